# The reference of the public headers is made without a warning, and each public type, function and
# type alias has a text: cmake -D BUILD=<build folder> -D DOXYGEN=<program> -P reference_test.cmake
# Members of classes and structs, and constants, may speak for themselves.
execute_process(COMMAND ${CMAKE_COMMAND} --build ${BUILD} --target reference
  COMMAND_ERROR_IS_FATAL ANY)
foreach(page IN ITEMS index.html structsurfmesh_1_1Model.html namespacesurfmesh.html)
  if(NOT EXISTS ${BUILD}/reference/html/${page})
    message(SEND_ERROR "the reference has no ${page}")
  endif()
endforeach()

set(file ${BUILD}/reference/Doxyfile.undocumented)
file(WRITE ${file} "@INCLUDE = ${BUILD}/reference/Doxyfile\nGENERATE_HTML = NO\n"
  "WARN_AS_ERROR = NO\nWARN_IF_UNDOCUMENTED = YES\n")
execute_process(COMMAND ${DOXYGEN} ${file} ERROR_VARIABLE warnings COMMAND_ERROR_IS_FATAL ANY)
string(REGEX MATCHALL "[^\n]*warning: [^\n]* is not documented" undocumented "${warnings}")
list(LENGTH undocumented count)
if(count EQUAL 0)
  message(SEND_ERROR "no member without a text: that warnings are read cannot be seen")
endif()
list(FILTER undocumented EXCLUDE REGEX "warning: Member .* ((of (class|struct) )|\\(variable\\))")
foreach(line IN LISTS undocumented)
  message(SEND_ERROR "${line}")
endforeach()
