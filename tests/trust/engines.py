#!/usr/bin/env python3
"""Checks docs/guide.md's examples for GNU parallel, Snakemake and a GitHub matrix: its unchanged lines, run on a small film, make a
file that is byte-identical to that of a single run.

A matrix is run in GitHub's order, a job for each value and then the job that needs them, but locally and without GitHub's actions.
Prints a table; exit code 1 on any failure, 77 (skipped) if parallel or snakemake is missing.
Usage: engines.py POINSOT GUIDE
"""
import filecmp
import os
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile
import time

SCENE = """title = "Elsewhere"
[body]
moments_kg_m2 = [3.0, 2.0, 1.0]
[start]
omega_rad_s = [0.3, 2.0, 0.1]
[film]
size = [96, 54]
duration_s = 16.0
"""


class Trial:
    def __init__(self, program, guide):
        self.program, self.n_wrong = program, 0
        section = guide.read_text().split("**Other workflow tools**")[1].split("\n## ")[0]
        self.blocks = dict(re.findall(r"```(sh|python|yaml)\n(.*?)```", section, re.S))

    def place(self, folder):
        """A folder that the guide's lines expect: with the scene, and the program in PATH."""
        (folder / "scenes").mkdir(parents=True)
        (folder / "scenes" / "generic.toml").write_text(SCENE)
        (folder / "bin").mkdir()
        (folder / "bin" / "poinsot").symlink_to(self.program)
        return folder

    def run(self, folder, *command):
        environment = dict(os.environ, PATH=f"{folder / 'bin'}:{os.environ['PATH']}", HOME=str(folder))
        done = subprocess.run(command, cwd=folder, env=environment, capture_output=True, text=True, timeout=240)
        if done.returncode != 0:
            print(f"  exit {done.returncode}: {' '.join(command)[:200]}\n{done.stderr[-1500:]}")
        return done.returncode == 0

    def judge(self, what, folder, done, began):
        right = done and filecmp.cmp(self.one, folder / "film.mp4", False)
        self.n_wrong += not right
        print(f"{what:34} {time.monotonic() - began:5.1f} s  {'the bytes of one run' if right else 'WRONG'}", flush=True)

    def parallel(self, folder):
        began = time.monotonic()
        lines = self.blocks["sh"]
        submission, parts = lines.split("parallel poinsot", 1)
        self.judge("parallel, tasks of a submission", folder, self.run(folder, "bash", "-e", "-c", submission), began)
        (folder / "film.mp4").unlink(missing_ok=True)
        began = time.monotonic()
        self.judge("parallel, parts", folder, self.run(folder, "bash", "-e", "-c", "parallel poinsot" + parts), began)

    def snakemake(self, folder):
        began = time.monotonic()
        (folder / "Snakefile").write_text(self.blocks["python"])
        self.judge("Snakemake", folder, self.run(folder, "snakemake", "-q", "-j2"), began)

    def matrix(self, folder):
        """Each step's commands, with the matrix's values inserted; artifacts are files in the folder itself."""
        began = time.monotonic()
        jobs, done = self.blocks["yaml"].split("  film:"), True
        values = re.search(r"matrix: \{k: \[([\d, ]+)\]\}", jobs[0]).group(1).split(", ")
        command = re.search(r"- run: (.*)", jobs[0]).group(1)
        for value in values:
            done = self.run(folder, "bash", "-e", "-c", command.replace("${{ matrix.k }}", value)) and done
        done = self.run(folder, "bash", "-e", "-c", re.search(r"- run: (.*)", jobs[1]).group(1)) and done
        self.judge("GitHub's matrix", folder, done, began)


def main():
    missing = [name for name in ("parallel", "snakemake") if shutil.which(name) is None]
    if missing:
        print(f"{', '.join(missing)}: not installed (Debian: parallel snakemake)")
        return 77
    trial = Trial(os.path.realpath(sys.argv[1]), pathlib.Path(sys.argv[2]))
    with tempfile.TemporaryDirectory(prefix="poinsot-engines-", dir="/tmp") as name:
        folder = pathlib.Path(name)
        here = trial.place(folder / "one")
        trial.one = here / "one.mp4"
        if not trial.run(here, "poinsot", "render", "scenes/generic.toml", "-q", "--portable", "-o", "one.mp4"):
            return 1
        for engine in ("parallel", "snakemake", "matrix"):
            getattr(trial, engine)(trial.place(folder / engine))
    return 1 if trial.n_wrong else 0


if __name__ == "__main__":
    sys.exit(main())
