# A page of doc/ is what the program prints: cmake -DPROGRAM=... -DOPTION=--print-... -DPAGE=... -P printed_page.cmake
execute_process(COMMAND ${PROGRAM} ${OPTION} OUTPUT_VARIABLE _printed RESULT_VARIABLE _status)
if(NOT _status EQUAL 0)
  message(FATAL_ERROR "${PROGRAM} ${OPTION} ended with status ${_status}")
endif()
file(READ ${PAGE} _page)
if(NOT _printed STREQUAL _page)
  message(FATAL_ERROR "${PAGE} is out of date: write it again with 'deltaform ${OPTION}'")
endif()
