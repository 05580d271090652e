"""The tool step's room."""

from __future__ import annotations

from typing import Any

from beltgui.jobs import Job
from beltgui.steps.context import Context
from beltgui.steps.room import Bench
from beltgui.steps.tool import step, touches
from beltgui.steps.tool.step import ToolOutcome
from beltgui.viewmodel.step import StepContent


class ToolRoom:
    """Step 5: the stylus, and the wheel of each grinder."""

    step = touches.STEP

    def acquire(self, bench: Bench, context: Context) -> None:
        """Ask for the touches that are missing; see `Room.acquire`."""
        touches.acquire(bench.session, context)

    def solve(self, bench: Bench, job: Job) -> ToolOutcome:
        """Solve from the touches that are there; see `Room.solve`."""
        return step.solve(bench, job)

    def record(self, outcome: ToolOutcome) -> dict[str, Any]:
        """For the session, the report and replay."""
        return step.record(outcome)

    def headline(self, outcome: ToolOutcome) -> str:
        """How well the worst grinder's mark is predicted by what was not fitted to it."""
        return step.headline(outcome)

    def view(self, bench: Bench, outcome: ToolOutcome | None, error: str = "") -> StepContent:
        """What the screen shows; see `Room.view`."""
        from beltgui.steps.tool.view import content

        return content(bench, outcome, error)
