# --target bundle: poinsot-VERSION-x86_64.tar.xz, which runs from any folder without installation:
# the program, its libraries except glibc, Mesa's software renderer, fonts, scenes, documents and
# all licences.

# The program, linked so that it uses the bundled libraries: by RPATH, which also applies to the
# libraries that these load.
add_executable(poinsot_bundled EXCLUDE_FROM_ALL doors/main.cpp)
target_link_libraries(poinsot_bundled PRIVATE poinsot_cli)
target_link_options(poinsot_bundled PRIVATE -Wl,--disable-new-dtags)
set_target_properties(poinsot_bundled PROPERTIES BUILD_RPATH "$ORIGIN/../lib" OUTPUT_NAME poinsot
    RUNTIME_OUTPUT_DIRECTORY ${PROJECT_BINARY_DIR}/bundled)

# The libraries opened at run time: FFmpeg in the versions of the build, and OSMesa, which needs no
# other part of Mesa.
set(bundled_libraries libOSMesa.so.8)
foreach(library avutil avcodec avformat swscale)
    string(REGEX MATCH "^[0-9]+" major "${LIBAV_lib${library}_VERSION}")
    list(APPEND bundled_libraries lib${library}.so.${major})
endforeach()
add_custom_target(bundle
    COMMAND ${CMAKE_COMMAND} -DBUILD=${PROJECT_BINARY_DIR} -DNAME=poinsot-${PROJECT_VERSION}-${CMAKE_SYSTEM_PROCESSOR}
            -DPROGRAM=$<TARGET_FILE:poinsot_bundled> "-DOPENED=${bundled_libraries}"
            -P ${PROJECT_SOURCE_DIR}/src/cmake/make_bundle.cmake
    DEPENDS poinsot poinsot_bundled VERBATIM)

# --target wheel: the Python package with the same libraries; it needs glibc, libstdc++, Python and NumPy.
if(TARGET poinsot_python)
    add_custom_target(wheel
        COMMAND ${Python_EXECUTABLE} ${PROJECT_SOURCE_DIR}/src/doors/python/poinsot_build.py wheel ${PROJECT_BINARY_DIR} ${PROJECT_BINARY_DIR}
                ${bundled_libraries}
        DEPENDS poinsot_python VERBATIM)
endif()
