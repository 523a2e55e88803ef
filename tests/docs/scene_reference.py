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
    "": "Keys before the first table of the file.",
    "body": "The body. Give exactly one of `moments_kg_m2`, `tensor_kg_m2`, `shape`, `[[body.masses]]`, `object` and `mesh`.",
    "body.masses[]": "Point masses, one table for each point.",
    "object": "How the body looks. These keys do not change its inertia.",
    "object.pictures[]": "Pictures on flat faces of the body, one table for each picture.",
    "start": "The motion at t = 0. A heavy top starts from `theta_rad` and its rates, every other motion from `omega_rad_s`.",
    "torque": "The torque on the body.",
    "measured": "A measured motion, which is drawn beside the exact one.",
    "motion": "How poinsot computes the motion.",
    "beside": "A second method, whose motion is drawn as a ghost for comparison.",
    "film": "The time span of the motion, and the film or still that shows it.",
    "camera": "The camera of the panels `space`, `object`, `top` and `sweep`.",
    "construction": "How Poinsot's construction is oriented in the picture, and what the film varies.",
    "trail": "Which parts of the polhode and the herpolhode are drawn.",
    "keyframes[]": "Values of the camera and the speed at given seconds of the film, one table for each keyframe.",
    "fades[]": "Elements that appear, disappear or change their opacity, one table for each fade.",
    "captions[]": "Text that is shown during a part of the film, one table for each text. Captions are also subtitles, in the film and in a file beside it.",
    "chapters[]": "Sections of the film, one table for each section.",
    "stops[]": "Instants at which a page waits for its viewer, one table for each stop. They come in order of time, at least a frame apart; a "
               "loop is not longer than the time since the last stop.",
    "page": "What the viewers of a page can change.",
    "symbols": "Symbols of quantities in labels. Each value is a formula.",
    "labels": "Labels moved by hand, as in `omega.offset_pt = [6.0, -4.0]`.",
    "style": "Values that override the theme. A theme file contains such lines without the header, and `extends = \"dark\"` at the top.",
    "marks[]": "Additional points, one table for each point.",
    "grid": "The grid whose cells hold the panels.",
    "panels[]": "Views of the same motion, one table for each panel.",
    "panels[].camera": "The camera of one panel, written below its `[[panels]]` table. The panels `space`, `object`, `top` and `sweep` take from `[camera]` the values that are not set here; `body` and `momentum` have their own defaults, in body axes.",
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


def summary_in_page(what, summary):
    """The summary of a name; the measured numbers of qualities are in docs/accuracy.md."""
    return summary.split("; picture: relative time ")[0] if what == "qualities" else summary


def header_of(table):
    if not table:
        return "Top of the file"
    return f"`[[{table[:-2]}]]`" if table.endswith("[]") else f"`[{table.replace('[]', '')}]`"


def key_sections(keys):
    """The keys by table, in the program's order."""
    sections = {}
    for path, summary in keys:
        table, _, leaf = path.rpartition(".")
        if table.startswith("labels."):  # one table for all labels
            table, leaf = path.split(".", 1)
        sections.setdefault(table, []).append((leaf, *summary.split("; ", 1)))
    for table, rows in sections.items():
        if table not in TABLES:
            sys.exit(f"scene_reference.py: describe [{table}] in TABLES")
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
             "This page lists every key of a scene file, and every name that a key accepts. `poinsot list keys` prints the same descriptions. "
             "A scene is a TOML file with strict keys: poinsot rejects an unknown key, a wrong type or a number out of range, and names "
             "the file, line and column. The command line can set any key, as in `--set film.speed=0.5` or "
             "`--set 'panels[0].kind=plan'`. The [guide](guide.md) explains how keys work together.", "",
             "`cmake --build build/release --target docs` generates this page from the program's tables; a test fails if the page is "
             "out of date.", "",
             "## Keys", ""]
    lines += key_sections(listed(program, "keys"))
    lines += ["## Names", ""]
    for what, key in LISTS.items():
        if what not in known:
            continue
        numbers = ", which also prints measured times and errors ([accuracy](accuracy.md#pixels))" if what == "qualities" else ""
        preposition = f"For `{key}`" if "." in key or key in ("show", "theme") else f"By {key}"
        lines += [f"### {what.capitalize()}", "", f"{preposition}; `poinsot list {what}`{numbers}.", "", "| name | |", "|---|---|"]
        lines += [f"| `{name}` | {in_table(summary_in_page(what, summary))} |" for name, summary in listed(program, what)]
        lines.append("")
    return "\n".join(lines).rstrip() + "\n"


if __name__ == "__main__":
    if len(sys.argv) != 3 or sys.argv[1] not in ("write", "check"):
        sys.exit(__doc__)
    text = page(sys.argv[2])
    if sys.argv[1] == "write":
        PAGE.write_text(text)
    elif not PAGE.exists() or PAGE.read_text() != text:
        sys.exit("docs/scene-reference.md does not match the program's tables; run: cmake --build build/release --target docs")
