#!/usr/bin/env python3
"""Runs the program with closed standard streams, within limits of memory and stack, and ends its terminal or its parent.

A run either makes the bytes of an ordinary run or exits with code 3 and one line that says what is missing; no signal ends it, and
nothing but its contents gets into a file. --all tries many more limits. Usage: surroundings.py POINSOT [--all]
"""
import argparse
import os
import pathlib
import resource
import shutil
import signal
import subprocess
import sys
import tempfile
import time

SCENE = """title = "Surroundings"
[body]
moments_kg_m2 = [3.0, 2.0, 1.0]
[start]
omega_rad_s = [0.05, 2.0, 0.1]
[film]
size = "160x90"
fps = 15
duration_s = 1.0
[[stops]]
at_s = 0.4
title = "One"
"""
# What makes the output, by its name. The small picture has notes on stderr.
MAKES = {
    "a.png": "still scene.toml",
    "a.pdf": "still scene.toml",
    "a.csv": "sample scene.toml --times 0:3:0.05",
    "a.mp4": "render scene.toml",
    "a.gif": "render scene.toml --frames 0-5",
    "a.webm": "render scene.toml --frames 0-5",
    "a.mov": "render scene.toml --frames 0-5",
    "a.pptx": "render scene.toml",
    "a.toml": "fit table.csv",
    "a.html": "render scene.toml",
    "slides": "render scene.toml",
    "jobs.mp4": "render scene.toml --jobs 2",
}
LIMITS = {"v": resource.RLIMIT_AS, "d": resource.RLIMIT_DATA, "s": resource.RLIMIT_STACK}
# In kB. The program and its libraries alone take 60,000 kB of address space, and a stack of 16 kB is too small to start any.
FEW = [("v", 225_000, "a.png"), ("v", 409_600, "a.mp4"), ("v", 500_000, "a.png"), ("v", 80_000, "a.pdf"), ("d", 50_000, "a.mp4"),
       ("s", 64, "a.mp4"), ("s", 64, "a.toml"), ("s", 512, "a.mp4")]
MANY = {"v": [80_000, 100_000, 153_600, 200_000, 225_000, 250_000, 275_000, 300_000, 325_000, 358_400, 409_600, 450_000, 480_000, 500_000,
              525_000, 550_000, 575_000, 600_000, 650_000, 700_000, 800_000, 1_000_000],
        "d": [5_000, 10_000, 20_000, 35_000, 50_000, 75_000, 100_000, 125_000, 150_000, 200_000, 250_000, 400_000],
        "s": [32, 64, 128, 256, 511, 512, 1024, 4096, 1_000_000]}


