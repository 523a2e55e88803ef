# --target library: an archive for each component of the library, as programs link it, and the imported targets
# poinsot::mechanics, poinsot::construction and poinsot::production. In an installed copy, src/cmake/poinsotConfig.cmake.in
# declares the same targets.
set(components mechanics construction)
if(POINSOT_PARTS STREQUAL "all")
    list(APPEND components production)
endif()

# The static libraries of this project that a target links, itself included; appended to the variable `found`.
function(poinsot_archives_of target found)
    get_target_property(type ${target} TYPE)
    if(type STREQUAL "STATIC_LIBRARY")
        list(APPEND ${found} ${target})
    endif()
    get_target_property(linked ${target} INTERFACE_LINK_LIBRARIES)
    foreach(other ${linked})
        string(REGEX REPLACE "^\\$<LINK_ONLY:(.*)>$" "\\1" other "${other}")
        if(other MATCHES "^poinsot_" AND NOT other IN_LIST ${found})
            poinsot_archives_of(${other} ${found})
        endif()
    endforeach()
    set(${found} ${${found}} PARENT_SCOPE)
endfunction()

# Each archive leaves out the objects of the archives before it.
set(archive_folder ${PROJECT_BINARY_DIR}/library)
set(earlier "")
set(archives "")
set(parts "")
foreach(component ${components})
    set(targets ${earlier})
    poinsot_archives_of(poinsot_library_${component} targets)
    set(own ${targets})
    if(earlier)
        list(REMOVE_ITEM own ${earlier})
    endif()
    set(earlier ${targets})
    list(TRANSFORM own REPLACE "(.+)" "$<TARGET_OBJECTS:\\1>")
    string(APPEND parts "set(${component} \"${own}\")\n")
    list(APPEND archives ${archive_folder}/libpoinsot_${component}.a)
endforeach()
file(GENERATE OUTPUT ${archive_folder}/parts.cmake CONTENT "${parts}")
set(script ${PROJECT_SOURCE_DIR}/src/cmake/make_library.cmake)
add_custom_command(OUTPUT ${archives}
    COMMAND ${CMAKE_COMMAND} -DFOLDER=${archive_folder} "-DCOMPONENTS=${components}" -DAR=${CMAKE_AR} -DNM=${CMAKE_NM}
            -DOBJCOPY=${CMAKE_OBJCOPY} -P ${script}
    DEPENDS ${earlier} ${archive_folder}/parts.cmake ${script} COMMENT "Making the archives of the library" VERBATIM)
# Part of the default build, because `cmake --install` installs the archives. Sanitizers would have to be linked, too.
set(in_all "")
if(PROJECT_IS_TOP_LEVEL AND NOT POINSOT_SANITIZE)
    set(in_all ALL)
endif()
add_custom_target(poinsot_archives ${in_all} DEPENDS ${archives})

# For projects that include this one by add_subdirectory or FetchContent.
foreach(component ${components})
    add_library(poinsot::${component} STATIC IMPORTED GLOBAL)
    set_target_properties(poinsot::${component} PROPERTIES IMPORTED_LOCATION ${archive_folder}/libpoinsot_${component}.a)
    add_dependencies(poinsot::${component} poinsot_archives)
endforeach()
target_include_directories(poinsot::mechanics INTERFACE ${POINSOT_PUBLIC_FOLDERS})
target_compile_features(poinsot::mechanics INTERFACE cxx_std_20)
target_link_libraries(poinsot::mechanics INTERFACE Eigen3::Eigen PkgConfig::SLEEF)
target_link_libraries(poinsot::construction INTERFACE poinsot::mechanics)
if(POINSOT_PARTS STREQUAL "all")
    target_link_libraries(poinsot::production INTERFACE poinsot::construction PNG::PNG fmt::fmt Threads::Threads PkgConfig::DEFLATE
        PkgConfig::MD PkgConfig::XXHASH PkgConfig::FREETYPE PkgConfig::HARFBUZZ PkgConfig::HARFBUZZ_SUBSET PkgConfig::CAIRO
        ${CMAKE_DL_LIBS})
endif()
if(NOT PROJECT_IS_TOP_LEVEL)
    return()
endif()

add_custom_target(library DEPENDS ${archives})
include(GNUInstallDirs)
include(CMakePackageConfigHelpers)
set(CMAKE_INSTALL_DEFAULT_COMPONENT_NAME library)
# Skips the installation if this target was not built.
install(CODE "if(NOT EXISTS \"${archive_folder}/libpoinsot_mechanics.a\")
    message(STATUS \"The C++ library is not installed: build the target library first\")
    return()
endif()")
install(FILES ${archives} DESTINATION ${CMAKE_INSTALL_LIBDIR})
file(GLOB headers CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/src/*/poinsot/*.h)
if(NOT POINSOT_PARTS STREQUAL "all")
    list(FILTER headers INCLUDE REGEX "/(error|motion|construction)\\.h$")
endif()
install(FILES ${headers} DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/poinsot)
set(config_folder ${CMAKE_INSTALL_LIBDIR}/cmake/poinsot)
configure_package_config_file(${PROJECT_SOURCE_DIR}/src/cmake/poinsotConfig.cmake.in ${archive_folder}/poinsotConfig.cmake
    INSTALL_DESTINATION ${config_folder} PATH_VARS CMAKE_INSTALL_INCLUDEDIR CMAKE_INSTALL_LIBDIR)
# Before 1.0, each minor version may change the library.
write_basic_package_version_file(${archive_folder}/poinsotConfigVersion.cmake COMPATIBILITY SameMinorVersion)
install(FILES ${archive_folder}/poinsotConfig.cmake ${archive_folder}/poinsotConfigVersion.cmake DESTINATION ${config_folder})
# Required by Debian of each package; src/cmake/poinsot_install.cmake and src/python/CMakeLists.txt install the changelog, too.
file(WRITE ${PROJECT_BINARY_DIR}/changelog "poinsot (${PROJECT_VERSION}) unstable; urgency=medium\n\n  * See CHANGELOG.md.\n\n"
    " -- the poinsot authors <poinsot@example.org>  Sun, 22 Nov 2026 00:00:00 +0000\n")
execute_process(COMMAND gzip -9nc ${PROJECT_BINARY_DIR}/changelog OUTPUT_FILE ${PROJECT_BINARY_DIR}/changelog.gz COMMAND_ERROR_IS_FATAL ANY)
install(FILES ${PROJECT_BINARY_DIR}/changelog.gz DESTINATION ${CMAKE_INSTALL_DATAROOTDIR}/doc/libpoinsot-dev)
install(FILES ${PROJECT_SOURCE_DIR}/LICENSE DESTINATION ${CMAKE_INSTALL_DATAROOTDIR}/doc/libpoinsot-dev RENAME copyright)
