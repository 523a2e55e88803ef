"""Finds what a run of the tests leaves behind: in its own temporary folder anything, in shared folders what is named like ours.

Usage: left_behind.py before | after   (ctest calls both: tests/CTestCustom.cmake.in)
"""
import json
import os
import pathlib
import re
import shutil
import sys
import time

# What lies in shared folders before the run, and the settings of programs: removed with the folder.
LIST, SETTINGS = ".before", ".config"
# Chromium may remove its last files after the test that started it.
PATIENCE_S = 5.0


def shared_folders():
    """The folders that everybody writes to, and the user's cache."""
    cache = os.environ.get("XDG_CACHE_HOME") or os.path.expanduser("~/.cache")
    return ["/tmp", "/var/tmp", "/dev/shm", cache]


def ours_in_shared():
    """What is there and named like ours, except the folders of other runs and of tests that somebody starts by hand."""
    found = []
    for folder in shared_folders():
        try:
            names = os.listdir(folder)
        except OSError:
            continue
        found += [os.path.join(folder, name) for name in names
                  if "poinsot" in name.lower() and not re.match("poinsot[-_]tests?[-_]", name)]
    return found


def before(run):
    run.mkdir(parents=True)
    # Some tests write as another user.
    run.chmod(0o1777)
    (run / LIST).write_text(json.dumps(ours_in_shared()))


def left_in(run):
    """What is in the run's folder, and what is new in the shared ones."""
    there = set(json.loads((run / LIST).read_text()))
    own = [str(path) for path in run.iterdir() if path.name not in (LIST, SETTINGS)]
    return sorted(own) + sorted(set(ours_in_shared()) - there)


def in_words(path):
    """A file, or a folder with some of what is in it."""
    most = 4
    inside = sorted(str(one.relative_to(path)) for one in pathlib.Path(path).rglob("*"))
    words = f" with {', '.join(inside[:most])}{', …' if len(inside) > most else ''}" if inside else ""
    changed = max((os.lstat(one).st_mtime for one in [path, *(os.path.join(path, name) for name in inside)]), default=0.0)
    return f"{path}{words}, last changed at {time.strftime('%H:%M:%S', time.localtime(changed))}"


def after(run):
    end = time.monotonic() + PATIENCE_S
    while (left := left_in(run)) and time.monotonic() < end:
        time.sleep(0.1)
    for path in left:
        print(f"the tests left behind {in_words(path)}")
    if left:
        print("Testing/Temporary/LastTest.log of the build says which tests ran then")
    shutil.rmtree(run, ignore_errors=True)
    return 1 if left else 0


def main():
    run = pathlib.Path(os.environ["POINSOT_TEST_FOLDER"])
    if sys.argv[1:] == ["before"]:
        before(run)
    elif sys.argv[1:] == ["after"]:
        sys.exit(after(run))
    else:
        sys.exit(__doc__)


if __name__ == "__main__":
    main()
