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
  surfmesh_add_package_test(Package.Subproject subproject "package;long;nightly")
endif()

# The packages of a release, in systems that have nothing else.
if(SURFMESH_INSTALL AND TARGET surfmesh_program)
  surfmesh_add_building_test(Package.Cpack "package;long;nightly"
    bash ${CMAKE_CURRENT_SOURCE_DIR}/package/clean_root_test.sh ${PROJECT_SOURCE_DIR}
    ${PROJECT_BINARY_DIR}/package/clean_root)
  set_tests_properties(Package.Cpack PROPERTIES SKIP_RETURN_CODE 77)
endif()

# The reference of the public headers.
if(TARGET reference)
  surfmesh_add_building_test(Reference.Doxygen "package;long"
    ${CMAKE_COMMAND} -D BUILD=${PROJECT_BINARY_DIR} -D DOXYGEN=${SURFMESH_DOXYGEN}
    -P ${CMAKE_CURRENT_SOURCE_DIR}/package/reference_test.cmake)
else()
  surfmesh_add_building_test(Reference.Doxygen "package;long"
    ${CMAKE_COMMAND} -E echo "skipped: doxygen is not installed (tools/setup.sh --reference)")
  set_tests_properties(Reference.Doxygen PROPERTIES SKIP_REGULAR_EXPRESSION "^skipped")
endif()

surfmesh_add_building_test(PublicHeaders.CompileAlone "package;long;nightly"
  ${CMAKE_COMMAND} --build ${PROJECT_BINARY_DIR} --target all_verify_interface_header_sets)

# The tests of these stages again, under the address and undefined-behaviour sanitizers, and of those
# that share work under the thread sanitizer. Those of nightly lists take longer to build and to run.
set(sanitized core io geometry formula metric quality delaunay boundary patch_mesh control formats)
set(sanitized_nightly model cage refine improve quad patch sizes sampling estimate assemble across
    model_file cad exchange tiles pieces fuzz)
set(threads_nightly core io quality assemble across sizes formats pipeline)
get_property(stages GLOBAL PROPERTY surfmesh_test_stages)

# surfmesh_add_sanitized_tests(<prefix of the tests> <preset> <name of the fixture> <labels>
#                              <stages...>)
function(surfmesh_add_sanitized_tests prefix preset fixture labels)
  foreach(stage IN LISTS ARGN)
    if(stage IN_LIST stages)
      list(APPEND targets ${stage}_test)
      add_test(NAME ${prefix}.${stage}
        COMMAND ${PROJECT_SOURCE_DIR}/build/${preset}/tests/${stage}_test)
      set_tests_properties(${prefix}.${stage} PROPERTIES
        LABELS "${labels}" FIXTURES_REQUIRED ${fixture} TIMEOUT 1800
        FAIL_REGULAR_EXPRESSION "Running 0 tests"
        # Not the folder in which the same test may run just now without sanitizers.
        ENVIRONMENT "TEST_TMPDIR=${PROJECT_BINARY_DIR}/${preset}")
    endif()
  endforeach()
  if(preset STREQUAL "sanitize-threads")
    list(APPEND targets seeded_race)
  endif()
  list(JOIN targets "," targets)  # a list would become several arguments
  surfmesh_add_building_test(${prefix}.${fixture} "${labels}"
    ${CMAKE_COMMAND} -D SOURCE=${PROJECT_SOURCE_DIR} -D PRESET=${preset} -D TARGETS=${targets}
    -P ${CMAKE_CURRENT_SOURCE_DIR}/sanitize.cmake)
  set_tests_properties(${prefix}.${fixture} PROPERTIES FIXTURES_SETUP ${fixture})
endfunction()

surfmesh_add_sanitized_tests(Sanitize sanitize Build "sanitize;long" ${sanitized})
surfmesh_add_sanitized_tests(Sanitize sanitize BuildNightly "sanitize;long;nightly"
  ${sanitized_nightly})
