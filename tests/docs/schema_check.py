#!/usr/bin/env python3
"""Checks the program's schema with an independent JSON Schema validator.

Usage: schema_check.py POINSOT
Every scene in scenes/ is valid and names the schema for editors; the schema in scenes/ is the one that the program prints; every
key has a type; 44 invalid scenes are rejected at the same key as by the program; and for every numeric key, the schema has the
bounds that the program states in its error message, rejects 0 where the program requires a positive number, and accepts what the
program accepts. Every default is valid for its own key, every key whose name ends in a unit has that unit, and every key with a fixed
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
GOOD = """
title = "good"
theme = "light"
show = ["plane", "ellipsoid"]
[body]
moments_kg_m2 = [3.0, 2.0, 1.0]
[start]
omega_rad_s = [0.01, 2.0, 0.01]
[film]
duration_s = 1.0
"""
# A scene is GOOD with one line replaced, or with lines added: (the replaced line or "", its replacement, the invalid key).
BROKEN = [
    ('title = "good"', 'title = 3', "title"),
    ('title = "good"', 'titel = "good"', "titel"),
    ('title = "good"', 'caption = ["a"]', "caption"),
    ('title = "good"', 'accuracy_px = "small"', "accuracy_px"),
    ('theme = "light"', 'theme = "lihgt"', "theme"),
    ('theme = "light"', 'theme = true', "theme"),
    ('show = ["plane", "ellipsoid"]', 'show = "plane"', "show"),
    ('show = ["plane", "ellipsoid"]', 'show = ["plane", 3]', "show"),
    ('show = ["plane", "ellipsoid"]', 'show = ["plane", "elipsoid"]', "show"),
    ("moments_kg_m2 = [3.0, 2.0, 1.0]", "moments_kg_m2 = [3.0, 2.0]", "moments_kg_m2"),
    ("moments_kg_m2 = [3.0, 2.0, 1.0]", "moments_kg_m2 = [3.0, 2.0, 1.0, 1.0]", "moments_kg_m2"),
    ("moments_kg_m2 = [3.0, 2.0, 1.0]", 'moments_kg_m2 = ["3", "2", "1"]', "moments_kg_m2"),
    ("moments_kg_m2 = [3.0, 2.0, 1.0]", "moments_kg_m2 = 3.0", "moments_kg_m2"),
    ("moments_kg_m2 = [3.0, 2.0, 1.0]", "moments_kg_m2 = [3.0, 2.0, -1.0]", "moments_kg_m2"),
    ("duration_s = 1.0", "duration_s = 0", "duration_s"),
    ("", '[torque]\nkind = "dissipation"\nhalf_life_s = "soon"', "half_life_s"),
    ("", 'language = "klingon"', "language"),
    ("moments_kg_m2 = [3.0, 2.0, 1.0]", "moments = [3.0, 2.0, 1.0]", "moments"),
    ("moments_kg_m2 = [3.0, 2.0, 1.0]", "tensor_kg_m2 = [[3.0, 0.0, 0.0], [0.0, 2.0, 0.0]]", "tensor_kg_m2"),
    ("moments_kg_m2 = [3.0, 2.0, 1.0]", "tensor_kg_m2 = [[3.0, 0.0], [0.0, 2.0], [0.0, 0.0]]", "tensor_kg_m2"),
    ("moments_kg_m2 = [3.0, 2.0, 1.0]", 'shape = "bx"\nsize_m = [1.0, 1.0, 1.0]\nmass_kg = 1.0', "shape"),
    ("moments_kg_m2 = [3.0, 2.0, 1.0]", 'shape = "box"\nsize_m = "1"\nmass_kg = 1.0', "size_m"),
    ("moments_kg_m2 = [3.0, 2.0, 1.0]", 'shape = "box"\nsize_m = [1.0, 1.0, 1.0]\nmass_kg = "1"', "mass_kg"),
    ("moments_kg_m2 = [3.0, 2.0, 1.0]", 'object = "teapot"', "object"),
    ("moments_kg_m2 = [3.0, 2.0, 1.0]", "moments_kg_m2 = [3.0, 2.0, 1.0]\nallow_unphysical = 1", "allow_unphysical"),
    ("moments_kg_m2 = [3.0, 2.0, 1.0]", "[[body.masses]]\nmass_kg = 1.0\nat = [1.0, 0.0, 0.0]", "at"),
    ("moments_kg_m2 = [3.0, 2.0, 1.0]", "[[body.masses]]\nmass_kg = [1.0]\nat_m = [1.0, 0.0, 0.0]", "mass_kg"),
    ("omega_rad_s = [0.01, 2.0, 0.01]", "omega = [0.01, 2.0, 0.01]", "omega"),
    ("omega_rad_s = [0.01, 2.0, 0.01]", "omega_rad_s = [0.01, true, 0.01]", "omega_rad_s"),
    ("omega_rad_s = [0.01, 2.0, 0.01]", "omega_rad_s = [0.01, 2.0, 0.01]\nattitude = [1.0, 0.0, 0.0]", "attitude"),
    ("duration_s = 1.0", 'duration_s = "1"', "duration_s"),
    ("duration_s = 1.0", "length = 1.0", "length"),
    ("duration_s = 1.0", "fps = true", "fps"),
    ("duration_s = 1.0", "size = [1920.5, 1080]", "size"),
    ("duration_s = 1.0", "size = [1920]", "size"),
    ("duration_s = 1.0", 'quality = "best"', "quality"),
    ("", '[camera]\nview = "beside"', "view"),
    ("", '[camera]\nlook_at = "nowhere"', "look_at"),
    ("", '[camera]\nmotion = "moving"', "motion"),
    ("", '[trail]\npolhode = "half"', "polhode"),
    ("", '[trail]\ndirection_marks = "yes"', "direction_marks"),
    ("", '[torque]\nkind = "friction"', "kind"),
    ("", '[[panels]]\nkind = "spaces"', "kind"),
    ("", '[[keyframes]]\nat_s = 0.0\neasing = "bumpy"', "easing"),
]
# The unit of a key by the end of its name; longer ends first.
UNITS = {
    "_kg_m2_s": "kg m²/s", "_kg_m2": "kg m²", "_kg_m3": "kg/m³", "_rad_s": "rad/s", "_N_m": "N m", "_1_s": "1/s", "_deg": "degrees", "_rad": "rad",
    "_kg": "kg", "_px": "pixels", "_m": "m", "_s": "s",
}


def key_of(error):
    """The innermost key to which a validator's error refers."""
    if error.validator == "additionalProperties":
        known = error.schema["properties"]
        return next(name for name in error.instance if name not in known)
    return next((part for part in reversed(error.absolute_path) if isinstance(part, str)), "")


