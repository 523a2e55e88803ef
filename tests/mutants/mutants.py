#!/usr/bin/env python3
"""Changes one token of a source at a time, runs the tests that could notice it, and prints which tests do.

Usage: mutants.py BUILD [--only K,K,…] [--tests REGEX] [--jobs N]
       mutants.py --make N [--seed S]
       mutants.py --check
BUILD is a built release tree. The mutants are the lines of mutants.txt, which `--make` draws from the sources in SOURCES: an operator,
a constant, or the member that a row names. No file of the tree changes: the unity file with the mutant is compiled into a temporary
folder, and programs are linked there with its object before the libraries.
`--check` looks for the sources, and for the line of each mutant.
Exit code 1 if a mutant survives that mutants.txt does not mark with "lives: REASON"; 2 if a test fails without a change.
"""
import argparse
import concurrent.futures
import json
import os
import pathlib
import random
import re
import shlex
import subprocess
import sys
import tempfile
import time

ROOT = pathlib.Path(__file__).resolve().parents[2]
LIST = pathlib.Path(__file__).with_suffix(".txt")
SEED = 4179
# A source, and the tests (regular expressions of CTest names) that could see a change of it. Not those of tests/doors/cli: they run the
# program of the build, whose path is compiled into them.
SCENE = r"scene\.|docs\.schema$"
SOURCES = {
    **{f"src/motion/scene/{name}.cpp": SCENE for name in (
        "body_keys", "camera_keys", "film_keys", "motion_keys", "name_keys", "picture_keys", "story_keys", "style_keys", "scene_key_rows",
        "value_type", "given_value", "complete_body", "complete_faces", "complete_film", "complete_object", "complete_start",
        "complete_style", "draft_checks", "frame_rate", "track", "film_clock", "write_scene", "toml/toml_text")},
    "src/outputs/compare/given_limits.cpp": r"compare\.",
    "src/outputs/compare/compare_file.cpp": r"compare\.",
    "src/outputs/compare/compare.cpp": r"compare\.",
    "src/motion/construction/quantities.cpp": r"construction\.|production\.Column|library\.[A-Z]",
    "src/motion/construction/polhode.cpp": r"construction\.",
    "src/motion/construction/poinsot_construction.cpp": r"construction\.|library\.[A-Z]",
    "src/outputs/encoding/packet_film.cpp": r"encoding\.|trust\.output_sequences$|production\.",
    "src/outputs/encoding/frame_log.cpp": r"encoding\.|trust\.output_sequences$",
    "src/picture/vector/passes/curves.cpp": r"vector\.",
    "src/picture/vector/occluders.cpp": r"vector\.",
    "src/picture/vector/conic.cpp": r"vector\.",
    "src/picture/vector/passes/plane.cpp": r"vector\.",
    "src/picture/vector/passes/arrows.cpp": r"vector\.",
    "src/picture/vector/passes/arrow_shape.cpp": r"vector\.",
    "src/picture/vector/passes/arrow_strands.cpp": r"vector\.",
    "src/picture/shapes/outlines.cpp": r"shapes\.|vector\.",
    "src/picture/shapes/projection.cpp": r"shapes\.|vector\.|drawing\.",
}
# Browsers need more address space than a mutant may have.
NEVER = r"Browser"

OPERATORS = {"<": "<=", "<=": "<", ">": ">=", ">=": ">", "==": "!=", "!=": "==", "&&": "||", "||": "&&", "+": "-", "-": "+", "*": "/",
             "/": "*", "+=": "-=", "-=": "+="}
TOKEN = re.compile(r"""
    (?P<skip>//[^\n]*|/\*.*?\*/|\#[^\n]*|R"\((?:.|\n)*?\)"|"(?:\\.|[^"\\\n])*"|'(?:\\.|[^'\\\n])*'|static_assert[^;]*;)
  | (?P<number>(?<![\w.])\d[\w.]*(?:(?<=[eE])[-+]\d+)?)
  | (?P<word>[A-Za-z_]\w*)
  | (?P<operator>(?<=[ ])(?:<=|>=|==|!=|&&|\|\||\+=|-=|<|>|\+|-|\*|/)(?=[ \n]))
""", re.VERBOSE | re.DOTALL)
MEMBER = re.compile(r"(\w+)(\.|->|::)$")


