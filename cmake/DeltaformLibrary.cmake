# The shared library libdeltaform, target deltaform::deltaform.
include(DeltaformDealII)
deltaform_deal_ii(${DELTAFORM_FLAVOUR})

set(_dependencies deltaform::deal_ii Eigen3::Eigen Boost::program_options Boost::serialization ZLIB::ZLIB)
if(NOT PROJECT_IS_TOP_LEVEL)
  deltaform_make_global(${_dependencies} Boost::headers)
endif()

add_library(deltaform_library SHARED $<TARGET_OBJECTS:deltaform_objects>)
add_library(deltaform::deltaform ALIAS deltaform_library)
target_link_libraries(deltaform_library PUBLIC ${_dependencies} PRIVATE fmt::fmt)
target_compile_features(deltaform_library PUBLIC cxx_std_17)
target_include_directories(deltaform_library INTERFACE $<BUILD_INTERFACE:${PROJECT_SOURCE_DIR}/include>
                                                       $<INSTALL_INTERFACE:include>)
set_target_properties(
  deltaform_library
  PROPERTIES LINKER_LANGUAGE CXX
             OUTPUT_NAME deltaform
             EXPORT_NAME deltaform
             VERSION ${PROJECT_VERSION}
             SOVERSION ${PROJECT_VERSION_MAJOR}.${PROJECT_VERSION_MINOR})
if(DELTAFORM_SANITIZE)
  target_link_options(deltaform_library PUBLIC -fsanitize=address,undefined)
endif()
