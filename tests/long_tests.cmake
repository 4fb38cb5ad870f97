# Tests that build something themselves. Those with the label long are left out by
# `ctest --preset release`; `ctest --preset all` runs them, too, but for those with the label nightly,
# which do not fit into 45 minutes on two cores with the rest.

# surfmesh_add_building_test(<name> <labels> <command...>): runs alone, for it uses all cores.
function(surfmesh_add_building_test name labels)
  add_test(NAME ${name} COMMAND ${ARGN})
  set_tests_properties(${name} PROPERTIES LABELS "${labels}" RUN_SERIAL ON TIMEOUT 3600)
endfunction()

function(surfmesh_add_package_test name mode labels)
  surfmesh_add_building_test(${name} "${labels}"
    ${CMAKE_COMMAND} -D MODE=${mode} -D SOURCE=${PROJECT_SOURCE_DIR} -D BUILD=${PROJECT_BINARY_DIR}
    -D GENERATOR=${CMAKE_GENERATOR} -D BUILD_TYPE=${CMAKE_BUILD_TYPE}
    -D COMPILER=${CMAKE_CXX_COMPILER} -D LAUNCHER=${CMAKE_CXX_COMPILER_LAUNCHER}
    -P ${CMAKE_CURRENT_SOURCE_DIR}/package/package_test.cmake)
endfunction()

if(SURFMESH_INSTALL AND TARGET surfmesh_program)
  surfmesh_add_package_test(Package.Installed installed package)
  surfmesh_add_package_test(Package.InstalledShared shared "package;long;nightly")
  surfmesh_add_package_test(Package.Subproject subproject "package;long")
endif()

surfmesh_add_building_test(PublicHeaders.CompileAlone "package;long"
  ${CMAKE_COMMAND} --build ${PROJECT_BINARY_DIR} --target all_verify_interface_header_sets)

# The tests of these stages again, under the address and undefined-behaviour sanitizers. Those of the
# second list have the label nightly: they take longer to build and to run.
set(sanitized core io geometry formula metric quality delaunay boundary patch_mesh control formats)
set(sanitized_nightly model cage refine improve quad patch sizes sampling estimate assemble across
    model_file cad exchange tiles pieces fuzz)
get_property(stages GLOBAL PROPERTY surfmesh_test_stages)

# surfmesh_add_sanitized_tests(<name of the fixture> <labels> <stages...>)
function(surfmesh_add_sanitized_tests fixture labels)
  foreach(stage IN LISTS ARGN)
    if(stage IN_LIST stages)
      list(APPEND targets ${stage}_test)
      add_test(NAME Sanitize.${stage}
        COMMAND ${PROJECT_SOURCE_DIR}/build/sanitize/tests/${stage}_test)
      set_tests_properties(Sanitize.${stage} PROPERTIES
        LABELS "${labels}" FIXTURES_REQUIRED ${fixture} TIMEOUT 1800
        # Not the folder in which the same test may run just now without sanitizers.
        ENVIRONMENT TEST_TMPDIR=${PROJECT_BINARY_DIR}/sanitize)
    endif()
  endforeach()
  # OpenCASCADE keeps what its readers allocate.
  foreach(stage IN ITEMS cad fuzz)
    if(TARGET surfmesh_cad AND "${stage}" IN_LIST ARGN AND "${stage}" IN_LIST stages)
      set_property(TEST Sanitize.${stage} APPEND PROPERTY ENVIRONMENT ASAN_OPTIONS=detect_leaks=0)
    endif()
  endforeach()
  list(JOIN targets "," targets)  # a list would become several arguments
  surfmesh_add_building_test(Sanitize.${fixture} "${labels}"
    ${CMAKE_COMMAND} -D SOURCE=${PROJECT_SOURCE_DIR} -D TARGETS=${targets}
    -P ${CMAKE_CURRENT_SOURCE_DIR}/sanitize.cmake)
  set_tests_properties(Sanitize.${fixture} PROPERTIES FIXTURES_SETUP ${fixture})
endfunction()

surfmesh_add_sanitized_tests(Build "sanitize;long" ${sanitized})
surfmesh_add_sanitized_tests(BuildNightly "sanitize;long;nightly" ${sanitized_nightly})

# Random small models through the program, judged by a script of its own.
if(TARGET surfmesh_program)
  add_test(NAME Soak.RandomModels COMMAND bash ${CMAKE_CURRENT_SOURCE_DIR}/soak.sh
    ${PROJECT_SOURCE_DIR}/../shared/bench/soak.py $<TARGET_FILE:surfmesh_program> 50 14)
  set_tests_properties(Soak.RandomModels PROPERTIES LABELS "soak;long" SKIP_RETURN_CODE 77)
endif()

# Half a minute of each fuzz target; longer runs are for tests/fuzz/run.sh. Skipped without clang.
set(fuzz_run ${CMAKE_CURRENT_SOURCE_DIR}/fuzz/run.sh)
surfmesh_add_building_test(Fuzz.Build "fuzz;long" bash ${fuzz_run} --build)
set_tests_properties(Fuzz.Build PROPERTIES FIXTURES_SETUP FuzzBuild SKIP_RETURN_CODE 77)
get_property(fuzz_targets GLOBAL PROPERTY surfmesh_fuzz_targets)
foreach(target IN LISTS fuzz_targets)
  add_test(NAME Fuzz.${target} COMMAND bash ${fuzz_run} --built 30 ${target})
  set_tests_properties(Fuzz.${target} PROPERTIES
    LABELS "fuzz;long" FIXTURES_REQUIRED FuzzBuild SKIP_RETURN_CODE 77 TIMEOUT 600)
endforeach()
