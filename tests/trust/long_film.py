#!/usr/bin/env python3
"""Makes a long film in parts, checks that the joined film is byte-identical, and measures costs: start, parts, join, and the join's
memory.

Prints a table; exit code 1 if a byte differs or the join's memory grows with the film. Takes some minutes, so no test runs it.
Usage: long_film.py POINSOT [--frames N] [--parts N] [--hour]      (36,000 frames at 320×180 in 10 parts; --hour: 108,000, too)
"""
import argparse
import filecmp
import os
import pathlib
import sys
import tempfile
import time

SCENE = """title = "Long"
[body]
moments_kg_m2 = [3.0, 2.0, 1.0]
[start]
omega_rad_s = [0.3, 2.0, 0.1]
[film]
size = [320, 180]
duration_s = 4000.0
"""


class Cost:
    """Wall and CPU seconds of a process, and its peak memory."""

    def __init__(self, *command):
        began = time.monotonic()
        process = os.posix_spawnp(command[0], [str(word) for word in command], os.environ)
        _, status, used = os.wait4(process, 0)
        self.wall_s = time.monotonic() - began
        self.cpu_s = used.ru_utime + used.ru_stime
        self.most_mib = used.ru_maxrss / 1024
        if os.waitstatus_to_exitcode(status) != 0:
            sys.exit(f"exit {os.waitstatus_to_exitcode(status)}: {command}")


def say(what, cost, more=""):
    print(f"{what:44} {cost.wall_s:8.2f} s  {cost.cpu_s:8.2f} s of CPU  {cost.most_mib:6.0f} MiB  {more}", flush=True)


def in_parts(program, scene, folder, n_frames, n_parts):
    """Makes the film in parts, each drawn by its own process, one after the other; returns it with the join's cost."""
    parts, all_s = [], 0.0
    for number in range(1, n_parts + 1):
        parts.append(folder / f"{number}.mp4")
        cost = Cost(program, "render", scene, "-q", "--portable", "--frames", f"0-{n_frames - 1}", "--part",
                    f"{number}/{n_parts}", "-o", parts[-1])
        all_s += cost.cpu_s
    print(f"{n_parts} parts of {n_frames:,} frames{'':18} {all_s:26.2f} s of CPU", flush=True)
    film = folder / f"{n_frames}.mp4"
    joined = Cost(program, "join", "-q", *parts, "-o", film)
    say(f"join of {n_frames:,} frames", joined, f"{film.stat().st_size / 1e6:.1f} MB")
    for part in parts:
        part.unlink()
    return film, joined


def main():
    arguments = argparse.ArgumentParser(description=__doc__)
    arguments.add_argument("program")
    arguments.add_argument("--frames", type=int, default=36000)
    arguments.add_argument("--parts", type=int, default=10)
    arguments.add_argument("--hour", action="store_true")
    chosen = arguments.parse_args()
    program = os.path.realpath(chosen.program)
    n_wrong = 0
    with tempfile.TemporaryDirectory(prefix="poinsot-long-", dir="/tmp") as name:
        folder = pathlib.Path(name)
        scene = folder / "long.toml"
        scene.write_text(SCENE)
        part = folder / "start.mp4"
        say("one frame as a part: what a start takes", Cost(program, "render", scene, "-q", "--portable", "--frames", "0-0",
                                                            "--part", "1/1", "-o", part))
        part.unlink()
        one = folder / "one.mp4"
        say(f"one process, {chosen.frames:,} frames", Cost(program, "render", scene, "-q", "--portable", "--jobs", "1",
                                                           "--frames", f"0-{chosen.frames - 1}", "-o", one))
        _, short = in_parts(program, scene, folder, chosen.frames // 10, chosen.parts)
        film, joined = in_parts(program, scene, folder, chosen.frames, chosen.parts)
        same = filecmp.cmp(one, film, False)
        n_wrong += not same
        print("byte for byte the film of one process" if same else "WRONG: other bytes than one process's", flush=True)
        if chosen.hour:
            _, joined = in_parts(program, scene, folder, 108000, chosen.parts)
        # FFmpeg's index of an MP4 and our index of the parts take some bytes per frame.
        flat = joined.most_mib < short.most_mib + 64
        n_wrong += not flat
        print(f"{'' if flat else 'WRONG: '}the join holds {joined.most_mib - short.most_mib:.0f} MiB more than of a tenth", flush=True)
    return 1 if n_wrong else 0


if __name__ == "__main__":
    sys.exit(main())
