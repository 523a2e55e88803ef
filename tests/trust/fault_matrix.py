#!/usr/bin/env python3
"""What becomes of a picture, a sequence and a film when the machine fails: each case with its outcome.

A run must end with the right file (the bytes of an undisturbed run), or with exit code 3 (2 where the scene could not be read),
one line, and nothing under the final name. Exit code 1 if any case does otherwise.
Usage: fault_matrix.py POINSOT [FAILING_NEW.so [QUOTA.so]] [--kills N] [--seed N] [--runs N] [--only CASE…]
"""
import argparse
import hashlib
import os
import pathlib
import random
import shutil
import signal
import subprocess
import sys
import tempfile
import threading
import time

SCENE = """title = "Faults"
[body]
moments_kg_m2 = [3.0, 2.0, 1.0]
[start]
omega_rad_s = [0.01, 2.0, 0.01]
[film]
size = "96x54"
duration_s = 60.0
"""
# Name of the output → the arguments that make it. "####" stands for the frame's number.
KINDS = {
    "a.png": ["still", "--time", "1"],
    "a_####.png": ["render", "--frames", "0-11"],
    "a.mp4": ["render", "--frames", "0-199"],
    "a.webm": ["render", "--frames", "0-11"],
    "a.gif": ["render", "--frames", "0-11"],
}
LONG_FRAMES = 720  # of the film that is killed: six chunks


