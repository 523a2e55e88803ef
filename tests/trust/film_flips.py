#!/usr/bin/env python3
"""Random bits of films are flipped: `explain --verify` sees each, and `compare` sees each that ffprobe sees.

Half of the bits lie anywhere in the file, half outside of the coded pictures: in headers, tables of times, index, texts and record. A film
that `explain --verify` calls unchanged must have the same frames, times, matrix, sizes, colours and durations as before, by ffprobe and by
ffmpeg's decoders. `compare` must call no film "same" whose pictures, by ffprobe, are different, turned or stretched, or
are shown more than half a frame earlier or later.
Usage: film_flips.py POINSOT [--seed N] [--flips N] [--compared N] [--only FORMAT]
Exits with 77 if ffprobe or ffmpeg is not installed.
"""
import argparse
import concurrent.futures
import hashlib
import json
import os
import pathlib
import random
import shutil
import subprocess
import sys
import tempfile

SCENE = """
[body]
moments_kg_m2 = [4.0, 3.0, 1.5]
[start]
omega_rad_s = [0.02, 2.0, 0.05]
[film]
duration_s = 1.0
fps = 15
size = [64, 36]
quality = "draft"
[[chapters]]
at_s = 0.0
title = "One"
[[chapters]]
at_s = 0.5
title = "Two"
[[captions]]
at_s = 0.1
over_s = 0.4
text = "Here"
"""
FPS = 15
UPRIGHT = ["65536", "0", "0", "0", "65536", "0", "1073741824"]
FORMATS = ["mp4", "mov", "webm", "gif"]
# What a player shows of a frame, of a stream and of the film.
OF_FRAME = ["media_type", "pts_time", "best_effort_timestamp_time", "duration_time", "pkt_duration_time", "width", "height",
            "sample_aspect_ratio", "color_range", "color_space", "color_primaries", "color_transfer"]
OF_STREAM = ["codec_type", "codec_name", "width", "height", "sample_aspect_ratio", "display_aspect_ratio", "color_range", "color_space",
             "color_primaries", "color_transfer", "chroma_location", "field_order", "r_frame_rate", "avg_frame_rate", "start_time",
             "duration"]
# Those of its pictures alone.
OF_PICTURE = ["pts_time", "width", "height", "sample_aspect_ratio"]
OF_SHAPE = ["sample_aspect_ratio"]


def run(command, **options):
    return subprocess.run(command, stdout=subprocess.PIPE, stderr=subprocess.PIPE, timeout=120, **options)


def probe(film, *asked):
    done = run(["ffprobe", "-v", "quiet", "-of", "json", *asked, str(film)])
    try:
        return json.loads(done.stdout or b"{}")
    except ValueError:
        return {}


def pictures_of(film):
    """A hash of each decoded picture, or what stands for a film that cannot be decoded."""
    done = run(["ffmpeg", "-v", "quiet", "-noautorotate", "-i", str(film), "-map", "0:v:0", "-fps_mode", "passthrough", "-f", "framemd5", "-"])
    lines = [line.split(",")[-1].strip() for line in done.stdout.decode().splitlines() if line and line[0] != "#"]
    return lines if done.returncode == 0 else [f"ffmpeg: {done.returncode}"]


def said_of(item, keys):
    """What ffprobe says of a stream or a frame; of what lies beside it, the matrix that turns pictures."""
    said = {key: item.get(key) for key in keys}
    said["side_data_list"] = [data for data in item.get("side_data_list", []) if data.get("side_data_type") == "Display Matrix"]
    return said


def shown(film):
    """All that a player shows, as far as FFmpeg knows it."""
    said = probe(film, "-show_streams", "-show_format", "-show_chapters", "-show_frames")
    return {"frames": [said_of(frame, OF_FRAME) for frame in said.get("frames", [])],
            "streams": [said_of(stream, OF_STREAM) for stream in said.get("streams", [])],
            "chapters": said.get("chapters"),
            "duration": said.get("format", {}).get("duration"),
            "pictures": pictures_of(film)}


def matrices_of(said):
    """The matrices that turn pictures, without where they put them, which players choose."""
    matrices = []
    for data in said["side_data_list"]:
        numbers = [line.split(":")[1].split() for line in data.get("displaymatrix", "").splitlines() if ":" in line]
        matrices.append([*numbers[0], *numbers[1], numbers[2][2]])
    return [matrix for matrix in matrices if matrix != UPRIGHT]


def shown_pictures(film):
    """Pictures, when and in what shape they are shown."""
    said = probe(film, "-select_streams", "v:0", "-show_frames", "-show_streams")
    frames = [said_of(frame, OF_PICTURE) for frame in said.get("frames", [])]
    streams = [said_of(stream, OF_SHAPE) for stream in said.get("streams", [])]
    times = [float(frame.pop("pts_time") or "nan") for frame in frames]
    for item in frames + streams:
        item["side_data_list"] = matrices_of(item)
        if item["sample_aspect_ratio"] in (None, "0:1"):
            item["sample_aspect_ratio"] = "1:1"  # what players assume
    return times, (frames, streams, pictures_of(film))


