#!/usr/bin/env python3
"""Tests films in parts on a real Slurm cluster, started here for this test: kills, a requeue, a restarted daemon.

The outputs must be byte-identical to those of a single run, and no other files may be in their folder. Prints a table; exit code 1
on any failure, 77 (skipped) with the reason if Slurm cannot be started, unless POINSOT_NEED_SLURM=1.
Usage: slurm.py POINSOT
"""
import filecmp
import os
import pathlib
import shutil
import signal
import socket
import subprocess
import sys
import tempfile
import time

SCENE = """title = "On a cluster"
[body]
moments_kg_m2 = [3.0, 2.0, 1.0]
[start]
omega_rad_s = [0.01, 2.0, 0.01]
[film]
size = [320, 180]
duration_s = 64.0
[[chapters]]
at_s = 0.0
title = "One"
[[chapters]]
at_s = 30.0
title = "Two"
"""
CONFIGURATION = """ClusterName=poinsot
SlurmctldHost={host}(127.0.0.1)
SlurmUser=root
SlurmctldPort={port}
SlurmdPort={daemon_port}
{authentication}
ProctrackType=proctrack/linuxproc
TaskPlugin=task/none
SelectType=select/cons_tres
SelectTypeParameters=CR_Core
ReturnToService=2
JobAcctGatherType=jobacct_gather/none
AccountingStorageType=accounting_storage/none
MpiDefault=none
StateSaveLocation={folder}/state
SlurmdSpoolDir={folder}/spool
SlurmctldPidFile={folder}/slurmctld.pid
SlurmdPidFile={folder}/slurmd.pid
SlurmctldLogFile={folder}/slurmctld.log
SlurmdLogFile={folder}/slurmd.log
KillWait=2
NodeName={host} NodeAddr=127.0.0.1 CPUs={cpus} State=UNKNOWN
PartitionName=all Nodes=ALL Default=YES MaxTime=INFINITE State=UP
"""


class CannotStart(Exception):
    pass


def free_port():
    with socket.socket() as probe:
        probe.bind(("127.0.0.1", 0))
        return probe.getsockname()[1]


class Slurm:
    """A cluster that consists of this machine."""

    def __init__(self, folder):
        for name in ("slurmctld", "slurmd", "sbatch", "scontrol"):
            if shutil.which(name) is None and not os.path.exists(f"/usr/sbin/{name}"):
                raise CannotStart(f"{name} is not installed (Debian: slurmctld slurmd slurm-client)")
        if os.getuid() != 0:
            raise CannotStart("slurmd runs as root only")
        if not os.path.ismount("/sys/fs/cgroup"):
            raise CannotStart("/sys/fs/cgroup is not mounted")
        self.folder = folder
        for name in ("state", "spool"):
            (folder / name).mkdir()
        host = socket.gethostname().split(".")[0]
        configuration = folder / "slurm.conf"
        configuration.write_text(CONFIGURATION.format(host=host, folder=folder, cpus=os.cpu_count(), port=free_port(),
                                                      daemon_port=free_port(), authentication=self.munge()))
        os.environ["SLURM_CONF"] = str(configuration)
        os.environ["PATH"] += ":/usr/sbin"
        self.start("slurmctld")
        self.start("slurmd")
        deadline = time.monotonic() + 60
        while "idle" not in self.ask("sinfo", "-h", "-o", "%T"):
            if time.monotonic() > deadline:
                raise CannotStart("no node became idle in 60 s: " + (folder / "slurmd.log").read_text()[-300:])
            time.sleep(0.2)

    def munge(self):
        """Starts a separate munged for authentication and returns its lines of slurm.conf. Without munge there is no
        authentication."""
        self.authentication = "none"
        if shutil.which("munged") is None and not os.path.exists("/usr/sbin/munged"):
            return "AuthType=auth/none\nCredType=cred/none"
        place = self.folder / "munge"
        place.mkdir(mode=0o711)
        key = place / "key"
        key.write_bytes(os.urandom(128))
        key.chmod(0o600)
        done = subprocess.run(["munged" if shutil.which("munged") else "/usr/sbin/munged", "--force", f"--key-file={key}",
                               f"--socket={place / 'socket'}", f"--pid-file={self.folder / 'munged.pid'}",
                               f"--log-file={place / 'log'}", f"--seed-file={place / 'seed'}"], capture_output=True, text=True)
        if done.returncode != 0:
            raise CannotStart(f"munged: {done.stderr.strip()[-300:]}")
        self.authentication = "munge"
        return f"AuthType=auth/munge\nAuthInfo=socket={place / 'socket'}\nCredType=cred/munge"

    def start(self, daemon):
        done = subprocess.run([daemon, "-f", os.environ["SLURM_CONF"]], capture_output=True, text=True)
        if done.returncode != 0:
            raise CannotStart(f"{daemon}: {done.stderr.strip()[-300:]}")

    def stop(self, daemon):
        pid_file = self.folder / f"{daemon}.pid"
        if not pid_file.exists():
            return
        pid = int(pid_file.read_text())
        try:
            os.kill(pid, signal.SIGTERM)
            deadline = time.monotonic() + 10
            while os.path.exists(f"/proc/{pid}") and time.monotonic() < deadline:
                time.sleep(0.05)
        except ProcessLookupError:
            pass

    def ask(self, *command):
        return subprocess.run(command, capture_output=True, text=True).stdout

    def wait_until_empty(self, seconds):
        deadline = time.monotonic() + seconds
        while self.ask("squeue", "-h").strip():
            if time.monotonic() > deadline:
                return False
            time.sleep(0.2)
        return True

    def end(self):
        self.ask("scancel", "--user=root")
        self.wait_until_empty(5)
        self.stop("slurmd")
        self.stop("slurmctld")
        self.stop("munged")


