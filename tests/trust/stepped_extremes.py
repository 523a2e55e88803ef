#!/usr/bin/env python3
"""Random scenes of stepped motions, magnitudes from 1e-300 to 1e300: none keeps silent.

Each is given to `check`, which must end, refuse in one line, or say what it does before it has used three seconds of processor time
(none of which another load of the machine lengthens); one that goes on must then end at once on SIGINT. The first scenes are those that
once stepped for minutes without a word.
Usage: stepped_extremes.py POINSOT [--seed N] [--scenes N] [--only K]
"""
import argparse
import os
import pathlib
import random
import select
import signal
import subprocess
import sys
import tempfile
import time

ANY = ["euler", "rk4", "dopri5", "rkmk4"]
TORQUES = {"none": ANY + ["midpoint", "splitting", "dmv"], "gravity": ANY + ["splitting"], "constant_body": ANY, "constant_space": ANY,
           "dissipation": ANY, "half_life": ANY, "drag": ANY}
MOST_S = 1e5  # a film has 10,000,000 frames at most
SILENT_S = 3.0
DEADLINE_S = 120.0  # of wall-clock time, for a machine that does nothing but others' work


def scene(moments, omega, torque, method, duration=20.0, start=0.0, extra=""):
    return (f"[body]\nmoments_kg_m2 = {moments}\n[start]\nomega_rad_s = {omega}\n"
            f"[torque]\n{torque}\n[motion]\nmethod = \"{method}\"\n{extra}"
            f"[film]\nduration_s = {duration!r}\nstart_s = {start!r}\n")


def friction(key, value):
    return f"kind = \"dissipation\"\n{key} = {value!r}"


KNOWN = [
    scene([3.0, 2.0, 1.5], [1e20, 1e20, 1e20], 'kind = "none"', "dopri5"),
    scene([3.0, 2.0, 1.5], [1e150, 1e150, 1e150], friction("rate_1_s", 0.1), "dopri5"),
    scene([3.0, 2.0, 1.5], [0.1, 2.0, 0.1], friction("half_life_s", 5e-324), "dopri5"),
    scene([2.0, 2.0, 1.0], [1e-9, 3.0, 1e-9], friction("half_life_s", 8.0), "dopri5"),
    scene([1.0, 1.0, 1.0000000000000002], [1.0, 0.5, 0.3], friction("half_life_s", 8.0), "rk4"),
    scene([3.0, 2.0, 1.5], [0.1, 2.0, 0.1], friction("rate_1_s", 1e300), "dopri5"),
    scene([3.0, 2.0, 1.5], [0.1, 2.0, 0.1], friction("rate_1_s", 1e6), "rkmk4"),
    scene([3.0, 2.0, 1.5], [1.0, 200.0, 1.0], 'kind = "none"', "dmv", 7200.0),
    scene([3.0, 2.0, 1.5], [1.0, 2.0, 1.0], 'kind = "drag"\nlinear_1_s = [100.0, 90.0, 80.0]', "dopri5", 100.0),
    scene([3.0, 2.0, 1.5], [1.0, 2.0, 1.0], 'kind = "drag"\nlinear_1_s = [1e300, 1.0, 0.0]', "dopri5"),
    scene([3.0, 2.0, 1.5], [1.0, 2.0, 1.0], 'kind = "drag"\nquadratic_1_rad = [1.0, 1.0, 0.0]', "dopri5", 20.0, -30.0),
    scene([3.0, 2.0, 1.5], [1.0, 2.0, 1.0], 'kind = "drag"\nlinear_1_s = [1.0, 1.0, 0.0]\ngrowth_1_s = 700.0', "rk4", 1.0),
]


def magnitude(chance):
    """Often everyday, often extreme, seldom 0."""
    kind = chance.random()
    if kind < 0.05:
        return 0.0
    exponent = chance.uniform(-1, 1) if kind < 0.5 else chance.uniform(-12, 12) if kind < 0.75 else chance.uniform(-300, 300)
    return chance.choice([-1.0, 1.0]) * 10.0 ** exponent


