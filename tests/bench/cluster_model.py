#!/usr/bin/env python3
"""Models a film on many nodes: a simulation with times measured on one machine, as tables and one plot.

The measured and the assumed values are listed below. A node runs one task at a time; tasks are started at the scheduler's rate; a
task starts, draws its chunks, and ends. One in a hundred is a straggler; one in a hundred dies at a random moment, is requeued,
waits for Slurm's delay, and continues after its last complete chunk. After the last part the join copies all packets. The same seed
gives the same numbers.
Usage: cluster_model.py [--plot cluster.png] [--seed N]     (the plot needs python3-matplotlib; run with /usr/bin/python3)
"""
import argparse
import heapq
import random

# Measured (2026-11-22, AMD EPYC, 2 cores).
START_S = 0.13          # CPU of a process until its first frame, with cached shaders
COLD_START_S = 0.5      # the same without cached shaders, as for a node's first task
CHUNK = 120             # frames per chunk
FRAME_S = 0.033         # CPU per frame, 1920 × 1080, lecture
FRAME_BYTES = 14.4e3     # of the film, 1920 × 1080, lecture
JOIN_START_S = 0.05
JOIN_FRAME_S = 8e-6     # of the join, per frame: index and hash
JOIN_BYTE_S = 3e-9      # of the join, per byte: read twice, written once
LIBRARIES_BYTES = 150e6  # read by a node before its first frame: program, Mesa, LLVM, FFmpeg
REQUEUE_S = 120.0       # Slurm's delay of a requeued task, as measured by tests/trust/slurm.py
# Assumed.
DISPATCH_A_S = 100.0    # tasks that the scheduler starts per second, after its first wait
FIRST_WAIT_S = 5.0      # until the scheduler starts the first task
STRAGGLERS, SLOWER = 0.01, 3.0
FAILURES = 0.01
SPREAD = 0.05           # relative spread of the speeds of equal nodes

HOUR = 108_000          # frames
TABLE = {               # CPU ms per frame, by size and quality: docs/speed.md
    "1280 × 720": (8, 14, 50, 102), "1920 × 1080": (17, 29, 92, 214), "3840 × 2160": (60, 137, 365, 809)}