surfmesh_add_sanitized_tests(SanitizeThreads sanitize-threads BuildThreads
  "sanitize;long;nightly" ${threads_nightly})
# A race of our own, which has to be found.
add_test(NAME SanitizeThreads.FindsARace
  COMMAND ${PROJECT_SOURCE_DIR}/build/sanitize-threads/tests/seeded_race)
set_tests_properties(SanitizeThreads.FindsARace PROPERTIES LABELS "sanitize;long;nightly"
  FIXTURES_REQUIRED BuildThreads PASS_REGULAR_EXPRESSION "ThreadSanitizer: data race")
# Of whole runs, those on several threads or ranks.
set_property(TEST SanitizeThreads.pipeline APPEND PROPERTY ENVIRONMENT
  "GTEST_FILTER=*Threads*:PiecesOf.*")
# OpenCASCADE keeps what its readers allocate.
foreach(stage IN ITEMS cad fuzz)
  if(TARGET surfmesh_cad AND stage IN_LIST stages)
    set_property(TEST Sanitize.${stage} APPEND PROPERTY ENVIRONMENT ASAN_OPTIONS=detect_leaks=0)
  endif()
endforeach()

# Random small models through the program, judged by scripts: one that is shared, and our own of
# quads, NURBS, tiles, pieces and formats. tests/soak/nightly.sh runs as many as fit into a night.
function(surfmesh_add_soak name script)
  add_test(NAME Soak.${name} COMMAND bash ${CMAKE_CURRENT_SOURCE_DIR}/soak/soak.sh
    ${script} $<TARGET_FILE:surfmesh_program> ${ARGN})
  set_tests_properties(Soak.${name} PROPERTIES LABELS "soak;long" SKIP_RETURN_CODE 77)
endfunction()

if(TARGET surfmesh_program)
  set(own_soak ${CMAKE_CURRENT_SOURCE_DIR}/soak/soak.py)
  surfmesh_add_soak(RandomModels ${PROJECT_SOURCE_DIR}/../shared/bench/soak.py --runs 50 --seed 14)
  surfmesh_add_soak(QuadsNurbsTilesFormats ${own_soak} --runs 50 --seed 14)
  surfmesh_add_soak(Threads ${own_soak} --runs 10 --seed 15 --threads 1,2,3,8)

  add_test(NAME Faults.FromOutside COMMAND /usr/bin/python3
    ${CMAKE_CURRENT_SOURCE_DIR}/faults/faults.py $<TARGET_FILE_DIR:surfmesh_program>)
  set_tests_properties(Faults.FromOutside PROPERTIES LABELS "faults;long" TIMEOUT 900 RUN_SERIAL ON)
endif()

# Half a minute of each fuzz target; longer runs are for tests/fuzz/run.sh. Skipped without clang. They
# still find something now and then, so they stay out of what a change must pass.
set(fuzz_run ${CMAKE_CURRENT_SOURCE_DIR}/fuzz/run.sh)
surfmesh_add_building_test(Fuzz.Build "fuzz;long;nightly" bash ${fuzz_run} --build)
set_tests_properties(Fuzz.Build PROPERTIES FIXTURES_SETUP FuzzBuild SKIP_RETURN_CODE 77)
get_property(fuzz_targets GLOBAL PROPERTY surfmesh_fuzz_targets)
foreach(target IN LISTS fuzz_targets)
  add_test(NAME Fuzz.${target} COMMAND bash ${fuzz_run} --built 30 ${target})
  set_tests_properties(Fuzz.${target} PROPERTIES
    LABELS "fuzz;long;nightly" FIXTURES_REQUIRED FuzzBuild SKIP_RETURN_CODE 77 TIMEOUT 600
    # Longer runs find more; here, what was tried before is tried again.
    ENVIRONMENT SURFMESH_FUZZ_SEED=1)
endforeach()
