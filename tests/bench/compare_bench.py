#!/usr/bin/env python3
"""Processor time of `poinsot compare`, and the size of its report.

Draws 100 pictures of 1280 × 720, of which 80 change in one of four ways, and compares them: counts alone, with a report, with FLIP and
SSIM. Then a film of 300 frames against itself and against one in other colours. Prints one line each.

Usage: compare_bench.py POINSOT [FOLDER]; pictures that are in FOLDER already are used again.
"""
import pathlib
import resource
import shutil
import subprocess
import sys
import tempfile
import time

ROOT = pathlib.Path(__file__).resolve().parents[2]
SCENES = ["generic", "tennis_racket", "separatrix", "rolling", "energy_sweep"]
CHANGES = [[], ["--theme", "dark"], ["--set", 'style.polhode="#1060ff"'], ["--set", "camera.field_deg=30.2"],
           ["--set", "type_scale=1.1"]]


def draw(program, folder):
    for kind in ("ref", "new"):
        (folder / kind).mkdir(parents=True, exist_ok=True)
    for scene in SCENES:
        for i in range(20):
            name = f"{scene}_{i}.png"
            base = [program, "still", str(ROOT / "scenes" / f"{scene}.toml"), "-q", "--portable", "--size", "1280x720",
                    "--time", f"{0.1 + 0.15 * i:.2f}"]
            if not (folder / "ref" / name).exists():
                subprocess.run([*base, "-o", str(folder / "ref" / name)], check=True)
            if (folder / "new" / name).exists():
                continue
            if CHANGES[i % 5]:
                subprocess.run([*base, *CHANGES[i % 5], "-o", str(folder / "new" / name)], check=True)
            else:
                shutil.copy(folder / "ref" / name, folder / "new" / name)
    for film, options in (("a.mp4", []), ("b.mp4", ["--theme", "dark"])):
        if not (folder / film).exists():
            subprocess.run([program, "render", str(ROOT / "scenes" / "generic.toml"), "-q", "--size", "1280x720",
                            "--frames", "0-299", "-o", str(folder / film), *options], check=True)


def measured(command, folder):
    before = resource.getrusage(resource.RUSAGE_CHILDREN)
    start = time.monotonic()
    subprocess.run(command, cwd=folder, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
    after = resource.getrusage(resource.RUSAGE_CHILDREN)
    cpu_s = after.ru_utime - before.ru_utime + after.ru_stime - before.ru_stime
    return cpu_s, time.monotonic() - start


def size_of(path):
    if path.is_dir():
        return sum(file.stat().st_size for file in path.iterdir())
    return path.stat().st_size if path.exists() else 0


def main():
    program = str(pathlib.Path(sys.argv[1]).resolve())
    with tempfile.TemporaryDirectory() as scratch:
        folder = pathlib.Path(sys.argv[2] if len(sys.argv) > 2 else scratch).resolve()
        draw(program, folder)
        print(f"{'':34} {'CPU s':>7} {'wall s':>7} {'page MB':>8} {'pictures MB':>12}")
        for name, first, second, options in (
                ("pictures, counts", "ref", "new", []),
                ("pictures, report", "ref", "new", ["--report", "report.html"]),
                ("pictures, report in a single file", "ref", "new", ["--report", "single.html", "--single-file"]),
                ("pictures, limit of FLIP", "ref", "new", ["--max-flip", "0.01"]),
                ("pictures, limit of SSIM", "ref", "new", ["--min-ssim", "0.99"]),
                ("equal pictures", "ref", "ref", []),
                ("film of 300 frames, the same bytes", "a.mp4", "a.mp4", []),
                ("film against another", "a.mp4", "b.mp4", [])):
            cpu_s, wall_s = measured([program, "compare", first, second, *options], folder)
            page = folder / options[1] if "--report" in options else pathlib.Path("none")
            print(f"{name:34} {cpu_s:7.2f} {wall_s:7.2f} {size_of(page) / 1e6:8.2f} "
                  f"{size_of(folder / (page.stem + '_pictures')) / 1e6:12.2f}")


if __name__ == "__main__":
    main()
