#!/usr/bin/env python3
"""Tests that frame k of a film is frame k: a function of the scene and k alone.

Draws a run of frames of each scene, then the same frames in runs that begin and end elsewhere: the pixels are those of the long run, byte
for byte. Some scenes are drawn in every other way, too: by several processes, in parts that are joined, as films, as slides and as the
stills of their chapters. The scenes are all of the gallery, and random ones with keyframes, fades, captions, chapters, panels and stops, at
odd sizes and rates, portable and native. Random choices follow from the seed, separately for each scene; a scene of the gallery is drawn
in the other profile with the next seed, or in both with --both.
Usage: frame_starts.py POINSOT SCENES [--seed N] [--random N] [--both] [--quick] [--only NAME]
"""
import argparse
import concurrent.futures
import fractions
import json
import os
import pathlib
import random
import re
import shutil
import struct
import subprocess
import sys
import tempfile
import tomllib

ENDLESS = 10**7 - 1  # no film has this frame

# Runs that once differed: (scene, options, the long run, others). Halos of letters widen as the camera comes near, and the renderer took
# the halo of an earlier frame for that of a later one.
HELD = r"""title = "A title that stands"
caption = 'Words below $\omega$'
[body]
moments_kg_m2 = [3.0, 2.0, 1.1]
[start]
omega_rad_s = [0.5, 1.9, 0.2]
[film]
duration_s = 9.0
[[keyframes]]
at_s = 3.0
azimuth_deg = 20.0
[[keyframes]]
at_s = 5.0
view = "contact"
[[fades]]
at_s = 4.0
elements = ["plane"]
[[stops]]
at_s = 2.0
[[stops]]
at_s = 6.0
loop_s = 1.0
"""
# Under friction the plane is as wide as the contact point comes to move, whatever the last frame of a run.
SLOWED = """[body]
moments_kg_m2 = [3.0, 2.0, 1.1]
[start]
omega_rad_s = [0.1, 0.2, 1.9]
[torque]
kind = "dissipation"
half_life_s = 3.0
[motion]
method = "dopri5"
[film]
length_s = 8.0
"""
KNOWN = [
    ("held", ["--size", "176x100", "--fps", "7"], (0, 62), [(37, 39), (50, 52)]),
    ("slowed", ["--size", "96x54", "--fps", "5"], (0, 39), [(3, 4), (20, 21)]),
    ("contact_matter", ["--size", "200x112", "--fps", "3"], (0, 29), [(10, 11), (18, 18)]),
    ("measured", ["--size", "320x180", "--fps", "3"], (0, 20), [(11, 11)]),
    ("lecture_construction", ["--size", "176x100", "--fps", "13"], (470, 502), [(480, 480), (500, 502)]),
    ("lecture", ["--size", "176x100", "--fps", "3"], (390, 406), [(403, 405)]),
]
N_QUICK = 2  # of these

ELEMENTS = ["axes", "contact", "ellipsoid", "herpolhode", "momentum", "omega", "plane", "polhode", "spin-axis"]  # shown by default
MORE_ELEMENTS = ["radius", "annulus", "tangent", "body", "gradient", "projection", "velocity", "levels", "half-axes", "distance"]
OVERLAYS = ["title", "caption", "chapter", "clock"]
EASINGS = ["linear", "smooth", "smoother", "in", "out", "through", "hold"]
VIEWS = ["lecture", "front", "side", "high", "top", "contact"]
WORDS = ["the ellipsoid rolls", r"$\boldsymbol\omega$ moves", r"$\mathbf{L}$ rests", "{omega_1:.2f} rad/s", r"$T$ = {T:.3f}", "herpolhode",
         "from T and L", r"$I(\mathbf{n}) = \sum_i I_i n_i^2$", "slowly"]
PANELS = ["space", "body", "plan", "momentum", "plot", "space", "object"]
RATES = ["7", "12", "13", "24", "30000/1001", "25", "60", "11.5"]


def quoted(text):
    return "'" + text + "'"


