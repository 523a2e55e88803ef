# Builds and packs a bundle. Variables: BUILD, the build folder; NAME of the bundle; PROGRAM, linked
# for it; OPENED, names of the libraries that are opened at run time. Written for Debian, whose dpkg
# finds the package of a library.
cmake_minimum_required(VERSION 3.25)

set(bundle ${BUILD}/bundle/${NAME})
file(REMOVE_RECURSE ${bundle})
file(MAKE_DIRECTORY ${bundle}/lib ${bundle}/share/doc/poinsot/licences)
execute_process(COMMAND ${CMAKE_COMMAND} --install ${BUILD} --prefix ${bundle} --component program OUTPUT_QUIET COMMAND_ERROR_IS_FATAL ANY)
file(COPY_FILE ${PROGRAM} ${bundle}/bin/poinsot)
execute_process(COMMAND strip ${bundle}/bin/poinsot COMMAND_ERROR_IS_FATAL ANY)

# Libraries, by the names in the linker's cache.
execute_process(COMMAND /sbin/ldconfig -p OUTPUT_VARIABLE known COMMAND_ERROR_IS_FATAL ANY)
set(opened "")
foreach(name IN LISTS OPENED)
    string(REPLACE "." "\\." pattern "${name}")
    if(NOT known MATCHES "\t${pattern} \\([^)]*\\) => ([^\n]+)")
        message(FATAL_ERROR "${name} is not installed; a bundle needs it")
    endif()
    list(APPEND opened ${CMAKE_MATCH_1})
endforeach()
# glibc comes from the machine; the bundle must not contain another version of it.
set(glibc "/(ld-linux.*|libc|libm|libmvec|libpthread|libdl|librt|libresolv|libutil|libanl)\\.so(\\.[0-9]+)*$")
file(GET_RUNTIME_DEPENDENCIES EXECUTABLES ${PROGRAM} LIBRARIES ${opened} RESOLVED_DEPENDENCIES_VAR needed
    UNRESOLVED_DEPENDENCIES_VAR unresolved POST_EXCLUDE_REGEXES ${glibc})
if(unresolved)
    message(FATAL_ERROR "these libraries are missing: ${unresolved}")
endif()
list(APPEND needed ${opened})
list(REMOVE_DUPLICATES needed)
set(files "")
foreach(library IN LISTS needed)
    get_filename_component(name ${library} NAME)
    file(REAL_PATH ${library} file)
    file(COPY_FILE ${file} ${bundle}/lib/${name})
    list(APPEND files ${file})
endforeach()

# Fonts, in the folder that the program searches first.
execute_process(COMMAND dpkg-query -L fonts-lmodern OUTPUT_VARIABLE fonts COMMAND_ERROR_IS_FATAL ANY)
foreach(name latinmodern-math lmsans10-regular lmsans10-bold lmsans10-oblique lmroman10-regular lmroman10-bold lmroman10-italic)
    if(NOT fonts MATCHES "([^\n]+/${name}\\.otf)")
        message(FATAL_ERROR "${name}.otf is not in fonts-lmodern")
    endif()
    file(COPY ${CMAKE_MATCH_1} DESTINATION ${bundle}/share/poinsot/fonts)
endforeach()

# Licences: of each library's package; of the headers compiled into the program; and the texts that
# these refer to.
set(packages fonts-lmodern libboost-dev libcli11-dev libeigen3-dev libglm-dev libtomlplusplus-dev python3-glad)
foreach(file IN LISTS files)
    string(REGEX REPLACE "^/usr/lib/" "/lib/" other ${file})
    execute_process(COMMAND dpkg-query -S ${file} ${other} OUTPUT_VARIABLE owner ERROR_QUIET)
    if(NOT owner MATCHES "^([^:,\n]+)")
        message(FATAL_ERROR "no package is known of ${file}, and so no licence")
    endif()
    list(APPEND packages ${CMAKE_MATCH_1})
endforeach()
list(REMOVE_DUPLICATES packages)
foreach(package IN LISTS packages)
    file(REAL_PATH /usr/share/doc/${package}/copyright licence)
    file(COPY_FILE ${licence} ${bundle}/share/doc/poinsot/licences/${package})
endforeach()
# Of what pages carry to write films, and the workbench to edit scenes, if they do.
foreach(package mediabunny=film_writer/node_modules/mediabunny codemirror=text_editor/node_modules/@codemirror/view)
    string(REPLACE "=" ";" package ${package})
    list(GET package 0 name)
    list(GET package 1 folder)
    get_filename_component(licence ${CMAKE_CURRENT_LIST_DIR}/../web/page/${folder}/LICENSE ABSOLUTE)
    if(EXISTS ${licence})
        file(COPY_FILE ${licence} ${bundle}/share/doc/poinsot/licences/${name})
    endif()
endforeach()
file(COPY /usr/share/common-licenses DESTINATION ${bundle}/share/doc/poinsot/licences)
list(LENGTH needed n_libraries)
list(LENGTH packages n_packages)

# Reproducible: files in fixed order, without owner and time.
execute_process(COMMAND tar --sort=name --mtime=@0 --owner=0 --group=0 --numeric-owner -cf ${bundle}.tar -C ${BUILD}/bundle ${NAME}
    COMMAND_ERROR_IS_FATAL ANY)
execute_process(COMMAND xz --force --x86 --lzma2=preset=8,dict=128MiB ${bundle}.tar COMMAND_ERROR_IS_FATAL ANY)
file(RENAME ${bundle}.tar.xz ${BUILD}/${NAME}.tar.xz)
file(SIZE ${BUILD}/${NAME}.tar.xz bytes)
math(EXPR megabytes "(${bytes} + 500000) / 1000000")
message(STATUS "${NAME}.tar.xz: ${megabytes} MB, ${n_libraries} libraries, the licences of ${n_packages} packages")
