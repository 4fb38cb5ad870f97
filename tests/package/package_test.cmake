# Install surfmesh to a prefix inside the build folder (or do not: mode subproject), then configure,
# build and run the project next to this file as an application would.
#
# cmake -D MODE=installed|shared|subproject -D SOURCE=<surfmesh> -D BUILD=<its build folder>
#       -D GENERATOR=... -D BUILD_TYPE=... -D COMPILER=... -D LAUNCHER=<compiler launcher or empty>
#       -P package_test.cmake
set(folder ${BUILD}/package/${MODE})
set(prefix ${folder}/prefix)
set(common -G ${GENERATOR} -DCMAKE_BUILD_TYPE=${BUILD_TYPE} -DCMAKE_CXX_COMPILER=${COMPILER}
    -DCMAKE_CXX_COMPILER_LAUNCHER=${LAUNCHER})

function(run)
  execute_process(COMMAND ${ARGN} COMMAND_ERROR_IS_FATAL ANY)
endfunction()

# expect_output(<expression> <command...>): what it prints, whether or not it fails, matches.
function(expect_output expected)
  execute_process(COMMAND ${ARGN} OUTPUT_VARIABLE output ERROR_VARIABLE output)
  string(REGEX REPLACE "[ \n]+" " " output "${output}")  # CMake wraps its messages
  if(NOT output MATCHES "${expected}")
    message(SEND_ERROR "expected '${expected}' of ${ARGN}, which prints\n${output}")
  endif()
endfunction()

# Models and documents lie where distributions expect them; models are to be meshed.
function(check_installed_files)
  if(EXISTS ${prefix}/bin/surfmesh-mpi)
    set(of_mpi share/man/man1/surfmesh-mpi.1 share/man/man1/surfmesh-mpi-mesh.1
        share/bash-completion/completions/surfmesh-mpi share/zsh/site-functions/_surfmesh-mpi)
  endif()
  foreach(file IN ITEMS ${of_mpi} share/man/man1/surfmesh.1 share/man/man1/surfmesh-mesh.1
                        share/bash-completion/completions/surfmesh share/zsh/site-functions/_surfmesh
                        share/surfmesh/models/README.md share/surfmesh/models/surfmesh.schema.json
                        share/surfmesh/models/torus.obj share/doc/surfmesh/README.md
                        share/doc/surfmesh/LICENSE share/doc/surfmesh/libsurfmesh/LIBRARY.md
                        share/doc/surfmesh/libsurfmesh/REFERENCE.md
                        share/doc/surfmesh/libsurfmesh/README.md
                        share/doc/surfmesh/libsurfmesh/CLUSTER.md
                        share/doc/surfmesh/libsurfmesh/CONTRIBUTING.md share/doc/surfmesh/CHANGELOG.md
                        share/doc/surfmesh/libsurfmesh/DECISIONS.md
                        share/doc/surfmesh/libsurfmesh/pictures/knob.png include/surfmesh/surfmesh.hh)
    if(NOT EXISTS ${prefix}/${file})
      message(SEND_ERROR "${file} is not installed")
    endif()
  endforeach()
  run(${prefix}/bin/surfmesh mesh ${prefix}/share/surfmesh/models/torus.obj
      -o ${folder}/torus.obj --quiet)
endfunction()

# The first error where the language is too old tells so.
function(check_language_standard)
  file(WRITE ${folder}/old.cc "#include <surfmesh/surfmesh.hh>\n")
  expect_output("error: [^:]*surfmesh needs C\\+\\+20"
    ${COMPILER} -std=c++17 -Wfatal-errors -fsyntax-only -I${prefix}/include ${folder}/old.cc)
endfunction()

# check_find_package(<arguments of find_package> <what CMake says>)
function(check_find_package arguments expected)
  file(WRITE ${folder}/find/CMakeLists.txt
    "cmake_minimum_required(VERSION 3.24)\nproject(find LANGUAGES CXX)\n"
    "find_package(surfmesh ${arguments})\nmessage(\"found: \${surfmesh_FOUND}\")\n")
  expect_output("${expected}" ${CMAKE_COMMAND} -S ${folder}/find -B ${folder}/find/build ${common}
    -DCMAKE_PREFIX_PATH=${prefix})
endfunction()

