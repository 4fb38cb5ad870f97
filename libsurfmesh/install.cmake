# What find_package(surfmesh) needs: library, headers, targets, config.
include(GNUInstallDirs)
include(CMakePackageConfigHelpers)

set(config_folder ${CMAKE_INSTALL_LIBDIR}/cmake/surfmesh)

install(TARGETS surfmesh EXPORT surfmeshTargets FILE_SET HEADERS)
install(EXPORT surfmeshTargets NAMESPACE surfmesh:: DESTINATION ${config_folder})

configure_package_config_file(cmake/surfmeshConfig.cmake.in surfmeshConfig.cmake
  INSTALL_DESTINATION ${config_folder} NO_SET_AND_CHECK_MACRO)
write_basic_package_version_file(surfmeshConfigVersion.cmake COMPATIBILITY SameMinorVersion)
install(FILES
  ${CMAKE_CURRENT_BINARY_DIR}/surfmeshConfig.cmake
  ${CMAKE_CURRENT_BINARY_DIR}/surfmeshConfigVersion.cmake
  cmake/FindOpenSubdiv.cmake
  DESTINATION ${config_folder})
install(FILES ${PROJECT_SOURCE_DIR}/LICENSE DESTINATION ${CMAKE_INSTALL_DOCDIR})
