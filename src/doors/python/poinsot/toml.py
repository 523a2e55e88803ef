"""Writes values and scenes as TOML."""

from __future__ import annotations

import json
import math
import os
import re
from typing import Any, Iterator, List, Mapping, Tuple

from .errors import InputError, shown

_bare_key = re.compile(r"[A-Za-z0-9_-]+")


def unicode_text(where: str, text: str) -> str:
    """The text, if it is one of a file: it may hold no half of a surrogate pair. Raises InputError."""
    if not isinstance(text, str):
        raise InputError(f"{where}: is a text, and this is {shown(text)}")
    try:
        text.encode("utf-8")
    except UnicodeEncodeError as error:
        raise InputError(f"{where}: not valid Unicode: {error}; give plain text") from None
    return text


def value_text(value: Any) -> str:
    """A value as TOML: a boolean, a number, a text, a path, a list or a table.

    NumPy's numbers and arrays count as Python's. Raises InputError for anything else.
    """
    if hasattr(value, "tolist"):
        value = value.tolist()
    if isinstance(value, bool):
        return "true" if value else "false"
    if isinstance(value, int):
        # Not str(): a subclass, such as an enumeration, may print as anything.
        return int.__repr__(value)
    if isinstance(value, float):
        if math.isnan(value):
            return "nan"
        return float.__repr__(value) if math.isfinite(value) else ("inf" if value > 0 else "-inf")
    if isinstance(value, os.PathLike):
        value = os.fspath(value)
    if isinstance(value, str):
        # JSON's escapes are TOML's, but TOML also wants DEL escaped.
        return json.dumps(value, ensure_ascii=False).replace("\x7f", "\\u007f")
    if isinstance(value, Mapping):
        held = [f"{_key(key)} = {value_text(one)}" for key, one in value.items() if one is not None]
        return "{" + ", ".join(held) + "}"
    if isinstance(value, (list, tuple)):
        return "[" + ", ".join(value_text(one) for one in value) + "]"
    raise InputError(f"a value of type {type(value).__name__} cannot stand in a scene; give a number, a text or a list")


def _key(key: Any) -> str:
    if not isinstance(key, str):
        raise InputError(f"a scene's keys are texts, not {type(key).__name__}")
    return key if _bare_key.fullmatch(key) else value_text(key)


def _is_tables(value: Any) -> bool:
    return isinstance(value, (list, tuple)) and bool(value) and all(isinstance(one, Mapping) for one in value)


def _lines(table: Mapping[Any, Any], path: List[str]) -> Iterator[str]:
    inner = []
    for key, value in table.items():
        if value is None:
            continue
        if isinstance(value, Mapping) or _is_tables(value):
            inner.append((key, value))
        else:
            yield f"{_key(key)} = {value_text(value)}"
    for key, value in inner:
        below = path + [_key(key)]
        name = ".".join(below)
        for one in [value] if isinstance(value, Mapping) else value:
            yield f"[{name}]" if isinstance(value, Mapping) else f"[[{name}]]"
            yield from _lines(one, below)


def scene_text(scene: Mapping[Any, Any]) -> str:
    """A scene of nested tables as the text of a scene file; keys whose value is None are left out."""
    return "\n".join(_lines(scene, [])) + "\n"


def assignments(values: Any) -> List[str]:
    """Values by dotted key or in nested dicts, as --set takes them; keys inside dicts whose value is None are left out."""
    if not isinstance(values, Mapping):
        raise InputError(f"values: is a dict of keys and values, and this is of type {type(values).__name__}")
    return [unicode_text("values", f"{key}={value_text(value)}") for key, value in _single(values, "")]


def _single(values: Mapping[Any, Any], above: str) -> Iterator[Tuple[str, Any]]:
    for key, value in values.items():
        dotted = above + _dotted(key)
        if value is None and not above:
            raise InputError(f"{dotted}: None is no value; give the value that the key shall have")
        if isinstance(value, Mapping):
            yield from _single(value, dotted + ".")
        elif value is not None:
            yield dotted, value


def _dotted(key: Any) -> str:
    if not isinstance(key, str) or not key or "=" in key:
        raise InputError(f'values: {shown(key)} is not a key; write one such as "start.omega_rad_s"')
    return key
