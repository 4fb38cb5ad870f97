# Tests that build something themselves. Those with the label long are left out by
# `ctest --preset release`; `ctest --preset all` runs them, too.

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
  surfmesh_add_package_test(Package.InstalledShared shared "package;long")
  surfmesh_add_package_test(Package.Subproject subproject "package;long")
endif()

surfmesh_add_building_test(PublicHeaders.CompileAlone "package;long"
  ${CMAKE_COMMAND} --build ${PROJECT_BINARY_DIR} --target all_verify_interface_header_sets)

# The tests of these stages again, under the address and undefined-behaviour sanitizers.
set(sanitized core io geometry formula model cage metric quality delaunay boundary refine improve
    patch_mesh patch control sizes sampling estimate assemble formats model_file)
get_property(stages GLOBAL PROPERTY surfmesh_test_stages)
foreach(stage IN LISTS sanitized)
  if(stage IN_LIST stages)
    list(APPEND sanitized_targets ${stage}_test)
    add_test(NAME Sanitize.${stage} COMMAND ${PROJECT_SOURCE_DIR}/build/sanitize/tests/${stage}_test)
    set_tests_properties(Sanitize.${stage} PROPERTIES
      LABELS "sanitize;long" FIXTURES_REQUIRED sanitize TIMEOUT 1800
      # Not the folder in which the same test may run just now without sanitizers.
      ENVIRONMENT TEST_TMPDIR=${PROJECT_BINARY_DIR}/sanitize)
  endif()
endforeach()
list(JOIN sanitized_targets "," sanitized_targets)  # a list would become several arguments
surfmesh_add_building_test(Sanitize.Build "sanitize;long"
  ${CMAKE_COMMAND} -D SOURCE=${PROJECT_SOURCE_DIR} -D TARGETS=${sanitized_targets}
  -P ${CMAKE_CURRENT_SOURCE_DIR}/sanitize.cmake)
set_tests_properties(Sanitize.Build PROPERTIES FIXTURES_SETUP sanitize)

# Random small models through the program, judged by a script of its own.
if(TARGET surfmesh_program)
  add_test(NAME Soak.RandomModels COMMAND bash ${CMAKE_CURRENT_SOURCE_DIR}/soak.sh
    ${PROJECT_SOURCE_DIR}/../shared/bench/soak.py $<TARGET_FILE:surfmesh_program> 50 14)
  set_tests_properties(Soak.RandomModels PROPERTIES LABELS "soak;long" SKIP_RETURN_CODE 77)
endif()
