# --target bundle: poinsot-VERSION-x86_64.tar.xz, which runs from any folder with nothing installed: the program, its libraries down to
# but without glibc, Mesa's software renderer, fonts, scenes, documents and the licences of all of it.

# The program again, linked so that it takes the libraries beside it: by RPATH, which holds for what these load in turn.
add_executable(poinsot_bundled EXCLUDE_FROM_ALL main.cpp)
target_link_libraries(poinsot_bundled PRIVATE poinsot_cli)
target_link_options(poinsot_bundled PRIVATE -Wl,--disable-new-dtags)
set_target_properties(poinsot_bundled PROPERTIES BUILD_RPATH "$ORIGIN/../lib" OUTPUT_NAME poinsot
    RUNTIME_OUTPUT_DIRECTORY ${CMAKE_BINARY_DIR}/bundled)

# What is opened at run time: FFmpeg by the versions that it was compiled for, and OSMesa, which needs no other part of Mesa.
set(bundled_libraries libOSMesa.so.8)
foreach(library avutil avcodec avformat swscale)
    string(REGEX MATCH "^[0-9]+" major "${LIBAV_lib${library}_VERSION}")
    list(APPEND bundled_libraries lib${library}.so.${major})
endforeach()
add_custom_target(bundle
    COMMAND ${CMAKE_COMMAND} -DBUILD=${CMAKE_BINARY_DIR} -DNAME=poinsot-${PROJECT_VERSION}-${CMAKE_SYSTEM_PROCESSOR}
            -DPROGRAM=$<TARGET_FILE:poinsot_bundled> "-DOPENED=${bundled_libraries}"
            -P ${CMAKE_SOURCE_DIR}/src/cmake/make_bundle.cmake
    DEPENDS poinsot poinsot_bundled VERBATIM)
