"""The motion at many instants."""

from __future__ import annotations

from typing import Any, Dict

import numpy as np

from .arrays import Numbers


class Samples(Dict[str, Numbers]):
    """Columns by name, each a contiguous array of float64 in the shape of the instants.

    The names are those of `poinsot sample`: "time_s", "omega_body_1", … "q_w", …; with columns=…
    they carry their unit, as "omega_body_1_rad_s". The name of a quantity, such as "omega_body" or
    "q", gives all its components as the last axis.
    """

    def __missing__(self, name: Any) -> Numbers:
        parts = [value for key, value in self.items() if _is_part(key, name)]
        if not parts:
            raise KeyError(f"{name}: not a column; there are {', '.join(self)}")
        return np.stack(parts, axis=-1)

    def to_pandas(self) -> Any:
        """The columns as a pandas.DataFrame; needs pandas."""
        import pandas

        return pandas.DataFrame({name: value.ravel() for name, value in self.items()})


def _is_part(column: str, quantity: Any) -> bool:
    if not isinstance(quantity, str) or not column.startswith(quantity + "_"):
        return False
    component = column[len(quantity) + 1 :].split("_", 1)[0]
    return component in ("1", "2", "3", "w", "x", "y", "z")
