"""Shows how far a film is."""

from __future__ import annotations

import sys
from typing import Any, List, Optional


class Progress:
    """A bar by tqdm where it is installed, else text on stderr; it keeps the notes."""

    def __init__(self, shown: bool, what: str) -> None:
        self.notes: List[str] = []
        self._shown = shown
        self._what = what
        self._bar: Optional[Any] = None
        self._is_text = False
        self._percent = -1

    def say(self, line: str) -> None:
        self.notes.append(line)

    def frames(self, n_done: int, n_frames: int) -> None:
        if not self._shown or sys.stderr is None:  # programs without a terminal, such as pythonw, have none
            return
        if self._bar is None and not self._is_text:
            self._bar = _tqdm_bar(self._what, n_frames)
            self._is_text = self._bar is None
        if self._bar is None:
            percent = 100 * n_done // n_frames
            if percent != self._percent:
                print(f"\r{self._what}: {percent} %", end="", file=sys.stderr, flush=True)
            self._percent = percent
        else:
            if self._bar.total != n_frames:
                self._bar.reset(n_frames)
            self._bar.update(n_done - self._bar.n)

    def close(self) -> None:
        if self._bar is not None:
            self._bar.close()
        elif self._is_text and sys.stderr is not None:
            print(file=sys.stderr)

    def __enter__(self) -> "Progress":
        return self

    def __exit__(self, *unused: object) -> None:
        self.close()


def _tqdm_bar(what: str, n_frames: int) -> Optional[Any]:
    try:
        from tqdm.auto import tqdm
    except ImportError:
        return None
    import warnings

    with warnings.catch_warnings():
        warnings.simplefilter("ignore")  # tqdm warns where a notebook has no widgets
        return tqdm(total=n_frames, desc=what, unit="frame", leave=False)
