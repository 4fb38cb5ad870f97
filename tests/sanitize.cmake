# Build targets with a preset: cmake -D SOURCE=<surfmesh> -D PRESET=<name> -D TARGETS=<a,b,c>
#                              -P sanitize.cmake
string(REPLACE "," ";" TARGETS ${TARGETS})
foreach(arguments "--preset;${PRESET}" "--build;--preset;${PRESET};--target;${TARGETS}")
  execute_process(COMMAND ${CMAKE_COMMAND} ${arguments} WORKING_DIRECTORY ${SOURCE}
                  COMMAND_ERROR_IS_FATAL ANY)
endforeach()
