# The Python package deltaform, where pybind11 and the headers of Python are found: in build/<preset>/python, and installed.
# Debian's pybind11 and numpy belong to Debian's Python; another one is chosen by -DPython_EXECUTABLE=.
option(DELTAFORM_PYTHON_MODULE "Build the Python package where pybind11 is found" ${PROJECT_IS_TOP_LEVEL})
if(NOT DELTAFORM_PYTHON_MODULE)
  return()
endif()
if(NOT Python_EXECUTABLE AND EXISTS /usr/bin/python3)
  set(Python_EXECUTABLE /usr/bin/python3)
endif()
find_package(Python 3.8 COMPONENTS Interpreter Development.Module QUIET)
find_package(pybind11 2.6 CONFIG QUIET)
if(NOT Python_Development.Module_FOUND OR NOT pybind11_FOUND)
  message(STATUS "No Python package: pybind11 or the headers of Python are missing")
  return()
endif()

set(_package ${PROJECT_BINARY_DIR}/python/deltaform)
pybind11_add_module(deltaform_python MODULE ${PROJECT_SOURCE_DIR}/source/python/module.cc)
target_link_libraries(deltaform_python PRIVATE deltaform_library)
target_compile_definitions(deltaform_python PRIVATE DELTAFORM_VERSION="${PROJECT_VERSION}")
target_compile_options(deltaform_python PRIVATE -Wall -Wextra -Werror)
set_target_properties(deltaform_python PROPERTIES OUTPUT_NAME _deltaform LIBRARY_OUTPUT_DIRECTORY ${_package}
                                                  INTERPROCEDURAL_OPTIMIZATION OFF)
configure_file(${PROJECT_SOURCE_DIR}/source/python/deltaform/__init__.py ${_package}/__init__.py COPYONLY)

if(DELTAFORM_INSTALL)
  execute_process(COMMAND ${Python_EXECUTABLE} -c "import sysconfig; print('dist' if 'deb_system' in sysconfig.get_scheme_names() else 'site')"
                  OUTPUT_VARIABLE _kind OUTPUT_STRIP_TRAILING_WHITESPACE)
  set(DELTAFORM_PYTHON_DIR lib/python${Python_VERSION_MAJOR}.${Python_VERSION_MINOR}/${_kind}-packages
      CACHE STRING "Where the Python package is installed, below the prefix")
  include(GNUInstallDirs)
  file(RELATIVE_PATH _up /${DELTAFORM_PYTHON_DIR}/deltaform /${CMAKE_INSTALL_LIBDIR})
  set_target_properties(deltaform_python PROPERTIES INSTALL_RPATH "$ORIGIN/${_up}" INSTALL_RPATH_USE_LINK_PATH ON)
  install(TARGETS deltaform_python LIBRARY DESTINATION ${DELTAFORM_PYTHON_DIR}/deltaform)
  install(FILES ${PROJECT_SOURCE_DIR}/source/python/deltaform/__init__.py DESTINATION ${DELTAFORM_PYTHON_DIR}/deltaform)
endif()
