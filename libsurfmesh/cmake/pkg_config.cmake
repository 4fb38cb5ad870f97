# surfmesh.pc: what a build without CMake needs, by `pkg-config --cflags --libs surfmesh`. It passes
# no -std, for programs choose theirs; headers tell where it is older than C++20.

set(pkg_config_folder ${CMAKE_INSTALL_LIBDIR}/pkgconfig)
if(IS_ABSOLUTE ${CMAKE_INSTALL_LIBDIR})
  set(pc_prefix ${CMAKE_INSTALL_PREFIX})
else()
  set(pc_prefix /prefix)
  cmake_path(RELATIVE_PATH pc_prefix BASE_DIRECTORY /prefix/${pkg_config_folder})
  set(pc_prefix "\${pcfiledir}/${pc_prefix}")
endif()
foreach(name IN ITEMS includedir libdir)
  string(TOUPPER ${name} folder)
  set(pc_${name} ${CMAKE_INSTALL_${folder}})
  if(NOT IS_ABSOLUTE ${pc_${name}})
    set(pc_${name} "\${prefix}/${pc_${name}}")
  endif()
endforeach()

# A shared library brings along what only its sources use. With a static one programs link it, by
# `pkg-config --static`. OpenSubdiv has no file for pkg-config.
get_target_property(surfmesh_type surfmesh TYPE)
if(surfmesh_type STREQUAL "STATIC_LIBRARY")
  set(pc_requires_private "fmt, tbb, expat, zlib")
  set(pc_libs_private "-losdCPU")
  cmake_path(GET OpenSubdiv_osdCPU_LIBRARY PARENT_PATH osd_folder)
  if(NOT osd_folder IN_LIST CMAKE_CXX_IMPLICIT_LINK_DIRECTORIES)
    string(PREPEND pc_libs_private "-L${osd_folder} ")
  endif()
endif()

configure_file(cmake/surfmesh.pc.in surfmesh.pc @ONLY)
install(FILES ${CMAKE_CURRENT_BINARY_DIR}/surfmesh.pc DESTINATION ${pkg_config_folder}
  COMPONENT surfmesh_development)
