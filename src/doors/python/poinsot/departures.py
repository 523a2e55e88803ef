"""How far somebody else's motion is from the exact one."""

from __future__ import annotations

from typing import Any, Dict, Iterable, NamedTuple

import numpy as np

from . import _poinsot
from .recordings import rows_of
from .samples import Samples


class Largest(NamedTuple):
    """A largest absolute value, and its instant in s."""

    value: float
    time_s: float


class Departure(Samples):
    """The errors of a motion, row by row: arrays of shape (n,) by name, as `poinsot check --against` finds them.

    Names: "time_s"; "attitude_rad", the angle between the two attitudes; "omega_rad_s", |ω − exact|; "omega_share",
    the same divided by |exact|; and for torque-free motions, whose constants they are, "energy_share", T/exact − 1,
    "momentum_share", |L|/exact − 1, and "momentum_tilt_rad", the angle between **L** in space and the exact one.
    A quantity that the rows do not determine is left out.
    """

    @property
    def rms(self) -> Dict[str, float]:
        """The root mean square of each quantity."""
        return {name: float(np.sqrt(np.mean(np.square(self[name])))) for name in self._quantities()}

    @property
    def largest(self) -> Dict[str, Largest]:
        """The largest absolute value of each quantity, and the instant at which it occurs."""
        found = {}
        for name in self._quantities():
            worst = int(np.argmax(np.abs(self[name])))
            found[name] = Largest(float(abs(self[name][worst])), float(self["time_s"][worst]))
        return found

    def _quantities(self) -> Iterable[str]:
        return [name for name in self if name != "time_s"]

    def __repr__(self) -> str:
        times, largest, rms = self["time_s"], self.largest, self.rms
        said = [
            f"{word} off by up to {largest[name].value:.3g} {unit} at {largest[name].time_s:.6g} s (rms {rms[name]:.3g})"
            for name, word, unit in (("attitude_rad", "attitude", "rad"), ("omega_rad_s", "ω", "rad/s"))
            if name in self
        ]
        span = f"{len(times)} rows from {times[0]:.6g} to {times[-1]:.6g} s"
        return f"<poinsot.Departure, {span}:\n {', '.join(said)}>"


def departure_of(scene: _poinsot.Scene, times: Any, omega: Any, attitude: Any) -> Departure:
    """The errors of these rows against the motion of a scene."""
    rows = rows_of(times, omega, attitude)
    names, values = scene.departure(*rows)
    return Departure({"time_s": rows[0], **dict(zip(names, values))})
