"""The check at the end of a test run names what is there, and only what is new in shared folders."""
import contextlib
import io
import pathlib
import tempfile

import left_behind


def said_after(run, act):
    left_behind.before(run)
    act()
    words = io.StringIO()
    with contextlib.redirect_stdout(words):
        code = left_behind.after(run)
    assert not run.exists()
    return code, words.getvalue()


with tempfile.TemporaryDirectory() as name:
    shared, run = pathlib.Path(name, "shared"), pathlib.Path(name, "run")
    shared.mkdir()
    (shared / "poinsot-of-yesterday").touch()
    left_behind.shared_folders = lambda: [str(shared), "/there/is/no/such/folder"]
    left_behind.PATIENCE_S = 0.2

    assert said_after(run, lambda: None) == (0, "")
    code, words = said_after(run, (run / ".film.gif.part.frames").touch)
    assert code == 1 and str(run / ".film.gif.part.frames") in words, words
    code, words = said_after(run, lambda: [(run / "folder").mkdir(), (run / "folder" / "a.png").touch()])
    assert code == 1 and f"{run / 'folder'} with a.png, last changed" in words, words
    code, words = said_after(run, lambda: [(shared / new).mkdir() for new in ("poinsot_fuzz_1", "of_others", "poinsot-tests-of-another-run", "poinsot-test-by-hand")])
    assert code == 1 and words.count("\n") == 2 and str(shared / "poinsot_fuzz_1") in words, words
