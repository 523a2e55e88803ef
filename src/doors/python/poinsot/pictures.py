"""What a scene gives: stills, figures, films and pages. A notebook shows each of them."""

from __future__ import annotations

import base64
import html
import json
import os
import re
import urllib.parse
from typing import Any, Callable, List, Optional, Sequence

from numpy.typing import NDArray

from . import _poinsot
from .arrays import Pixels
from .errors import InputError
from .paths import Path, path_text

#: A film up to this size is shown inside the notebook; a larger one is linked from it.
most_inline_bytes = 8_000_000


def write_file(path: Path, contents: bytes) -> None:
    """Writes a file as a whole: it is complete or unchanged."""
    name = path_text(path)
    # "-" alone would be the standard output, as for the program.
    _poinsot.write_whole("./-" if name == "-" else name, contents)


def _link(path: str) -> str:
    """The address of a file, from the notebook's folder, as the value of an attribute."""
    return html.escape(urllib.parse.quote(os.path.relpath(path)))


def _data(kind: str, contents: bytes) -> str:
    return f"data:{kind};base64,{base64.b64encode(contents).decode('ascii')}"


class Still:
    """A picture in memory.

    Attributes:
        pixels: array of shape (height, width, 4) of uint8: sRGB-encoded R, G, B, and linear,
            non-premultiplied alpha; row 0 is the top. It shares the still's memory.
        png: the bytes of the PNG file that `poinsot still` writes, with its record.
        bound: how far the lines may be from the truth, in words.
        notes: remarks, such as names without room.
        report: with a journal, size, least sizes, contrasts and what is left out; else None.
    """

    def __init__(self, drawn: _poinsot.Still, notes: Sequence[str] = (), report: Optional[str] = None) -> None:
        self.notes = list(notes)
        self.report = report
        self._drawn = drawn
        self._png: Optional[bytes] = None

    @property
    def pixels(self) -> Pixels:
        return self._drawn.pixels

    @property
    def png(self) -> bytes:
        if self._png is None:
            self._png = self._drawn.png
        return self._png

    @property
    def bound(self) -> str:
        return self._drawn.bound

    def save(self, path: Path) -> None:
        """Writes the PNG file. Raises InputError for another suffix, and EnvironmentError."""
        name = path_text(path)
        if not name.lower().endswith(".png"):
            raise InputError(f"{name}: a still is saved as a PNG; end its name in .png")
        write_file(name, self.png)

    def __array__(self, dtype: Any = None, copy: Optional[bool] = None) -> NDArray[Any]:
        pixels = self.pixels if dtype is None else self.pixels.astype(dtype)
        return pixels.copy() if copy and dtype is None else pixels

    def _repr_png_(self) -> bytes:
        return self.png

    def __repr__(self) -> str:
        height, width, _ = self.pixels.shape
        return f"<poinsot.Still, {width} × {height} pixels, {self.bound}>"


class Figure:
    """A figure of vectors, with exact hidden lines.

    Attributes:
        svg: its text as SVG.
        pdf: its bytes as PDF, made when it is first asked for.
        notes: remarks, such as names without room, and the bound of the errors of its paths.
        report: with a journal, size, least sizes, contrasts and what is left out; else None.
    """

    def __init__(
        self, svg: str, make_pdf: Callable[[], bytes], notes: Sequence[str] = (), report: Optional[str] = None
    ) -> None:
        self.svg = svg
        self.notes = list(notes)
        self.report = report
        self._make_pdf = make_pdf
        self._pdf: Optional[bytes] = None

    @property
    def pdf(self) -> bytes:
        if self._pdf is None:
            self._pdf = self._make_pdf()
        return self._pdf

    def save(self, path: Path) -> None:
        """Writes an .svg or a .pdf file. Raises InputError for another suffix, and EnvironmentError."""
        name = path_text(path)
        if name.lower().endswith(".svg"):
            write_file(name, self.svg.encode("utf-8"))
        elif name.lower().endswith(".pdf"):
            write_file(name, self.pdf)
        else:
            raise InputError(f"{name}: a figure is an SVG or a PDF; end its name in .svg or .pdf")

    def _repr_svg_(self) -> str:
        return self.svg

    def __repr__(self) -> str:
        return f"<poinsot.Figure, {len(self.svg.encode('utf-8')) / 1e3:.0f} kB as SVG>"


