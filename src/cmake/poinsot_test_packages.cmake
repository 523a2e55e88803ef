# Libraries of the tests and benchmarks. Sets poinsot_missing_test_packages to the Debian packages
# of those that are not installed.

set(poinsot_missing_test_packages "")

# poinsot_test_library(FOUND PACKAGE): if the variable FOUND is false, PACKAGE is missing.
macro(poinsot_test_library found package)
    if(NOT ${found})
        list(APPEND poinsot_missing_test_packages ${package})
    endif()
endmacro()

find_package(GTest QUIET)
poinsot_test_library(GTest_FOUND libgtest-dev)
find_package(rapidcheck QUIET)
poinsot_test_library(rapidcheck_FOUND librapidcheck-dev)
find_package(benchmark QUIET)
poinsot_test_library(benchmark_FOUND libbenchmark-dev)
find_package(nlohmann_json QUIET)
poinsot_test_library(nlohmann_json_FOUND nlohmann-json3-dev)
foreach(library gmp mpfr)
    find_library(POINSOT_TEST_${library} ${library})
    poinsot_test_library(POINSOT_TEST_${library} lib${library}-dev)
endforeach()
# A dependency of libpng-dev, which the program needs.
find_package(ZLIB QUIET REQUIRED)
list(JOIN poinsot_missing_test_packages ", " poinsot_missing_test_packages)
