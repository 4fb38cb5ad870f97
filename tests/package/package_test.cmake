# Install surfmesh to a prefix inside the build folder (or do not: mode subproject), then configure,
# build and run the project next to this file as an application would.
#
# cmake -D MODE=installed|shared|subproject -D SOURCE=<surfmesh> -D BUILD=<its build folder>
#       -D GENERATOR=... -D BUILD_TYPE=... -D LAUNCHER=<compiler launcher or empty>
#       -P package_test.cmake
set(folder ${BUILD}/package/${MODE})
set(prefix ${folder}/prefix)
set(common -G ${GENERATOR} -DCMAKE_BUILD_TYPE=${BUILD_TYPE} -DCMAKE_CXX_COMPILER_LAUNCHER=${LAUNCHER})

function(run)
  execute_process(COMMAND ${ARGN} COMMAND_ERROR_IS_FATAL ANY)
endfunction()

function(install_surfmesh build)
  run(${CMAKE_COMMAND} --install ${build} --prefix ${prefix})
  run(${prefix}/bin/surfmesh mesh ${SOURCE}/models/torus.obj -o ${folder}/torus.obj --quiet)
endfunction()

file(REMOVE_RECURSE ${prefix} ${folder}/consumer)
if(MODE STREQUAL "subproject")
  set(surfmesh -DSURFMESH_SOURCE=${SOURCE})
elseif(MODE STREQUAL "shared")
  run(${CMAKE_COMMAND} -S ${SOURCE} -B ${folder}/library ${common} -DBUILD_SHARED_LIBS=ON
      -DSURFMESH_BUILD_TESTS=OFF -DSURFMESH_BUILD_BENCH=OFF)
  run(${CMAKE_COMMAND} --build ${folder}/library)
  install_surfmesh(${folder}/library)
  set(surfmesh -DCMAKE_PREFIX_PATH=${prefix})
else()
  install_surfmesh(${BUILD})
  set(surfmesh -DCMAKE_PREFIX_PATH=${prefix})
endif()

run(${CMAKE_COMMAND} -S ${CMAKE_CURRENT_LIST_DIR} -B ${folder}/consumer ${common} ${surfmesh})
run(${CMAKE_COMMAND} --build ${folder}/consumer)
run(${CMAKE_CTEST_COMMAND} --test-dir ${folder}/consumer --output-on-failure)
