#!/usr/bin/env python3
"""Tests the portable profile: byte-identical files on every x86-64 processor, with any number of threads, any backend and in every
run.

Runs the program natively and under qemu-x86_64 as several processors, and compares PNG, PDF and SVG files, a film's bytes and the
digits of `sample` with those of the first native run. Exit code 1 on any difference, 77 (skipped) without qemu.
Usage: processor_sweep.py POINSOT [TEST_LIBM]
"""
import concurrent.futures
import ctypes.util
import hashlib
import os
import pathlib
import shutil
import subprocess
import sys
import tempfile
import time

REPOSITORY = pathlib.Path(__file__).resolve().parents[2]
# Without AVX and FMA; with AVX; with AVX2 and FMA, of both manufacturers.
PROCESSORS = ["native", "Nehalem", "SandyBridge", "Haswell", "EPYC"]
SIZE = "128x72"
TIMES = ",".join(repr(0.37 * k * k) for k in range(300))

# OSMesa, which was removed from Mesa in 25.1, or its replacement.
FIRST = "osmesa" if ctypes.util.find_library("OSMesa") else "egl"
# The runs: name → (arguments, suffix of the output file or "" for stdout, llvmpipe's threads).
STILL = ["--portable", "-q", "--size", SIZE]
CASES = {
    f"still generic, {FIRST}, 2 threads": (["still", "generic", *STILL, "--backend", FIRST], ".png", 2),
    f"still generic, {FIRST}, 1 thread": (["still", "generic", *STILL, "--backend", FIRST], ".png", 1),
    "still generic, egl, 4 threads": (["still", "generic", *STILL, "--backend", "egl"], ".png", 4),
    "still heavy_top_looping": (["still", "heavy_top_looping", *STILL, "--time", "4"], ".png", 2),
    "still tensor": (["still", "tensor", *STILL, "--time", "3"], ".png", 2),
    "film tennis_racket": (["render", "tennis_racket", "--frames", "0-3", *STILL], ".mp4", 2),
    "still generic, PDF": (["still", "generic", "-q"], ".pdf", 2),
    "still momentum_sphere, SVG": (["still", "momentum_sphere", "-q"], ".svg", 2),
    "still toutatis, PDF": (["still", "toutatis", "-q", "--text", "paths"], ".pdf", 2),
    "sample generic": (["sample", "generic", "--times", TIMES], "", 2),
    "sample heavy_top_wavy": (["sample", "heavy_top_wavy", "--times", TIMES], "", 2),
    "sample heavy_top_looping": (["sample", "heavy_top_looping", "--times", TIMES], "", 2),
}
# Pictures that must be equal to each other as well.
ALIKE = [f"still generic, {FIRST}, 2 threads", f"still generic, {FIRST}, 1 thread", "still generic, egl, 4 threads"]
# Omitted to save minutes: other cases test the same.
LEFT_OUT = {ALIKE[1]: ["SandyBridge", "Haswell"], ALIKE[2]: ["SandyBridge", "EPYC"]}


def run_case(program, processor, name, folder):
    """The SHA-256 of one run's output, or its error."""
    arguments, suffix, threads = CASES[name]
    command, scene, *options = arguments
    output = folder / f"{processor}-{abs(hash(name))}{suffix}"
    line = [] if processor == "native" else ["qemu-x86_64", "-cpu", processor]
    line += [program, command, str(REPOSITORY / "scenes" / f"{scene}.toml"), *options]
    if suffix:
        line += ["-o", str(output)]
    environment = dict(os.environ, LP_NUM_THREADS=str(threads), MESA_SHADER_CACHE_DISABLE="true")
    done = subprocess.run(line, env=environment, capture_output=True)
    if done.returncode != 0:
        return f"exit code {done.returncode}: {done.stderr.decode(errors='replace')[-300:]}"
    return hashlib.sha256(output.read_bytes() if suffix else done.stdout).hexdigest()


def elementary_functions(test, processor):
    """Whether the test of the elementary functions passes on the processor."""
    line = [] if processor == "native" else ["qemu-x86_64", "-cpu", processor]
    done = subprocess.run([*line, test, "--gtest_filter=*SameBits*"], capture_output=True)
    return "same bits" if done.returncode == 0 else f"FAILED, exit code {done.returncode}"


def main():
    program = sys.argv[1]
    test = sys.argv[2] if len(sys.argv) > 2 else None
    if shutil.which("qemu-x86_64") is None:
        print("skipped: qemu-x86_64 is not installed (Debian: qemu-user)")
        return 77
    began = time.monotonic()
    failures = 0
    with tempfile.TemporaryDirectory() as scratch, \
            concurrent.futures.ThreadPoolExecutor(os.cpu_count()) as workers:
        wanted = [(name, processor) for name in CASES for processor in PROCESSORS
                  if processor == "native" or processor not in LEFT_OUT.get(name, [])]
        runs = {(name, processor): workers.submit(run_case, program, processor, name, pathlib.Path(scratch))
                for name, processor in wanted}
        libm = {processor: workers.submit(elementary_functions, test, processor) for processor in PROCESSORS if test}
        for name in CASES:
            expected = runs[ALIKE[0] if name in ALIKE else name, "native"].result()
            for processor in PROCESSORS:
                if (name, processor) not in runs:
                    continue
                found = runs[name, processor].result()
                same = found == expected and len(found) == 64
                failures += not same
                print(f"{name:34} {processor:12} {'same ' + found[:16] if same else 'DIFFERS ' + found}", flush=True)
        for processor, outcome in libm.items():
            failures += outcome.result() != "same bits"
            print(f"{'elementary functions':34} {processor:12} {outcome.result()}")
    print(f"{failures} of {len(runs) + len(libm)} differ; {time.monotonic() - began:.0f} s")
    return 1 if failures else 0


if __name__ == "__main__":
    sys.exit(main())
