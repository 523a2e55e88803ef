#!/usr/bin/env python3
"""Compiles every object of the program again, one after the other and without a compiler cache, and prints the dearest: their seconds of
processor time and their memory. Usage: dearest_objects.py [BUILD [N [FLAG...]]], where the FLAGs, as -O1, come after the build's own.

Processor time depends less on what else the machine does than ninja's log does, which keeps seconds of the clock.
"""
import os
import pathlib
import re
import subprocess
import sys
import tempfile


def main(build="build/release", n="12", *flags):
    told = subprocess.run(["ninja", "-C", build, "-t", "commands", "poinsot"], check=True, capture_output=True, text=True).stdout
    measured = []
    with tempfile.TemporaryDirectory() as folder:
        for command in told.splitlines():
            found = re.fullmatch(r"(?:\S*ccache )?(\S*(?:c\+\+|cc|g\+\+|clang\S*) .*) -MD -MT \S+ -MF \S+ -o (\S+) -c (\S+)", command)
            if not found:
                continue
            name = re.sub(r"CMakeFiles/|\.dir(/Unity)?|_cxx\.cxx|\.o(bj)?$", "", found[2])
            made = pathlib.Path(folder, "object.o")
            process = subprocess.Popen(f"exec {found[1]} {' '.join(flags)} -o {made} -c {found[3]}", shell=True, cwd=build)
            _, status, used = os.wait4(process.pid, 0)
            if status:
                sys.exit(f"{name} does not compile by itself; build first")
            measured.append((used.ru_utime + used.ru_stime, used.ru_maxrss / 2**20, name))
            print(f"{measured[-1][0]:6.1f} s  {measured[-1][1]:.2f} GB  {name}", file=sys.stderr)
    print("| object | CPU, s | memory, GB |\n|---|---|---|")
    for seconds, gigabytes, name in sorted(measured, reverse=True)[: int(n)]:
        print(f"| `{name}` | {seconds:.0f} | {gigabytes:.2f} |")
    print(f"\n{len(measured)} objects, {sum(row[0] for row in measured):.0f} s")


main(*sys.argv[1:])
