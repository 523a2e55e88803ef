#!/usr/bin/env python3
"""Tests figures whose text is set by LaTeX: each scene's figure is compiled by pdflatex, in a document that contains only the
figure.

Labels must be at the positions that they have in the figure with our own text. Prints a table; exit code 1 if a figure does not
compile or a label is elsewhere, 77 (skipped) without pdflatex or pdftotext.
Usage: vector_latex.py POINSOT SCENES
"""
import html
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile
import unicodedata

# The figure is in the page's corner.
DOCUMENT = r"""\documentclass{article}
\usepackage{graphicx,color}
\pdfpagewidth=%(width)sbp \pdfpageheight=%(height)sbp
\hoffset=-1in \voffset=-1in \topmargin=0pt \headheight=0pt \headsep=0pt \oddsidemargin=0pt \topskip=0pt \parindent=0pt
\textwidth=%(width)sbp \textheight=%(height)sbp \pagestyle{empty}
\begin{document}\noindent\input{figure}\end{document}
"""
# Letters of another font have other widths and heights; only a label's reference point has the same position.
MOST_PT = 3.0  # measured 1.2


def words_of(pdf):
    """Each word of the page: its text, left and right, and its lower edge, points."""
    page = subprocess.run(["pdftotext", "-bbox", pdf, "-"], capture_output=True, text=True, check=True).stdout
    found = re.findall(r'<word xMin="([\d.-]+)" yMin="[\d.-]+" xMax="([\d.-]+)" yMax="([\d.-]+)">([^<]*)<', page)
    return [(unicodedata.normalize("NFKC", html.unescape(word)), float(x0), float(x1), float(y1)) for x0, x1, y1, word in found]


# Between words of a line, points: pdftotext does not report a large radical or bracket.
SPACE_PT, WIDEST_PT = 5.0, 16.0


def is_beside(word, other, gap_pt=WIDEST_PT):
    """Whether a word continues another one on its left."""
    # Exponents are above the line.
    return word is not other and abs(word[3] - other[3]) < 7.0 and -1.0 < word[1] - other[2] < gap_pt


def is_under(word, other):
    """Whether a word begins the line below another one's."""
    return 4.0 < word[3] - other[3] < 18.0 and abs(word[1] - other[1]) < 2.0


def beginnings(words):
    """The first words of labels and captions."""
    return [word for word in words if not any(is_beside(word, other) or is_under(word, other) for other in words)]


def end_of(word, words, gap_pt):
    """The end of the line to which a word belongs."""
    after = next((other for other in words if is_beside(other, word, gap_pt)), None)
    return word[2] if after is None else end_of(after, words, gap_pt)


def distance(one, ours, other, theirs):
    """Distance of two labels: of their nearest sides or middles, and of their lower edges."""
    left = other[1] - one[1]
    aside = abs(left)
    # Another label may stand close to the end of one.
    for gap_pt in (SPACE_PT, WIDEST_PT):
        right = end_of(other, theirs, gap_pt) - end_of(one, ours, gap_pt)
        aside = min(aside, abs(right), abs(0.5 * (left + right)))
    return max(aside, abs(other[3] - one[3]))


def trial(program, scene, folder):
    still = [program, "still", str(scene), "-q", "--theme", "print", "--width-mm", "170", "-o"]
    subprocess.run([*still, "ours.pdf"], cwd=folder, check=True)
    subprocess.run([*still, "figure.pdf", "--text", "latex"], cwd=folder, check=True)
    size = re.search(r"Page size:\s+([\d.]+) x ([\d.]+)",
                     subprocess.run(["pdfinfo", "figure.pdf"], cwd=folder, capture_output=True, text=True).stdout)
    (folder / "document.tex").write_text(DOCUMENT % {"width": size[1], "height": size[2]})
    run = subprocess.run(["pdflatex", "-halt-on-error", "-interaction=nonstopmode", "document.tex"], cwd=folder,
                         capture_output=True)
    if run.returncode != 0:
        log = run.stdout.decode("utf-8", "replace")
        return "pdflatex: " + next((line for line in log.splitlines() if line.startswith("!")), "failed")
    # The figure's own file contains no text.
    if len(subprocess.run(["pdffonts", "figure.pdf"], cwd=folder, capture_output=True, text=True).stdout.splitlines()) > 2:
        return "the figure without type has fonts"
    ours, theirs = words_of(folder / "ours.pdf"), words_of(folder / "document.pdf")
    # The programs split formulas into words differently.
    # The numbers of a matrix begin no line, and LaTeX may break that caption into lines elsewhere.
    plain_word = "[A-Za-z.]+" if "matrix}" in scene.read_text() else "[A-Za-z0-9.]+"
    plain = [word for word in beginnings(ours) if re.fullmatch(plain_word, word[0])]
    # Two labels that nearly touch are one word to pdftotext.
    off = [min((distance(word, ours, other, theirs) for other in theirs if word[0] in other[0]), default=1e9) for word in plain]
    worst = max(off, default=1e9)
    print(f"{scene.stem:28} {len(plain):3} beginnings, at most {worst:.2f} pt off", flush=True)
    if worst > MOST_PT:
        return f"not in its place: {plain[off.index(worst)] if plain else 'no word was found'}"
    return ""


def main():
    program, scenes = sys.argv[1], pathlib.Path(sys.argv[2])
    for tool in ("pdflatex", "pdftotext"):
        if shutil.which(tool) is None:
            print(f"{tool} is not here")
            return 77
    failed = 0
    for scene in sorted(scenes.glob("*.toml")):
        with tempfile.TemporaryDirectory() as folder:
            fault = trial(program, scene, pathlib.Path(folder))
        if fault:
            failed += 1
            print(f"{scene.stem}: {fault}", flush=True)
    return 1 if failed else 0


if __name__ == "__main__":
    sys.exit(main())
