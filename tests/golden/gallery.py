#!/usr/bin/env python3
"""Makes the gallery, docs/gallery.md: every scene as a small picture and as vectors, and a table of the lecture's claims with their
stills.

Usage: gallery.py draw POINSOT     (or: cmake --build build/release --target gallery)
       gallery.py vectors POINSOT FOLDER   every scene as NAME.svg in FOLDER, for the site
       gallery.py text             docs/gallery.md alone, from the scene files
       gallery.py check            exit code 1 unless docs/gallery.md agrees with the scene files, and each scene has its picture
Draws scenes/*.toml in one process, in the portable profile, into tests/golden/gallery, reduces each picture to less than 40 kB with
a palette (pngquant, Debian package of that name), draws the README's pictures, and writes both tables between their marks. The SVGs
are not kept: git would hold each version of all of them. A picture's caption is its scene's title and the first line of its file. A claim is a comment in the
scene file that begins with "# Claim (lecture, page 14): " or "# Claims (lecture, pages 6, 8): "; the text after "Seen:" in it says
what the picture must show.
"""
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile

ROOT = pathlib.Path(__file__).resolve().parents[2]
GALLERY = ROOT / "tests" / "golden" / "gallery"
README_PICTURES = ROOT / "tests" / "golden" / "readme"
PAGE = ROOT / "docs" / "gallery.md"
SIZE = "480x270"
COLOURS = "128"
MOST_BYTES = 40_000
# In the order of a lecture.
ORDER = ["five_seconds", "cover",
         "tensor", "four_views", "momentum_sphere", "montgomery", "torque_axis", "torque_symmetric", "euler_drift", "inertia_ellipsoid",
         "gradient", "invariable_plane", "rolling", "contact_matter", "generic", "lecture_construction", "lecture", "sphere", "stable_largest",
         "stable_smallest", "tennis_racket", "inertial_forces", "separatrix", "stability_map", "energy_sweep", "symmetric_oblate", "symmetric_prolate",
         "point_masses", "euler_angles", "heavy_top_conserved", "heavy_top_wavy", "heavy_top_cusp", "heavy_top_looping", "heavy_top_steady",
         "heavy_top_sleeping", "t_handle", "racket_thrown", "feynman_plate", "football", "explorer_1", "earth_wobble", "toutatis"]
# Pages of the lecture with a claim about rigid bodies.
PAGES = range(2, 23)


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
            palette(picture, GALLERY / f"{name}.png")


def draw_vectors(program, names, folder):
    """Draws each scene as FOLDER/NAME.svg."""
    folder.mkdir(parents=True, exist_ok=True)
    scenes = [str(ROOT / "scenes" / f"{name}.toml") for name in names]
    with tempfile.TemporaryDirectory() as drawn:
        subprocess.run([program, "still", *scenes, "-q", "-o", f"{drawn}/####.svg"], check=True)
        for name, page in zip(names, sorted(pathlib.Path(drawn).iterdir()), strict=True):
            shutil.copyfile(page, folder / f"{name}.svg")


def palette(picture, small, colours=COLOURS, most_bytes=MOST_BYTES):
    """Reduces the picture to a palette of few colours, below the size limit."""
    subprocess.run(["pngquant", "--force", "--nofs", "--speed", "1", "--strip", "-o", str(small), colours, str(picture)],
                   check=True)
    if small.stat().st_size > most_bytes:
        sys.exit(f"{small}: {small.stat().st_size} bytes, more than {most_bytes}; take fewer colours")


def draw_first(program):
    """Draws the README's pictures: the default scene as a loop without its caption, and the same for paper."""
    scene = str(ROOT / "scenes" / "generic.toml")
    with tempfile.TemporaryDirectory() as folder:
        # Three turns about L in four polhode periods need the smallest change of the start, 0.03 % of |ω|.
        loop = pathlib.Path(folder) / "loop.toml"
        text, n = re.subn(r"^duration_s = .*$", 'loop = "3/4"\nlength_s = 9.0', pathlib.Path(scene).read_text(), flags=re.M)
        assert n == 1, "scenes/generic.toml says how long its film is"
        loop.write_text(text)
        subprocess.run([program, "render", str(loop), "--portable", "--size", "480x270", "--fps", "15", "--set", "caption=", "-q",
                        "-o", str(README_PICTURES / "rolling.gif")], check=True)
    with tempfile.TemporaryDirectory() as folder:
        picture = pathlib.Path(folder) / "print.png"
        subprocess.run([program, "still", scene, "--portable", "--theme", "print", "--width-mm", "85", "--dpi", "144", "-q",
                        "-o", str(picture)], check=True)
        palette(picture, README_PICTURES / "print.png")
    draw_map(program)


