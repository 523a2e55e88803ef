"""Scenes: a rigid body, its start, and how its motion is drawn."""

from __future__ import annotations

import difflib
import json
import numbers
import operator
import os
import tempfile
from typing import TYPE_CHECKING, Any, Callable, Dict, List, Mapping, Optional, Sequence, Tuple, Union

from numpy.typing import ArrayLike

from . import _poinsot, toml
from .arrays import seconds
from .errors import InputError, shown
from .motion import Motion
from .paths import Path, path_text
from .pictures import Figure, Film, Page, Still, page_name
from .progress import Progress
from .samples import Samples

if TYPE_CHECKING:
    from .departures import Departure

_scenes_folder = os.path.join(os.path.dirname(__file__), "scenes")

Size = Union[Tuple[int, int], str]


def scenes() -> List[str]:
    """The names of the scenes that come with the package.

    >>> "tennis_racket" in scenes()
    True
    """
    return sorted(name[:-5] for name in os.listdir(_scenes_folder) if name.endswith(".toml"))


def _file_of(given: str) -> str:
    """The file of a scene as a user names it: a file, or the name of a scene of the package."""
    if os.path.dirname(given) or os.path.splitext(given)[1] or os.path.isfile(given):
        return given
    known = scenes()
    if given in known:
        return os.path.join(_scenes_folder, given + ".toml")
    near = difflib.get_close_matches(given, known, 1)
    hint = f'did you mean "{near[0]}"?' if near else "poinsot.scenes() lists them"
    raise InputError(f"{given}: no such file, and no scene has that name; {hint}", given)


def _size_text(size: Any) -> str:
    if isinstance(size, str):
        return size
    try:
        width, height = size
        if int(width) == width and int(height) == height:
            return f"{int(width)}x{int(height)}"
    except (TypeError, ValueError, OverflowError):
        pass
    raise InputError(f"size: {shown(size)} is not a size in pixels; give (width, height)")


