#!/usr/bin/env python3
"""Builds docs/examples/library against the library, runs it, and compares its numbers with closed forms computed here.

Usage: example_check.py WAY CMAKE BUILD_FOLDER NM LAUNCHER
installed: against a copy that `cmake --install` makes and that is then moved, found by find_package. Also checks the symbols
           of the archives, that each header compiles alone, with warnings and for other processors, that all archives link
           with the libraries that the package names, and which versions and components are refused.
included:  with the repository as a part of the example's project, by add_subdirectory.
"""
import math
import os
import pathlib
import re
import subprocess
import sys
import tempfile

SOURCE = pathlib.Path(__file__).resolve().parents[2]
EXAMPLE = SOURCE / "docs/examples/library"
MOMENTS, OMEGA = (17.1e-3, 15.6e-3, 1.57e-3), (0.3, 6.2832, 0.2)


def run(*words, fails=False):
    done = subprocess.run([str(word) for word in words], capture_output=True, text=True,
                          env={**os.environ, "CCACHE_BASEDIR": str(SOURCE), "CCACHE_NOHASHDIR": "1"})
    if (done.returncode != 0) != fails:
        sys.exit(f"{' '.join(map(str, words))} returned {done.returncode}:\n{done.stdout[-3000:]}{done.stderr[-3000:]}")
    return done.stdout + (done.stderr if fails else "")


SCENE = """#include <poinsot/error.h>
#include <poinsot/motion.h>
#include <poinsot/scene.h>

#include <filesystem>
#include <fstream>
#include <iostream>
#include <map>
#include <string>
#include <variant>
#include <vector>

using namespace poinsot::library;

int main(int, char** arguments) {
    const Scene scene = Scene::from_text("[body]\\nmoments_kg_m2 = [4, 3, 1.5]\\n[start]\\nomega_rad_s = [1, 1, 2]\\n")
                            .with(std::vector<std::string>{"film.size=64x36"});
    const Still still = scene.still();
    const std::vector<std::uint8_t> png = still.png();
    std::ofstream(std::filesystem::path(arguments[1]), std::ios::binary).write(reinterpret_cast<const char*>(png.data()), png.size());
    MotionOptions options;
    options.method = "rk4";
    options.last_time_s = 1.0;
    options.torque = Gravity{1.0};
    const Motion top({1, 2, 3}, {0.1, 2, 0}, options);
    std::variant<int, double, std::string> first = options.method;
    std::map<std::string, std::vector<double>> table{{"omega", {top.at(0.5).omega_body[0]}}};
    std::cout << still.width_px() << ' ' << still.height_px() << ' ' << std::get<std::string>(first) << ' ';
    try {
        Scene::from_text("", "bad.toml");
    } catch (const poinsot::InputError& error) {
        std::cout << std::string(error.what()).substr(0, 13) << ' ';
    }
    try {
        return std::get<int>(first);
    } catch (const std::bad_variant_access&) {
        std::cout << table.size() + 1 << '\\n';
    }
    stop_drawing();
}
"""


def numbers(text):
    found = {}
    for line in text.splitlines():
        name, *values = line.split()
        if name in ("period_s", "precession_rad_s", "flip_s", "contact", "plane_distance", "contact_height", "omega_from_L_deg"):
            found.setdefault(name, []).extend(float(value) for value in values)
    return found


def check_output(text):
    found = numbers(text)
    A, B, C = MOMENTS
    twice_T = sum(moment * omega ** 2 for moment, omega in zip(MOMENTS, OMEGA))
    L = math.sqrt(sum((moment * omega) ** 2 for moment, omega in zip(MOMENTS, OMEGA)))
    # Landau & Lifshitz, Mechanics (37.8), (37.12), for a polhode about e1; K by the arithmetic-geometric mean.
    rate = math.sqrt((L * L - twice_T * C) * (A - B) / (A * B * C))
    mean = 1.0, math.sqrt(1.0 - (B - C) * (twice_T * A - L * L) / ((A - B) * (L * L - twice_T * C)))
    for _ in range(10):
        mean = 0.5 * (mean[0] + mean[1]), math.sqrt(mean[0] * mean[1])
    period_s = 2.0 * math.pi / mean[0] / rate
    height = math.sqrt(twice_T) / L
    length = math.sqrt(sum(x * x for x in found["contact"]))
    expected = {"period_s": [period_s], "plane_distance": [height], "contact_height": [height],
                "flip_s": [found["flip_s"][0] + 0.5 * period_s * i for i in range(4)],
                "omega_from_L_deg": [math.degrees(math.acos(height / length))]}
    # The contact is on both quadrics.
    found["quadrics"] = [sum(moment ** n * x * x for moment, x in zip(MOMENTS, found["contact"])) for n in (1, 2)]
    expected["quadrics"] = [1.0, L * L / twice_T]
    for name, values in expected.items():
        # The period here has lost three digits to the difference of nearly equal moments.
        if len(values) != len(found[name]) or any(abs(x - y) > 1e-11 * max(map(abs, values)) for x, y in zip(values, found[name])):
            sys.exit(f"{name} is {found[name]}, expected {values}")
    if "axis of the largest moment" not in text or not re.search(r"^error moments_kg_m2: .*make I3 at most 2", text, re.M):
        sys.exit(f"the example prints\n{text}")


