# Installed files, for any prefix: the program, its scenes with their schema, manual pages,
# completions, documents.
include(GNUInstallDirs)

install(TARGETS poinsot RUNTIME)
# The documents that the program generates are written during installation, so that they match the
# program.
set(own_documents ${PROJECT_BINARY_DIR}/share)
install(CODE "execute_process(COMMAND \"${CMAKE_COMMAND}\" -DPROGRAM=$<TARGET_FILE:poinsot> -DFOLDER=${own_documents}
    -P \"${PROJECT_SOURCE_DIR}/src/cmake/write_documents.cmake\" COMMAND_ERROR_IS_FATAL ANY)")
foreach(below poinsot bash-completion fish man)
    install(DIRECTORY ${own_documents}/${below} DESTINATION ${CMAKE_INSTALL_DATADIR})
endforeach()
# Debian's zsh searches completions of packages in its own folder.
set(zsh_folder zsh/site-functions)
if(EXISTS /etc/debian_version)
    set(zsh_folder zsh/vendor-completions)
endif()
install(FILES ${own_documents}/zsh/_poinsot DESTINATION ${CMAKE_INSTALL_DATADIR}/${zsh_folder})
install(DIRECTORY ${PROJECT_SOURCE_DIR}/scenes DESTINATION ${CMAKE_INSTALL_DATADIR}/poinsot
    PATTERN "scene.schema.json" EXCLUDE)
install(DIRECTORY ${PROJECT_SOURCE_DIR}/docs/ DESTINATION ${CMAKE_INSTALL_DOCDIR})
install(FILES ${PROJECT_SOURCE_DIR}/README.md DESTINATION ${CMAKE_INSTALL_DOCDIR})
install(FILES ${PROJECT_SOURCE_DIR}/LICENSE DESTINATION ${CMAKE_INSTALL_DOCDIR} RENAME copyright)
# Of Mediabunny, which pages carry to write films.
install(FILES ${PROJECT_SOURCE_DIR}/src/doors/web/page/film_writer/node_modules/mediabunny/LICENSE DESTINATION ${CMAKE_INSTALL_DOCDIR}
    RENAME mediabunny.copyright OPTIONAL)
# Of CodeMirror, with which the workbench edits scenes.
install(FILES ${PROJECT_SOURCE_DIR}/src/doors/web/page/text_editor/node_modules/@codemirror/view/LICENSE DESTINATION ${CMAKE_INSTALL_DOCDIR}
    RENAME codemirror.copyright OPTIONAL)
install(FILES ${PROJECT_SOURCE_DIR}/CHANGELOG.md DESTINATION ${CMAKE_INSTALL_DOCDIR})
install(FILES ${PROJECT_BINARY_DIR}/changelog.gz DESTINATION ${CMAKE_INSTALL_DOCDIR})
