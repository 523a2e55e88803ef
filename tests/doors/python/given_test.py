"""What callers give: tables and times of other libraries, and one line about what cannot be used."""
import datetime
import itertools
import re

import numpy as np
import pytest

import poinsot
from poinsot.errors import shown

TIMES = np.arange(0.0, 4.0, 0.01)
OMEGA = poinsot.Motion([3.0, 2.0, 1.0], [0.3, 6.0, 0.2]).at(TIMES).omega_body
COLUMNS = {"Time (ms)": 1000 * TIMES, **{f"omega_{x}": OMEGA[:, k] for k, x in enumerate("xyz")}, "note": ["a\n,b"] * len(TIMES), "rate": 100}
MOTION = poinsot.Motion([3.0, 2.0, 1.0], [0.3, 6.0, 0.2])
SCENE = poinsot.Scene("sphere")


class Refusing:
    """No value of anything."""

    def __repr__(self):
        raise RuntimeError("no repr")


class Frame:
    """As much of a data frame as those of polars and others have in common."""

    def __init__(self, columns):
        self._columns = columns
        self.columns = list(columns)

    def __getitem__(self, name):
        return self._columns[name]


def record_array():
    names = ["time", "omega_x", "omega_y", "omega_z"]
    return np.rec.fromarrays([TIMES, *OMEGA.T], names=names)


@pytest.mark.parametrize("make", [
    lambda: COLUMNS,
    lambda: {**COLUMNS, "omega_x": list(OMEGA[:, 0])},
    lambda: Frame({name: column for name, column in COLUMNS.items() if name != "rate"}),
    record_array,
    lambda: np.array(record_array()),
    lambda: SCENE.__class__("generic").sample(TIMES) | dict(zip(("omega_body_1", "omega_body_2", "omega_body_3"), OMEGA.T)),
], ids=["dict", "dict of lists", "frame", "record array", "structured array", "samples"])
def test_a_table_in_memory_is_read_by_the_names_of_its_columns(make):
    found = poinsot.fit(make())
    np.testing.assert_allclose(found.omega, OMEGA, rtol=1e-12)
    np.testing.assert_allclose(found.times, TIMES, rtol=1e-12, atol=1e-12)
    assert len(poinsot.flights(make())[0]) == len(TIMES)
    another = poinsot.Motion([3.0, 2.0, 1.0], [0.9, -5.0, 0.4]).at(TIMES).omega_body
    assert poinsot.fit([make(), (TIMES, another)]).n_used == 2


def test_frames_of_polars_are_read_by_the_names_of_their_columns():
    polars = pytest.importorskip("polars")
    frame = polars.DataFrame({name: column for name, column in COLUMNS.items() if name != "rate"})
    np.testing.assert_allclose(poinsot.fit(frame).omega, OMEGA, rtol=1e-12)
    durations = frame.with_columns(polars.Series("t", [datetime.timedelta(milliseconds=10 * k) for k in range(len(TIMES))])).drop("Time (ms)")
    np.testing.assert_allclose(poinsot.fit(durations).times, TIMES, atol=1e-12)


def test_missing_values_of_nullable_columns_are_empty_cells():
    pandas = pytest.importorskip("pandas")
    frame = pandas.DataFrame({name: pandas.array(column, dtype="Float64") for name, column in COLUMNS.items() if name not in ("note", "rate")})
    np.testing.assert_allclose(poinsot.fit(frame).omega, OMEGA, rtol=1e-12)
    frame.loc[3, "omega_x"] = pandas.NA
    with pytest.raises(poinsot.InputError, match="the cell is empty"):
        poinsot.fit(frame)


def durations():
    """The instants of TIMES as other libraries hold them."""
    plain = [datetime.timedelta(milliseconds=10 * k) for k in range(len(TIMES))]
    yield plain
    yield np.array(10 * np.arange(len(TIMES)), dtype="timedelta64[ms]")
    try:
        import pandas
    except ImportError:
        return
    yield pandas.to_timedelta(plain)
    yield pandas.Series(plain)
    yield [pandas.Timedelta(one) for one in plain]


