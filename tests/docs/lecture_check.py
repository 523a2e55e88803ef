#!/usr/bin/env python3
"""docs/lecture.md says what scenes/lecture.toml says: times, titles, pages and notes of the stops.

A note has a paragraph, the formula and what students ask; the script repeats them, with emphasis, and adds other scenes.
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


def rows_of(script):
    """The rows of the table of times: number, film, clock, title, page."""
    return [tuple(cell.strip() for cell in row.split("|")[1:-1]) for row in re.findall(r"^\| \d+ \|.*$", script, re.M)]


def sections_of(script):
    """Heading, paragraph and the items that a note has, of each stop."""
    stops = script.split("\n## Stop by stop\n")[1].split("\n## ")[0]
    for section in re.split(r"^### ", stops, flags=re.M)[1:]:
        heading, paragraph, *items = section.split("\n\n")
        items = re.split(r"^- ", "\n".join(items), flags=re.M)[1:]
        yield heading, plain(paragraph), [plain(item) for item in items if item.startswith(("**Formula", "**Students"))]


def main():
    stops = tomllib.loads((ROOT / "scenes/lecture.toml").read_text())["stops"]
    script = (ROOT / "docs/lecture.md").read_text()
    rows, sections = rows_of(script), list(sections_of(script))
    wrong = [] if len(rows) == len(sections) == len(stops) else [f"{len(stops)} stops, {len(rows)} rows, {len(sections)} sections"]
    for number, (stop, row, section) in enumerate(zip(stops, rows, sections), 1):
        paragraph, *others = stop["note"].split("\n\n")
        page = re.match(r"(?:Lecture, page|Page) ([\d–]+)\. ", paragraph)
        paragraph = paragraph[page.end():] if page else paragraph
        planned = int(stop["planned_s"])
        expected = ((str(number), f"{stop['at_s']:g} s", f"{planned // 60}:{planned % 60:02}", stop["title"], page[1] if page else ""),
                    (f"{number}. {stop['title']}", plain(paragraph), [plain(other) for other in others]))
        for said, meant in zip((row, section), expected):
            if said != meant:
                wrong.append(f"stop {number}: docs/lecture.md has {said}, scenes/lecture.toml has {meant}")
    for line in wrong:
        print(line)
    return 1 if wrong else 0


if __name__ == "__main__":
    sys.exit(main())
