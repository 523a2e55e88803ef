#!/usr/bin/env python3
"""Makes a static site: a first page with the live construction, the README, the documents, the gallery and the workbench. It needs no
server: it can be opened from its folder. On a server, a service worker keeps it for use without a network, and phones can put the workbench
on their home screen.

Usage: make_site.py SOURCE WORKBENCH SITE [DOWNLOADS]
SOURCE: the sources of poinsot. WORKBENCH: poinsot.html. SITE: the folder to write; it is emptied first, if this program wrote it.
DOWNLOADS: a folder of files that the page "Download" offers.
POINSOT_SITE_ADDRESS, a variable of the environment: the address at which the site will lie, such as https://example.org/poinsot; with it,
there are a sitemap, canonical addresses and pictures for links in mail and chat, which need whole addresses.
The pages are those of GitHub: cmark-gfm (Debian package of that name) reads the Markdown, and headings have GitHub's anchors. Pictures of
the gallery lead to their scenes in the workbench, so that all of them share one module.
"""
import base64
import hashlib
import html
import json
import os
import pathlib
import re
import shutil
import subprocess
import sys

# Pages of the bar: file, name.
BAR = [("index.html", "poinsot"), ("about.html", "About"), ("docs/gallery.html", "Gallery"), ("poinsot.html", "Workbench"), ("docs/guide.html", "Guide"),
       ("docs/lecture.html", "Lecture"), ("docs/scene-reference.html", "Scene reference"), ("docs/python.html", "Python"),
       ("docs/regression.html", "Regression tests"), ("download.html", "Download")]
MARK = "made-by-poinsot-site"

# Titles that say what a page is about where it stands alone, in search results and links.
TITLES = {"index.html": "poinsot: how a rigid body turns, exactly, in your browser", "about.html": "About poinsot: films and figures of rotating rigid bodies",
          "docs/gallery.html": "Gallery of rigid-body rotation", "docs/guide.html": "Guide to pictures and films of rotating bodies",
          "docs/lecture.html": "A lecture on Poinsot’s construction", "docs/scene-reference.html": "Scene reference: every key",
          "docs/python.html": "Exact rigid-body motion in Python", "docs/formulas.html": "Formulas of rigid-body rotation",
          "docs/accuracy.html": "Accuracy of motion and picture, measured", "docs/speed.html": "Speed, measured", "docs/trust.html": "Why you can trust the pictures",
          "docs/extending.html": "Extending the program", "docs/architecture.html": "Architecture of the program", "download.html": "Download the program or the workbench",
          "CHANGELOG.html": "Changes, newest first", "docs/regression.html": "Regression tests of physics engines and pictures", "docs/library.html": "Exact rigid-body motion in C++"}
ABOUT = "Poinsot’s construction of a freely rotating rigid body, exact and live in the browser: turn it, throw your phone, make films and figures."
CARD = "tests/golden/gallery/generic.png"

