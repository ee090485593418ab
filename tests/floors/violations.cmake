# The check of the floors finds what it has to find: every tree below has one fault, and a sound one passes.
#
#     cmake -DCHECK=<include_direction.cmake> -DWORK=<scratch folder> -P violations.cmake
cmake_minimum_required(VERSION 3.21)

# run(<expected message, empty: none> <path> <content>...): a sound tree, changed by these files.
function(run expected)
  file(REMOVE_RECURSE ${WORK})
  file(WRITE ${WORK}/include/deltaform/precompiled.h "#include <vector>\n")
  foreach(room parameters assembly process io geometry kinematics materials tools blanks contact solver heat model analysis
               conditions results scene app)
    file(WRITE ${WORK}/include/deltaform/${room}/thing.h "#include <vector>\n")
  endforeach()
  file(WRITE ${WORK}/source/blanks/shell.h "#include <deltaform/materials/thing.h>\n")
  file(WRITE ${WORK}/source/blanks/shell.cc
       "#include \"shell.h\"\n#include <deltaform/kinematics/thing.h>\nRegistry<Blank>::Entry entry(1);\n")
  file(WRITE ${WORK}/source/tools/helper.h "#include <deltaform/parameters/thing.h>\n")
  file(WRITE ${WORK}/source/tools/shapes/plate.cc "#include \"../helper.h\"\nRegistry<Shape>::Entry entry(1);\n")
  file(WRITE ${WORK}/source/scene/scene.cc "#include <deltaform/contact/thing.h>\n#include <deltaform/results/thing.h>\n")
  file(WRITE ${WORK}/source/main.cc "#include <deltaform/scene/thing.h>\n")
  while(ARGN)
    list(POP_FRONT ARGN path content)
    file(APPEND ${WORK}/${path} "${content}\n")
  endwhile()
  execute_process(COMMAND ${CMAKE_COMMAND} -DROOT=${WORK} -P ${CHECK} RESULT_VARIABLE result ERROR_VARIABLE message
                  OUTPUT_VARIABLE ignored)
  string(REGEX REPLACE "[ \n]+" " " message "${message}") # CMake wraps long lines
  if(expected STREQUAL "")
    if(NOT result EQUAL 0)
      message(SEND_ERROR "a sound tree is refused: ${message}")
    endif()
  elseif(result EQUAL 0)
    message(SEND_ERROR "not found: ${expected}")
  else()
    string(FIND "${message}" "${expected}" place)
    if(place EQUAL -1)
      message(SEND_ERROR "expected '${expected}', found: ${message}")
    endif()
  endif()
endfunction()

run("")
run("parameters (floor 0) looks up to kinematics" include/deltaform/parameters/thing.h "#include <deltaform/kinematics/thing.h>")
run("parameters and assembly are siblings" include/deltaform/parameters/thing.h "#include <deltaform/assembly/thing.h>")
run("blanks and contact are siblings" source/blanks/shell.cc "#include <deltaform/contact/thing.h>")
run("tools and materials are siblings" include/deltaform/tools/thing.h "  #  include <deltaform/materials/thing.h>")
run("solver (floor 4) looks up to scene" source/solver/system.cc "#include <deltaform/scene/thing.h>")
run("results and conditions are siblings" source/results/history.cc "#include <deltaform/conditions/thing.h>")
run("leaves the room contact" source/contact/pair.cc "#include \"../tools/helper.h\"")
run("does not exist" source/contact/pair.cc "#include \"missing.h\"")
run("does not exist" source/contact/pair.cc "#include <deltaform/parameters/missing.h>")
run("an interface sees the implementation" include/deltaform/tools/thing.h
    "#include \"../../../source/tools/helper.h\"")
run("a concrete law has no header" source/materials/swift.cc "Registry<Hardening>::Entry entry(1)\;"
    include/deltaform/materials/swift.h "#include <vector>")
run("registers 2 laws" source/materials/swift.cc "Registry<Law>::Entry a(1)\; Registry<Law>::Entry b(1)\;")
run("leaves the room scene" source/scene/scene.cc "#include \"../blanks/shell.h\"")
run("does not exist" source/scene/scene.cc "#include <deltaform/blanks/shell.h>")
run("a concrete law has no header" include/deltaform/blanks/shell.h "#include <vector>")
run("an interface declares Section" include/deltaform/parameters/section.h "#include <vector>"
    include/deltaform/tools/thing.h "#include <deltaform/parameters/section.h>")
run("belongs to no room" source/attic/old.cc "#include <vector>")
run("is in no room" source/scene/scene.cc "#include <deltaform/attic/old.h>")
run("looks up to parameters" include/deltaform/precompiled.h "#include <deltaform/parameters/thing.h>")
file(REMOVE_RECURSE ${WORK})
