# Build targets with the preset `sanitize`: cmake -D SOURCE=<surfmesh> -D TARGETS=<a,b,c>
#                                                -P sanitize.cmake
string(REPLACE "," ";" TARGETS ${TARGETS})
foreach(arguments "--preset;sanitize" "--build;--preset;sanitize;--target;${TARGETS}")
  execute_process(COMMAND ${CMAKE_COMMAND} ${arguments} WORKING_DIRECTORY ${SOURCE}
                  COMMAND_ERROR_IS_FATAL ANY)
endforeach()
