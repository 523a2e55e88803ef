# Libraries required by the build: if one is missing or too old, CMake stops with its name, its
# minimum version and its Debian package. All missing libraries are named at once.

set(poinsot_wanting "")

# poinsot_needs(NAME VERSION PACKAGE [further arguments of find_package]) finds a library by its own
# CMake files. The version is compared here, not by find_package: files that treat every later major
# version as incompatible, such as Eigen 5's, would refuse it.
macro(poinsot_needs name version package)
    find_package(${name} QUIET ${ARGN})
    if(NOT ${name}_FOUND)
        list(APPEND poinsot_wanting "  ${name} ${version} or newer is missing: install ${package}")
    elseif(${name}_VERSION AND ${name}_VERSION VERSION_LESS ${version})
        list(APPEND poinsot_wanting "  ${name} is ${${name}_VERSION}: ${version} or newer is needed, of ${package}")
    endif()
endmacro()

# poinsot_needs_modules(PREFIX PACKAGE MODULE>=VERSION…) finds libraries by pkg-config, as PkgConfig::PREFIX.
macro(poinsot_needs_modules prefix package)
    if(PROJECT_IS_TOP_LEVEL)
        pkg_check_modules(${prefix} QUIET IMPORTED_TARGET ${ARGN})
    else()
        pkg_check_modules(${prefix} QUIET IMPORTED_TARGET GLOBAL ${ARGN})
    endif()
    if(NOT ${prefix}_FOUND)
        string(REPLACE ";" ", " modules "${ARGN}")
        list(APPEND poinsot_wanting "  ${modules}: missing or too old: install ${package}")
    endif()
endmacro()

# Stops if a library is missing.
function(poinsot_needs_met)
    if(poinsot_wanting)
        string(REPLACE ";" "\n" lines "${poinsot_wanting}")
        message(FATAL_ERROR "Libraries are wanting:\n${lines}\n.ci/packages lists all packages; sh .ci/setup film installs them.")
    endif()
endfunction()