class Surroundings:
    def __init__(self, program, folder):
        self.program, self.folder, self.n_wrong, self.n_runs = program, folder, 0, 0
        (folder / "scene.toml").write_text(SCENE)
        # Bytes are those of any number of threads; with two, a machine of many cores is tried with the limits of a small one.
        os.environ.update(LP_NUM_THREADS="2", MESA_SHADER_CACHE_DIR=str(folder / "shaders"))
        table = self.run("sample scene.toml --times 0:3:0.05".split())[1]
        (folder / "table.csv").write_bytes(table)
        self.references = {}

    def wrong(self, what):
        self.n_wrong += 1
        print("WRONG", what, flush=True)

    def run(self, arguments, prepare=None, close=()):
        self.n_runs += 1

        def before():
            for descriptor in close:
                os.close(descriptor)
            if prepare:
                prepare()

        done = subprocess.run([self.program, *arguments], cwd=self.folder, stdout=subprocess.PIPE, stderr=subprocess.PIPE,
                              preexec_fn=before, timeout=600)
        return done.returncode, done.stdout, done.stderr.decode(errors="replace")

    def make(self, name, **how):
        """Makes an output; returns its files' bytes, the exit code and what was said."""
        option = "--slides" if name == "slides" else "-o"
        code, _, said = self.run([*MAKES[name].split(), option, name], **how)
        there = self.folder / name
        files = {p.name: p.read_bytes() for p in there.iterdir()} if there.is_dir() else there.read_bytes() if there.exists() else None
        for path in self.folder.glob("*" + name + "*"):
            shutil.rmtree(path) if path.is_dir() else path.unlink()
        for path in self.folder.glob("." + name + "*"):
            shutil.rmtree(path) if path.is_dir() else path.unlink()
        return files, code, said

    def reference(self, name):
        if name not in self.references:
            files, code, said = self.make(name)
            if name == "a.html" and code == 3 and "without its module" in said:
                files = None  # this build makes no pages
            elif code != 0 or files is None:
                self.wrong(f"{name}: exit {code}, {said[-300:]!r}")
            self.references[name] = files
        return self.references[name]

    def with_closed_streams(self, name, close):
        expected = self.reference(name)
        files, code, said = self.make(name, close=close)
        # Only `fit` prints something besides, which then fails.
        right_code = 3 if name == "a.toml" and 1 in close else 0
        if expected is not None and (code != right_code or files != expected):
            self.wrong(f"{name} without descriptors {close}: exit {code}, {said[-300:]!r}, "
                       f"{'no file' if files is None else 'same bytes' if files == expected else 'other bytes'}")

    def within(self, letter, kB, name):
        expected = self.reference(name)
        if expected is None:
            return
        hard = resource.getrlimit(LIMITS[letter])[1]
        if hard != resource.RLIM_INFINITY and hard < 1024 * kB:
            return
        files, code, said = self.make(name, prepare=lambda: resource.setrlimit(LIMITS[letter], (1024 * kB, 1024 * kB)))
        lines = [line for line in said.splitlines() if not line.startswith("note:")]
        refused = code == 3 and files is None and len(lines) == 1 and ("memory" in said or "ulimit" in said) and "install" not in said
        if not refused and not (code == 0 and files == expected):
            self.wrong(f"{name} within ulimit -{letter} {kB}: exit {code}, {said[-300:]!r}, "
                       f"{'no file' if files is None else 'same bytes' if files == expected else 'other bytes'}")
        return code

    def verified_within(self, kB):
        """A film that is drawn again: what there is no memory for is not said to be missing."""
        (self.folder / "verified.mp4").write_bytes(self.reference("a.mp4"))
        code, _, said = self.run(["explain", "--verify", "verified.mp4"],
                                 prepare=lambda: resource.setrlimit(resource.RLIMIT_AS, (1024 * kB, 1024 * kB)))
        if code not in (0, 1, 3) or "install" in said or said.count("\n") > 1:
            self.wrong(f"explain --verify within ulimit -v {kB}: exit {code}, {said[-300:]!r}")

    def begin_long_film(self, *options, prepare=None):
        """A film of an hour, of which some frames are in its hidden files."""
        process = subprocess.Popen([self.program, "render", "scene.toml", "-q", "--set", "film.duration_s=3600.0", "--set", "stops=[]",
                                    "-o", "long.mp4", *options],
                                   cwd=self.folder, stdout=subprocess.DEVNULL, stderr=subprocess.PIPE, preexec_fn=prepare)
        until = time.monotonic() + 300
        while not any(p.stat().st_size > 0 for p in self.folder.glob(".long.mp4*/.*.frames") if p.is_file()) and \
                not any(p.stat().st_size > 0 for p in self.folder.glob(".long.mp4*.frames") if p.is_file()):
            if process.poll() is not None or time.monotonic() > until:
                self.wrong(f"the long film was not begun: {process.poll()}")
                break
            time.sleep(0.02)
        return process

    def end_by(self, number, prepare=None):
        process = self.begin_long_film("--jobs", "1", prepare=prepare)
        process.send_signal(number)
        said = process.communicate(timeout=300)[1].decode()
        if process.returncode != 3 or "interrupted before" not in said:
            self.wrong(f"signal {number}: exit {process.returncode}, {said!r}")

    def ignore_a_hangup(self):
        process = self.begin_long_film("--jobs", "1", prepare=lambda: signal.signal(signal.SIGHUP, signal.SIG_IGN))
        process.send_signal(signal.SIGHUP)
        time.sleep(0.5)
        if process.poll() is not None:
            self.wrong(f"nohup: exit {process.returncode}")
        process.terminate()
        process.communicate(timeout=300)

    def kill_the_parent(self):
        # Its children need some time to give their memory back.
        process = self.begin_long_film("--jobs", "2", "--size", "1920x1080")
        process.kill()
        process.stderr.close()
        process.wait()
        code, _, said = self.run(["render", "scene.toml", "-q", "--jobs", "2", "-o", "long.mp4"])
        if code != 0:
            self.wrong(f"the run after the death of a parent: exit {code}, {said!r}")


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("program")
    parser.add_argument("--all", action="store_true")
    args = parser.parse_args()
    with tempfile.TemporaryDirectory() as folder:
        tried = Surroundings(os.path.abspath(args.program), pathlib.Path(folder))
        for number in (signal.SIGHUP, signal.SIGTERM, signal.SIGINT) if args.all else (signal.SIGHUP,):
            tried.end_by(number)
        tried.ignore_a_hangup()
        for _ in range(20 if args.all else 1):
            tried.kill_the_parent()
        for name in MAKES if args.all else ("a.pptx",):
            for close in ((0,), (1,), (2,), (0, 1), (0, 2), (1, 2), (0, 1, 2)) if args.all else ((2,), (0, 1, 2)):
                tried.with_closed_streams(name, close)
        few = FEW if not args.all else [(letter, kB, name) for letter, all_kB in MANY.items() for kB in all_kB for name in MAKES]
        codes = {}
        for letter, kB, name in few:
            codes.setdefault((letter, name), []).append(f"{kB}:{tried.within(letter, kB, name)}")
        for kB in MANY["v"] if args.all else (200_000,):
            tried.verified_within(kB)
        for (letter, name), row in codes.items():
            print(f"ulimit -{letter}  {name:9}", *row)
        print(f"{tried.n_runs} runs, {tried.n_wrong} wrong")
    return 1 if tried.n_wrong else 0


if __name__ == "__main__":
    sys.exit(main())
