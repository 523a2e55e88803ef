#!/usr/bin/env python3
"""Generates docs/scene-reference.md from the lists that the program prints of its own tables.

Usage: scene_reference.py write POINSOT     (or: cmake --build build/release --target docs)
       scene_reference.py check POINSOT     exit code 1 if the page is out of date
"""
import json
import pathlib
import subprocess
import sys

PAGE = pathlib.Path(__file__).resolve().parents[2] / "docs" / "scene-reference.md"
# Table of the scene file → introduction of its keys.
TABLES = {
    "": "At the top of the file, before any table.",
    "body": "What turns, in exactly one of these ways: `moments_kg_m2`, `tensor_kg_m2`, `shape`, `[[body.masses]]`, `object` or `mesh`.",
    "body.masses[]": "Point masses, one table each.",
    "object": "What the body looks like, where it does not say so itself, and what is told apart of it.",
    "object.pictures[]": "Pictures on its flat faces, one table each.",
    "start": "The motion at t = 0. A heavy top starts from `theta_rad` and its rates, everything else from `omega_rad_s`.",
    "torque": "What acts on the body.",
    "motion": "How the motion is computed.",
    "beside": "A second method, drawn as a ghost.",
    "film": "The stretch of motion, and the film or still that shows it.",
    "camera": "From where it is seen.",
    "construction": "How Poinsot's construction stands in the picture.",
    "trail": "How much of the paths is shown.",
    "keyframes[]": "Camera and speed over the film, in seconds of film.",
    "fades[]": "What comes and goes.",
    "captions[]": "Text that comes and goes, in seconds of film; also subtitles, in a film and beside it.",
    "chapters[]": "Sections of the film.",
    "symbols": "Names of quantities in labels, as formulas.",
    "style": "What is drawn otherwise than the theme says. A file of such lines without the header, with `extends = \"dark\"` on top, is a theme.",
    "marks[]": "Points of one's own, one table each.",
    "grid": "Columns and rows that panels stand in.",
    "panels[]": "Views of the one motion, one table each.",
    "panels[].camera": "From where one panel is seen, below its `[[panels]]`. `space`, `object`, `top` and `sweep` take from `[camera]` what is not said here; `body` and `momentum`, in body axes, from where they are seen by themselves.",
}
# Lists of accepted names, with the key that accepts them.
LISTS = {
    "elements": "show", "panels": "panels[].kind", "quantities": "panels[].quantity", "themes": "theme", "methods": "motion.method",
    "qualities": "film.quality", "overlays": "show", "views": "camera.view", "easings": "keyframes[].easing", "solids": "body.shape",
    "objects": "body.object", "formats": "the name of the output", "columns": "`sample --columns`",
}


def in_table(text):
    return text.replace("|", "\\|")


def listed(program, what):
    done = subprocess.run([program, "list", what, "--json"], capture_output=True, text=True, check=True)
    return [(row["name"], row["summary"]) for row in json.loads(done.stdout)]


def header_of(table):
    if not table:
        return "Top of the file"
    return f"`[[{table[:-2]}]]`" if table.endswith("[]") else f"`[{table.replace('[]', '')}]`"


def key_sections(keys):
    """The keys by table, in the program's order."""
    sections = {}
    for path, summary in keys:
        table, _, leaf = path.rpartition(".")
        sections.setdefault(table, []).append((leaf, *summary.split("; ", 1)))
    for table, rows in sections.items():
        if table not in TABLES:
            sys.exit(f"scene_reference.py: say in TABLES what [{table}] is")
        yield f"### {header_of(table)}"
        yield ""
        yield TABLES[table]
        yield ""
        yield "| key | value | meaning |"
        yield "|---|---|---|"
        for leaf, value, meaning in rows:
            yield f"| `{leaf}` | {in_table(value)} | {in_table(meaning)} |"
        yield ""


def page(program):
    known = subprocess.run([program, "list"], capture_output=True, text=True, check=True).stdout.split()
    lines = ["# Scene reference", "",
             "Made from the program's own tables by `cmake --build build/release --target docs`; a test fails when it is stale. "
             "`poinsot list keys` prints the same. A scene is TOML with strict keys: an unknown key, a wrong type or a number "
             "out of its domain is refused with file, line and column. Any key may be set on the command line, as in "
             "`--set film.speed=0.5` or `--set 'panels[0].kind=plan'`. How keys work together: [guide](guide.md).", "",
             "## Keys", ""]
    lines += key_sections(listed(program, "keys"))
    lines += ["## Names", ""]
    for what, key in LISTS.items():
        if what not in known:
            continue
        lines += [f"### {what.capitalize()}", "", f"For `{key}`; `poinsot list {what}`." if "." in key or key in ("show", "theme")
                  else f"By {key}; `poinsot list {what}`.", "", "| name | |", "|---|---|"]
        lines += [f"| `{name}` | {in_table(summary)} |" for name, summary in listed(program, what)]
        lines.append("")
    return "\n".join(lines).rstrip() + "\n"


if __name__ == "__main__":
    if len(sys.argv) != 3 or sys.argv[1] not in ("write", "check"):
        sys.exit(__doc__)
    text = page(sys.argv[2])
    if sys.argv[1] == "write":
        PAGE.write_text(text)
    elif not PAGE.exists() or PAGE.read_text() != text:
        sys.exit("docs/scene-reference.md is not what the program's tables say; run: cmake --build build/release --target docs")
