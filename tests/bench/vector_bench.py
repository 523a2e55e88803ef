#!/usr/bin/env python3
"""Measures processor time and size of every scene as PDF and SVG, with tones and with lines only.

Usage: vector_bench.py POINSOT SCENES [options of still]
"""
import os
import pathlib
import resource
import subprocess
import sys
import tempfile


def cost(command):
    """Seconds of processor time of a command, the least of three runs."""
    best = 1e9
    for _ in range(3):
        before = resource.getrusage(resource.RUSAGE_CHILDREN)
        subprocess.run(command, check=True, capture_output=True)
        after = resource.getrusage(resource.RUSAGE_CHILDREN)
        best = min(best, after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime)
    return best


def main():
    program, scenes, options = sys.argv[1], pathlib.Path(sys.argv[2]), sys.argv[3:]
    print("| scene | PDF, kB | s | SVG, kB | s | PDF of lines, kB | s |\n|---|---|---|---|---|---|---|")
    most = {"pdf": 0, "svg": 0}
    for scene in sorted(scenes.glob("*.toml")):
        row = f"| {scene.stem} |"
        with tempfile.TemporaryDirectory() as folder:
            for suffix, shading in (("pdf", "tone"), ("svg", "tone"), ("pdf", "none")):
                file = os.path.join(folder, "a." + suffix)
                seconds = cost([program, "still", str(scene), "-q", "--shading", shading, "-o", file, *options])
                kilobytes = os.path.getsize(file) / 1000
                most[suffix] = max(most[suffix], kilobytes)
                row += f" {kilobytes:.0f} | {seconds:.2f} |"
        print(row, flush=True)
    print(f"\nthe largest: PDF {most['pdf']:.0f} kB, SVG {most['svg']:.0f} kB")


if __name__ == "__main__":
    main()
