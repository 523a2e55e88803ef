"""poinsot: the exact motion of a turning rigid body, and Poinsot's construction.

    import poinsot
    racket = poinsot.Scene("tennis_racket")   # a notebook shows its picture
    racket.sample([0.0, 0.5, 1.0])["omega_body"]
    racket.render("racket.mp4")

See docs/python.md.
"""

from __future__ import annotations

from typing import TYPE_CHECKING, Any, List

if TYPE_CHECKING:
    from ._poinsot import __version__
    from .comparison import Comparison, approve, compare, compare_folders
    from .departures import Departure, Largest
    from .errors import EnvironmentError, Error, InputError
    from .fits import Drag, Fit, JointFit, Prediction, Start, fit
    from .motion import Claim, Cones, Constants, Motion, TopConstants
    from .pictures import Figure, Film, Page, Still
    from .recordings import Flight, flights
    from .samples import Samples
    from .scene import Scene, scenes

__all__ = [
    "Claim",
    "Comparison",
    "Cones",
    "Constants",
    "Departure",
    "Drag",
    "EnvironmentError",
    "Error",
    "Figure",
    "Film",
    "Fit",
    "Flight",
    "InputError",
    "JointFit",
    "Largest",
    "Motion",
    "Page",
    "Prediction",
    "Samples",
    "Scene",
    "Start",
    "Still",
    "TopConstants",
    "__version__",
    "approve",
    "compare",
    "compare_folders",
    "fit",
    "flights",
    "scenes",
]

# Each name is imported when it is first used: pytest loads the plugin, and thereby this package, in
# sessions that draw nothing.
_modules = {
    "_poinsot": ["__version__"],
    "comparison": ["Comparison", "approve", "compare", "compare_folders"],
    "departures": ["Departure", "Largest"],
    "errors": ["EnvironmentError", "Error", "InputError"],
    "fits": ["Drag", "Fit", "JointFit", "Prediction", "Start", "fit"],
    "motion": ["Claim", "Cones", "Constants", "Motion", "TopConstants"],
    "pictures": ["Figure", "Film", "Page", "Still"],
    "recordings": ["Flight", "flights"],
    "samples": ["Samples"],
    "scene": ["Scene", "scenes"],
}
_module_of = {name: module for module, names in _modules.items() for name in names}


def __getattr__(name: str) -> Any:
    import importlib

    if name not in _module_of:
        raise AttributeError(f"module {__name__!r} has no attribute {name!r}")
    value = getattr(importlib.import_module("." + _module_of[name], __name__), name)
    globals()[name] = value
    return value


def __dir__() -> List[str]:
    return sorted(__all__)