def test_differences_of_time_count_in_seconds():
    for given in durations():
        np.testing.assert_allclose(poinsot.fit(given, OMEGA).times, TIMES, atol=1e-12)
        np.testing.assert_allclose(MOTION.at(given).omega_body, OMEGA, atol=1e-9)
        np.testing.assert_allclose(SCENE.sample(given)["time_s"], TIMES, atol=1e-12)
        np.testing.assert_allclose(poinsot.fit({"when": given, **{f"omega_{x}": OMEGA[:, k] for k, x in enumerate("xyz")}}).times, TIMES, atol=1e-12)
        later = given[1] if isinstance(given, (list, np.ndarray)) else given.__getitem__(1)
        assert SCENE.still(later, size=(32, 18)).png == SCENE.still(0.01, size=(32, 18)).png
    ten = datetime.timedelta(seconds=10)
    assert MOTION.flips(datetime.timedelta(0), ten) == MOTION.flips(0.0, 10.0) == MOTION.flips(0.0, np.timedelta64(10, "s"))
    with pytest.raises(poinsot.InputError, match="times: these are dates; give seconds, or differences: subtract the first one"):
        poinsot.fit(np.datetime64("2026-01-01") + np.arange(400) * np.timedelta64(10, "ms"), OMEGA)
    with pytest.raises(poinsot.InputError, match="omega: numbers are needed"):
        poinsot.fit(TIMES, np.array(OMEGA, dtype="timedelta64[s]"))


@pytest.mark.parametrize("value, says", [
    (np.zeros((200, 3)), "of type ndarray, of shape (200, 3)"),
    ("a" * 500, "'" + "a" * 30),
    (list(range(10**6)), "[0, 1, 2"),
    ({"a": [1, 2]}, "{'a': [1, 2]}"),
    (Refusing(), "Refusing"),
    ("one\ntwo", r"'one\ntwo'"),
    (3, "3"),
])
def test_what_was_given_is_shown_in_a_part_of_a_line(value, says):
    said = shown(value)
    assert says in said and len(said) <= 80 and "\n" not in said


# Values that some caller gives in some place where it means nothing.
WRONG = [None, "", "x" * 3000, b"bytes", 3, -1, 10**400, float("inf"), float("nan"), True, 1j, (), [], [1, 2], {}, {"a": 1}, set(), object(),
         Refusing(), np.zeros(0), np.zeros((5, 5)), np.full(400, np.nan), np.array("text"), np.array([None, 1], dtype=object), np.timedelta64("NaT"),
         datetime.timedelta(1), datetime.datetime(2026, 1, 1), np.ma.masked_all(3), lambda: 0, poinsot.Scene, "\udc80", "a\0b", range(3),
         [[1, 2], [3]], {"times": [[1.0]], "omega": 3}, {"t": [1.0, 2.0], "x": [1.0]}]
try:
    import pandas
except ImportError:
    pass
else:
    WRONG += [pandas.Series(TIMES, name="time"), pandas.DataFrame(OMEGA), pandas.NaT, pandas.DataFrame({"time": TIMES})]

CALLS = {
    "fit": lambda x: poinsot.fit(x),
    "fit omega": lambda x: poinsot.fit(TIMES, x),
    "fit attitude": lambda x: poinsot.fit(TIMES, attitude=x),
    "fit moments": lambda x: poinsot.fit(TIMES, OMEGA, moments=x),
    "fit drag": lambda x: poinsot.fit(TIMES, OMEGA, drag=x),
    "fit predict": lambda x: poinsot.fit(TIMES, OMEGA, drag="none", predict=x),
    "fit list": lambda x: poinsot.fit([(TIMES, OMEGA), x]),
    "flights": lambda x: poinsot.flights(x),
    "Motion": lambda x: poinsot.Motion(x, [1.0, 2.0, 3.0]),
    "omega": lambda x: poinsot.Motion([1.0, 2.0, 2.5], x),
    "attitude": lambda x: poinsot.Motion([1.0, 2.0, 2.5], [1, 2, 3], attitude=x),
    "method": lambda x: poinsot.Motion([1.0, 2.0, 2.5], [1, 2, 3], method=x),
    "step_s": lambda x: poinsot.Motion([1.0, 2.0, 2.5], [1, 2, 3], method="rk4", step_s=x),
    "order": lambda x: poinsot.Motion([1.0, 2.0, 2.5], [1, 2, 3], method="taylor", order=x),
    "span_s": lambda x: poinsot.Motion([1.0, 2.0, 2.5], [1, 2, 3], method="rk4", step_s=0.1, span_s=x),
    "heavy_top": lambda x: poinsot.Motion.heavy_top(1.0, 0.5, x, theta_rad=0.5, omega3_rad_s=20.0),
    "at": lambda x: MOTION.at(x),
    "flips": lambda x: MOTION.flips(x, 1.0),
    "polhode": lambda x: MOTION.polhode(x),
    "herpolhode": lambda x: MOTION.herpolhode(x),
    "certificate": lambda x: MOTION.certificate([0.0], x),
    "Scene": lambda x: poinsot.Scene(x),
    "values": lambda x: poinsot.Scene("sphere", x),
    "set": lambda x: SCENE.set(x),
    "set key": lambda x: SCENE.set({"start.omega_rad_s": x}),
    "set table": lambda x: SCENE.set(camera=x),
    "sample": lambda x: SCENE.sample(x),
    "columns": lambda x: SCENE.sample([0.0], x),
    "departure": lambda x: SCENE.departure(x),
    "still": lambda x: SCENE.still(x, size=(32, 18)),
    "size": lambda x: SCENE.still(size=x),
    "frames": lambda x: SCENE.render("film.gif", size=(32, 18), progress=False, frames=x),
    "fps": lambda x: SCENE.render("film.gif", size=(32, 18), progress=False, frames=(0, 1), fps=x),
    "render": lambda x: SCENE.render(x, size=(32, 18), progress=False, frames=(0, 1)),
    "slides": lambda x: SCENE.slides(x, size=(32, 18), progress=False),
    "compare": lambda x: poinsot.compare(x, np.zeros((4, 4))),
    "max_differing": lambda x: poinsot.compare(np.zeros((4, 4)), np.zeros((4, 4)), max_differing=x),
    "ignore": lambda x: poinsot.compare(np.zeros((4, 4)), np.zeros((4, 4)), ignore=x),
    "profile": lambda x: poinsot.compare(np.zeros((4, 4)), np.zeros((4, 4)), profile=x),
    "compare_folders": lambda x: poinsot.compare_folders(x, "."),
    "report": lambda x: poinsot.compare_folders(".", ".", report=x),
    "approve": lambda x: poinsot.approve(x, baselines="b", results="."),
    "why": lambda x: poinsot.approve("a", baselines="b", results=".", why=x),
    **{name: lambda x, name=name: SCENE.still(size=(32, 18), **{name: x})
       for name in ("theme", "quality", "width_mm", "height_mm", "dpi", "type_pt", "journal", "keep_text", "backend", "portable")},
    **{name: lambda x, name=name: SCENE.figure(size=(32, 18), **{name: x}) for name in ("shading", "text")},
}


