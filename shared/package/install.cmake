# Installs what platon_library() has collected: `cmake --install BUILD --component library --prefix PREFIX`.
include(CMakePackageConfigHelpers)

set(package ${CMAKE_INSTALL_LIBDIR}/cmake/platon)
install(DIRECTORY include/platon DESTINATION include COMPONENT library)
install(EXPORT platon_targets NAMESPACE platon:: FILE platonTargets.cmake DESTINATION ${package} COMPONENT library)
install(FILES package/platonConfig.cmake DESTINATION ${package} COMPONENT library)

# Before version 1, a new minor version may change the interface.
write_basic_package_version_file(${CMAKE_CURRENT_BINARY_DIR}/platonConfigVersion.cmake COMPATIBILITY SameMinorVersion)
install(FILES ${CMAKE_CURRENT_BINARY_DIR}/platonConfigVersion.cmake DESTINATION ${package} COMPONENT library)

# For pkg-config. The paths begin at the file itself, so that the installed folder can be moved.
set(pkg_config_folder ${CMAKE_INSTALL_LIBDIR}/pkgconfig)
string(REGEX REPLACE "[^/]+" ".." prefix_from_pkg_config ${pkg_config_folder})
configure_file(package/platon.pc.in platon.pc @ONLY)
install(FILES ${CMAKE_CURRENT_BINARY_DIR}/platon.pc DESTINATION ${pkg_config_folder} COMPONENT library)
