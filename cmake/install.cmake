include(GNUInstallDirs)
include(CMakePackageConfigHelpers)
install(TARGETS gapflow gapflow_options gapflow_command EXPORT gapflow-targets
  RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR} LIBRARY DESTINATION ${CMAKE_INSTALL_LIBDIR} ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR})
install(DIRECTORY src/gapflow DESTINATION ${CMAKE_INSTALL_INCLUDEDIR} FILES_MATCHING PATTERN "*.hpp")
install(EXPORT gapflow-targets NAMESPACE gapflow:: DESTINATION ${CMAKE_INSTALL_LIBDIR}/cmake/gapflow)
configure_package_config_file(cmake/gapflow-config.cmake.in ${PROJECT_BINARY_DIR}/gapflow-config.cmake
  INSTALL_DESTINATION ${CMAKE_INSTALL_LIBDIR}/cmake/gapflow)
write_basic_package_version_file(${PROJECT_BINARY_DIR}/gapflow-config-version.cmake COMPATIBILITY SameMinorVersion)
install(FILES ${PROJECT_BINARY_DIR}/gapflow-config.cmake ${PROJECT_BINARY_DIR}/gapflow-config-version.cmake
  DESTINATION ${CMAKE_INSTALL_LIBDIR}/cmake/gapflow)
