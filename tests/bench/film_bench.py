#!/usr/bin/env python3
"""Measures all costs of making films, in one table and one plot.

    tests/bench/film_bench.py [--build build/release] [--scene scenes/generic.toml] [--quick]
                              [--plot films.png] [--json films.json]

Prints Markdown. CPU time includes all threads; every number is the median of --repeat runs. --quick takes a few minutes on two idle
cores: it omits the repetitions and three quarters of each film's frames, and draws 600 frames instead of the film of 3,000. Build
the targets poinsot, film_phases and bench_picture first. The plot needs python3-matplotlib.
"""
import argparse
import datetime
import json
import os
import pathlib
import resource
import shutil
import statistics
import subprocess
import sys
import tempfile
import time

ROOT = pathlib.Path(__file__).resolve().parents[2]
ELEMENTS = ["plane", "ellipsoid", "polhode", "herpolhode", "momentum", "omega", "axes", "contact", "title", "caption",
            "clock"]
SIZES = ["1280x720", "1920x1080", "3840x2160"]
QUALITIES = ["draft", "lecture", "print", "reference"]


class Failed(Exception):
    """A process failed; contains the end of its output."""


class Run:
    """A completed process: wall and CPU seconds, peak memory in MiB, its output."""

    def __init__(self, command, **environment):
        before = time.perf_counter()
        child = subprocess.Popen([str(c) for c in command], stdout=subprocess.PIPE, stderr=subprocess.STDOUT,
                                 env={**os.environ, **environment})
        self.out = child.stdout.read().decode()
        _, status, usage = os.wait4(child.pid, 0)
        child.returncode = os.waitstatus_to_exitcode(status)
        if child.returncode != 0:
            raise Failed((self.out.strip().splitlines() or [f"{command[0]} ended with {child.returncode}"])[-1])
        self.wall_s = time.perf_counter() - before
        self.cpu_s = usage.ru_utime + usage.ru_stime
        self.peak_mib = usage.ru_maxrss / 1024


