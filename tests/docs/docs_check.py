#!/usr/bin/env python3
"""Checks the statements of the documents: links, sizes, files, tests, and command lines.

Usage: docs_check.py POINSOT WHAT
links:     every relative link of *.md and docs/*.md leads to an existing file, and to one of its headings.
readme:    README.md is at most 8192 bytes; its two commands, and each `./run WORD` of a document, exist.
files:     every path of src/, tests/, scenes/, shaders/ or .ci/ in backticks exists; `*` matches any name.
excerpts:  blocks that say to be lines of a scene are.
tests:     every test that docs/formulas.md names, as `Suite.Claim`, exists in tests/.
walks:     the sh blocks of the guide's walks run unchanged, one after the other, in a folder with only
           scenes; of films, only the first two frames are drawn.
commands:  every line with poinsot in an sh block has a command, options and scenes that the program knows.
"""
import pathlib
import re
import shlex
import subprocess
import sys
import tempfile

ROOT = pathlib.Path(__file__).resolve().parents[2]
PAGES = sorted(ROOT.glob("*.md")) + sorted((ROOT / "docs").glob("*.md"))
MOST_README_BYTES = 8192


def without_code(text):
    return re.sub(r"`[^`\n]*`", "", re.sub(r"^```.*?^```", "", text, flags=re.M | re.S))


def anchors_of(page):
    """Anchors of headings, as GitHub makes them."""
    headings = re.findall(r"^#+ +(.*)$", re.sub(r"^```.*?^```", "", page.read_text(), flags=re.M | re.S), re.M)
    return {re.sub(r"[^\w\- ]", "", heading.strip().lower()).replace(" ", "-") for heading in headings}


def links(_program):
    for page in PAGES:
        for target in re.findall(r"\]\(([^)\s]+)\)|(?:src|href)=\"([^\"]+)\"", without_code(page.read_text())):
            target = target[0] or target[1]
            if re.match(r"[a-z]+:", target):
                continue
            path, _, anchor = target.partition("#")
            file = (page.parent / path).resolve() if path else page
            if not file.exists():
                yield f"{page.relative_to(ROOT)}: no file is at {target}"
            elif anchor and anchor not in anchors_of(file):
                yield f"{page.relative_to(ROOT)}: {path or page.name} has no heading for #{anchor}"


def readme(_program):
    size = (ROOT / "README.md").stat().st_size
    if size > MOST_README_BYTES:
        yield f"README.md: {size} bytes, more than {MOST_README_BYTES}; move something to docs/"
    known = set(re.findall(r"^\./run (\w+)", subprocess.run([ROOT / "run"], capture_output=True, text=True, check=True).stdout, re.M))
    named = {page.name: set(re.findall(r"\./run (\w+)", page.read_text())) for page in PAGES}
    if known != {"film", "test"} or named["README.md"] != known:
        yield f"README.md names {sorted(named['README.md'])} of run, which says {sorted(known)}"
    for page, words in named.items():
        if words - known:
            yield f"{page}: run has no command {', '.join(words - known)}"


def files(_program):
    for page in PAGES:
        for path in re.findall(r"`((?:src|tests|scenes|shaders|\.ci)/[^`\s]*)`", page.read_text()):
            if "NAME" not in path and not any(ROOT.glob(path.rstrip("/"))):
                yield f"{page.relative_to(ROOT)}: no file is at {path}"


def excerpts(_program):
    """A block of TOML after "these lines of `scenes/NAME.toml`" has lines of that scene, comments aside."""
    for page in PAGES:
        for path, block in re.findall(r"these lines of `(scenes/[^`]*)`:\n\n```toml\n(.*?)^```", page.read_text(), re.M | re.S):
            known = {line.split("#")[0].strip() for line in (ROOT / path).read_text().splitlines()}
            for line in block.splitlines():
                if line.split("#")[0].strip() not in known:
                    yield f"{page.relative_to(ROOT)}: {path} has no line {line}"


def tests(_program):
    source = "\n".join(path.read_text() for path in (ROOT / "tests").rglob("*.cpp"))
    known = {".".join(pair) for pair in re.findall(r"TEST(?:_P|_F)?\((\w+),\s*(\w+)\)", source)}
    for test in re.findall(r"`([A-Z]\w+\.[A-Z]\w+)`", (ROOT / "docs" / "formulas.md").read_text()):
        if test not in known:
            yield f"docs/formulas.md: there is no test {test}"


def command_lines():
    for page in PAGES:
        for block in re.findall(r"^```sh\n(.*?)^```", page.read_text(), re.M | re.S):
            for line in block.replace("\\\n", " ").splitlines():
                words = shlex.split(line, comments=True)
                if words and pathlib.PurePath(words[0]).name == "poinsot":
                    yield page, words


def commands(program):
    helps = {}
    for page, words in command_lines():
        where = f"{page.relative_to(ROOT)}: {' '.join(words)}"
        command = words[1] if len(words) > 1 else ""
        if command not in helps:
            done = subprocess.run([program, command, "--help"], capture_output=True, text=True)
            helps[command] = done.stdout if done.returncode == 0 else None
        if helps[command] is None:
            yield f"{where}: there is no such command"
            continue
        known = set(re.findall(r"(?<![\w-])--?[a-z][\w-]*", helps[command]))
        for word in words[2:]:
            if re.match(r"--?[a-z]", word) and word.split("=")[0] not in known:
                yield f"{where}: {command} has no {word}"
            if word.startswith("scenes/") and not any(ROOT.glob(word)):
                yield f"{where}: there is no {word}"


def walks(program):
    guide = (ROOT / "docs" / "guide.md").read_text()
    walked = re.search(r"^## Three walkthroughs\n(.*?)^## ", guide, re.M | re.S).group(1)
    blocks = re.findall(r"^```sh\n(.*?)^```", walked, re.M | re.S)
    if len(blocks) < 3:
        yield f"docs/guide.md: three walks with {len(blocks)} blocks of sh"
    brief = f"""set -e
poinsot() {{
    case $1 in
    render) command "{program}" "$@" --frames 0-1 --size 320x180 ;;
    *) command "{program}" "$@" ;;
    esac
}}
"""
    with tempfile.TemporaryDirectory() as folder:
        (pathlib.Path(folder) / "scenes").symlink_to(ROOT / "scenes")
        for block in blocks:
            done = subprocess.run(["sh", "-c", brief + "set -x\n" + block], cwd=folder, capture_output=True, text=True)
            if done.returncode != 0:
                yield f"docs/guide.md: a walk ends with {done.returncode}:\n{block}{done.stderr[-2000:]}"


if __name__ == "__main__":
    checks = {check.__name__: check for check in (links, readme, files, excerpts, tests, commands, walks)}
    if len(sys.argv) != 3 or sys.argv[2] not in checks:
        sys.exit(__doc__)
    faults = list(checks[sys.argv[2]](sys.argv[1]))
    print("\n".join(faults))
    sys.exit(1 if faults else 0)
