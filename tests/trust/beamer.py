#!/usr/bin/env python3
"""Compiles the Beamer example of the guide: each slide shows its still, and a click opens a film that exists.

Exit code 1 if not, 77 (skipped) without pdflatex with Beamer, pdftoppm or numpy.
Usage: beamer.py POINSOT EXAMPLES
"""
import json
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile
import zlib

WIDTH, HEIGHT = 640, 360
# pdftoppm moves letters by up to a pixel, which counts little in pages that are drawn larger.
ENLARGED = 6
# Mean difference in levels between a slide and its still, without the button; measured 0.15. Between two stills: 2.9 and more.
SAME_LEVELS, OTHER_LEVELS = 0.5, 1.0


def skip(why):
    print("skipped:", why)
    sys.exit(77)


def page_of(pdf, number, numpy):
    """A page as grey levels, without the lowest tenth, where the button is."""
    pgm = subprocess.run(["pdftoppm", "-gray", "-f", str(number), "-l", str(number), "-scale-to-x", str(ENLARGED * WIDTH),
                          "-scale-to-y", str(ENLARGED * HEIGHT), pdf], capture_output=True, check=True).stdout
    large = numpy.frombuffer(pgm[-ENLARGED**2 * WIDTH * HEIGHT:], numpy.uint8).reshape(HEIGHT, ENLARGED, WIDTH, ENLARGED)
    return large.mean(axis=(1, 3))[:HEIGHT * 9 // 10]


def texts_of(pdf):
    """The objects of a PDF, unpacked."""
    data = pdf.read_bytes()
    parts = [data]
    for found in re.finditer(rb"stream\r?\n", data):
        try:
            parts.append(zlib.decompressobj().decompress(data[found.end():]))
        except zlib.error:
            pass
    return b"\n".join(parts)


def main(program, examples):
    if not all(shutil.which(name) for name in ("pdflatex", "pdftoppm", "kpsewhich")):
        skip("pdflatex or pdftoppm is missing")
    if any(subprocess.run(["kpsewhich", name], capture_output=True).returncode for name in ("beamer.cls", "pgfmath.sty")):
        skip("LaTeX's Beamer or PGF is missing")
    try:
        import numpy
    except ImportError:
        skip("numpy is missing")
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        shutil.copy(examples / "wobble.toml", folder)
        shutil.copy(examples / "beamer.tex", folder)
        subprocess.run([program, "render", "wobble.toml", "--slides", "wobble", "--size", "320x180", "--quiet"], cwd=folder, check=True)
        latex = subprocess.run(["pdflatex", "-interaction=batchmode", "-halt-on-error", "beamer.tex"], cwd=folder, capture_output=True)
        if latex.returncode != 0:
            print((folder / "beamer.log").read_text(errors="replace"))
            return 1
        plan = json.loads((folder / "wobble/slides.json").read_text())
        stills = [page_of(folder / "wobble" / slide["pdf"], 1, numpy) for slide in plan["slides"]]
        n_failed = 0
        for k in range(len(stills)):
            page = page_of(folder / "beamer.pdf", k + 2, numpy)  # after the title
            levels = [float(abs(page - still).mean()) for still in stills]
            others = levels[:k] + levels[k + 1:]
            is_right = levels[k] < SAME_LEVELS and min(others) > OTHER_LEVELS
            n_failed += not is_right
            print(f"slide {k + 2}: {levels[k]:.2f} levels from its still, at least {min(others):.2f} from the others"
                  f"{'' if is_right else ': WRONG'}")
        links = sorted(set(re.findall(rb"\((wobble/[^)]*\.mp4)\)", texts_of(folder / "beamer.pdf"))))
        print("links:", ", ".join(link.decode() for link in links))
        n_failed += len(links) != len(stills) or not all((folder / link.decode()).exists() for link in links)
        return 1 if n_failed else 0


if __name__ == "__main__":
    sys.exit(main(str(pathlib.Path(sys.argv[1]).resolve()), pathlib.Path(sys.argv[2])))
