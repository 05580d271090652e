"""The base step's room."""

from __future__ import annotations

from typing import Any

from beltgui.jobs import Job
from beltgui.steps.base import step
from beltgui.steps.base.step import BaseOutcome
from beltgui.steps.context import Context
from beltgui.steps.room import Bench
from beltgui.viewmodel.step import StepContent


class BaseRoom:
    """Step 2: the measuring frame in the base of the robot."""

    step = step.STEP

    def acquire(self, bench: Bench, context: Context) -> None:
        """Take the scans that are missing; see `Room.acquire`."""
        step.acquire(bench, context)

    def solve(self, bench: Bench, job: Job) -> BaseOutcome:
        """Solve from the scans that are there; see `Room.solve`."""
        return step.solve(bench, job)

    def record(self, outcome: BaseOutcome) -> dict[str, Any]:
        """For the session, the report and replay."""
        return step.record(outcome)

    def headline(self, outcome: BaseOutcome) -> str:
        """How well the ball is predicted in poses that were not fitted."""
        return step.headline(outcome)

    def view(self, bench: Bench, outcome: BaseOutcome | None, error: str = "") -> StepContent:
        """What the screen shows; see `Room.view`."""
        from beltgui.steps.base.view import content

        return content(bench, outcome, error)
