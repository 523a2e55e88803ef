#!/usr/bin/env python3
"""Compares poinsot with other tools that make the same kind of film: ratios of wall time, CPU time and memory.

    tests/bench/peers_bench.py PEERS_FOLDER [--build build/release] [--frames 60] [--presets medium,veryfast]

PEERS_FOLDER contains mktraj.py and peer_NAME.py, each of which draws the motion of scenes/generic.toml's body (ellipsoid, plane,
both curves, arrows, text) and encodes it with x264 at crf 18. All peers that are installed are run; poinsot makes its film of the
default scene with the same size, number of frames, preset and crf. --quick omits the preset medium and draws 20 frames, at most a
minute per peer. Not part of CI.
"""
import argparse
import datetime
import json
import os
import pathlib
import re
import subprocess
import tempfile

ROOT = pathlib.Path(__file__).resolve().parents[2]
# Name in the table, script, environment, number of frames (fewer for a slow peer).
PEERS = [("VTK, 4× MSAA", "peer_vtk.py", {"MSAA": "4"}, 1.0),
         ("VTK, no MSAA", "peer_vtk.py", {"MSAA": "0"}, 1.0),
         ("MuJoCo, 4× MSAA", "peer_mujoco.py", {"MSAA": "4"}, 1.0),
         ("matplotlib, 64×128 mesh", "peer_matplotlib.py", {"MESH": "128x64"}, 0.5),
         ("gnuplot", "peer_gnuplot.py", {}, 0.5),
         ("POV-Ray", "peer_povray.py", {}, 0.1)]
REPORT = re.compile(r"frames=(\d+) .*?fps=([\d.]+) .*?cpu_self=([\d.]+) cpu_children=([\d.]+) .*?peak_self=(\d+)MiB "
                    r"peak_child=(\d+)MiB")


def peer(folder, script, environment, arguments, limit_s):
    """Frames per second, CPU ms per frame and MiB of one peer; None with the reason if it cannot run here."""
    try:
        run = subprocess.run(["/usr/bin/python3", folder / script, *map(str, arguments)], capture_output=True, text=True,
                             env={**os.environ, **environment}, timeout=limit_s)
    except (OSError, subprocess.TimeoutExpired) as error:
        return None, type(error).__name__
    found = REPORT.search(run.stdout)
    if not found:
        return None, (run.stderr.strip().splitlines() or ["it printed no report"])[-1][:80]
    _, fps, own, children, peak, peak_child = map(float, found.groups())
    return {"fps": fps, "cpu_ms": 1e3 * (own + children), "mib": peak + peak_child}, ""


def poinsot(build, size, settings, n_frames):
    out = subprocess.run([build / "tests/bench/film_phases", "film", ROOT / "scenes/generic.toml", size, settings,
                          str(n_frames)], check=True, capture_output=True, text=True).stdout
    run = json.loads(out)
    return {"fps": n_frames / run["wall_s"], "cpu_ms": 1e3 * run["cpu_s"] / n_frames, "mib": run["peak_mib"]}


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("folder", type=pathlib.Path)
    parser.add_argument("--build", type=pathlib.Path, default=ROOT / "build" / "release")
    parser.add_argument("--frames", type=int, default=60)
    parser.add_argument("--size", default="1920x1080")
    parser.add_argument("--presets", default="medium,veryfast")
    parser.add_argument("--limit-s", type=float, default=300, help="seconds that one peer may take")
    parser.add_argument("--quick", action="store_true", help="20 frames, preset veryfast alone, 60 s a peer at most")
    options = parser.parse_args()
    if options.quick:
        options.frames, options.presets, options.limit_s = 20, "veryfast", 60
    print(f"{datetime.date.today()}, {os.cpu_count()} processors, load {os.getloadavg()[0]:.1f}; {options.size}, x264 crf 18")
    with tempfile.TemporaryDirectory(prefix="poinsot-peers-") as scratch:
        csv = pathlib.Path(scratch) / "motion.csv"
        subprocess.run(["/usr/bin/python3", options.folder / "mktraj.py", csv], check=True, stdout=subprocess.DEVNULL)
        width, height = options.size.split("x")
        for preset in options.presets.split(","):
            ours = poinsot(options.build, options.size, preset, options.frames)
            print(f"\n| preset {preset} | frames/s | CPU, ms a frame | MiB | poinsot: times as fast | CPU over ours | "
                  "memory, ours over theirs |\n|" + "---|" * 7)
            print(f"| poinsot | {ours['fps']:.1f} | {ours['cpu_ms']:.0f} | {ours['mib']:.0f} | | | |")
            for name, script, environment, share in PEERS:
                n = max(4, round(share * options.frames))
                row, why = peer(options.folder, script, environment,
                                ["--csv", csv, "--frames", n, "--width", width, "--height", height, "--out",
                                 pathlib.Path(scratch) / "peer.mp4", "--preset", preset], options.limit_s)
                if row is None:
                    print(f"| {name} | not run: {why} | | | | | |", flush=True)
                    continue
                print(f"| {name} | {row['fps']:.2f} | {row['cpu_ms']:.0f} | {row['mib']:.0f} | {ours['fps'] / row['fps']:.1f} "
                      f"| {row['cpu_ms'] / ours['cpu_ms']:.1f} | {ours['mib'] / row['mib']:.2f} |", flush=True)


if __name__ == "__main__":
    main()
