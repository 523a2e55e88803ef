"""Pictures in pytest: compared with baselines, renewed with a reason, reported as HTML.

    @pytest.mark.poinsot_image(max_flip=0.01)
    def test_turn():
        return poinsot.Scene("generic").still(portable=True)

    def test_views(poinsot_image):
        for name in ("front", "side"):
            poinsot_image(draw(name), name + ".png")

A picture is a PNG file, an array, a Still, a picture of PIL, or an object with `savefig`, such as a
figure of matplotlib. The limits are those of poinsot.compare. See docs/python.md.
"""

from __future__ import annotations

import difflib
import hashlib
import inspect
import json
import os
import re
import shlex
import sys
import unittest
from pathlib import Path
from typing import TYPE_CHECKING, Any, Callable, Dict, Iterator, List, Optional, Set, Tuple

import pytest

# Only pytest: the package and NumPy are imported by the first test that has a picture.
if TYPE_CHECKING:
    from . import Comparison

_session_key = "poinsot-session"
_mark = "poinsot_image"


# In a folder of results: poinsot has made its folders actual and difference.
RESULTS_MARK = "made-by-poinsot"


def pytest_addoption(parser: Any) -> None:
    group = parser.getgroup("poinsot", "pictures (poinsot)")
    group.addoption(
        "--poinsot-baselines",
        metavar="DIR",
        help="folder of the baseline pictures; default: the ini value poinsot_baselines, else `baselines` beside "
        "each test file",
    )
    group.addoption(
        "--poinsot-results",
        metavar="DIR",
        help="folder for the pictures of failed tests and their differences; default: poinsot-results in pytest's "
        "temporary folder",
    )
    group.addoption(
        "--poinsot-renew", metavar="WHY", help="make the tests' pictures the baselines; manifest.toml keeps the reason"
    )
    group.addoption("--poinsot-report", metavar="FILE.html", help="write a page that shows all compared pictures")
    parser.addini("poinsot_baselines", "folder of the baseline pictures, relative to the ini file")


def pytest_configure(config: Any) -> None:
    config.addinivalue_line(
        "markers",
        f"{_mark}(baseline=NAME, **limits): compares the picture that the test returns with a baseline; "
        "limits as for poinsot.compare",
    )
    config.pluginmanager.register(_Session(config), _session_key)


def _start_folder(config: Any) -> Path:
    return Path(str(config.invocation_params.dir))


