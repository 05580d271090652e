"""Progress of a long computation: told to a callback, which may raise to end the work."""

from __future__ import annotations

from collections.abc import Callable

Progress = Callable[[float, str], None]
"""Called with the share done (0 to 1) and what is being done; what it raises ends the computation."""


def silent(fraction: float, text: str) -> None:
    """Nobody listens."""


def part(progress: Progress, start: float, end: float) -> Progress:
    """Progress of a part of the work: its 0 to 1 is `start` to `end` of the whole."""

    def told(fraction: float, text: str) -> None:
        progress(start + (end - start) * fraction, text)

    return told