@pytest.mark.parametrize("name", CALLS)
def test_what_cannot_be_used_is_refused_in_one_line_without_options_of_the_command_line(name, tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    n_refused = 0
    for value in WRONG:
        try:
            CALLS[name](value)
        except poinsot.Error as error:
            n_refused += 1
            said = str(error)
            assert "\n" not in said and len(said) <= 600, said
            assert not re.search(r"(^|[ (`])--[a-z]", said), said
    assert n_refused > 0


def test_the_advice_of_messages_and_notes_names_keywords(tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    for folder in ("results", "baselines"):
        (tmp_path / folder).mkdir()
    SCENE.still(size=(32, 18)).save("results/native.png")
    poinsot.pictures.write_file("results/foreign.png", poinsot.comparison.png_bytes("grey", np.full((8, 8), 128, np.uint8)))
    (tmp_path / "inside").mkdir()
    (tmp_path / "inside" / "scene.toml").write_text('[body]\nmesh = "../outside.stl"\ndensity_kg_m3 = 1.0\n[start]\nomega_rad_s = [1.0, 2.0, 3.0]\n')
    (tmp_path / "outside.stl").write_text("solid\nendsolid\n")

    def approved(name, **options):
        poinsot.approve(name, baselines="baselines", results="results", **options)

    for call, keyword in (
        (lambda: approved("foreign"), "give foreign to"),
        (lambda: approved("native"), "drawn without portable"),
        (lambda: approved([]), "names: name the pictures"),
        (lambda: poinsot.Scene("inside/scene.toml").check(), "allow_outside"),
        (lambda: SCENE.sample([0.0], ["omgea"]), "columns: no column"),
        (lambda: SCENE.still(size=(32, 18), keep_text=True), "keep_text: only journal leaves text out"),
    ):
        with pytest.raises(poinsot.Error, match=re.escape(keyword)) as caught:
            call()
        assert "--" not in str(caught.value)
    figure = poinsot.Scene("generic", {"title": "A title"}).figure(journal="aps")
    assert not any("--" in note for note in itertools.chain(figure.notes, (figure.report or "").splitlines()))


def test_an_object_without_rows_is_refused():
    class Empty:
        times = omega = None

    for given in (Empty(), [Empty(), Empty()]):
        with pytest.raises(poinsot.InputError, match="has neither omega nor attitude"):
            poinsot.fit(given)
    with pytest.raises(poinsot.InputError, match="different numbers of rows"):
        poinsot.fit({"time": TIMES, "omega_x": OMEGA[:-1, 0], "omega_y": OMEGA[:, 1], "omega_z": OMEGA[:, 2]})
    with pytest.raises(poinsot.InputError, match="omega: a column has one number in a row"):
        poinsot.fit({"time": TIMES, "omega": OMEGA})
