#!/usr/bin/env python3
"""Checks the site that src/cmake/make_site.py makes: every link leads to a file of the site and to one of its headings, nothing is
loaded from elsewhere, every page says what it is about, every scene of the gallery opens in the workbench, downloads are offered, and a folder that is not a site is kept.

Usage: site_check.py [SITE]; without it, makes one in a temporary folder, with an empty file in place of the workbench.
"""
import html.parser
import pathlib
import re
import subprocess
import sys
import tempfile

ROOT = pathlib.Path(__file__).resolve().parents[2]
MAKE = ROOT / "src" / "cmake" / "make_site.py"
NAMES = {path.stem for path in (ROOT / "scenes").glob("*.toml")}


class Links(html.parser.HTMLParser):
    def __init__(self, text):
        super().__init__()
        self.followed, self.loaded, self.anchors = [], [], set()
        self.about = {}  # what search engines, mail and chat show
        self.feed(text)

    def handle_starttag(self, tag, attributes):
        values = dict(attributes)
        if "id" in values:
            self.anchors.add(values["id"])
        if tag == "meta" and "content" in values:
            self.about[values.get("name") or values.get("property")] = values["content"]
        if tag == "a" and "href" in values:
            self.followed.append(values["href"])
        elif values.get("rel") != "canonical" and ("href" in values or "src" in values):
            self.loaded.append(values.get("href") or values.get("src"))


def faults(site):
    # Examples are copied as they are.
    pages = {path: Links(path.read_text()) for path in site.rglob("*.html") if path.name != "poinsot.html" and "examples" not in path.parts}
    if len(pages) < 12:
        yield f"only {len(pages)} pages"
    opened = set()
    for page, links in pages.items():
        if page.name != "live.html":
            for name in ("description", "og:title", "og:description", "og:image"):
                if not 10 <= len(links.about.get(name, "")) <= 200 and (name != "og:image" or not links.about.get(name, "").endswith("card.png")):
                    yield f"{page.relative_to(site)}: {name} is {links.about.get(name)!r}"
        for link in links.loaded:
            if re.match(r"(?!data:)[a-z]+:|//", link):
                yield f"{page.relative_to(site)} loads {link}"
        for link in links.followed + links.loaded:
            path, _, anchor = link.partition("#")
            if re.match(r"(https?|mailto|data):", link):
                continue
            file = (page.parent / path).resolve() if path else page
            if not file.exists() or not file.is_relative_to(site):
                yield f"{page.relative_to(site)}: nothing is at {link}"
            elif file.name == "poinsot.html":
                opened |= {anchor.removeprefix("scene=")} if anchor.startswith("scene=") else set()
            elif anchor and anchor not in pages[file].anchors:
                yield f"{page.relative_to(site)}: {path or page.name} has no heading for #{anchor}"
    if opened != NAMES:
        yield f"scenes of the gallery that do not open in the workbench, or the other way round: {sorted(opened ^ NAMES)}"


def made(folder):
    """Makes a site with two downloads. Yields what is wrong."""
    workbench, downloads, site = folder / "poinsot.html", folder / "downloads", folder / "site"
    workbench.touch()
    downloads.mkdir()
    for name in ("poinsot-0.1.0-x86_64.tar.xz", "SHA256SUMS"):
        (downloads / name).write_text(name)
    subprocess.run([MAKE, ROOT, workbench, site, downloads], check=True)
    subprocess.run([MAKE, ROOT, workbench, site, downloads], check=True)  # its own site is replaced
    yield from faults(site)
    offered = Links((site / "download.html").read_text()).followed
    for name in ("poinsot.html", "poinsot-0.1.0-x86_64.tar.xz", "SHA256SUMS"):
        if name not in offered:
            yield f"download.html does not offer {name}"
    stranger = folder / "stranger"
    stranger.mkdir()
    (stranger / "precious").touch()
    refused = subprocess.run([MAKE, ROOT, workbench, stranger], capture_output=True, text=True)
    if refused.returncode == 0 or "no site of poinsot" not in refused.stderr or not (stranger / "precious").exists():
        yield f"a folder of others was not refused: {refused.stderr}"


def main():
    if len(sys.argv) == 2:
        found = list(faults(pathlib.Path(sys.argv[1]).resolve()))
    else:
        with tempfile.TemporaryDirectory() as folder:
            found = list(made(pathlib.Path(folder)))
    for fault in found:
        print(fault)
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main())
