"""The plugin for pytest, in sessions of pytest that pytester starts."""
import os
import re
import sys

import numpy as np
import pytest

import poinsot
import poinsot.comparison
import poinsot.scene  # all of it, as sessions in this process forget what they import

HEAD = """
import numpy as np
import pytest

GREY = np.full((8, 8), 128, np.uint8)

def spot(levels):
    picture = GREY.copy()
    picture[0, 0] += levels
    return picture
"""

# The tests of one file: they pass once their baselines exist.
TESTS = HEAD + """
LEVELS = 0

@pytest.mark.poinsot_image
def test_default():
    return spot(LEVELS)

@pytest.mark.poinsot_image(baseline="named.png", max_differing=1, max_over=0, over_levels=3)
def test_named():
    return spot(LEVELS)

@pytest.mark.poinsot_image
@pytest.mark.parametrize("shade", [10, 20])
def test_shades(shade):
    return np.full((4, 4, 3), shade, np.uint8)

class TestClass:
    @pytest.mark.poinsot_image
    def test_method(self):
        return GREY

def test_several(poinsot_image):
    poinsot_image(GREY, "several/front.png")
    poinsot_image(spot(LEVELS), "several/side")
    poinsot_image(GREY)
"""
N_TESTS = 6
BASELINES = ["named.png", "several/front.png", "several/side.png", "test_turn.TestClass.test_method.png",
             "test_turn.test_default.png", "test_turn.test_several.png", "test_turn.test_shades-10.png",
             "test_turn.test_shades-20.png"]


@pytest.fixture
def sessions(pytester, monkeypatch):
    """Starts pytest with this plugin alone in the folder of the test; with workers, in a process of its own."""
    # Python would load the compiled form of a file that changes twice within a second and keeps its size.
    monkeypatch.setattr(sys, "dont_write_bytecode", True)
    monkeypatch.setenv("PYTHONDONTWRITEBYTECODE", "1")
    # Plugins of the machine may import NumPy or matplotlib. A session within this process forgets what it imported, and these
    # libraries crash when they are loaded twice.
    monkeypatch.setenv("PYTEST_DISABLE_PLUGIN_AUTOLOAD", "1")

    def run(*arguments, own_process=False):
        workers = ("-p", "xdist") if "-n" in arguments else ()
        start = pytester.runpytest_subprocess if own_process or workers else pytester.runpytest_inprocess
        return start("-p", "poinsot.pytest_plugin", "-p", "no:cacheprovider", *workers, *arguments)

    # Otherwise pytest from version 8.1 on takes the folder of poinsot's own pyproject.toml as the root.
    pytester.makeini("[pytest]\n")
    run.folder = pytester.path
    run.write = lambda text, name="test_turn": pytester.makepyfile(**{name: text})
    return run


@pytest.fixture
def renewed(sessions):
    """Sessions whose tests of TESTS have baselines."""
    sessions.write(TESTS)
    sessions("--poinsot-renew", "first").assert_outcomes(passed=N_TESTS)
    return sessions


def pngs(folder):
    return sorted(str(file.relative_to(folder)) for file in folder.rglob("*.png"))


def change(sessions, levels):
    sessions.write(TESTS.replace("LEVELS = 0", f"LEVELS = {levels}"))


def lines_between(result, first, n):
    lines = result.outlines
    at = next(i for i, line in enumerate(lines) if re.search(first, line))
    return "\n".join(lines[at:at + n])


@pytest.mark.parametrize("workers", [(), ("-n", "2")], ids=["one process", "xdist"])
def test_renewed_baselines_are_those_that_later_sessions_compare_with(sessions, workers):
    sessions.write(TESTS)
    renewed = sessions("--strict-markers", "-W", "error", "--poinsot-renew", "first \"grey\" pictures", *workers)
    renewed.assert_outcomes(passed=N_TESTS)
    baselines = sessions.folder / "baselines"
    assert pngs(baselines) == BASELINES
    for name in BASELINES:
        renewed.stdout.fnmatch_lines([f"baselines/{name}: new"])
    for folder in (baselines, baselines / "several"):
        assert (folder / "manifest.toml").read_text().count("grey") == len(list(folder.glob("*.png")))
    sessions(*workers).assert_outcomes(passed=N_TESTS)

    change(sessions, 3)  # test_named allows it
    sessions(*workers).assert_outcomes(passed=N_TESTS - 2, failed=2)

    again = sessions("--poinsot-renew", "spots", *workers)
    again.assert_outcomes(passed=N_TESTS)
    again.stdout.fnmatch_lines(["baselines/test_turn.test_default.png: changed"])
    again.stdout.no_fnmatch_line("*test_method.png: *")
    assert (baselines / "manifest.toml").read_text().count('why = "spots"') == 2
    assert (baselines / "several" / "manifest.toml").read_text().count('why = "spots"') == 1
    sessions(*workers).assert_outcomes(passed=N_TESTS)


