"""The ball step's room."""

from __future__ import annotations

from typing import Any

from beltgui.jobs import Job
from beltgui.steps.ball import step
from beltgui.steps.ball.step import BallOutcome
from beltgui.steps.context import Context
from beltgui.steps.room import Bench
from beltgui.viewmodel.step import StepContent


class BallRoom:
    """Step 1: the scanner on its stage."""

    step = step.STEP

    def acquire(self, bench: Bench, context: Context) -> None:
        """Take the scans that are missing; see `Room.acquire`."""
        step.acquire(bench, context)

    def solve(self, bench: Bench, job: Job) -> BallOutcome:
        """Solve from the scans that are there; see `Room.solve`."""
        return step.solve(bench, job)

    def record(self, outcome: BallOutcome) -> dict[str, Any]:
        """For the session, the report and replay."""
        return step.record(outcome)

    def headline(self, outcome: BallOutcome) -> str:
        """How well the ball is predicted by what was not fitted to it."""
        return step.headline(outcome)

    def view(self, bench: Bench, outcome: BallOutcome | None, error: str = "") -> StepContent:
        """What the screen shows; see `Room.view`."""
        from beltgui.steps.ball.view import content

        return content(bench, outcome, error)
