#!/usr/bin/env python3
"""Measures positions of edges: the PDF in poppler and the SVG in Chromium, compared with our own pixels with 8 x 8 samples, at
1080p.

An edge is a row or column of pixels that changes from one uniform tone to another over at most five pixels; a line is one that dips
between two equal tones. An edge's position is the sum of the coverage, a line's position the middle of its dip: computed for our
picture in linear light and for the readers' in encoded levels, which is how each blends. Text is omitted: in pixels it is at whole
pixels.

Geometry is measured on the samples themselves: a reader draws the page eight times as large as well, and edges are searched in its
pixels and our samples, in every eighth row and column; those within three pixels of an ellipsoid's outline, where lines end, are
counted separately. The effects of a reader at 1080p are printed beside, and the difference of its picture of that size from its own
larger one: poppler raises coverage to the power 1.5, which moves the edge of a dark stroke by up to 0.1 px, and puts lines along
rows and columns at whole pixels (those are omitted there); Chromium moves dots and dashes.
Prints a table of position differences, px. Exit code 1 if, for the geometry, more than MOST_OFF of them are over 0.1 px or the
median is over 0.03 px; or, at 1080p, if a reader's picture differs from ours more than from its own larger one, by MOST_MORE of the
edges or by 0.02 px in the median; 77 (skipped) if no reader is installed.
Usage: vector_edges.py POINSOT SCENES [--small] [--overlay FOLDER] [NAME...]
"""
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile

import numpy
from PIL import Image

import vector_readers

Image.MAX_IMAGE_PIXELS = None
MOST_PX = 0.1
FLAT = 2.5  # largest range of levels in a uniform tone
CONTRAST = 40.0  # least difference of levels
MOST_OFF = 0.02  # a fraction; measured: see docs/accuracy.md
MOST_MORE = 0.12  # a fraction; measured: see docs/accuracy.md
SVG_UNITS = 256.0  # per point
FINE = 8  # samples per pixel, in each direction


def linear(levels):
    c = levels / 255.0
    return numpy.where(c <= 0.04045, c / 12.92, ((c + 0.055) / 1.055) ** 2.4)


def samples(program, scene, folder, size, dpi):
    """Our own samples: a picture 8 times as large in each direction."""
    subprocess.run([program, "still", str(scene), "-q", "--theme", "print", *size, "--dpi", str(FINE * dpi),
                    "-o", "large.png"], cwd=folder, check=True)
    return numpy.asarray(Image.open(folder / "large.png").convert("RGB"))


def reduced(large):
    """Pixels as the mean of 8 x 8 samples in linear light."""
    height, width = large.shape[0] // FINE, large.shape[1] // FINE
    out = numpy.empty((height, width, 3))
    light = linear(numpy.arange(256.0))
    for y in range(height):
        rows = light[large[FINE * y:FINE * (y + 1), :FINE * width]]
        out[y] = rows.reshape(FINE, width, FINE, 3).mean(axis=(0, 2))
    return out


def windows(values, n):
    return numpy.lib.stride_tricks.sliding_window_view(values, n, axis=1)


def levels_of(light):
    return 255.0 * numpy.where(light <= 0.0031308, 12.92 * light, 1.055 * numpy.maximum(light, 0.0) ** (1 / 2.4) - 0.055)


def cover_of(values, side):
    """Position of an edge from the left, px, from the coverage."""
    low, high = values[-side:].mean(), values[:side].mean()
    return ((values - low) / (high - low)).sum()


def middle_of(values, side):
    """Position of a line's middle from the left, px."""
    n = len(values)
    depth = numpy.interp(numpy.arange(n), [side / 2, n - side / 2], [values[:side].mean(), values[-side:].mean()]) - values
    depth[:side] = depth[-side:] = 0.0
    return (depth * numpy.arange(n)).sum() / depth.sum() if depth.sum() > 0 else 1e9