class Scene:
    """A scene: from a file, a text of TOML, nested dicts, a Motion, or the name of a scene of the package.

    A text has several lines or a "="; `values` are changed values by dotted key, as --set takes
    them. `allow_outside`: whether the scene may name files outside its own folder.

    Raises InputError, with file, line and column, for a scene that cannot be used.

    >>> racket = Scene("tennis_racket")
    >>> racket.name
    'tennis_racket'
    >>> Scene({"body": {"moments_kg_m2": [1, 2, 3]}, "start": {"omega_rad_s": [0.1, 2, 0]}}).check()["regime"]
    'elliptic, about the axis of the smallest moment'
    """

    def __init__(
        self,
        source: Union[str, "os.PathLike[str]", Mapping[str, Any], Motion],
        values: Optional[Mapping[str, Any]] = None,
        *,
        allow_outside: bool = False,
    ) -> None:
        changes = toml.assignments({} if values is None else values)
        if isinstance(source, Motion):
            source = source.as_scene()
        if isinstance(source, Mapping):
            text = toml.unicode_text("scene.toml", toml.scene_text(source))
            self._native = _poinsot.Scene.from_text(text, "scene.toml", changes, allow_outside)
        elif isinstance(source, str) and ("\n" in source or "=" in source):
            self._native = _poinsot.Scene.from_text(
                toml.unicode_text("scene.toml", source), "scene.toml", changes, allow_outside
            )
        elif isinstance(source, (str, os.PathLike)):
            self._native = _poinsot.Scene.from_file(_file_of(path_text(source)), changes, allow_outside)
        else:
            raise InputError(f"a scene is a file, a text, a dict or a Motion, not {type(source).__name__}")

    def set(self, values: Optional[Mapping[str, Any]] = None, **tables: Any) -> "Scene":
        """The same scene with other values; this one stays as it is.

        values: by dotted key, or in nested dicts. Keys and tables without a dot may also be keywords.

        >>> Scene("generic").set({"start.omega_rad_s": [0.2, 2.0, 0.1]}).values
        ['start.omega_rad_s=[0.2, 2.0, 0.1]']
        >>> Scene("generic").set(theme="dark", camera={"elevation_deg": 10}).values
        ['theme="dark"', 'camera.elevation_deg=10']
        """
        changed = object.__new__(Scene)
        given = [] if values is None and tables else toml.assignments(values)
        changed._native = self._native.with_values(given + toml.assignments(tables))
        return changed

    def __eq__(self, other: object) -> bool:
        """Whether both have the same text, changed values and place of files: they give the same bytes."""
        if not isinstance(other, Scene):
            return NotImplemented
        return self.__reduce__() == other.__reduce__()

    def __hash__(self) -> int:
        native = self._native
        return hash((native.text, native.file, tuple(native.values), native.allow_outside))

    def __reduce__(self) -> Tuple[Any, ...]:
        native = self._native
        return _same_scene, (native.text, native.file, native.values, native.allow_outside)

    @property
    def name(self) -> str:
        """The scene's name: that of its file without the suffix."""
        return self._native.name

    @property
    def title(self) -> str:
        """The scene's title, or its name if it has none."""
        return self._native.title

    @property
    def text(self) -> str:
        """The text of the scene file."""
        return self._native.text

    @property
    def values(self) -> List[str]:
        """The changed values, as --set takes them."""
        return self._native.values

    @property
    def size_px(self) -> Tuple[int, int]:
        """Width and height of its pictures."""
        return self._native.width_px, self._native.height_px

    def check(self) -> Dict[str, Any]:
        """What `poinsot check --json` says: regime, constants, periods, film, accuracy.

        SI units, as the names say. Raises InputError for a motion that cannot be computed.
        """
        said: Dict[str, Any] = json.loads(self._native.check_json())
        return said

    def sample(self, times: ArrayLike, columns: Optional[Sequence[str]] = None) -> Samples:
        """The motion at these instants.

        times: seconds, any shape; columns: names as for `poinsot sample --columns`. Returns arrays
        of the shape of `times`: ω in rad/s in body axes, the attitude space_from_body as a unit
        quaternion (w, x, y, z), the herpolhode in rad/s in space axes. The digits are those of the
        command. Exact motions cost the same at every instant. The interpreter's lock is released.
        Raises InputError for instants that are not finite, or that a stepped motion cannot reach.

        >>> import numpy as np
        >>> motion = Scene("sphere").sample(np.linspace(0, 10, 3))
        >>> motion["omega_body"].shape
        (3, 3)
        """
        instants = seconds("times", times)
        if isinstance(columns, str):
            columns = [columns]
        try:
            given: List[Any] = [] if columns is None else list(columns)
        except TypeError:
            given = [None]
        if not all(isinstance(column, str) for column in given):
            raise InputError('columns: give names of columns, as ["time", "kinetic_energy"]')
        wanted = [toml.unicode_text("columns", column) for column in given]
        names, values = self._native.sample(instants.ravel(), wanted)
        return Samples(zip(names, (column.reshape(instants.shape) for column in values)))

    def departure(self, times: Any, omega: Any = None, *, attitude: Any = None) -> "Departure":
        """How far somebody else's motion is from that of the scene, as `poinsot check --against` compares them.

        times: s, shape (n,), increasing; omega: rad/s, body axes, shape (n, 3); attitude: space from body as unit
        quaternions (w, x, y, z), shape (n, 4); one of both may be missing. In place of these, `times` may be a table
        with named columns, as for `poinsot.fit`. Returns the errors row by row, with `rms` and `largest`. Raises
        InputError for other shapes, rows that are not finite, and instants that a stepped motion cannot reach.

        >>> import numpy as np
        >>> t = np.linspace(0.0, 5.0, 11)
        >>> exact = Scene("generic").sample(t)["omega_body"]
        >>> Scene("generic").departure(t, 1.01 * exact).largest["omega_share"].value.__round__(6)
        0.01
        """
        from .departures import departure_of

        return departure_of(self._native, times, omega, attitude)

    def still(
        self,
        time_s: Union[None, float, str] = None,
        *,
        # keywords of still
        size: Optional[Size] = None,
        theme: Optional[str] = None,
        quality: Optional[str] = None,
        width_mm: Optional[float] = None,
        height_mm: Optional[float] = None,
        dpi: Optional[float] = None,
        type_pt: Optional[float] = None,
        journal: Optional[str] = None,
        keep_text: bool = False,
        backend: str = "auto",
        portable: bool = False,
        # end
    ) -> Still:
        """One picture, at `time_s` seconds of the motion; "auto": where the arrows are farthest apart.

        The options are those of `poinsot still`. Any thread may draw; a process that was forked
        after or while its parent drew a picture may not. Raises InputError, EnvironmentError.
        """
        return Still(*self._native.still(_given(locals())))

    def figure(
        self,
        time_s: Union[None, float, str] = None,
        *,
        # keywords of figure
        size: Optional[Size] = None,
        theme: Optional[str] = None,
        quality: Optional[str] = None,
        width_mm: Optional[float] = None,
        height_mm: Optional[float] = None,
        type_pt: Optional[float] = None,
        journal: Optional[str] = None,
        keep_text: bool = False,
        shading: str = "tone",
        text: str = "font",
        backend: str = "auto",
        portable: bool = False,
        # end
    ) -> Figure:
        """The same as vectors, for print. The options are those of `poinsot still -o NAME.pdf`."""
        native, options = self._native, _given(locals())
        svg, notes, report = native.figure("svg", options)
        return Figure(svg.decode("utf-8"), lambda: native.figure("pdf", options)[0], notes, report)

    def render(
        self,
        path: Path,
        *,
        progress: bool = True,
        # keywords of render
        size: Optional[Size] = None,
        fps: Any = None,
        theme: Optional[str] = None,
        quality: Optional[str] = None,
        frames: Union[None, Tuple[int, int], range] = None,
        backend: str = "auto",
        portable: bool = False,
        # end
    ) -> Film:
        """Writes a film (.mp4, .webm, .mov, .gif), a presentation (.pptx) or, with #### in the name, a
        PNG sequence.

        The options are those of `poinsot render`; frames: the first and the last, from 0, or a range. A film
        that was interrupted, also by Ctrl-C, continues at the next call. `progress` shows a bar.
        Raises InputError, EnvironmentError.
        """
        options = _given(locals())
        name = path_text(path)
        if name.lower().endswith(".html"):
            raise InputError(f"{name}: .page({name!r}) writes a page")
        with Progress(progress, self.name) as shown:
            self._native.render(name, options, shown.say, shown.frames)
        return Film(name, shown.notes)

    def slides(
        self,
        folder: Path,
        *,
        progress: bool = True,
        # keywords of slides
        size: Optional[Size] = None,
        fps: Any = None,
        theme: Optional[str] = None,
        quality: Optional[str] = None,
        backend: str = "auto",
        portable: bool = False,
        # end
    ) -> Dict[str, Any]:
        """Writes a film and stills for each stop, as `poinsot render --slides`; returns slides.json."""
        options = _given(locals())
        name = path_text(folder)
        with Progress(progress, self.name) as shown:
            self._native.slides(name, options, shown.say, shown.frames)
        with open(os.path.join(name, "slides.json"), encoding="utf-8") as file:
            deck: Dict[str, Any] = json.load(file)
        return deck

    def page(
        self,
        path: Optional[Path] = None,
        *,
        # keywords of page
        size: Optional[Size] = None,
        theme: Optional[str] = None,
        backend: str = "auto",
        portable: bool = False,
        # end
    ) -> Page:
        """The scene as a page that plays, turns and is edited; written to `path` if one is given.

        With a path, a notebook holds only the page's poster (60 kB) instead of the page (1.2 MB).
        Raises EnvironmentError where the package was built without the module for browsers.
        """
        options = _given(locals())
        changed = self.set({"film.size": options["size"]}) if "size" in options else self
        with tempfile.TemporaryDirectory() as folder:
            name = os.path.join(folder, self.name + ".html") if path is None else page_name(path)
            self._native.render(name, options, None, None)
            with open(name, encoding="utf-8") as file:
                return Page(file.read(), *changed.size_px, None if path is None else name)

    def _repr_png_(self) -> bytes:
        # As wide as a notebook's cell, or smaller: outputs are stored in the notebook.
        width, height = self.size_px
        shown = min(width, 960)
        return self.still(size=(shown, max(2, shown * height // width // 2 * 2))).png

    def __repr__(self) -> str:
        return f"<poinsot.Scene {self.name}>"


def _same_scene(text: str, file: str, values: List[str], allow_outside: bool) -> Scene:
    """A scene that was sent to another process."""
    same = object.__new__(Scene)
    same._native = _poinsot.Scene.from_text(text, file, values, allow_outside)
    return same


def _rate_text(fps: Any) -> str:
    if isinstance(fps, (str, numbers.Number)):
        return str(fps)
    raise InputError(f'fps: {shown(fps)} is not a rate; give a number, a Fraction or a text as "30000/1001"')


def _instant(time_s: Any) -> Union[float, str]:
    if isinstance(time_s, str):
        if time_s == "auto":
            return time_s
        raise InputError(f'time_s: {shown(time_s)} is not an instant in seconds; give a number or "auto"')
    instant = seconds("time_s", time_s)
    if instant.size != 1:
        raise InputError("time_s: a picture shows one instant; give one number")
    return float(instant.ravel()[0])


def _frames(frames: Any) -> Tuple[int, int]:
    try:
        first, last = (frames[0], frames[-1]) if isinstance(frames, range) and frames.step == 1 else frames
        first, last = operator.index(first), operator.index(last)
        if max(first, last) >= 2**63 or min(first, last) < -(2**63):
            raise ValueError
    except (IndexError, TypeError, ValueError):
        raise InputError(f"frames: {shown(frames)} is not a range of frames; give (first, last), from 0") from None
    return first, last


# Options whose values have forms of their own in Python.
_own_forms: Dict[str, Callable[[Any], Any]] = {"size": _size_text, "fps": _rate_text, "time_s": _instant, "frames": _frames}


def _given(arguments: Dict[str, Any]) -> Dict[str, Any]:
    """The options among a method's arguments, as the module reads them."""
    return {
        name: _own_forms.get(name, lambda same: same)(value)
        for name, value in arguments.items()
        if value is not None and name != "self"
    }