def check_program(nm, program):
    """The program's functions are those of glibc, and it exports nothing of the library."""
    if not re.search(r"\bU acos(@|$)", run(nm, program), re.M):
        sys.exit("the program's acos is not glibc's")
    exported = [line for line in run(nm, "--dynamic", "--defined-only", program).splitlines()
                if re.search(r"poinsot|Sleef| (sin|cos|exp|pow)$", line)]
    if exported:
        sys.exit("the program exports symbols of the library:\n" + "\n".join(exported[:20]))


def build(cmake, launcher, source, folder, *options):
    run(cmake, "-G", "Ninja", "-S", source, "-B", folder, f"-DCMAKE_CXX_COMPILER_LAUNCHER={launcher}", f"-DCMAKE_C_COMPILER_LAUNCHER={launcher}",
        *options)
    run(cmake, "--build", folder)


def project(folder, text):
    folder.mkdir()
    (folder / "CMakeLists.txt").write_text("cmake_minimum_required(VERSION 3.25)\n" + text)
    (folder / "main.cpp").write_text("int main() { return 0; }\n")
    return folder


def installed(cmake, build_folder, nm, launcher, place):
    run(cmake, "--install", build_folder, "--component", "library", "--prefix", place / "first")
    prefix = (place / "first").rename(place / "prefix")
    found = f"-DCMAKE_PREFIX_PATH={prefix}"
    archives = sorted(prefix.glob("lib*/**/libpoinsot_*.a"))
    if [archive.name for archive in archives] != [f"libpoinsot_{name}.a" for name in ("construction", "mechanics", "production")]:
        sys.exit(f"the archives are {archives}")
    foreign = [line for line in run(nm, "--extern-only", "--defined-only", "--format=posix", *archives).splitlines()
               if len(line.split()) > 1 and "poinsot" not in line.split()[0]]
    if foreign:
        sys.exit(f"the archives define {len(foreign)} symbols without poinsot in their names:\n" + "\n".join(foreign[:20]))

    build(cmake, launcher, EXAMPLE, place / "build", found, "-DCMAKE_BUILD_TYPE=Release")
    text = run(place / "build/racket")
    check_output(text)
    check_program(nm, place / "build/racket")

    # Programs may be compiled for one processor, and without optimisation: the library's digits and layouts stay the same.
    build(cmake, launcher, EXAMPLE, place / "native", found, "-DCMAKE_BUILD_TYPE=Debug", "-DCMAKE_CXX_FLAGS=-march=native")
    native = numbers(run(place / "native/racket"))
    for name in ("period_s", "precession_rad_s", "flip_s", "contact", "plane_distance"):
        if native[name] != numbers(text)[name]:
            sys.exit(f"compiled for this processor, {name} is {native[name]}, not {numbers(text)[name]}")
    flags = ["-std=c++20", "-Wall", "-Wextra", "-Wpedantic", "-Wshadow", "-Werror", "-fsyntax-only", "-I", prefix / "include", "-isystem",
             "/usr/include/eigen3", "-x", "c++", "/dev/null", "-include"]
    for header in sorted((prefix / "include/poinsot").glob("*.h")):
        for processor in ([], ["-march=skylake-avx512"]):
            run("c++", *processor, *flags, header)

    everything = project(place / "everything", """project(everything LANGUAGES CXX)
find_package(poinsot 0.1 REQUIRED)
add_executable(everything main.cpp)
target_link_libraries(everything PRIVATE -Wl,--whole-archive $<TARGET_FILE:poinsot::production> $<TARGET_FILE:poinsot::construction>
    $<TARGET_FILE:poinsot::mechanics> -Wl,--no-whole-archive poinsot::production)
""")
    build(cmake, launcher, everything, place / "everything/build", found)
    run(place / "everything/build/everything")
    # Programs that define the same templates of the standard library, as groups of sections of which the linker keeps one.
    scene = project(place / "scene", """project(scene LANGUAGES CXX)
find_package(poinsot 0.1 REQUIRED)
add_executable(scene main.cpp)
target_link_libraries(scene PRIVATE poinsot::production)
""")
    (scene / "main.cpp").write_text(SCENE)
    for level in ("-O0", "-O2"):
        build(cmake, launcher, scene, scene / level[1:], found, f"-DCMAKE_CXX_FLAGS={level}", "-DCMAKE_BUILD_TYPE=")
        said = run(scene / level[1:] / "scene", place / "still.png")
        if said.split() != ["64", "36", "rk4", "bad.toml:1:1:", "2"]:
            sys.exit(f"the program with {level} says {said}")
    for ask, said in (("1.0 REQUIRED", "version"), ("0.2 REQUIRED", "version"),
                      ("REQUIRED COMPONENTS mechanics cinema", "the component cinema")):
        asking = project(place / re.sub(r"\W", "_", ask), f"project(asking LANGUAGES CXX)\nfind_package(poinsot {ask})\n")
        if said not in run(cmake, "-S", asking, "-B", asking / "build", found, fails=True):
            sys.exit(f"find_package(poinsot {ask}) is refused without a word about {said}")