def candidates(text):
    """Every change of one token: (kind, offset, old, new)."""
    members = {}
    words = []
    for token in TOKEN.finditer(text):
        kind, old, at = token.lastgroup, token.group(), token.start()
        if kind == "operator" and not text.startswith("&& {", at):  # a member function of an rvalue
            yield "operator", at, old, OPERATORS[old]
        elif kind == "number" and re.fullmatch(r"\d+|\d+\.\d*(e[-+]?\d+)?|\d+e[-+]?\d+", old):
            is_whole = old.isdigit()
            yield "constant", at, old, str(int(old) + 1) if is_whole else repr(float(old) * 1.5 or 0.5)
        elif kind == "word" and old in ("true", "false"):
            yield "constant", at, old, "false" if old == "true" else "true"
        elif kind == "word":
            owner = MEMBER.search(text, max(0, at - 60), at)
            if owner and owner.group(1) not in ("std", "fmt", "Eigen") and text[token.end():token.end() + 1] not in ("(", ":", "<"):
                members.setdefault(owner.group(1), []).append(old)
                words.append((owner.group(1), at, old))
    for owner, at, old in words:
        others = sorted(set(members[owner]) - {old})
        if others:
            # The member that a careless copy would name: the next one in the alphabet.
            yield "member", at, old, min((other for other in others if other > old), default=others[0])


class Mutant:
    """A line of the list: `FILE:LINE:COLUMN OLD NEW | the line`, and perhaps ` | lives: why`."""

    def __init__(self, row):
        place, old, new, self.line, *rest = re.fullmatch(r"(\S+) (\S+) (\S+) \| (.*?)(?: \| lives: (.*))?", row).groups()
        self.file, line, column = place.rsplit(":", 2)
        self.at, self.column, self.old, self.new, self.lives = int(line), int(column), old, new, rest[0]
        self.place = f"{self.file}:{self.at}"

    def __str__(self):
        return f"{self.file}:{self.at}:{self.column} {self.old} {self.new} | {self.line}" + (f" | lives: {self.lives}" if self.lives else "")

    def text(self):
        """The mutated source; None if it no longer has the line."""
        lines = (ROOT / self.file).read_text().split("\n")
        same = [k for k, line in enumerate(lines) if line.strip() == self.line]
        if not same:
            return None
        k = min(same, key=lambda k: abs(k + 1 - self.at))
        self.place = f"{self.file}:{k + 1}"
        indent = len(lines[k]) - len(lines[k].lstrip())
        start = indent + self.column
        assert lines[k][start:start + len(self.old)] == self.old, self
        lines[k] = lines[k][:start] + self.new + lines[k][start + len(self.old):]
        return "\n".join(lines)


def make(n, seed):
    """n mutants, of all sources in turn and of each kind as often as the other kinds."""
    dice = random.Random(seed)
    pools = {}
    for file in SOURCES:
        text = (ROOT / file).read_text()
        kinds = {}
        for kind, *change in candidates(text):
            kinds.setdefault(kind, []).append(change)
        for changes in kinds.values():
            dice.shuffle(changes)
        pools[file] = (text, kinds)
    rows = []
    while len(rows) < n:
        files = list(pools)
        dice.shuffle(files)
        for file in files:
            text, kinds = pools[file]
            left = sorted(kind for kind in kinds if kinds[kind])
            if not left:
                continue
            at, old, new = kinds[dice.choice(left)].pop()
            begin = text.rfind("\n", 0, at) + 1
            line = text[begin:text.find("\n", at)]
            column = at - begin - (len(line) - len(line.lstrip()))
            rows.append(f"{file}:{text.count(chr(10), 0, at) + 1}:{column} {old} {new} | {line.strip()}")
    return rows[:n]


def check():
    """Whether all sources are there, and the line of each mutant in one of them."""
    wrong = [f"{file}: no such file" for file in SOURCES if not (ROOT / file).is_file()]
    for row in LIST.read_text().splitlines():
        mutant = Mutant(row)
        if mutant.file not in SOURCES:
            wrong.append(f"{mutant}: its file is not among SOURCES")
        elif (ROOT / mutant.file).is_file() and mutant.text() is None:
            wrong.append(f"{mutant}: the line is gone; take another mutant")
    print("\n".join(wrong or [f"{len(SOURCES)} sources, and all lines of {LIST.name}"]))
    return 1 if wrong else 0


