"""Arrays that callers give."""

from __future__ import annotations

import datetime
from typing import Any

import numpy as np

from numpy.typing import NDArray

from .errors import InputError, shown

Numbers = NDArray[np.float64]
Pixels = NDArray[np.uint8]


# Modes of PIL whose 8-bit numbers are not grey, R, G, B and alpha.
_pil_modes_to_convert = {"P", "PA", "LA", "La", "RGBX", "RGBa", "CMYK", "YCbCr", "LAB", "HSV"}


_masked: Any = np.ma  # NumPy's types leave it out


def _refuse_masked(name: str, values: Any) -> None:
    # Without its mask, an array has numbers again where the caller has none.
    if isinstance(values, np.ma.MaskedArray) and _masked.is_masked(values):
        raise InputError(f"{name}: some values are masked; take them out, or put others in their place: .filled(0)")


def number(name: str, value: Any) -> float:
    """One number. Raises InputError for other types."""
    if not isinstance(value, (str, bytes, bytearray)):  # float() would read them
        try:
            return float(value)
        except (TypeError, ValueError, OverflowError):
            pass
    raise InputError(f"{name}: is a number, and this is {shown(value)}")


def numbers(name: str, values: Any) -> Numbers:
    """The values as an array of float64, of any shape. Raises InputError for other types."""
    _refuse_masked(name, values)
    try:
        array = np.asarray(values)
    except (ValueError, TypeError) as error:
        raise InputError(f"{name}: not an array of numbers: {error}") from None
    if array.dtype.kind not in "fiu":
        raise InputError(f"{name}: numbers are needed, and these are of type {array.dtype}")
    return np.ascontiguousarray(array, dtype=np.float64).reshape(array.shape)


def are_durations(array: NDArray[Any]) -> bool:
    """Whether the values are differences of time, such as Timedelta."""
    if array.dtype.kind == "O" and array.size:
        return all(isinstance(one, datetime.timedelta) for one in array.flat)
    return array.dtype.kind == "m"


def seconds(name: str, values: Any) -> Numbers:
    """Instants in s, of any shape, as `numbers`; differences of time count in seconds."""
    _refuse_masked(name, values)
    try:
        array = np.asarray(values)
    except (ValueError, TypeError):
        return numbers(name, values)
    if array.dtype.kind == "M":
        raise InputError(f"{name}: these are dates; give seconds, or differences: subtract the first one")
    if are_durations(array):
        in_s = [one.total_seconds() for one in array.flat] if array.dtype.kind == "O" else array / np.timedelta64(1, "s")
        return np.array(in_s, dtype=np.float64).reshape(array.shape)
    return numbers(name, array)


def second(name: str, value: Any) -> float:
    """One instant in s, as `number`; a difference of time counts in seconds."""
    if isinstance(value, (datetime.timedelta, np.timedelta64)):
        return float(seconds(name, value))
    return number(name, value)


def whole(name: str, value: Any) -> int:
    """One whole number. Raises InputError for other numbers, and for those of more than nine digits."""
    given = number(name, value)
    if not abs(given) <= 1e9 or given != int(given):
        raise InputError(f"{name}: is a whole number, and this is {shown(value)}")
    return int(given)


def w_first(attitude: Any) -> Any:
    """The attitude; of a Rotation of SciPy, whose quaternions are (x, y, z, w), the numbers in the order (w, x, y, z)."""
    return np.roll(attitude.as_quat(), 1, axis=-1) if hasattr(attitude, "as_quat") else attitude


def pixels(name: str, values: Any) -> Pixels:
    """A picture as an array of shape (height, width, 4) of 8-bit values.

    Takes 8-bit values, or floats from 0 to 1; grey (H×W), RGB (H×W×3) or RGBA (H×W×4); and the
    pictures of PIL.
    """
    _refuse_masked(name, values)
    if getattr(values, "mode", None) in _pil_modes_to_convert:
        values = values.convert("RGBA")
    try:
        array = np.asarray(values)
    except (ValueError, TypeError) as error:
        raise InputError(f"{name}: not a picture: {error}") from None
    if array.dtype == np.bool_ or array.dtype.kind == "f":
        array = array.astype(np.float64)
        if array.size and not (np.all(array >= 0.0) and np.all(array <= 1.0)):
            raise InputError(f"{name}: floats are taken as 0 to 1, and some are not; give 8-bit values or scale them")
        array = np.rint(255.0 * array).astype(np.uint8)
    if array.dtype != np.uint8:
        raise InputError(f"{name}: pixels are 8-bit values or floats from 0 to 1, and these are of type {array.dtype}")
    if array.ndim == 2:
        array = array[:, :, np.newaxis].repeat(3, axis=2)
    if array.ndim != 3 or array.shape[2] not in (3, 4) or 0 in array.shape:
        raise InputError(f"{name}: a picture has the shape (height, width), (height, width, 3) or (height, width, 4), "
                         f"and this has {array.shape}")
    if array.shape[2] == 3:
        array = np.concatenate([array, np.full(array.shape[:2] + (1,), 255, np.uint8)], axis=2)
    return np.ascontiguousarray(array)