def included(cmake, build_folder, nm, launcher, place):
    folder = pathlib.Path(build_folder) / "example"
    build(cmake, launcher, EXAMPLE, folder, f"-DPOINSOT_SOURCE={SOURCE}", "-DCMAKE_UNITY_BUILD=ON", "-DCMAKE_BUILD_TYPE=Release")
    check_output(run(folder / "racket"))
    check_program(nm, folder / "racket")
    cache = (folder / "CMakeCache.txt").read_text()
    if re.search("^(BUILD_TESTING|CPACK_|POINSOT_PAGE)", cache, re.M) or (folder / "poinsot/library/libpoinsot_production.a").exists():
        sys.exit("the including project gets tests, packages or parts that it did not ask for")
    run(cmake, "--install", folder, "--prefix", place / "prefix")
    if (place / "prefix").exists():
        sys.exit("the including project installs files of poinsot")

    # All parts, by FetchContent; the project has targets of its own with the names of poinsot's.
    fetching = project(place / "fetching", f"""project(fetching LANGUAGES C CXX)
foreach(name docs page bundle gallery library)
    add_custom_target(${{name}})
endforeach()
include(FetchContent)
FetchContent_Declare(poinsot SOURCE_DIR {SOURCE})
FetchContent_MakeAvailable(poinsot)
add_executable(fetching main.cpp)
target_link_libraries(fetching PRIVATE poinsot::production)
if(CMAKE_BUILD_TYPE OR CMAKE_CXX_STANDARD OR CMAKE_POSITION_INDEPENDENT_CODE)
    message(FATAL_ERROR "poinsot changes settings")
endif()
""")
    run(cmake, "-G", "Ninja", "-S", fetching, "-B", fetching / "build")
    if "libpoinsot_production.a" not in run(cmake, "--build", fetching / "build", "--", "-t", "inputs", "fetching"):
        sys.exit("the program does not depend on the library")
    # What the project does not use, it does not build.
    project(place / "other", "").joinpath("CMakeLists.txt").write_text(
        f"cmake_minimum_required(VERSION 3.25)\nproject(other LANGUAGES C CXX)\nadd_subdirectory({SOURCE} poinsot)\n")
    run(cmake, "-G", "Ninja", "-S", place / "other", "-B", place / "other/build")
    if ".o" in run(cmake, "--build", place / "other/build", "--", "-t", "inputs", "all"):
        sys.exit("the default build makes parts of poinsot that the project does not use")


if __name__ == "__main__":
    way, *arguments = sys.argv[1:]
    with tempfile.TemporaryDirectory() as name:
        {"installed": installed, "included": included}[way](*arguments, pathlib.Path(name))
