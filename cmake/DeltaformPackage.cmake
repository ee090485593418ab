# cpack -G DEB in the build folder: a package for the Debian (or Ubuntu) on which it was built. What it depends on is found from
# the libraries that it uses.
set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGE_NAME deltaform)
set(CPACK_PACKAGE_VENDOR deltaform)
set(CPACK_PACKAGE_CONTACT "the deltaform developers <deltaform@example.org>")
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "forming of sheet and bulk metal with rigid tools")
set(CPACK_PACKAGE_DESCRIPTION
    "Axisymmetric and plane-strain metal forming, where the user states the allowed penetration between blank and tool\n\
 and the program finds the penalty factors. With library, headers and, where it was built, the Python package.")
set(CPACK_RESOURCE_FILE_LICENSE ${PROJECT_SOURCE_DIR}/LICENSE)
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_STRIP_FILES ON)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_SECTION science)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS_PRIVATE_DIRS ${PROJECT_BINARY_DIR})
set(CPACK_DEBIAN_PACKAGE_RECOMMENDS "python3-numpy, python3-matplotlib")
# Debian's Python looks for packages of /usr in a folder without version.
set(CPACK_PRE_BUILD_SCRIPTS ${PROJECT_SOURCE_DIR}/cmake/DebianPythonFolder.cmake)
include(CPack)
