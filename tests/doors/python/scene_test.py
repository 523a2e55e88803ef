"""Scenes: their numbers and pictures are those of the program, and their errors say where."""
import enum
import os
import pathlib
import pickle
import subprocess

import numpy as np
import pytest

import poinsot
from conftest import SCENES

GENERIC = str(SCENES / "generic.toml")
TINY = (64, 36)


def bits(values):
    return np.ascontiguousarray(values).view(np.int64)


def columns_of(csv):
    """The columns of the program's CSV, which gives each double back."""
    heading, *rows = csv.decode().splitlines()
    numbers = np.array([[float(text) for text in row.split(",")] for row in rows]).reshape(len(rows), -1)
    return dict(zip(heading.split(","), numbers.T))


@pytest.mark.parametrize("name, columns", [
    ("generic", None),
    ("measured", None),
    ("generic", ["time", "kinetic_energy", "contact_space"]),
    ("heavy_top_looping", ["time", "euler"]),
    ("euler_drift", ["kinetic_energy", "omega_body"]),
])
def test_the_digits_of_a_sample_are_those_of_the_command(program, name, columns):
    file = SCENES / f"{name}.toml"
    times = [0.0, 0.125, 1.0, 1.0 / 3.0, 7.25]
    named = ["--columns", ",".join(columns)] if columns else []
    expected = columns_of(program("sample", file, "--times", ",".join(map(repr, times)), *named))
    found = poinsot.Scene(file).sample(times, columns)
    assert list(found) == list(expected)
    for column, values in expected.items():
        np.testing.assert_array_equal(bits(found[column]), bits(values), err_msg=column)


@pytest.mark.parametrize("times", [2.0, 2, np.float32(2), [], [1, 2, 3], np.linspace(0, 1, 6).reshape(2, 3), np.zeros((0, 4)),
                                   np.linspace(0, 1, 24).reshape(2, 3, 4).T, np.linspace(0, 1, 10)[::3]],
                         ids=lambda times: f"{type(times).__name__}{np.shape(times)}")
def test_columns_have_the_shape_of_the_times_and_are_contiguous(times):
    sampled = poinsot.Scene("generic").sample(times)
    np.testing.assert_array_equal(sampled["time_s"], np.asarray(times, np.float64))
    for column in sampled.values():
        assert column.shape == np.shape(times)
        assert column.dtype == np.float64 and column.flags.c_contiguous
    assert sampled["omega_body"].shape == np.shape(times) + (3,)
    assert sampled["q"].shape == np.shape(times) + (4,)
    np.testing.assert_array_equal(sampled["omega_body"][..., 1], sampled["omega_body_2"])
    np.testing.assert_allclose((sampled["q"] ** 2).sum(axis=-1), 1.0, rtol=1e-14)


def test_an_unknown_quantity_of_a_sample_names_the_columns():
    with pytest.raises(KeyError, match="omega: not a column; there are time_s, omega_body_1"):
        poinsot.Scene("generic").sample([0.0])["omega"]


def test_a_sample_becomes_a_data_frame():
    pytest.importorskip("pandas")
    sampled = poinsot.Scene("generic").sample([0.0, 1.0])
    frame = sampled.to_pandas()
    assert list(frame.columns) == list(sampled) and len(frame) == 2
    np.testing.assert_array_equal(frame["omega_body_1"].to_numpy(), sampled["omega_body_1"])


@pytest.mark.parametrize("arguments, options", [
    ((), {"size": "96x54"}),
    ((1.5,), {"size": "96x54", "quality": "draft"}),
    (("auto",), {"size": "96x54", "theme": "dark"}),
    ((), {"width_mm": 85, "dpi": 100, "type_pt": 9}),
], ids=["scene's instant", "instant", "clearest", "paper"])
def test_a_still_is_the_file_of_the_command(program, tmp_path, arguments, options):
    given = {"time": arguments[0] if arguments else None, **options}
    command = [word for name, value in given.items() if value is not None for word in ("--" + name.replace("_", "-"), value)]
    program("still", GENERIC, *command, "-o", tmp_path / "still.png")
    still = poinsot.Scene(GENERIC).still(*arguments, portable=False, **options)
    assert still.png == (tmp_path / "still.png").read_bytes()


