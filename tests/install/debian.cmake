# The Debian package: made, unpacked, and run from there, with nothing of the build folder but what the package has.
#
#     cmake -DBUILD=<build folder> -DWORK=<scratch> -DTARGETS=<to build besides> -DPYTHON=<interpreter or empty> -P debian.cmake
cmake_minimum_required(VERSION 3.21)
file(REMOVE_RECURSE ${WORK})
file(MAKE_DIRECTORY ${WORK})
execute_process(COMMAND ${CMAKE_COMMAND} --build ${BUILD} --target deltaform deltaform_library ${TARGETS} OUTPUT_QUIET
                COMMAND_ERROR_IS_FATAL ANY)
execute_process(COMMAND ${CMAKE_CPACK_COMMAND} --config ${BUILD}/CPackConfig.cmake -B ${WORK}/made -G DEB OUTPUT_QUIET
                WORKING_DIRECTORY ${WORK} COMMAND_ERROR_IS_FATAL ANY)
file(GLOB package ${WORK}/made/*.deb)
execute_process(COMMAND dpkg-deb --field ${package} Depends OUTPUT_VARIABLE depends COMMAND_ERROR_IS_FATAL ANY)
foreach(needed libdeal.ii libtrilinos libc6)
  if(NOT depends MATCHES "${needed}")
    message(FATAL_ERROR "the package does not depend on ${needed}: ${depends}")
  endif()
endforeach()
execute_process(COMMAND dpkg-deb --extract ${package} ${WORK}/root COMMAND_ERROR_IS_FATAL ANY)

# A scene with a metal by name: the table of metals is found where the program is.
set(program ${WORK}/root/usr/bin/deltaform)
execute_process(COMMAND ${program} new bend ${WORK}/bend.prm OUTPUT_QUIET COMMAND_ERROR_IS_FATAL ANY)
execute_process(COMMAND ${program} ${WORK}/bend.prm --quiet --output ${WORK}/bend --set Material/Name=AA5754-O
                        --set "Material/Young's modulus=68e3" COMMAND_ERROR_IS_FATAL ANY)
file(READ ${WORK}/bend/scene.prm scene)
if(NOT scene MATCHES "set Name = AA5754-O")
  message(FATAL_ERROR "the run knows nothing of its metal")
endif()
if(PYTHON)
  execute_process(COMMAND ${CMAKE_COMMAND} -E env PYTHONPATH=${WORK}/root/usr/lib/python3/dist-packages ${PYTHON} -c
                          "import deltaform; assert deltaform.__file__.startswith('${WORK}'); deltaform.Scene('${WORK}/bend.prm')"
                  COMMAND_ERROR_IS_FATAL ANY)
endif()
file(REMOVE_RECURSE ${WORK})
