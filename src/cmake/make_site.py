#!/usr/bin/env python3
"""Makes a static site of the README, the documents, the gallery and the workbench. It runs no script but that of the workbench, and
needs no server: it can be opened from its folder.

Usage: make_site.py SOURCE WORKBENCH SITE [DOWNLOADS]
SOURCE: the sources of poinsot. WORKBENCH: poinsot.html. SITE: the folder to write; it is emptied first, if this program wrote it.
DOWNLOADS: a folder of files that the page "Download" offers.
The pages are those of GitHub: cmark-gfm (Debian package of that name) reads the Markdown, and headings have GitHub's anchors. Pictures of
the gallery lead to their scenes in the workbench, so that all of them share one module.
"""
import html
import os
import pathlib
import re
import shutil
import subprocess
import sys

# Pages of the bar: file, name.
BAR = [("index.html", "poinsot"), ("docs/gallery.html", "Gallery"), ("poinsot.html", "Workbench"), ("docs/guide.html", "Guide"),
       ("docs/lecture.html", "Lecture"), ("docs/scene-reference.html", "Scene reference"), ("docs/python.html", "Python"),
       ("docs/regression.html", "Regression tests"), ("download.html", "Download")]
MARK = "made-by-poinsot-site"

STYLE = """
:root { color-scheme: light dark; --text: #1c2128; --ground: #fff; --line: #d5d9df; --quiet: #f3f5f8; --link: #2447a8; }
@media (prefers-color-scheme: dark) { :root { --text: #dfe3e8; --ground: #14181e; --line: #363d47; --quiet: #1d232b; --link: #8fb0ff; } }
* { box-sizing: border-box; }
body { margin: 0; color: var(--text); background: var(--ground); font: 17px/1.6 system-ui, sans-serif; }
a { color: var(--link); }
nav { display: flex; flex-wrap: wrap; gap: 0 1.2rem; padding: .7rem max(1rem, calc(50vw - 34rem)); border-bottom: 1px solid var(--line); }
nav a { text-decoration: none; padding: .15rem 0; }
nav a:first-child, nav a[aria-current] { font-weight: 600; }
main { max-width: 68rem; margin: 0 auto; padding: 1rem; }
h1, h2, h3 { line-height: 1.25; margin: 1.6em 0 .5em; }
h1 { margin-top: .6em; }
img { max-width: 100%; height: auto; background: #fff; border-radius: 4px; }
pre, code { font: .88em/1.5 ui-monospace, monospace; background: var(--quiet); border-radius: 4px; }
code { padding: .1em .3em; overflow-wrap: break-word; }
pre { padding: .8rem 1rem; overflow-x: auto; }
pre code { padding: 0; overflow-wrap: normal; }
.wide { overflow-x: auto; }
table { border-collapse: collapse; }
td, th { border: 1px solid var(--line); padding: .4rem .7rem; vertical-align: top; text-align: left; }
"""


def anchor_of(heading):
    """GitHub's anchor of a heading, given as HTML."""
    text = html.unescape(re.sub(r"<[^>]*>", "", heading))
    return re.sub(r"[^\w\- ]", "", text.strip().lower()).replace(" ", "-")