def test_a_failure_says_in_few_lines_why_where_and_how_to_renew(renewed):
    change(renewed, 4)
    result = renewed("--poinsot-results", "results")
    result.assert_outcomes(passed=N_TESTS - 3, failed=3)
    said = lines_between(result, "_ test_default _", 8)
    assert "pixels: 1 of 64 pixels differ" in said
    for line in ("  expected:   baselines/test_turn.test_default.png",
                 "  actual:     results/actual/test_turn.test_default.png",
                 "  difference: results/difference/test_turn.test_default.png",
                 '  to renew:   pytest test_turn.py::test_default --poinsot-renew "WHY"'):
        assert f"\n{line}\n" in said + "\n", said
    # Of a fixture, the line of the test is shown, and no line of the plugin.
    said = lines_between(result, "_ test_several _", 30)
    assert '>       poinsot_image(spot(LEVELS), "several/side")' in said
    assert "  difference: results/difference/test_turn.test_several/several/side.png" in said
    assert "pytest_plugin" not in said


def test_the_files_that_a_failure_names_show_the_pictures_until_the_test_passes(renewed):
    from PIL import Image

    change(renewed, 4)
    renewed("--poinsot-results", "results")
    results = renewed.folder / "results"
    actual = np.asarray(Image.open(results / "actual/test_turn.test_default.png"))
    assert actual[0, 0, 0] == 132 and actual[1, 1, 0] == 128
    shown = np.asarray(Image.open(results / "difference/test_turn.test_default.png").convert("RGB"))
    assert (shown[:, :8] == 128).all() and (shown[:, 16:] == actual[:, :, :3]).all()
    assert len(pngs(results / "difference")) == len(pngs(results / "actual")) == 3  # not those that passed
    change(renewed, 0)
    renewed("--poinsot-results", "results").assert_outcomes(passed=N_TESTS)
    assert pngs(results) == []


def test_results_are_by_default_in_the_temporary_folder_of_the_session(sessions):
    sessions.write(TESTS)
    for workers in ((), ("-n", "2")):
        result = sessions("--basetemp", "temporary", *workers)
        result.assert_outcomes(failed=N_TESTS)
        assert len(pngs(sessions.folder / "temporary" / "poinsot-results")) == N_TESTS
    assert not (sessions.folder / "baselines").exists()


def test_a_missing_baseline_fails_and_says_how_to_make_it(sessions):
    sessions.write(TESTS)
    result = sessions("--poinsot-results", "results")
    result.assert_outcomes(failed=N_TESTS)
    said = lines_between(result, "_ test_shades.20. _", 6)
    assert "there is no baseline for this picture" in said
    command = re.search(r"to renew:   pytest (.*) --poinsot-renew", said).group(1)
    assert command == "'test_turn.py::test_shades[20]'"
    renewed = sessions(command.strip("'"), "--poinsot-renew", "as the failure says")
    renewed.assert_outcomes(passed=1)
    assert pngs(sessions.folder / "baselines") == ["test_turn.test_shades-20.png"]


def test_the_command_that_renews_holds_in_the_folder_where_pytest_was_started(sessions):
    folder = sessions.folder / "deep"
    folder.mkdir()
    (folder / "test_turn.py").write_text(TESTS)
    (sessions.folder / "pytest.ini").write_text("[pytest]\n")
    result = sessions("deep")
    assert "pytest deep/test_turn.py::test_default --poinsot-renew" in "\n".join(result.outlines)
    assert "  expected:   deep/baselines/named.png" in result.outlines


