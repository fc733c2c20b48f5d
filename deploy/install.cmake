# Installs the game: `cmake --install BUILD --component NAME --prefix PREFIX`. The components are client, data (the levels,
# which client and server need), server, tools and library, which shared/package/install.cmake installs. Man pages and
# completions are made from what the programs print for --help.
include(GNUInstallDirs)
find_package(Python3 COMPONENTS Interpreter)

set(PLATON_GAME_FOLDER ${CMAKE_INSTALL_BINDIR} CACHE STRING "Folder for the client")
set(PLATON_DOC_FOLDER ${CMAKE_INSTALL_DOCDIR} CACHE STRING "Folder for the pages")
set(PLATON_UNIT_FOLDER lib/systemd/system CACHE STRING "Folder for the units of systemd")
set(describe ${CMAKE_CURRENT_LIST_DIR}/describe)
set(described ${PROJECT_BINARY_DIR}/described)
set(described_files)
cmake_path(ABSOLUTE_PATH PLATON_DOC_FOLDER BASE_DIRECTORY ${CMAKE_INSTALL_PREFIX} OUTPUT_VARIABLE installed_pages)

# platon_install_program(target COMPONENT component SECTION man_section [FOLDER folder])
# Installs a program, its man page and its completions, if this build has the program.
function(platon_install_program target)
  cmake_parse_arguments(PARSE_ARGV 1 arg "" "COMPONENT;SECTION;FOLDER" "")
  if(NOT TARGET ${target})
    return()
  endif()
  if(NOT arg_FOLDER)
    set(arg_FOLDER ${CMAKE_INSTALL_BINDIR})
  endif()
  install(TARGETS ${target} RUNTIME DESTINATION ${arg_FOLDER} COMPONENT ${arg_COMPONENT})
  if(NOT Python3_FOUND)
    return()
  endif()
  set(page ${described}/${target}.${arg_SECTION})
  set(completions ${described}/${target}.bash ${described}/_${target} ${described}/${target}.fish)
  file(GLOB scripts CONFIGURE_DEPENDS ${describe}/*.py)
  add_custom_command(OUTPUT ${page} ${completions}
    COMMAND ${Python3_EXECUTABLE} -B ${describe}/describe.py $<TARGET_FILE:${target}> ${arg_SECTION} ${described}
            ${installed_pages}/docs
    DEPENDS ${target} ${scripts} VERBATIM)
  install(FILES ${page} DESTINATION ${CMAKE_INSTALL_MANDIR}/man${arg_SECTION} COMPONENT ${arg_COMPONENT})
  install(FILES ${described}/${target}.bash DESTINATION ${CMAKE_INSTALL_DATADIR}/bash-completion/completions
          RENAME ${target} COMPONENT ${arg_COMPONENT})
  install(FILES ${described}/_${target} DESTINATION ${CMAKE_INSTALL_DATADIR}/zsh/vendor-completions COMPONENT ${arg_COMPONENT})
  install(FILES ${described}/${target}.fish DESTINATION ${CMAKE_INSTALL_DATADIR}/fish/vendor_completions.d
          COMPONENT ${arg_COMPONENT})
  set(described_files ${described_files} ${page} ${completions} PARENT_SCOPE)
endfunction()

platon_install_program(platon-client COMPONENT client SECTION 6 FOLDER ${PLATON_GAME_FOLDER})
platon_install_program(platon-server COMPONENT server SECTION 8)
foreach(tool bench bot level sim)
  platon_install_program(platon-${tool} COMPONENT tools SECTION 1)
endforeach()

# The levels, the recorded ways to their goals, and the times that their medals follow from. A link to the folder would
# be installed as a link.
file(REAL_PATH ${PROJECT_SOURCE_DIR}/levels/data levels)
install(DIRECTORY ${levels}/ DESTINATION ${CMAKE_INSTALL_DATADIR}/platon/levels COMPONENT data
        FILES_MATCHING PATTERN *.level PATTERN *.recording PATTERN way_times)

# The pages and what they link to, in folders as here, so that the links lead there. Links to files would be installed as
# links.
file(REAL_PATH ${PROJECT_SOURCE_DIR}/docs pages)
cmake_path(GET pages PARENT_PATH tree)
install(DIRECTORY ${pages} DESTINATION ${PLATON_DOC_FOLDER} COMPONENT data
        FILES_MATCHING PATTERN *.md PATTERN *.png PATTERN *.svg PATTERN *.gif)
install(FILES ${tree}/README.md ${tree}/CHANGELOG.md ${tree}/CONTRIBUTING.md ${tree}/SECURITY.md
        DESTINATION ${PLATON_DOC_FOLDER} COMPONENT data)
install(DIRECTORY ${tree}/shared/proof DESTINATION ${PLATON_DOC_FOLDER}/shared COMPONENT data)
install(FILES ${tree}/tests/client/gl/golden/elements.png
        DESTINATION ${PLATON_DOC_FOLDER}/tests/client/gl/golden COMPONENT data)

# What a desktop knows of the client.
set(desktop ${CMAKE_CURRENT_LIST_DIR}/desktop)
install(FILES ${desktop}/platon.desktop DESTINATION ${CMAKE_INSTALL_DATADIR}/applications COMPONENT client)
install(FILES ${desktop}/platon.svg DESTINATION ${CMAKE_INSTALL_DATADIR}/icons/hicolor/scalable/apps COMPONENT client)
install(FILES ${desktop}/invalid.platon.platon.metainfo.xml DESTINATION ${CMAKE_INSTALL_DATADIR}/metainfo COMPONENT client)

# The configuration of the service: the one with all defaults, and files in the folders that its unit gives it.
set(server_config ${described}/server.toml)
add_custom_command(OUTPUT ${server_config}
  COMMAND ${CMAKE_COMMAND} -DSERVER=$<TARGET_FILE:platon-server> -DOUT=${server_config} -P ${describe}/server_config.cmake
  DEPENDS platon-server ${describe}/server_config.cmake VERBATIM)
install(FILES ${server_config} DESTINATION ${CMAKE_INSTALL_FULL_SYSCONFDIR}/platon COMPONENT server)
list(APPEND described_files ${server_config})
add_custom_target(described ALL DEPENDS ${described_files})

# platon_install_unit(unit CONFIG name FOLDER folder)
# Installs a unit of systemd that runs a server with /etc/platon/NAME.toml, and keeps its files in /var/lib/FOLDER and
# /run/FOLDER.
function(platon_install_unit unit)
  cmake_parse_arguments(PARSE_ARGV 1 unit "" "TITLE;CONFIG;FOLDER" "")
  configure_file(${PROJECT_SOURCE_DIR}/deploy/systemd/platon-server.service.in ${described}/${unit} @ONLY)
  install(FILES ${described}/${unit} DESTINATION ${PLATON_UNIT_FOLDER} COMPONENT server)
endfunction()

platon_install_unit(platon-server.service TITLE "Platon server" CONFIG server FOLDER platon)
platon_install_unit(platon-server@.service TITLE "Platon server %i" CONFIG %i FOLDER platon/%i)
install(FILES ${CMAKE_CURRENT_LIST_DIR}/systemd/sysusers.conf DESTINATION lib/sysusers.d RENAME platon-server.conf
        COMPONENT server)
install(FILES ${CMAKE_CURRENT_LIST_DIR}/systemd/tmpfiles.conf DESTINATION lib/tmpfiles.d RENAME platon-server.conf
        COMPONENT server)
