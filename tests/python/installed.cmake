# Installs, and imports the package from there, with nothing of the build folder.
#
#     cmake -DBUILD=<build folder> -DWORK=<scratch> -DPYTHON=<interpreter> -DPACKAGES=<below the prefix> -DSCENE=<file> -P installed.cmake
cmake_minimum_required(VERSION 3.21)
file(REMOVE_RECURSE ${WORK})
# Library and package of one build: a library that is newer than the package cannot serve it.
execute_process(COMMAND ${CMAKE_COMMAND} --build ${BUILD} --target deltaform deltaform_library deltaform_python OUTPUT_QUIET
                COMMAND_ERROR_IS_FATAL ANY)
execute_process(COMMAND ${CMAKE_COMMAND} --install ${BUILD} --prefix ${WORK}/prefix OUTPUT_QUIET COMMAND_ERROR_IS_FATAL ANY)
set(words "import deltaform, sys\nrun = deltaform.Scene(sys.argv[1], {'Steps/form/End time': .1}).run()\n"
          "maps = open('/proc/self/maps').read()\n"
          "assert deltaform.__file__.startswith(sys.argv[2]), deltaform.__file__\n"
          "assert sys.argv[3] + '/libdeltaform' not in maps and sys.argv[2] in maps\n"
          "assert run.done and len(run.history) > 5\n")
string(JOIN "" words ${words})
file(WRITE ${WORK}/use.py "${words}")
execute_process(COMMAND ${CMAKE_COMMAND} -E env PYTHONPATH=${WORK}/prefix/${PACKAGES} ${PYTHON} use.py ${SCENE} ${WORK}/prefix ${BUILD}
                WORKING_DIRECTORY ${WORK} COMMAND_ERROR_IS_FATAL ANY)
file(REMOVE_RECURSE ${WORK})
