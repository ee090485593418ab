# Installs what was built, builds pressed_block with it outside of the tree, and runs it.
#
#     cmake -DBUILD=<build folder> -DEXAMPLE=<tests/install> -DWORK=<scratch folder> -DTYPE=<build type> -DLIBDIR=<lib>
#           -P install.cmake
cmake_minimum_required(VERSION 3.21)

function(call)
  execute_process(COMMAND ${ARGN} COMMAND_ERROR_IS_FATAL ANY)
endfunction()

file(REMOVE_RECURSE ${WORK})
call(${CMAKE_COMMAND} --install ${BUILD} --prefix ${WORK}/prefix)
# Nothing of the build folder or of the tree may be needed.
call(${CMAKE_COMMAND} -S ${EXAMPLE} -B ${WORK}/build -DCMAKE_PREFIX_PATH=${WORK}/prefix -DCMAKE_BUILD_TYPE=${TYPE}
     -DCMAKE_FIND_USE_PACKAGE_REGISTRY=OFF)
call(${CMAKE_COMMAND} --build ${WORK}/build)
call(${WORK}/build/pressed_block)
call(${WORK}/prefix/bin/deltaform --version)

file(STRINGS ${WORK}/prefix/${LIBDIR}/cmake/deltaform/deltaformTargets.cmake paths REGEX "${BUILD}")
if(paths)
  message(FATAL_ERROR "the installed package names the build folder:\n${paths}")
endif()
file(REMOVE_RECURSE ${WORK})
