"""Comparison of pictures: from any renderer, as files or as arrays."""

from __future__ import annotations

import numbers
import operator
import os
import tempfile
from dataclasses import dataclass, field
from typing import Any, Dict, Iterable, List, Optional, Union

import numpy as np

from numpy.typing import NDArray

from . import _poinsot, toml
from .arrays import Pixels, pixels
from .errors import InputError, shown
from .paths import Path, path_text
from .pictures import Still, page_name

Picture = Union[Path, Still, NDArray[Any], Any]

#: A share of the pixels: 0.001 or "0.1%".
Share = Union[float, str]


@dataclass
class Comparison:
    """How two pictures differ. True if it passes.

    Attributes:
        passes: whether the differences are within the limits.
        outcome: "same", "within limits", "pixels", "size", …
        reason: one line; empty if the pictures are equal.
        n_pixels, n_differing, n_over_level, n_ignored: numbers of pixels: compared, different in
            any channel, different by more than over_levels, ignored.
        largest_difference, mean_difference: levels of 0 to 255.
        ssim, flip: structural similarity (1: equal) and FLIP (0: equal), if they were measured.
        changes: what the records of two pictures by poinsot say that differs; None without records.
        difference: expected | difference × 16 | actual, shape (H, W, 4) of uint8; None if equal.
    """

    name: str
    passes: bool
    outcome: str
    reason: str
    n_pixels: int
    n_differing: int
    n_over_level: int
    n_ignored: int
    largest_difference: float
    mean_difference: float
    ssim: Optional[float]
    flip: Optional[float]
    changes: Optional[List[str]]
    difference: Optional[Pixels] = field(default=None, repr=False, compare=False)

    def __bool__(self) -> bool:
        return self.passes

    def __str__(self) -> str:
        return f"{self.outcome}: {self.reason}" if self.reason else self.outcome

    def _repr_png_(self) -> Optional[bytes]:
        return None if self.difference is None else _poinsot.png_of(self.difference)


def plain_limit(name: str, value: Any) -> Union[None, bool, int, float, str, List[str]]:
    """A limit as Python's own value, whatever kind of number or text it was. Raises InputError."""
    if isinstance(value, (np.generic, np.ndarray)):
        value = value.tolist()
    if name == "ignore":
        return _regions(value)
    if value is None or isinstance(value, bool):
        return value
    if isinstance(value, str):
        return toml.unicode_text(name, str.__str__(value))
    if name != "profile" and not isinstance(value, (bytes, bytearray)):  # float() reads these as text
        if isinstance(value, numbers.Integral):
            return operator.index(value)
        try:
            return float(value)
        except (TypeError, ValueError, OverflowError):
            pass
    what = "portable or native" if name == "profile" else "True or False" if name == "antialiasing" else "a number"
    raise InputError(f"{name}: is {what}, and this is {shown(value)}")


def _regions(given: Any) -> List[str]:
    if given is None or isinstance(given, str):
        given = [] if given is None else [given]
    try:
        regions = list(given)
    except TypeError:
        raise InputError(f"ignore: is a region or a list of regions, and this is {shown(given)}") from None
    for region in regions:
        if not isinstance(region, str):
            raise InputError(f"ignore: a region is a text, and this is {shown(region)}")
    return [toml.unicode_text("ignore", str.__str__(region)) for region in regions]


def _profile(given: Any) -> str:
    profile = plain_limit("profile", given)
    if isinstance(profile, bool):
        raise InputError(f"profile: is portable or native, and this is {profile}")
    return str(profile or "")


#: The limits of a comparison without a profile.
limit_names = (*(name for name, _, _ in _poinsot.keywords("compare")), "antialiasing", "ignore")


def _limits(arguments: Dict[str, Any]) -> Dict[str, Any]:
    return {name: plain_limit(name, arguments[name]) for name in limit_names}


def png_bytes(name: str, picture: Any) -> bytes:
    """A picture in memory as a PNG file: a Still, or an array (see arrays.pixels)."""
    return picture.png if isinstance(picture, Still) else _poinsot.png_of(pixels(name, picture))


def _file(name: str, picture: Picture, folder: str) -> str:
    """The picture as a file: its own, or a temporary one."""
    if isinstance(picture, (str, os.PathLike)):
        return path_text(picture)
    path = os.path.join(folder, name + ".png")
    with open(path, "wb") as file:
        file.write(png_bytes(name, picture))
    return path