def draw_map(program):
    """Draws the guide's picture: a sweep on a contact sheet."""
    with tempfile.TemporaryDirectory() as folder:
        sheet = pathlib.Path(folder) / "map.png"
        subprocess.run([program, "still", str(ROOT / "scenes" / "stability_map.toml"), "--portable", "--size", "400x226", "--sweep",
                        "start.omega_rad_s[1]=0:1.65:12", "--sheet", "4x3", "-q", "-o", str(sheet)], check=True)
        palette(sheet, README_PICTURES / "stability_map.png", colours="96", most_bytes=165_000)


def lines_of(name):
    """The lines of a scene file without the one that names the schema for editors."""
    lines = (ROOT / "scenes" / f"{name}.toml").read_text().splitlines()
    return [line for line in lines if not line.startswith("#:")]


def title_of(name):
    return re.search(r'^title = "(.*)"$', "\n".join(lines_of(name)), re.M).group(1)


def in_table(text):
    return text.replace("|", "\\|")


def row(name):
    says = in_table(lines_of(name)[0].lstrip("# "))
    title = title_of(name)
    folder = "../tests/golden/gallery"
    return f"| [![{title}]({folder}/{name}.png)](../scenes/{name}.toml) | **{title}.** {says} |"


def gallery_table(names):
    return ["| | |", "|---|---|"] + [row(name) for name in names]


def claim_of(name):
    """The pages of a scene's claim, the claim, and what must be seen; None for a scene without a claim."""
    comment = []
    for line in lines_of(name):
        if comment and not line.startswith("#"):
            break
        if comment or line.startswith("# Claim"):
            comment.append(line.lstrip("#").strip())
    if not comment:
        return None
    found = re.fullmatch(r"Claims? \(lecture, pages? ([\d–, ]+)\): (.*)", " ".join(comment))
    if found is None:
        sys.exit(f"scenes/{name}.toml: a claim begins with \"# Claim (lecture, page 14): \", this one with \"# {comment[0]}\"")
    claim, _, seen = found.group(2).partition("Seen:")
    return found.group(1), claim.strip(), seen.strip()


def pages_in(text):
    """The pages 6, 8 and 10–12 of "6, 8, 10–12"."""
    spans = [[int(page) for page in span.split("–")] for span in text.split(",")]
    return [page for span in spans for page in range(span[0], span[-1] + 1)]


def claims_table(names):
    claims = [(name, *claim) for name in names if (claim := claim_of(name))]
    claims.sort(key=lambda row: (pages_in(row[1])[0], pages_in(row[1])[-1]))
    lines = ["| page | claim | what is seen | still |", "|---|---|---|---|"]
    for name, pages, claim, seen in claims:
        still = f"[{title_of(name)}](../tests/golden/gallery/{name}.png), [`{name}`](../scenes/{name}.toml)"
        lines.append(f"| {pages} | {in_table(claim)} | {in_table(seen)} | {still} |")
    claimed = {page for row in claims for page in pages_in(row[1])}
    missing = [str(page) for page in PAGES if page not in claimed]
    if missing:
        lines += ["", f"Pages whose claim no scene file states: {', '.join(missing)}."]
    return lines


def written():
    """docs/gallery.md with its tables generated from the scene files."""
    names = scenes_in_order()
    text = PAGE.read_text()
    for mark, lines in (("gallery", gallery_table(names)), ("claims", claims_table(names))):
        begin, end = f"<!-- {mark} -->", f"<!-- end of {mark} -->"
        before, rest = text.split(begin)
        text = before + begin + "\n\n" + "\n".join(lines) + "\n\n" + end + rest.split(end)[1]
    return text


def check():
    if PAGE.read_text() != written():
        sys.exit("docs/gallery.md does not say what the scene files say; run: python3 tests/golden/gallery.py text")
    scenes = set(scenes_in_order())
    pictures = {path.stem for path in GALLERY.iterdir()}
    if scenes != pictures:
        sys.exit(f"tests/golden/gallery: no scene, or no picture, of: {', '.join(sorted(scenes ^ pictures))}; "
                 "run: cmake --build build/release --target gallery")


if __name__ == "__main__":
    if sys.argv[1:] == ["check"]:
        check()
    elif sys.argv[1:] == ["text"]:
        PAGE.write_text(written())
    elif len(sys.argv) == 3 and sys.argv[1] == "draw":
        if not shutil.which("pngquant"):
            sys.exit("gallery.py: pngquant is missing; apt-get install pngquant")
        draw(sys.argv[2], scenes_in_order())
        draw_first(sys.argv[2])
        PAGE.write_text(written())
    elif len(sys.argv) == 4 and sys.argv[1] == "vectors":
        draw_vectors(sys.argv[2], scenes_in_order(), pathlib.Path(sys.argv[3]))
    else:
        sys.exit(__doc__)
