#!/usr/bin/env python3
"""Checks the program's schema with an independent JSON Schema validator.

Usage: schema_check.py POINSOT
Every scene in scenes/ is valid and names the schema for editors; the schema in scenes/ is the one that the program prints; every
key has a type; the schema rejects an unknown key in every table and, as the program does, a value of another type and a list of
another length; and for every numeric key, the schema has the bounds that the program states in its error message, rejects 0 where the
program requires a positive number, and accepts what the program accepts. Every default is valid for its own key, every key whose name ends in a unit has that unit, and every key with a fixed
list of names rejects another name, as the program does.
"""
import json
import pathlib
import re
import subprocess
import sys
import tempfile
import tomllib

import jsonschema

ROOT = pathlib.Path(__file__).resolve().parents[2]
# The unit of a key by the end of its name; longer ends first.
UNITS = {
    "_kg_m2_s": "kg m²/s", "_kg_m2": "kg m²", "_kg_m3": "kg/m³", "_rad_s": "rad/s", "_N_m": "N m", "_1_s": "1/s", "_1_rad": "1/rad", "_deg": "degrees", "_rad": "rad",
    "_kg": "kg", "_px": "pixels", "_m": "m", "_s": "s",
}


def leaves(schema):
    if "properties" in schema:
        for name, below in schema["properties"].items():
            for path, leaf in leaves(below):
                yield f"{name}.{path}" if path else name, leaf
    elif "properties" in schema.get("items", {}):
        yield from leaves(schema["items"])
    else:
        yield "", schema


def keys(schema, header=""):
    """For every key: its name, its type, and a scene template that sets it alone, because the table's own keys must be read before
    missing keys are reported."""
    for name, leaf in schema["properties"].items():
        items = leaf.get("items", {})
        if "properties" in leaf:
            yield from keys(leaf, f"[{name}]")
        elif "properties" in items:
            yield from keys(items, f"[[{header[1:-1] + '.' if header else ''}{name}]]")
        else:
            yield f"{header}{name}", leaf, f"{header}\n{name} = {{}}\n"


def tables(schema, path=""):
    """Every table of the schema, with its path."""
    yield path, schema
    for name, leaf in schema["properties"].items():
        for below in (leaf, leaf.get("items", {})):
            if "properties" in below:
                yield from tables(below, f"{path}.{name}")


def said_of(program, scene):
    with tempfile.NamedTemporaryFile("w", suffix=".toml") as file:
        file.write(scene)
        file.flush()
        return subprocess.run([program, "check", file.name], capture_output=True, text=True).stderr


def disagreements(program, schema):
    """Differences of the bounds between schema and program: at 0, and for large numbers of both signs."""
    n_positive = n_bounded = 0
    for key, leaf, scene in keys(schema):
        items = leaf.get("items", {})
        if not re.search('"(number|integer)"', json.dumps(items or leaf)) or "items" in items:
            continue
        number = next((one for one in leaf.get("anyOf", [leaf]) if one.get("type") in ("number", "integer")), None)
        if "items" not in leaf and number is None:
            continue
        zero = [0] * leaf.get("minItems", 1) if "items" in leaf else 0
        refused = not jsonschema.Draft4Validator(leaf).is_valid(zero)
        said = said_of(program, scene.format(zero))
        bounded = re.search(r"give an? \w+ from (\S+) to (\S+)$", said.strip())
        n_positive += refused and not bounded
        if refused != ("greater than 0" in said or bounded is not None):
            yield f"{key} = {zero}: the schema {'refuses' if refused else 'takes'} it, the program says {said.strip()!r}"
        if "items" in leaf:
            number = next((one for one in leaf["items"].get("anyOf", [leaf["items"]]) if "type" in one), {})
        for value in (-10**9, 10**15):
            if "items" in leaf:
                written = [value if number.get("type") == "integer" else float(value)] * max(leaf.get("minItems", 1), 1)
                said = said_of(program, scene.format(written))
            else:
                said = said_of(program, scene.format(value if number.get("type") == "integer" else f"{value}.0"))
            bounded = re.search(r"give an? \w+ from (\S+) to (\S+)$", said.strip())
            told = tuple(map(float, bounded.groups())) if bounded else (None, None)
            if least := re.search(r"give an? \w+ of at least (\S+)$", said.strip()):
                told = (float(least[1]), None)
            has = (number.get("minimum"), number.get("maximum")) if "exclusiveMinimum" not in number else (None, None)
            n_bounded += bounded is not None
            inside = has[0] is not None and has[0] <= value and (has[1] is None or value <= has[1])
            if told != has and not (bounded is None and least is None and inside):
                yield f"{key}: the schema has {has}, the program says {said.strip()!r}"
    if n_positive < 10 or n_bounded < 60:
        yield f"only {n_positive} keys refuse 0, and {n_bounded} values were out of bounds"


