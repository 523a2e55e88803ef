# Makes the archives of the library's components. Variables: FOLDER, where they and parts.cmake lie; COMPONENTS; the programs
# AR, NM and OBJCOPY of GNU's binutils.
#
# Every symbol that these archives define contains "poinsot" in its name; others get the prefix poinsot_. So the elementary
# functions of src/libm/ do not replace those of the program that links the library, and no template of Eigen or fmt compiled
# here replaces one that the program compiled with other flags, such as -march=native, or the reverse.
cmake_minimum_required(VERSION 3.25)
include(${FOLDER}/parts.cmake)

set(joined "")
foreach(component ${COMPONENTS})
    set(archive ${FOLDER}/joined_${component}.a)
    file(REMOVE ${archive})
    execute_process(COMMAND ${AR} qcSD ${archive} ${${component}} COMMAND_ERROR_IS_FATAL ANY)
    list(APPEND joined ${archive})
endforeach()

set(new_names ${FOLDER}/new_names)
# Those of type n are the signatures of COMDAT groups, which must change with their members: the linker drops all but one group
# of a name, whatever its members are called.
execute_process(COMMAND ${NM} --defined-only --format=posix ${joined}
    COMMAND awk "NF > 1 && $1 !~ /poinsot/ && ($2 ~ /^[A-Zuvw]/ || ($2 == \"n\" && $1 ~ /^_Z/)) {print $1, \"poinsot_\" $1}" COMMAND sort -u
    OUTPUT_FILE ${new_names} COMMAND_ERROR_IS_FATAL ANY)
file(STRINGS ${new_names} of_lto REGEX "^__gnu_lto" LIMIT_COUNT 1)
if(of_lto)
    message(FATAL_ERROR "The library cannot be made of objects for link-time optimisation; build it without -flto")
endif()
foreach(component ${COMPONENTS})
    set(archive ${FOLDER}/joined_${component}.a)
    execute_process(COMMAND ${OBJCOPY} --strip-debug --redefine-syms=${new_names} ${archive} COMMAND_ERROR_IS_FATAL ANY)
    execute_process(COMMAND ${AR} sD ${archive} COMMAND_ERROR_IS_FATAL ANY)
    file(RENAME ${archive} ${FOLDER}/libpoinsot_${component}.a)
endforeach()
