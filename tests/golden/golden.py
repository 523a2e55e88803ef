#!/usr/bin/env python3
"""The golden tests: every scene as a small picture, in the portable profile, compared with its approved baseline.

check:  one scene against its baseline in tests/golden/scenes, by `poinsot compare`: with the baselines' renderer
        no pixel may differ; with another version of llvmpipe 0.1 % may, by one level. A failure leaves a report and prints its path.
together: all scenes three times in one process, in shuffled order: each picture is byte-identical to the one drawn alone.
once:   all scenes in one process, in shuffled order, against their baselines: what the sanitizers watch.
rerendered: every scene's picture redrawn from its own record: byte-identical, as `explain --verify` promises.
renew:  takes the pictures of all scenes as baselines, after you have looked at them; --why gives the reason of the change.
sheet:  all baselines in one picture, for inspection.
Usage: golden.py check POINSOT NAME FOLDER | golden.py together POINSOT | golden.py once POINSOT | golden.py rerendered POINSOT | golden.py renew POINSOT
       "WHY" [FOLDER] | golden.py sheet POINSOT OUT.png
"""
import pathlib
import random
import re
import shutil
import subprocess
import sys
import tempfile

HERE = pathlib.Path(__file__).resolve().parent
BASELINES = HERE / "scenes"
SCENES = HERE.parents[1] / "scenes"
SIZE = "240x135"


def draw(program, name, folder):
    """Draws the scene's picture into the folder, at film.still_s or, without it, at an instant where no arrows coincide."""
    picture = folder / f"{name}.png"
    subprocess.run([program, "still", str(SCENES / f"{name}.toml"), "--portable", "--size", SIZE, "-q", "-o", str(picture)],
                   check=True)
    return picture


def fields_of(program, picture):
    """The fields of a picture's record, by key."""
    text = subprocess.run([program, "explain", str(picture)], check=True, capture_output=True, text=True).stdout
    return dict(line.split(": ", 1) for line in text.split("\n\n")[0].splitlines() if ": " in line)


def check(program, name, folder):
    folder = pathlib.Path(folder)
    folder.mkdir(parents=True, exist_ok=True)
    baseline = BASELINES / f"{name}.png"
    picture = draw(program, name, folder)
    if not baseline.exists():
        print(f"{name}: no baseline; look at {picture}, then: {sys.argv[0]} renew {program} \"first picture\"")
        return 1
    report = folder / f"{name}.html"
    compared = subprocess.run([program, "compare", str(baseline), str(picture), "--report", str(report)])
    if compared.returncode == 0:
        report.unlink(missing_ok=True)
        return 0
    if fields_of(program, baseline)["scene-sha256"] != fields_of(program, picture)["scene-sha256"]:
        print(f"{name}: its scene has changed since the picture was approved")
    print(f"report: {report}\nif the new picture is the right one: {sys.argv[0]} renew {program} \"why it changed\"")
    return 1


def together(program, alone):
    """Draws every scene three times in one process, in shuffled order, and compares with the pictures that `check` left in the
    folder `alone`."""
    with tempfile.TemporaryDirectory() as beside_others:
        names = 3 * sorted(scene.stem for scene in SCENES.glob("*.toml"))
        random.Random(1).shuffle(names)
        subprocess.run([program, "still", *(str(SCENES / f"{name}.toml") for name in names), "--portable", "--size", SIZE,
                        "-q", "-o", str(pathlib.Path(beside_others, "###.png"))], check=True)
        expected = {name: pathlib.Path(alone, f"{name}.png").read_bytes() for name in set(names)}
        wrong = [f"{number}: {name}" for number, name in enumerate(names)
                 if pathlib.Path(beside_others, f"{number:03}.png").read_bytes() != expected[name]]
    print(f"{len(names)} pictures drawn after others, {len(wrong)} unlike those drawn alone", *wrong, sep="\n")
    return 1 if wrong else 0


