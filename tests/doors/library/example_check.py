#!/usr/bin/env python3
"""Builds docs/examples/library against the library, runs it, and compares its numbers with closed forms computed here.

Usage: example_check.py WAY CMAKE BUILD_FOLDER NM LAUNCHER
installed: against a copy that `cmake --install` makes and that is then moved, found by find_package and by pkg-config. Also checks
           that the library exports what the headers declare and nothing else, that each header compiles alone, with warnings and for
           other processors, that programs with names of their own do not disturb the library, that they catch its exceptions, and
           which versions and components are refused.
included:  with the repository as a part of the example's project, by add_subdirectory.
"""
import math
import os
import pathlib
import re
import subprocess
import sys
import tempfile

SOURCE = pathlib.Path(__file__).resolve().parents[3]
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
#include <typeinfo>
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
    } catch (const poinsot::Error& error) {
        std::cout << std::string(error.what()).substr(0, 13) << ' ';
    }
    try {
        Motion({0, 0, 0}, {0, 0, 0});
    } catch (const poinsot::InputError& error) {
        // The library's type is the program's own, at one address: other runtimes than libstdc++ compare nothing else.
        std::cout << (typeid(error).name() == typeid(poinsot::InputError).name() ? "same " : "another ");
    }
    try {
        return std::get<int>(first);
    } catch (const std::bad_variant_access&) {
        std::cout << table.size() + 1 << '\\n';
    }
    stop_drawing();
}
"""


# Names that the library uses inside, for other things. It must not notice.
NEIGHBOUR = """#include <Eigen/Geometry>
#include <poinsot/construction.h>
#include <poinsot/motion.h>

#include <iostream>
#include <string>

namespace poinsot {
class Motion {
 public:
    double mine[100] = {};
};
class Polhode {
 public:
    ~Polhode() { std::cout << "wrong "; }
};
std::string regime_sentence(const Motion&) { return "wrong"; }
double read_double(std::string_view) { return 1e300; }
}  // namespace poinsot
extern "C" double acos(double) noexcept { return 42.0; }
extern "C" double exp(double) noexcept { return 43.0; }
extern "C" double log(double) noexcept { return 44.0; }
extern "C" double pow(double, double) noexcept { return 45.0; }
extern "C" double sin(double) noexcept { return 46.0; }
extern "C" double cos(double) noexcept { return 47.0; }

int main() {
    const poinsot::library::Motion body({3, 2, 1}, {0.1, 0.2, 2});
    const poinsot::library::Construction construction(body);
    volatile double one = 1.0;
    std::cout.precision(17);
    std::cout << std::acos(one) << ' ' << poinsot::regime_sentence(poinsot::Motion()) << ' ' << construction.polhode(1e-2).points.size();
    for (const double number : body.at(7).omega_body) std::cout << ' ' << number;
    std::cout << ' ' << body.at(7).space_from_body.w() << '\\n';
}
"""

# A part that is loaded, draws, and is unloaded.
PLUGIN = """#include <poinsot/scene.h>

extern "C" int draw() {
    return poinsot::library::Scene::from_text("[film]\\nsize = \\"64x36\\"\\n[body]\\nmoments_kg_m2 = [4, 3, 1.5]\\n[start]\\nomega_rad_s = "
                                              "[1, 1, 2]\\n")
        .still()
        .width_px();
}
"""
HOST = """#include <dlfcn.h>

