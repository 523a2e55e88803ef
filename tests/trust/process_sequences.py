#!/usr/bin/env python3
"""Tests sequences of {run, kill, rerun, change a setting, disk full, freed} on one output, each step in its own process.

After every step, either no file has the output's name or it is byte-identical to that of an uninterrupted run with one of its
settings; after the last, undisturbed run it is that of an uninterrupted run, and no other files are left.
tests/trust/output_sequences.cpp tests far more sequences in one process. Random choices follow from the seed, separately for each
sequence; moments of kills depend on the machine's clock; with strace, every second kill is at a given system call.
Usage: process_sequences.py POINSOT QUOTA.so [--seed N] [--sequences N] [--kind NAME] [--only K]
"""
import argparse
import hashlib
import os
import pathlib
import random
import shutil
import subprocess
import sys
import tempfile
import time

SCENE = """title = "Sequences"
[body]
moments_kg_m2 = [3.0, 2.0, 1.0]
[start]
omega_rad_s = [0.01, 2.0, 0.01]
[film]
size = "96x54"
duration_s = 60.0
"""
# Name of the output → the arguments that make it.
KINDS = {
    "a.png": ["still", "--time", "1"],
    "a_####.png": ["render", "--frames", "0-7"],
    "a.mp4": ["render", "--frames", "0-139"],
    "a.webm": ["render", "--frames", "0-7"],
    "a.mov": ["render", "--frames", "0-7"],
    "a.gif": ["render", "--frames", "0-11"],
}
SETTINGS = [[], ["--set", "start.omega_rad_s=[0.02, 2.0, 0.01]"]]
STEPS = ["run", "kill", "kill", "kill", "change", "full", "full", "call"]


def contents(place, hidden=True):
    return {p.name: hashlib.sha256(p.read_bytes()).hexdigest() for p in sorted(place.iterdir())
            if hidden or not p.name.startswith(".")}


class Sequences:
    def __init__(self, program, quota, folder, seed):
        self.program, self.quota, self.folder, self.seed = program, quota, folder, seed
        self.scene = folder / "scene.toml"
        self.scene.write_text(SCENE)
        # Mesa's shader cache: filled by undisturbed runs; the others do not write to it.
        os.environ["MESA_SHADER_CACHE_DIR"] = str(folder / "shaders")
        # And no threads in Mesa, which would delay small pictures.
        os.environ["LP_NUM_THREADS"] = "0"
        self.has_strace = shutil.which("strace") is not None
        self.n_steps = 0

    def command(self, name, place, setting):
        command, *options = KINDS[name]
        return [self.program, command, str(self.scene), *options, *SETTINGS[setting], "--portable", "-q", "-o", str(place / name)]

    def run(self, command, *, kill_after=None, quota=None, place=None, call=None):
        environment = dict(os.environ)
        if quota is not None:
            environment.update(LD_PRELOAD=self.quota, POINSOT_QUOTA=str(quota), POINSOT_QUOTA_FOLDER=str(place))
        if call is not None:
            name, n = call
            command = ["strace", "--seccomp-bpf", "-f", "-qq", "-o", "/dev/null", "-e", f"inject={name}:signal=KILL:when={n}", *command]
        process = subprocess.Popen(command, stdout=subprocess.DEVNULL, stderr=subprocess.PIPE, env=environment)
        try:
            _, said = process.communicate(timeout=kill_after if kill_after is not None else 300)
        except subprocess.TimeoutExpired:
            process.kill()
            _, said = process.communicate()
        self.n_steps += 1
        return process.returncode, said.decode(errors="replace").strip()

    def right_files(self, name):
        files, took = [], 0.0
        for setting in range(len(SETTINGS)):
            place = pathlib.Path(tempfile.mkdtemp(dir=self.folder))
            began = time.monotonic()
            subprocess.run(self.command(name, place, setting), check=True)
            took = time.monotonic() - began
            files.append(contents(place))
            self.n_bytes = sum(p.stat().st_size for p in place.iterdir())
        return files, took

    def make(self, name, number, right, took):
        """Returns a description of the failure, or an empty string."""
        dice = random.Random(f"{self.seed}:{name}:{number}")
        place = pathlib.Path(tempfile.mkdtemp(dir=self.folder))
        setting, used, told = dice.randrange(2), set(), []
        for _ in range(dice.randint(2, 5)):
            step = dice.choice(STEPS)
            if step == "call" and not self.has_strace:
                step = "kill"
            told.append(step)
            if step == "change":
                setting = 1 - setting
                continue
            used.add(setting)
            command = self.command(name, place, setting)
            if step == "run":
                code, said = self.run(command)
                if code != 0 or contents(place) != right[setting]:
                    return f"{told}: exit {code}, {said[-200:]!r}, left {sorted(contents(place))}"
            elif step == "kill":
                self.run(command, kill_after=dice.uniform(0.3, 1.1) * took)
            elif step == "call":
                self.run(command, call=(dice.choice(["rename", "fsync", "write", "unlink", "ftruncate"]), dice.randint(1, 6)))
            else:
                code, said = self.run(command, quota=dice.randint(0, int(1.2 * self.n_bytes)), place=place)
                if code not in (0, 3) or said.count("\n") > 0:
                    return f"{told}: exit {code}, {said[-200:]!r}"
            for file, found in contents(place, hidden=False).items():
                if all(right[s].get(file) != found for s in used):
                    return f"{told}: {file} is there and no run's"
        code, said = self.run(self.command(name, place, setting))
        found = contents(place)
        shutil.rmtree(place)
        if code != 0 or found != right[setting]:
            return f"{told}, last run: exit {code}, {said[-200:]!r}, left {sorted(found)}"
        return ""


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("program")
    parser.add_argument("quota")
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--sequences", type=int, default=50)
    parser.add_argument("--kind", choices=list(KINDS))
    parser.add_argument("--only", type=int)
    args = parser.parse_args()
    n_wrong = 0
    with tempfile.TemporaryDirectory() as folder:
        sequences = Sequences(os.path.abspath(args.program), os.path.abspath(args.quota), pathlib.Path(folder), args.seed)
        for name in [args.kind] if args.kind else KINDS:
            right, took = sequences.right_files(name)
            began, before, n_kind = time.monotonic(), sequences.n_steps, 0
            numbers = [args.only] if args.only is not None else range(args.sequences)
            for number in numbers:
                wrong = sequences.make(name, number, right, took)
                if wrong:
                    n_kind += 1
                    print(f"WRONG {wrong} --seed {args.seed} --kind {name} --only {number}", flush=True)
            n_wrong += n_kind
            print(f"{name:11} {len(numbers):4} sequences, {sequences.n_steps - before} processes, {n_kind} wrong, "
                  f"{time.monotonic() - began:.0f} s", flush=True)
    return 1 if n_wrong else 0


if __name__ == "__main__":
    sys.exit(main())
