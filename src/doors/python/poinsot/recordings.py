"""Measured motions as callers give them: arrays, tables, and the free flights of a recording."""

from __future__ import annotations

import os
import re
from typing import Any, List, Mapping, Optional, Tuple

import numpy as np

from . import _poinsot
from .arrays import Numbers, are_durations, numbers, seconds, w_first
from .errors import InputError, shown
from .paths import path_text


class Flight:
    """A stretch of a recording in which the body flies freely; `fit` takes it.

    Attributes:
        times: the instants in s, shape (n,).
        omega: the angular velocity in rad/s, in the axes of the instrument, shape (n, 3).
        attitude: space from body as unit quaternions (w, x, y, z), shape (n, 4); None without attitudes.
        measured: "omega", or "attitude" where ω follows from the differences of the attitudes; `fit` fits what was
            measured.
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
        measured: str = "omega",
    ) -> None:
        self.times = times
        self.omega = omega
        self.attitude = attitude
        self.rate = rate
        self.turn_rad = turn_rad
        self.residual = residual
        self.noise = noise
        self.measured = measured

    def __len__(self) -> int:
        return len(self.times)

    def __repr__(self) -> str:
        return (
            f"<poinsot.Flight from {self.times[0]:.6g} to {self.times[-1]:.6g} s, {len(self)} rows,\n"
            f" |ω| = {self.rate:.3g} rad/s, turns by {self.turn_rad:.3g} rad, residual {self.residual:.2g} rad/s>"
        )


def flights(times: Any, omega: Any = None, *, attitude: Any = None) -> List[Flight]:
    """The free flights of a recording, among walking, throwing and catching, in order of time.

    times, omega, attitude: as for `fit`; a table in place of `times` holds all columns. A flight has 30 rows or more, turns the body by 3.5 rad or more about an axis that wanders through the
    body, and leaves residuals of at most 3 % of |ω|. Rows at the limit of the sensor are left out. Ctrl-C ends the
    search. Raises InputError as `fit` does.

    >>> import numpy as np
    >>> from poinsot import Motion
    >>> t = np.arange(0.0, 4.0, 0.01)
    >>> [flight] = flights(t, Motion([3.0, 2.0, 1.0], [0.3, 6.0, 0.2]).at(t).omega_body)
    >>> len(flight) == len(t)
    True
    """
    return [Flight(**found) for found in _poinsot.flights(*rows_of(times, omega, attitude))]


#: times, omega and attitude; what the caller does not have is None.
Rows = Tuple[Numbers, Optional[Numbers], Optional[Numbers]]


def rows_of(times: Any, omega: Any = None, attitude: Any = None) -> Rows:
    """times, omega and attitude as arrays, of arrays or of a table that holds them."""
    if omega is None and attitude is None:
        return _rows_of_table(times)
    measured = None if omega is None else numbers("omega", omega)
    return seconds("times", times), measured, None if attitude is None else numbers("attitude", w_first(attitude))


def is_table(given: Any) -> bool:
    """Whether it holds times and ω in one: a flight, a fit, columns by name or a file."""
    return _is_held(given) or _columns_of(given) is not None or isinstance(given, (str, os.PathLike))


def _is_held(given: Any) -> bool:
    return hasattr(given, "times") and hasattr(given, "omega") and not hasattr(given, "columns")


def _columns_of(given: Any) -> Optional[List[Tuple[str, Any]]]:
    """The names and values of a record array, a dict or a data frame; None of anything else."""
    names = getattr(getattr(given, "dtype", None), "names", None)
    if names:
        return [(name, given[name]) for name in names]
    if isinstance(given, Mapping):
        return [(str(name), column) for name, column in given.items()]
    if not hasattr(given, "columns") or not hasattr(given, "__getitem__"):
        return None
    # Of pandas, times may be the index.
    frame = given.reset_index() if getattr(getattr(given, "index", None), "name", None) is not None else given
    pairs = frame.items() if hasattr(frame, "items") else [(name, frame[name]) for name in frame.columns]
    return [(str(name), column) for name, column in pairs]


def _rows_of_table(given: Any) -> Rows:
    if _is_held(given):
        if given.omega is None and getattr(given, "attitude", None) is None:
            raise InputError(f"{shown(given)} has neither omega nor attitude")
        omega = None if getattr(given, "measured", "omega") == "attitude" else given.omega
        return rows_of(given.times, omega, getattr(given, "attitude", None))
    if isinstance(given, (str, os.PathLike)):
        name = path_text(given)
        try:
            with open(name, encoding="utf-8", newline="") as file:
                text = file.read()
        except (OSError, UnicodeDecodeError) as error:
            why = getattr(error, "strerror", None) or "it is not a text in UTF-8"
            raise InputError(f"{name}: cannot be read: {why}", name) from None
        return _rows_of_text(text, name)
    columns = _columns_of(given)
    if columns is not None:
        return _rows_of_text(_text_of(columns), "the table")
    raise InputError("omega: is missing; give times and omega as arrays, a table with both, or a list of flights")


def _text_of(columns: List[Tuple[str, Any]]) -> str:
    """The columns of numbers as CSV. Other columns may be anything."""
    held = [found for found in (_column(name, values) for name, values in columns) if found is not None]
    if not held:
        raise InputError("the table has no columns of numbers; give time, omega_x, omega_y and omega_z")
    if len({len(cells) for _, cells in held}) > 1:
        sizes = ", ".join(f"{name}: {len(cells)}" for name, cells in held)
        raise InputError(f"the table's columns have different numbers of rows: {sizes}")
    # The reader takes a heading between quotes as it is.
    head = ",".join('"' + re.sub(r'["\s]', " ", name) + '"' for name, _ in held)
    return "\n".join([head, *(",".join(row) for row in zip(*(cells for _, cells in held))), ""])


def _column(name: str, values: Any) -> Optional[Tuple[str, List[str]]]:
    """The heading and the cells of a column of numbers or of differences of time; None of another."""
    try:
        array = np.asarray(values)
    except (ValueError, TypeError):
        return None
    kind = getattr(getattr(values, "dtype", None), "kind", array.dtype.kind)
    if kind in "fiu" and array.dtype.kind == "O":  # of pandas, with missing values
        array = np.asarray(values.to_numpy(dtype=np.float64, na_value=np.nan))
    elif are_durations(array):
        name = "time_s"
    elif array.dtype.kind not in "fiu":
        return None
    if array.ndim == 0:
        return None
    if array.ndim > 1:
        raise InputError(
            f"{name}: a column has one number in a row, and this is {shown(array)}; give a column for each "
            "component, as omega_x"
        )
    numbers_of = seconds(name, values if isinstance(values, np.ma.MaskedArray) else array).tolist()
    return name, ["" if one != one else repr(one) for one in numbers_of]


def _rows_of_text(text: str, name: str) -> Rows:
    return _poinsot.table(text, name)
