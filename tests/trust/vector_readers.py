#!/usr/bin/env python3
"""Compares renderings of the same page by several PDF and SVG readers.

Readers differ in text (hinting, weight of small letters) and in the antialiasing of edges; elsewhere they must agree. Prints a
table; exit code 1 if a reader fails or differs by more, 77 (skipped) if fewer than two are installed.
Usage: vector_readers.py POINSOT SCENES [--quick] [NAME...]
--quick: only poppler and Chromium, one scene.
"""
import pathlib
import shutil
import subprocess
import sys
import tempfile

from PIL import Image, ImageChops

DPI = 150
# Levels of 255, mean over all pixels, and fraction of pixels over 24 levels, both including text and edges.
MOST_MEAN = 2.0  # measured 1.90
MOST_SHARE = 0.028  # measured 0.0269, in Ghostscript with the names of curves


def chromium(folder, name, size, scale=1):
    page = folder / "page.html"
    page.write_text(f'<body style="margin:0;background:#fff"><img src="{name}.svg" style="width:{size[0]}px;height:{size[1]}px">')
    subprocess.run(["chromium", "--headless=new", "--no-sandbox", "--hide-scrollbars", f"--window-size={size[0]},{size[1]}",
                    f"--force-device-scale-factor={scale}", f"--screenshot={folder}/chromium.png", f"file://{page}"],
                   capture_output=True, timeout=120, check=False)
    return folder / "chromium.png"


def raster(reader, folder, name, size, scale=1):
    """The file of the page as rendered by a reader, at DPI; in Chromium, of this size times the scale."""
    out = folder / f"{reader}.png"
    commands = {
        "pdftoppm": ["pdftoppm", "-png", "-singlefile", "-r", str(DPI), f"{name}.pdf", reader],
        "gs": ["gs", "-q", "-dBATCH", "-dNOPAUSE", "-sDEVICE=png16m", f"-r{DPI}", "-dTextAlphaBits=4", "-dGraphicsAlphaBits=4",
               f"-sOutputFile={reader}.png", f"{name}.pdf"],
        "rsvg-convert": ["rsvg-convert", "--dpi-x", str(DPI), "--dpi-y", str(DPI), "-b", "white", "-o", f"{reader}.png",
                         f"{name}.svg"],
        "inkscape": ["inkscape", f"--export-dpi={DPI}", "--export-background=white", f"--export-filename={reader}.png",
                     f"{name}.svg"]}
    if reader == "chromium":
        return chromium(folder, name, size, scale)
    subprocess.run(commands[reader], cwd=folder, capture_output=True, timeout=300, check=False)
    return out


def difference(a, b):
    """Difference of two pictures: the mean over all pixels of the component with the largest difference, levels, and the fraction
    over 24 levels."""
    size = (min(a.width, b.width), min(a.height, b.height))
    red, green, blue = ImageChops.difference(a.crop((0, 0, *size)), b.crop((0, 0, *size))).split()
    counts = ImageChops.lighter(ImageChops.lighter(red, green), blue).histogram()
    return sum(level * n for level, n in enumerate(counts)) / sum(counts), sum(counts[25:]) / sum(counts)


def main():
    arguments = [a for a in sys.argv[1:] if a != "--quick"]
    quick = len(arguments) + 1 < len(sys.argv)
    program, scenes = arguments[0], pathlib.Path(arguments[1])
    names = arguments[2:] or ["generic"] if quick else arguments[2:] or ["generic", "invariable_plane", "four_views", "momentum_sphere", "toutatis"]
    known = ("pdftoppm", "chromium") if quick else ("pdftoppm", "gs", "rsvg-convert", "chromium", "inkscape")
    readers = [r for r in known if shutil.which(r)]
    if len(readers) < 2:
        print("fewer than two readers are here")
        return 77
    failed = 0
    print("against pdftoppm: mean of 255 levels / share of pixels over 24 levels")
    print(f"{'scene':24}" + "".join(f"{r:>22}" for r in readers[1:]))
    for name in names:
        with tempfile.TemporaryDirectory() as temporary:
            folder = pathlib.Path(temporary)
            for suffix in ("pdf", "svg"):
                # Letters as paths: only geometry and tones are compared.
                subprocess.run([program, "still", str(scenes / f"{name}.toml"), "-q", "--theme", "print", "--text", "paths",
                                "-o", f"{name}.{suffix}"], cwd=folder, check=True)
            first = raster(readers[0], folder, name, (0, 0))
            expected = Image.open(first).convert("RGB")
            size = expected.size
            row = f"{name:24}"
            for reader in readers[1:]:
                made = raster(reader, folder, name, size)
                if not made.exists():
                    row += f"{'failed':>22}"
                    failed += 1
                    continue
                picture = Image.open(made).convert("RGB")
                if abs(picture.width - size[0]) > 2 or abs(picture.height - size[1]) > 2:
                    row += f"{'size ' + str(picture.size):>22}"
                    failed += 1
                    continue
                mean, share = difference(picture, expected)
                row += f"{mean:14.2f} /{100 * share:5.2f}%"
                failed += mean > MOST_MEAN or share > MOST_SHARE
            print(row, flush=True)
    return 1 if failed else 0


if __name__ == "__main__":
    sys.exit(main())
