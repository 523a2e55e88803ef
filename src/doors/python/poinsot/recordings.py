"""Measured motions as callers give them: arrays, tables, and the free flights of a recording."""

from __future__ import annotations

import os
from typing import Any, List, Optional, Tuple

from . import _poinsot
from .arrays import Numbers, numbers, w_first
from .errors import InputError
from .paths import path_text


class Flight:
    """A stretch of a recording in which the body flies freely; `fit` takes it.

    Attributes:
        times: the instants in s, shape (n,).
        omega: the angular velocity in rad/s, in the axes of the instrument, shape (n, 3).
        attitude: space from body as unit quaternions (w, x, y, z), shape (n, 4); None without attitudes.
        rate: the root mean square of |ω|, rad/s.
        turn_rad: the angle ∫|ω| dt through which the body turned, rad.
        residual: how far ω is from a free motion, the root mean square of a component, rad/s.
        noise: how far a component scatters from row to row, rad/s.
    """

    def __init__(
        self,
        times: Numbers,
        omega: Numbers,
        attitude: Optional[Numbers],
        rate: float,
        turn_rad: float,
        residual: float,
        noise: float,
    ) -> None:
        self.times = times
        self.omega = omega
        self.attitude = attitude
        self.rate = rate
        self.turn_rad = turn_rad
        self.residual = residual
        self.noise = noise

    def __len__(self) -> int:
        return len(self.times)

    def __repr__(self) -> str:
        return (
            f"<poinsot.Flight from {self.times[0]:.6g} to {self.times[-1]:.6g} s, {len(self)} rows,\n"
            f" |ω| = {self.rate:.3g} rad/s, turns by {self.turn_rad:.3g} rad, residual {self.residual:.2g} rad/s>"
        )


def flights(times: Any, omega: Any = None, *, attitude: Any = None) -> List[Flight]:
    """The free flights of a recording, among walking, throwing and catching, in order of time.

    times, omega, attitude: as for `fit`; a table (a pandas.DataFrame or a CSV file) in place of `times` holds all
    columns. A flight has 30 rows or more, turns the body by 3.5 rad or more about an axis that wanders through the
    body, and leaves residuals of at most 3 % of |ω|. Rows at the limit of the sensor are left out. Ctrl-C ends the
    search. Raises InputError as `fit` does.

    >>> import numpy as np
    >>> from poinsot import Motion
    >>> t = np.arange(0.0, 4.0, 0.01)
    >>> [flight] = flights(t, Motion([3.0, 2.0, 1.0], [0.3, 6.0, 0.2]).at(t).omega_body)
    >>> len(flight) == len(t)
    True
    """
    rows = with_omega(rows_of(times, omega, attitude))
    return [Flight(**found) for found in _poinsot.flights(*rows)]


#: times, omega and attitude; what the caller does not have is None.
Rows = Tuple[Numbers, Optional[Numbers], Optional[Numbers]]


def rows_of(times: Any, omega: Any = None, attitude: Any = None) -> Rows:
    """times, omega and attitude as arrays, of arrays or of a table that holds them."""
    if omega is None and attitude is None:
        return _rows_of_table(times)
    measured = None if omega is None else numbers("omega", omega)
    return numbers("times", times), measured, None if attitude is None else numbers("attitude", w_first(attitude))


def with_omega(rows: Rows) -> Tuple[Numbers, Numbers, Optional[Numbers]]:
    """The rows; those with attitudes alone get ω from the differences of these."""
    times, omega, attitude = rows
    if omega is None:
        assert attitude is not None
        omega = _poinsot.omega_by_differences(times, attitude)
    return times, omega, attitude


def is_table(given: Any) -> bool:
    """Whether it holds times and ω in one: a flight, a fit, a data frame or a file."""
    held = hasattr(given, "times") and hasattr(given, "omega")
    return held or hasattr(given, "to_csv") or isinstance(given, (str, os.PathLike))


def _rows_of_table(given: Any) -> Rows:
    if hasattr(given, "times") and hasattr(given, "omega"):
        return given.times, given.omega, getattr(given, "attitude", None)
    if isinstance(given, (str, os.PathLike)):
        name = path_text(given)
        try:
            with open(name, encoding="utf-8", newline="") as file:
                text = file.read()
        except (OSError, UnicodeDecodeError) as error:
            why = getattr(error, "strerror", None) or "it is not a text in UTF-8"
            raise InputError(f"{name}: cannot be read: {why}", name) from None
        return _rows_of_text(text, name)
    if hasattr(given, "to_csv"):
        # Times may be the index. Only columns of numbers count: others may be anything.
        frame = given if given.index.name is None else given.reset_index()
        of_numbers = frame.select_dtypes("number")
        if not len(of_numbers.columns):
            raise InputError("the table has no columns of numbers; give time, omega_x, omega_y and omega_z")
        return _rows_of_text(of_numbers.to_csv(index=False), "the table")
    raise InputError("omega: is missing; give times and omega as arrays, a table with both, or a list of flights")


def _rows_of_text(text: str, name: str) -> Rows:
    found = _poinsot.table(text, name)
    return found["times"], found["omega"], found["attitude"]