def places(ours, own, theirs, free, after, level=True):
    """Position differences of edges and thin lines, px. ours: green, in linear light; own: the same in levels; theirs: levels;
    free: where there is no text; after: as ours, one row further; level: include edges along the columns. Differences along x are
    converted to differences perpendicular to the edge, by the edge's shift from row to row."""
    n, side = 13, 4  # of a window: uniform, edge or line of at most 5, uniform
    a, b = windows(own, n), windows(theirs, n)
    even = windows(free, n).all(axis=2)
    for w in (a, b):
        even &= (numpy.ptp(w[..., :side], axis=2) < FLAT) & (numpy.ptp(w[..., -side:], axis=2) < FLAT)
    left = a[..., :side].mean(axis=2), b[..., :side].mean(axis=2)
    right = a[..., -side:].mean(axis=2), b[..., -side:].mean(axis=2)
    even &= (abs(left[0] - left[1]) < 8) & (abs(right[0] - right[1]) < 8)
    steps = even & (abs(left[0] - right[0]) > CONTRAST)
    dips = even & (abs(left[0] - right[0]) < FLAT) & (a[..., side:-side].min(axis=2) < left[0] - CONTRAST)
    # Where a reader's dots or dashes stand elsewhere on their line, there is nothing to compare.
    dips &= b[..., side:-side].min(axis=2) < left[1] - 0.5 * CONTRAST
    off = []
    for kind, place, middle in ((steps, cover_of, n / 2), (dips, middle_of, (n - 1) / 2)):
        for y, x in zip(*numpy.nonzero(kind)):
            here = place(ours[y, x:x + n], side)
            # One window per edge: the one with the edge in its middle.
            if abs(here - middle) >= 0.5:
                continue
            beside = after[y, x:x + n]
            if abs(beside[:side].mean() - beside[-side:].mean()) < 1e-9 and place is cover_of:
                continue  # a corner: it does not continue in the next row
            slope = place(beside, side) - here
            if not level and abs(slope) < 1e-3:
                continue
            off.append((here - place(theirs[y, x:x + n], side)) / numpy.hypot(1.0, min(abs(slope), n / 2)))
    return off


def free_of_type(pdf, shape, dpi):
    """Pixels without words of the page nearby."""
    page = subprocess.run(["pdftotext", "-bbox", pdf, "-"], capture_output=True, text=True, check=True).stdout
    free = numpy.ones(shape[:2], dtype=bool)
    for box in re.findall(r'<word xMin="([\d.-]+)" yMin="([\d.-]+)" xMax="([\d.-]+)" yMax="([\d.-]+)"', page):
        x0, y0, x1, y1 = (float(side) * dpi / 72.0 for side in box)
        free[max(int(y0) - 6, 0):int(y1) + 7, max(int(x0) - 6, 0):int(x1) + 7] = False
    return free


def turned(*pictures):
    """The arrays in both orientations: to be searched along rows, and along columns."""
    height, width = (min(p.shape[k] for p in pictures) for k in (0, 1))
    pictures = [p[:height, :width] for p in pictures]
    return pictures, [p.T for p in pictures]


def differences(ours, own, levels, free):
    off = []
    for mixed, seen, theirs, place in turned(ours, own, levels, free):
        off += places(mixed[:-1], seen[:-1], theirs[:-1], place[:-1], mixed[1:], level=False)
    return numpy.array(off)


def smaller(levels):
    """A reader's picture reduced by FINE in levels, as the reader blends."""
    height, width = levels.shape[0] // FINE, levels.shape[1] // FINE
    return levels[:FINE * height, :FINE * width].reshape(height, FINE, width, FINE).mean(axis=(1, 3))


def outlines(svg):
    """Outlines of the ellipsoids, as arrays of points, pt: the conics that clip the lines on them."""
    for data in re.findall(r'<clipPath id="[^"]*"><path d="(m[^"]*c[^"]*)"', svg.read_text()):
        at = start = numpy.zeros(2)
        path = []
        for command, text in re.findall(r"([mlhvcz])([^mlhvcz]*)", data):
            numbers = [float(n) for n in re.findall(r"-?\d+", text)]
            if command in "hv":
                at = at + sum(numbers) * numpy.array([command == "h", command == "v"])
                continue
            points = numpy.array(numbers).reshape(-1, 2)
            if command == "m":
                start = at + points[0]
            if command != "c":
                at = start if command == "z" else at + points.sum(axis=0)
                continue
            for last in points.reshape(-1, 3, 2):
                t = numpy.linspace(0.0, 1.0, 400)[:, None]
                path.append(at + 3 * (1 - t)**2 * t * last[0] + 3 * (1 - t) * t**2 * last[1] + t**3 * last[2])
                at = at + last[2]
        yield numpy.concatenate(path) / SVG_UNITS


def near_outlines(svg, shape, dpi, reach_px=3):
    """Pixels near the outlines of ellipsoids."""
    near = numpy.zeros(shape[:2], dtype=bool)
    for path in outlines(svg):
        for x, y in (path * dpi / 72.0).astype(int):
            near[max(y - reach_px, 0):y + reach_px + 1, max(x - reach_px, 0):x + reach_px + 1] = True
    return near


def fine_differences(own, theirs, free):
    """As differences(), px, for samples and a reader's picture of the same size, both in levels of green; free: per pixel."""
    light = linear(numpy.arange(256.0))
    off = []
    for a, b, c in turned(own, theirs, free.repeat(FINE, axis=0).repeat(FINE, axis=1)):
        band = 64 * FINE
        for y in range(0, a.shape[0] - 1, band):
            rows = slice(y, min(y + band, a.shape[0] - 1), FINE)
            after = slice(y + 1, min(y + band, a.shape[0] - 1) + 1, FINE)
            ours = light[a[rows]]
            off += places(ours, levels_of(ours), b[rows].astype(float), c[rows], light[a[after]])
    return numpy.array(off) / FINE


