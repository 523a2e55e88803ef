"""Threads, forks, interrupts and the ends of things; each in a process of its own, so that a crash or a hang fails.

The slow form of the test of memory, 10,000 stills, is the test python.memory: POINSOT_STILLS=10000.
"""
import os
import sys

import pytest

UNDER_SANITIZER = "libasan" in os.environ.get("LD_PRELOAD", "")

# A process draws its first picture in about 0.3 s; all waits below are at least 10 times what they take.
HEAD = """
import gc, os, signal, sys, threading, time
import numpy as np
import poinsot

SIZE = (64, 36)
scene = poinsot.Scene("generic")

def drawn(time_s=0.5, **options):
    return scene.still(time_s, size=SIZE, **options)
"""


def test_four_threads_draw_what_one_draws(in_process):
    assert in_process(HEAD + """
from concurrent.futures import ThreadPoolExecutor
jobs = [(name, i / 4) for name in ("generic", "sphere", "symmetric_oblate") for i in range(8)]

def draw(job):
    name, time_s = job
    if job[1] == 0.5:
        poinsot.Scene(name).sample(np.linspace(0, 10, 1000))
    return poinsot.Scene(name).still(time_s, size=SIZE).png

one = [draw(job) for job in jobs]
with ThreadPoolExecutor(4) as pool:
    four = list(pool.map(draw, jobs))
assert four == one and len(set(one)) == len(jobs)
with ThreadPoolExecutor(4) as pool:  # of one scene
    assert len(set(pool.map(lambda _: drawn().png, range(16)))) == 1
print("done")
""") == "done\n"


def test_threads_sample_what_one_samples(in_process):
    assert in_process(HEAD + """
from concurrent.futures import ThreadPoolExecutor
stepped = poinsot.Scene("euler_drift")
motion = poinsot.Motion([1, 2, 3], [0.1, 2, 0.3])
times = np.linspace(0, 5, 2000)
asked = [lambda: scene.sample(times)["q"], lambda: stepped.sample(times)["q"], lambda: motion.at(times).omega_body] * 4
one = [ask() for ask in asked]
with ThreadPoolExecutor(4) as pool:
    four = list(pool.map(lambda ask: ask(), asked))
assert all(np.array_equal(a, b) for a, b in zip(one, four))
print("done")
""") == "done\n"


@pytest.mark.parametrize("n_threads", [0, 1, 3])
def test_the_interpreter_ends_after_and_while_threads_draw(in_process, n_threads):
    for _ in range(3):
        assert in_process(HEAD + """
drawn()

def draw():
    while True:
        drawn()
        scene.sample(np.linspace(0, 1, 20_000))

for _ in range(int(sys.argv[1])):
    threading.Thread(target=draw, daemon=True).start()
time.sleep(0.5)
print("end")
""", n_threads) == "end\n"


def test_the_interpreter_does_not_wait_for_a_film_of_a_daemon_thread(in_process):
    # The film takes hours.
    assert in_process(HEAD + """
begun = threading.Event()
long = poinsot.Scene("generic", {"film.duration_s": 36000})

class Progress:
    def __init__(self, *unused): self.notes = []
    def __enter__(self): return self
    def __exit__(self, *unused): pass
    def say(self, line): pass
    def frames(self, done, n):
        if done > 0: begun.set()

import poinsot.scene
poinsot.scene.Progress = Progress
threading.Thread(target=lambda: long.render("long.mp4", size=(64, 36)), daemon=True).start()
assert begun.wait(200)
print("end")
""", timeout_s=300) == "end\n"


def test_a_film_of_an_ordinary_thread_is_finished(in_process, tmp_path):
    in_process(HEAD + """
threading.Thread(target=lambda: scene.render("film.mp4", size=SIZE, frames=(0, 20), progress=False)).start()
""")
    assert (tmp_path / "film.mp4").stat().st_size > 1000
    assert [file.name for file in tmp_path.iterdir() if "part" in file.name] == []


def test_drawing_and_then_exiting_at_once_is_safe(in_process):
    for end in ("sys.exit()", "os._exit(0)", "raise SystemExit(0)", "del scene, poinsot; gc.collect()"):
        in_process(HEAD + "still = drawn()\n" + end + "\n")


FORKED = HEAD + """
import multiprocessing

def worker(_):
    try:
        return drawn().png
    except poinsot.EnvironmentError as error:
        return str(error)

def others(_):
    return scene.figure(size=SIZE).svg, scene.sample([0.0, 1.0])["q"].tolist()

def in_pool(method, work):
    with multiprocessing.get_context(method).Pool(2) as pool:
        return pool.map_async(work, range(4)).get(250)
"""