def compare(
    expected: Picture,
    actual: Picture,
    *,
    profile: Optional[str] = None,
    # keywords of compare
    max_differing: Optional[Share] = None,
    max_over: Optional[Share] = None,
    over_levels: Optional[int] = None,
    max_flip: Optional[float] = None,
    min_ssim: Optional[float] = None,
    # end
    antialiasing: Optional[bool] = None,
    ignore: Iterable[str] = (),
    measures: bool = False,
) -> Comparison:
    """Compares two pictures: files, Stills, or arrays of any renderer.

    Arrays have the shape (H, W), (H, W, 3) or (H, W, 4), of 8-bit values or of floats from 0 to 1.
    The limits are those of `poinsot compare`; without any, no pixel may differ, except where the
    manifest or the compare.toml beside the expected file says more. max_differing and max_over are
    shares of the pixels, as 0.05 or "5%". With one of them alone the other keeps its default: only
    0.0002 % of the pixels may differ by more than over_levels (2), unless max_over says more.
    Raises InputError.

    >>> import numpy as np
    >>> grey = np.full((4, 4), 128, np.uint8)
    >>> other = grey.copy(); other[0, 0] = 130
    >>> bool(compare(grey, grey)), bool(compare(grey, other))
    (True, False)
    >>> bool(compare(grey, other, max_differing="10%", over_levels=2))
    True
    """
    limits = _limits(locals())
    with tempfile.TemporaryDirectory() as folder:
        a, b = _file("expected", expected, folder), _file("actual", actual, folder)
        for name, file in (("expected", a), ("actual", b)):
            if not os.path.isfile(file):
                raise InputError(f"{name}: {file}: no such file", file)
        name = os.path.splitext(os.path.basename(b))[0]
        return Comparison(**_poinsot.compare_pair(name, a, b, _profile(profile), limits, measures))


def compare_folders(
    expected: Path,
    actual: Path,
    *,
    report: Optional[Path] = None,
    single_file: bool = False,
    junit: Optional[Path] = None,
    title: Optional[str] = None,
    profile: Optional[str] = None,
    # keywords of compare
    max_differing: Optional[Share] = None,
    max_over: Optional[Share] = None,
    over_levels: Optional[int] = None,
    max_flip: Optional[float] = None,
    min_ssim: Optional[float] = None,
    # end
    antialiasing: Optional[bool] = None,
    ignore: Iterable[str] = (),
    measures: bool = False,
) -> List[Comparison]:
    """Compares all pictures of two folders, worst first.

    report: an HTML page to be written, with its pictures in a folder beside it, or in the page
    (single_file). junit: a file for test results in JUnit's XML. Neither may replace what is compared,
    nor may the report's pictures lie in a folder that is compared. Raises InputError, EnvironmentError.
    """
    limits = _limits(locals())
    a, b = path_text(expected), path_text(actual)
    outputs = {
        "title": toml.unicode_text("title", title or f"{b} compared with {a}"),
        "report": None if report is None else page_name(report),
        "single_file": single_file,
        "junit": None if junit is None else path_text(junit),
    }
    found = _poinsot.compare_all(a, b, _profile(profile), limits, measures, outputs)
    return [Comparison(**one) for one in found]


def approve(
    names: Union[str, Iterable[str]],
    *,
    baselines: Path,
    results: Optional[Path] = None,
    why: str = "",
    any_renderer: bool = False,
    foreign: bool = False,
    remove: bool = False,
) -> Dict[str, str]:
    """Makes files of the folder `results` the baselines; the manifest keeps the reason.

    names: pictures without ".png", films and figures with their suffix. why: needed where a baseline
    changes. any_renderer: also pictures that were drawn without `portable`. foreign: also pictures of
    other programs. remove: instead removes these baselines; needs no `results`. Returns the outcome
    of each. Raises InputError, EnvironmentError.
    """
    try:
        given = [path_text(name) for name in ([names] if isinstance(names, (str, os.PathLike)) else names)]
    except TypeError:
        raise InputError(f"names: are names of pictures, and this is {shown(names)}") from None
    if not given:
        raise InputError("names: name the pictures")
    reason = toml.unicode_text("why", why)
    folder = path_text(baselines)
    if remove:
        return dict(_poinsot.remove_baselines(folder, given, reason))
    if results is None:
        raise InputError("results: give the folder of the new pictures")
    return dict(_poinsot.approve(path_text(results), folder, given, reason, any_renderer, foreign))
