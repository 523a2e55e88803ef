#!/usr/bin/env python3
"""docs/lecture.md says what the scenes of the lecture say: times, titles, pages and notes of the stops, from scene to scene.

A note has a paragraph, the formula and what students ask; the script repeats them, with emphasis, and adds other scenes. The planned times
add up to 45 minutes.
Usage: lecture_check.py
"""
import pathlib
import re
import sys
import tomllib

ROOT = pathlib.Path(__file__).resolve().parents[2]


def plain(text):
    """The text without line breaks, emphasis and code."""
    return re.sub(r"\s+", " ", re.sub(r"[*`]", "", text)).strip()


def scenes_of(first):
    """Name and content of each scene, from the first to the last that [page] next leads to."""
    name = first
    while name:
        scene = tomllib.loads((ROOT / f"scenes/{name}.toml").read_text())
        yield name, scene
        name = scene["page"].get("next", "").removesuffix(".html")


def clock(seconds):
    return f"{int(seconds) // 60}:{int(seconds) % 60:02}"


def rows_of(script):
    """The rows of the table of times: number, scene, film, clock, title, page."""
    return [tuple(plain(cell) for cell in row.split("|")[1:-1]) for row in re.findall(r"^\| \d+ \|.*$", script, re.M)]


def sections_of(script):
    """Heading, paragraph and the items that a note has, of each stop."""
    stops = script.split("\n## Stop by stop\n")[1].split("\n## ")[0]
    stops = re.sub(r"^### .*\n", "", stops, flags=re.M)
    for section in re.split(r"^#### ", stops, flags=re.M)[1:]:
        heading, paragraph, *items = section.split("\n\n")
        items = re.split(r"^- ", "\n".join(items), flags=re.M)[1:]
        yield heading, plain(paragraph), [plain(item) for item in items if item.startswith(("**Formula", "**Students"))]


def main():
    script = (ROOT / "docs/lecture.md").read_text()
    rows, sections = rows_of(script), list(sections_of(script))
    stops = []
    begins_s = 0.0
    for name, scene in scenes_of("tensor"):
        stops += [(name, begins_s, stop) for stop in scene["stops"]]
        planned = [stop["planned_s"] for stop in scene["stops"]] + [scene["page"]["planned_s"]]
        if planned != sorted(set(planned)) or planned[0] != 0.0:
            print(f"scenes/{name}.toml: the planned times of its stops are {planned}")
            return 1
        begins_s += scene["page"]["planned_s"]
    wrong = [] if begins_s == 2700.0 else [f"the planned times add up to {clock(begins_s)}"]
    if not len(rows) == len(sections) == len(stops):
        wrong.append(f"{len(stops)} stops, {len(rows)} rows, {len(sections)} sections")
    for number, ((name, before_s, stop), row, section) in enumerate(zip(stops, rows, sections), 1):
        paragraph, *others = stop["note"].split("\n\n")
        page = re.match(r"Pages? ([\d–]+)\. ", paragraph)
        paragraph = paragraph[page.end():] if page else paragraph
        expected = ((str(number), name, f"{stop['at_s']:g} s", clock(before_s + stop["planned_s"]), stop["title"], page[1] if page else ""),
                    (f"{number}. {stop['title']}", plain(paragraph), [plain(other) for other in others]))
        for said, meant in zip((row, section), expected):
            if said != meant:
                wrong.append(f"stop {number}: docs/lecture.md has {said}, scenes/{name}.toml has {meant}")
    for line in wrong:
        print(line)
    return 1 if wrong else 0


if __name__ == "__main__":
    sys.exit(main())