def test_forked_workers_draw_if_the_parent_did_not(in_process):
    assert in_process(FORKED + """
if __name__ == "__main__":
    forked = in_pool("fork", worker)
    assert forked == [drawn().png] * 4
    print("done")
""") == "done\n"


def test_forked_workers_of_a_parent_that_drew_say_so_and_do_the_rest(in_process):
    said = in_process(FORKED + """
if __name__ == "__main__":
    here = worker(0)
    forked = in_pool("fork", worker)
    assert len(set(forked)) == 1
    print(forked[0])
    assert in_pool("fork", others) == [others(0)] * 4
    assert worker(0) == here
""")
    assert said.startswith("this process was forked from one that had drawn pictures") and "spawn" in said


def test_spawned_workers_draw(in_process):
    assert in_process(FORKED + """
if __name__ == "__main__":
    here = worker(0)
    assert in_pool("spawn", worker) == [here] * 4
    print("done")
""") == "done\n"


def test_a_forked_process_ends_as_usual(in_process):
    # Mesa's own handler at exit would wait for threads that the fork does not have.
    assert in_process(HEAD + """
drawn()
child = os.fork()
if child == 0:
    sys.stdout.write("child\\n")
    sys.exit(7)
assert os.waitstatus_to_exitcode(os.waitpid(child, 0)[1]) == 7
print("parent")
""") == "child\nparent\n"


@pytest.mark.skipif(UNDER_SANITIZER, reason="a fork may find the sanitizer's own locks held")
def test_a_fork_while_another_thread_draws_does_not_hang(in_process):
    assert in_process(HEAD + """
stop = threading.Event()

def draw():
    while not stop.is_set():
        drawn()

drawn()
thread = threading.Thread(target=draw)
thread.start()
for _ in range(20):
    child = os.fork()
    if child == 0:
        try:
            scene.sample([0.0])
            drawn()
        except poinsot.EnvironmentError:
            sys.exit(7)  # runs what the interpreter does at its end
        os._exit(1)
    if os.waitstatus_to_exitcode(os.waitpid(child, 0)[1]) != 7:
        os._exit(1)
stop.set()
thread.join()
print("done")
sys.stdout.flush()
""") == "done\n"


def test_an_interrupt_stops_a_long_film_which_then_continues(in_process, tmp_path):
    # Without the interrupt it takes hours; after it, the rest of a short one is drawn.
    said = in_process(HEAD + """
long = poinsot.Scene("generic", {"film.duration_s": 36000})
import poinsot.scene

class Progress(poinsot.scene.Progress):
    sent = None
    def frames(self, done, n):
        if done >= 10 and Progress.sent is None:
            Progress.sent = time.monotonic()
            os.kill(os.getpid(), signal.SIGINT)

poinsot.scene.Progress = Progress
try:
    long.render("long.mp4", size=SIZE)
except KeyboardInterrupt:
    print("interrupted", file=sys.stderr)
else:
    sys.exit("not interrupted")
assert time.monotonic() - Progress.sent < 60, time.monotonic() - Progress.sent

def stop_later(self, done, n):
    if done >= 10:
        raise RuntimeError("stop")

Progress.frames = stop_later
try:
    scene.render("short.mp4", size=SIZE, frames=(0, 40))
except RuntimeError as error:
    assert str(error) == "stop"
else:
    sys.exit("the exception of the callback was lost")
counts = []
Progress.frames = lambda self, done, n: counts.append(done)
scene.render("short.mp4", size=SIZE, frames=(0, 40))
scene.render("whole.mp4", size=SIZE, frames=(0, 40))
same = open("short.mp4", "rb").read() == open("whole.mp4", "rb").read()
print(same)
""", timeout_s=400)
    assert said == "True\n"


def test_an_interrupt_stops_one_thread_s_work_and_no_other(in_process):
    assert in_process(HEAD + """
# The main thread is interrupted while it waits for its turn or draws; the others go on.
stop, faults, n_drawn = threading.Event(), [], [0]

def draw():
    while not stop.is_set():
        try:
            drawn()
            n_drawn[0] += 1
        except Exception as error:
            faults.append(error)

threads = [threading.Thread(target=draw) for _ in range(2)]
for thread in threads: thread.start()
long = poinsot.Scene("generic", {"film.duration_s": 36000})
for _ in range(10):
    threading.Timer(0.2, lambda: os.kill(os.getpid(), signal.SIGINT)).start()
    try:
        long.render("long.mp4", size=SIZE, progress=False)
        sys.exit("not interrupted")
    except KeyboardInterrupt:
        pass
stop.set()
for thread in threads: thread.join()
assert not faults, faults
assert n_drawn[0] > 0
print("done")
""", timeout_s=300) == "done\n"


