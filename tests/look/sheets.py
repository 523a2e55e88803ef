#!/usr/bin/env python3
"""Draws every scene in every theme, on sheets for inspection before the golden pictures are renewed.

Usage: sheets.py POINSOT FOLDER [SCENE...]      all scenes, or the named ones (stems)
A scene's sheet has a picture of 900 pixels for each theme at 1920 × 1080, then the still for paper (print theme, 85 mm at 600 dpi).
`NAME.film.png` has four frames of its film, at 0, 1/3, 2/3 and the end. The pictures themselves stay in FOLDER/THEME/.
`transparent` is composited on a mid grey, which makes errors of alpha visible, `transparent-dark` on a dark blue. Takes about four
minutes. Needs Pillow (python3-pil).
"""
import json
import pathlib
import subprocess
import sys

from PIL import Image, ImageDraw

SCENES = pathlib.Path(__file__).resolve().parents[2] / "scenes"
PAPER = ["--theme", "print", "--width-mm", "85", "--dpi", "600"]
WIDTH = 900           # width of a picture on a sheet, pixels
GROUNDS = {"transparent-dark": (38, 50, 70)}
MID_GREY = (150, 150, 150)


def stills(program, names, folder, options):
    """The scenes' pictures in the folder, drawn in one process, by name."""
    folder.mkdir(parents=True, exist_ok=True)
    for old in folder.glob("*.png"):
        old.unlink()
    files = [str(SCENES / f"{name}.toml") for name in names]
    target = folder / ("####.png" if len(names) > 1 else "0.png")
    subprocess.run([program, "still", *files, "-q", *options, "-o", str(target)], check=True)
    drawn = sorted(folder.glob("*.png"))
    return {name: picture.rename(folder / f"{name}.png") for name, picture in zip(names, drawn, strict=True)}


def film_frames(program, name, folder):
    """Four frames of the scene's film, with their numbers: the first, at a third, at two thirds, and the last."""
    scene = str(SCENES / f"{name}.toml")
    text = subprocess.run([program, "check", "--json", scene], check=True, capture_output=True, text=True).stdout
    last = json.loads(text)["n_frames"] - 1
    folder.mkdir(parents=True, exist_ok=True)
    frames = []
    for number in [0, last // 3, 2 * last // 3, last]:
        subprocess.run([program, "render", scene, "-q", "--frames", f"{number}-{number}", "-o", f"{folder}/{name}.#####.png"],
                       check=True)
        frames.append((f"frame {number} of {last + 1}", folder / f"{name}.{number:05}.png"))
    return frames


def sheet(pictures, out):
    """Pictures with their names, two per row."""
    opened = []
    for title, path in pictures:
        picture = Image.open(path).convert("RGBA")
        height = round(picture.height * WIDTH / picture.width)
        ground = Image.new("RGBA", (WIDTH, height), GROUNDS.get(title, MID_GREY) + (255,))
        ground.alpha_composite(picture.resize((WIDTH, height), Image.LANCZOS))
        ImageDraw.Draw(ground).text((6, 4), title, fill=(255, 0, 160))
        opened.append(ground.convert("RGB"))
    height = max(picture.height for picture in opened)
    rows = -(-len(opened) // 2)
    page = Image.new("RGB", (2 * WIDTH + 6, rows * (height + 6)), (255, 0, 160))
    for i, picture in enumerate(opened):
        page.paste(picture, ((i % 2) * (WIDTH + 6), (i // 2) * (height + 6)))
    page.save(out)


def main(program, folder, names):
    folder = pathlib.Path(folder)
    names = names or sorted(path.stem for path in SCENES.glob("*.toml"))
    themes = json.loads(subprocess.run([program, "list", "themes", "--json"], check=True, capture_output=True).stdout)
    drawn = {theme["name"]: stills(program, names, folder / theme["name"], ["--theme", theme["name"]]) for theme in themes}
    drawn["85 mm, 600 dpi"] = stills(program, names, folder / "paper", PAPER)
    for name in names:
        sheet([(theme, pictures[name]) for theme, pictures in drawn.items()], folder / f"{name}.png")
        sheet(film_frames(program, name, folder / "film"), folder / f"{name}.film.png")
        print(folder / f"{name}.png", flush=True)


if __name__ == "__main__":
    if len(sys.argv) < 3:
        sys.exit(__doc__)
    main(sys.argv[1], sys.argv[2], sys.argv[3:])
