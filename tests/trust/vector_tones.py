#!/usr/bin/env python3
"""Measures differences of tones between vector figures and our own pixels.

At 300 dots per inch, poppler's rendering of the PDF and, if installed, rsvg's of the SVG are compared with our picture, where
neither changes by more than 2 levels between neighbouring pixels, which excludes lines. Inside the outlines of the ellipsoids: the
rms in levels; on the whole page, bodies included: the fraction of such pixels that differ by more than FAR levels, which show
different surfaces.

Prints one row per scene, levels of 255. Exit code 1 if any value is over MOST_RMS or MOST_FAR; 77 (skipped) without poppler.
Usage: vector_tones.py POINSOT SCENES [NAME...]
"""
import pathlib
import shutil
import subprocess
import sys
import tempfile

import numpy
from PIL import Image, ImageDraw

import vector_edges

MOST_RMS = 4.0
FAR = 16.0
MOST_FAR = 0.002  # measured: see docs/accuracy.md
DPI = 300
STILL = ["-q", "--theme", "print", "--width-mm", "162.56", "--height-mm", "91.44", "--dpi", str(DPI)]


def most(channels):
    """The largest of three channels; numpy's own max(axis=2) is ten times slower."""
    return numpy.maximum(numpy.maximum(channels[..., 0], channels[..., 1]), channels[..., 2])


def even(levels):
    """Where a picture differs by no more than 2 levels from all four neighbours."""
    flat = numpy.ones(levels.shape[:2], dtype=bool)
    down = most(abs(numpy.diff(levels, axis=0))) <= 2
    across = most(abs(numpy.diff(levels, axis=1))) <= 2
    flat[1:] &= down
    flat[:-1] &= down
    flat[:, 1:] &= across
    flat[:, :-1] &= across
    return flat


def inside_outlines(svg, size):
    mask = Image.new("L", size)
    draw = ImageDraw.Draw(mask)
    for path in vector_edges.outlines(svg):
        draw.polygon([tuple(place) for place in path * DPI / 72.0], fill=255)
    return numpy.asarray(mask) > 0


def tones(name, folder):
    """By reader: rms in levels inside the ellipsoids, number of pixels, and the fraction of all pixels with large differences."""
    readers = {"poppler.ppm": ["pdftoppm", "-singlefile", "-r", str(DPI), f"{name}.pdf", "poppler"],
               "rsvg.png": ["rsvg-convert", "--dpi-x", str(DPI), "--dpi-y", str(DPI), "-b", "white", "-o", "rsvg.png", f"{name}.svg"]}
    for picture, command in readers.items():
        if not shutil.which(command[0]):
            continue
        subprocess.run(command, cwd=folder, check=True)
        ours, theirs = (numpy.asarray(Image.open(folder / file).convert("RGB"), dtype=numpy.int16)
                        for file in (f"{name}.png", picture))
        height, width = min(ours.shape[0], theirs.shape[0]), min(ours.shape[1], theirs.shape[1])
        ours, theirs = ours[:height, :width], theirs[:height, :width]
        counted = even(ours) & even(theirs)
        apart = ours - theirs
        far = float((most(abs(apart))[counted] > FAR).mean())
        counted &= inside_outlines(folder / f"{name}.svg", (width, height))
        n = int(counted.sum())
        rms = float(numpy.sqrt((apart[counted].astype(float)**2).mean())) if n else 0.0
        yield picture.split(".")[0], rms, n, far


def main():
    program, scenes, names = sys.argv[1], pathlib.Path(sys.argv[2]).absolute(), sys.argv[3:]
    if not shutil.which("pdftoppm"):
        print("poppler is not here")
        return 77
    names = names or sorted(scene.stem for scene in scenes.glob("*.toml"))
    failed = 0
    with tempfile.TemporaryDirectory() as folder:
        for suffix in ("pdf", "svg", "png"):
            subprocess.run([program, "still", *(str(scenes / f"{name}.toml") for name in names), *STILL, "-o", f"{{scene}}.{suffix}"],
                           cwd=folder, check=True)
        for name in names:
            for reader, rms, n, far in tones(name, pathlib.Path(folder)):
                print(f"{name:20} {reader:8} {rms:.2f} levels rms, {n} pixels; {100 * far:.3f} % of the page over {FAR:.0f} levels", flush=True)
                failed += rms > MOST_RMS or far > MOST_FAR
    return 1 if failed else 0


if __name__ == "__main__":
    sys.exit(main())
