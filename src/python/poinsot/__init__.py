"""poinsot: the exact motion of a turning rigid body, and Poinsot's construction.

    import poinsot
    racket = poinsot.Scene("tennis_racket")   # a notebook shows its picture
    racket.sample([0.0, 0.5, 1.0])["omega_body"]
    racket.render("racket.mp4")

See docs/python.md.
"""

import atexit as _atexit

from ._poinsot import __version__
from ._poinsot import stop_drawing as _stop_drawing
from .comparison import Comparison, approve, compare, compare_folders
from .errors import EnvironmentError, Error, InputError
from .motion import Claim, Cones, Constants, Motion, TopConstants
from .pictures import Figure, Film, Page, Still
from .samples import Samples
from .scene import Scene, scenes

__all__ = [
    "Claim",
    "Comparison",
    "Cones",
    "Constants",
    "EnvironmentError",
    "Error",
    "Figure",
    "Film",
    "InputError",
    "Motion",
    "Page",
    "Samples",
    "Scene",
    "Still",
    "TopConstants",
    "__version__",
    "approve",
    "compare",
    "compare_folders",
    "scenes",
]

# Before the interpreter unloads libraries in an order of its own.
_atexit.register(_stop_drawing)