class Build:
    """How a built tree compiles, links and tests."""

    def __init__(self, folder):
        self.folder = folder.resolve()
        self.units = {}
        for entry in json.loads((self.folder / "compile_commands.json").read_text()):
            for source in re.findall(r'#include "([^"]*)"', pathlib.Path(entry["file"]).read_text()) if "/Unity/" in entry["file"] else [entry["file"]]:
                # A library's unit, before those of tests and of the page.
                if "/src/" in entry["file"]:
                    self.units.setdefault(source, entry)
        # This program may itself be a test of a run, whose temporary folder is not the one of this ctest.
        own = {name: value for name, value in os.environ.items() if name != "POINSOT_TEST_FOLDER"}
        shown = subprocess.run(["ctest", "--show-only=json-v1"], cwd=self.folder, env=own, capture_output=True, text=True, check=True)
        self.tests = [test for test in json.loads(shown.stdout)["tests"] if "command" in test]
        for test in self.tests:
            test["of"] = {one["name"]: one["value"] for one in test.get("properties", [])}
        # Programs of the tree, by path.
        self.targets = {}
        for line in subprocess.run(["ninja", "-t", "targets", "all"], cwd=self.folder, capture_output=True, text=True, check=True).stdout.splitlines():
            name, _, rule = line.partition(": ")
            if rule.startswith("CXX_EXECUTABLE_LINKER"):
                self.targets[str(self.folder / name)] = name

    def tests_for(self, pattern, further):
        return [test for test in self.tests
                if re.search(pattern, test["name"]) and re.search(further, test["name"]) and not re.search(NEVER, test["name"])
                and "slow" not in test["of"].get("LABELS", []) and not test["of"].get("DISABLED")]

    def link_of(self, target):
        commands = subprocess.run(["ninja", "-t", "commands", target], cwd=self.folder, capture_output=True, text=True, check=True).stdout
        link = next(part for part in commands.strip().split("\n")[-1].split(" && ") if f" -o {target} " in part)
        return shlex.split(link)

    def compile(self, mutant, text, folder):
        """The object of the unity file with the mutant; None if the mutant is not C++."""
        source = str(ROOT / mutant.file)
        entry = self.units[source]
        changed = folder / pathlib.Path(source).name
        # Headers of its own folder are found there.
        changed.write_text(f'#line 1 "{source}"\n{text}')
        unit = folder / "unit.cpp"
        original = pathlib.Path(entry["file"]).read_text() if "/Unity/" in entry["file"] else f'#include "{source}"\n'
        unit.write_text(original.replace(f'"{source}"', f'"{changed}"'))
        words = shlex.split(entry["command"])
        words[words.index("-o") + 1] = str(folder / "unit.o")
        words[words.index("-c") + 1] = str(unit)
        words = [word for word in words if not word.startswith("-W") and not word.endswith("ccache") and word != "-O3"]
        words += ["-O1", "-w", "-iquote", str(pathlib.Path(source).parent)]
        done = subprocess.run(words, cwd=entry["directory"], capture_output=True, text=True)
        return folder / "unit.o" if done.returncode == 0 else None

    def link(self, program, unit, folder):
        target = self.targets[program]
        words = self.link_of(target)
        made = folder / pathlib.Path(program).name
        words[words.index("-o") + 1] = str(made)
        # The first definition is taken.
        first = next(k for k, word in enumerate(words) if word.endswith(".o"))
        words[first:first] = [str(unit), "-Wl,--allow-multiple-definition"]
        done = subprocess.run(words, cwd=self.folder, capture_output=True, text=True)
        if done.returncode:
            sys.exit(f"mutants: {target} does not link: {done.stderr[-2000:]}")
        return str(made)


def run(command, test, folder, seconds):
    environment = dict(os.environ, TMPDIR=str(folder / "tmp"))
    for setting in test["of"].get("ENVIRONMENT", []):
        name, _, value = setting.partition("=")
        environment[name] = value
    # A loop without an end must not take all memory.
    command = ["prlimit", f"--as={12 << 30}", *command]
    try:
        done = subprocess.run(command, cwd=test["of"].get("WORKING_DIRECTORY", folder), env=environment, stdin=subprocess.DEVNULL,
                              capture_output=True, timeout=seconds, start_new_session=True)
        return done.returncode
    except subprocess.TimeoutExpired:
        return "too long"


def failures(tests, program_of, folder):
    """The names of those tests that fail, with the programs that program_of gives for those of the build."""
    failed, of_program = [], {}
    for test in tests:
        # A test of GoogleTest is run with the others of its program.
        is_google = len(test["command"]) > 1 and test["command"][1].startswith("--gtest_filter=")
        of_program.setdefault(test["command"][0] if is_google else test["name"], []).append(test)
    for name, group in of_program.items():
        command = [program_of(word) for word in group[0]["command"]]
        if name == group[0]["name"]:
            if run(command, group[0], folder, 300) not in (0, 77):
                failed.append(name)
            continue
        filters = ":".join(test["command"][1].partition("=")[2] for test in group)
        report = folder / "report.json"
        report.unlink(missing_ok=True)
        code = run([command[0], f"--gtest_filter={filters}", "--gtest_brief=1", f"--gtest_output=json:{report}"], group[0], folder, 600)
        prefix = group[0]["name"].partition(".")[0]
        if report.exists() and code in (0, 1):
            failed += [f"{prefix}.{suite['name']}.{case['name']}" for suite in json.loads(report.read_text())["testsuites"]
                       for case in suite["testsuite"] if case.get("failures")]
        else:
            failed.append(f"{prefix} ({'takes too long' if code == 'too long' else 'crashes'})")
    return failed


