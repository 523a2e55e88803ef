# One CMake target per folder: every .cpp of the folder and its subfolders, without a list of files. A
# subfolder that has a CMakeLists.txt is a target of its own.

# poinsot_folder(NAME [FUZZED] [COLD] [PUBLIC targets…] [PRIVATE targets…] [NATIVE files…]) makes poinsot_NAME from
# ./**.cpp. NATIVE: regular expressions of the files that a page in a browser does without: it has neither threads, nor
# files, nor the libraries that they use. FUZZED: it reads untrusted input and is instrumented for coverage in fuzzing builds. The
# instrumentation slows rendering by a factor of three, so other folders do without. COLD: no loop of it runs for each pixel or each step of
# a motion; -O1 compiles in two thirds of the time (docs/speed.md).
function(poinsot_folder name)
    cmake_parse_arguments(arg "FUZZED;COLD" "" "PUBLIC;PRIVATE;NATIVE" ${ARGN})
    file(GLOB_RECURSE sources CONFIGURE_DEPENDS ${CMAKE_CURRENT_SOURCE_DIR}/*.cpp)
    file(GLOB libraries ${CMAKE_CURRENT_SOURCE_DIR}/*/CMakeLists.txt)
    foreach(library ${libraries})
        cmake_path(GET library PARENT_PATH library)
        list(FILTER sources EXCLUDE REGEX "^${library}/")
        if(NOT POINSOT_IS_PAGE OR NOT library MATCHES "/files$")
            add_subdirectory(${library})
        endif()
    endforeach()
    if(POINSOT_IS_PAGE)
        foreach(file ${arg_NATIVE})
            list(FILTER sources EXCLUDE REGEX "^${CMAKE_CURRENT_SOURCE_DIR}/${file}$")
        endforeach()
    endif()
    if(NOT sources)
        add_library(poinsot_${name} INTERFACE)
        target_link_libraries(poinsot_${name} INTERFACE poinsot_options ${arg_PUBLIC} ${arg_PRIVATE})
        return()
    endif()
    add_library(poinsot_${name} STATIC ${sources})
    target_link_libraries(poinsot_${name} PUBLIC poinsot_options ${arg_PUBLIC} PRIVATE ${arg_PRIVATE})
    if(POINSOT_FUZZERS AND arg_FUZZED)
        target_compile_options(poinsot_${name} PRIVATE -fsanitize=fuzzer-no-link)
    endif()
    if(arg_COLD)
        target_compile_options(poinsot_${name} PRIVATE $<$<CONFIG:Release>:-O1>)
    endif()
endfunction()

# poinsot_embed(OUTPUT HEADER h TYPE t FUNCTION f FILES files…) makes OUTPUT, which defines f() of h: a vector of t,
# each of a file's name and text. A page's module carries shaders without their comments, a third of their length.
function(poinsot_embed output)
    cmake_parse_arguments(arg "" "HEADER;TYPE;FUNCTION" "FILES" ${ARGN})
    set(script ${PROJECT_SOURCE_DIR}/src/cmake/embed_files.cmake)
    add_custom_command(OUTPUT ${output}
        COMMAND ${CMAKE_COMMAND} -DOUTPUT=${output} "-DFILES=${arg_FILES}" -DHEADER=${arg_HEADER}
                -DTYPE=${arg_TYPE} -DFUNCTION=${arg_FUNCTION} -DWITHOUT_COMMENTS=${POINSOT_IS_PAGE} -P ${script}
        DEPENDS ${arg_FILES} ${script} VERBATIM)
endfunction()

# poinsot_tests(NAME [COLD] targets…) makes test_NAME from ./*_test.cpp; each TEST is a CTest test. COLD as above.
function(poinsot_tests name)
    cmake_parse_arguments(arg "COLD" "" "" ${ARGN})
    file(GLOB sources CONFIGURE_DEPENDS ${CMAKE_CURRENT_SOURCE_DIR}/*_test.cpp)
    if(NOT sources)
        return()
    endif()
    add_executable(test_${name} ${sources} ${PROJECT_SOURCE_DIR}/tests/places.cpp ${PROJECT_SOURCE_DIR}/tests/left_behind.cpp)
    target_link_libraries(test_${name} PRIVATE poinsot_options ${arg_UNPARSED_ARGUMENTS} GTest::gtest GTest::gtest_main)
    if(arg_COLD)
        target_compile_options(test_${name} PRIVATE $<$<CONFIG:Release>:-O1>)
    endif()
    # Only this file contains the repository's path, so that a compiler cache serves every checkout.
    set_source_files_properties(${PROJECT_SOURCE_DIR}/tests/places.cpp PROPERTIES
        COMPILE_DEFINITIONS "POINSOT_SOURCE_DIR=\"${PROJECT_SOURCE_DIR}\"")
    target_include_directories(test_${name} PRIVATE ${POINSOT_TEST_HEADERS})
    if(POINSOT_SANITIZE)
        # One process per test would spend more time on starting than most tests take: each process
        # runs every eighth test.
        foreach(part RANGE 7)
            add_test(NAME ${name}.part_${part} COMMAND test_${name})
            set_tests_properties(${name}.part_${part} PROPERTIES TIMEOUT 1800
                ENVIRONMENT "${POINSOT_TEST_ENVIRONMENT};GTEST_TOTAL_SHARDS=8;GTEST_SHARD_INDEX=${part}")
        endforeach()
        return()
    endif()
    include(GoogleTest)
    # Other tests start those whose names begin with DISABLED.
    gtest_discover_tests(test_${name} NO_PRETTY_VALUES TEST_PREFIX "${name}." TEST_FILTER "-*DISABLED_*" DISCOVERY_TIMEOUT 120
        PROPERTIES ENVIRONMENT "${POINSOT_TEST_ENVIRONMENT}")
endfunction()