def test_the_pixels_of_a_still_are_those_of_its_png():
    image = pytest.importorskip("PIL.Image")
    import io

    still = poinsot.Scene("generic").still(size=TINY)
    np.testing.assert_array_equal(still.pixels, np.asarray(image.open(io.BytesIO(still.png)).convert("RGBA")))
    np.testing.assert_array_equal(np.asarray(still), still.pixels)
    assert still.pixels.shape == TINY[::-1] + (4,) and still.pixels.dtype == np.uint8
    assert len(np.unique(still.pixels.reshape(-1, 4), axis=0)) > 10  # it shows something


def test_a_figure_is_the_file_of_the_command(program, tmp_path):
    figure = poinsot.Scene(GENERIC).figure(1.5, size=(320, 180))
    for suffix, contents in (("svg", figure.svg.encode()), ("pdf", figure.pdf)):
        program("still", GENERIC, "--time", "1.5", "--size", "320x180", "-o", tmp_path / f"figure.{suffix}")
        assert contents == (tmp_path / f"figure.{suffix}").read_bytes()


def test_a_figure_and_a_still_keep_what_the_command_says(program, tmp_path):
    def said_by(*options):
        command = [os.environ["POINSOT"], "still", GENERIC, "--time", "1.5", *map(str, options)]
        return subprocess.run(command, capture_output=True, text=True, check=True).stderr

    scene = poinsot.Scene(GENERIC)
    figure = scene.figure(1.5, size=(160, 90))
    said = said_by("--size", "160x90", "-o", tmp_path / "figure.svg")
    assert [line for line in said.splitlines() if "figure.svg" not in line] == figure.notes
    still = scene.still(1.5, size=(160, 90))
    assert still.notes and still.report is None and figure.report is None
    for drawn, suffix in ((scene.figure(1.5, journal="aps"), "pdf"), (scene.still(1.5, journal="aps"), "png")):
        assert drawn.report.startswith("size: ")
        # With the name of the keyword in place of the option's.
        assert drawn.report in said_by("--journal", "aps", "-o", tmp_path / f"picture.{suffix}").replace("--keep-text", "keep_text")


@pytest.mark.parametrize("name", ["turn.mp4", "turn_####.png"])
def test_a_film_is_the_file_of_the_command(program, tmp_path, name):
    (tmp_path / "command").mkdir()
    (tmp_path / "module").mkdir()
    program("render", GENERIC, "--size", "64x36", "--frames", "0-9", "-o", tmp_path / "command" / name)
    film = poinsot.Scene(GENERIC).render(tmp_path / "module" / name, size=TINY, frames=(0, 9), progress=False)
    expected = {file.name: file.read_bytes() for file in (tmp_path / "command").iterdir()}
    assert {file.name: file.read_bytes() for file in (tmp_path / "module").iterdir()} == expected
    assert len(expected) == (10 if "#" in name else 1)
    assert film.path == str(tmp_path / "module" / name)


def test_a_scene_is_a_path_a_name_a_text_or_tables():
    text = pathlib.Path(GENERIC).read_text(encoding="utf-8")
    tables = {"body": {"moments_kg_m2": np.array([1.0, 2.0, 3.0])}, "start": {"omega_rad_s": (0.1, np.float64(2.0), 0)}}
    same_text = "[body]\nmoments_kg_m2 = [1.0, 2.0, 3.0]\n[start]\nomega_rad_s = [0.1, 2.0, 0]\n"
    for a, b in ((GENERIC, pathlib.Path(GENERIC)), (GENERIC, "generic"), (GENERIC, text), (tables, same_text)):
        left, right = poinsot.Scene(a).sample([0.0, 1.0]), poinsot.Scene(b).sample([0.0, 1.0])
        for column in left:
            np.testing.assert_array_equal(bits(left[column]), bits(right[column]))
    assert poinsot.Scene(GENERIC).name == poinsot.Scene("generic").name == "generic"
    assert poinsot.Scene(text).text == text
    assert set(poinsot.scenes()) == {file.stem for file in SCENES.glob("*.toml")}


