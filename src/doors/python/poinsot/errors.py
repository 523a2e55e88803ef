"""The exceptions of poinsot, with the sentences of its command line."""

from __future__ import annotations

import reprlib
from typing import Any, Optional, Tuple

__all__ = ["Error", "InputError", "EnvironmentError"]

_most_shown = 80  # characters of a value
_most_said = 600  # of a message
_short = reprlib.Repr()
_short.maxstring = _short.maxother = _short.maxlong = _most_shown


def shown(value: Any) -> str:
    """A value that cannot be used, in a part of one line: the shape of an array, the beginning of anything else."""
    shape = getattr(value, "shape", None)
    if isinstance(shape, tuple) and shape:
        return f"of type {type(value).__name__}, of shape {shape}"
    try:
        text = " ".join(_short.repr(value).split())
    except Exception:  # an object whose repr() fails
        return f"of type {type(value).__name__}"
    return text if len(text) <= _most_shown else text[: _most_shown - 1] + "…"


class Error(Exception):
    """One line that says what failed, where, and what to do."""

    def __init__(self, message: str) -> None:
        # Names and texts that are quoted may be of any length.
        super().__init__(message if len(message) <= _most_said else f"{message[:400]} … {message[-150:]}")


class InputError(Error, ValueError):
    """A scene, a value or another input cannot be used.

    Attributes:
        file: the scene file, or the option, that is at fault; None if there is none.
        line, column: the place in that file, from 1; None without one.
    """

    def __init__(
        self, message: str, file: Optional[str] = None, line: Optional[int] = None, column: Optional[int] = None
    ) -> None:
        super().__init__(message)
        self.file = file
        self.line = line
        self.column = column

    def __reduce__(self) -> Tuple[Any, ...]:
        return (type(self), (str(self), self.file, self.line, self.column))


class EnvironmentError(Error, RuntimeError):  # noqa: A001 (the name of the command line's error)
    """The system refused something: no OpenGL context, a full disk, an encoder that fails."""