def once(program):
    """Draws every scene in one process, in shuffled order, and compares the pictures with the baselines."""
    with tempfile.TemporaryDirectory() as drawn:
        names = sorted(scene.stem for scene in SCENES.glob("*.toml"))
        random.Random(1).shuffle(names)
        subprocess.run([program, "still", *(str(SCENES / f"{name}.toml") for name in names), "--portable", "--size", SIZE,
                        "-q", "-o", str(pathlib.Path(drawn, "###.png"))], check=True)
        for number, name in enumerate(names):
            pathlib.Path(drawn, f"{number:03}.png").rename(pathlib.Path(drawn, f"{name}.png"))
        return subprocess.run([program, "compare", str(BASELINES), drawn]).returncode


def rerendered(program):
    """Redraws pictures without the scene file, with only the files beside it: meshes, pictures and tables."""
    names = sorted(scene.stem for scene in SCENES.glob("*.toml"))
    wrong = []
    with tempfile.TemporaryDirectory() as scratch:
        for name in names:
            folder = pathlib.Path(scratch, name)
            folder.mkdir()
            for beside in SCENES.iterdir():
                if beside.suffix not in (".toml", ".json"):
                    shutil.copy(beside, folder)
            picture = draw(program, name, folder)
            again = folder / "again.png"
            verified = subprocess.run([program, "explain", "--verify", picture], cwd=folder, capture_output=True, text=True)
            drawn = subprocess.run([program, "rerender", picture, "-q", "-o", again], cwd=folder, capture_output=True, text=True)
            if verified.returncode != 0:
                wrong.append(f"{name}: {verified.stderr.strip()}")
            if drawn.returncode != 0:
                wrong.append(f"{name}: {drawn.stderr.strip()}")
            elif again.read_bytes() != picture.read_bytes():
                wrong.append(f"{name}: drawn again it has other bytes")
    print(f"{len(names)} pictures drawn again from their records, {len(wrong)} faults", *wrong, sep="\n")
    return 1 if wrong else 0


def renew(program, why, folder=None):
    with tempfile.TemporaryDirectory() as scratch:
        results = pathlib.Path(folder or scratch)
        results.mkdir(parents=True, exist_ok=True)
        names = sorted(scene.stem for scene in SCENES.glob("*.toml"))
        for name in names:
            draw(program, name, results)
        # Removes baselines of deleted scenes, with their lines in the manifest.
        for baseline in BASELINES.glob("*.png"):
            if baseline.stem in names:
                continue
            baseline.unlink()
            manifest = BASELINES / "manifest.toml"
            kept = [line for line in manifest.read_text().splitlines(True) if not line.startswith(f'"{baseline.stem}" ')]
            manifest.write_text("".join(kept))
            print(f"{baseline.stem}: gone")
        return subprocess.run([program, "approve", "--all", "--results", str(results), "--baselines", str(BASELINES),
                               "--why", why]).returncode


def sheet(program, out):
    """Baselines side by side, on a page rendered by Chromium; only for inspection."""
    pictures = sorted(BASELINES.glob("*.png"))
    cells = "".join(f'<figure style="display:inline-block;margin:4px"><img src="file://{p}" style="width:480px">'
                    f"<figcaption>{re.sub('_', ' ', p.stem)}</figcaption></figure>" for p in pictures)
    with tempfile.NamedTemporaryFile("w", suffix=".html") as page:
        page.write(f'<body style="font:14px sans-serif;width:1980px">{cells}')
        page.flush()
        rows = -(-len(pictures) // 4)
        return subprocess.run(["chromium", "--headless", "--no-sandbox", "--disable-gpu", f"--screenshot={out}",
                               f"--window-size=2000,{rows * 305 + 20}", "--allow-file-access-from-files",
                               f"file://{page.name}"], capture_output=True).returncode


if __name__ == "__main__":
    sys.exit({"check": check, "together": together, "once": once, "rerendered": rerendered, "renew": renew, "sheet": sheet}[sys.argv[1]](*sys.argv[2:]))