def test_exceptions_of_callbacks_are_raised_by_the_call(in_process):
    assert in_process(HEAD + """
import poinsot.scene
for method in ("say", "frames"):
    class Progress(poinsot.scene.Progress):
        pass
    def fail(self, *unused):
        raise LookupError(method)
    setattr(Progress, method, fail)
    poinsot.scene.Progress = Progress
    for _ in range(3):
        try:
            scene.render("film.mp4", size=SIZE, frames=(0, 60))
        except LookupError as error:
            assert str(error) == repr(method) or str(error) == method
        else:
            sys.exit(method + ": lost")
assert drawn().pixels.any()
print("done")
""") == "done\n"


def test_arrays_outlive_what_they_came_from(in_process):
    assert in_process(HEAD + """
still = drawn()
pixels, copy = still.pixels, still.pixels.copy()
states = poinsot.Motion([1, 2, 3], [0.1, 2, 0]).at(np.linspace(0, 1, 1000))
omega, omega_copy = states.omega_body, states.omega_body.copy()
herpolhode = states.herpolhode
times = np.linspace(0, 1, 1000)
q = scene.sample(times)["q_w"]
q_copy = q.copy()
at = poinsot.Motion([1, 2, 3], [0.1, 2, 0]).at
figure = poinsot.Scene("sphere").figure(size=SIZE)
comparison = poinsot.compare(still, drawn(2.5))
difference, difference_copy = comparison.difference, comparison.difference.copy()
del still, states, comparison, scene, times
gc.collect()
churn = [np.random.bytes(len(copy.tobytes())) for _ in range(200)]
assert np.array_equal(pixels, copy) and np.array_equal(omega, omega_copy) and np.array_equal(q, q_copy)
assert np.array_equal(difference, difference_copy)
assert np.isfinite(herpolhode).all()
assert at(0.0).omega_body.tolist() == [0.1, 2.0, 0.0]
assert figure.pdf.startswith(b"%PDF")
assert pixels.max() > 0 and not pixels.flags.writeable  # the still's PNG has a record that describes them
print("done")
""") == "done\n"


def test_stills_do_not_grow_the_memory(in_process):
    n = int(os.environ.get("POINSOT_STILLS", "300"))
    # A still of 64 × 36 has 9 kB of pixels and 6 kB of PNG: kept, 300 of them would be 4.5 MB; their scenes more. The heap's own
    # breathing is below 2 MB here.
    grown = int(in_process(HEAD + """
def resident_bytes():
    gc.collect()
    with open("/proc/self/statm") as file:
        return int(file.read().split()[1]) * os.sysconf("SC_PAGESIZE")

def work(i):
    still = poinsot.Scene("sphere", {"start.omega_rad_s": [0.1, 2.0, 0.01 * (i % 7)]}).still(0.1 * (i % 13), size=(320, 180))
    still.pixels.sum(), still.png, np.asarray(still)
    scene.sample(np.linspace(0, 1, 1000))
    try:
        scene.set({"film.sise": 1})
    except poinsot.InputError:
        pass

for i in range(100):
    work(i)
before = resident_bytes()
for i in range(int(sys.argv[1])):
    work(i)
print(resident_bytes() - before)
""", n, timeout_s=max(300, n)))
    # One still of 320 × 180 is 230 kB: 300 that are kept are 69 MB.
    assert grown < 20e6, f"{grown / 1e6:.1f} MB more after {n} stills"