def test_set_changes_a_copy():
    scene = poinsot.Scene(GENERIC)
    changed = scene.set({"start.omega_rad_s": [0.1, 2.0, 0.3]}).set({"body.moments_kg_m2": np.array([1.0, 2.0, 2.5])})
    assert scene.values == []
    assert changed.values == ["start.omega_rad_s=[0.1, 2.0, 0.3]", "body.moments_kg_m2=[1.0, 2.0, 2.5]"]
    np.testing.assert_array_equal(changed.sample(0.0)["omega_body"], [0.1, 2.0, 0.3])


def test_check_says_what_the_command_says(program):
    import json

    assert poinsot.Scene(GENERIC).check() == json.loads(program("check", GENERIC, "--json"))


def test_an_input_error_says_file_line_and_column(tmp_path):
    file = tmp_path / "wrong.toml"
    file.write_text("[body]\nmoments_kg_m2 = [1, 2, 3]\n\n[start]\n  omega = [1, 2, 3]\n")
    with pytest.raises(poinsot.InputError) as caught:
        poinsot.Scene(file)
    error = caught.value
    assert (error.file, error.line, error.column) == (str(file), 5, 3)
    assert str(error).startswith(f'{file}:5:3: unknown key "omega"')
    assert "\n" not in str(error)
    assert isinstance(error, ValueError) and isinstance(error, poinsot.Error)

    with pytest.raises(poinsot.InputError) as caught:
        poinsot.Scene("generic").set({"film.sise": 3})
    assert (caught.value.file, caught.value.line, caught.value.column) == ("set film.sise=3", None, None)
    assert str(caught.value) == 'set film.sise=3: unknown key "film.sise"; did you mean "film.size"?'


def test_errors_survive_pickling():
    with pytest.raises(poinsot.InputError) as caught:
        poinsot.Scene("[body]\nmoment = 3\n")
    copy = pickle.loads(pickle.dumps(caught.value))
    assert type(copy) is poinsot.InputError and str(copy) == str(caught.value)
    assert (copy.file, copy.line, copy.column) == ("scene.toml", 2, 1)
    with pytest.raises(poinsot.EnvironmentError) as no_folder:
        poinsot.Scene("generic").render("/nowhere/at/all.mp4", size=TINY, frames=(0, 0), progress=False)
    copy = pickle.loads(pickle.dumps(no_folder.value))
    assert type(copy) is poinsot.EnvironmentError and str(copy) == str(no_folder.value)
    assert isinstance(copy, RuntimeError) and not isinstance(copy, ValueError)


