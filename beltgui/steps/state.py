"""Names, order and states of the six steps: one word each, the same in code, files and on the screen."""

from __future__ import annotations

from dataclasses import dataclass
from enum import StrEnum

STEPS = ("ball", "base", "rough", "fine", "tool", "error_surface")

TITLES = {
    "ball": "Ball",
    "base": "Base",
    "rough": "Rough workpiece",
    "fine": "Fine workpiece",
    "tool": "Stylus and tool",
    "error_surface": "Error surface",
}


class StepState(StrEnum):
    """Where a step stands."""

    NOT_STARTED = "not started"
    RUNNING = "running"
    ACCEPTED = "accepted"
    STALE = "stale"
    FAILED = "failed"


@dataclass(frozen=True)
class StepEvent:
    """A step changed its state.

    Attributes:
        step: One of `STEPS`.
        state: The new state.
        headline: One line with the number that matters and its unit, or the reason of a failure.
    """

    step: str
    state: StepState
    headline: str = ""
