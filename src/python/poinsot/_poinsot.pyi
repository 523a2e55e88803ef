"""The compiled module. The package gives its functions the names that people use."""

from typing import Any, Callable, Dict, List, Optional, Sequence, Tuple

import numpy as np
from numpy.typing import NDArray

__version__: str

class States:
    @property
    def time_s(self) -> NDArray[np.float64]: ...
    @property
    def omega_body(self) -> NDArray[np.float64]: ...
    @property
    def space_from_body(self) -> NDArray[np.float64]: ...
    @property
    def herpolhode(self) -> NDArray[np.float64]: ...

class Motion:
    def __init__(
        self,
        moments: NDArray[np.float64],
        omega: NDArray[np.float64],
        attitude: NDArray[np.float64],
        method: str,
        step_s: Optional[float],
        tolerance: Optional[float],
        order: Optional[int],
        span_s: Tuple[float, float],
        allow_unphysical: bool,
    ) -> None: ...
    @staticmethod
    def heavy_top(
        transverse: float,
        axial: float,
        mgl_N_m: float,
        theta_rad: float,
        theta_dot_rad_s: float,
        phi_dot_rad_s: float,
        omega3_rad_s: float,
    ) -> Motion: ...
    def at(self, times: Any) -> States: ...
    @property
    def regime(self) -> str: ...
    @property
    def description(self) -> str: ...
    def constants(self) -> Dict[str, Any]: ...
    def top_constants(self) -> Dict[str, Any]: ...
    def cones(self) -> Optional[Dict[str, Any]]: ...
    def polhode(self, tolerance: float) -> NDArray[np.float64]: ...
    def contact(self, times: NDArray[np.float64], in_space: bool) -> NDArray[np.float64]: ...
    def flips(self, first_s: float, last_s: float) -> List[float]: ...
    def certificate(
        self, times: NDArray[np.float64], attitude_error_rad: float
    ) -> List[Dict[str, Any]]: ...

class Still:
    @property
    def pixels(self) -> NDArray[np.uint8]: ...
    @property
    def png(self) -> bytes: ...
    @property
    def bound(self) -> str: ...

class Scene:
    @staticmethod
    def from_file(file: str, values: Sequence[str], allow_outside: bool) -> Scene: ...
    @staticmethod
    def from_text(text: str, name: str, values: Sequence[str], allow_outside: bool) -> Scene: ...
    def with_values(self, values: Sequence[str]) -> Scene: ...
    @property
    def name(self) -> str: ...
    @property
    def title(self) -> str: ...
    @property
    def text(self) -> str: ...
    @property
    def values(self) -> List[str]: ...
    @property
    def file(self) -> str: ...
    @property
    def allow_outside(self) -> bool: ...
    @property
    def width_px(self) -> int: ...
    @property
    def height_px(self) -> int: ...
    def check_json(self) -> str: ...
    def sample(
        self, times_s: NDArray[np.float64], columns: Sequence[str]
    ) -> Tuple[List[str], NDArray[np.float64]]: ...
    def still(
        self,
        time_s: Optional[float],
        clearest: bool,
        paper: Dict[str, Any],
        backend: str,
        portable: bool,
    ) -> Still: ...
    def figure(
        self,
        format: str,
        time_s: Optional[float],
        clearest: bool,
        paper: Dict[str, Any],
        shading: str,
        text: str,
        backend: str,
        portable: bool,
    ) -> bytes: ...
    def render(
        self,
        path: str,
        frames: Optional[Tuple[int, int]],
        backend: str,
        portable: bool,
        say: Optional[Callable[[str], object]],
        progress: Optional[Callable[[int, int], object]],
    ) -> None: ...
    def slides(
        self,
        folder: str,
        backend: str,
        portable: bool,
        say: Optional[Callable[[str], object]],
        progress: Optional[Callable[[int, int], object]],
    ) -> None: ...

def compare_pair(
    name: str, expected: str, actual: str, profile: str, limits: Dict[str, Any], measures: bool
) -> Dict[str, Any]: ...
def compare_all(
    expected: str, actual: str, profile: str, limits: Dict[str, Any], measures: bool, report: str, title: str
) -> List[Dict[str, Any]]: ...
def report_pairs(pairs: Sequence[Tuple[str, str, str, str, Dict[str, Any]]], report: str, title: str) -> None: ...
def png_of(pixels: NDArray[np.uint8]) -> bytes: ...
def write_whole(file: str, contents: bytes) -> None: ...
def approve(
    results: str, baselines: str, names: Sequence[str], why: str, any_renderer: bool
) -> List[Tuple[str, str]]: ...
