#!/usr/bin/env python3
"""Finds the settings of x264 that suit drawings: CPU time against size at equal quality.

    tests/bench/x264_search.py [--build build/release] [--frames 60] [--plot x264.png]

Each setting encodes the same frames at several crf; size and CPU are interpolated to the SSIM of the preset medium at crf 18.
Prints the table, the cheapest first; `front` marks the Pareto front. Needs ffmpeg with libx264; the plot needs python3-matplotlib.
"""
import argparse
import math
import os
import pathlib
import re
import subprocess
import tempfile

ROOT = pathlib.Path(__file__).resolve().parents[2]
FLAT = "psy=0:aq-mode=1"  # there is no grain to preserve
SETTINGS = [("veryfast", ""), ("faster", ""), ("fast", ""), ("medium", ""), ("slow", ""),
            ("superfast", FLAT + ":trellis=1"), ("veryfast", FLAT + ":trellis=1"), ("veryfast", "psy=0:aq-mode=2:trellis=1"),
            ("veryfast", FLAT + ":trellis=1:subme=6:rc-lookahead=30"), ("faster", FLAT + ":trellis=1"), ("fast", FLAT),
            ("fast", FLAT + ":rc-lookahead=20"), ("fast", FLAT + ":ref=1:rc-lookahead=20"), ("fast", FLAT + ":subme=5"),
            ("medium", FLAT + ":rc-lookahead=20"), ("medium", "psy=0:aq-mode=2:rc-lookahead=20"),
            ("slow", FLAT + ":rc-lookahead=20")]
CRFS = [16, 18, 20]


def cpu_of(command):
    before = os.times()
    subprocess.run(command, check=True, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
    after = os.times()
    return after.children_user + after.children_system - before.children_user - before.children_system


def ssim_of(film, reference):
    run = subprocess.run(["ffmpeg", "-hide_banner", "-i", film, "-i", reference, "-lavfi", "ssim", "-f", "null", "-"],
                         check=True, capture_output=True, text=True)
    return float(re.findall(r"SSIM .*All:([\d.]+)", run.stderr)[-1])


def at_likeness(points, loss_db):
    """CPU and size at this SSIM, interpolated between the two neighbouring points (linear in dB and log size)."""
    points = sorted(points)
    for low, high in zip(points, points[1:]):
        if low[0] <= loss_db <= high[0]:
            t = (loss_db - low[0]) / (high[0] - low[0])
            return (low[1] + t * (high[1] - low[1]),
                    math.exp(math.log(low[2]) + t * (math.log(high[2]) - math.log(low[2]))))
    return None


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--build", type=pathlib.Path, default=ROOT / "build" / "release")
    parser.add_argument("--scene", default=ROOT / "scenes" / "generic.toml")
    parser.add_argument("--frames", type=int, default=60)
    parser.add_argument("--size", default="1920x1080")
    parser.add_argument("--plot")
    options = parser.parse_args()
    with tempfile.TemporaryDirectory(prefix="poinsot-x264-") as folder:
        folder = pathlib.Path(folder)
        subprocess.run([options.build / "poinsot", "render", options.scene, "--size", options.size, "--frames",
                        f"0-{options.frames - 1}", "-q", "-o", folder / "####.png"], check=True)
        reference = folder / "frames.y4m"
        subprocess.run(["ffmpeg", "-loglevel", "error", "-i", folder / "%04d.png", "-pix_fmt", "yuv420p", reference],
                       check=True)
        reading = cpu_of(["ffmpeg", "-i", reference, "-f", "null", "-"])
        rows = []
        for preset, x264 in SETTINGS:
            points = []
            for crf in CRFS:
                film = folder / "film.mp4"
                cpu = cpu_of(["ffmpeg", "-y", "-i", reference, "-c:v", "libx264", "-preset", preset, "-crf", str(crf),
                              "-threads", "3", *(["-x264-params", x264] if x264 else []), film]) - reading
                loss_db = -10 * math.log10(1 - ssim_of(film, reference))
                points.append((loss_db, 1e3 * cpu / options.frames, film.stat().st_size / options.frames))
            rows.append((f"{preset} {x264}".strip(), points))
    medium = next(points for name, points in rows if name == "medium")
    target = medium[CRFS.index(18)][0]
    taken = [(name, at_likeness(points, target)) for name, points in rows]
    medium_cpu, medium_size = next(place for name, place in taken if name == "medium")
    taken = sorted((place[0] / medium_cpu, place[1] / medium_size, name) for name, place in taken if place)
    print(f"at medium's SSIM at crf 18, {1 - 10 ** (-target / 10):.5f}; medium takes {medium_cpu:.1f} ms and "
          f"{medium_size / 1e3:.1f} kB a frame\n\n| setting | CPU over medium's | size over medium's | front |\n|---|---|---|---|")
    front = [row for row in taken if not any(o[:2] != row[:2] and o[0] <= row[0] and o[1] <= row[1]
                                           for o in taken)]
    for row in taken:
        print(f"| `{row[2]}` | {row[0]:.2f} | {row[1]:.2f} | {'•' if row in front else ''} |")
    if options.plot:
        import matplotlib
        matplotlib.use("Agg")
        from matplotlib import pyplot
        figure, axes = pyplot.subplots(figsize=(8, 4.5), dpi=100)
        axes.plot([row[0] for row in front], [row[1] for row in front], "-", color="0.7", zorder=1)
        for cpu, size, name in taken:
            stock = " " not in name
            axes.plot(cpu, size, "o", color="tab:blue" if stock else "tab:orange", zorder=2)
            axes.annotate(name.replace(FLAT, "flat"), (cpu, size), fontsize=7, xytext=(4, 3), textcoords="offset points")
        axes.set(xlabel="CPU time over medium's", ylabel="size over medium's", xlim=(0, 1.6),
                 title=f"x264 at one SSIM ({1 - 10 ** (-target / 10):.4f}), {pathlib.Path(options.scene).stem}, {options.size}\n"
                       "blue: presets as they are; orange: for drawings (flat: psy=0:aq-mode=1)")
        axes.grid(alpha=0.3)
        figure.tight_layout()
        figure.savefig(options.plot)


if __name__ == "__main__":
    main()