def parts_of(n_frames, n_parts):
    """Frames of each part: chunks are distributed evenly."""
    n_chunks = -(-n_frames // CHUNK)
    n_parts = min(n_parts, n_chunks)
    chunks = [n_chunks // n_parts + (k < n_chunks % n_parts) for k in range(n_parts)]
    return [n * CHUNK for n in chunks]


def join_s(n_frames):
    return JOIN_START_S + n_frames * (JOIN_FRAME_S + FRAME_BYTES * JOIN_BYTE_S)


def film_s(n_frames, n_nodes, n_parts, dice, stragglers=STRAGGLERS, failures=FAILURES, requeue_s=REQUEUE_S, n_films=1):
    """Wall seconds from submission to the joined film, or to the last of several such films, which are joined in parallel."""
    nodes = [(0.0, node) for node in range(n_nodes)]  # time at which each node is free
    heapq.heapify(nodes)
    cold = set(range(n_nodes))
    queue = [(0.0, k, frames) for k, frames in enumerate(parts_of(n_frames, n_parts))]  # earliest start, order, frames left
    heapq.heapify(queue)
    dispatched, end_s = FIRST_WAIT_S, 0.0
    while queue:
        earliest_s, order, frames = heapq.heappop(queue)
        free_s, node = heapq.heappop(nodes)
        dispatched = max(dispatched + 1 / DISPATCH_A_S, free_s)
        begin_s = max(dispatched, earliest_s)
        start_s = COLD_START_S if node in cold else START_S
        cold.discard(node)
        speed = max(0.5, dice.gauss(1.0, SPREAD)) / (SLOWER if dice.random() < stragglers else 1.0)
        drawn_s = frames * FRAME_S / speed
        ends_s = begin_s + start_s / speed + drawn_s
        if dice.random() < failures:
            done = dice.random()
            ends_s = begin_s + start_s / speed + done * drawn_s
            left = frames - int(done * frames) // CHUNK * CHUNK
            heapq.heappush(queue, (ends_s + requeue_s, order, left))
        else:
            end_s = max(end_s, ends_s)
        heapq.heappush(nodes, (ends_s, node))
    return end_s + join_s(n_frames / n_films)


def median(make, seed, n=25):
    return sorted(make(random.Random(f"{seed}:{k}")) for k in range(n))[n // 2]


def print_start_share():
    print("Share of the processor time that starting takes, of an hour of film (108,000 frames), warm / cold")
    print(f"{'size, lecture':14}" + "".join(f"{n:>18,} parts" for n in (10, 100, 900)))
    for size, row in TABLE.items():
        drawn_s = HOUR * row[1] * 1e-3
        shares = [[100 * n * start / (drawn_s + n * start) for start in (START_S, COLD_START_S)] for n in (10, 100, 900)]
        print(f"{size:14}" + "".join(f"{warm:15.2f} / {cold:.2f} %" for warm, cold in shares))
    print(f"A film of ten minutes at 320 × 180 (2.3 ms a frame) in 150 parts: {100 * 150 * START_S / (18000 * 0.0023 + 150 * START_S):.0f} %")


def print_nodes(seed):
    one_s = START_S + HOUR * FRAME_S
    print(f"\nAn hour at 1920 × 1080, lecture: {one_s / 60:.0f} min on one core. Minutes, and how many times as fast:")
    print(f"{'nodes':>6} {'parts':>6} {'nothing goes wrong':>20} {'stragglers':>18} {'and failures':>18} {'… gone on with at once':>24}")
    found = {}
    for n_nodes in (1, 10, 30, 100, 300, 1000):
        n_parts = min(900, n_nodes)
        row = [median(lambda dice: film_s(HOUR, n_nodes, n_parts, dice, 0, 0), seed),
               median(lambda dice: film_s(HOUR, n_nodes, n_parts, dice, STRAGGLERS, 0), seed),
               median(lambda dice: film_s(HOUR, n_nodes, n_parts, dice), seed),
               median(lambda dice: film_s(HOUR, n_nodes, n_parts, dice, requeue_s=0.0), seed)]
        found[n_nodes] = row
        print(f"{n_nodes:6} {n_parts:6}" + "".join(f"{s / 60:12.2f} {one_s / s:5.0f} ×" for s in row))
    return one_s, found


def print_course(seed):
    films = 40
    one_s = films * HOUR * FRAME_S
    many = [median(lambda dice: film_s(films * HOUR, 1000, n_parts, dice, n_films=films), seed, 5) for n_parts in (1000, 4000, 36000)]
    print(f"\nForty such films on 1,000 nodes ({one_s / 3600:.0f} h on one core), as one submission: "
          + ", ".join(f"{n:,} parts {s / 60:.1f} min ({one_s / s:.0f} ×)" for n, s in zip((1000, 4000, 36000), many)))


def print_file_system():
    print("\nWhat 1,000 nodes ask of one file system")
    print(f"  all start at once: {1000 * LIBRARIES_BYTES / 1e9:.0f} GB read, unless the program lies on the nodes")
    print(f"  drawing: {1000 * FRAME_BYTES / FRAME_S / 1e6:.0f} MB/s written, {1000 / FRAME_S:,.0f} writes a second of some 14 kB each")
    print(f"  the join: {HOUR * FRAME_BYTES / 1e6:.0f} MB read twice and written once, {join_s(HOUR):.1f} s")
    print(f"  a task makes and renames 1 file of film, and 3 of state: {4 * DISPATCH_A_S:.0f} a second while they are handed out")


def plot(file, one_s, found):
    import matplotlib
    matplotlib.use("Agg")
    from matplotlib import pyplot
    figure, axes = pyplot.subplots(figsize=(8, 4.5), dpi=100)
    nodes = list(found)
    axes.plot(nodes, nodes, color="0.6", linestyle=":", label="as many times as nodes")
    for k, (label, line) in enumerate((("nothing goes wrong", "o-"), ("1 % stragglers, three times as slow", "s-"),
                                       ("and 1 % failures, requeued after 2 min", "^-"),
                                       ("the same, gone on with at once, as task.sh does", "v--"))):
        axes.plot(nodes, [one_s / found[n][k] for n in nodes], line, label=label)
    axes.axvline(900, color="0.8", linestyle="--")
    axes.text(880, 1.3, "900 chunks", rotation=90, ha="right", va="bottom", fontsize=8, color="0.4")
    axes.set(xscale="log", yscale="log", xlabel="nodes, a task each", ylabel="times as fast as one core",
             title="An hour of film, 1920 × 1080, lecture: simulated over measured times")
    axes.set_xticks(nodes, [f"{n:,}" for n in nodes])
    axes.minorticks_off()
    axes.grid(alpha=0.3)
    axes.legend(fontsize=8)
    figure.tight_layout()
    figure.savefig(file)
    print(f"\nplot: {file}")


def main():
    arguments = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    arguments.add_argument("--plot")
    arguments.add_argument("--seed", type=int, default=1)
    chosen = arguments.parse_args()
    print_start_share()
    one_s, found = print_nodes(chosen.seed)
    print_course(chosen.seed)
    print_file_system()
    if chosen.plot:
        plot(chosen.plot, one_s, found)


if __name__ == "__main__":
    main()