@pytest.mark.parametrize("workers", [(), ("-n", "2")], ids=["one process", "xdist"])
def test_the_report_shows_each_picture_within_its_own_limits(renewed, workers):
    change(renewed, 3)
    renewed.write(HEAD + """
@pytest.mark.poinsot_image
def test_new():
    return GREY
""", "test_other")
    result = renewed("--poinsot-report", "pages/report.html", *workers)
    result.assert_outcomes(passed=N_TESTS - 2, failed=3)
    result.stdout.fnmatch_lines(["report: pages/report.html"])
    page = (renewed.folder / "pages" / "report.html").read_text()
    for name, outcome in (("test_turn.test_default", "pixels"), ("test_turn.test_several/several/side", "pixels"),
                          ("test_turn.test_named/named", "within limits"), ("test_turn.TestClass.test_method", "same"),
                          ("test_turn.test_several", "pixels"), ("test_other.test_new", "unexpected")):
        assert name in page, name
        assert outcome in page
    assert len(list((renewed.folder / "pages" / "report_pictures").rglob("*.png"))) > 0


def test_a_report_without_pictures_is_not_written_and_said_so(sessions):
    sessions.write("def test_plain(): pass")
    result = sessions("--poinsot-report", "report.html")
    assert result.ret == 0
    result.stdout.fnmatch_lines(["report: not written, as no test compared a picture"])
    assert not (sessions.folder / "report.html").exists()


@pytest.mark.parametrize("file, said", [(os.fsdecode(b"\xff.html"), "*not valid UTF-8; rename the file"), ("file/report.html", "*file*")],
                         ids=["bytes", "below a file"])
def test_a_report_that_cannot_be_written_fails_the_session(renewed, file, said):
    (renewed.folder / "file").write_text("")
    result = renewed("--poinsot-report", file)
    assert result.ret == 1
    result.assert_outcomes(passed=N_TESTS)
    result.stdout.fnmatch_lines([f"--poinsot-report: {said}"])


def test_a_folder_of_baselines_that_is_not_utf_8_fails_each_test_with_one_sentence(sessions):
    sessions.write(TESTS)
    result = sessions("--poinsot-baselines", os.fsdecode(b"\xff"))
    result.assert_outcomes(failed=N_TESTS)
    result.stdout.fnmatch_lines(["*not valid UTF-8; rename the file"])


@pytest.mark.parametrize("ini", [False, True], ids=["option", "ini"])
def test_one_folder_may_hold_the_baselines_of_all_tests(sessions, ini):
    for folder in ("a", "b"):
        (sessions.folder / folder).mkdir()
        (sessions.folder / folder / "__init__.py").write_text("")
        (sessions.folder / folder / "test_turn.py").write_text(TESTS)
    given = ("--poinsot-baselines", "pictures")
    if ini:
        (sessions.folder / "pytest.ini").write_text("[pytest]\npoinsot_baselines = pictures\n")
        given = ()
    sessions("--poinsot-renew", "first", *given).assert_outcomes(passed=2 * N_TESTS)
    names = pngs(sessions.folder / "pictures")
    assert "a.test_turn.test_default.png" in names and "b.test_turn.test_default.png" in names and "named.png" in names
    sessions(*given).assert_outcomes(passed=2 * N_TESTS)
    assert not (sessions.folder / "a" / "baselines").exists()


@pytest.mark.parametrize("picture", ["path", "pathlib", "still", "figure", "pil", "float"])
def test_a_picture_is_a_file_an_array_a_still_or_a_figure(sessions, picture):
    if picture == "figure":
        pytest.importorskip("matplotlib")
    made = {
        "path": "file(tmp_path)",
        "pathlib": "__import__('pathlib').Path(file(tmp_path))",
        "still": "__import__('poinsot').Scene('sphere').still(size=(64, 36))",
        "figure": "drawing()",
        "pil": "Image.fromarray(GREY)",
        "float": "GREY / 255.0",
    }[picture]
    sessions.write(HEAD + f"""
from PIL import Image

def file(folder):
    Image.fromarray(GREY).save(folder / "drawn.png")
    return str(folder / "drawn.png")

def drawing():
    import matplotlib
    matplotlib.use("agg")
    from matplotlib import pyplot
    figure = pyplot.figure(figsize=(1, 1), dpi=50)
    figure.add_subplot().plot([1, 2])
    return figure

@pytest.mark.poinsot_image(baseline="it.png")
def test_it(tmp_path):
    return {made}

@pytest.mark.poinsot_image(baseline="it.png")
def test_grey_is_another():
    return np.full((8, 8), 127, np.uint8)
""")
    sessions("--poinsot-renew", "first", "-k", "test_it", own_process=True).assert_outcomes(passed=1, deselected=1)
    sessions(own_process=True).assert_outcomes(passed=1, failed=1)


