"""A program with types that uses the package; mypy --strict accepts it but for the last line."""

from pathlib import Path
from typing import Dict, List, Optional

import numpy as np
from numpy.typing import NDArray

import poinsot


def drift(scene: poinsot.Scene, times: NDArray[np.float64]) -> float:
    sampled: poinsot.Samples = scene.sample(times, columns=["time", "kinetic_energy"])
    column: NDArray[np.float64] = sampled["kinetic_energy"]
    return float(np.ptp(column))


def pictures(folder: Path) -> List[poinsot.Still]:
    scene = poinsot.Scene({"body": {"moments_kg_m2": [1, 2, 3]}, "start": {"omega_rad_s": [0.1, 2, 0]}})
    still: poinsot.Still = scene.still(1.0, size=(640, 360), theme="dark", portable=True)
    still.save(folder / "still.png")
    pixels: NDArray[np.uint8] = still.pixels
    figure: poinsot.Figure = scene.figure("auto", width_mm=86.0, journal=None)
    figure.save(folder / "figure.pdf")
    film: poinsot.Film = scene.render(folder / "film.mp4", frames=(0, 9), progress=False)
    notes: List[str] = film.notes
    assert pixels.size and notes
    scene.render(folder / "part.mp4", frames=range(10), progress=False)
    return [still, scene.set({"theme": "print"}).still("auto"), scene.set(theme="dark", camera={"elevation_deg": 10}).still()]


def motion() -> Optional[float]:
    turning = poinsot.Motion([1.0, 2.0, 3.0], np.array([0.1, 2.0, 0.0]))
    omega: NDArray[np.float64] = turning.at(np.linspace(0, 1, 5)).omega_body
    constants: poinsot.Constants = turning.constants
    claims: List[poinsot.Claim] = turning.certificate([0.0, 1.0])
    assert turning == poinsot.Motion([1.0, 2.0, 3.0], [0.1, 2.0, 0.0])
    drawn: poinsot.Still = poinsot.Scene(turning).still()
    assert omega.shape == (5, 3) and drawn.pixels.size and all(claim.holds for claim in claims)
    curve: NDArray[np.float64] = turning.polhode(1e-3)
    return constants.polhode_period_s if len(curve) > 1 else turning.period_s


def compared(folder: Path, still: poinsot.Still) -> bool:
    found: poinsot.Comparison = poinsot.compare(folder / "still.png", still, max_flip=0.01, ignore=["clock"])
    outcomes: Dict[str, str] = poinsot.approve("still", results=folder, baselines=folder / "baselines", why="first")
    worst: List[poinsot.Comparison] = poinsot.compare_folders(folder, folder, report=folder / "report.html")
    try:
        poinsot.Scene("nothing")
    except poinsot.InputError as error:
        file: Optional[str] = error.file
        line: Optional[int] = error.line
        print(file, line)
    return bool(found) and all(worst) and "still" in outcomes


poinsot.Scene("generic").still(theme=3)
