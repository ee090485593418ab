# deltaform_label_tests([QUICK <regex>] [SLOW <regex>]): belongs at the end of a folder's CMakeLists.txt. Its tests get the first
# part of their name as label (those of a room: unit; those that kill and resume runs: resume), and `quick` where the name matches
# QUICK and not SLOW. All quick tests together stay below a minute on two cores.
function(deltaform_label_tests)
  cmake_parse_arguments(_of "" "QUICK;SLOW" "" ${ARGN})
  get_property(_tests DIRECTORY PROPERTY TESTS)
  foreach(_test IN LISTS _tests)
    string(REGEX REPLACE "/.*" "" _label ${_test})
    if(_label IN_LIST DELTAFORM_ROOMS)
      set(_label unit)
    elseif(_test MATCHES "^scenes/resume/")
      set(_label resume)
    endif()
    if(_of_QUICK AND _test MATCHES "${_of_QUICK}" AND NOT (_of_SLOW AND _test MATCHES "${_of_SLOW}"))
      list(APPEND _label quick)
    endif()
    set_tests_properties(${_test} PROPERTIES LABELS "${_label}")
  endforeach()
endfunction()