def fine_picture(reader, folder, name, own, size):
    """A reader's picture as large as our samples; green. Chromium may capture a large page before it is completely painted: then it
    is rendered again."""
    for _ in range(8):
        made = vector_readers.raster(reader, folder, name, size, scale=FINE)
        fine = numpy.asarray(Image.open(made).convert("RGB"))[..., 1]
        if (fine < 250).mean() > 0.8 * (own < 250).mean():
            return fine
    sys.exit(f"{name}: {reader} does not paint the whole page")


def report(name, reader, what, off):
    """Prints a row; returns the median, px, and the fraction over MOST_PX."""
    median, over = numpy.median(abs(off)), (abs(off) > MOST_PX).mean()
    print(f"{name:20} {reader:10} {what:9} {len(off):6} edges and lines: median {median:.3f} px, 99 % within "
          f"{numpy.quantile(abs(off), 0.99):.3f} px, {100 * over:.2f} % over {MOST_PX} px", flush=True)
    return median, over


def main():
    arguments = sys.argv[1:]
    small = "--small" in arguments
    arguments = [a for a in arguments if a != "--small"]
    overlay = None
    if "--overlay" in arguments:
        at = arguments.index("--overlay")
        overlay = pathlib.Path(arguments[at + 1]).absolute()
        overlay.mkdir(parents=True, exist_ok=True)
        del arguments[at:at + 2]
    program, scenes = arguments[0], pathlib.Path(arguments[1])
    names = arguments[2:] or ["generic", "invariable_plane", "tennis_racket", "symmetric_prolate", "momentum_sphere"]
    # 1080p, or a quarter of it, at 300 dots per inch.
    # Both sides are given, and the page is laid out on the same fine pixels: the number of rows added for text is an integer.
    size = ["--width-mm", "81.28", "--height-mm", "45.72"] if small else ["--width-mm", "162.56", "--height-mm", "91.44"]
    # The dashes of hidden lines begin elsewhere in pixels than in vectors.
    size += ["--set", 'hidden="pale"']
    if small:
        # Text of 8 pt would leave only a third of such a small page for the figure.
        size += ["--set", 'title=""', "--set", 'caption=""', "--set", "clock=false"]
    dpi = 300
    readers = [r for r in ("pdftoppm", "chromium") if shutil.which(r)]
    if not readers:
        print("no reader is here")
        return 77
    failed = 0
    for name in names:
        with tempfile.TemporaryDirectory() as temporary:
            folder = pathlib.Path(temporary)
            large = samples(program, scenes / f"{name}.toml", folder, size, dpi)
            ours = reduced(large)
            own = large[..., 1].copy()
            del large
            for suffix in ("pdf", "svg"):
                subprocess.run([program, "still", str(scenes / f"{name}.toml"), "-q", "--theme", "print", *size,
                                "--dpi", str(FINE * dpi), "-o", f"{name}.{suffix}"], cwd=folder, check=True)
            free = free_of_type(folder / f"{name}.pdf", ours.shape, dpi)
            near = near_outlines(folder / f"{name}.svg", ours.shape, dpi)
            for reader in readers:
                vector_readers.DPI = FINE * dpi
                fine = fine_picture(reader, folder, name, own, (ours.shape[1], ours.shape[0]))
                for what, where in (("", free & ~near), ("outlines", free & near)):
                    off = fine_differences(own, fine, where)
                    if len(off) > 100:
                        median, over = report(name, reader, what, off)
                        failed += median > 0.03 or over > MOST_OFF
                    else:
                        failed += what == ""
                vector_readers.DPI = dpi
                made = vector_readers.raster(reader, folder, name, (ours.shape[1], ours.shape[0]))
                levels = numpy.asarray(Image.open(made).convert("RGB"), dtype=float)
                green = levels[..., 1]
                itself = smaller(fine)
                median, over = report(name, reader, "at 1080p", differences(ours[..., 1], levels_of(ours[..., 1]), green, free))
                least_median, least = report(name, reader, "itself", differences(itself, itself, green, free))
                failed += median > least_median + 0.02 or over > least + MOST_MORE
                if overlay:
                    # Ours red, theirs cyan: grey where they agree.
                    height, width = min(ours.shape[0], levels.shape[0]), min(ours.shape[1], levels.shape[1])
                    levels_here = levels_of(ours[:height, :width].clip(0, 1))
                    both = numpy.stack([levels_here.mean(axis=2), *2 * [levels[:height, :width].mean(axis=2)]], axis=2)
                    Image.fromarray(both.clip(0, 255).astype("uint8")).save(overlay / f"{name}_{reader}.png")
    return 1 if failed else 0


if __name__ == "__main__":
    sys.exit(main())
