"""What a notebook shows and stores for each value of the package, and the files that it saves."""
import os
import pathlib
import re
import struct
import sys
import urllib.parse

import pytest

import poinsot
from pages import writes_pages

SMALL = {"film.size": [320, 180]}
TINY = (64, 36)


@pytest.fixture(autouse=True)
def in_a_folder(monkeypatch, tmp_path):
    monkeypatch.chdir(tmp_path)


needs_pages = pytest.mark.skipif(not writes_pages(), reason="the package was built without the module for browsers")


def test_a_scene_shows_itself_at_its_size_and_at_most_960_pixels_wide():
    for size, shown in (([320, 180], (320, 180)), ([3840, 2160], (960, 540))):
        assert struct.unpack(">II", poinsot.Scene("generic", {"film.size": size})._repr_png_()[16:24]) == shown


def test_saved_files_are_the_pictures():
    scene = poinsot.Scene("sphere")
    still, figure = scene.still(size=TINY), scene.figure(size=TINY)
    still.save("a.png")
    figure.save("a.svg")
    figure.save("a.pdf")
    assert pathlib.Path("a.png").read_bytes() == still.png == still._repr_png_()
    assert pathlib.Path("a.svg").read_text(encoding="utf-8") == figure.svg == figure._repr_svg_()
    assert pathlib.Path("a.pdf").read_bytes() == figure.pdf
    for save in (still.save, figure.save):
        with pytest.raises(poinsot.InputError, match="end its name in"):
            save("a.jpg")
    with pytest.raises(poinsot.EnvironmentError, match="nowhere"):
        still.save("nowhere/a.png")


def test_a_file_may_be_called_as_the_standard_output(capfdbinary):
    poinsot.pictures.write_file("-", b"contents")
    assert pathlib.Path("-").read_bytes() == b"contents"
    assert capfdbinary.readouterr().out == b""


TOLD = """[body]
moments_kg_m2 = [1.0, 2.0, 2.9]
[start]
omega_rad_s = [1.5, 0.3, 0.75]
[film]
size = [80, 44]
fps = 10
length_s = 0.5
[[stops]]
at_s = 0.3
[[captions]]
at_s = 0.1
text = "It rolls."
[[chapters]]
at_s = 0.0
title = "One"
"""


def state_of(folder):
    return {
        str(path): (path.lstat().st_mode, os.readlink(path) if path.is_symlink() else path.read_bytes() if path.is_file() else "")
        for path in sorted(pathlib.Path(folder).rglob("*"))
    }


def plant(kind, path):
    path.parent.mkdir(parents=True, exist_ok=True)
    if kind == "file":
        path.write_bytes(b"mine")
    elif kind == "folder":
        path.mkdir()
    elif kind == "link":
        pathlib.Path("victim").write_bytes(b"mine")
        path.symlink_to(os.path.abspath("victim"))
    elif kind == "link to nothing":
        path.symlink_to("nothing")
    else:
        os.mkfifo(path)


@pytest.mark.parametrize("kind", ["file", "folder", "link", "link to nothing", "pipe"])
@pytest.mark.parametrize(
    "place, write",
    [
        ("o.vtt", lambda scene: scene.render("o.mp4", progress=False)),
        ("o.chapters.json", lambda scene: scene.render("o.mp4", progress=False)),
        ("o/index.html", lambda scene: scene.slides("o", progress=False)),
        ("o/2024.pdf", lambda scene: scene.slides("o", progress=False)),
        ("results_pictures/b-actual.png", lambda scene: poinsot.compare_folders("ref", "new", report="results.html")),
    ],
)
def test_files_of_others_beside_an_output_stay(kind, place, write):
    scene = poinsot.Scene(TOLD)
    for folder, instant in (("ref", 0.0), ("new", 0.3)):
        pathlib.Path(folder).mkdir()
        scene.still(size=TINY, time_s=instant).save(f"{folder}/b.png")
    plant(kind, pathlib.Path(place))
    before = state_of(".")
    with pytest.raises(poinsot.InputError, match=re.escape(pathlib.Path(place).name)):
        write(scene)
    assert state_of(".") == before


def test_slides_and_presentations_of_a_scene_are_written_again_after_a_change():
    for length in (0.5, 0.6):
        scene = poinsot.Scene(TOLD.replace("length_s = 0.5", f"length_s = {length}"))
        scene.slides("o", progress=False)
        scene.render("o.pptx", progress=False)
    other = poinsot.Scene('title = "Another"\n' + TOLD)
    for write in (lambda: other.slides("o", progress=False), lambda: other.render("o.pptx", progress=False)):
        with pytest.raises(poinsot.InputError, match="another scene"):
            write()


def test_a_short_film_is_stored_and_a_missing_one_is_not_shown():
    film = poinsot.Scene("generic", SMALL).render("film.mp4", frames=(0, 2), progress=False)
    assert 'src="data:video/mp4;base64,' in film._repr_html_()
    os.remove("film.mp4")
    assert film._repr_html_() is None


@pytest.mark.parametrize("suffix", ["gif", "mp4", "html"])
def test_a_notebook_links_to_a_file_of_any_name(monkeypatch, suffix):
    name = f"50% #1? \"a\" & ä.{suffix}"
    pathlib.Path(name).write_bytes(b"x")
    monkeypatch.setattr(poinsot.pictures, "most_inline_bytes", 0)
    shown = poinsot.Page("", 1, 1, name) if suffix == "html" else poinsot.Film(name, [])
    address = re.search("href=\"([^\"]*)\"" if suffix == "html" else "src=\"([^\"]*)\"", shown._repr_html_())[1]
    assert re.fullmatch(r"[\w.%-]+", address, re.ASCII)
    assert urllib.parse.unquote(address) == name


@needs_pages
def test_a_page_with_a_path_stores_its_poster_and_a_link_alone():
    page = poinsot.Scene("generic", SMALL).page("page.html")
    shown = page._repr_html_()
    assert len(shown) < 100_000
    assert '<a href="page.html"><img src="data:image/png;base64,' in shown
    assert "<script" not in shown
    assert pathlib.Path("page.html").read_text(encoding="utf-8") == page.html


@needs_pages
def test_a_page_without_a_path_starts_in_a_sandbox_and_holds_its_text_as_data():
    shown = poinsot.Scene("generic", {**SMALL, "title": "</script><b>"}).page()._repr_html_()
    assert "setAttribute('sandbox','allow-scripts')" in shown
    # One script element, whose text is JSON without a "<" that could end it.
    held = re.findall(r'<script type="application/json">(.*?)</script>', shown)
    assert len(held) == 1 and "<" not in held[0]
    assert shown.endswith("</script></div>")


def test_render_shows_its_progress_as_text_where_tqdm_is_missing(monkeypatch, capsys):
    for name in ("tqdm", "tqdm.auto"):
        monkeypatch.setitem(sys.modules, name, None)
    poinsot.Scene("generic", SMALL).render("film.mp4", frames=(0, 2))
    assert "generic: 100 %" in capsys.readouterr().err