class Film:
    """A film, or a sequence of pictures, that was written.

    Attributes:
        path: its file, or the pattern of its files.
        notes: the bound of its errors, and remarks.
    """

    def __init__(self, path: str, notes: List[str]) -> None:
        self.path = path
        self.notes = notes

    def _repr_html_(self) -> Optional[str]:
        suffix = os.path.splitext(self.path)[1].lower()
        kind = {".mp4": "video/mp4", ".webm": "video/webm", ".gif": "image/gif"}.get(suffix)
        if kind is None or not os.path.isfile(self.path):
            return None
        if os.path.getsize(self.path) <= most_inline_bytes:
            with open(self.path, "rb") as file:
                source = _data(kind, file.read())
        else:
            source = _link(self.path)
        if suffix == ".gif":
            return f'<img src="{source}" style="max-width:100%">'
        return f'<video controls loop muted playsinline src="{source}" style="max-width:100%"></video>'

    def __repr__(self) -> str:
        return f"<poinsot.Film, {self.path}>"


def page_name(path: Path) -> str:
    """The name of a page's file. Raises InputError for another suffix than .html."""
    name = path_text(path)
    if not name.lower().endswith(".html"):
        raise InputError(f"{name}: a page ends in .html")
    return name


class Page:
    """A page that holds the motion and needs nothing else: it plays, turns and is edited.

    In a notebook it is a picture; a click on it starts the page in a sandbox. Where scripts are
    stripped, the picture stays.

    Attributes:
        path: its file, if it was given one.
        html: its text.
    """

    def __init__(self, contents: str, width_px: int, height_px: int, path: Optional[str]) -> None:
        self.html = contents
        self.path = path
        self._size_px = (width_px, height_px)

    def save(self, path: Path) -> None:
        """Writes the page's .html file. Raises InputError for another suffix, and EnvironmentError."""
        write_file(page_name(path), self.html.encode("utf-8"))

    def _repr_html_(self) -> str:
        width, height = self._size_px
        # The page has a picture of 256 colours, which is shown until it draws.
        shown = re.search(r'<img id="poster" src="(data:image/png;base64,[^"]*)"', self.html)
        poster = f'<img src="{shown[1] if shown else ""}" style="width:100%;display:block" alt="poinsot">'
        if self.path is None:
            # Data, not a program: no browser runs it, and no "<" in it ends it.
            text = json.dumps(self.html).replace("<", "\\u003c")
            held = f'{poster}<script type="application/json">{text}</script>'
            start = "frame.srcdoc=JSON.parse(this.querySelector('script').textContent)"
        else:
            # A notebook turns the link into the address of the file.
            held = f'<a href="{_link(self.path)}">{poster}</a>'
            start = "frame.src=this.querySelector('a').href"
        # An attribute, because some notebooks run scripts elsewhere in the page.
        click = (
            "event.preventDefault();event.stopPropagation();const frame=document.createElement('iframe');"
            "frame.setAttribute('sandbox','allow-scripts');"
            f"frame.style='width:100%;aspect-ratio:{width}/{height};border:0';{start};"
            "this.onclick=null;this.replaceChildren(frame)"
        )
        return f'<div style="max-width:{width}px;cursor:pointer" title="click to start" onclick="{click}">{held}</div>'

    def __repr__(self) -> str:
        where = self.path or f"{len(self.html.encode('utf-8')) / 1e6:.2f} MB"
        return f"<poinsot.Page, {where}>"
