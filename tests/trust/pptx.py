#!/usr/bin/env python3
"""Reads presentations of `render -o LECTURE.pptx` with Python's zipfile and xml, and has LibreOffice draw them.

Each stop has one slide with its title, its note, its film, which starts by itself, and its loop, which the next press shows; each part is
named and typed; two runs give the same bytes. LibreOffice makes a page of each slide and draws the stop on it, with which the film ends.
Exit code 1 if not, 77 (skipped) where soffice, pdftoppm, ffmpeg or numpy are missing. --quick: without them.
Usage: pptx.py POINSOT EXAMPLES [--quick]
"""
import pathlib
import posixpath
import shutil
import subprocess
import sys
import tempfile
import xml.etree.ElementTree as ElementTree
import zipfile

A = "{http://schemas.openxmlformats.org/drawingml/2006/main}"
P = "{http://schemas.openxmlformats.org/presentationml/2006/main}"
P14 = "{http://schemas.microsoft.com/office/powerpoint/2010/main}"
R = "{http://schemas.openxmlformats.org/officeDocument/2006/relationships}"
RELATIONSHIP = "{http://schemas.openxmlformats.org/package/2006/relationships}Relationship"
WIDTH, HEIGHT = 640, 360
# Mean difference in levels between a page and its still, both as means of 8 × 8 pixels: LibreOffice compresses pictures as JPEG and places
# them up to a pixel off. Measured 0.10 to 0.46; from the other stills 2.65 and more.
BLOCK = 8
SAME_LEVELS = 0.8

# Title, note, film and loop of each slide. The second stop's title and note are hostile; the frames after the last stop have the title
# and note of that stop.
TITLE, NOTE = 'Is a < b > c & "d"?', "One line & <b>\nand another"
SLIDES = [("Which way does the axis go?", "Let them vote before you go on.", "01.mp4", None),
          (TITLE, NOTE, "02.mp4", "02-loop.mp4"),
          (TITLE, NOTE, "03.mp4", None)]

n_failed = 0


def check(what, is_right):
    global n_failed
    n_failed += not is_right
    if not is_right:
        print("WRONG:", what)


def skip(why):
    print("skipped:", why)
    sys.exit(1 if n_failed else 77)


def scene_text(examples):
    text = (examples / "wobble.toml").read_text()
    for old, new in (('"A cone rolls on a cone"', f"'{TITLE}'"), ('"Let it run while you explain."', "'''" + NOTE + "'''")):
        assert old in text
        text = text.replace(old, new)
    return text


def source_of(relationships):
    """The part that has these relationships: "ppt/slides/slide1.xml" for "ppt/slides/_rels/slide1.xml.rels"."""
    folder, name = posixpath.split(relationships)
    return posixpath.join(posixpath.dirname(folder), name[:-len(".rels")])


def relationships_of(archive, part):
    """Target by id, from the root of the package."""
    folder, name = posixpath.split(part)
    tree = ElementTree.fromstring(archive.read(posixpath.join(folder, "_rels", name + ".rels")))
    return {row.get("Id"): posixpath.normpath(posixpath.join(folder, row.get("Target"))) for row in tree.iter(RELATIONSHIP)}


def text_of(tree, kind):
    """The paragraphs of the placeholder of this kind."""
    for shape in tree.iter(P + "sp"):
        if shape.find(f"{P}nvSpPr/{P}nvPr/{P}ph").get("type") == kind:
            return "\n".join("".join(run.text for run in line.iter(A + "t")) for line in shape.iter(A + "p"))
    return None


