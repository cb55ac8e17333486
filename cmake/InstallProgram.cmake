# What an installed program has beside its binaries: manual, completion, licence, docs, desktop files. The
# manual is what the program just built says of itself, so a cross build leaves it out.
install(FILES LICENSE CHANGELOG.md README.md CITATION.cff
  DESTINATION ${CMAKE_INSTALL_DOCDIR} COMPONENT program)
install(DIRECTORY docs DESTINATION ${CMAKE_INSTALL_DOCDIR} COMPONENT doc)
install(FILES packaging/pupflow.desktop
  DESTINATION ${CMAKE_INSTALL_DATADIR}/applications COMPONENT graphics)
install(FILES packaging/pupflow.metainfo.xml
  DESTINATION ${CMAKE_INSTALL_DATADIR}/metainfo COMPONENT graphics)
install(FILES packaging/pupflow.svg
  DESTINATION ${CMAKE_INSTALL_DATADIR}/icons/hicolor/scalable/apps COMPONENT graphics)

if(NOT CMAKE_CROSSCOMPILING)
  set(manual ${CMAKE_BINARY_DIR}/manual)
  add_custom_command(OUTPUT ${manual}/made
    COMMAND ${PROJECT_SOURCE_DIR}/scripts/manual $<TARGET_FILE:pupflow> ${manual}
    COMMAND ${CMAKE_COMMAND} -E touch ${manual}/made
    DEPENDS pupflow ${PROJECT_SOURCE_DIR}/scripts/manual VERBATIM)
  add_custom_target(pupflow_manual ALL DEPENDS ${manual}/made)
  install(DIRECTORY ${manual}/man1/ DESTINATION ${CMAKE_INSTALL_MANDIR}/man1 COMPONENT program)
  install(FILES ${manual}/pupflow.bash RENAME pupflow
    DESTINATION ${CMAKE_INSTALL_DATADIR}/bash-completion/completions COMPONENT program)
  install(FILES ${manual}/_pupflow
    DESTINATION ${CMAKE_INSTALL_DATADIR}/zsh/vendor-completions COMPONENT program)
endif()

configure_file(cmake/uninstall.cmake.in uninstall.cmake @ONLY)
add_custom_target(uninstall COMMAND ${CMAKE_COMMAND} -P ${CMAKE_BINARY_DIR}/uninstall.cmake)