def random_camera(dice, view=True):
    lines = []
    if view and dice.random() < 0.5:
        lines.append(f'view = "{dice.choice(VIEWS)}"')
    if dice.random() < 0.6:
        lines.append(f"azimuth_deg = {dice.uniform(-200, 200)!r}")
    if dice.random() < 0.4:
        lines.append(f"elevation_deg = {dice.uniform(-20, 80)!r}")
    if dice.random() < 0.3:
        lines.append(f"distance = {dice.uniform(2.5, 9)!r}")
    if dice.random() < 0.15:
        lines.append(f'look_at = "{dice.choice(["middle", "centre", "foot"])}"')
    return lines


def random_text(dice, live=True):
    words = [w for w in WORDS if live or "{" not in w or "$I" in w]
    return quoted("  ".join(dice.choice(words) for _ in range(dice.randint(1, 4))))


def random_scene(dice):
    """The text of a scene, with its film's length in seconds of film."""
    length = dice.choice([4.0, 6.0, 9.0, 15.0])
    lines = []
    if dice.random() < 0.8:
        lines.append(f"title = {random_text(dice, live=False)}")
    if dice.random() < 0.6:
        lines.append(f"caption = {random_text(dice)}")
    if dice.random() < 0.4:
        lines.append(f'theme = "{dice.choice(["light", "dark", "print", "colour-blind", "transparent"])}"')
    if dice.random() < 0.2:
        lines.append('hidden = "dashed"')
    if dice.random() < 0.2:
        lines.append('crossings = "gap"')
    if dice.random() < 0.3:
        lines.append(f"type_scale = {dice.uniform(0.7, 2.5)!r}")
    shown = ELEMENTS
    if dice.random() < 0.3:
        shown = dice.sample(ELEMENTS + MORE_ELEMENTS, dice.randint(6, 12)) + dice.sample(OVERLAYS, dice.randint(1, 4))
        lines.append("show = [" + ", ".join(f'"{name}"' for name in shown) + "]")
    a, b, c = (dice.uniform(0.3, 2.0) for _ in range(3))
    moments = [b + c, c + a, a + b]
    if dice.random() < 0.15:
        moments[1] = moments[0]
    omega = [dice.choice([-1, 1]) * dice.uniform(0.05, 3.0) for _ in range(3)]
    lines += ["[body]", f"moments_kg_m2 = {moments}", "[start]", f"omega_rad_s = {omega}"]
    kind = dice.random()
    if kind < 0.15:
        lines += ["[torque]", 'kind = "dissipation"', f"half_life_s = {dice.uniform(1, 20)!r}", "[motion]", 'method = "dopri5"']
    elif kind < 0.25:
        lines += ["[motion]", f'method = "{dice.choice(["rk4", "dopri5", "dmv"])}"']
    lines += ["[film]", f"length_s = {length!r}"]
    if dice.random() < 0.2:
        lines.append(f'quality = "{dice.choice(["draft", "print"])}"')
    if dice.random() < 0.2:
        lines.append(f"start_s = {dice.uniform(-5, 5)!r}")
    if dice.random() < 0.3:
        lines.append(f"speed = {dice.uniform(0.3, 3.0)!r}")
    camera = random_camera(dice)
    if dice.random() < 0.1:
        camera.append('motion = "co-precessing"')
    if dice.random() < 0.2:
        camera.append('projection = "orthographic"')
    lines += ["[camera]", *camera]
    if dice.random() < 0.6:
        lines.append("[trail]")
        for name in ("polhode", "herpolhode"):
            if dice.random() < 0.6:
                lines.append(f'{name} = "{dice.choice(["whole", "history", "fading"])}"')
        if dice.random() < 0.3:
            lines.append(f"length_s = {dice.uniform(0.3, 5.0)!r}")
        if dice.random() < 0.2:
            lines.append("direction_marks = true")
    n_panels = dice.choice([0, 0, 0, 1, 2, 3, 4])
    for k in range(n_panels):
        lines += ["[[panels]]", f'kind = "{"space" if k == 0 else dice.choice(PANELS)}"', f"row = {k // 2}", f"column = {k % 2}"]
    if dice.random() < 0.3:
        lines += ["[[marks]]", f"at = {[dice.uniform(-1, 1) for _ in range(3)]}"]
        if dice.random() < 0.5:
            lines.append("trail = true")
        if dice.random() < 0.5:
            lines.append("name = 'P'")

    def instants(most):
        return sorted({round(dice.uniform(0.0, length), 2) for _ in range(dice.randint(0, most))})

    for at_s in instants(4):
        lines += ["[[keyframes]]", f"at_s = {at_s!r}", *(random_camera(dice) or ["azimuth_deg = 10.0"])]
        if dice.random() < 0.4:
            lines.append(f'easing = "{dice.choice(EASINGS)}"')
        if dice.random() < 0.3:
            lines.append(f"speed = {dice.choice([0.0, 0.5, 1.0, 2.0])!r}")
    for at_s in instants(3):
        lines += ["[[fades]]", f"at_s = {at_s!r}", f'elements = ["{dice.choice(shown)}"]']
        if dice.random() < 0.6:
            lines.append(f"opacity = {dice.choice([0.0, 0.0, 0.4, 1.0])!r}")
        if dice.random() < 0.5:
            lines.append(f"over_s = {dice.uniform(0.0, 2.0)!r}")
    for at_s in instants(3):
        lines += ["[[captions]]", f"at_s = {at_s!r}", f"text = {random_text(dice)}"]
        if dice.random() < 0.3:
            lines.append('place = "top"')
    for k, at_s in enumerate(instants(3)):
        lines += ["[[chapters]]", f"at_s = {at_s if k else 0.0!r}", f"title = {random_text(dice, live=False)}"]
    before_s = 0.0
    for at_s in instants(3):
        if at_s - before_s > 0.6:
            lines += ["[[stops]]", f"at_s = {at_s!r}", f'title = "Stop at {at_s}"']
            if dice.random() < 0.4:
                lines.append(f"loop_s = {dice.uniform(0.2, 0.5)!r}")
            before_s = at_s
    return "\n".join(lines) + "\n"