def check_package(archive):
    """Every part can be read, has a type, and what relationships name is there."""
    check("sums of the ZIP", archive.testzip() is None)
    names = archive.namelist()
    check("a name for each part", len(names) == len(set(names)))
    check("the types come first", names[0] == "[Content_Types].xml")
    types = ElementTree.fromstring(archive.read(names[0]))
    of_suffix = {row.get("Extension") for row in types if row.tag.endswith("Default")}
    of_part = {row.get("PartName") for row in types if row.tag.endswith("Override")}
    for name in names[1:]:
        suffix = name.rsplit(".", 1)[1]
        is_typed = "/" + name in of_part or suffix in of_suffix and (suffix != "xml")
        check(f"type of {name}", is_typed)
        if suffix == "rels":
            source = source_of(name)
            check(f"{name} belongs to a part", source in names or source == "")
            for target in relationships_of(archive, source).values():
                check(f"{name}: {target}", target in names)
    check("no type without its part", all(part[1:] in names for part in of_part))


def steps_of(tree, kind):
    """The steps of the sequence of this kind: for each, its effects as (class, kind of start, shape)."""
    for sequence in tree.iter(P + "seq"):
        node = sequence.find(P + "cTn")
        if node.get("nodeType") == kind:
            return [[(effect.get("presetClass"), effect.get("nodeType"), next(effect.iter(P + "spTgt")).get("spid"))
                     for effect in step.iter(P + "cTn") if effect.get("presetClass")] for step in node.find(P + "childTnLst")]
    return []


def check_slides(archive):
    """Returns, for each slide, its film, the poster, and the picture that lies on top, which print-outs show."""
    presentation = "ppt/presentation.xml"
    tree = ElementTree.fromstring(archive.read(presentation))
    size = tree.find(P + "sldSz")
    check("16:9", int(size.get("cx")) * 9 == int(size.get("cy")) * 16)
    targets = relationships_of(archive, presentation)
    slides = [targets[row.get(R + "id")] for row in tree.iter(P + "sldId")]
    check("number of slides", len(slides) == len(SLIDES))
    media = []
    for part, (title, note, film, loop) in zip(slides, SLIDES):
        tree = ElementTree.fromstring(archive.read(part))
        targets = relationships_of(archive, part)
        check(f"{part}: title", text_of(tree, "title") == title)
        notes = [target for target in targets.values() if "notesSlide" in target]
        found = text_of(ElementTree.fromstring(archive.read(notes[0])), "body") if notes else None
        check(f"{part}: note", found == note)
        linked = [targets[row.get(R + "link")] for row in tree.iter(A + "videoFile")]
        embedded = [targets[row.get(R + "embed")] for row in tree.iter(P14 + "media")]
        check(f"{part}: films", linked == embedded == ["ppt/media/" + name for name in (film, loop) if name])
        pictures = list(tree.iter(P + "pic"))
        boxes = [picture.find(f"{P}spPr/{A}xfrm/{A}ext").attrib for picture in pictures]
        check(f"{part}: two pictures fill the slide", boxes == 2 * [{"cx": size.get("cx"), "cy": size.get("cy")}])
        under, top = [picture.find(f"{P}nvPicPr/{P}cNvPr").get("id") for picture in pictures]
        # The film starts with the slide. The picture above it is hidden until the next press shows the loop; without a loop, until
        # somebody clicks on the title, which is above the slide.
        plays = [("mediacall", "afterEffect", under)]
        shows = [("entr", "clickEffect", top)]
        check(f"{part}: steps", steps_of(tree, "mainSeq") == ([plays, [*shows, ("mediacall", "withEffect", top)]] if loop else [plays]))
        check(f"{part}: the still", steps_of(tree, "interactiveSeq") == ([] if loop else [shows]))
        check(f"{part}: plays from the beginning", all(row.get("cmd") == "playFrom(0.0)" for row in tree.iter(P + "cmd")))
        repeats = {next(node.iter(P + "spTgt")).get("spid"): next(node.iter(P + "cTn")).get("repeatCount") for node in tree.iter(P + "video")}
        check(f"{part}: repeats", repeats == ({under: None, top: "indefinite"} if loop else {under: None}))
        numbers = [node.get("id") for node in tree.iter(P + "cTn")]
        check(f"{part}: a number for each node", len(numbers) == len(set(numbers)))
        poster, still = [targets[picture.find(f"{P}blipFill/{A}blip").get(R + "embed")] for picture in pictures]
        media.append((embedded[0], poster, still))
    for before, after in zip(media, media[1:]):
        check(f"{after[0]} starts from the picture of the stop before", after[1] == before[2])
    check("print-outs show each stop once", len({still for _, _, still in media}) == len(media))
    return media