class Site:
    def __init__(self, source, workbench, folder, downloads):
        self.source, self.workbench, self.folder, self.downloads = source, workbench, folder, downloads
        self.icon = re.search(r'<link rel="icon"[^>]*>', (source / "src/doors/web/page" / "index.html").read_text())[0]

    def make(self):
        if self.folder.exists() and any(self.folder.iterdir()) and not (self.folder / MARK).exists():
            sys.exit(f"{self.folder}: exists, and is no site of poinsot; name another folder, or remove this one")
        shutil.rmtree(self.folder, ignore_errors=True)
        self.folder.mkdir(parents=True)
        (self.folder / MARK).touch()
        (self.folder / "style.css").write_text(STYLE.lstrip())
        shutil.copyfile(self.workbench, self.folder / "poinsot.html")
        # And those that these lead to.
        self.pages = [self.source / "README.md", *sorted((self.source / "docs").glob("*.md"))]
        for page in self.pages:
            self.write_page(page)
        self.write_downloads()

    def place_of(self, page):
        """Where a document lies in the site."""
        name = page.relative_to(self.source)
        return pathlib.Path("index.html") if str(name) == "README.md" else name.with_suffix(".html")

    def write_page(self, page):
        made = subprocess.run(["cmark-gfm", "--unsafe", "-e", "table", "-e", "strikethrough", page], check=True, capture_output=True, text=True).stdout
        place = self.place_of(page)
        taken = {}

        def heading(found):
            anchor = anchor_of(found[2])
            taken[anchor] = taken.get(anchor, -1) + 1
            if taken[anchor]:
                anchor += f"-{taken[anchor]}"
            return f'<h{found[1]} id="{html.escape(anchor)}">{found[2]}</h{found[1]}>'

        made = re.sub(r"<h([1-6])>(.*?)</h\1>", heading, made, flags=re.S)
        made = re.sub(r'<a href="([^"]*)">(\s*<img\b.*?)</a>', lambda found: self.pictured(found, page), made, flags=re.S)
        made = re.sub(r'(href|src)="([^"]*)"', lambda found: f'{found[1]}="{self.target(html.unescape(found[2]), page, place)}"', made)
        made = made.replace("<table>", '<div class="wide"><table>').replace("</table>", "</table></div>")
        title = re.search(r"<h1[^>]*>(.*?)</h1>", made, re.S)
        self.write(place, re.sub(r"<[^>]*>", "", title[1]) if title else page.stem, made)

    def pictured(self, found, page):
        """A picture that leads to a scene file leads to the scene in the workbench."""
        scene = re.fullmatch(r"(?:\.\./)?scenes/(\w+)\.toml", found[1])
        if not scene or not (self.source / "scenes" / f"{scene[1]}.toml").exists():
            return found[0]
        workbench = os.path.relpath(self.source / "poinsot.html", page.parent)
        return f'<a href="{workbench}#scene={scene[1]}">{found[2]}</a>'

    def target(self, link, page, place):
        """The link in the site; a linked file is copied along."""
        path, hash_sign, anchor = link.partition("#")
        if not path or re.match(r"[a-z]+:", link):
            return html.escape(link)
        file = (page.parent / path).resolve()
        if file == (self.source / "poinsot.html").resolve():
            there = pathlib.Path("poinsot.html")
        elif file.suffix == ".md":
            there = self.place_of(file)
            if file not in self.pages:
                self.pages.append(file)
        else:
            there = file.relative_to(self.source)
            copy = self.folder / there
            if file.is_dir():
                shutil.copytree(file, copy, dirs_exist_ok=True)
            elif not copy.exists():
                copy.parent.mkdir(parents=True, exist_ok=True)
                shutil.copyfile(file, copy)
        return html.escape(os.path.relpath(there, place.parent) + hash_sign + anchor)

    def write(self, place, title, body):
        up = "../" * (len(place.parts) - 1)
        bar = "\n".join(f'<a href="{up}{file}"{" aria-current=page" if file == str(place) else ""}>{name}</a>' for file, name in BAR)
        file = self.folder / place
        file.parent.mkdir(parents=True, exist_ok=True)
        file.write_text(f"""<!DOCTYPE html>
<html lang="en">
<head>
<meta charset="utf-8">
<meta name="viewport" content="width=device-width">
<title>{title if title == "poinsot" else f"{title} – poinsot"}</title>
{self.icon}
<link rel="stylesheet" href="{up}style.css">
</head>
<body>
<nav>
{bar}
</nav>
<main>
{body}</main>
</body>
</html>
""")

    def write_downloads(self):
        """The page "Download": the workbench, and what lies in the folder of downloads."""
        kinds = [("*.tar.xz", "any x86-64 Linux: unpack it and run <code>bin/poinsot</code>"), ("poinsot_*.deb", "Debian 12: <code>apt install ./FILE</code>"),
                 ("python3-poinsot_*.deb", "Debian 12: the Python package"), ("libpoinsot[0-9]*.deb", "Debian 12: the C++ library"),
                 ("libpoinsot-dev_*.deb", "Debian 12: what building programs with this library needs"),
                 ("*.whl", "Python: <code>pip install FILE</code>"), ("*.tar.gz", "the sources"),
                 ("SHA256SUMS", "checksums: <code>sha256sum --check SHA256SUMS</code>")]
        files = sorted(self.downloads.iterdir()) if self.downloads else []
        rows = ['<tr><td><a href="poinsot.html" download>poinsot.html</a></td><td>any computer, tablet or phone with a browser: save it and open it; '
                "it needs no network</td></tr>"]
        for pattern, words in kinds:
            for file in files:
                if file.match(pattern):
                    shutil.copyfile(file, self.folder / file.name)
                    rows.append(f'<tr><td><a href="{html.escape(file.name)}" download>{html.escape(file.name)}</a></td>'
                                f"<td>{words.replace('FILE', html.escape(file.name))}</td></tr>")
        self.write(pathlib.Path("download.html"), "Download", "<h1>Download</h1>\n<div class=wide><table>\n<tr><th>file</th><th>for</th></tr>\n" +
                   "\n".join(rows) + '\n</table></div>\n<p>What the program needs, and how to build it: <a href="index.html#build-and-test">Build and test</a>.</p>\n')


def main():
    if len(sys.argv) not in (4, 5):
        sys.exit(__doc__)
    if not shutil.which("cmark-gfm"):
        sys.exit("cmark-gfm is missing; install the Debian package cmark-gfm")
    source, workbench, folder = (pathlib.Path(word).resolve() for word in sys.argv[1:4])
    Site(source, workbench, folder, pathlib.Path(sys.argv[4]).resolve() if len(sys.argv) == 5 else None).make()


if __name__ == "__main__":
    main()