int main(int, char** arguments) {
    void* const plugin = dlopen(arguments[1], RTLD_NOW);
    if (plugin == nullptr) return 1;
    const int width = reinterpret_cast<int (*)()>(dlsym(plugin, "draw"))();
    return dlclose(plugin) == 0 && width == 64 ? 0 : 2;
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
    """The program's functions are those of glibc."""
    if not re.search(r"\bU acos(@|$)", run(nm, program), re.M):
        sys.exit("the program's acos is not glibc's")


def declared(headers):
    """The functions that the headers declare for programs, and the types of their exceptions."""
    names = set()
    for header in headers:
        text = re.sub(r"//.*|^#.*", "", header.read_text(), flags=re.M)
        names |= {f"typeinfo{of} for poinsot::{name}" for name in re.findall(r"^class .*\b(\w+) : public", text, re.M) for of in ("", " name")}
        _, opened, outside = text.partition("namespace poinsot::library {")
        if not opened:
            continue
        for name, inside in re.findall(r"^class __attribute__\(\(visibility\(\"default\"\)\)\) (\w+) \{\n(.*?)^\};", text, re.M | re.S):
            names |= {f"poinsot::library::{name}::{function}" for function in functions(inside.split(" private:")[0])}
            outside = outside.replace(inside, "")
        outside = re.sub(r"^(struct|enum class) \w+ \{(\};|.*?^\};)", "", outside, flags=re.M | re.S)
        names |= {f"poinsot::library::{function}" for function in functions(outside.replace('__attribute__((visibility("default")))', ""))}
    return names


def functions(text):
    while (shorter := re.sub(r"\{[^{}]*\}", "", text)) != text:
        text = shorter
    found = (re.search(r"(\w+)\(", one) for one in text.split(";") if "= default" not in one and "static_assert" not in one)
    return {match[1] for match in found if match}


def check_symbols(nm, library, headers):
    """The library exports what the headers declare, and takes from others only what is theirs."""
    lines = run(nm, "--dynamic", "--demangle", "--with-symbol-versions", library).splitlines()
    exported, taken = set(), set()
    for line in lines:
        kind, name = re.match(r"[0-9a-f]* *(\w) (.*)", line).groups()
        if kind in "Uwv":
            taken.add(name)
        elif kind != "A":
            name, version = name.rsplit("@@", 1)
            if version != "POINSOT_0.1":
                sys.exit(f"{name} has the version {version}")
            exported.add(re.sub(r"\(.*|\[abi:.*", "", name))
    if exported != declared(headers):
        sys.exit(f"the library exports {sorted(exported - declared(headers))}, which no header declares, and lacks "
                 f"{sorted(declared(headers) - exported)}")
    # Each version of fmt has a namespace of its own.
    foreign = [name for name in taken if re.match(r"(vtable for |typeinfo for )?(poinsot|Eigen|fmt(?!::v\d)|boost|toml|CLI)::|"
                                                  r"(sin|cos|tan|acos|atan2|exp|log|pow)@", name)]
    if foreign:
        sys.exit("another file can replace these functions of the library:\n" + "\n".join(foreign[:20]))
    if not taken or not exported:
        sys.exit(f"nm lists nothing of {library}")


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
    for component in ("library", "development"):
        run(cmake, "--install", build_folder, "--component", component, "--prefix", place / "first")
    prefix = (place / "first").rename(place / "prefix")
    found = f"-DCMAKE_PREFIX_PATH={prefix}"
    libraries = sorted(prefix.glob("lib/**/libpoinsot*"))
    if [library.name for library in libraries] != ["libpoinsot.so", "libpoinsot.so.0", "libpoinsot.so.0.1.0"]:
        sys.exit(f"the libraries are {libraries}")
    headers = sorted((prefix / "include/poinsot").glob("*.h"))
    check_symbols(nm, libraries[0], headers)

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
    for header in headers:
        for processor in ([], ["-march=skylake-avx512"]):
            run("c++", *processor, *flags, header)

    os.environ["PKG_CONFIG_PATH"] = str(libraries[0].parent / "pkgconfig")
    words = run("pkg-config", "--cflags", "--libs", "poinsot").split()
    if run("pkg-config", "--modversion", "poinsot").strip() != "0.1.0":
        sys.exit("pkg-config knows another version")
    os.environ["LD_LIBRARY_PATH"] = str(libraries[0].parent)
    run("c++", "-std=c++20", "-O1", EXAMPLE / "main.cpp", "-o", place / "by_pkg_config", *words)
    check_output(run(place / "by_pkg_config"))

    # Programs that define the names of the library's inside, and templates of Eigen and of the standard library in other forms.
    neighbour = place / "neighbour.cpp"
    neighbour.write_text(NEIGHBOUR)
    expected = None
    for flags in (["-O2", "-march=native", "-DEIGEN_DONT_VECTORIZE", "-fno-builtin"], ["-O0", "-fno-builtin", "-DEIGEN_MAX_ALIGN_BYTES=64"]):
        run("c++", "-std=c++20", *flags, neighbour, "-o", place / "neighbour", *words)
        acos, sentence, n_points, *state = run(place / "neighbour").split()
        if (acos, sentence) != ("42", "wrong") or int(n_points) < 10:
            sys.exit(f"the program with names of its own, with {flags}, says {acos} {sentence} {n_points}")
        expected = expected or state
        if state != expected:
            sys.exit(f"with {flags}, the motion is {state}, not {expected}")
    # |L| and T are those of the start; a wrong elementary function would change them.
    omega = [float(number) for number in expected[:3]]
    for power in (1, 2):
        at, start = (sum(moment ** power * x * x for moment, x in zip((3, 2, 1), body)) for body in (omega, (0.1, 0.2, 2)))
        if abs(at / start - 1) > 1e-13:
            sys.exit(f"with the program's own elementary functions, the motion is {expected}")

    scene = project(place / "scene", """project(scene LANGUAGES CXX)
find_package(poinsot 0.1 REQUIRED)
add_executable(scene main.cpp)
target_link_libraries(scene PRIVATE poinsot::poinsot)
""")
    (scene / "main.cpp").write_text(SCENE)
    for number, flags in enumerate(("-O0", "-O2 -fvisibility=hidden")):
        build(cmake, launcher, scene, scene / f"build{number}", found, f"-DCMAKE_CXX_FLAGS={flags}", "-DCMAKE_BUILD_TYPE=")
        said = run(scene / f"build{number}/scene", place / "still.png")
        if said.split() != ["64", "36", "rk4", "bad.toml:1:1:", "same", "2"]:
            sys.exit(f"the program with {flags} says {said}")
    # The thread that draws survives the program's part that used the library.
    (place / "plugin.cpp").write_text(PLUGIN)
    (place / "host.cpp").write_text(HOST)
    run("c++", "-std=c++20", "-shared", "-fPIC", place / "plugin.cpp", "-o", place / "plugin.so", *words)
    run("c++", "-std=c++20", place / "host.cpp", "-o", place / "host")
    run(place / "host", place / "plugin.so")
    for ask, said in (("1.0 REQUIRED", "version"), ("0.2 REQUIRED", "version"),
                      ("REQUIRED COMPONENTS mechanics", "has no components")):
        asking = project(place / re.sub(r"\W", "_", ask), f"project(asking LANGUAGES CXX)\nfind_package(poinsot {ask})\n")
        if said not in run(cmake, "-S", asking, "-B", asking / "build", found, fails=True):
            sys.exit(f"find_package(poinsot {ask}) is refused without a word about {said}")


def included(cmake, build_folder, nm, launcher, place):
    folder = pathlib.Path(build_folder) / "example"
    build(cmake, launcher, EXAMPLE, folder, f"-DPOINSOT_SOURCE={SOURCE}", "-DCMAKE_UNITY_BUILD=ON", "-DCMAKE_BUILD_TYPE=Release")
    check_output(run(folder / "racket"))
    check_program(nm, folder / "racket")
    cache = (folder / "CMakeCache.txt").read_text()
    if re.search("^(BUILD_TESTING|CPACK_|POINSOT_PAGE)", cache, re.M) or (folder / "poinsot/src/outputs/production").exists():
        sys.exit("the including project gets tests, packages or parts that it did not ask for")
    run(cmake, "--install", folder, "--prefix", place / "prefix")
    files = sorted(path.name for path in (place / "prefix").glob("**/*") if not path.is_dir())
    if files != ["libpoinsot.so.0", "libpoinsot.so.0.1.0", "racket"]:
        sys.exit(f"the including project installs {files}")
    check_output(run((place / "prefix").rename(place / "moved") / "bin/racket"))

    # All parts, by FetchContent; the project has targets of its own with the names of poinsot's.
    fetching = project(place / "fetching", f"""project(fetching LANGUAGES C CXX)
foreach(name docs page bundle gallery library)
    add_custom_target(${{name}})
endforeach()
include(FetchContent)
FetchContent_Declare(poinsot SOURCE_DIR {SOURCE})
FetchContent_MakeAvailable(poinsot)
add_executable(fetching main.cpp)
target_link_libraries(fetching PRIVATE poinsot::poinsot)
if(CMAKE_BUILD_TYPE OR CMAKE_CXX_STANDARD OR CMAKE_POSITION_INDEPENDENT_CODE)
    message(FATAL_ERROR "poinsot changes settings")
endif()
""")
    run(cmake, "-G", "Ninja", "-S", fetching, "-B", fetching / "build")
    if "libpoinsot.so" not in run(cmake, "--build", fetching / "build", "--", "-t", "inputs", "fetching"):
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
