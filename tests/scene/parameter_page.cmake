# doc/parameters.md is what the program prints: cmake -DPROGRAM=... -DPAGE=... -P parameter_page.cmake
execute_process(COMMAND ${PROGRAM} --print-parameters OUTPUT_VARIABLE _printed RESULT_VARIABLE _status)
if(NOT _status EQUAL 0)
  message(FATAL_ERROR "${PROGRAM} --print-parameters ended with status ${_status}")
endif()
file(READ ${PAGE} _page)
if(NOT _printed STREQUAL _page)
  message(FATAL_ERROR "${PAGE} is out of date: write it again with 'deltaform --print-parameters > doc/parameters.md'")
endif()
