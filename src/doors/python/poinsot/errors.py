"""The exceptions of poinsot, with the sentences of its command line."""

from __future__ import annotations

from typing import Any, Optional, Tuple

__all__ = ["Error", "InputError", "EnvironmentError"]


class Error(Exception):
    """One line that says what failed, where, and what to do."""


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