def are_shown_alike(one, other):
    """Whether two films show the same pictures, each within half a frame of the same instant."""
    return (one[1] == other[1] and len(one[0]) == len(other[0]) and
            all(abs(a - b) <= 0.5 / FPS for a, b in zip(one[0], other[0])))


def places_of_pictures(film):
    """The bytes that packets of pictures take."""
    places = []
    for packet in probe(film, "-select_streams", "v:0", "-show_entries", "packet=pos,size").get("packets", []):
        if "pos" in packet:
            places.append((int(packet["pos"]), int(packet["pos"]) + int(packet["size"])))
    return places


def chosen_flips(film, n_flips, chance):
    n_bytes = film.stat().st_size
    inside = places_of_pictures(film)
    outside = [byte for byte in range(n_bytes) if not any(begin <= byte < end for begin, end in inside)]
    return [(chance.randrange(n_bytes) if k % 2 else chance.choice(outside), chance.randrange(8)) for k in range(n_flips)]


def try_flip(poinsot, folder, film, bytes_of_film, before, flip, number, compares):
    """What is wrong, whether it was seen, and whether ffprobe sees it (None: it was not asked)."""
    changed = bytearray(bytes_of_film)
    changed[flip[0]] ^= 1 << flip[1]
    file = folder / f"{number}{film.suffix}"
    file.write_bytes(changed)
    try:
        done = run([poinsot, "explain", "--verify", str(file)])
        if done.returncode not in (0, 1, 2):
            return f"exit code {done.returncode} of explain --verify", None, None
        is_seen = done.returncode != 0
        if not is_seen and shown(file) != before["all"]:
            return "explain --verify calls it unchanged, and ffprobe sees a change", is_seen, True
        if not compares:
            return None, is_seen, None
        is_shown = not are_shown_alike(shown_pictures(file), before["pictures"])
        done = run([poinsot, "compare", str(film), str(file)])
        if done.returncode not in (0, 1, 2):
            return f"exit code {done.returncode} of compare", is_seen, is_shown
        if is_shown and done.returncode == 0:
            return "compare calls it the same, and ffprobe sees a change: " + done.stdout.decode().strip(), is_seen, is_shown
        return None, is_seen, is_shown
    finally:
        file.unlink()


def main():
    options = argparse.ArgumentParser()
    options.add_argument("poinsot")
    options.add_argument("--seed", type=int, default=47)
    options.add_argument("--flips", type=int, default=2000)
    options.add_argument("--compared", type=int, default=200)
    options.add_argument("--only", choices=FORMATS)
    chosen = options.parse_args()
    if not shutil.which("ffprobe") or not shutil.which("ffmpeg"):
        print("ffprobe or ffmpeg is not installed")
        sys.exit(77)
    n_wrong = 0
    print("| film | bytes | bits flipped | seen by explain --verify | compared | of these shown otherwise | wrong |\n|---|---|---|---|---|---|---|")
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        (folder / "scene.toml").write_text(SCENE)
        for kind in [chosen.only] if chosen.only else FORMATS:
            film = folder / f"film.{kind}"
            subprocess.run([chosen.poinsot, "render", str(folder / "scene.toml"), "-q", "-o", str(film)], check=True)
            subprocess.run([chosen.poinsot, "explain", "--verify", str(film)], check=True, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
            before = {"all": shown(film), "pictures": shown_pictures(film)}
            seed = int.from_bytes(hashlib.sha256(f"{chosen.seed} {kind}".encode()).digest()[:8], "big")
            flips = chosen_flips(film, chosen.flips, random.Random(seed))
            bytes_of_film = film.read_bytes()
            with concurrent.futures.ThreadPoolExecutor(os.cpu_count()) as pool:
                answers = list(pool.map(lambda item: try_flip(chosen.poinsot, folder, film, bytes_of_film, before, item[1], item[0],
                                                              item[0] < chosen.compared), enumerate(flips)))
            wrong = [(flip, answer[0]) for flip, answer in zip(flips, answers) if answer[0]]
            for (byte, bit), what in wrong:
                print(f"film.{kind}, bit {bit} of byte {byte}: {what}", file=sys.stderr)
            n_wrong += len(wrong)
            compared = answers[:chosen.compared]
            print(f"| {kind} | {len(bytes_of_film)} | {len(flips)} | {sum(bool(answer[1]) for answer in answers)} | {len(compared)} | "
                  f"{sum(bool(answer[2]) for answer in compared)} | {len(wrong)} |", flush=True)
    sys.exit(1 if n_wrong else 0)


main()
