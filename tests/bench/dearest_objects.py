#!/usr/bin/env python3
"""Prints the objects that took longest to compile, from the log that ninja keeps of a build: dearest_objects.py [BUILD [N]].

Seconds are those of the clock, of the last time that each was made: build on a quiet machine, with an empty compiler cache, with
as many jobs as it has processors.
"""
import pathlib
import re
import sys


def main(build="build/release", n="12"):
    took = {}
    for line in pathlib.Path(build, ".ninja_log").read_text("utf-8").splitlines()[1:]:
        start_ms, end_ms, _, output, _ = line.split("\t")
        if output.endswith((".o", ".obj")):
            took[re.sub(r"CMakeFiles/|\.dir(/Unity)?|_cxx\.cxx|\.o(bj)?$", "", output)] = (int(end_ms) - int(start_ms)) / 1000
    dearest = sorted(took.items(), key=lambda entry: -entry[1])[: int(n)]
    print("| object | s |\n|---|---|")
    for name, seconds in dearest:
        print(f"| `{name}` | {seconds:.0f} |")
    print(f"\n{len(took)} objects, {sum(took.values()):.0f} s")


main(*sys.argv[1:])
