# The flavour of deal.II. In another project the type of the build may be any.
set(DELTAFORM_FLAVOUR RELEASE)
if(CMAKE_BUILD_TYPE STREQUAL "Debug")
  set(DELTAFORM_FLAVOUR DEBUG)
endif()

# deltaform_link(<target> <library>...): deal.II's macro fixes the plain or the keyword signature of
# target_link_libraries, depending on its version; setting the property goes with both.
function(deltaform_link target)
  set_property(TARGET ${target} APPEND PROPERTY LINK_LIBRARIES ${ARGN})
endfunction()

# deltaform_setup(<target>): deal.II, Boost, Eigen, zlib, warnings as errors, sanitizers.
function(deltaform_setup target)
  deal_ii_setup_target(${target} ${DELTAFORM_FLAVOUR})
  # deal.II's and Trilinos' headers are not ours to warn about.
  get_target_property(_dirs ${target} INCLUDE_DIRECTORIES)
  if(_dirs)
    set_target_properties(${target} PROPERTIES INCLUDE_DIRECTORIES "")
    target_include_directories(${target} SYSTEM PRIVATE ${_dirs})
  endif()
  target_include_directories(${target} PRIVATE ${PROJECT_SOURCE_DIR}/include)
  target_compile_features(${target} PUBLIC cxx_std_17)
  # MPI's C++ classes, which MPI 3 has removed and nobody calls: deal.II's headers bring them into every file, where they took
  # a quarter of the time of the compiler.
  target_compile_definitions(${target} PRIVATE OMPI_SKIP_MPICXX MPICH_SKIP_MPICXX)
  target_compile_options(${target} PRIVATE -Wall -Wextra -Wpedantic -Wshadow -Wnon-virtual-dtor -Woverloaded-virtual
                                           -Wfloat-conversion -Werror)
  # Debian's deal.II hands down -g also for Release. Symbols make a program thirty times as large, and a build took 8 GB of
  # disk. A Debug build has them.
  target_compile_options(${target} PRIVATE $<$<CONFIG:Release>:-g0>)
  # Compilers differ in whether they record libraries that nothing refers to; each would be loaded.
  target_link_options(${target} PRIVATE -Wl,--as-needed)
  deltaform_link(${target} Boost::program_options Boost::serialization Eigen3::Eigen ZLIB::ZLIB)
  if(DELTAFORM_SANITIZE)
    # GCC 12 takes std::regex for uninitialized where it is sanitized.
    target_compile_options(${target} PRIVATE -fsanitize=address,undefined -fno-omit-frame-pointer -Wno-maybe-uninitialized)
    target_link_options(${target} PUBLIC -fsanitize=address,undefined)
  endif()
endfunction()
