"""What the tests of the Python package share.

They run with the package on the path and, for the comparisons with the program, with POINSOT=program.
"""
import os
import pathlib
import subprocess
import sys

import pytest

ROOT = pathlib.Path(__file__).resolve().parents[3]
SCENES = ROOT / "scenes"

pytest_plugins = ["pytester"]


@pytest.fixture(scope="session")
def program():
    """Runs the program: program("sample", …) returns its standard output as bytes."""
    path = os.environ.get("POINSOT")
    if not path:
        pytest.skip("POINSOT does not name the program")

    def run(*arguments):
        done = subprocess.run([path, *map(str, arguments)], capture_output=True, timeout=600)
        assert done.returncode == 0, done.stderr.decode()
        return done.stdout

    return run


@pytest.fixture
def in_process(tmp_path):
    """Runs a Python program in a process of its own: a hang or a crash of it fails the test."""

    def run(source, *arguments, timeout_s=300.0, exit_code=0):
        file = tmp_path / "program.py"
        file.write_text(source)
        done = subprocess.run([sys.executable, str(file), *map(str, arguments)], capture_output=True, text=True,
                              cwd=tmp_path, timeout=timeout_s)
        assert done.returncode == exit_code, f"exit code {done.returncode}\n{done.stdout}\n{done.stderr}"
        return done.stdout

    return run