def random_scene(chance):
    unit = abs(magnitude(chance)) or 1.0
    a, b, c = (chance.random() + 1e-3 for _ in range(3))
    near = chance.random()
    if near < 0.2:
        b = a
    elif near < 0.3:
        b, c = a * (1 + 1e-15), a * (1 - 1e-15)
    moments = [(b + c) * unit, (c + a) * unit, (a + b) * unit]
    omega = [magnitude(chance) for _ in range(3)]
    if chance.random() < 0.3:
        omega = [omega[0] * 1e-9, omega[1] or 1.0, omega[1] * 1e-9]
    kind = chance.choice(sorted(TORQUES))
    size = abs(magnitude(chance)) or 1.0
    vector = [magnitude(chance) for _ in range(3)]
    torque = {"none": 'kind = "none"',
              "gravity": f'kind = "gravity"\nmgl_N_m = {size!r}\narm_body = [0.1, 0.2, 1.0]',
              "constant_body": f'kind = "constant_body"\ntorque_body_N_m = {vector}',
              "constant_space": f'kind = "constant_space"\ntorque_space_N_m = {vector}',
              "dissipation": friction("rate_1_s", size),
              "half_life": friction("half_life_s", size),
              "drag": f'kind = "drag"\nlinear_1_s = {[abs(x) for x in vector]}\nquadratic_1_rad = {[size, 0.0, abs(vector[0])]}\n'
                      f'growth_1_s = {vector[2]!r}'}[kind]
    method = chance.choice(TORQUES[kind])
    extra = ""
    if chance.random() < 0.2:
        extra = f"tolerance = {10.0 ** chance.uniform(-14, -1)!r}\n" if method == "dopri5" else \
                f"step_s = {10.0 ** chance.uniform(-12, 0)!r}\n"
    return scene(moments, omega, torque, method, min(abs(magnitude(chance)) or 10.0, MOST_S), 0.0, extra)


def processor_s(pid):
    try:
        fields = pathlib.Path(f"/proc/{pid}/stat").read_text().rsplit(")", 1)[1].split()
    except (FileNotFoundError, ProcessLookupError):
        return 0.0
    return (int(fields[11]) + int(fields[12])) / os.sysconf("SC_CLK_TCK")


def tried(poinsot, text, folder):
    """(what is wrong or "", what came of it)."""
    file = pathlib.Path(folder) / "s.toml"
    file.write_text(text)
    began = time.monotonic()
    run = subprocess.Popen([poinsot, "check", str(file)], stdout=subprocess.PIPE, stderr=subprocess.STDOUT, cwd=folder)
    try:
        said = b""
        while not said and run.poll() is None:
            if select.select([run.stdout], [], [], 0.02)[0]:
                said = os.read(run.stdout.fileno(), 4096)
                if not said:
                    break
            if processor_s(run.pid) > SILENT_S or time.monotonic() - began > DEADLINE_S:
                return "silent", "silent"
        if b"stepping the motion" in said and run.poll() is None:
            before = processor_s(run.pid)
            run.send_signal(signal.SIGINT)
            while run.poll() is None:
                if processor_s(run.pid) > before + 1.0 or time.monotonic() - began > DEADLINE_S:
                    return "goes on after SIGINT", "goes on"
                time.sleep(0.005)
            return "", "told and ended"
        said += run.communicate(timeout=DEADLINE_S)[0]
        if run.returncode in (0, 1):
            return "", "checked"
        lines = said.decode("utf-8", "replace").strip().splitlines()
        refusals = [line for line in lines if "note:" not in line]
        if run.returncode != 2 or len(refusals) != 1 or "s.toml:" not in refusals[0]:
            return f"exit {run.returncode}: {said!r}", "wrong"
        return "", "refused"
    finally:
        if run.poll() is None:
            run.kill()
        run.wait()


def main():
    asked = argparse.ArgumentParser()
    asked.add_argument("poinsot")
    asked.add_argument("--seed", type=int, default=33)
    asked.add_argument("--scenes", type=int, default=250)
    asked.add_argument("--only", type=int)
    asked = asked.parse_args()
    counts, wrong = {}, 0
    with tempfile.TemporaryDirectory() as folder:
        for k in range(asked.scenes):
            if asked.only is not None and k != asked.only:
                continue
            text = KNOWN[k] if k < len(KNOWN) else random_scene(random.Random(f"{asked.seed} {k}"))
            problem, outcome = tried(asked.poinsot, text, folder)
            counts[outcome] = counts.get(outcome, 0) + 1
            if problem:
                wrong += 1
                print(f"scene {k}: {problem}\n{text}", flush=True)
    print(", ".join(f"{n} {outcome}" for outcome, n in sorted(counts.items())))
    sys.exit(1 if wrong else 0)


main()