@pytest.mark.skipif(UNDER_SANITIZER, reason="the sanitizer ends a process that asks for too much memory")
def test_enormous_input_raises_and_does_not_crash(in_process):
    # With less memory than the arrays need.
    assert in_process(HEAD + """
import resource
drawn()
resource.setrlimit(resource.RLIMIT_AS, (4 << 30, 4 << 30))

def refused(work, *kinds):
    try:
        work()
    except kinds or (poinsot.InputError, poinsot.EnvironmentError, MemoryError) as error:
        assert "\\n" not in str(error), error
        return
    sys.exit(f"accepted: {work}")

body = {"body": {"moments_kg_m2": [1, 2, 3]}, "start": {"omega_rad_s": [0.1, 2, 0]}}
refused(lambda: poinsot.Scene({**body, "panels": [{"show": ["polhode"]}] * 1_000_000}).still(size=SIZE))
refused(lambda: poinsot.Scene("[body]\\n" + "[" * 1_000_000))
refused(lambda: poinsot.Scene("a = " + "[" * 1_000_000))
refused(lambda: scene.still(size=(65536, 65536)))
for size in ((0, 1), (-1, -1), (10**9, 10**9), (65537, 1)):
    refused(lambda: scene.still(size=size), poinsot.InputError)
billion = np.broadcast_to(0.0, (10**9,))
refused(lambda: scene.sample(billion))
refused(lambda: poinsot.Motion([1, 2, 3], [0.1, 2, 0]).at(billion))
refused(lambda: poinsot.Motion([1, 2, 3], [0.1, 2, 0]).herpolhode(billion))
refused(lambda: poinsot.Motion([1, 2, 3], [0.1, 2, 0]).certificate(billion))
refused(lambda: scene.sample(np.broadcast_to(0.0, (2**40, 2**12))))
refused(lambda: poinsot.compare(np.broadcast_to(np.uint8(0), (60_000, 60_000)), np.zeros((1, 1), np.uint8)))
assert drawn().pixels.any()
print("done")
""", timeout_s=500) == "done\n"


def test_a_second_interpreter_in_the_process_is_no_crash(in_process):
    interpreters = pytest.importorskip("_xxsubinterpreters") if sys.version_info < (3, 13) else None
    if interpreters is None:
        pytest.skip("subinterpreters have another name")
    # NumPy may refuse a second interpreter; the first one goes on.
    assert in_process(HEAD + """
import _xxsubinterpreters
drawn()
other = _xxsubinterpreters.create()
try:
    _xxsubinterpreters.run_string(other, "import poinsot; poinsot.Scene('generic').name")
except Exception:
    pass
assert drawn().pixels.any()
print("done")
sys.stdout.flush()
""") == "done\n"


def test_a_fork_while_another_thread_opens_a_scene_does_not_hang(in_process):
    assert in_process(HEAD + """
slow = poinsot.Scene("generic", {"motion.method": "rk4", "motion.step_s": 2e-6})
thread = threading.Thread(target=slow.check)
thread.start()
time.sleep(0.3)
child = os.fork()
if child == 0:
    slow.sample([0.0])
    os._exit(7)
print(os.waitstatus_to_exitcode(os.waitpid(child, 0)[1]))
thread.join()
""") == "7\n"


def test_a_fork_while_the_first_picture_is_drawn_is_told(in_process):
    assert in_process(HEAD + """
begun, forked = threading.Event(), threading.Event()

def wait_for_the_fork(n_done, n_frames):
    begun.set()
    forked.wait()

film = poinsot.Scene("generic", {"film.size": [64, 36], "film.duration_s": 60.0})._native
thread = threading.Thread(target=film.render, args=("film.mp4", {}, None, wait_for_the_fork))
thread.start()
begun.wait()
child = os.fork()
if child == 0:
    try:
        drawn()
    except poinsot.EnvironmentError:
        os._exit(7)
    os._exit(8)
print(os.waitstatus_to_exitcode(os.waitpid(child, 0)[1]))
forked.set()
thread.join()
""") == "7\n"


@pytest.mark.parametrize("call", ["slow.sample([0.0])", "slow.check()", "slow.still(0.5, size=SIZE)", "slow.figure()",
                                  "poinsot.Motion([1, 2, 3], [1, 2, 3], method='rk4', step_s=1e-7, span_s=(0, 50))"])
def test_an_interrupt_stops_the_stepping_of_a_motion(in_process, call):
    """One that takes far longer than the test would."""
    assert in_process(HEAD + f"""
slow = poinsot.Scene("generic", {{"motion.method": "rk4", "motion.step_s": 1e-7, "film.duration_s": 6.0}})
threading.Timer(0.5, os.kill, (os.getpid(), signal.SIGINT)).start()
try:
    {call}
except KeyboardInterrupt:
    print("stopped")
""", timeout_s=60.0) == "stopped\n"


