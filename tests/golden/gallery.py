#!/usr/bin/env python3
"""The gallery of the README: every scene as a small picture, and the table that shows them.

Usage: gallery.py POINSOT            (or: cmake --build build/release --target gallery)
Draws scenes/*.toml in one process, in the portable profile, into tests/golden/gallery, brings each below 40 kB by a palette
(pngquant, Debian package of that name), draws the README's first picture, and writes the table between its gallery marks. A picture's caption is its
scene's title and the first line of its file.
"""
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile

ROOT = pathlib.Path(__file__).resolve().parents[2]
GALLERY = ROOT / "tests" / "golden" / "gallery"
SIZE = "480x270"
COLOURS = "128"
MOST_BYTES = 40_000
COLUMNS = 3
# As a lecture would come to them.
ORDER = ["tensor", "inertia_ellipsoid", "gradient", "invariable_plane", "generic", "four_views", "momentum_sphere", "sphere",
         "stable_largest", "stable_smallest", "tennis_racket", "separatrix", "euler_drift", "symmetric_oblate", "symmetric_prolate",
         "point_masses", "euler_angles", "heavy_top_wavy", "heavy_top_cusp", "heavy_top_looping", "heavy_top_steady",
         "heavy_top_sleeping", "t_handle", "racket_thrown", "feynman_plate", "football", "earth_wobble", "toutatis"]


def scenes_in_order():
    names = sorted(path.stem for path in (ROOT / "scenes").glob("*.toml"))
    return [name for name in ORDER if name in names] + [name for name in names if name not in ORDER]


def draw(program, names):
    GALLERY.mkdir(exist_ok=True)
    for old in GALLERY.glob("*.png"):
        old.unlink()
    scenes = [str(ROOT / "scenes" / f"{name}.toml") for name in names]
    with tempfile.TemporaryDirectory() as folder:
        subprocess.run([program, "still", *scenes, "--portable", "--size", SIZE, "-q", "-o", f"{folder}/####.png"], check=True)
        for name, picture in zip(names, sorted(pathlib.Path(folder).iterdir()), strict=True):
            small = GALLERY / f"{name}.png"
            subprocess.run(["pngquant", "--nofs", "--speed", "1", "--strip", "-o", str(small), COLOURS, str(picture)],
                           check=True)
            if small.stat().st_size > MOST_BYTES:
                sys.exit(f"{small}: {small.stat().st_size} bytes, more than {MOST_BYTES}; take fewer colours")


def draw_first(program):
    subprocess.run([program, "still", str(ROOT / "scenes" / "generic.toml"), "--portable", "--size", "1280x720", "-q", "-o",
                    str(GALLERY.parent / "readme" / "generic.png")], check=True)


def cell(name):
    text = (ROOT / "scenes" / f"{name}.toml").read_text()
    title = re.search(r'^title = "(.*)"$', text, re.M).group(1)
    says = text.splitlines()[0].lstrip("# ").replace("|", "\\|")
    return f"[![{title}](tests/golden/gallery/{name}.png)](scenes/{name}.toml)<br>**{title}.** {says}"


def write_table(names):
    rows = [names[i:i + COLUMNS] for i in range(0, len(names), COLUMNS)]
    lines = ["|" + " |" * COLUMNS, "|" + "---|" * COLUMNS]
    lines += ["| " + " | ".join([cell(name) for name in row] + [""] * (COLUMNS - len(row))) + " |" for row in rows]
    readme = ROOT / "README.md"
    begin, end = "<!-- gallery -->", "<!-- end of gallery -->"
    before, rest = readme.read_text().split(begin)
    readme.write_text(before + begin + "\n\n" + "\n".join(lines) + "\n\n" + end + rest.split(end)[1])


if __name__ == "__main__":
    if len(sys.argv) != 2:
        sys.exit(__doc__)
    if not shutil.which("pngquant"):
        sys.exit("gallery.py: pngquant is missing; apt-get install pngquant")
    draw(sys.argv[1], scenes_in_order())
    draw_first(sys.argv[1])
    write_table(scenes_in_order())