def test_wrong_options_end_the_session_with_one_sentence(sessions):
    sessions.write(TESTS)
    (sessions.folder / "file").write_text("")
    (sessions.folder / "mine/actual").mkdir(parents=True)
    for arguments, sentence in (
        (("--poinsot-results", "mine"), "--poinsot-results: 'mine' holds a folder actual or difference that poinsot has not made"),
        (("--poinsot-renew", " "), "--poinsot-renew: give the reason"),
        (("--poinsot-baselines", "file"), "--poinsot-baselines: 'file' is not a folder"),
        (("--poinsot-results", "file"), "--poinsot-results: 'file' is not a folder"),
        (("--poinsot-report", "report.pdf"), "--poinsot-report: report.pdf: the report is a page"),
    ):
        result = sessions(*arguments)
        assert result.ret == pytest.ExitCode.USAGE_ERROR
        said = [line for line in result.errlines if line]
        assert len(said) == 1 and said[0].startswith(f"ERROR: {sentence}"), said
    assert not (sessions.folder / "baselines").exists()


@pytest.mark.parametrize("workers", [(), ("-n", "2")], ids=["one process", "xdist"])
def test_wrong_arguments_and_pictures_fail_their_test_with_one_sentence(sessions, workers):
    cases = {
        "limit": ("(max_flop=0.1)", "return GREY", '@pytest.mark.poinsot_image: there is no limit "max_flop"; did you mean "max_flip"?'),
        "value": ("(max_flip=3)", "return GREY", "max_flip: 3: not a FLIP value; give 0 (equal) to 1, such as 0.01"),
        "suffix": ("(baseline='turn.svg')", "return GREY", "baseline: turn.svg: baselines are PNG files; end the name in .png"),
        "outside": ("(baseline='../turn.png')", "return GREY", "baseline: '../turn.png' is not a name in the folder of baselines; give one, as turn.png"),
        "empty": ("(baseline='')", "return GREY", "baseline: '' is not a name in the folder of baselines; give one, as turn.png"),
        "number": ("(baseline=3)", "return GREY", "baseline: 3 is not the name of a file; give a text or a pathlib.Path"),
        "two": ("('a.png', 'b.png')", "return GREY", "@pytest.mark.poinsot_image: a test has one baseline, and this names 2"),
        "nothing": ("", "pass", "the test returned no picture; return a file, an array, a Still or a figure with savefig"),
        "file": ("", "return 'none.png'", "none.png: no such picture"),
    }
    text = HEAD
    for name, (arguments, body, _) in cases.items():
        text += f"\n@pytest.mark.poinsot_image{arguments}\ndef test_{name}():\n    {body}\n"
    text += "\n@pytest.mark.poinsot_image\nasync def test_async():\n    return GREY\n"
    sessions.write(text)
    # The limits are looked at when there is a baseline.
    baselines = sessions.folder / "baselines"
    baselines.mkdir()
    for name in cases:
        poinsot.pictures.write_file(baselines / f"test_turn.test_{name}.png",
                                    poinsot.comparison.png_bytes("grey", np.full((8, 8), 128, np.uint8)))
    result = sessions(*workers)
    result.assert_outcomes(failed=len(cases) + 1)
    for name, (_, _, sentence) in cases.items():
        said = lines_between(result, f"_ test_{name} _", 3 if not workers else 4)
        assert any(matches(line, sentence) for line in said.split("\n")), said
    assert "a test with this marker returns its picture; it can neither yield nor be async" in lines_between(result, "_ test_async _", 4)


def matches(line, pattern):
    return re.fullmatch(re.escape(pattern).replace(r"\*", ".*"), line) is not None


def test_a_wrong_argument_of_the_fixture_raises_an_input_error_at_the_line_of_the_test(sessions):
    sessions.write(HEAD + """
import poinsot

def test_caught(poinsot_image):
    with pytest.raises(poinsot.InputError, match="max_flop"):
        poinsot_image(GREY, "a.png", max_flop=1)

def test_seen(poinsot_image):
    poinsot_image(GREY, "a.png", max_flop=1)
""")
    result = sessions()
    result.assert_outcomes(passed=1, failed=1)
    said = lines_between(result, "_ test_seen _", 30)
    assert '>       poinsot_image(GREY, "a.png", max_flop=1)' in said
    assert "pytest_plugin" not in said