def killers_of(build, mutant, tests):
    """The names of the tests that fail; or a word: gone (from the source), invalid (C++)."""
    text = mutant.text()
    if text is None:
        return "gone"
    with tempfile.TemporaryDirectory(prefix="poinsot-mutant-") as made:
        folder = pathlib.Path(made)
        (folder / "tmp").mkdir()
        unit = build.compile(mutant, text, folder)
        if unit is None:
            return "invalid"
        linked = {}

        def program_of(word):
            if word in build.targets and word not in linked:
                linked[word] = build.link(word, unit, folder)
            return linked.get(word, word)
        return failures(tests, program_of, folder)


def failing_already(build, tests):
    with tempfile.TemporaryDirectory(prefix="poinsot-mutant-") as made:
        folder = pathlib.Path(made)
        (folder / "tmp").mkdir()
        return failures(tests, lambda word: word, folder)


def main():
    parser = argparse.ArgumentParser(usage=__doc__.split("\n\n")[1])
    parser.add_argument("build", nargs="?", type=pathlib.Path)
    parser.add_argument("--make", type=int)
    parser.add_argument("--seed", type=int, default=SEED)
    parser.add_argument("--check", action="store_true")
    parser.add_argument("--only")
    parser.add_argument("--tests", default="")
    parser.add_argument("--jobs", type=int, default=2)
    given = parser.parse_args()
    if given.make:
        LIST.write_text("\n".join(make(given.make, given.seed)) + "\n")
        return 0
    if given.check:
        return check()
    if not given.build:
        parser.error("name the build folder, for example build/release")
    mutants = dict(enumerate(map(Mutant, LIST.read_text().splitlines()), 1))
    wanted = [int(k) for k in given.only.split(",")] if given.only else list(mutants)
    build = Build(given.build)
    tests_of = {k: build.tests_for(SOURCES[mutants[k].file], given.tests) for k in wanted}
    already = failing_already(build, list({test["name"]: test for tests in tests_of.values() for test in tests}.values()))
    if already:
        print(f"mutants: these tests fail without a change: {', '.join(already)}")
        return 2
    survivors, alone, of_test, counts = [], {}, {}, {"killed": 0, "lives": 0, "gone": 0, "invalid": 0}
    with concurrent.futures.ThreadPoolExecutor(given.jobs) as pool:
        def timed(k):
            begin = time.monotonic()
            return killers_of(build, mutants[k], tests_of[k]), time.monotonic() - begin
        for k, (killers, seconds) in zip(wanted, pool.map(timed, wanted)):
            mutant = mutants[k]
            fate = killers if isinstance(killers, str) else "killed" if killers else "lives"
            counts[fate] += 1
            said = fate if fate != "killed" else f"killed by {len(killers)}: {', '.join(killers[:3])}{' …' if len(killers) > 3 else ''}"
            print(f"{k:3} {mutant.place} {mutant.old} → {mutant.new}: {said} ({seconds:.0f} s)", flush=True)
            if fate == "lives" and not mutant.lives:
                survivors.append(k)
            for name in killers if fate == "killed" else []:
                suite = name.rsplit(".", 1)[0] if name.count(".") > 1 else name
                of_test.setdefault(suite, set()).add(k)
            suites = [suite for suite, killed in of_test.items() if k in killed]
            if len(suites) == 1:
                alone[suites[0]] = alone.get(suites[0], 0) + 1
    print(", ".join(f"{n} {fate}" for fate, n in counts.items() if n))
    print("suite of tests: mutants killed, and those that no other suite kills")
    for suite, killed in sorted(of_test.items(), key=lambda one: -len(one[1])):
        print(f"  {suite}: {len(killed)}, {alone.get(suite, 0)}")
    if survivors:
        print(f"survivors without a reason in {LIST.name}: {', '.join(map(str, survivors))}")
    return 1 if survivors else 0


if __name__ == "__main__":
    sys.exit(main())
