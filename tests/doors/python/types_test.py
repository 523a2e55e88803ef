"""The types: mypy accepts the package and a program that uses it, and finds a wrong use."""
import os
import pathlib
import subprocess
import sys

import pytest

import poinsot

HERE = pathlib.Path(__file__).resolve().parent


@pytest.fixture(scope="module")
def mypy(tmp_path_factory):
    pytest.importorskip("mypy")
    cache = tmp_path_factory.mktemp("mypy")

    def run(*arguments):
        package = pathlib.Path(poinsot.__file__).parents[1]
        done = subprocess.run([sys.executable, "-m", "mypy", "--config-file", HERE / "mypy.ini", "--cache-dir", cache, "--no-error-summary",
                               *arguments], capture_output=True, text=True, env={**os.environ, "MYPYPATH": str(package)})
        return done.stdout.splitlines() + done.stderr.splitlines()

    return run


def test_the_package_is_typed(mypy):
    folder = pathlib.Path(poinsot.__file__).parent
    assert (folder / "py.typed").is_file()
    assert mypy("-p", "poinsot") == []


def test_a_program_is_accepted_but_for_its_wrong_line(mypy):
    program = HERE / "typed_usage.py"
    last = len(program.read_text().splitlines())
    found = mypy(program)
    assert len(found) == 1 and f"typed_usage.py:{last}: error:" in found[0], found
    assert 'Argument "theme" to "still" of "Scene" has incompatible type "int"' in found[0]


def test_the_stub_has_what_the_module_has():
    """Names, and the names of arguments, from the compiled module's signatures."""
    import ast
    import re

    from poinsot import _poinsot

    stub = ast.parse((pathlib.Path(poinsot.__file__).parent / "_poinsot.pyi").read_text())
    public = {name for name in vars(_poinsot) if not name.startswith("_")}
    assert {node.name for node in stub.body if hasattr(node, "name")} == public

    def arguments(function):
        return [one.arg for one in function.args.args if one.arg != "self"]

    def signature(documented):
        text = documented.splitlines()[0]
        return [name for name in re.findall(r"(\w+): ", text) if name != "self"]

    for node in stub.body:
        if isinstance(node, ast.FunctionDef):
            assert arguments(node) == signature(getattr(_poinsot, node.name).__doc__), node.name
        elif isinstance(node, ast.ClassDef):
            native = getattr(_poinsot, node.name)
            methods = {one.name: one for one in node.body if isinstance(one, ast.FunctionDef)}
            has = {name for name in vars(native) if not name.startswith("_")}
            assert {name for name in methods if name != "__init__"} == has, node.name
            for name, method in methods.items():
                if not isinstance(vars(native).get(name), property):
                    assert arguments(method) == signature(getattr(native, name).__doc__), name