def test_a_method_of_unittest_with_the_marker_fails_as_its_picture_would_not_be_compared(sessions):
    sessions.write(HEAD + """
import unittest

class Case(unittest.TestCase):
    @pytest.mark.poinsot_image
    def test_it(self):
        return GREY
""")
    result = sessions()
    result.assert_outcomes(errors=1)
    result.stdout.fnmatch_lines(["@pytest.mark.poinsot_image: a method of unittest.TestCase returns no picture; *"])


def test_the_changes_of_records_are_named(sessions):
    sessions.write("""
import os, poinsot, pytest

@pytest.mark.poinsot_image
def test_theme():
    return poinsot.Scene("sphere").still(size=(64, 36), theme=os.environ["THEME"], portable=True)
""")
    with pytest.MonkeyPatch.context() as patch:
        patch.setenv("THEME", "light")
        sessions("--poinsot-renew", "first", own_process=True).assert_outcomes(passed=1)
        patch.setenv("THEME", "dark")
        result = sessions(own_process=True)
    result.assert_outcomes(failed=1)
    result.stdout.fnmatch_lines(["  changed:    theme: light → dark*"])


@pytest.mark.parametrize("ids", [["a/b", "a b", "ä", "x" * 300], ["a.b", "a::b", "[a::b]", "[a.b]"]], ids=["characters", "colons"])
def test_tests_of_unusual_names_have_baselines_of_their_own(sessions, ids):
    sessions.write(HEAD + f"""
@pytest.mark.poinsot_image
@pytest.mark.parametrize("i", range(4), ids={ids!r})
def test_it(i):
    return np.full((2, 2), i, np.uint8)
""")
    sessions("--poinsot-renew", "first").assert_outcomes(passed=4)
    names = pngs(sessions.folder / "baselines")
    assert len(names) == 4 and all(re.fullmatch(r"[\w.-]{,200}", name, re.ASCII) for name in names), names
    assert ("test_turn.test_it-a.b.png" in names) == ("a.b" in ids)
    sessions().assert_outcomes(passed=4)


@pytest.mark.parametrize("workers", [(), ("-n", "1")], ids=["one process", "xdist"])
def test_limits_are_numbers_and_texts_of_any_type(sessions, workers):
    sessions.write(HEAD + """
import enum
from fractions import Fraction

class Level(enum.IntEnum):
    FEW = 3

class Text(str):
    pass

@pytest.mark.poinsot_image(max_flip=Fraction(1, 2))
def test_fraction():
    return spot(1)

@pytest.mark.poinsot_image(max_differing=np.float32(1), max_over=np.array(0), over_levels=Level.FEW, profile=Text("native"))
def test_enumeration():
    return spot(1)

@pytest.mark.poinsot_image(ignore=np.array(["0,0,1,1", "2,2,1,1"]), antialiasing=np.False_)
def test_array():
    return spot(1)

@pytest.mark.poinsot_image(ignore=[Text("0,0,1,1")])
def test_text():
    return spot(1)
""")
    sessions("--poinsot-renew", "first", *workers).assert_outcomes(passed=4)
    sessions.write((sessions.folder / "test_turn.py").read_text().replace("spot(1)", "spot(2)"))
    sessions("--poinsot-report", "report.html", *workers).assert_outcomes(passed=4)


def test_a_doctest_with_the_marker_runs(sessions):
    sessions.write("""
import pytest

def pytest_collection_modifyitems(items):
    for item in items:
        item.add_marker(pytest.mark.poinsot_image)
""", "conftest")
    sessions.write("""
def shade():
    '''
    >>> shade()
    3
    '''
    return 3
""")
    sessions("--doctest-modules").assert_outcomes(passed=1)


def test_one_test_may_compare_many_pictures_with_one_baseline(sessions):
    sessions.write(HEAD + """
def test_it(poinsot_image):
    for i in range(3):
        assert poinsot_image(GREY, "one.png") is None or i < 3
""")
    sessions("--poinsot-renew", "first").assert_outcomes(passed=1)
    sessions("--poinsot-report", "report.html").assert_outcomes(passed=1)
    page = (sessions.folder / "report.html").read_text()
    assert "test_turn.test_it/one" in page and "test_turn.test_it/3/one" in page