class Matrix:
    def __init__(self, program, folder):
        self.program, self.folder = program, folder
        self.scene = folder / "scene.toml"
        self.scene.write_text(SCENE)
        self.counts = {}
        self.n_wrong = 0
        self.n_runs = 0
        self.expected = {}
        for name in KINDS:
            place = folder / f"right_{name}"
            place.mkdir()
            subprocess.run(self.command(name, place), check=True)
            self.expected[name] = self.contents(place)

    def command(self, name, place, *more):
        command, *options = KINDS[name]
        return [self.program, command, str(self.scene), *options, *more, "--portable", "-q", "-o", str(place / name)]

    @staticmethod
    def contents(place):
        """Hashes of all files that are not hidden, by name."""
        return {p.name: hashlib.sha256(p.read_bytes()).hexdigest() for p in sorted(place.iterdir())
                if p.is_file() and not p.name.startswith(".")}

    def say(self, fault, name, right, outcome):
        self.n_wrong += not right
        self.n_runs += 1
        key = (fault, name, ("" if right else "WRONG: ") + outcome)
        self.counts[key] = self.counts.get(key, 0) + 1

    def print(self):
        for (fault, name, outcome), n in self.counts.items():
            print(f"{fault:34} {name:11} {n:3} × {outcome}", flush=True)
        self.counts = {}

    def judge(self, fault, name, place, done, input_may_fail=False):
        """A finished process and the folder it wrote to."""
        found, expected = self.contents(place), self.expected[name]
        line = done.stderr.decode(errors="replace").strip()
        one_line = line.count("\n") == 0 and line != ""
        if done.returncode == 0:
            self.say(fault, name, found == expected, "right file" if found == expected else "exit 0 without the right file")
            return
        if done.returncode == 3 and one_line and found == expected:
            self.say(fault, name, True, f"exit 3, one line, and the right file ({line.split(': ')[-1][:60]})")
            return
        # Frames of a sequence that are there must be whole ones.
        partial = all(expected.get(n) == h for n, h in found.items()) if "#" in name else not found
        codes = (2, 3) if input_may_fail else (3,)
        if done.returncode in codes and one_line and partial:
            reason = line.split(": ")[-1][:60]
            self.say(fault, name, True, f"exit {done.returncode}, one line ({reason})")
        else:
            self.say(fault, name, False,
                     f"exit {done.returncode}, left {sorted(found) if not partial else 'nothing'}, said {line[-200:]!r}")

    def fresh(self):
        return pathlib.Path(tempfile.mkdtemp(dir=self.folder))

    def run(self, command, timeout=120, **more):
        return subprocess.run(command, capture_output=True, timeout=timeout, **more)

    # The cases.

    def full_disk(self):
        for name in KINDS:
            for size in ("4k", "12k", "40k", "100k"):
                place, kept = self.fresh(), self.fresh()
                # A mount of the process's own; what is left is copied out before it vanishes.
                script = 'mount -t tmpfs -o size=$1 none "$2" || exit 99; shift; p=$1; k=$2; shift 2; "$@"; s=$?; cp -a "$p"/. "$k"; exit $s'
                done = self.run(["unshare", "-m", "sh", "-c", script, "sh", size, str(place), str(kept),
                                 *self.command(name, place)])
                if done.returncode == 99 or b"unshare" in done.stderr:
                    self.say("full tmpfs", name, True, "skipped: this machine does not let us mount")
                else:
                    self.judge("full tmpfs", name, kept, done)

    def full_device(self):
        for name in ("a.png", "a.gif", "a.webm"):
            place = self.fresh()
            (place / name).symlink_to("/dev/full")
            done = self.run(self.command(name, place))
            (place / name).unlink()
            self.judge("link to /dev/full", name, place, done)
        for command in (["sample", str(self.scene), "--times", "0,1"], ["check", str(self.scene)], ["list", "keys"]):
            with open("/dev/full", "wb") as full:
                done = subprocess.run([self.program, *command], stdout=full, stderr=subprocess.PIPE)
            self.say("stdout is /dev/full", command[0], done.returncode == 3, f"exit {done.returncode}")

    def small_limit(self):
        for name in KINDS:
            for n_kib in (1, 4, 16):
                place = self.fresh()
                done = self.run(["bash", "-c", f'ulimit -f {n_kib}; exec "$@"', "bash", *self.command(name, place)])
                self.judge("ulimit -f", name, place, done)

    def quota(self, library):
        """A user's quota on the disk: bytes, and, with none left, files. The write that passes it comes through in part."""
        if library is None:
            return
        for name in KINDS:
            size = sum(p.stat().st_size for p in (self.folder / f"right_{name}").iterdir())
            for n_bytes in (0, 1, 1000, size // 2, size - 1):
                place = self.fresh()
                environment = dict(os.environ, LD_PRELOAD=library, POINSOT_QUOTA=str(n_bytes),
                                   POINSOT_QUOTA_FOLDER=str(place))
                done = self.run(self.command(name, place), env=environment)
                self.judge("quota", name, place, done)
                if done.returncode != 3 or b"quota" not in done.stderr:
                    self.say("quota", name, False, f"exit {done.returncode}, said {done.stderr[-200:]!r}")

    def closed_folders(self):
        for name in KINDS:
            place = self.fresh()
            script = ('mount -t tmpfs -o size=1m none "$1" && mount -o remount,ro "$1" || exit 99; shift; "$@"')
            done = self.run(["unshare", "-m", "sh", "-c", script, "sh", str(place), *self.command(name, place)])
            if done.returncode == 99 or b"unshare" in done.stderr:
                self.say("read-only folder", name, True, "skipped: this machine does not let us mount")
            else:
                self.judge("read-only folder", name, place, done)
            place = self.fresh()
            done = self.run(self.command(name, place / "missing"))
            self.judge("missing folder", name, place, done)
            if name == "a.png":
                continue
            place = self.fresh() / "vanishes"
            place.mkdir()
            long = [*self.command(name, place)]
            long[long.index("--frames") + 1] = "0-1799"
            process = subprocess.Popen(long, stdout=subprocess.DEVNULL, stderr=subprocess.PIPE)
            time.sleep(0.6)
            place.rename(place.with_name("gone"))
            shutil.rmtree(place.with_name("gone"), ignore_errors=True)
            _, said = process.communicate(timeout=120)
            place.mkdir(exist_ok=True)
            self.judge("folder vanishes", name, place,
                       subprocess.CompletedProcess(long, process.returncode, b"", said))

    def broken_pipe(self):
        times = ",".join(str(t) for t in range(20000))
        process = subprocess.Popen([self.program, "sample", str(self.scene), "--times", times],
                                   stdout=subprocess.PIPE, stderr=subprocess.PIPE)
        process.stdout.read(100)
        process.stdout.close()
        said = process.stderr.read().decode().strip()
        code = process.wait()
        self.say("broken pipe", "sample", code == 3 and said.count("\n") == 0 and said != "", f"exit {code} ({said[:50]})")
        place = self.fresh()
        os.mkfifo(place / "a.gif")
        reader = threading.Thread(target=lambda: open(place / "a.gif", "rb").read(10))
        reader.start()
        done = self.run(self.command("a.gif", place))
        reader.join()
        (place / "a.gif").unlink()
        self.judge("broken pipe", "a.gif", place, done)

    def second_run(self):
        for name in KINDS:
            if name == "a.png":
                continue
            place = self.fresh()
            long = self.command(name, place)
            long[long.index("--frames") + 1] = "0-1799"
            first = subprocess.Popen(long, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
            # The second begins when the first has its file.
            deadline = time.monotonic() + 30
            while not any(place.iterdir()) and time.monotonic() < deadline:
                time.sleep(0.01)
            done = self.run(self.command(name, place))
            first.kill()
            first.wait()
            refused = done.returncode == 3 and b"another run" in done.stderr and done.stderr.strip().count(b"\n") == 0
            self.say("second run on the same output", name, refused,
                     "exit 3, one line (another run is writing it)" if refused else f"exit {done.returncode} {done.stderr[-200:]}")

    def kills(self, n_kills, seed):
        """kill -9 at random moments, then the same command again; in every fifth round it may finish."""
        dice = random.Random(seed)
        for name, frames, share in (("a.mp4", LONG_FRAMES, 1), ("a.webm", LONG_FRAMES, 0.4), ("a.gif", 400, 0.4),
                                    ("a_####.png", 150, 0.2)):
            right = self.fresh()
            command = self.command(name, right)
            command[command.index("--frames") + 1] = f"0-{frames - 1}"
            began = time.monotonic()
            subprocess.run(command, check=True)
            whole_s = time.monotonic() - began
            expected = self.contents(right)
            n_done, n_early, n_resumed = 0, 0, 0
            place = self.fresh()
            again = [part.replace(str(right), str(place)) for part in command if part != "-q"]
            while n_done < n_kills * share:
                process = subprocess.Popen(again, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
                try:
                    process.wait(dice.uniform(0.0, 0.6 * whole_s))
                    n_early += 1
                except subprocess.TimeoutExpired:
                    process.send_signal(signal.SIGKILL)
                    process.wait()
                    n_done += 1
                found = self.contents(place)
                # A run killed between the renaming and its end has done its work.
                if any(expected.get(n) != h for n, h in found.items()):
                    self.say("kill -9", name, False, "a file that is not as it should be")
                if process.returncode == 0 or n_done % 5 == 0:
                    done = self.run(again)
                    n_resumed += b"going on" in done.stderr
                    same = done.returncode == 0 and self.contents(place) == expected
                    self.say("kill -9, then the same command", name, same,
                             "the bytes of an uninterrupted run" if same else f"exit {done.returncode} {done.stderr[-200:]}")
                    shutil.rmtree(place)
                    place.mkdir()
            # How many there are depends on the machine's speed; that kept frames are used is tested in tests/output.
            self.say("kill -9", name, True,
                     f"{n_done} kills; {n_resumed} finishing runs went on from what was left")

    def failing_calls(self, n_runs):
        """libfiu: reads, writes, opens and syncs of the C library that fail at random."""
        if shutil.which("fiu-run") is None:
            self.say("libfiu", "all", True, "skipped: fiu-run is not installed (Debian: fiu-utils)")
            return
        # As fiu-run does, but with FFmpeg loaded from the start: libfiu's malloc() asks for thread-local data while the loader
        # is about to move it for libraries opened later, and glibc 2.36 then frees it twice.
        # And without Mesa's shader cache: the thread that writes it asks the loader for a name while it holds libfiu's lock, and
        # the loader, opening FFmpeg, asks libfiu's malloc() for memory while it holds its own.
        preloaded = " ".join(["/usr/lib/fiu/fiu_run_preload.so", "/usr/lib/fiu/fiu_posix_preload.so",
                              "libavformat.so.59", "libswscale.so.6"])
        for what, probability in (("posix/io/rw/*", 0.02), ("posix/io/oc/*", 0.03), ("posix/io/sync/*", 0.5),
                                  ("posix/stdio/*", 0.02)):
            for name in KINDS:
                for _ in range(n_runs):
                    place = self.fresh()
                    done = self.run(self.command(name, place),
                                    env=dict(os.environ, LD_PRELOAD=preloaded, MESA_SHADER_CACHE_DISABLE="true",
                                             FIU_ENABLE=f"enable_random name={what},probability={probability}"))
                    self.judge(f"libfiu {what}", name, place, done, input_may_fail=True)

    def failing_allocation(self, library, n_points):
        if library is None:
            return
        for name in KINDS:
            def environment(n):
                return dict(os.environ, LD_PRELOAD=library, POINSOT_FAIL_NEW=str(n))
            counted = self.run(self.command(name, self.fresh()), env=environment(-1))
            total = int(counted.stderr.decode().split("allocations: ")[1])
            # Close together at first, where the set-up is, then over the whole run.
            points = sorted({max(1, int(total ** (i / (n_points - 1)))) for i in range(n_points)}
                            | {max(1, total * i // n_points) for i in range(1, n_points)})
            for point in points:
                place = self.fresh()
                done = self.run(self.command(name, place), env=environment(point))
                self.judge("failing allocation", name, place, done, input_may_fail=True)

    def room(self):
        """A run that cannot fit ends early: on 2 MB, before 5 % of its frames are drawn."""
        for name, frames in (("a.mp4", 54000), ("a_####.png", 54000)):
            place = self.fresh()
            long = self.command(name, place, "--set", "film.duration_s=1800")
            long[long.index("--frames") + 1] = f"0-{frames - 1}"
            script = 'mount -t tmpfs -o size=2m none "$1" || exit 99; shift; "$@"'
            began = time.monotonic()
            done = self.run(["unshare", "-m", "sh", "-c", script, "sh", str(place), *long])
            if done.returncode == 99 or b"unshare" in done.stderr:
                self.say("too little room", name, True, "skipped: this machine does not let us mount")
                continue
            right = done.returncode == 3 and b"frames to come need about" in done.stderr
            self.say("too little room", name, right, f"exit {done.returncode} before the disk is full"
                     if right else f"exit {done.returncode} after {time.monotonic() - began:.1f} s: {done.stderr[-200:]}")


def main():
    arguments = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    arguments.add_argument("program")
    arguments.add_argument("failing_new", nargs="?")
    arguments.add_argument("quota", nargs="?")
    arguments.add_argument("--kills", type=int, default=50)
    arguments.add_argument("--seed", type=int, default=1)
    arguments.add_argument("--runs", type=int, default=6, help="of each kind under each of libfiu's faults")
    arguments.add_argument("--only", nargs="*", metavar="CASE", help="of the cases, these")
    chosen = arguments.parse_args()
    with tempfile.TemporaryDirectory(prefix="poinsot-faults-") as folder:
        matrix = Matrix(chosen.program, pathlib.Path(folder))
        cases = {"full_disk": matrix.full_disk, "full_device": matrix.full_device, "limit": matrix.small_limit,
                 "quota": lambda: matrix.quota(chosen.quota),
                 "folders": matrix.closed_folders, "pipe": matrix.broken_pipe, "second_run": matrix.second_run,
                 "room": matrix.room, "kills": lambda: matrix.kills(chosen.kills, chosen.seed),
                 "libfiu": lambda: matrix.failing_calls(chosen.runs),
                 "allocation": lambda: matrix.failing_allocation(chosen.failing_new, 8)}
        for case in chosen.only or cases:
            cases[case]()
            matrix.print()
        print(f"{matrix.n_runs} outcomes, {matrix.n_wrong} wrong")
        return 1 if matrix.n_wrong else 0


if __name__ == "__main__":
    sys.exit(main())