# A compiler and pkg-config are all that a program needs.
function(check_pkg_config)
  find_program(PKG_CONFIG NAMES pkg-config pkgconf)
  if(NOT PKG_CONFIG)
    message("pkg-config is not installed: surfmesh.pc is not tested")
    return()
  endif()
  file(GLOB_RECURSE file ${prefix}/surfmesh.pc)
  cmake_path(GET file PARENT_PATH pc_folder)
  cmake_path(GET pc_folder PARENT_PATH library_folder)
  execute_process(
    COMMAND ${CMAKE_COMMAND} -E env PKG_CONFIG_PATH=${pc_folder}
      ${PKG_CONFIG} --cflags --libs ${ARGN} surfmesh
    OUTPUT_VARIABLE flags COMMAND_ERROR_IS_FATAL ANY)
  separate_arguments(flags UNIX_COMMAND "${flags}")
  set(source ${CMAKE_CURRENT_FUNCTION_LIST_DIR}/walk_result.cc)
  set(program ${folder}/walk_result)
  run(${COMPILER} -std=c++20 ${source} ${flags} -o ${program})
  expect_output("triangles, greatest distance"
    ${CMAKE_COMMAND} -E env LD_LIBRARY_PATH=${library_folder}
      ${program} ${prefix}/share/surfmesh/models/torus.obj)
endfunction()

# A project around surfmesh stays as it was, and gets no targets without our name.
function(check_project_around)
  run(${CMAKE_COMMAND} -S ${CMAKE_CURRENT_FUNCTION_LIST_DIR}/around -B ${folder}/around ${common}
      -DSURFMESH_SOURCE=${SOURCE})
  execute_process(COMMAND ${CMAKE_COMMAND} --build ${folder}/around --target help
    OUTPUT_VARIABLE targets COMMAND_ERROR_IS_FATAL ANY)
  if(targets MATCHES "verify_interface_header_sets")
    message(SEND_ERROR "surfmesh's check of its headers is among the targets of the project around")
  endif()
endfunction()

function(install_surfmesh build)
  run(${CMAKE_COMMAND} --install ${build} --prefix ${prefix})
  check_installed_files()
  check_language_standard()
endfunction()

file(REMOVE_RECURSE ${prefix} ${folder}/consumer ${folder}/around ${folder}/find)
if(MODE STREQUAL "subproject")
  # Debug, as people build while developing.
  list(APPEND common -DCMAKE_BUILD_TYPE=Debug)
  check_project_around()
  set(surfmesh -DSURFMESH_SOURCE=${SOURCE} -DSURFMESH_UNITY_BUILD=ON)
elseif(MODE STREQUAL "shared")
  # Not joined: of all builds from nothing, this one shows that each file includes what it needs.
  run(${CMAKE_COMMAND} -S ${SOURCE} -B ${folder}/library ${common} -DBUILD_SHARED_LIBS=ON
      -DSURFMESH_BUILD_TESTS=OFF -DSURFMESH_BUILD_BENCH=OFF)
  run(${CMAKE_COMMAND} --build ${folder}/library)
  install_surfmesh(${folder}/library)
  check_pkg_config()
  set(surfmesh -DCMAKE_PREFIX_PATH=${prefix})
else()
  install_surfmesh(${BUILD})
  check_pkg_config(--static)
  check_find_package("1.0 REQUIRED" "found: 1")
  check_find_package("0.1" "found: 0")
  check_find_package("1.1" "found: 0")
  check_find_package("2.0" "found: 0")
  check_find_package("1.0 COMPONENTS nonsense" "surfmesh has no component nonsense.*found: 0")
  check_find_package("1.0 OPTIONAL_COMPONENTS nonsense" "found: 1")
  foreach(header IN ITEMS cad/read_cad.hh mpi/mpi_exchange.hh metis/deal_by_metis.hh)
    cmake_path(GET header PARENT_PATH component)
    if(EXISTS ${prefix}/include/surfmesh_${header})
      check_find_package("1.0 COMPONENTS ${component}" "found: 1")
    else()
      check_find_package("1.0 COMPONENTS ${component}"
        "built without its component ${component}.*found: 0")
    endif()
  endforeach()
  set(surfmesh -DCMAKE_PREFIX_PATH=${prefix})
endif()

run(${CMAKE_COMMAND} -S ${CMAKE_CURRENT_LIST_DIR} -B ${folder}/consumer ${common} ${surfmesh})
run(${CMAKE_COMMAND} --build ${folder}/consumer)
run(${CMAKE_CTEST_COMMAND} --test-dir ${folder}/consumer --output-on-failure)