def grey(command, numpy):
    out = subprocess.run(command, capture_output=True, check=True).stdout
    return numpy.frombuffer(out[-WIDTH * HEIGHT:], numpy.uint8).reshape(HEIGHT, WIDTH).astype(int)


def in_blocks(picture):
    return picture.reshape(HEIGHT // BLOCK, BLOCK, WIDTH // BLOCK, BLOCK).mean(axis=(1, 3))


def check_drawn(folder, media):
    """LibreOffice's pages, and the films' first pictures, against the posters."""
    for name in ("soffice", "pdftoppm", "ffmpeg"):
        if not shutil.which(name):
            skip(f"{name} is missing")
    try:
        import numpy
    except ImportError:
        skip("numpy is missing")
    subprocess.run(["soffice", f"-env:UserInstallation=file://{folder}/office", "--headless", "--convert-to", "pdf", "lecture.pptx"],
                   cwd=folder, check=True, capture_output=True, timeout=300)
    pdf = folder / "lecture.pdf"
    pages = subprocess.run(["pdfinfo", pdf], capture_output=True, check=True, text=True).stdout
    check("a page for each slide", f"Pages:           {len(media)}\n" in pages)
    with zipfile.ZipFile(folder / "lecture.pptx") as archive:
        archive.extractall(folder / "parts")

    def first_picture(name):
        return grey(["ffmpeg", "-v", "error", "-i", folder / "parts" / name, "-frames:v", "1", "-vf", f"scale={WIDTH}:{HEIGHT}:flags=area",
                     "-pix_fmt", "gray", "-f", "rawvideo", "-"], numpy)

    stills = [first_picture(still) for _, _, still in media]
    posters = [first_picture(poster) for _, poster, _ in media]
    for k, (film, _, _) in enumerate(media):
        page = grey(["pdftoppm", "-gray", "-f", str(k + 1), "-l", str(k + 1), "-scale-to-x", str(WIDTH), "-scale-to-y", str(HEIGHT), pdf],
                    numpy)
        shown = first_picture(film)
        levels = [float(abs(in_blocks(page) - in_blocks(picture)).mean()) for picture in stills]
        of_film = [float(abs(shown - picture).mean()) for picture in posters]
        nearest, nearest_of_film = (min(found[:k] + found[k + 1:]) for found in (levels, of_film))
        print(f"slide {k + 1}: page {levels[k]:.2f} levels from its still, {nearest:.2f} from the next; "
              f"film {of_film[k]:.2f} and {nearest_of_film:.2f}")
        check(f"page {k + 1}", levels[k] < SAME_LEVELS < nearest)
        check(f"{film} begins with its poster", of_film[k] < nearest_of_film)


def main(program, examples, is_quick):
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        (folder / "wobble.toml").write_text(scene_text(examples))
        for output in ("lecture.pptx", "again.pptx"):
            subprocess.run([program, "render", "wobble.toml", "-o", output, "--size", "320x180" if is_quick else f"{WIDTH}x{HEIGHT}",
                            "--fps", "10", "--quiet"], cwd=folder, check=True)
        check("no other files", sorted(path.name for path in folder.iterdir()) == ["again.pptx", "lecture.pptx", "wobble.toml"])
        check("the same bytes", (folder / "lecture.pptx").read_bytes() == (folder / "again.pptx").read_bytes())
        with zipfile.ZipFile(folder / "lecture.pptx") as archive:
            check_package(archive)
            media = check_slides(archive)
        if not is_quick:
            check_drawn(folder, media)
    return 1 if n_failed else 0


if __name__ == "__main__":
    sys.exit(main(str(pathlib.Path(sys.argv[1]).resolve()), pathlib.Path(sys.argv[2]), "--quick" in sys.argv))