class _Session:
    """The options, and what the tests of this process, or of all workers, did."""

    def __init__(self, config: Any) -> None:
        self.config = config
        self.worker_input: Dict[str, Any] = getattr(config, "workerinput", {})
        self.start = Path(self.worker_input.get("poinsot_start") or _start_folder(config))
        self.pictures: List[Dict[str, Any]] = []
        self.renewed: List[str] = []
        self.report: Optional[Path] = None
        self.report_error = ""
        self.root = Path(str(config.rootpath))

        option = config.getoption
        self.why: Optional[str] = option("poinsot_renew")
        if self.why is not None and not self.why.strip():
            raise pytest.UsageError('--poinsot-renew: give the reason, as --poinsot-renew "lighter theme"')
        given = option("poinsot_baselines")
        self.baselines: Optional[Path] = None
        if given is not None:
            self.baselines = self._folder("--poinsot-baselines", given, self.start)
        elif config.getini("poinsot_baselines"):
            base = Path(str(config.inipath)).parent if config.inipath else self.root
            self.baselines = self._folder("poinsot_baselines", config.getini("poinsot_baselines"), base)
        self._results: Optional[Path] = None
        if option("poinsot_results") is not None:
            self._results = self._folder("--poinsot-results", option("poinsot_results"), self.start)
            made = [self._results / name for name in ("actual", "difference")]
            if any(os.path.lexists(folder) for folder in made) and not (self._results / RESULTS_MARK).is_file():
                raise pytest.UsageError(
                    f"--poinsot-results: {option('poinsot_results')!r} holds a folder actual or difference that poinsot has "
                    "not made; move it away, or name another folder"
                )
        page = option("poinsot_report")
        if page is not None:
            if not page.lower().endswith(".html"):
                raise pytest.UsageError(f"--poinsot-report: {page}: the report is a page; end its name in .html")
            self.report = self.start / page

    @staticmethod
    def _folder(option: str, given: str, base: Path) -> Path:
        folder = base / given
        if not given or (folder.exists() and not folder.is_dir()):
            raise pytest.UsageError(f"{option}: {given!r} is not a folder; give the name of one")
        return folder

    @property
    def results(self) -> Path:
        if self._results is None:
            controllers = self.worker_input.get("poinsot_results")
            self._results = Path(controllers) if controllers else self._temporary() / "poinsot-results"
        return self._results

    def owner_of(self, baseline: str, test: str, picture: str) -> Tuple[str, str]:
        """The first test of this session, in any of its processes, that has this baseline, and its picture."""
        folder = Path(self.worker_input.get("poinsot_owners") or self._temporary() / "poinsot-owners")
        folder.mkdir(parents=True, exist_ok=True)
        claim = folder / hashlib.sha256(os.path.realpath(baseline).encode("utf-8", "surrogateescape")).hexdigest()
        if not claim.exists():
            own = folder / f"{claim.name}-{os.getpid()}"
            own.write_text(json.dumps([test, picture]), encoding="utf-8")
            try:
                os.link(own, claim)  # whole, or not there
            except FileExistsError:
                pass
            own.unlink()
        owner, owners_picture = json.loads(claim.read_text(encoding="utf-8"))
        return owner, owners_picture

    def _temporary(self) -> Path:
        return Path(str(self.config._tmp_path_factory.getbasetemp()))

    def shown(self, path: Path) -> str:
        """A path as short as it can be for the user."""
        try:
            return str(path.relative_to(self.start))
        except ValueError:
            return str(path)

    @pytest.hookimpl(optionalhook=True)
    def pytest_configure_node(self, node: Any) -> None:
        # Workers of xdist write to the folder of the controller.
        node.workerinput["poinsot_results"] = str(self.results)
        node.workerinput["poinsot_start"] = str(self.start)
        node.workerinput["poinsot_owners"] = str(self._temporary() / "poinsot-owners")

    @pytest.hookimpl(hookwrapper=True)
    def pytest_runtest_makereport(self, item: Any, call: Any) -> Iterator[None]:
        outcome: Any = yield
        if call.when == "call" and _test_key in item.stash:
            # Reports carry this from xdist's workers to the controller.
            outcome.get_result().poinsot_pictures = item.stash[_test_key].pictures

    def pytest_runtest_logreport(self, report: Any) -> None:
        if self.worker_input:
            return
        for picture in getattr(report, "poinsot_pictures", []):
            self.pictures.append(picture)
            if picture["renewed"]:
                self.renewed.append(picture["renewed"])

    def pytest_sessionfinish(self, session: Any) -> None:
        if self.worker_input or self.report is None or not self.pictures:
            return
        from . import Error, _poinsot
        from .paths import path_text

        pairs = [
            (one["name"], one["expected"], one["actual"], one["limits"].get("profile") or "", one["limits"])
            for one in sorted(self.pictures, key=lambda picture: str(picture["name"]))
        ]
        try:
            self.report.parent.mkdir(parents=True, exist_ok=True)
            _poinsot.report_pairs(pairs, path_text(self.report), "Pictures of the tests")
        except (Error, OSError) as error:
            self.report_error = f"--poinsot-report: {error}"
            session.exitstatus = session.exitstatus or pytest.ExitCode.TESTS_FAILED

    def pytest_terminal_summary(self, terminalreporter: Any) -> None:
        if not (self.renewed or self.report):
            return
        terminalreporter.section("poinsot")
        for line in self.renewed:
            terminalreporter.write_line(line)
        if self.report_error:
            terminalreporter.write_line(self.report_error, red=True)
        elif self.report and self.pictures:
            terminalreporter.write_line(f"report: {self.shown(self.report)}")
        elif self.report:
            terminalreporter.write_line("report: not written, as no test compared a picture")


def _plain(text: str) -> str:
    """A test's name as the name of a file, and another one for each test."""
    test, bracket, parameters = text.partition("[")
    short = test.replace("::", ".") + re.sub(r"^\[(.*)\]$", r"-\1", bracket + parameters)
    # A "::" among the parameters is no plain character, or it would read like a ".".
    name = re.sub(r"[^\w.=+-]", "_", short, flags=re.ASCII)
    if name == short and len(name) <= 150:
        return name
    return name[:150] + "-" + hashlib.sha256(text.encode("utf-8", "replace")).hexdigest()[:8]


def _checked_name(given: Any) -> str:
    """The name of a baseline without its suffix."""
    from . import InputError
    from .paths import path_text

    try:
        name = path_text(given)
    except InputError as error:
        raise InputError(f"baseline: {error}") from None
    stem, suffix = os.path.splitext(name)
    if suffix.lower() in (".pdf", ".svg", ".jpg", ".jpeg", ".gif", ".mp4", ".webm", ".mov"):
        raise InputError(f"baseline: {name}: baselines are PNG files; end the name in .png")
    if suffix.lower() != ".png":
        stem = name
    if not os.path.basename(stem) or os.path.isabs(name) or ".." in Path(name).parts:
        raise InputError(f"baseline: {name!r} is not a name in the folder of baselines; give one, as turn.png")
    return stem


