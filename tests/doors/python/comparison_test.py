"""Comparisons of pictures of any renderer."""
import os

import numpy as np
import pytest

import poinsot

GREY = np.full((6, 8), 100, np.uint8)


def changed(picture, level, at=(0, 0)):
    copy = picture.copy()
    copy[at] = level
    return copy


def test_the_numbers_of_a_comparison_are_those_of_the_arrays():
    random = np.random.default_rng(39)
    a = random.integers(0, 256, (20, 30, 4), np.uint8)
    b = a.copy()
    b[3:9, 4:7, 1] = random.integers(0, 256, (6, 3), np.uint8)
    b[15, 2, 3] ^= 1
    differences = np.abs(a.astype(int) - b).max(axis=2)
    found = poinsot.compare(a, b, over_levels=2)
    assert not found and not found.passes
    assert found.outcome == "pixels" and "pixels differ" in found.reason and str(found) == f"pixels: {found.reason}"
    assert found.n_pixels == 600
    assert found.n_differing == np.count_nonzero(differences)
    assert found.n_over_level == np.count_nonzero(differences > 2)
    assert found.largest_difference == differences.max()
    assert found.ssim is None and found.flip is None and found.changes is None
    measured = poinsot.compare(a, b, measures=True)
    assert 0 < measured.flip < 0.5 < measured.ssim < 1, measured
    shown = found.difference
    assert shown.shape == (20, 90, 4) and shown.dtype == np.uint8
    np.testing.assert_array_equal(shown[:, :30, :3], a[:, :, :3])
    np.testing.assert_array_equal(shown[:, 60:, :3], b[:, :, :3])
    assert found._repr_png_().startswith(b"\x89PNG")


def test_equal_pictures_pass_in_every_form(tmp_path):
    image = pytest.importorskip("PIL.Image")
    colour = np.random.default_rng(1).integers(0, 256, (6, 8, 3), np.uint8)
    opaque = np.dstack([colour, np.full((6, 8), 255, np.uint8)])
    image.fromarray(colour).save(tmp_path / "rgb.png")
    image.fromarray(opaque).save(str(tmp_path / "rgba.png"))
    forms = [colour, opaque, colour / 255.0, (colour / 255.0).astype(np.float32), image.fromarray(colour), image.fromarray(opaque),
             tmp_path / "rgb.png", str(tmp_path / "rgba.png"), np.asfortranarray(colour), colour[::-1][::-1], colour.tolist()]
    forms[-1] = np.array(forms[-1], np.uint8)
    for a in forms:
        for b in forms:
            found = poinsot.compare(a, b)
            assert found and found.outcome == "same" and found.reason == "" and found.difference is None
            assert found.n_differing == 0 and found.largest_difference == 0
    for form in forms:
        assert not poinsot.compare(form, changed(colour, 255 - colour[2, 3], (2, 3)))


def test_grey_is_its_colour_and_a_mask_is_black_and_white():
    assert poinsot.compare(GREY, np.repeat(GREY[:, :, None], 3, axis=2))
    assert poinsot.compare(GREY > 50, np.full((6, 8), 255, np.uint8))
    assert not poinsot.compare(GREY > 50, GREY)


def test_a_picture_with_a_palette_is_compared_by_its_colours():
    image = pytest.importorskip("PIL.Image")
    picture = image.new("P", (8, 6))
    picture.putpalette([10, 20, 30] + [0] * 765)
    assert poinsot.compare(picture, np.full((6, 8, 3), (10, 20, 30), np.uint8))
    grey_alpha = image.new("LA", (8, 6), (100, 255))
    assert poinsot.compare(grey_alpha, GREY)
    assert not poinsot.compare(image.new("LA", (8, 6), (100, 254)), GREY)


def test_a_still_is_compared_with_its_file_and_with_another(tmp_path):
    scene = poinsot.Scene("sphere")
    still = scene.still(0.0, size=(64, 36))
    still.save(tmp_path / "still.png")
    assert poinsot.compare(still, tmp_path / "still.png")
    assert poinsot.compare(tmp_path / "still.png", still.pixels)
    found = poinsot.compare(still, scene.still(0.0, size=(64, 36), theme="dark"))
    assert not found
    assert any("theme" in change for change in found.changes)


EDGE = np.repeat(np.array([[0, 0, 0, 100, 255, 255]], np.uint8), 6, axis=0)