def wrong_types(program, schema):
    """Keys for which the schema accepts an unknown name, a table, or a list of a length that the program refuses."""
    n_tables = n_lists = 0
    for path, table in tables(schema):
        n_tables += 1
        if jsonschema.Draft4Validator(table).is_valid({"no_such_key": 1}) or table.get("additionalProperties") is not False:
            yield f"{path}: the schema accepts an unknown key"
    for key, leaf, scene in keys(schema):
        if jsonschema.Draft4Validator(leaf).is_valid({"a": {"b": 1}}) and not key.endswith("labels"):
            yield f"{key}: the schema accepts a table"
        if "minItems" not in leaf or '"number"' not in json.dumps(leaf):
            continue
        n_lists += 1
        one = [1] * 3 if "items" in leaf["items"] else 1
        for n in {leaf["minItems"] - 1, leaf["minItems"], leaf.get("maxItems", 5), leaf.get("maxItems", 5) + 1}:
            refused = not jsonschema.Draft4Validator(leaf).is_valid([one] * n)
            if refused != ("it must be" in said_of(program, scene.format([one] * n))):
                yield f"{key}: the schema {'refuses' if refused else 'takes'} {n} values, the program does not"
    if n_tables < 20 or n_lists < 12:
        yield f"only {n_tables} tables and {n_lists} lists of numbers"


def wrong_descriptions(program, schema):
    n_defaults = n_units = n_enumerations = 0
    for path, leaf in leaves(schema):
        if "default" in leaf:
            n_defaults += 1
            for error in jsonschema.Draft4Validator(leaf).iter_errors(leaf["default"]):
                yield f"{path}: its default is not valid: {error.message}"
        n_units += "x-unit" in leaf
        by_name = next((unit for ending, unit in UNITS.items() if path.endswith(ending)), leaf.get("x-unit"))
        if leaf.get("x-unit") != by_name:
            yield f"{path}: the unit is {leaf.get('x-unit')}, the name says {by_name}"
    for key, leaf, scene in keys(schema):
        if "enum" not in leaf:
            continue
        n_enumerations += 1
        if jsonschema.Draft4Validator(leaf).is_valid("no such name"):
            yield f"{key}: the schema accepts an unknown name"
        # The program looks up the names of `poinsot list` only in complete scenes.
        if "in `poinsot list" not in leaf["description"] and "no such name" not in said_of(program, scene.format('"no such name"')):
            yield f"{key}: the program accepts an unknown name"
    if n_defaults < 40 or n_units < 40 or n_enumerations < 25:
        yield f"only {n_defaults} defaults, {n_units} units and {n_enumerations} keys with a fixed list of names"


def findings(program):
    text = subprocess.run([program, "list", "schema"], check=True, capture_output=True, text=True).stdout
    schema = json.loads(text)
    jsonschema.Draft4Validator.check_schema(schema)
    validator = jsonschema.Draft4Validator(schema)
    if (ROOT / "scenes" / "scene.schema.json").read_text() != text:
        yield "scenes/scene.schema.json is not what `poinsot list schema` prints: cmake --build build/release --target docs"
    for path, leaf in leaves(schema):
        if not {"type", "enum", "anyOf"} & set(leaf):
            yield f"{path}: src/doors/cli/scene_schema.cpp does not know what this key's type means: {leaf['description']}"

    scenes = sorted((ROOT / "scenes").glob("*.toml"))
    for scene in scenes:
        if not scene.read_text().startswith("#:schema scene.schema.json\n"):
            yield f"{scene.name}: its first line must be `#:schema scene.schema.json`, for editors"
        for error in validator.iter_errors(tomllib.loads(scene.read_text())):
            yield f"{scene.name}: {error.message}"

    yield from disagreements(program, schema)
    yield from wrong_descriptions(program, schema)
    yield from wrong_types(program, schema)
    if len(scenes) < 30:
        yield f"{len(scenes)} scenes"


if __name__ == "__main__":
    wrong = list(findings(sys.argv[1]))
    print("\n".join(wrong))
    sys.exit(1 if wrong else 0)