class Refused(Exception):
    """The program refuses the scene."""


class Differs(Exception):
    """What is wrong, and how it is seen again."""


def pixels_of(file):
    """The compressed pixels of a PNG, with its header: everything but what it says of itself."""
    data, at, kept = file.read_bytes(), 8, b""
    while at < len(data):
        size, kind = int.from_bytes(data[at:at + 4], "big"), data[at + 4:at + 8]
        if kind in (b"IHDR", b"PLTE", b"tRNS", b"IDAT"):
            kept += data[at + 8:at + 8 + size]
        at += 12 + size
    return kept


def encoded_frames(film):
    """The packets of an MP4 film's pictures, in the order in which the file has them."""
    data = film.read_bytes()

    def insides(name, at, end):
        while at < end:
            size = int.from_bytes(data[at:at + 4], "big")
            if data[at + 4:at + 8] == name:
                return at + 8, at + size
            at += size
        raise ValueError(f"{film.name}: no {name!r}")

    def numbers(name, n_before_count, width):
        """The rows of a table of numbers of four bytes."""
        at, _ = insides(name, *table)
        at += n_before_count
        n = int.from_bytes(data[at:at + 4], "big")
        row = struct.Struct(f">{width}I")
        return [row.unpack_from(data, at + 4 + row.size * k) for k in range(n)]

    table = (0, len(data))
    for name in (b"moov", b"trak", b"mdia", b"minf", b"stbl"):
        table = insides(name, *table)
    sizes = [size for size, in numbers(b"stsz", 8, 1)]
    runs, packets = numbers(b"stsc", 4, 3), []
    for chunk, (at,) in enumerate(numbers(b"stco", 4, 1), 1):
        for _ in range([n for first, n, _ in runs if first <= chunk][-1]):
            packets.append(data[at:at + sizes[len(packets)]])
            at += len(packets[-1])
    return packets


