# deltaform_placeholders(): Debian's libdeal.ii.so needs 200 libraries, and the loader resolves every address in them before
# main: CAD, mesh generators, other mesh formats, integrators of ordinary differential equations, of which no scene uses
# anything. An empty library of the same name takes the place of each; that halves the start of every process
# (doc/speed.md). Without Python, or where a program does not start with them, the real ones stay, and the
# configuration says so. Sets DELTAFORM_PLACEHOLDER_LINKS, what every program links right after deal.II.
function(deltaform_placeholders)
  set(DELTAFORM_PLACEHOLDER_LINKS "" PARENT_SCOPE)
  set(_names "lib(TK.*|gmsh|assimp|sundials_.*|gsl)[.]so.*")
  set(_folder ${CMAKE_BINARY_DIR}/placeholders)
  set(_target ${DEAL_II_TARGET_RELEASE})
  if(CMAKE_BUILD_TYPE STREQUAL "Debug")
    set(_target ${DEAL_II_TARGET_DEBUG})
  endif()
  find_program(DELTAFORM_PYTHON python3)
  if(NOT TARGET "${_target}" AND DEAL_II_TARGET_CONFIG)
    include(${DEAL_II_TARGET_CONFIG}) # what deal_ii_setup_target would do (deal.II 9.4)
    set(DEAL_II_TARGET_CONFIG_INCLUDED TRUE PARENT_SCOPE)
  endif()
  if(NOT TARGET "${_target}" OR NOT DELTAFORM_PYTHON OR NOT CMAKE_NM OR NOT CMAKE_READELF)
    message(STATUS "Placeholders: no, for want of deal.II's target, python3, nm or readelf")
    return()
  endif()
  get_target_property(_library ${_target} LOCATION)
  # Made once for a release of deal.II: it takes some seconds.
  set(_names_made ${_folder}/names.txt)
  set(_script ${CMAKE_SOURCE_DIR}/cmake/placeholders.py)
  set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${_library} ${_script})
  set(_outdated FALSE)
  foreach(_source ${_library} ${_script} ${CMAKE_SOURCE_DIR}/cmake/Placeholders.cmake)
    if(NOT EXISTS ${_names_made} OR ${_source} IS_NEWER_THAN ${_names_made})
      set(_outdated TRUE)
    endif()
  endforeach()
  if(_outdated)
    file(REMOVE_RECURSE ${_folder})
    execute_process(COMMAND ${DELTAFORM_PYTHON} ${_script} --root ${_library} --names ${_names} --folder ${_folder}
                            --compiler ${CMAKE_CXX_COMPILER} --nm ${CMAKE_NM} --readelf ${CMAKE_READELF}
                    ERROR_VARIABLE _error RESULT_VARIABLE _status)
    if(_status)
      message(STATUS "Placeholders: no, they could not be made: ${_error}")
      return()
    endif()
  endif()
  file(STRINGS ${_names_made} _made)
  list(LENGTH _made _number)
  if(_number EQUAL 0)
    message(STATUS "Placeholders: deal.II needs nothing that could be left out")
    return()
  endif()

  # After deal.II, whose symbols most look-ups are for; kept although nobody refers to them.
  list(TRANSFORM _made PREPEND ${_folder}/)
  set(_links -Wl,--push-state,--no-as-needed ${_made} -Wl,--pop-state)

  # The real ones must not be linked as well. Those that only they need go with them.
  get_target_property(_needed ${_target} INTERFACE_LINK_LIBRARIES)
  list(FILTER _needed EXCLUDE REGEX "/${_names}$")

  # Every address is resolved, and every library's initialization runs, before an empty program can end.
  set(_program ${_folder}/starts)
  file(WRITE ${_program}.cc "int main() {}\n")
  execute_process(COMMAND ${CMAKE_CXX_COMPILER} ${_program}.cc -o ${_program} -Wl,--no-as-needed ${_library} ${_links}
                          -Wl,-rpath,${_folder} -Wl,--allow-shlib-undefined
                  OUTPUT_VARIABLE _error ERROR_VARIABLE _error RESULT_VARIABLE _status)
  if(NOT _status)
    execute_process(COMMAND ${CMAKE_COMMAND} -E env LD_BIND_NOW=1 ${_program}
                    OUTPUT_VARIABLE _error ERROR_VARIABLE _error RESULT_VARIABLE _status)
  endif()
  if(_status)
    message(STATUS "Placeholders: no, an empty program does not start with them: ${_error}")
    return()
  endif()
  message(STATUS "Placeholders: for ${_number} libraries that deal.II needs and deltaform does not")
  set_target_properties(${_target} PROPERTIES INTERFACE_LINK_LIBRARIES "${_needed}")
  set(DELTAFORM_PLACEHOLDER_LINKS "${_links}" PARENT_SCOPE)
endfunction()
