#!/usr/bin/env python3
"""Checks the files that `cmake --install` puts under a prefix, used from another folder as by a user.

Usage: install_check.py CMAKE BUILD_FOLDER
"""
import os
import pathlib
import subprocess
import sys
import tempfile

SOURCE = pathlib.Path(__file__).resolve().parents[2]


def findings(cmake, build):
    with tempfile.TemporaryDirectory() as name:
        prefix, elsewhere = pathlib.Path(name, "prefix"), pathlib.Path(name, "elsewhere")
        elsewhere.mkdir()
        done = subprocess.run([cmake, "--install", build, "--prefix", str(prefix)], capture_output=True, text=True)
        if done.returncode:
            yield f"cmake --install: {done.stderr.strip()}"
            return
        program = prefix / "bin" / "poinsot"

        def run(*words):
            return subprocess.run([program, *words], cwd=elsewhere, capture_output=True, text=True)

        listed = [line.split()[0] for line in run("list", "scenes").stdout.splitlines()]
        there = sorted(path.stem for path in (SOURCE / "scenes").glob("*.toml"))
        if listed != there:
            yield f"list scenes names {len(listed)} scenes, {len(there)} came with the program"
        if (prefix / "share/poinsot/scenes/generic.toml").read_bytes() != (SOURCE / "scenes/generic.toml").read_bytes():
            yield "the installed generic.toml is another"
        done = run("render", "generic", "--size", "64x36", "--frames", "0-1", "-o", "film.mp4")
        if done.returncode or not (elsewhere / "film.mp4").stat().st_size:
            yield f"render generic: {done.stderr.strip()}"
        done = run("check", "genric")
        if done.returncode != 2:
            yield f"a scene that does not exist gives {done.returncode}"
        pages = [line.split()[0] for line in run("list", "documents").stdout.splitlines() if line.startswith("poinsot")]
        wanted = [f"man/man{page[-1]}/{page}.gz" for page in pages] + [
            "bash-completion/completions/poinsot", "fish/vendor_completions.d/poinsot.fish", "poinsot/scenes/scene.schema.json",
            "doc/poinsot/guide.md", "doc/poinsot/copyright"]
        for path in wanted:
            if not (prefix / "share" / path).is_file() or not (prefix / "share" / path).stat().st_size:
                yield f"share/{path} is not there, or empty"

        # If the prefix is not writable, no partial installation is left.
        if os.getuid() != 0:
            locked = pathlib.Path(name, "locked")
            locked.mkdir(mode=0o500)
            done = subprocess.run([cmake, "--install", build, "--prefix", str(locked)], capture_output=True, text=True)
            if done.returncode == 0 or any(locked.iterdir()):
                yield "an install folder that cannot be written is not refused"


if __name__ == "__main__":
    wrong = list(findings(*sys.argv[1:]))
    print("\n".join(wrong))
    sys.exit(1 if wrong else 0)
