# What the page's module is built with: libraries that consist of headers, and stand-ins for those
# that only the native program links.

# Headers of the system's libraries, without those of its C library beside them.
set(page_headers ${PROJECT_BINARY_DIR}/headers)
file(MAKE_DIRECTORY ${page_headers})
foreach(library eigen3/Eigen boost fmt toml++ glm)
    get_filename_component(name ${library} NAME)
    if(NOT EXISTS /usr/include/${library})
        message(FATAL_ERROR "The page's module needs /usr/include/${library}: sh .ci/setup film installs it.")
    endif()
    file(CREATE_LINK /usr/include/${library} ${page_headers}/${name} SYMBOLIC)
endforeach()
file(GLOB harfbuzz /usr/include/harfbuzz/*.h)
foreach(header ${harfbuzz})
    get_filename_component(name ${header} NAME)
    file(CREATE_LINK ${header} ${page_headers}/${name} SYMBOLIC)
endforeach()

# Paths are names here: Debian's libc++ for wasm leaves std::filesystem out, whose paths need no file.
file(READ /usr/include/wasm32-wasi/c++/v1/__config_site config_site)
string(REPLACE "#define _LIBCPP_HAS_NO_FILESYSTEM" "" config_site "${config_site}")
file(WRITE ${PROJECT_BINARY_DIR}/libc++/__config_site.new "${config_site}")
file(COPY_FILE ${PROJECT_BINARY_DIR}/libc++/__config_site.new ${PROJECT_BINARY_DIR}/libc++/__config_site ONLY_IF_DIFFERENT)

# A header of Boost asks for threads.
file(COPY ${PROJECT_SOURCE_DIR}/src/doors/web/host/single_thread/boost DESTINATION ${PROJECT_BINARY_DIR}/libc++)

target_include_directories(poinsot_options SYSTEM BEFORE INTERFACE ${PROJECT_BINARY_DIR}/libc++ ${page_headers})
# Small: one thread, which never ends, and no names of types.
target_compile_options(poinsot_options INTERFACE -Oz -fwasm-exceptions -fvisibility=hidden -ffunction-sections -fdata-sections
    -mbulk-memory -mnontrapping-fptoint -msign-ext -fno-threadsafe-statics -fmerge-all-constants
    $<$<COMPILE_LANGUAGE:CXX>:-fno-rtti> $<$<COMPILE_LANGUAGE:CXX>:-fno-c++-static-destructors>)
target_compile_definitions(poinsot_options INTERFACE FMT_HEADER_ONLY BOOST_DISABLE_THREADS
    # fmt without the locales of the C++ library.
    FMT_STATIC_THOUSANDS_SEPARATOR=','
    # Boost 1.74 derives from std::unary_function.
    _LIBCPP_ENABLE_CXX17_REMOVED_UNARY_BINARY_FUNCTION)

set(TOMLPLUSPLUS_INCLUDE ${page_headers})
foreach(library Eigen3::Eigen Boost::headers fmt::fmt fmt::fmt-header-only tomlplusplus::tomlplusplus CLI11::CLI11 glm::glm PNG::PNG
        Threads::Threads PkgConfig::DEFLATE PkgConfig::MD PkgConfig::XXHASH PkgConfig::FREETYPE PkgConfig::HARFBUZZ PkgConfig::HARFBUZZ_SUBSET
        PkgConfig::CAIRO PkgConfig::SLEEF)
    add_library(${library} INTERFACE IMPORTED)
endforeach()
set_target_properties(tomlplusplus::tomlplusplus PROPERTIES INTERFACE_INCLUDE_DIRECTORIES "")
