# A run that is asked for condition numbers is the run that was asked about: its final profile and contact table equal, to
# the last byte, those of a run that was not. And not asked for, they cost nothing: no timer section.
#   cmake -DPROGRAM=deltaform -DSCENE=FILE.prm -DWORK=FOLDER -DENTRY="Contact/Penalty rule=paper" -P THIS
file(REMOVE_RECURSE ${WORK})
file(MAKE_DIRECTORY ${WORK})
foreach(every 0 5)
  execute_process(COMMAND ${PROGRAM} ${SCENE} --quiet --output ${WORK}/${every} --set ${ENTRY} --set Output/Pictures=0
                          --set "Output/Condition number every=${every}" --set "Output/Condition number by=dense"
                  RESULT_VARIABLE status)
  if(NOT status EQUAL 0)
    message(FATAL_ERROR "exit status ${status} with numbers every ${every} increments")
  endif()
endforeach()

file(GLOB tables RELATIVE ${WORK}/0 ${WORK}/0/profile_*.csv ${WORK}/0/contact_*.csv)
if(NOT tables)
  message(FATAL_ERROR "nothing to compare")
endif()
foreach(table IN LISTS tables)
  file(READ ${WORK}/0/${table} alone)
  file(READ ${WORK}/5/${table} measured)
  if(NOT alone STREQUAL measured)
    message(FATAL_ERROR "${table} depends on whether condition numbers are asked for (${ENTRY})")
  endif()
endforeach()

foreach(every 0 5)
  file(READ ${WORK}/${every}/timing.json timing)
  string(FIND "${timing}" "condition numbers" section_${every})
endforeach()
if(NOT section_0 EQUAL -1)
  message(FATAL_ERROR "a timer section of condition numbers that nobody asked for")
endif()
if(section_5 EQUAL -1)
  message(FATAL_ERROR "no timer section where they were asked for: the comparison says nothing")
endif()
