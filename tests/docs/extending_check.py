"""The numbers of files in docs/extending.md: counted from what is there already.

For each kind of addition the files that name an existing one, such as the limit max_flip, are the files that one more would touch; of some
kinds also the one that is named in most files. The test fails when a heading has another number: when it is smaller, a table has been typed
a second time.
Usage: extending_check.py
"""

import pathlib
import re
import sys

ROOT = pathlib.Path(__file__).resolve().parents[2]
# Written from the tables of options and of limits: `ninja keywords`.
GENERATED = re.compile(r"( *)# keywords of \w+\n.*?# end\n", re.S)
SUFFIXES = (".cpp", ".h", ".py", ".pyi", ".js", ".html")
# The beginning of a heading, and the names by which an existing one is found.
EXISTING = {
    "An element": r"period-turn|period_turn",
    "A panel": r"make_potential_panel",
    "A physical quantity": r'"contact_space"',
    "A plot quantity": r'"wobble"|wobble_values',
    "A format": r"(open|recover|join)_gif",
    "A scene key": r"&Scene::labels\b|bool labels\b",
    "A torque": r"\bDrag(?:::|[{>;]|& drag\b| \{)|linear_1_s",
    "An integrator": r"\bsplitting\(const MethodStart|make = splitting",
    "A command": r"explain_command",
    "An option of `still`": r"\bkeep_text\b",
    "A limit of `compare`": r"\b(min|least)_ssim\b",
    "A theme": r'"colour-blind"',
    "A quality": r'"reference"',
    "A shape": r"\bConePass\b|std::vector<Cone>",
    "A function of the library and of Python": r"\btop_constants\b",
    "A real object": r"\bt_handle\(\)|object_makers::t_handle\b",
    "A control": r"'torque\.half_life_s': \[",
}
# The dearest example of a kind, which a heading names after a semicolon.
DEAREST = {
    "A format": r"\.mov\b|\"mov\"|_mov\b",
    "An option of `still`": r"\blettering\b",
    "A shape": r"\bCone(Pass)?\b|\bcones\b",
}
DEAREST_IN = {"A shape": "src/picture/"}


def main():
    texts = {file.relative_to(ROOT): GENERATED.sub("", file.read_text("utf-8")) for file in sorted((ROOT / "src").rglob("*"))
             if file.suffix in SUFFIXES and file.is_file() and "node_modules" not in file.parts}
    headings = re.findall(r"^## (.*) \((\d+)(?: to (\d+))? files?\b[^;\n]*(?:; (\d+) .*)?\)$",
                          (ROOT / "docs/extending.md").read_text("utf-8"), re.M)
    wrong = []
    counted = set()
    for name, least, most, dearest in headings:
        if name in DEAREST or dearest:
            files = [str(file) for file, text in texts.items()
                     if str(file).startswith(DEAREST_IN.get(name, "src/")) and re.search(DEAREST.get(name, "$^"), text)]
            if str(len(files)) != dearest:
                wrong.append(f"docs/extending.md: the dearest of \"{name}\" touches {len(files)} files, not {dearest or 'none'}: {', '.join(files)}")
        if name not in EXISTING:
            continue
        counted.add(name)
        files = [str(file) for file, text in texts.items() if re.search(EXISTING[name], text)]
        if not int(least) <= len(files) <= int(most or least):
            wrong.append(f"docs/extending.md: \"{name}\" touches {len(files)} files, not {most or least}: {', '.join(files)}")
    wrong += [f"docs/extending.md: no heading \"{name} (N files)\"" for name in EXISTING.keys() - counted]
    sys.exit("\n".join(wrong) or None)


main()
