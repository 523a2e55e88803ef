#!/usr/bin/env python3
"""What a clone weighs: git keeps every version of every file, so that a large file that changes often is paid for with each change.

Each file that git tracks is small, but for the list below, which may only shrink; and no commit adds much. Where there is no git, as in a
copy of the sources, only the files are weighed.
"""
import pathlib
import subprocess
import sys

ROOT = pathlib.Path(__file__).resolve().parents[2]
FOLDERS = ("src", "shaders", "scenes", "tests", "docs", ".ci")
NOT_OURS = ("node_modules", "__pycache__")
MOST_BYTES = 130_000
# Larger ones, each with the most that it may have.
LARGER = {
    "tests/golden/readme/rolling.gif": 2_200_000,                       # the README's first picture
    "tests/motion/measured/recording/round3_093502.csv": 1_260_000,     # a whole recording, without which no test finds throws
    "tests/motion/mechanics/reference/torque_free.json": 170_000,       # an independent answer
    "tests/golden/readme/tradeoff.png": 170_000,
    "tests/golden/readme/stability_map.png": 165_000,
}
# A renewal of all pictures; the last commits are asked.
MOST_BYTES_OF_A_COMMIT = 4_500_000
N_COMMITS = 20


def files():
    for folder in FOLDERS:
        for file in (ROOT / folder).rglob("*"):
            if file.is_file() and not any(part in NOT_OURS for part in file.parts):
                yield file


def of_files():
    sizes = {str(file.relative_to(ROOT)): file.stat().st_size for file in files()}
    tracked = git("ls-files", "-z")
    if tracked is not None:
        names = set(tracked.split("\0"))
        sizes = {name: size for name, size in sizes.items() if name in names}
    for name, size in sizes.items():
        most = LARGER.get(name, MOST_BYTES)
        if size > most:
            yield f"{name} has {size} bytes, {most} are allowed; make it smaller, or let a target make it"
    for name in LARGER:
        if sizes.get(name, 0) <= MOST_BYTES:
            yield f"{name} is not larger than others; take it out of the list"


def git(*words, text=None):
    done = subprocess.run(["git", "-C", ROOT, *words], input=text, capture_output=True, text=True)
    return done.stdout if done.returncode == 0 else None


def of_commits():
    commits = git("log", f"-{N_COMMITS}", "--no-merges", "--format=%H")
    for commit in (commits or "").split():
        changed = git("diff-tree", "-r", "--no-commit-id", commit)
        objects = {line.split()[3] for line in changed.splitlines() if not line.split()[3].startswith("0000")}
        size = sum(int(line) for line in git("cat-file", "--batch-check=%(objectsize)", text="\n".join(sorted(objects))).split())
        if size > MOST_BYTES_OF_A_COMMIT:
            yield f"commit {commit[:12]} adds {size} bytes, {MOST_BYTES_OF_A_COMMIT} are allowed"


if __name__ == "__main__":
    faults = [*of_files(), *of_commits()]
    print("\n".join(faults) or "small enough")
    sys.exit(bool(faults))