class Film:
    """A scene with options, drawn in one way and another."""

    def __init__(self, program, scene, options, folder):
        self.program, self.scene, self.options, self.folder = program, str(scene), options, folder

    def call(self, command, *options):
        line = [self.program, command, *options]
        run = subprocess.run(line, stdout=subprocess.DEVNULL, stderr=subprocess.PIPE, timeout=600, cwd=self.folder)
        said = run.stderr.decode("utf-8", "replace").strip()
        if run.returncode == 2:
            raise Refused(said)
        if run.returncode != 0:
            raise Differs(f"exit {run.returncode}: {' '.join(line)}: {said[-300:]}")

    def render(self, output, *options):
        self.call("render", self.scene, *self.options, *options, "-q", "-o", str(output))

    def n_frames(self):
        try:
            self.render("none_####.png", "--frames", f"0-{ENDLESS}")
        except Refused as refusal:
            found = re.search(r"the film has frames 0-(\d+)", str(refusal))
            if found:
                return int(found[1]) + 1
            raise
        raise Differs("a film has no end")

    def place(self, name):
        place = self.folder / name
        shutil.rmtree(place, ignore_errors=True)
        place.mkdir()
        return place

    def frames(self, name, first, last, *options):
        """The pixels of these frames, by number."""
        place = self.place(name)
        self.render(place / "f_########.png", "--frames", f"{first}-{last}", *options)
        return {int(file.stem[2:]): pixels_of(file) for file in place.glob("f_*.png")}

    def told(self):
        return " ".join(self.options)

    def check_starts(self, whole, runs):
        """The frames of other runs are those of a long one."""
        first, last = whole
        frames = self.frames("long", first, last)
        if sorted(frames) != list(range(first, last + 1)):
            raise Differs(f"{self.told()} --frames {first}-{last}: has {len(frames)} frames")
        for begin, end in runs:
            try:
                differ = sorted(k for k, pixels in self.frames("short", begin, end).items() if pixels != frames[k])
            except Refused as refusal:
                raise Differs(f"{self.told()}: --frames {begin}-{end} is refused, {first}-{last} is not: {refusal}") from refusal
            if differ:
                raise Differs(f"{self.told()}: frames {differ} of --frames {begin}-{end} are not those of {first}-{last}")

    def check_same_files(self, name, one, others):
        """Each way of making a film makes the file of one process."""
        for told, file in others:
            if file.read_bytes() != one.read_bytes():
                raise Differs(f"{self.told()} -o {name}: {told} is not the film of one process")

    def check_sequence(self, n):
        """By several processes, and in parts."""
        one, jobs, parts = self.place("one"), self.place("jobs"), self.place("parts")
        last = min(n, 40) - 1
        frames = ["--frames", f"0-{last}"]
        self.render(one / "f_####.png", *frames, "--jobs", "1")
        self.render(jobs / "f_####.png", *frames, "--jobs", "3")
        for part in ("2/3", "3/3", "1/3"):
            self.render(parts / "f_####.png", *frames, "--part", part)
        self.call("join", str(parts / "f_####.png"), "-q", "-o", str(parts / "f_####.png"))
        for k in range(last + 1):
            name = f"f_{k:04}.png"
            self.check_same_files(name, one / name, [("--jobs 3", jobs / name), ("the joined parts", parts / name)])

    def check_film(self, suffix, n):
        """By several processes, and joined from parts, of which each has more than one chunk of 120 frames."""
        last = min(n, 370) - 1
        place = self.place("film")
        frames = ["--frames", f"0-{last}"]
        one, jobs, joined = place / f"one{suffix}", place / f"jobs{suffix}", place / f"joined{suffix}"
        self.render(one, *frames, "--jobs", "1")
        self.render(jobs, *frames, "--jobs", "2")
        n_parts = min(3, (last + 120) // 120) if suffix != ".gif" else 3
        parts = [place / f"part{k}{suffix}" for k in range(1, n_parts + 1)]
        for k, part in reversed(list(enumerate(parts, 1))):
            self.render(part, *frames, "--part", f"{k}/{n_parts}")
        self.call("join", *map(str, parts), "-q", "-o", str(joined))
        self.check_same_files(suffix, one, [("--jobs 2", jobs), ("the joined parts", joined)])

    def check_slides(self, n):
        """Slides by one process and by two; their pictures, and the stills of stops, are frames of the film."""
        frames = self.frames("whole", 0, n - 1)
        one, two = self.folder / "slides_of_one", self.folder / "slides_of_two"
        for deck, jobs in ((one, "1"), (two, "2")):
            shutil.rmtree(deck, ignore_errors=True)
            self.call("render", self.scene, *self.options, "--slides", str(deck), "--jobs", jobs, "-q")
        for file in sorted(one.iterdir()):
            self.check_same_files("--slides", file, [(f"{file.name} of two processes", two / file.name)])
        stills = self.place("stills")
        options = list(self.options)
        rate = options.index("--fps")
        options[rate:rate + 2] = ["--set", f"film.fps={options[rate + 1]}"]
        self.call("still", self.scene, *options, "--chapters", "-q", "-o", str(stills / "s_####.png"))
        slides = json.loads((one / "slides.json").read_text())["slides"]
        for slide in slides:
            k = slide["last_frame"]
            if pixels_of(one / slide["png"]) != frames[k]:
                raise Differs(f"{self.told()} --slides: {slide['png']} is not frame {k}")
        # A slide's film begins with the frame with which the one before ends, and looks the same there: it is encoded alike.
        for before, after in zip(slides, slides[1:]):
            if encoded_frames(one / before["film"])[-1] != encoded_frames(one / after["film"])[0]:
                raise Differs(f"{self.told()} --slides: {after['film']} does not begin as {before['film']} ends")
        # Stops only: slides have one more where the film goes on after the last.
        for file in sorted(stills.glob("s_*.png")):
            slide = slides[int(file.stem[2:]) - 1]
            if pixels_of(file) != frames[slide["last_frame"]]:
                raise Differs(f"{self.told()} still --chapters: {file.name} is not frame {slide['last_frame']}")


def random_size(dice):
    return f"{dice.randint(96, 400)}x{dice.randint(54, 225)}"


def events_of(text):
    """The instants of the film at which something changes."""
    scene = tomllib.loads(text)
    return sorted({item["at_s"] for key in ("keyframes", "fades", "captions", "chapters", "stops") for item in scene.get(key, [])} | {0.0})


def runs_in(dice, first, last, n_runs):
    runs = []
    for _ in range(n_runs):
        begin = dice.randint(first, last)
        runs.append((begin, min(last, begin + dice.randint(0, 2))))
    return runs


class Trial:
    def __init__(self, program, scenes, folder, seed):
        self.program, self.scenes, self.folder, self.seed = program, scenes, folder, seed

    def film(self, name, scene, options):
        place = self.folder / name
        place.mkdir(exist_ok=True)
        return Film(self.program, scene, options, place)

    def known(self, name, options, whole, runs):
        texts = {"held": HELD, "slowed": SLOWED}
        if name in texts:
            scene = self.folder / f"{name}.toml"
            scene.write_text(texts[name])
        else:
            scene = self.scenes / f"{name}.toml"
        for profile in ([], ["--portable"]):
            self.film(f"known_{name}", scene, [*options, *profile]).check_starts(whole, runs)

    def sparse(self, name, scene, n, options):
        """The whole film in some n frames, or in as many as its stops need; and its last frame."""
        length_s = self.film(name, scene, ["--fps", "30", *options]).n_frames() / 30
        while True:
            film = self.film(name, scene, ["--fps", f"{max(0.001, n / length_s):.3f}", *options])
            try:
                return film, film.n_frames() - 1
            except Refused as refusal:
                if "less than a frame" not in str(refusal) or n > 1000:
                    raise
            n *= 2

    def starts(self, name, scene, dice, profile):
        """Frames all over the film, and one after the other about some event."""
        size = ["--size", random_size(dice)]
        events = events_of(scene.read_text())
        sparse, last = self.sparse(name, scene, dice.randint(12, 40), [*size, *profile])
        sparse.check_starts((0, last), runs_in(dice, 0, last, 3))
        rate = dice.choice(RATES)
        dense = self.film(name, scene, ["--fps", rate, *size, *profile])
        last = dense.n_frames() - 1
        begin = min(max(0, int(dice.choice(events) * fractions.Fraction(rate)) - dice.randint(0, 9)), last)
        end = min(last, begin + dice.randint(9, 27))
        dense.check_starts((begin, end), runs_in(dice, begin, end, 3))

    def of_gallery(self, scene, profile):
        dice = random.Random(f"{self.seed}:{scene.stem}:{profile}")
        name = f"{scene.stem}{''.join(profile)}"
        self.starts(name, scene, dice, profile)
        if "\n[[stops]]" in scene.read_text():
            film = self.film(name, scene, ["--fps", "3", "--size", "176x100", *profile])
            film.check_slides(film.n_frames())

    def of_random(self, number):
        """Draws the first of some random scenes that the program accepts."""
        for attempt in range(20):
            dice = random.Random(f"{self.seed}:{number}:{attempt}")
            scene = self.folder / f"random_{number}.toml"
            scene.write_text(random_scene(dice))
            profile = ["--portable"] if number % 2 else []
            try:
                self.starts(f"random_{number}", scene, dice, profile)
            except Refused:
                continue
            kind = number % 10
            film = self.film(f"random_{number}", scene, ["--fps", "40", "--size", "96x54", *profile])
            n = film.n_frames()
            if kind == 0:
                film.check_sequence(n)
            elif kind in (1, 2, 3, 4):
                film.check_film([".mp4", ".webm", ".mov", ".gif"][kind - 1], n if kind != 4 else min(n, 60))
            elif kind in (5, 6, 7) and "[[stops]]" in scene.read_text():
                slow = self.film(f"random_{number}", scene, ["--fps", "7", "--size", "96x54", *profile])
                slow.check_slides(slow.n_frames())
            return
        raise Differs("20 random scenes were refused")


def main():
    asked = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    asked.add_argument("program")
    asked.add_argument("scenes")
    asked.add_argument("--seed", type=int, default=1)
    asked.add_argument("--random", type=int, default=40)
    asked.add_argument("--both", action="store_true")
    asked.add_argument("--quick", action="store_true")
    asked.add_argument("--only")
    asked = asked.parse_args()
    os.environ["LP_NUM_THREADS"] = "0"  # threads of Mesa would delay small pictures
    with tempfile.TemporaryDirectory() as folder:
        trial = Trial(os.path.abspath(asked.program), pathlib.Path(asked.scenes).resolve(), pathlib.Path(folder), asked.seed)
        cases = [(f"known_{case[0]}", trial.known, case) for case in KNOWN[:N_QUICK if asked.quick else None]]
        if not asked.quick:
            profiles = ([], ["--portable"])
            for number, scene in enumerate(sorted(trial.scenes.glob("*.toml"))):
                for profile in profiles if asked.both else [profiles[(number + asked.seed) % 2]]:
                    cases.append((f"{scene.stem}{''.join(profile)}", trial.of_gallery, (scene, profile)))
        n_random = 1 if asked.quick else asked.random
        cases += [(f"random_{k}", trial.of_random, (k,)) for k in range(n_random)]
        if asked.only:
            cases = [case for case in cases if case[0] == asked.only]

        def tried(case):
            name, check, arguments = case
            try:
                check(*arguments)
            except (Differs, Refused, subprocess.TimeoutExpired) as wrong:
                return f"{name}: {wrong}"
            finally:
                shutil.rmtree(trial.folder / name, ignore_errors=True)
            return ""

        n_wrong = 0
        with concurrent.futures.ThreadPoolExecutor(min(2, os.cpu_count() or 1)) as pool:
            for wrong in pool.map(tried, cases):
                if wrong:
                    n_wrong += 1
                    print(f"WRONG --seed {asked.seed} --only {wrong}", flush=True)
    print(f"{len(cases)} scenes, {n_wrong} with frames that depend on the run")
    sys.exit(1 if n_wrong or not cases else 0)


if __name__ == "__main__":
    main()