def _checked_limits(where: str, given: Dict[str, Any]) -> Dict[str, Any]:
    """The limits as plain values, which can be sent from a worker of xdist."""
    from . import InputError
    from .comparison import limit_names, plain_limit

    known = ("profile", *limit_names)
    for name in given:
        if name not in known:
            near = difflib.get_close_matches(name, (*known, "baseline"), 1)
            hint = f'did you mean "{near[0]}"?' if near else "there are baseline, " + ", ".join(known)
            raise InputError(f'{where}: there is no limit "{name}"; {hint}')
    return {name: plain_limit(name, value) for name, value in given.items()}


def _write(picture: Any, path: Path) -> None:
    """A picture as a PNG file."""
    from . import InputError
    from .comparison import png_bytes
    from .paths import path_text
    from .pictures import write_file

    path.parent.mkdir(parents=True, exist_ok=True)
    if picture is None:
        raise InputError("the test returned no picture; return a file, an array, a Still or a figure with savefig")
    if inspect.isgenerator(picture) or inspect.iscoroutine(picture):
        picture.close()
        raise InputError("a test with this marker returns its picture; it can neither yield nor be async")
    if hasattr(picture, "savefig"):
        picture.savefig(str(path), format="png")
        if "matplotlib.pyplot" in sys.modules:
            sys.modules["matplotlib.pyplot"].close(picture)
        return
    if isinstance(picture, (str, os.PathLike)):
        file = Path(path_text(picture))
        if not file.is_file():
            raise InputError(f"{file}: no such picture", str(file))
        write_file(path, file.read_bytes())
    else:
        write_file(path, png_bytes("picture", picture))


class _Test:
    """The pictures of one test, and where they lie."""

    def __init__(self, item: Any) -> None:
        self.session: _Session = item.config.pluginmanager.get_plugin(_session_key)
        self.pictures: List[Dict[str, Any]] = []
        self.file = Path(str(item.path))
        self.id: str = item.nodeid
        _, _, self.own_id = item.nodeid.partition("::")
        self.name = f"{self.file.stem}.{_plain(self.own_id)}"
        try:
            self.folders: Tuple[str, ...] = self.file.parent.relative_to(self.session.root).parts
        except ValueError:
            self.folders = ()
        self.baselines = self.session.baselines or self.file.parent / "baselines"
        self.written: Set[Path] = set()

    def paths(self, given_name: Any) -> Tuple[Path, Path, Path]:
        """The baseline of this name, and where the picture and the difference are put."""
        within = Path(*self.folders)
        if given_name is None:
            # In a common folder, the folder of the test tells apart tests of the same name.
            name = ".".join((*self.folders, self.name)) if self.session.baselines else self.name
        else:
            name = _checked_name(given_name)
            within /= self.name
        within /= name + ".png"
        if within in self.written:  # once more with the same baseline
            within = within.parent / str(len(self.written) + 1) / within.name
        self.written.add(within)
        results = self.session.results
        return self.baselines / (name + ".png"), results / "actual" / within, results / "difference" / within

    def compare(self, picture: Any, given_name: Any, limits: Dict[str, Any], where: str) -> "_Outcome":
        """Compares a picture with its baseline, or makes it the baseline. Raises poinsot's errors."""
        from . import InputError, _poinsot, compare
        from .comparison import png_bytes
        from .paths import path_text
        from .pictures import write_file

        limits = _checked_limits(where, limits)
        baseline, actual, difference = self.paths(given_name)
        self.session.results.mkdir(parents=True, exist_ok=True)
        (self.session.results / RESULTS_MARK).touch()
        _write(picture, actual)
        if difference.exists():
            difference.unlink()
        name = actual.relative_to(self.session.results / "actual").with_suffix("").as_posix()
        files = {"expected": path_text(baseline), "actual": path_text(actual)}
        record = {"name": name, **files, "limits": limits, "renewed": ""}
        owner, owners_picture = self.session.owner_of(files["expected"], self.id, files["actual"])
        if self.session.why is not None:
            _poinsot.check_limits(files["actual"], limits.get("profile") or "", limits)
            if owner == self.id:
                record["renewed"] = self.renew(baseline, actual)
            elif not compare(owners_picture, actual, **limits):
                raise InputError(
                    f"{self.session.shown(baseline)}: is also the baseline of {owner}, with another picture; "
                    "give one of the two another name"
                )
            self.pictures.append(record)
            return "", None
        paths = {"expected": baseline, "actual": actual}
        if not baseline.is_file():
            self.pictures.append(record)
            return self.message("there is no baseline for this picture", paths), None
        comparison = compare(baseline, actual, **limits)
        self.pictures.append(record)
        if comparison:
            if self.session.report is None:
                actual.unlink()
            return "", comparison
        reason = f"{comparison.outcome}: {comparison.reason}"
        if comparison.changes:
            more = len(comparison.changes) - 5
            reason += "\n  changed:    " + "; ".join(comparison.changes[:5]) + (f"; {more} more" if more > 0 else "")
        if owner != self.id:
            reason += f"\n  {owner} also has this baseline"
        if comparison.difference is not None:
            difference.parent.mkdir(parents=True, exist_ok=True)
            write_file(difference, png_bytes("difference", comparison.difference))
            paths["difference"] = difference
        return self.message(reason, paths), comparison

    def renew(self, baseline: Path, actual: Path) -> str:
        """Makes the picture the baseline; says what it did, or nothing if it was the baseline already."""
        from . import approve

        baseline.parent.mkdir(parents=True, exist_ok=True)
        why = self.session.why or ""
        outcomes = approve(
            actual.stem, results=actual.parent, baselines=baseline.parent, why=why, any_renderer=True, foreign=True
        )
        outcome = outcomes[actual.stem]
        return "" if outcome == "unchanged" else f"{self.session.shown(baseline)}: {outcome}"

    def message(self, reason: str, paths: Dict[str, Path]) -> str:
        lines = [f"  {what + ':':<12}{self.session.shown(path)}" for what, path in paths.items()]
        test = shlex.quote(f"{self.session.shown(self.file)}::{self.own_id}")
        return "\n".join([reason, *lines, f'  to renew:   pytest {test} --poinsot-renew "WHY"'])


