# The engine as a CMake package: find_package(pupflow) gives pupflow::engine and, where the shared library
# is installed, pupflow::engine_shared. Component `engine` is what a compiler needs, `library` the shared
# library that programs load; `cmake --install BUILD --component engine` installs the one without the other.
include(CMakePackageConfigHelpers)
set(package_folder ${CMAKE_INSTALL_LIBDIR}/cmake/pupflow)

install(TARGETS pupflow_engine EXPORT pupflow_engine
  ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR} COMPONENT engine)
install(EXPORT pupflow_engine NAMESPACE pupflow:: FILE pupflowTargets.cmake
  DESTINATION ${package_folder} COMPONENT engine)
if(TARGET pupflow_engine_shared)
  install(TARGETS pupflow_engine_shared EXPORT pupflow_engine_shared
    LIBRARY DESTINATION ${CMAKE_INSTALL_LIBDIR} COMPONENT library NAMELINK_COMPONENT engine)
  install(EXPORT pupflow_engine_shared NAMESPACE pupflow:: FILE pupflowSharedTargets.cmake
    DESTINATION ${package_folder} COMPONENT engine)
endif()
install(DIRECTORY engine/include/ DESTINATION ${CMAKE_INSTALL_INCLUDEDIR} COMPONENT engine)

configure_package_config_file(cmake/pupflowConfig.cmake.in pupflowConfig.cmake
  INSTALL_DESTINATION ${package_folder} PATH_VARS CMAKE_INSTALL_LIBDIR)
# Before 1.0 a minor version may break what uses it.
write_basic_package_version_file(pupflowConfigVersion.cmake COMPATIBILITY SameMinorVersion)
file(RELATIVE_PATH prefix_from_pc /${CMAKE_INSTALL_LIBDIR}/pkgconfig /)
configure_file(cmake/pupflow.pc.in pupflow.pc @ONLY)
install(FILES ${CMAKE_CURRENT_BINARY_DIR}/pupflow.pc
  DESTINATION ${CMAKE_INSTALL_LIBDIR}/pkgconfig COMPONENT engine)
install(FILES ${CMAKE_CURRENT_BINARY_DIR}/pupflowConfig.cmake
  ${CMAKE_CURRENT_BINARY_DIR}/pupflowConfigVersion.cmake
  DESTINATION ${package_folder} COMPONENT engine)
