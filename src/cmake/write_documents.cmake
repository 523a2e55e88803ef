# Writes the documents that are installed: manual pages, completions, the schema of scene files.
# Usage: cmake -DPROGRAM=… -DFOLDER=… -P write_documents.cmake

function(write_document name to)
    execute_process(COMMAND ${PROGRAM} list ${name} OUTPUT_FILE ${FOLDER}/${to} COMMAND_ERROR_IS_FATAL ANY)
endfunction()

file(REMOVE_RECURSE ${FOLDER})
foreach(below bash-completion/completions zsh fish/vendor_completions.d poinsot/scenes man/man1 man/man5)
    file(MAKE_DIRECTORY ${FOLDER}/${below})
endforeach()
write_document(completion.bash bash-completion/completions/poinsot)
write_document(completion.zsh zsh/_poinsot)
write_document(completion.fish fish/vendor_completions.d/poinsot.fish)
write_document(schema poinsot/scenes/scene.schema.json)

# One page per command, and one for scene files. Compressed without a date, as required by Debian.
execute_process(COMMAND ${PROGRAM} list documents OUTPUT_VARIABLE documents COMMAND_ERROR_IS_FATAL ANY)
string(REGEX MATCHALL "poinsot[a-z-]*\\.[15]" pages "${documents}")
foreach(page IN LISTS pages)
    string(REGEX MATCH "[15]$" section ${page})
    write_document(${page} man/man${section}/${page})
    execute_process(COMMAND gzip -9n ${FOLDER}/man/man${section}/${page} COMMAND_ERROR_IS_FATAL ANY)
endforeach()