@pytest.mark.parametrize("limits, passes, pair", [
    ({}, False, None),
    ({"ignore": None}, False, None),
    ({"max_differing": 1 / 48, "max_over": 0, "over_levels": 3}, True, None),
    ({"max_differing": "2%", "max_over": 1}, False, None),  # 1 of 48 is 2.1 %
    ({"max_differing": np.float64(1), "max_over": np.float32(1), "over_levels": np.int64(0)}, True, None),
    ({"max_flip": 1}, True, None),
    ({"min_ssim": -1}, True, None),
    ({"profile": "native"}, True, (np.zeros((40, 40), np.uint8), changed(np.zeros((40, 40), np.uint8), 1))),
    ({"ignore": "0,0,1,1"}, True, None),
    ({"ignore": ["1,0,1,1", "0,0,10%,10%"]}, True, None),
    ({"antialiasing": True}, True, (EDGE, np.where(EDGE == 100, np.uint8(140), EDGE))),
    ({"max_differing": 1, "max_over": 1}, False, (GREY, GREY[:, :7])),  # of another size
])
def test_each_limit_decides(limits, passes, pair):
    found = poinsot.compare(*(pair or (GREY, changed(GREY, 103))), **limits)  # one pixel of 48 by 3 levels
    assert bool(found) is passes
    assert found.outcome == ("within limits" if passes else "size" if pair else "pixels")


def write_grey(file, level=100):
    file.parent.mkdir(exist_ok=True)
    file.write_bytes(poinsot.comparison.png_bytes("grey", np.full((4, 4), level, np.uint8)))


def test_pictures_are_approved_and_compared_as_the_files_beside_them_say(tmp_path):
    results, baselines = tmp_path / "results", tmp_path / "baselines"
    baseline = baselines / "a.png"
    write_grey(results / "a.png")
    with pytest.raises(poinsot.InputError, match="has no record of how it was made"):
        poinsot.approve("a", results=results, baselines=baselines, why="new")
    assert poinsot.approve("a", results=results, baselines=baselines, why='the "first"', foreign=True) == {"a": "new"}
    assert 'why = "the \\"first\\""' in (baselines / "manifest.toml").read_text()
    assert poinsot.approve(["a"], results=results, baselines=baselines, foreign=True) == {"a": "unchanged"}
    (baselines / "compare.toml").write_text("max_differing = 1\nover_levels = 1\nmax_over = 0\n")
    assert poinsot.compare(baseline, np.full((4, 4), 101, np.uint8))
    assert not poinsot.compare(baseline, np.full((4, 4), 102, np.uint8))
    write_grey(baseline, 101)
    assert poinsot.compare(baseline, np.full((4, 4), 101, np.uint8)).outcome == "baseline"
    with pytest.raises(poinsot.InputError, match="results: give the folder"):
        poinsot.approve("a", baselines=baselines)
    assert poinsot.approve("a", baselines=baselines, remove=True) == {"a": "removed"} and not baseline.exists()


def test_a_report_stays_out_of_what_is_compared(tmp_path):
    for folder, level in (("a", 100), ("b", 110)):
        (tmp_path / folder).mkdir()
        poinsot.pictures.write_file(tmp_path / folder / "p.png", poinsot.comparison.png_bytes("p", GREY + np.uint8(level - 100)))
    before = sorted(tmp_path.rglob("*"))
    a, b = tmp_path / "a", tmp_path / "b"
    for report in (a / "report.html", b / "report.html"):
        with pytest.raises(poinsot.InputError, match="^report .*: lies in a folder that is compared.* or give single_file$"):
            poinsot.compare_folders(a, b, report=report)
    for junit in (a / "p.png", b / "p.png"):
        with pytest.raises(poinsot.InputError, match="^junit .*: is one of the pictures compared"):
            poinsot.compare_folders(a, b, junit=junit)
    with pytest.raises(poinsot.InputError, match="^single_file says how report writes its page"):
        poinsot.compare_folders(a, b, single_file=True)
    assert sorted(tmp_path.rglob("*")) == before
    found = poinsot.compare_folders(a, b, report=a / "report.html", single_file=True, junit=tmp_path / "tests.xml")
    assert [one.outcome for one in found] == ["pixels"]
    assert not (a / "report_pictures").exists() and "data:image/png" in (a / "report.html").read_text()
    assert '<failure type="pixels"' in (tmp_path / "tests.xml").read_text()


def test_folders_are_compared_worst_first_with_a_report(tmp_path):
    """Names that are not UTF-8 come as os.fsdecode gives them."""
    name = os.fsdecode(b"\xff")
    for folder, levels in (("a", {name: 100, "little": 100, "much": 100, "gone": 100}),
                           ("b", {name: 100, "little": 101, "much": 200, "new": 100})):
        for picture, level in levels.items():
            write_grey(tmp_path / folder / f"{picture}.png", level)
    found = poinsot.compare_folders(tmp_path / "a", tmp_path / "b", report=tmp_path / "report.html", title="Two <folders>")
    assert [(one.name, one.outcome) for one in found] == [
        ("gone", "missing"), ("much", "pixels"), ("little", "pixels"), ("new", "unexpected"), (name, "same")]
    page = (tmp_path / "report.html").read_text(encoding="utf-8")
    assert "Two &lt;folders&gt;" in page and "\N{REPLACEMENT CHARACTER}" in page
    limited = poinsot.compare_folders(tmp_path / "a", tmp_path / "b", max_differing=1, max_over=0, over_levels=1)
    assert [one.name for one in limited if one] == ["little", name]


