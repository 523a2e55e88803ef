#!/usr/bin/env python3
"""Checks that CMake configures the program on machines with only some of the packages; nothing is built.

Each library of the tests is hidden in turn, then all of them. The program alone (BUILD_TESTING=OFF, as `./run film` configures it)
must configure without any message about tests; with BUILD_TESTING=ON the tests are omitted and a warning names the Debian package.
Each library of the program is hidden in turn, too: CMake must stop and name its Debian package. Pages are built with the tests, or if they
are asked for. Without a package for pages it must go on and name it, and stop where a module was given.
Usage: configure_check.py CMAKE SOURCE
"""
import pathlib
import re
import subprocess
import sys
import tempfile

TEST_PACKAGES = {  # Debian package → the CMake option that hides it
    "libgtest-dev": "-DCMAKE_DISABLE_FIND_PACKAGE_GTest=ON",
    "librapidcheck-dev": "-DCMAKE_DISABLE_FIND_PACKAGE_rapidcheck=ON",
    "libbenchmark-dev": "-DCMAKE_DISABLE_FIND_PACKAGE_benchmark=ON",
    "nlohmann-json3-dev": "-DCMAKE_DISABLE_FIND_PACKAGE_nlohmann_json=ON",
    "libgmp-dev": "-DPOINSOT_TEST_gmp=OFF",
    "libmpfr-dev": "-DPOINSOT_TEST_mpfr=OFF",
}
PROGRAM_PACKAGES = {
    "libeigen3-dev": "-DCMAKE_DISABLE_FIND_PACKAGE_Eigen3=ON",
    "libfmt-dev": "-DCMAKE_DISABLE_FIND_PACKAGE_fmt=ON",
    "libcli11-dev": "-DCMAKE_DISABLE_FIND_PACKAGE_CLI11=ON",
}
NO_XZ = "-DXZ_PROGRAM="


def unset(option):
    return "-U" + re.match(r"-D([^=]+)=", option)[1]


def main():
    cmake, source = sys.argv[1:]
    failures = []
    with tempfile.TemporaryDirectory() as build:
        every = [*TEST_PACKAGES.values(), *PROGRAM_PACKAGES.values(), "-DPOINSOT_PAGE=auto", NO_XZ]

        def configure(*options):
            """Configures with only these options: libraries hidden by an earlier run are found again."""
            shown = [unset(hidden) for hidden in every if hidden not in options]
            done = subprocess.run([cmake, "-S", source, "-B", build, "--no-warn-unused-cli", *shown, *options], capture_output=True,
                                  text=True)
            return done.returncode, " ".join((done.stdout + done.stderr).split())

        def expect(true, what, said):
            if not true:
                failures.append(f"{what}: {said[-600:]}")

        tests_off, tests_on = "-DBUILD_TESTING=OFF", "-DBUILD_TESTING=ON"
        for name, hidden in [*TEST_PACKAGES.items(), ("all test packages", None)]:
            options = [hidden] if hidden else list(TEST_PACKAGES.values())
            code, said = configure(tests_off, *options)
            expect(code == 0 and "Warning" not in said, f"without {name}, BUILD_TESTING=OFF", said)
            expect(not (pathlib.Path(build) / "tests").exists(), f"without {name}, BUILD_TESTING=OFF configures tests", said)
            code, said = configure(tests_on, *options)
            expect(code == 0, f"without {name}, BUILD_TESTING=ON", said)
            for package in [name] if hidden else TEST_PACKAGES:
                expect(f"{package}" in said and "tests are left out" in said, f"{package} is not named", said)
        # Generated files can be renewed without the tests.
        targets = subprocess.run([cmake, "--build", build, "--target", "help"], capture_output=True, text=True).stdout.split()
        for target in ("poinsot", "docs", "gallery"):
            expect(any(word.rstrip(":") == target for word in targets), f"there is no target {target} without tests", "")
        for name, hidden in PROGRAM_PACKAGES.items():
            code, said = configure(tests_off, hidden)
            expect(code != 0 and f"install {name}" in said, f"without {name}", said)
        # Pages are asked for, not come upon: without tests nobody opens one.
        for options, pages in (([tests_off], "OFF"), ([tests_on], "auto"), ([tests_off, "-DPOINSOT_PAGE=auto"], "auto")):
            code, said = configure(*options)
            cache = pathlib.Path(build, "CMakeCache.txt").read_text("utf-8")
            expect(code == 0 and f"\nPOINSOT_PAGE:STRING={pages}\n" in cache, f"POINSOT_PAGE with {options} is not {pages}", said)
        code, said = configure(tests_off, "-DPOINSOT_PAGE=auto", NO_XZ)
        expect(code == 0 and re.search(r"cannot write pages [^:]*: these packages are missing:[^:]* xz-utils", said), "pages without xz", said)
        module = pathlib.Path(build, "given.wasm")
        code, said = configure(tests_off, f"-DPOINSOT_PAGE={module}")
        expect(code != 0 and "no such file" in said, "a module that does not exist", said)
        module.touch()
        code, said = configure(tests_off, f"-DPOINSOT_PAGE={module}", NO_XZ)
        expect(code != 0 and "install xz-utils" in said, "a module without xz", said)
        # With nothing hidden, the tests are configured; otherwise the checks above would prove nothing.
        code, said = configure(tests_on)
        expect(code == 0 and (pathlib.Path(build) / "tests").exists() and "left out" not in said, "with all packages", said)
    print("\n".join(failures) or f"{len(TEST_PACKAGES)} test packages and {len(PROGRAM_PACKAGES)} libraries hidden in turn")
    return 1 if failures else 0


if __name__ == "__main__":
    sys.exit(main())