class Trial:
    def __init__(self, program, folder, slurm):
        self.program, self.folder, self.slurm, self.n_wrong = program, folder, slurm, 0

    def poinsot(self, *arguments, check=True):
        return subprocess.run([self.program, *map(str, arguments)], check=check, capture_output=True, text=True)

    def say(self, what, right, outcome, seconds):
        self.n_wrong += not right
        print(f"{what:58} {seconds:5.1f} s  {'' if right else 'WRONG: '}{outcome}", flush=True)

    @staticmethod
    def wait_for(question, seconds=160):
        deadline = time.monotonic() + seconds
        while time.monotonic() < deadline:
            answer = question()
            if answer:
                return answer
            time.sleep(0.02)
        return None

    def drawing(self, place):
        """Processes of poinsot that draw a part in a folder, and the names of those parts."""
        found = {}
        for process in pathlib.Path("/proc").glob("[0-9]*"):
            try:
                words = (process / "cmdline").read_bytes().split(b"\0")
            except OSError:
                continue
            if words[0] == self.program.encode() and b"--part" in words and str(place).encode() in b" ".join(words):
                found[int(process.name)] = words[words.index(b"--part") + 1].decode()
        return found

    def submit(self, *arguments):
        done = self.poinsot("submit", *arguments)
        return dict(line.split(" ", 1) for line in done.stdout.splitlines())

    def film(self):
        """Eight parts; one killed, one requeued, and the node's daemon restarted."""
        scene = self.folder / "film.toml"
        scene.write_text(SCENE)
        one = self.folder / "one"
        place = self.folder / "many"
        one.mkdir(), place.mkdir()
        self.poinsot("render", scene, "-q", "--portable", "-o", one / "film.mp4")
        began = time.monotonic()
        told = self.submit(scene, "-q", "-o", place / "film.mp4", "--parts", "8")
        killed = self.wait_for(lambda: self.drawing(place))
        if killed:
            os.kill(next(iter(killed)), signal.SIGKILL)
        # A requeued task restarts only after a delay, so it is requeued early.
        requeued = self.wait_for(lambda: [part for part in self.drawing(place).values() if part not in killed.values()])
        if requeued:
            self.slurm.ask("scontrol", "requeue", f"{told['parts']}_{requeued[0].split('/')[0]}")
        time.sleep(1)
        self.slurm.stop("slurmd")
        self.slurm.start("slurmd")
        states = self.poinsot("status", place, check=False).stdout
        # Slurm delays a requeued task for two minutes, which the test need not wait for.
        self.wait_for(lambda: self.release(told["parts"]), 90)
        empty = self.slurm.wait_until_empty(400)
        seconds = time.monotonic() - began
        self.say("film of 1,920 frames in 8 parts, 320×180", empty and filecmp.cmp(one / "film.mp4", place / "film.mp4", False)
                 if (place / "film.mp4").exists() else False, "the bytes of one run", seconds)
        self.say("  one task killed by kill -9", bool(killed), f"part {next(iter(killed.values()), '')} went on" if killed else "none ran", 0)
        self.say("  one requeued", bool(requeued), f"part {requeued[0]} went on" if requeued else "none ran", 0)
        self.say("  status while slurmd was started again", "parts" in states, states.splitlines()[0] if states else "nothing", 0)
        chapters = filecmp.cmp(one / "film.chapters.json", place / "film.chapters.json", False)
        left = sorted(p.name for p in place.iterdir())
        right = chapters and left == ["film.chapters.json", "film.mp4", "film.mp4.job"]
        self.say("  what lies in the folder", right, ", ".join(left), 0)
        left = [p.name for p in (place / "film.mp4.job" / "parts").rglob("*")]
        self.say("  parts left after the join", not left, str(len(left)), 0)
        told = self.poinsot("status", place / "film.mp4.job", check=False)
        self.say("  status in the end", told.returncode == 0 and "8 done; join done" in told.stdout, told.stdout.strip(), 0)

    def release(self, job):
        """Releases a requeued task that waits until a given time."""
        waiting = self.slurm.ask("squeue", "-h", "-r", "-j", job, "-t", "PENDING", "-o", "%i %r").split("\n")
        held = [line.split()[0] for line in waiting if "BeginTime" in line]
        for task in held:
            self.slurm.ask("scontrol", "update", f"JobId={task}", "StartTime=now")
        return held

    def stills(self):
        """A thousand tiny pictures in an array of 20."""
        scene = self.folder / "stills.toml"
        scene.write_text(SCENE)
        place = self.folder / "stills"
        place.mkdir()
        began = time.monotonic()
        self.submit(scene, "-q", "-o", place / "s_####.png", "--parts", "20", "--frames", "0-999", "--size", "64x36")
        empty = self.slurm.wait_until_empty(400)
        seconds = time.monotonic() - began
        one = self.folder / "still_frames"
        one.mkdir()
        self.poinsot("render", scene, "-q", "--portable", "--frames", "0-999", "--size", "64x36", "-o", one / "s_####.png")
        names = sorted(p.name for p in one.iterdir())
        same = all((place / name).exists() and filecmp.cmp(one / name, place / name, False) for name in names)
        left = sorted(p.name for p in place.iterdir() if p.name not in names)
        self.say("1,000 pictures of 64×36 in 20 tasks", empty and same, "the bytes of one run", seconds)
        self.say("  what else lies in the folder", left == ["s_.png.job"], ", ".join(left), 0)

    def refusals(self):
        """Checks that errors of sbatch are reported with its message, and that no job stays submitted."""
        scene = self.folder / "film.toml"
        done = self.poinsot("submit", scene, "-q", "-o", self.folder / "no.mp4", "--parts", "2", "--slurm", "--partition=none", check=False)
        queue = self.slurm.ask("squeue", "-h").strip()
        right = done.returncode == 3 and "partition" in done.stderr and done.stderr.strip().count("\n") == 0 and not queue
        self.say("a partition that is not there", right, f"exit {done.returncode}: {done.stderr.strip()[:70]}", 0)


def main():
    program = os.path.realpath(sys.argv[1])
    with tempfile.TemporaryDirectory(prefix="poinsot-slurm-", dir="/tmp") as name:
        folder = pathlib.Path(name)
        slurm = None
        try:
            (folder / "slurm").mkdir()
            slurm = Slurm.__new__(Slurm)
            slurm.folder = folder / "slurm"
            slurm.__init__(folder / "slurm")
            trial = Trial(program, folder, slurm)
            print(f"Slurm is up, daemons authenticated by {slurm.authentication}", flush=True)
            trial.film()
            trial.stills()
            trial.refusals()
        except CannotStart as reason:
            print(f"no Slurm: {reason}")
            return 1 if os.environ.get("POINSOT_NEED_SLURM") == "1" else 77
        finally:
            if slurm is not None and "SLURM_CONF" in os.environ:
                slurm.end()
    return 1 if trial.n_wrong else 0


if __name__ == "__main__":
    sys.exit(main())
