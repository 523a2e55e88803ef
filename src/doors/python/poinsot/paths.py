"""Names of files that callers give."""

from __future__ import annotations

import os
from typing import Any, Union

from .errors import InputError, shown

Path = Union[str, "os.PathLike[str]"]


def path_text(path: Any) -> str:
    """The name of a file or folder as a text. Raises InputError for names that poinsot cannot write."""
    try:
        name = os.fspath(path)
    except TypeError:
        raise InputError(f"{shown(path)} is not the name of a file; give a text or a pathlib.Path") from None
    if not isinstance(name, str):
        raise InputError(f"{shown(name)} is not a text; give the file's name as a text: os.fsdecode(name)")
    # The system ends a name at NUL, so another file would be written.
    if "\0" in name:
        raise InputError(f"{shown(name)}: no file's name contains NUL; remove it")
    try:
        name.encode("utf-8")
    except UnicodeEncodeError:
        raise InputError(f"{shown(name)}: the file's name is not valid UTF-8; rename the file") from None
    return name