@pytest.mark.parametrize("wrong, sentence", [
    (lambda s: s.sample([0.0, np.nan]), "times nan: .* not finite"),
    (lambda s: s.sample("soon"), "times: numbers are needed, and these are of type <U4"),
    (lambda s: s.sample([True]), "times: numbers are needed, and these are of type bool"),
    (lambda s: s.sample([10**400]), "times: numbers are needed"),
    (lambda s: s.sample([[1], [2, 3]]), "times: not an array of numbers"),
    (lambda s: s.sample([0.0], [1]), "columns: give names of columns"),
    (lambda s: s.sample([0.0], 5), "columns: give names of columns"),
    (lambda s: s.sample([0.0], ["\ud800"]), "columns: not valid Unicode"),
    (lambda s: s.sample(np.ma.array([0.0, 1.0], mask=[False, True])), "times: some values are masked"),
    (lambda s: s.still(backend=3), "backend: choose auto, osmesa, egl or gpu, and this is 3"),
    (lambda s: s.still(portable="yes"), "portable: is True or False, and this is 'yes'"),
    (lambda s: s.still(theme="\ud800"), "theme: not valid Unicode"),
    (lambda s: s.still(theme=3), "theme: is a text, and this is 3"),
    (lambda s: s.render("film\0.mp4"), r"'film\\x00.mp4': no file's name contains NUL"),
    (lambda s: s.render(b"film.mp4"), "b'film.mp4' is not a text"),
    (lambda s: s.render(os.fsdecode(b"\xff.mp4")), "not valid UTF-8; rename the file"),
    (lambda s: s.render(3), "3 is not the name of a file"),
    (lambda s: s.slides("deck\0"), "contains NUL"),
    (lambda s: s.still(size=TINY).save("still\0.png"), "contains NUL"),
    (lambda s: s.figure(size=TINY).save("figure\0.svg"), "contains NUL"),
    (lambda s: poinsot.Page("", 1, 1, None).save("page\0.html"), "contains NUL"),
    (lambda s: s.sample([0.0], ["time"] * 100_000), "given twice"),
    (lambda s: s.still(size=(10**30, 1)), "give width and height in pixels"),
    (lambda s: s.still(size=(64.5, 36)), "not a size in pixels"),
    (lambda s: s.still(size=(np.nan, 36)), "not a size in pixels"),
    (lambda s: s.still(size=(np.inf, 36)), "not a size in pixels"),
    (lambda s: s.still(size=3), "not a size in pixels"),
    (lambda s: s.still(np.nan), "not finite"),
    (lambda s: s.still("soon"), "not an instant in seconds"),
    (lambda s: s.still([1.0, 2.0]), "one instant"),
    (lambda s: s.still(width_mm=np.nan), "^width_mm nan: .* millimetres"),
    (lambda s: s.still(width_mm="wide"), "width_mm: is a number, and this is 'wide'"),
    (lambda s: s.still(journal="diary"), "unknown journal"),
    (lambda s: s.still(quality="best"), "unknown quality"),
    (lambda s: s.render(""), "no name"),
    (lambda s: s.render("film.mp4", frames=(5, 1)), "frames 5 to 1: not a range of frames"),
    (lambda s: s.render("film.mp4", frames=(0, 10**30)), "not a range of frames"),
    (lambda s: s.render("film.mp4", frames=3), "not a range of frames"),
    (lambda s: s.render("film.mp4", frames=(0.5, 1)), "not a range of frames"),
    (lambda s: s.render("film.mp4", frames=range(0)), "not a range of frames"),
    (lambda s: s.render("film.mp4", frames=range(0, 9, 2)), "not a range of frames"),
    (lambda s: s.render("film.mp4", frames=range(5, 0, -1)), "not a range of frames"),
    (lambda s: s.render("page.html"), r"\.page\("),
    (lambda s: s.slides(""), "no name"),
    (lambda s: s.page("page.pdf"), "a page ends in .html"),
    (lambda s: s.set({3: 1}), "not a key"),
    (lambda s: s.set(), "values: is a dict of keys and values"),
    (lambda s: s.set({"title": None}), "title: None is no value"),
    (lambda s: s.set({"title": object()}), "cannot stand in a scene"),
    (lambda s: s.set({"title": "\ud800"}), "values: not valid Unicode"),
    (lambda s: poinsot.Scene("generic", [("a", 1)]), "values: is a dict of keys and values, and this is of type list"),
    (lambda s: poinsot.Scene(os.fsdecode(b"\xff.toml")), "not valid UTF-8"),
    (lambda s: poinsot.Scene("generic\0.toml"), "contains NUL"),
    (lambda s: poinsot.Scene("generik"), 'did you mean "generic"'),
    (lambda s: poinsot.Scene({3: 1}), "a scene's keys are texts, not int"),
    (lambda s: poinsot.Scene(3), "a file, a text, a dict or a Motion"),
    (lambda s: poinsot.Scene("a = \udc80"), "not valid Unicode"),
    (lambda s: poinsot.Scene("a = 1\0"), "control character"),
    (lambda s: poinsot.Scene({"body": {"moments_kg_m2": [1, 2, float("nan")]}}), "finite"),
    (lambda s: poinsot.Scene({"title": "x" * 10_000_000}), ""),
])
def test_wrong_input_is_refused_with_one_line(monkeypatch, tmp_path, wrong, sentence):
    monkeypatch.chdir(tmp_path)
    scene = poinsot.Scene("sphere")
    with pytest.raises(poinsot.InputError, match=sentence) as caught:
        wrong(scene)
    assert "\n" not in str(caught.value)
    assert list(tmp_path.iterdir()) == []


def test_a_folder_does_not_hide_a_scene_of_the_package(monkeypatch, tmp_path):
    monkeypatch.chdir(tmp_path)
    (tmp_path / "generic").mkdir()
    assert poinsot.Scene("generic").text == pathlib.Path(GENERIC).read_text(encoding="utf-8")


