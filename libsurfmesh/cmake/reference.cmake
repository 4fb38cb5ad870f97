# The target `reference`: pages of all public headers, by Doxygen, in <build>/reference/html. It
# fails on any warning.
find_program(SURFMESH_DOXYGEN doxygen)
mark_as_advanced(SURFMESH_DOXYGEN)
if(NOT SURFMESH_DOXYGEN)
  return()
endif()

foreach(library IN ITEMS surfmesh surfmesh_cad surfmesh_mpi surfmesh_metis)
  if(TARGET ${library})
    get_target_property(headers ${library} HEADER_SET)
    list(APPEND public_headers ${headers})
  endif()
endforeach()
list(JOIN public_headers "\" \\\n                         \"" public_headers)
configure_file(${CMAKE_CURRENT_LIST_DIR}/Doxyfile.in ${PROJECT_BINARY_DIR}/reference/Doxyfile @ONLY)
add_custom_target(reference
  COMMAND ${SURFMESH_DOXYGEN} ${PROJECT_BINARY_DIR}/reference/Doxyfile
  COMMAND ${CMAKE_COMMAND} -E echo "Made ${PROJECT_BINARY_DIR}/reference/html/index.html"
  VERBATIM)
