# What find_package(surfmesh) needs: library, headers, targets, config; what pkg-config needs; and
# what users read.
include(GNUInstallDirs)
include(CMakePackageConfigHelpers)

set(config_folder ${CMAKE_INSTALL_LIBDIR}/cmake/surfmesh)

# surfmesh_install_library(<library>): it, its headers and its targets. Components of the
# installation are the packages of package.cmake; a shared library belongs to the programs.
function(surfmesh_install_library library)
  install(TARGETS ${library} EXPORT ${library}Targets
    RUNTIME COMPONENT surfmesh_programs
    LIBRARY COMPONENT surfmesh_programs NAMELINK_COMPONENT surfmesh_development
    ARCHIVE COMPONENT surfmesh_development
    FILE_SET HEADERS COMPONENT surfmesh_development)
  install(EXPORT ${library}Targets NAMESPACE surfmesh::
    DESTINATION ${CMAKE_INSTALL_LIBDIR}/cmake/surfmesh COMPONENT surfmesh_development)
endfunction()
surfmesh_install_library(surfmesh)

configure_package_config_file(cmake/surfmeshConfig.cmake.in surfmeshConfig.cmake
  INSTALL_DESTINATION ${config_folder} NO_SET_AND_CHECK_MACRO
  NO_CHECK_REQUIRED_COMPONENTS_MACRO)
write_basic_package_version_file(surfmeshConfigVersion.cmake COMPATIBILITY SameMajorVersion)
install(FILES
  ${CMAKE_CURRENT_BINARY_DIR}/surfmeshConfig.cmake
  ${CMAKE_CURRENT_BINARY_DIR}/surfmeshConfigVersion.cmake
  cmake/FindOpenSubdiv.cmake
  DESTINATION ${config_folder} COMPONENT surfmesh_development)
include(cmake/pkg_config.cmake)

# Models with their JSON schema, to try and to copy from.
install(DIRECTORY ${PROJECT_SOURCE_DIR}/models DESTINATION ${CMAKE_INSTALL_DATADIR}/surfmesh
  COMPONENT surfmesh_programs)
# CMAKE_INSTALL_DOCDIR belongs to the project around this one, if there is one.
set(document_folder ${CMAKE_INSTALL_DATAROOTDIR}/doc/surfmesh)
if(PROJECT_IS_TOP_LEVEL)
  set(document_folder ${CMAKE_INSTALL_DOCDIR})
endif()
install(FILES ${PROJECT_SOURCE_DIR}/LICENSE ${PROJECT_SOURCE_DIR}/README.md
              ${PROJECT_SOURCE_DIR}/CHANGELOG.md
  DESTINATION ${document_folder} COMPONENT surfmesh_programs)
# In a folder as here, so that documents find each other and their pictures.
install(FILES CLUSTER.md CONTRIBUTING.md DECISIONS.md FORMATS.md GALLERY.md LIBRARY.md PAPER.md PYTHON.md README.md
  REFERENCE.md VIEW.md
  DESTINATION ${document_folder}/libsurfmesh COMPONENT surfmesh_programs)
install(DIRECTORY pictures DESTINATION ${document_folder}/libsurfmesh
  COMPONENT surfmesh_programs)