# Registers the service worker and names the manifest, which browsers take from servers alone.
APP = ("if(location.protocol.startsWith('http')){const link=document.createElement('link');link.rel='manifest';link.href='{{up}}manifest.webmanifest';"
       "document.head.append(link);navigator.serviceWorker?.register('{{up}}worker.js').catch(()=>{})}")

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
@media (max-width: 700px) { .pictures :is(table, tbody, tr, td) { display: block; border: 0; padding: .3rem 0; } .pictures thead { display: none; } .pictures tr { margin-bottom: 1.6rem; } }
.first { display: grid; grid-template: auto / minmax(0, 3fr) minmax(0, 2fr); gap: 1rem 2rem; align-items: center; }
.first > :is(iframe, img) { display: block; width: 100%; height: min(70vh, 34rem); border: 1px solid var(--line); border-radius: 10px; background: #fff; object-fit: contain; }
.buttons { display: flex; flex-wrap: wrap; gap: .7rem; }
.buttons a { padding: .6rem 1.1rem; border: 1px solid var(--link); border-radius: 10px; text-decoration: none; font-weight: 600; }
.buttons a:first-child { background: var(--link); color: var(--ground); }
.cards { display: grid; grid-template-columns: repeat(auto-fill, minmax(15rem, 1fr)); gap: 1rem; margin: 0; padding: 0; list-style: none; }
.cards a { display: block; height: 100%; border: 1px solid var(--line); border-radius: 10px; overflow: hidden; text-decoration: none; color: inherit; }
.cards img { display: block; width: 100%; aspect-ratio: 16 / 9; object-fit: cover; border-radius: 0; }
.cards b, .cards span { display: block; padding: .5rem .9rem 0; }
.cards span { padding: 0 .9rem .7rem; font-size: .92em; }
dt { font-weight: 600; margin-top: .7rem; }
dd { margin: 0; }
@media (max-width: 700px) { nav { flex-wrap: nowrap; overflow-x: auto; white-space: nowrap; } .first { grid-template: auto auto / minmax(0, 1fr); }
 .first > :is(iframe, img) { height: 46vh; } .first h1 { margin: 0; font-size: 1.5rem; } .first p { margin: .6rem 0; line-height: 1.4; } .cards { grid-template-columns: minmax(0, 1fr); } }
"""


def anchor_of(heading):
    """GitHub's anchor of a heading, given as HTML."""
    text = html.unescape(re.sub(r"<[^>]*>", "", heading))
    return re.sub(r"[^\w\- ]", "", text.strip().lower()).replace(" ", "-")


class Site:
    def __init__(self, source, workbench, folder, downloads):
        self.source, self.workbench, self.folder, self.downloads = source, workbench, folder, downloads
        self.address = os.environ.get("POINSOT_SITE_ADDRESS", "").rstrip("/")
        self.places = []
        self.icon = re.search(r'<link rel="icon"[^>]*>', (source / "src/doors/web/page" / "index.html").read_text())[0]

    def make(self):
        if self.folder.exists() and any(self.folder.iterdir()) and not (self.folder / MARK).exists():
            sys.exit(f"{self.folder}: exists, and is no site of poinsot; name another folder, or remove this one")
        shutil.rmtree(self.folder, ignore_errors=True)
        self.folder.mkdir(parents=True)
        (self.folder / MARK).touch()
        (self.folder / "style.css").write_text(STYLE.lstrip())
        self.write_workbench()
        # And those that these lead to.
        self.pages = [self.source / "README.md", *sorted((self.source / "docs").glob("*.md"))]
        for page in self.pages:
            self.write_page(page)
        self.write_start()
        self.write_downloads()
        self.write_app()

    def place_of(self, page):
        """Where a document lies in the site."""
        name = page.relative_to(self.source)
        return pathlib.Path("about.html") if str(name) == "README.md" else name.with_suffix(".html")

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
        made = re.sub(r"<table>(.*?)</table>", lambda found: f'<div class="wide{" pictures" if "<img" in found[1] else ""}"><table>{found[1]}</table></div>', made,
                      flags=re.S)
        title = re.search(r"<h1[^>]*>(.*?)</h1>", made, re.S)
        first = re.search(r"<p>(?!\s*<)(.*?)</p>", made, re.S)
        about = html.unescape(re.sub(r"\s+", " ", re.sub(r"<[^>]*>", "", first[1]))).strip() if first else ABOUT
        self.write(place, re.sub(r"<[^>]*>", "", title[1]) if title else page.stem, made, about)

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
            if file.suffix == ".html":
                # What an example loads is made by its reader: the site shows its text.
                self.write(there, file.name, f"<h1>{html.escape(file.name)}</h1>\n<pre><code>{html.escape(file.read_text())}</code></pre>\n")
            elif file.is_dir():
                shutil.copytree(file, copy, dirs_exist_ok=True)
            elif not copy.exists():
                copy.parent.mkdir(parents=True, exist_ok=True)
                shutil.copyfile(file, copy)
        return html.escape(os.path.relpath(there, place.parent) + hash_sign + anchor)

    def write(self, place, title, body, about=ABOUT):
        up = "../" * (len(place.parts) - 1)
        bar = "\n".join(f'<a href="{up}{file}"{" aria-current=page" if file == str(place) else ""}>{name}</a>' for file, name in BAR)
        title = html.escape(TITLES.get(str(place), html.unescape(title)))
        about = html.escape(about if len(about) <= 200 else about[:199].rsplit(" ", 1)[0] + " …")
        whole = self.address + "/" if self.address else up
        own = html.escape(whole + ("" if str(place) == "index.html" else str(place)))
        canonical = f'<link rel="canonical" href="{own}">\n<meta property="og:url" content="{own}">\n' if self.address else ""
        self.places.append(place)
        file = self.folder / place
        file.parent.mkdir(parents=True, exist_ok=True)
        file.write_text(f"""<!DOCTYPE html>
<html lang="en">
<head>
<meta charset="utf-8">
<meta name="viewport" content="width=device-width, initial-scale=1">
<title>{title if title.startswith("poinsot") or "poinsot" in title else f"{title} – poinsot"}</title>
<meta name="description" content="{about}">
{canonical}<meta property="og:title" content="{title}">
<meta property="og:description" content="{about}">
<meta property="og:type" content="website">
<meta property="og:site_name" content="poinsot">
<meta property="og:image" content="{html.escape(whole)}card.png">
<meta name="twitter:card" content="summary_large_image">
{self.icon}
<link rel="stylesheet" href="{up}style.css">
<script>{APP.replace("{{up}}", up)}</script>
</head>
<body>
<nav aria-label="Site">
{bar}
</nav>
<main>
{body}</main>
</body>
</html>
""")

    def write_workbench(self):
        """The workbench, which a phone can put on its home screen: its content policy allows what that needs."""
        text = self.workbench.read_text()
        script = APP.replace("{{up}}", "")
        allowed = "'sha256-" + base64.b64encode(hashlib.sha256(script.encode()).digest()).decode() + "'"
        policy = re.search(r'<meta http-equiv="Content-Security-Policy" content="([^"]*)">', text)
        if policy:
            wider = policy[0].replace("script-src ", f"script-src {allowed} ").replace("img-src ", "img-src 'self' ").replace('">', "; manifest-src 'self'; worker-src 'self'\">")
            text = text.replace(policy[0], wider, 1)
            head = text.index("<title>")
            text = text[:head] + f"<script>{script}</script>\n" + text[head:]
            text = text.replace("<title>", f'<meta name="description" content="{html.escape(ABOUT)}">\n<title>', 1)
        (self.folder / "poinsot.html").write_text(text)

    def live_page(self):
        """The scene with which the workbench opens, as a page that runs alone; None without a workbench."""
        text = self.workbench.read_text()

        def block(name):
            found = re.search(rf'<script id="{name}"[^>]*>(.*?)</script>', text, re.S)
            return found[1] if found else ""

        if not block("workbench-data"):
            return None
        data = json.loads(block("workbench-data"))
        scene = json.loads(block("scene-data"))
        poster = re.search(r'<img id="poster" src="([^"]*)"', text)
        values = {"language": scene["language"], "no-script": html.escape(data["no_script"].get(scene["language"], "")), "title": html.escape(scene["title"]),
                  "ground": re.search(r'data-ground="([^"]*)"', text)[1], "poster": poster[1] if poster else "", "scene": block("scene-data"), "fonts": block("program-fonts"),
                  "page-scripts": block("page-scripts"), "film-writer": block("film-writer"), "module": block("program-module")}
        return re.sub(r"\{\{([a-z-]+)\}\}", lambda found: values.get(found[1], found[0]), data["template"])

    def write_start(self):
        """The first page: the live construction, or its film where no workbench is; three ways on; the gallery as cards."""
        shutil.copyfile(self.source / CARD, self.folder / "card.png")
        film = self.target("tests/golden/readme/rolling.gif", self.source / "README.md", pathlib.Path("index.html"))
        film = f'<img src="{film}" alt="The inertia ellipsoid rolls on the invariable plane along a herpolhode that closes after three turns">'
        page = self.live_page()
        figure = film
        if page:
            (self.folder / "live.html").write_text(page)
            figure = f'<iframe src="live.html" title="Poinsot’s construction, live" allowfullscreen></iframe>\n<noscript>{film}</noscript>'
        cards = []
        for name, title, about in re.findall(r"\]\(\.\./scenes/(\w+)\.toml\) \| \*\*(.*?)\*\* (.*?) \|$", (self.source / "docs/gallery.md").read_text(), re.M):
            picture = self.target(f"tests/golden/gallery/{name}.png", self.source / "README.md", pathlib.Path("index.html"))
            cards.append(f'<li><a href="poinsot.html#scene={name}"><img src="{picture}" alt="" loading="lazy" width="640" height="360">'
                         f"<b>{html.escape(title.rstrip('.'))}</b><span>{html.escape(about.replace(chr(92) + '|', '|'))}</span></a></li>")
        body = (self.source / "src/cmake/site_start.html").read_text()
        self.write(pathlib.Path("index.html"), "poinsot", body.replace("{{figure}}", figure).replace("{{cards}}", "\n".join(cards)))

    def write_app(self):
        """What a server needs besides: the service worker, the manifest for home screens, and the sitemap."""
        icon = re.search(r'href="data:image/svg\+xml,([^"]*)"', self.icon)[1].replace("%3C", "<").replace("%3E", ">").replace("%23", "#")
        (self.folder / "icon.svg").write_text(icon)
        (self.folder / "manifest.webmanifest").write_text(json.dumps({
            "name": "poinsot", "short_name": "poinsot", "description": ABOUT, "start_url": "poinsot.html", "scope": "./", "display": "standalone",
            "background_color": "#f7f8fa", "theme_color": "#3f51c9", "icons": [{"src": "icon.svg", "sizes": "any", "type": "image/svg+xml", "purpose": "any"}]}, indent=1))
        first = ["./", "index.html", "poinsot.html", "style.css", "card.png", "icon.svg", "manifest.webmanifest"] + (["live.html"] if (self.folder / "live.html").exists() else [])
        contents = hashlib.sha256(b"".join((self.folder / name).read_bytes() for name in first[1:])).hexdigest()[:12]
        worker = (self.source / "src/cmake/site_worker.js").read_text()
        (self.folder / "worker.js").write_text(worker.replace("{{version}}", contents).replace("{{files}}", json.dumps(first)))
        if self.address:
            rows = "".join(f"<url><loc>{html.escape(self.address + '/' + ('' if str(place) == 'index.html' else str(place)))}</loc></url>\n"
                           for place in [*self.places, pathlib.Path("poinsot.html")])
            (self.folder / "sitemap.xml").write_text('<?xml version="1.0" encoding="UTF-8"?>\n<urlset xmlns="http://www.sitemaps.org/schemas/sitemap/0.9">\n' + rows +
                                                     "</urlset>\n")
            (self.folder / "robots.txt").write_text(f"User-agent: *\nAllow: /\nSitemap: {self.address}/sitemap.xml\n")

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
                   "\n".join(rows) + '\n</table></div>\n<p>What the program needs, and how to build it: <a href="about.html#build-and-test">Build and test</a>.</p>\n')


def main():
    if len(sys.argv) not in (4, 5):
        sys.exit(__doc__)
    if not shutil.which("cmark-gfm"):
        sys.exit("cmark-gfm is missing; install the Debian package cmark-gfm")
    source, workbench, folder = (pathlib.Path(word).resolve() for word in sys.argv[1:4])
    Site(source, workbench, folder, pathlib.Path(sys.argv[4]).resolve() if len(sys.argv) == 5 else None).make()


if __name__ == "__main__":
    main()
