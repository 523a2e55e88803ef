# One CMake target a folder: every .cpp of the folder, nothing to register by hand.

# poinsot_folder(NAME [PUBLIC targets…] [PRIVATE targets…]) makes poinsot_NAME from ./*.cpp.
function(poinsot_folder name)
    cmake_parse_arguments(arg "" "" "PUBLIC;PRIVATE" ${ARGN})
    file(GLOB sources CONFIGURE_DEPENDS ${CMAKE_CURRENT_SOURCE_DIR}/*.cpp)
    if(NOT sources)
        add_library(poinsot_${name} INTERFACE)
        target_link_libraries(poinsot_${name} INTERFACE poinsot_options ${arg_PUBLIC} ${arg_PRIVATE})
        return()
    endif()
    add_library(poinsot_${name} STATIC ${sources})
    target_link_libraries(poinsot_${name} PUBLIC poinsot_options ${arg_PUBLIC} PRIVATE ${arg_PRIVATE})
endfunction()

# poinsot_embed(OUTPUT HEADER h TYPE t FUNCTION f FILES files…) makes OUTPUT, which defines f() of h: a vector of t,
# each of a file's name and text.
function(poinsot_embed output)
    cmake_parse_arguments(arg "" "HEADER;TYPE;FUNCTION" "FILES" ${ARGN})
    set(script ${CMAKE_SOURCE_DIR}/src/cmake/embed_files.cmake)
    add_custom_command(OUTPUT ${output}
        COMMAND ${CMAKE_COMMAND} -DOUTPUT=${output} "-DFILES=${arg_FILES}" -DHEADER=${arg_HEADER}
                -DTYPE=${arg_TYPE} -DFUNCTION=${arg_FUNCTION} -P ${script}
        DEPENDS ${arg_FILES} ${script} VERBATIM)
endfunction()

# poinsot_tests(NAME targets…) makes test_NAME from ./*_test.cpp, each claim a CTest test.
function(poinsot_tests name)
    file(GLOB sources CONFIGURE_DEPENDS ${CMAKE_CURRENT_SOURCE_DIR}/*_test.cpp)
    if(NOT sources)
        return()
    endif()
    add_executable(test_${name} ${sources})
    target_link_libraries(test_${name} PRIVATE poinsot_options ${ARGN} GTest::gtest GTest::gtest_main)
    target_compile_definitions(test_${name} PRIVATE POINSOT_SOURCE_DIR="${CMAKE_SOURCE_DIR}"
        POINSOT_BINARY_DIR="${CMAKE_BINARY_DIR}" POINSOT_TESTS_DIR="${CMAKE_SOURCE_DIR}/tests")
    target_include_directories(test_${name} PRIVATE ${CMAKE_SOURCE_DIR}/tests)
    include(GoogleTest)
    gtest_discover_tests(test_${name} TEST_PREFIX "${name}." DISCOVERY_TIMEOUT 120
        PROPERTIES ENVIRONMENT "${POINSOT_TEST_ENVIRONMENT}")
endfunction()
