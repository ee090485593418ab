# cmake --install: the program, the library with its headers, and what find_package(deltaform) reads.
include(GNUInstallDirs)
include(CMakePackageConfigHelpers)

# Libraries in unusual places are found there again.
set_target_properties(deltaform deltaform_library PROPERTIES INSTALL_RPATH_USE_LINK_PATH ON)
install(TARGETS deltaform RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR})
install(TARGETS deltaform_library EXPORT deltaform LIBRARY DESTINATION ${CMAKE_INSTALL_LIBDIR})
install(DIRECTORY ${PROJECT_SOURCE_DIR}/include/deltaform DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}
        FILES_MATCHING PATTERN "*.h" PATTERN "precompiled.h" EXCLUDE)

install(FILES ${PROJECT_SOURCE_DIR}/share/materials.prm DESTINATION ${CMAKE_INSTALL_DATADIR}/deltaform)

set(_folder ${CMAKE_INSTALL_LIBDIR}/cmake/deltaform)
install(EXPORT deltaform NAMESPACE deltaform:: FILE deltaformTargets.cmake DESTINATION ${_folder})
configure_package_config_file(${PROJECT_SOURCE_DIR}/cmake/deltaformConfig.cmake.in
                              ${PROJECT_BINARY_DIR}/deltaformConfig.cmake INSTALL_DESTINATION ${_folder})
# Before 1.0 a minor version may change the interface.
write_basic_package_version_file(${PROJECT_BINARY_DIR}/deltaformConfigVersion.cmake COMPATIBILITY SameMinorVersion)
install(FILES ${PROJECT_BINARY_DIR}/deltaformConfig.cmake ${PROJECT_BINARY_DIR}/deltaformConfigVersion.cmake
              ${PROJECT_SOURCE_DIR}/cmake/DeltaformDealII.cmake
        DESTINATION ${_folder})