class Bench:
    def __init__(self, options):
        self.options = options
        self.build = pathlib.Path(options.build)
        self.poinsot = self.build / "poinsot"
        self.tools = self.build / "tests" / "bench"
        self.scratch = pathlib.Path(tempfile.mkdtemp(prefix="poinsot-bench-"))
        self.found = {}

    def median(self, values):
        return statistics.median(values)

    def phase(self, phase, size, settings, n_frames):
        """CPU and wall ms per frame, and memory, of one phase of film_phases."""
        runs = [json.loads(Run([self.tools / "film_phases", phase, self.options.scene, size, settings, n_frames]).out)
                for _ in range(self.options.repeat)]
        row = {key: self.median([run[key] for run in runs]) for key in
               ("wall_s", "cpu_s", "resident_before_mib", "peak_mib", "bytes")}
        return {"cpu_ms": 1e3 * row["cpu_s"] / n_frames, "wall_ms": 1e3 * row["wall_s"] / n_frames,
                "grown_mib": row["peak_mib"] - row["resident_before_mib"], "peak_mib": row["peak_mib"],
                "kB": row["bytes"] / n_frames / 1e3}

    def n_frames(self, size, settings):
        few = {"print": 4, "reference": 10}.get(settings, 1) * {"3840x2160": 4}.get(size, 1)
        return max(6, self.options.frames // few)

    # Each function below prints one section and stores its numbers in `found`.

    def parts(self):
        least = "0.2" if self.options.quick else "1"
        out = Run([self.tools / "bench_picture", "--benchmark_format=json", f"--benchmark_min_time={least}"]).out
        rows = {b["name"].removesuffix("/process_time"): b for b in json.loads(out)["benchmarks"]}
        cpu = {name: row["cpu_time"] for name, row in rows.items()}
        self.found["parts"] = cpu
        print("\n### CPU of a frame, ms\n\n| whole | " + " | ".join(ELEMENTS) + " |")
        print("|---|" + "---|" * len(ELEMENTS))
        print(f"| {cpu['draw/all']:.1f} | " +
              " | ".join(f"{cpu['draw/all'] - cpu['draw/without_' + e]:.1f}" for e in ELEMENTS) + " |")
        for title, prefix in (("stage", "stage/"), ("size", "pixels/"), ("accuracy_px of the curves", "points/accuracy_px_"),
                              ("frame of a film of an hour", "history/frame_"), ("panels", "panels/")):
            names = [name for name in cpu if name.startswith(prefix)]
            print(f"\n| {title} | " + " | ".join(name.removeprefix(prefix) for name in names) + " |")
            print("|---|" + "---|" * len(names))
            print("| ms | " + " | ".join(f"{cpu[name]:.2f}" for name in names) + " |")

    def first_picture(self):
        def still(cache):
            return Run([self.poinsot, "still", self.options.scene, "--size", "1920x1080", "-q", "-o",
                        self.scratch / "still.png"], MESA_SHADER_CACHE_DIR=str(cache))
        warm_cache = self.scratch / "warm"
        still(warm_cache)
        warm = [still(warm_cache) for _ in range(5)]
        cold = [still(self.scratch / f"cold{k}") for k in range(5)]
        print("\n### `still` at 1920×1080, the whole process\n\n| shader cache | wall, s | CPU, s |\n|---|---|---|")
        for name, runs in (("warm", warm), ("cold", cold)):
            wall, cpu = (self.median([getattr(run, key) for run in runs]) for key in ("wall_s", "cpu_s"))
            self.found[f"still_{name}"] = {"wall_s": wall, "cpu_s": cpu}
            print(f"| {name} | {wall:.3f} | {cpu:.3f} |")

    def folder(self):
        names = [s for s in sorted((ROOT / "scenes").glob("*.toml")) if "heavy" not in s.name]
        scenes = [names[k % len(names)] for k in range(120)]
        (self.scratch / "folder").mkdir()
        run = Run([self.poinsot, "still", *scenes, "--size", "320x240", "-q", "-o", self.scratch / "folder/####.png"])
        self.found["folder"] = {"pictures": len(scenes), "wall_s": run.wall_s, "cpu_s": run.cpu_s}
        print(f"\n### {len(scenes)} scenes at 320×240 in one process\n\n{len(scenes) / run.wall_s:.0f} pictures a second "
              f"({1e3 * run.cpu_s / len(scenes):.1f} ms of CPU each)")

    def floor(self):
        print("\n### 1920×1080 to MP4 against its floor: drawing alone and encoding alone, same frames, same run\n")
        print("| settings | draw, CPU ms | encode, CPU ms | film, wall ms | wall over (draw + encode)/2 | frames/s | "
              "encoder alone, frames/s | share | memory above the encoder's, MiB |\n|" + "---|" * 9)
        n = self.options.frames
        self.found["floor"] = {}
        for settings in ("lecture", "veryfast", "medium"):
            draw = self.phase("render", "1920x1080", "lecture", n)
            encode = self.phase("encode", "1920x1080", settings, n)
            film = self.phase("film", "1920x1080", settings, n)
            floor_ms = (draw["cpu_ms"] + encode["cpu_ms"]) / 2
            above = film["peak_mib"] - encode["grown_mib"]
            self.found["floor"][settings] = {"draw": draw, "encode": encode, "film": film}
            name = settings if settings in QUALITIES else f"x264 {settings}, crf 18"
            print(f"| {name} | {draw['cpu_ms']:.1f} | {encode['cpu_ms']:.1f} | {film['wall_ms']:.1f} | "
                  f"{film['wall_ms'] / floor_ms:.2f} | {1e3 / film['wall_ms']:.1f} | {1e3 / encode['wall_ms']:.1f} | "
                  f"{encode['wall_ms'] / film['wall_ms']:.2f} | {above:.0f} |")

    def films(self):
        print("\n### Films and sequences, frames a second (CPU ms a frame)\n\n| | " + " | ".join(QUALITIES) +
              " | PNG sequence |\n|---|" + "---|" * 5)
        self.found["films"] = {}
        for size in SIZES:
            cells = []
            for quality in QUALITIES:
                try:
                    row = self.phase("film", size, quality, self.n_frames(size, quality))
                except Failed as failure:
                    cells.append("–")
                    print(f"{size} {quality}: {failure}", file=sys.stderr)
                    continue
                self.found["films"][f"{size} {quality}"] = row
                cells.append(f"{1e3 / row['wall_ms']:.1f} ({row['cpu_ms']:.0f})")
            n = self.n_frames(size, "lecture")
            folder = self.scratch / f"png_{size}"
            folder.mkdir()
            run = Run([self.poinsot, "render", self.options.scene, "--size", size, "--frames", f"0-{n - 1}", "-q", "-o",
                       folder / "####.png"])
            shutil.rmtree(folder)
            self.found["films"][f"{size} png"] = {"wall_ms": 1e3 * run.wall_s / n, "cpu_ms": 1e3 * run.cpu_s / n}
            cells.append(f"{n / run.wall_s:.1f} ({1e3 * run.cpu_s / n:.0f})")
            print(f"| {size} | " + " | ".join(cells) + " |")

    def memory(self):
        print("\n### Peak memory, 1920×1080 to MP4, lecture\n\n| frames | MiB |\n|---|---|")
        for n in (300, 600 if self.options.quick else 3000):
            run = Run([self.poinsot, "render", self.options.scene, "--set", f"film.duration_s={n / 30}", "--size",
                       "1920x1080", "-q", "-o", self.scratch / f"{n}.mp4"])
            self.found[f"memory_{n}"] = {"peak_mib": run.peak_mib, "wall_s": run.wall_s, "cpu_s": run.cpu_s}
            print(f"| {n} | {run.peak_mib:.0f} |")

    def plot(self, file):
        import matplotlib
        matplotlib.use("Agg")
        from matplotlib import pyplot
        figure, axes = pyplot.subplots(figsize=(8, 4.5), dpi=100)
        for quality in QUALITIES + ["png"]:
            sizes = [size for size in SIZES if f"{size} {quality}" in self.found["films"]]
            axes.plot([megapixels(size) for size in sizes],
                      [1e3 / self.found["films"][f"{size} {quality}"]["wall_ms"] for size in sizes], "o-",
                      label="PNG sequence" if quality == "png" else f"MP4, {quality}")
        axes.axhline(30, color="0.6", linestyle=":", label="as fast as it plays")
        axes.set(xscale="log", yscale="log", xlabel="megapixels a frame", ylabel="frames a second",
                 title=f"{pathlib.Path(self.options.scene).stem}, {os.cpu_count()} processors, no GPU")
        axes.set_xticks([megapixels(size) for size in SIZES], ["720p", "1080p", "2160p"])
        axes.minorticks_off()
        axes.grid(alpha=0.3)
        axes.legend(fontsize=8)
        figure.tight_layout()
        figure.savefig(file)
        print(f"\nplot: {file}")


def megapixels(size):
    width, height = map(int, size.split("x"))
    return width * height / 1e6


def machine():
    model = next((line.split(":", 1)[1].strip() for line in open("/proc/cpuinfo") if line.startswith("model name")), "?")
    return f"{datetime.date.today()}, {model}, {os.cpu_count()} processors, load {os.getloadavg()[0]:.1f}"


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--build", default=ROOT / "build" / "release")
    parser.add_argument("--scene", default=ROOT / "scenes" / "generic.toml")
    parser.add_argument("--frames", type=int, default=240, help="of the 1080p films; larger and finer ones get fewer")
    parser.add_argument("--repeat", type=int, default=3)
    parser.add_argument("--quick", action="store_true", help="60 frames a film instead of 240, one run of each, no film of "
                                                              "3,000 frames")
    parser.add_argument("--only", help="a comma-separated choice of: parts, first_picture, folder, floor, films, "
                                       "memory")
    parser.add_argument("--plot")
    parser.add_argument("--json")
    options = parser.parse_args()
    if options.quick:
        options.frames, options.repeat = 60, 1
    if options.plot:
        try:
            import matplotlib  # noqa: F401, before the minutes that lead to the plot
        except ModuleNotFoundError:
            parser.error("--plot needs matplotlib: apt install python3-matplotlib, and run with /usr/bin/python3")
    bench = Bench(options)
    print(machine())
    parts = ["parts", "first_picture", "folder", "floor", "films", "memory"]
    try:
        for part in options.only.split(",") if options.only else parts:
            getattr(bench, part)()
            sys.stdout.flush()
        if options.plot and "films" in bench.found:
            bench.plot(options.plot)
        if options.json:
            pathlib.Path(options.json).write_text(json.dumps({"machine": machine(), **bench.found}, indent=1))
    except Failed as failure:
        sys.exit(f"film_bench: {failure}")
    finally:
        shutil.rmtree(bench.scratch, ignore_errors=True)
    print(f"\nload at the end: {os.getloadavg()[0]:.1f}; the script's own CPU: "
          f"{sum(resource.getrusage(resource.RUSAGE_SELF)[:2]):.1f} s")


if __name__ == "__main__":
    main()
