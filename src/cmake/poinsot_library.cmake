# --target library: libpoinsot.so, the library for programs in C++, and the target poinsot::poinsot for projects that include this one.
# In an installed copy, src/cmake/poinsotConfig.cmake.in declares the same target.
set(top_part construction)
set(facades mechanics construction)
if(POINSOT_PARTS STREQUAL "all")
    set(top_part production)
    list(APPEND facades production)
endif()
set(library_folder ${PROJECT_BINARY_DIR}/library)
configure_file(${PROJECT_SOURCE_DIR}/src/doors/library/exported.map.in ${library_folder}/exported.map @ONLY)

# All objects of the facades; of the layers below, those that they use.
list(TRANSFORM facades REPLACE "(.+)" "$<TARGET_OBJECTS:poinsot_library_\\1>")
add_library(poinsot_shared SHARED ${facades})
add_library(poinsot::poinsot ALIAS poinsot_shared)
target_link_libraries(poinsot_shared PRIVATE poinsot_library_${top_part} INTERFACE Eigen3::Eigen)
target_include_directories(poinsot_shared INTERFACE ${POINSOT_PUBLIC_FOLDERS})
target_compile_features(poinsot_shared INTERFACE cxx_std_20)
set_target_properties(poinsot_shared PROPERTIES OUTPUT_NAME poinsot LINKER_LANGUAGE CXX LIBRARY_OUTPUT_DIRECTORY ${library_folder}
    VERSION ${PROJECT_VERSION} SOVERSION ${PROJECT_VERSION_MAJOR} LINK_DEPENDS ${library_folder}/exported.map)
# nodelete: the thread that draws may outlive a dlclose.
target_link_options(poinsot_shared PRIVATE LINKER:--version-script=${library_folder}/exported.map LINKER:--as-needed LINKER:-z,nodelete)
if(POINSOT_SANITIZE)
    # Programs would have to be linked with the sanitizer, too.
    set_target_properties(poinsot_shared PROPERTIES EXCLUDE_FROM_ALL ON)
else()
    target_link_options(poinsot_shared PRIVATE LINKER:-z,defs)
endif()
if(NOT PROJECT_IS_TOP_LEVEL)
    return()
endif()

add_custom_target(library DEPENDS poinsot_shared)
# Where Debian's linker, pkg-config and CMake look, below any prefix.
if(EXISTS /etc/debian_version AND NOT DEFINED CMAKE_INSTALL_LIBDIR)
    set(CMAKE_INSTALL_LIBDIR lib/${CMAKE_LIBRARY_ARCHITECTURE} CACHE PATH "Folder of libraries, below the prefix")
endif()
include(GNUInstallDirs)
include(CMakePackageConfigHelpers)
# The components library, which programs need to run, and development, to build them: one Debian package of each. Both are left out if
# the library was not built.
foreach(component library development)
    install(CODE "if(NOT EXISTS \"$<TARGET_FILE:poinsot_shared>\")
    message(STATUS \"The C++ library is not installed: build the target library first\")
    return()
endif()" COMPONENT ${component})
endforeach()
install(TARGETS poinsot_shared LIBRARY DESTINATION ${CMAKE_INSTALL_LIBDIR} COMPONENT library NAMELINK_COMPONENT development)
set(CMAKE_INSTALL_DEFAULT_COMPONENT_NAME development)
file(GLOB headers CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/src/*/*/poinsot/*.h)
if(NOT POINSOT_PARTS STREQUAL "all")
    list(FILTER headers INCLUDE REGEX "/(error|torque|motion|construction)\\.h$")
endif()
install(FILES ${headers} DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/poinsot)
set(config_folder ${CMAKE_INSTALL_LIBDIR}/cmake/poinsot)
configure_package_config_file(${PROJECT_SOURCE_DIR}/src/cmake/poinsotConfig.cmake.in ${library_folder}/poinsotConfig.cmake
    INSTALL_DESTINATION ${config_folder} PATH_VARS CMAKE_INSTALL_INCLUDEDIR CMAKE_INSTALL_LIBDIR)
# Before 1.0, each minor version may change the library.
write_basic_package_version_file(${library_folder}/poinsotConfigVersion.cmake COMPATIBILITY SameMinorVersion)
install(FILES ${library_folder}/poinsotConfig.cmake ${library_folder}/poinsotConfigVersion.cmake DESTINATION ${config_folder})
file(RELATIVE_PATH prefix_from_pkgconfig /${CMAKE_INSTALL_LIBDIR}/pkgconfig /)
string(REGEX REPLACE "/$" "" prefix_from_pkgconfig ${prefix_from_pkgconfig})
configure_file(${PROJECT_SOURCE_DIR}/src/cmake/poinsot.pc.in ${library_folder}/poinsot.pc @ONLY)
install(FILES ${library_folder}/poinsot.pc DESTINATION ${CMAKE_INSTALL_LIBDIR}/pkgconfig)
# Required by Debian of each package; src/cmake/poinsot_install.cmake and src/doors/python/CMakeLists.txt install the changelog, too.
file(WRITE ${PROJECT_BINARY_DIR}/changelog "poinsot (${PROJECT_VERSION}) unstable; urgency=medium\n\n  * See CHANGELOG.md.\n\n"
    " -- the poinsot authors <poinsot@example.org>  Sun, 22 Nov 2026 00:00:00 +0000\n")
execute_process(COMMAND gzip -9nc ${PROJECT_BINARY_DIR}/changelog OUTPUT_FILE ${PROJECT_BINARY_DIR}/changelog.gz COMMAND_ERROR_IS_FATAL ANY)
foreach(package library=libpoinsot${PROJECT_VERSION_MAJOR} development=libpoinsot-dev)
    string(REPLACE "=" ";" package ${package})
    list(GET package 0 component)
    list(GET package 1 name)
    install(FILES ${PROJECT_BINARY_DIR}/changelog.gz DESTINATION ${CMAKE_INSTALL_DATAROOTDIR}/doc/${name} COMPONENT ${component})
    install(FILES ${PROJECT_SOURCE_DIR}/LICENSE DESTINATION ${CMAKE_INSTALL_DATAROOTDIR}/doc/${name} COMPONENT ${component} RENAME copyright)
endforeach()