@pytest.mark.parametrize("picture, sentence", [
    (np.zeros((4, 4, 2), np.uint8), "a picture has the shape"),
    (np.zeros((4, 4, 5), np.uint8), "a picture has the shape"),
    (np.zeros((1, 4, 4, 4), np.uint8), "a picture has the shape"),
    (np.zeros(4, np.uint8), "a picture has the shape"),
    (np.zeros((0, 4), np.uint8), "a picture has the shape"),
    (np.zeros((4, 4), np.int32), "8-bit values or floats"),
    (np.zeros((4, 4), np.uint16), "8-bit values or floats"),
    (np.zeros((4, 4), complex), "8-bit values or floats"),
    (np.full((4, 4), 2.0), "floats are taken as 0 to 1"),
    (np.full((4, 4), -0.1), "floats are taken as 0 to 1"),
    (np.full((4, 4), np.nan), "floats are taken as 0 to 1"),
    (np.broadcast_to(np.uint8(0), (70_000, 2)), "1 to 65536 pixels"),
    (None, "8-bit values or floats"),
    (object(), "8-bit values or floats"),
    ([[1], [1, 2]], "not a picture"),
    ("none.png", "none.png: no such file"),
    ("none\0.png", "no file's name contains NUL"),
    (os.fsdecode(b"\xff.png"), "not valid UTF-8"),
    (np.ma.array(GREY, mask=GREY == 100), "some values are masked"),
    (__file__, "not a PNG"),
])
def test_what_is_no_picture_is_refused_on_either_side(picture, sentence):
    for pair in ((GREY, picture), (picture, GREY)):
        with pytest.raises(poinsot.InputError, match=sentence):
            poinsot.compare(*pair)


def test_names_that_are_not_valid_are_refused_before_anything_is_written(tmp_path):
    write_grey(tmp_path / "a" / "a.png")
    before = sorted(tmp_path.rglob("*"))
    a = tmp_path / "a"
    for wrong, sentence in (
        (lambda: poinsot.compare_folders(a, a, report=tmp_path / "report.pdf"), "a page ends in .html"),
        (lambda: poinsot.compare_folders(a, a, report="-"), "a page ends in .html"),
        (lambda: poinsot.compare_folders(a, a, report=f"{tmp_path}/r\0.html"), "contains NUL"),
        (lambda: poinsot.compare_folders(a, f"{tmp_path}/b\0"), "contains NUL"),
        (lambda: poinsot.compare_folders(a, a, title="\ud800"), "title: not valid Unicode"),
        (lambda: poinsot.approve("a\0", results=a, baselines=tmp_path / "b", why="new"), "contains NUL"),
        (lambda: poinsot.approve("a", results=a, baselines=f"{tmp_path}/b\0", why="new"), "contains NUL"),
        (lambda: poinsot.approve("a", results=a, baselines=tmp_path / "b", why="\ud800"), "why: not valid Unicode"),
        (lambda: poinsot.approve("a", results=a, baselines=tmp_path / "b", why=3), "why: is a text, and this is 3"),
    ):
        with pytest.raises(poinsot.InputError, match=sentence):
            wrong()
    assert sorted(tmp_path.rglob("*")) == before


@pytest.mark.parametrize("limits, sentence", [
    ({"max_differing": 2}, "max_differing: 2: not a share of the pixels"),
    ({"max_differing": float("nan")}, "max_differing: nan: not a share of the pixels"),
    ({"over_levels": 256}, "256: not a level"),
    ({"over_levels": 2.5}, "over_levels: is a whole number, and this is 2.5"),
    ({"over_levels": 10**30}, "over_levels: is a whole number"),
    ({"max_flip": "0.1"}, "max_flip: is a number, and this is '0.1'"),
    ({"antialiasing": "yes"}, "antialiasing: is True or False, and this is 'yes'"),
    ({"ignore": "nothing"}, 'unknown region "nothing"'),
    ({"ignore": [3]}, "ignore: a region is a text, and this is 3"),
    ({"profile": "exact"}, "profile: exact: unknown; choose portable or native"),
    ({"profile": 5}, "profile: is portable or native, and this is 5"),
    ({"ignore": 5}, "ignore: is a region or a list of regions, and this is 5"),
    ({"max_flip": b"0.1"}, "max_flip: is a number, and this is b'0.1'"),
    ({"max_flip": np.array([0.1, 0.2])}, "max_flip: is a number, and this is "),
    ({"max_flip": 1j}, "max_flip: is a number, and this is 1j"),
])
def test_wrong_limits_are_refused(limits, sentence):
    with pytest.raises(poinsot.InputError, match=sentence):
        poinsot.compare(GREY, GREY, **limits)
    with pytest.raises(TypeError):
        poinsot.compare(GREY, GREY, max_flop=1)
