# Installs what platon_library() has collected: `cmake --install BUILD --component library --prefix PREFIX`.
include(CMakePackageConfigHelpers)
include(GNUInstallDirs)

set(package ${CMAKE_INSTALL_LIBDIR}/cmake/platon)
install(DIRECTORY include/platon DESTINATION include COMPONENT library)
install(EXPORT platon_targets NAMESPACE platon:: FILE platonTargets.cmake DESTINATION ${package} COMPONENT library)
install(FILES package/platonConfig.cmake DESTINATION ${package} COMPONENT library)

# Before version 1, a new minor version may change the interface.
write_basic_package_version_file(${CMAKE_CURRENT_BINARY_DIR}/platonConfigVersion.cmake COMPATIBILITY SameMinorVersion)
install(FILES ${CMAKE_CURRENT_BINARY_DIR}/platonConfigVersion.cmake DESTINATION ${package} COMPONENT library)

# Only the same version of GCC can read the code for optimisation across files, and -flto makes it try. The installed
# archives hold plain code.
if(TARGET platon_across_files AND CMAKE_CXX_COMPILER_ID STREQUAL GNU)
  set(prefix "\${CMAKE_INSTALL_PREFIX}/")
  if(IS_ABSOLUTE "${CMAKE_INSTALL_LIBDIR}")
    set(prefix "")
  endif()
  foreach(library exact physics)
    set(archive ${CMAKE_INSTALL_LIBDIR}/${CMAKE_STATIC_LIBRARY_PREFIX}platon_${library}${CMAKE_STATIC_LIBRARY_SUFFIX})
    install(CODE "execute_process(
      COMMAND \"${CMAKE_OBJCOPY}\" --wildcard --remove-section=.gnu.lto_* --remove-section=.gnu.debuglto_*
        --strip-symbol=__gnu_lto_v1 \"\$ENV{DESTDIR}${prefix}${archive}\"
      COMMAND_ERROR_IS_FATAL ANY)" COMPONENT library)
  endforeach()
endif()
