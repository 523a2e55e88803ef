#!/usr/bin/env python3
"""Tests pictures, sequences and films on a failing machine: each case with its outcome.

A run must end with the correct file (byte-identical to an undisturbed run), or with exit code 3 (2 if the scene could not be read),
one line of message, and no file under the final name. Exit code 1 if any case fails.
Random choices follow from the seed, separately for each trial: a failure prints its trial, and `--seed N --only CASE --trial TRIAL`
repeats it. Positions of system calls are exact; moments of `kills` depend on the machine's clock. Sequences of such failures, exactly
repeatable, are those of output_sequences.
Usage: fault_matrix.py POINSOT [FAILING_NEW.so [QUOTA.so]] [--kills N] [--seed N] [--only CASE…] [--trial TRIAL]
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
# Name of the output → the arguments that make it. "####" is replaced by the frame's number.
KINDS = {
    "a.png": ["still", "--time", "1"],
    "a_####.png": ["render", "--frames", "0-11"],
    "a.mp4": ["render", "--frames", "0-199"],
    "a.webm": ["render", "--frames", "0-11"],
    "a.mov": ["render", "--frames", "0-11"],
    "a.gif": ["render", "--frames", "0-11"],
}
LONG_FRAMES = 720  # of the film that is killed: six chunks


class Matrix:
    def __init__(self, program, folder, seed=1, trial=None):
        self.program, self.folder = program, folder
        self.seed, self.trial = seed, trial
        self.scene = folder / "scene.toml"
        self.scene.write_text(SCENE)
        # Mesa's shader cache, filled by the undisturbed runs below: the disturbed runs do not write to it, so that every write,
        # rename and unlink is made by poinsot itself, and no run spends its time on compiling shaders.
        os.environ["MESA_SHADER_CACHE_DIR"] = str(folder / "shaders")
        # And no threads in Mesa, which would delay small pictures.
        os.environ["LP_NUM_THREADS"] = "0"
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

    def dice(self, *trial):
        return random.Random(f"{self.seed}:{':'.join(map(str, trial))}")

    def wants(self, *trial):
        """Whether a trial is selected: all are, or one by its name."""
        return self.trial is None or self.trial == ":".join(map(str, trial))

    def print(self):
        for (fault, name, outcome), n in self.counts.items():
            print(f"{fault:41} {name:11} {n:3} × {outcome}", flush=True)
        self.counts = {}

    def judge(self, fault, name, place, done, input_may_fail=False, trial=None):
        """Checks a completed process and its output folder."""
        replay = f" (trial {trial})" if trial else ""
        found, expected = self.contents(place), self.expected[name]
        line = done.stderr.decode(errors="replace").strip()
        one_line = line.count("\n") == 0 and line != ""
        if done.returncode == 0:
            self.say(fault, name, found == expected, "right file" if found == expected else f"exit 0 without the right file{replay}")
            return
        if done.returncode == 3 and one_line and found == expected:
            self.say(fault, name, True, f"exit 3, one line, and the right file ({line.split(': ')[-1][:60]})")
            return
        # Existing frames of a sequence must be complete.
        partial = all(expected.get(n) == h for n, h in found.items()) if "#" in name else not found
        codes = (2, 3) if input_may_fail else (3,)
        if done.returncode in codes and one_line and partial:
            reason = line.split(": ")[-1][:60]
            self.say(fault, name, True, f"exit {done.returncode}, one line ({reason})")
        else:
            self.say(fault, name, False,
                     f"exit {done.returncode}, left {sorted(found) if not partial else 'nothing'}, said {line[-200:]!r}{replay}")

    def fresh(self):
        return pathlib.Path(tempfile.mkdtemp(dir=self.folder))

    def run(self, command, timeout=120, **more):
        return subprocess.run(command, capture_output=True, timeout=timeout, **more)

    # The test cases.

    def full_disk(self):
        for name in KINDS:
            for size in ("4k", "12k", "40k", "100k"):
                place, kept = self.fresh(), self.fresh()
                # A mount in the process's own namespace; remaining files are copied before it disappears.
                script = 'mount -t tmpfs -o size=$1 none "$2" || exit 99; shift; p=$1; k=$2; shift 2; "$@"; s=$?; cp -a "$p"/. "$k"; exit $s'
                done = self.run(["unshare", "-m", "sh", "-c", script, "sh", size, str(place), str(kept),
                                 *self.command(name, place)])
                if done.returncode == 99 or b"unshare" in done.stderr:
                    self.say("full tmpfs", name, True, "skipped: this machine does not let us mount")
                else:
                    self.judge("full tmpfs", name, kept, done)

    def full_device(self):
        for name in ("a.png", "a.gif", "a.webm", "a.mov"):
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
        """Disk quotas: of bytes, and of files if no bytes are left. The write that exceeds it is done in part."""
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
        # As for other tools: terminated by the signal, without a message.
        self.say("broken pipe", "sample", code == -signal.SIGPIPE and said == "", f"ended by {code} ({said[:50]})")
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
            # The second run starts when the first has opened its file.
            deadline = time.monotonic() + 30
            while not any(place.iterdir()) and time.monotonic() < deadline:
                time.sleep(0.01)
            done = self.run(self.command(name, place))
            first.kill()
            first.wait()
            refused = done.returncode == 3 and b"another run" in done.stderr and done.stderr.strip().count(b"\n") == 0
            self.say("second run on the same output", name, refused,
                     "exit 3, one line (another run is writing it)" if refused else f"exit {done.returncode} {done.stderr[-200:]}")

    def kills(self, n_kills):
        """Sends SIGKILL at random moments and runs the same command again; after five kills it may finish."""
        n_each = 5
        for name, frames, share in (("a.mp4", LONG_FRAMES, 1), ("a.webm", LONG_FRAMES, 0.4), ("a.mov", LONG_FRAMES, 0.4),
                                    ("a.gif", 400, 0.4), ("a_####.png", 150, 0.2)):
            rounds = [k for k in range(max(1, round(n_kills * share / n_each))) if self.wants(name, k)]
            if not rounds:
                continue
            right = self.fresh()
            command = self.command(name, right)
            command[command.index("--frames") + 1] = f"0-{frames - 1}"
            began = time.monotonic()
            subprocess.run(command, check=True)
            whole_s = time.monotonic() - began
            expected = self.contents(right)
            n_done, n_resumed = 0, 0
            for k in rounds:
                dice, place = self.dice("kills", name, k), self.fresh()
                again = [part.replace(str(right), str(place)) for part in command if part != "-q"]
                for _ in range(n_each):
                    process = subprocess.Popen(again, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
                    try:
                        process.wait(dice.uniform(0.0, 0.6 * whole_s))
                    except subprocess.TimeoutExpired:
                        process.send_signal(signal.SIGKILL)
                        process.wait()
                        n_done += 1
                    # A run killed after the final rename has completed its work.
                    if any(expected.get(n) != h for n, h in self.contents(place).items()):
                        self.say("kill -9", name, False, f"a file that is not as it should be (trial {name}:{k})")
                    if process.returncode == 0:
                        break
                n_resumed += self.finish("kill -9", name, k, again, place, expected)
            # Their number depends on the machine's speed; tests/outputs/encoding tests that finished frames are reused.
            self.say("kill -9", name, True,
                     f"{n_done} kills; {n_resumed} finishing runs went on from what was left")

    def finish(self, fault, name, trial, command, place, expected):
        """Checks that the same command, undisturbed, makes a byte-identical file. Returns whether it continued an interrupted run."""
        done = self.run(command)
        same = done.returncode == 0 and self.contents(place) == expected
        self.say(f"{fault}, then the same command", name, same, "the bytes of an uninterrupted run" if same else
                 f"exit {done.returncode} {done.stderr[-200:]} (trial {name}:{trial})")
        shutil.rmtree(place)
        return b"note: continuing" in done.stderr

    # A program under strace, in which the n-th call of a thread kills it or fails.
    CALLS = {"rename": "EIO", "fsync": "EIO", "write": "ENOSPC", "ftruncate": "EIO", "unlink": "EACCES"}

    def traced(self, command, *options):
        # --seccomp-bpf: only the traced calls stop the program.
        return self.run(["strace", "--seccomp-bpf", "-f", "-qq", *options, *command])

    def places_of(self, command, call, dice):
        """Indices of a program's disturbed calls: the first, the last, and some between."""
        log = self.folder / "calls"
        self.traced(command, "-o", str(log), "-e", f"trace={call}")
        threads = [line.split()[0] for line in log.read_text(errors="replace").splitlines() if f" {call}(" in line]
        most = max((threads.count(thread) for thread in set(threads)), default=0)
        between = range(3, max(3, most - 2))
        return sorted({1, 2, most - 1, most, *dice.sample(between, min(4, len(between)))} & set(range(1, most + 1)))

    def system_calls(self):
        """Kills and failures at given system calls."""
        if shutil.which("strace") is None:
            self.say("system calls", "all", True, "skipped: strace is not installed (Debian: strace)")
            return
        for name in KINDS:
            for call, error in self.CALLS.items():
                if self.trial is not None and not self.trial.startswith(f"{name}:{call}:"):
                    continue
                for n in self.places_of(self.command(name, self.fresh()), call, self.dice("system_calls", name, call)):
                    trial = f"{call}:{n}"
                    if not self.wants(name, call, n):
                        continue
                    place = self.fresh()
                    command = self.command(name, place)
                    self.traced(command, "-o", "/dev/null", "-e", f"trace={call}", "-e", f"inject={call}:signal=KILL:when={n}")
                    found = self.contents(place)
                    if any(self.expected[name].get(f) != h for f, h in found.items()):
                        self.say(f"killed at {call}", name, False, f"left {sorted(found)} (trial {name}:{trial})")
                    self.finish(f"killed at {call}", name, trial, command, place, self.expected[name])
                    place = self.fresh()
                    command = self.command(name, place)
                    done = self.traced(command, "-o", "/dev/null", "-e", f"trace={call}",
                                       "-e", f"inject={call}:error={error}:when={n}")
                    self.judge(f"{call} fails", name, place, done, trial=f"{name}:{trial}")
                    self.finish(f"{call} fails", name, trial, command, place, self.expected[name])

    def approvals(self):
        """`approve` killed at system calls: the next run completes, and every baseline has a matching line in the manifest."""
        if shutil.which("strace") is None:
            self.say("approve killed", "all", True, "skipped: strace is not installed (Debian: strace)")
            return
        drawn = self.fresh()
        for k in range(4):
            still = [self.program, "still", str(self.scene), "--portable", "-q", "--time", str(k), "-o", str(drawn / f"{k}.png")]
            subprocess.run(still, check=True)

        def approve(place):
            return [self.program, "approve", "--all", "--results", str(place / "new"), "--baselines", str(place / "ref"),
                    "--why", "again"]

        def prepared():
            """Two baselines, and results of which one is a different picture and one is new."""
            place = self.fresh()
            for folder in ("ref", "new"):
                (place / folder).mkdir()
            for name, k in (("a", 0), ("b", 1)):
                shutil.copy(drawn / f"{k}.png", place / "new" / f"{name}.png")
            subprocess.run(approve(place), check=True, stdout=subprocess.DEVNULL)
            shutil.copy(drawn / "2.png", place / "new" / "b.png")
            shutil.copy(drawn / "3.png", place / "new" / "c.png")
            return place

        for call in ("rename", "fsync", "write", "unlink", "openat"):
            for n in self.places_of(approve(prepared()), call, self.dice("approvals", call)):
                if not self.wants("approve", call, n):
                    continue
                place = prepared()
                self.traced(approve(place), "-o", "/dev/null", "-e", f"trace={call}",
                            "-e", f"inject={call}:signal=KILL:when={n}")
                again = self.run(approve(place))
                compared = self.run([self.program, "compare", str(place / "ref"), str(place / "new")])
                left = [p.name for p in (place / "ref").iterdir() if p.name.startswith(".")]
                right = again.returncode == 0 and compared.returncode == 0 and not left
                self.say(f"killed at {call}, then approved", "approve", right,
                         "every baseline as approved" if right else
                         f"exit {again.returncode}, {compared.stdout[-200:]}, left {left} (trial approve:{call}:{n})")

    def failing_allocation(self, library, n_points):
        if library is None:
            return
        for name in KINDS:
            def environment(n):
                return dict(os.environ, LD_PRELOAD=library, POINSOT_FAIL_NEW=str(n))
            counted = self.run(self.command(name, self.fresh()), env=environment(-1))
            total = int(counted.stderr.decode().split("allocations: ")[1])
            # Dense at first, during the setup, then over the whole run; many for a still, which is quick.
            n = 8 * n_points if name == "a.png" else n_points
            points = sorted({max(1, int(total ** (i / (n - 1)))) for i in range(n)} | {max(1, total * i // n) for i in range(1, n)})
            for point in points:
                place = self.fresh()
                done = self.run(self.command(name, place), env=environment(point))
                self.judge("failing allocation", name, place, done, input_may_fail=True)

    def parts(self, n_kills):
        """A join on a full disk or killed, and parallel processes that draw parts, one of them killed."""
        name = "a.mp4"
        made = self.fresh()
        files = [str(made / f"{k}.mp4") for k in (1, 2)]
        for k, part in enumerate(files, 1):
            command = self.command(name, made, "--part", f"{k}/2")
            subprocess.run([*command[:-1], part], check=True)

        def join(place):
            return [self.program, "join", *files, "-q", "-o", str(place / name)]

        for size in ("4k", "12k", "40k"):
            place, kept = self.fresh(), self.fresh()
            script = 'mount -t tmpfs -o size=$1 none "$2" || exit 99; shift; p=$1; k=$2; shift 2; "$@"; s=$?; cp -a "$p"/. "$k"; exit $s'
            done = self.run(["unshare", "-m", "sh", "-c", script, "sh", size, str(place), str(kept), *join(place)])
            if done.returncode == 99 or b"unshare" in done.stderr:
                self.say("join: full tmpfs", name, True, "skipped: this machine does not let us mount")
            else:
                self.judge("join: full tmpfs", name, kept, done)
        for n_kib in (1, 4, 16):
            place = self.fresh()
            done = self.run(["bash", "-c", f'ulimit -f {n_kib}; exec "$@"', "bash", *join(place)])
            self.judge("join: ulimit -f", name, place, done)
        for call, error in self.CALLS.items() if shutil.which("strace") else ():
            for n in self.places_of(join(self.fresh()), call, self.dice("parts", call)):
                place = self.fresh()
                self.traced(join(place), "-o", "/dev/null", "-e", f"trace={call}", "-e", f"inject={call}:signal=KILL:when={n}")
                self.finish(f"join: killed at {call}", name, f"{call}:{n}", join(place), place, self.expected[name])
                place = self.fresh()
                done = self.traced(join(place), "-o", "/dev/null", "-e", f"trace={call}", "-e", f"inject={call}:error={error}:when={n}")
                self.judge(f"join: {call} fails", name, place, done, trial=f"{call}:{n}")
                self.finish(f"join: {call} fails", name, f"{call}:{n}", join(place), place, self.expected[name])
        for k in range(max(2, n_kills // 5)):
            if not self.wants("jobs", k):
                continue
            dice, place = self.dice("jobs", k), self.fresh()
            command = self.command(name, place, "--jobs", "2")
            for _ in range(3):
                process = subprocess.Popen(command, stdout=subprocess.DEVNULL, stderr=subprocess.PIPE)
                time.sleep(dice.uniform(0.0, 0.5))
                children = subprocess.run(["pgrep", "-P", str(process.pid)], capture_output=True, text=True).stdout.split()
                victim, number = dice.choice([(process.pid, signal.SIGKILL), (process.pid, signal.SIGINT),
                                              *[(int(child), signal.SIGKILL) for child in children]])
                try:
                    os.kill(victim, number)
                except ProcessLookupError:
                    pass
                said = process.communicate(timeout=60)[1].decode(errors="replace").strip()
                found = self.contents(place)
                right = found == self.expected[name] if process.returncode == 0 else not found or found == self.expected[name]
                right = right and (process.returncode in (0, 3, -signal.SIGKILL, -signal.SIGINT)) and said.count("\n") == 0
                self.say("jobs: one is killed", name, right, f"exit {process.returncode}, at most one line" if right else
                         f"exit {process.returncode}, left {sorted(found)}, said {said[-200:]!r} (trial jobs:{k})")
                # Children of a killed parent terminate by themselves.
                deadline = time.monotonic() + 20
                while any(os.path.exists(f"/proc/{child}") for child in children) and time.monotonic() < deadline:
                    time.sleep(0.01)
            done = self.run(command)
            left = [p.name for p in place.iterdir() if p.name.startswith(".")]
            same = done.returncode == 0 and self.contents(place) == self.expected[name] and not left
            self.say("jobs: then the same command", name, same, "the bytes of one job, and nothing else" if same else
                     f"exit {done.returncode}, left {left}, said {done.stderr[-200:]} (trial jobs:{k})")

    def room(self):
        """A run that does not fit on the disk ends early: on 2 MB, before 5 % of its frames are drawn."""
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
            right = done.returncode == 3 and b"remaining frames need about" in done.stderr
            self.say("too little room", name, right, f"exit {done.returncode} before the disk is full"
                     if right else f"exit {done.returncode} after {time.monotonic() - began:.1f} s: {done.stderr[-200:]}")


def main():
    arguments = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    arguments.add_argument("program")
    arguments.add_argument("failing_new", nargs="?")
    arguments.add_argument("quota", nargs="?")
    arguments.add_argument("--kills", type=int, default=50)
    arguments.add_argument("--seed", type=int, default=1)
    arguments.add_argument("--only", nargs="*", metavar="CASE", help="of the cases, these")
    arguments.add_argument("--trial", help="of the trials of kills, system_calls or approvals, this one")
    chosen = arguments.parse_args()
    with tempfile.TemporaryDirectory(prefix="poinsot-faults-") as folder:
        matrix = Matrix(chosen.program, pathlib.Path(folder), chosen.seed, chosen.trial)
        cases = {"full_disk": matrix.full_disk, "full_device": matrix.full_device, "limit": matrix.small_limit,
                 "quota": lambda: matrix.quota(chosen.quota),
                 "folders": matrix.closed_folders, "pipe": matrix.broken_pipe, "second_run": matrix.second_run,
                 "parts": lambda: matrix.parts(chosen.kills), "room": matrix.room, "kills": lambda: matrix.kills(chosen.kills),
                 "system_calls": matrix.system_calls, "approvals": matrix.approvals,
                 "allocation": lambda: matrix.failing_allocation(chosen.failing_new, 8)}
        for case in chosen.only or cases:
            cases[case]()
            matrix.print()
        print(f"{matrix.n_runs} outcomes with seed {chosen.seed}, {matrix.n_wrong} wrong")
        return 1 if matrix.n_wrong else 0


if __name__ == "__main__":
    sys.exit(main())
