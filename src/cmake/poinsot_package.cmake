# --target package: .debs for the distribution that they are built on: poinsot, the program; libpoinsot0 and libpoinsot-dev, the
# library for C++; and python3-poinsot, where the Python package is built.

# The package of a library that is opened at run time, if dpkg knows it.
function(package_of_library name to)
    execute_process(COMMAND dpkg-query -S "*/${name}" OUTPUT_VARIABLE found ERROR_QUIET OUTPUT_STRIP_TRAILING_WHITESPACE)
    string(REGEX MATCH "^[^:,\n]+" package "${found}")
    if(package)
        list(APPEND ${to} ${package})
        set(${to} ${${to}} PARENT_SCOPE)
    endif()
endfunction()

# FFmpeg in the versions of the build; OSMesa if available, and always EGL with Mesa's software
# renderer.
set(opened "")
foreach(library avutil avcodec avformat swscale)
    string(REGEX MATCH "^[0-9]+" major "${LIBAV_lib${library}_VERSION}")
    package_of_library(lib${library}.so.${major} opened)
endforeach()
package_of_library(libOSMesa.so.8 opened)
package_of_library(libEGL.so.1 opened)
list(APPEND opened libegl-mesa0 libgl1-mesa-dri fonts-lmodern)
list(JOIN opened ", " opened)

set(CPACK_GENERATOR DEB)
set(CPACK_DEB_COMPONENT_INSTALL ON)
set(CPACK_COMPONENTS_GROUPING IGNORE)
set(CPACK_COMPONENTS_ALL program library development)
set(CPACK_PACKAGE_NAME poinsot)
set(CPACK_PACKAGE_VERSION ${PROJECT_VERSION})
set(CPACK_PACKAGE_CONTACT "the poinsot authors <poinsot@example.org>")
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "exact motion of a turning rigid body and its construction by Poinsot")
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_STRIP_FILES ON)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_PRIORITY optional)
set(CPACK_DEBIAN_PROGRAM_PACKAGE_NAME poinsot)
set(CPACK_DEBIAN_PROGRAM_PACKAGE_SECTION science)
set(CPACK_DEBIAN_PROGRAM_DESCRIPTION
    "This program takes a scene file, computes the motion of a rigid body exactly at\nany instant, draws Poinsot's construction without a screen and writes stills,\nimage sequences, films, slides and pages.")
set(CPACK_DEBIAN_PROGRAM_PACKAGE_SHLIBDEPS ON)
set(CPACK_DEBIAN_PROGRAM_PACKAGE_DEPENDS "${opened}")
# Motions need nothing that is opened at run time; pictures and films do.
set(runtime_package libpoinsot${PROJECT_VERSION_MAJOR})
set(CPACK_DEBIAN_LIBRARY_PACKAGE_NAME ${runtime_package})
set(CPACK_DEBIAN_LIBRARY_PACKAGE_SECTION libs)
set(CPACK_DEBIAN_LIBRARY_DESCRIPTION
    "This package contains the shared library, for programs in C++ that compute\nmotions or draw Poinsot's construction.")
set(CPACK_DEBIAN_LIBRARY_PACKAGE_SHLIBDEPS ON)
set(CPACK_DEBIAN_PACKAGE_GENERATE_SHLIBS ON)
set(CPACK_DEBIAN_PACKAGE_GENERATE_SHLIBS_POLICY ">=")
# CPack writes scripts that call ldconfig; Debian asks for the trigger.
file(WRITE ${PROJECT_BINARY_DIR}/control/triggers "activate-noawait ldconfig\n")
set(CPACK_DEBIAN_LIBRARY_PACKAGE_CONTROL_EXTRA ${PROJECT_BINARY_DIR}/control/triggers)
set(CPACK_DEBIAN_LIBRARY_PACKAGE_RECOMMENDS "${opened}")
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_NAME libpoinsot-dev)
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_SECTION libdevel)
set(CPACK_DEBIAN_DEVELOPMENT_DESCRIPTION
    "This package contains headers, and files for CMake and pkg-config, with which\nprograms in C++ are built.")
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_DEPENDS "${runtime_package} (= ${PROJECT_VERSION}), libeigen3-dev")
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_SUGGESTS "poinsot, cmake, pkg-config")
if(TARGET poinsot_python)
    list(APPEND CPACK_COMPONENTS_ALL python)
    set(CPACK_DEBIAN_PYTHON_PACKAGE_NAME python3-poinsot)
    set(CPACK_DEBIAN_PYTHON_PACKAGE_SECTION python)
    set(CPACK_DEBIAN_PYTHON_DESCRIPTION "This package contains the Python package poinsot, for notebooks, scripts and\npytest.")
    set(CPACK_DEBIAN_PYTHON_PACKAGE_SHLIBDEPS ON)
    execute_process(COMMAND ${Python_EXECUTABLE} -c "import sys; a, b = sys.version_info[:2]; print(f'python3 (>= {a}.{b}~), python3 (<< {a}.{b + 1})')"
        OUTPUT_VARIABLE its_python OUTPUT_STRIP_TRAILING_WHITESPACE COMMAND_ERROR_IS_FATAL ANY)
    set(CPACK_DEBIAN_PYTHON_PACKAGE_DEPENDS "${its_python}, python3-numpy, ${opened}")
    set(CPACK_DEBIAN_PYTHON_PACKAGE_SUGGESTS "python3-matplotlib, python3-pandas, python3-tqdm, python3-pytest")
endif()
set(CPACK_INSTALL_DEFAULT_DIRECTORY_PERMISSIONS
    OWNER_READ OWNER_WRITE OWNER_EXECUTE GROUP_READ GROUP_EXECUTE WORLD_READ WORLD_EXECUTE)
include(CPack)