def test_stopping_a_film_stops_no_stepping_of_other_threads(in_process):
    assert in_process(HEAD + """
film = poinsot.Scene("generic", {"film.size": [1920, 1080]})._native

def stop(n_done, n_frames):
    raise ValueError("mine")

def render():
    try:
        film.render("film.mp4", None, "auto", False, None, stop)
    except ValueError:
        pass

thread = threading.Thread(target=render)
thread.start()
while thread.is_alive():
    poinsot.Scene("generic", {"motion.method": "rk4", "motion.step_s": 0.01}).sample([0.0, 1.0])
print("done")
""") == "done\n"


@pytest.mark.parametrize("call", ["poinsot.Motion([4, 3, 1.5], [1, 2, 3], method='rk4', step_s=1e-7, span_s=(0, 50))", "slow.check()"])
def test_the_interpreter_does_not_wait_for_the_stepping_of_a_daemon_thread(in_process, call):
    """It takes far longer than the test would."""
    assert in_process(HEAD + f"""
slow = poinsot.Scene("generic", {{"motion.method": "rk4", "motion.step_s": 1e-7, "film.duration_s": 6.0}})
threading.Thread(target=lambda: {call}, daemon=True).start()
time.sleep(0.3)
print("end")
""", timeout_s=60.0) == "end\n"


@pytest.mark.parametrize("prepare, call", [
    ("top = poinsot.Motion.heavy_top(1.0, 0.5, 2.0, theta_rad=0.5, omega3_rad_s=20.0); times = np.linspace(0, 1, 3_000_000)",
     "top.at(times)"),
    ("body = poinsot.Motion([1, 2, 3], [0.1, 2, 0.3]); times = np.linspace(0, 1, 3_000_000)", "body.herpolhode(times)"),
    ("from poinsot import _poinsot; a = np.random.default_rng(1).integers(0, 255, (1200, 1200, 4), np.uint8);"
     "[open(name, 'wb').write(_poinsot.png_of(pixels)) for name, pixels in (('a.png', a), ('b.png', a[::-1].copy()))]",
     "poinsot.compare('a.png', 'b.png', measures=True)"),
    ("times = np.arange(0, 200, 0.01); omega = poinsot.Motion([3, 2, 1], [0.3, 6, 0.2]).at(times).omega_body;"
     "omega += np.random.default_rng(1).normal(0, 0.1, omega.shape)", "poinsot.fit(times, omega, drag='axes')"),
])
def test_an_interrupt_stops_long_calls(in_process, prepare, call):
    """In less than half of the time that the call takes the processor."""
    assert in_process(HEAD + f"""
{prepare}
began = time.process_time()
{call}
whole_s = time.process_time() - began
threading.Timer(0.1 * whole_s, os.kill, (os.getpid(), signal.SIGINT)).start()
began = time.process_time()
try:
    {call}
    time.sleep(10)
    print("not interrupted")
except KeyboardInterrupt:
    spent_s = time.process_time() - began
    print("stopped" if spent_s < 0.5 * whole_s else f"after {{spent_s}} of {{whole_s}} s")
""") == "stopped\n"


@pytest.mark.parametrize("streams", ["sys.stderr = None", "sys.stdout = sys.stderr = None"])
def test_a_film_needs_no_standard_streams(in_process, tmp_path, streams):
    """Programs without a terminal, such as those of pythonw, have none."""
    in_process(HEAD + streams + """
scene.render("film.gif", size=SIZE, frames=(0, 5))
""")
    assert (tmp_path / "film.gif").stat().st_size > 100


def test_a_closed_stderr_does_not_become_a_file(in_process):
    assert in_process(HEAD + """
import subprocess
code = "import os; from poinsot import _poinsot; print(os.open('/dev/null', os.O_RDONLY) > 2)"
print(subprocess.run(["sh", "-c", 'exec "$0" -c "$1" 2>&-', sys.executable, code], capture_output=True, text=True).stdout, end="")
""") == "True\n"


def test_no_object_of_the_module_is_without_its_contents(in_process):
    assert in_process(HEAD + """
import copy
from poinsot import _poinsot
for kind in (_poinsot.Motion, _poinsot.Scene, _poinsot.Still, _poinsot.States):
    for make in (lambda: kind.__new__(kind), kind, lambda: object.__new__(kind), lambda: type("Mine", (kind,), {})()):
        try:
            make()
        except TypeError as error:
            assert "\\n" not in str(error), error
        else:
            sys.exit(f"made: {kind}")
for native in (scene._native, drawn()._drawn, poinsot.Motion([1, 2, 3], [0.1, 2, 0])._native):
    try:
        copy.copy(native)
    except TypeError:
        continue
    sys.exit(f"copied: {native}")
print("done")
""") == "done\n"