def leaves(schema):
    if "properties" in schema:
        for name, below in schema["properties"].items():
            for path, leaf in leaves(below):
                yield f"{name}.{path}" if path else name, leaf
    elif "properties" in schema.get("items", {}):
        yield from leaves(schema["items"])
    else:
        yield "", schema


def numbers(schema, header=""):
    """For every numeric key: its name, its type, and a scene template that sets it."""
    for name, leaf in schema["properties"].items():
        items = leaf.get("items", {})
        if "properties" in leaf:
            yield from numbers(leaf, f"[{name}]")
        elif "properties" in items:
            yield from numbers(items, f"[[{header[1:-1] + '.' if header else ''}{name}]]")
        elif re.search('"(number|integer)"', json.dumps(items or leaf)) and "items" not in items:
            # No other keys: the table's own keys must be parsed before missing keys are reported.
            yield f"{header}{name}", leaf, f"{header}\n{name} = {{}}\n"


def said_of(program, scene):
    with tempfile.NamedTemporaryFile("w", suffix=".toml") as file:
        file.write(scene)
        file.flush()
        return subprocess.run([program, "check", file.name], capture_output=True, text=True).stderr


def disagreements(program, schema):
    """Differences of the bounds between schema and program: at 0, and for large numbers of both signs."""
    n_positive = n_bounded = 0
    for key, leaf, scene in numbers(schema):
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
            has = (number.get("minimum"), number.get("maximum")) if "exclusiveMinimum" not in number else (None, None)
            n_bounded += bounded is not None
            if told != has and not (bounded is None and None not in has and has[0] <= value <= has[1]):
                yield f"{key}: the schema has {has}, the program says {said.strip()!r}"
    if n_positive < 10 or n_bounded < 60:
        yield f"only {n_positive} keys refuse 0, and {n_bounded} values were out of bounds"


def enumerations(schema, header=""):
    """Yields every key with a fixed list of names: its name, its schema, and a scene that sets it, with a place for the value."""
    for name, leaf in schema["properties"].items():
        items = leaf.get("items", {})
        if "properties" in leaf:
            yield from enumerations(leaf, f"[{name}]")
        elif "properties" in items:
            yield from enumerations(items, f"[[{header[1:-1] + '.' if header else ''}{name}]]")
        elif "enum" in leaf:
            yield f"{header}{name}", leaf, f"{header}\n{name} = {{}}\n"


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
    for key, leaf, scene in enumerations(schema):
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
            yield f"{path}: src/cli/scene_schema.cpp does not know what this key's type means: {leaf['description']}"

    scenes = sorted((ROOT / "scenes").glob("*.toml"))
    for scene in scenes:
        if not scene.read_text().startswith("#:schema scene.schema.json\n"):
            yield f"{scene.name}: its first line must be `#:schema scene.schema.json`, for editors"
        for error in validator.iter_errors(tomllib.loads(scene.read_text())):
            yield f"{scene.name}: {error.message}"

    yield from disagreements(program, schema)
    yield from wrong_descriptions(program, schema)
    good = tomllib.loads(GOOD)
    yield from (f"the good scene: {error.message}" for error in validator.iter_errors(good))
    for old, new, key in BROKEN:
        broken = GOOD.replace(old, new) if old else GOOD + new + "\n"
        found = {key_of(error) for error in validator.iter_errors(tomllib.loads(broken))}
        if found != {key}:
            yield f"{new!r}: refused for {found or 'nothing'}, should be for {key}"
        with tempfile.NamedTemporaryFile("w", suffix=".toml") as file:
            file.write(broken)
            file.flush()
            done = subprocess.run([program, "check", file.name], capture_output=True, text=True)
            named = key in done.stderr or new.split('"')[-2:-1] and new.split('"')[-2] in done.stderr
            if done.returncode != 2 or not named:
                yield f"{new!r}: the program says {done.stderr.strip()!r}"
    if len(BROKEN) != 44 or len(scenes) < 30:
        yield f"{len(BROKEN)} broken scenes and {len(scenes)} scenes"


if __name__ == "__main__":
    wrong = list(findings(sys.argv[1]))
    print("\n".join(wrong))
    sys.exit(1 if wrong else 0)