def test_sessions_without_pictures_do_not_import_numpy(sessions):
    sessions.write("""
import sys

def test_plain():
    assert "poinsot.pytest_plugin" in sys.modules
    assert "numpy" not in sys.modules and "poinsot._poinsot" not in sys.modules
""")
    sessions(own_process=True).assert_outcomes(passed=1)


def test_the_plugin_works_beside_the_other_plugins_of_the_machine(sessions, monkeypatch):
    pytest.importorskip("pytest_mpl")
    # Without a path, pytest-mpl leaves its results in the temporary folder.
    monkeypatch.delenv("PYTEST_DISABLE_PLUGIN_AUTOLOAD")
    sessions.write("""
import matplotlib
matplotlib.use("agg")
import pytest
from matplotlib import pyplot

def drawing(height):
    figure = pyplot.figure(figsize=(1, 1), dpi=50)
    figure.add_subplot().plot([1, height])
    return figure

@pytest.mark.poinsot_image
def test_ours():
    return drawing(2)

@pytest.mark.mpl_image_compare(baseline_dir="theirs", filename="theirs.png")
def test_theirs():
    return drawing(2)

def test_both_draw(poinsot_image):
    poinsot_image(drawing(3), "fixture.png")
""")
    sessions("--mpl-results-path", "results", "--mpl-generate-path", "theirs", "-k", "theirs", own_process=True).assert_outcomes(skipped=1, deselected=2)
    sessions("--poinsot-renew", "first", own_process=True).assert_outcomes(passed=3)
    assert pngs(sessions.folder / "theirs") == ["theirs.png"]
    assert pngs(sessions.folder / "baselines") == ["fixture.png", "test_turn.test_ours.png"]
    sessions("--mpl-results-path", "results", "--mpl", "--poinsot-report", "report.html", own_process=True).assert_outcomes(passed=3)
    # A change is noticed by the plugin whose picture it is.
    sessions.write((sessions.folder / "test_turn.py").read_text().replace("drawing(2)", "drawing(1)"))
    changed = sessions("--mpl-results-path", "results", "--mpl", own_process=True)
    changed.assert_outcomes(passed=1, failed=2)
    changed.stdout.fnmatch_lines(["  to renew:   pytest test_turn.py::test_ours --poinsot-renew*"])


TWO = HEAD + """
LEVELS = 0

def test_one(poinsot_image):
    poinsot_image(GREY, "front.png")

def test_two(poinsot_image):
    poinsot_image(spot(LEVELS), "front.png")
"""


@pytest.mark.parametrize("workers", [(), ("-n", "2")], ids=["one process", "xdist"])
def test_two_tests_may_share_a_baseline_but_not_overwrite_each_others(sessions, workers):
    sessions.write(TWO)
    sessions("--poinsot-renew", "grey", *workers).assert_outcomes(passed=2)
    sessions(*workers).assert_outcomes(passed=2)
    sessions.write(TWO.replace("LEVELS = 0", "LEVELS = 9"))
    renewed = sessions("--poinsot-renew", "spots", *workers)
    renewed.assert_outcomes(passed=1, failed=1)
    renewed.stdout.fnmatch_lines(["*baselines/front.png: is also the baseline of test_turn.py::test_*, with another picture*"])
    later = sessions()
    later.assert_outcomes(passed=1, failed=1)
    if not workers:
        later.stdout.fnmatch_lines(["*test_turn.py::test_one also has this baseline*"])


@pytest.mark.parametrize("limit, said", [
    ('ignore=["clock"]', "*ignore: neither picture has a record that says where to find clock*"),
    ('max_differing="much"', "*max_differing: much: not a share of the pixels*"),
])
def test_limits_that_cannot_work_are_refused_when_the_baseline_is_made(sessions, limit, said):
    sessions.write(HEAD + f"def test_grey(poinsot_image):\n    poinsot_image(GREY, {limit})\n")
    renewed = sessions("--poinsot-renew", "first")
    renewed.assert_outcomes(failed=1)
    renewed.stdout.fnmatch_lines([said])
    assert not (sessions.folder / "baselines" / "test_turn.test_grey.png").exists()