# Why a picture fails, empty if it passes; and the comparison.
_Outcome = Tuple[str, "Optional[Comparison]"]

_test_key = pytest.StashKey[_Test]()


def _test_of(item: Any) -> _Test:
    if _test_key not in item.stash:
        item.stash[_test_key] = _Test(item)
    test: _Test = item.stash[_test_key]
    return test


@pytest.fixture
def poinsot_image(request: Any) -> "Callable[..., Optional[Comparison]]":
    """Compares a picture with a baseline: poinsot_image(picture, "turn.png", max_flip=0.01).

    Without a name, the baseline is named after the test. Returns the Comparison, or None if the
    baseline was renewed. May be called several times in a test.
    """

    def check(picture: Any, baseline: Any = None, **limits: Any) -> "Optional[Comparison]":
        from . import Error

        __tracebackhide__ = True
        try:
            fault, comparison = _test_of(request.node).compare(picture, baseline, limits, "poinsot_image")
        except Error as error:
            raise error.with_traceback(None) from None
        if fault:
            raise AssertionError(fault)
        return comparison

    return check


@pytest.hookimpl(tryfirst=True)
def pytest_pyfunc_call(pyfuncitem: Any) -> Optional[bool]:
    """Runs a test that has the marker; its picture is compared."""
    marker = pyfuncitem.get_closest_marker(_mark)
    if marker is None:
        return None
    from . import Error

    __tracebackhide__ = True
    limits = dict(marker.kwargs)
    names = [*marker.args, *(limits.pop(name) for name in ("baseline",) if name in limits)]
    if len(names) > 1:
        pytest.fail(f"@pytest.mark.{_mark}: a test has one baseline, and this names {len(names)}", pytrace=False)
    baseline = names[0] if names else None
    picture = pyfuncitem.obj(**{name: pyfuncitem.funcargs[name] for name in pyfuncitem._fixtureinfo.argnames})
    try:
        fault, _ = _test_of(pyfuncitem).compare(picture, baseline, limits, f"@pytest.mark.{_mark}")
    except Error as error:
        fault = str(error)
    if fault:
        pytest.fail(fault, pytrace=False)
    return True


def pytest_runtest_setup(item: Any) -> None:
    item.stash[_test_key] = None  # of an earlier run of the test
    del item.stash[_test_key]
    if item.get_closest_marker(_mark) is None:
        return
    # Else its picture would never be compared.
    owner = getattr(item, "cls", None)  # a doctest has none
    if owner is not None and issubclass(owner, unittest.TestCase):
        pytest.fail(
            f"@pytest.mark.{_mark}: a method of unittest.TestCase returns no picture; use a function or a plain class",
            pytrace=False,
        )