def test_numbers_of_any_kind_are_written_as_the_number():
    class Number(int):
        def __repr__(self):
            return "1\ntitle = 'another'"
        __str__ = __repr__

    class Real(float):
        __repr__ = __str__ = Number.__repr__

    class Axis(enum.IntEnum):
        LAST = 3

    values = {"a": Number(7), "b": Real(0.5), "c": Axis.LAST, "d": [Axis.LAST], "e": {"f": Number(7)}, "g": np.True_, "h": -np.inf}
    assert poinsot.toml.assignments(values) == ["a=7", "b=0.5", "c=3", "d=[3]", "e.f=7", "g=true", "h=-inf"]
    assert poinsot.toml.scene_text(values) == "a = 7\nb = 0.5\nc = 3\nd = [3]\ng = true\nh = -inf\n[e]\nf = 7\n"


def test_keys_without_a_value_are_left_out_of_every_table():
    tables = {"a": None, "b": {"c": None, "d": 1}, "e": [{"f": None, "g": 2}], "h": [1, {"i": None, "j": 3}]}
    assert poinsot.toml.scene_text(tables) == "h = [1, {j = 3}]\n[b]\nd = 1\n[[e]]\ng = 2\n"
    assert poinsot.toml.assignments({"film": {"size": None, "fps": 30}}) == ["film.fps=30"]


def test_every_form_of_a_change_sets_the_same_values():
    dotted = poinsot.Scene("generic").set({"theme": "dark", "camera.elevation_deg": 10, "camera.azimuth_deg": 20.0})
    nested = {"theme": "dark", "camera": {"elevation_deg": 10, "azimuth_deg": 20.0}}
    for same in (poinsot.Scene("generic").set(nested), poinsot.Scene("generic").set(**nested), poinsot.Scene("generic", nested),
                 poinsot.Scene("generic").set({"theme": "dark"}, camera=nested["camera"])):
        assert same.values == dotted.values and same == dotted and hash(same) == hash(dotted)
    # The other values of the table stay.
    assert dotted.check()["film_s"] == poinsot.Scene("generic").check()["film_s"]


def test_scenes_are_equal_if_all_that_they_were_made_of_is():
    scene = poinsot.Scene("generic")
    assert scene == poinsot.Scene("generic") and len({scene, poinsot.Scene("generic")}) == 1
    for other in (scene.set(theme="dark"), poinsot.Scene("sphere"), poinsot.Scene("generic", allow_outside=True), 3, None):
        assert scene != other


def test_a_range_of_frames_is_its_first_and_last(tmp_path):
    scene = poinsot.Scene("generic")
    for frames, folder in (((2, 4), "pair"), (range(2, 5), "range")):
        (tmp_path / folder).mkdir()
        scene.render(tmp_path / folder / "f_####.png", size=TINY, frames=frames, progress=False)
    written = {folder: {file.name: file.read_bytes() for file in (tmp_path / folder).glob("*.png")} for folder in ("pair", "range")}
    assert len(written["pair"]) == 3 and written["pair"] == written["range"]


def test_scenes_and_results_can_be_sent_to_another_process_as_the_documentation_says():
    scene = poinsot.Scene("sphere").set({"start.omega_rad_s": [0.5, 0.6, 0.7]})
    same = pickle.loads(pickle.dumps(scene))
    assert same == scene and (same.name, same.text, same.values) == (scene.name, scene.text, scene.values)
    still = scene.still(size=TINY)
    sampled = scene.sample([0.0, 1.0])
    copied = pickle.loads(pickle.dumps(sampled))
    assert type(copied) is poinsot.Samples and list(copied) == list(sampled)
    np.testing.assert_array_equal(copied["omega_body"], same.sample([0.0, 1.0])["omega_body"])
    compared = poinsot.compare(still, 255 - still.pixels)
    assert pickle.loads(pickle.dumps(compared)) == compared
    assert pickle.loads(pickle.dumps(poinsot.Film("a.mp4", ["note"]))).notes == ["note"]
    assert pickle.loads(pickle.dumps(poinsot.Page("text", 1, 1, None))).html == "text"
    for drawn in (still, scene.figure(size=TINY)):
        with pytest.raises((TypeError, AttributeError, pickle.PicklingError)):
            pickle.dumps(drawn)
