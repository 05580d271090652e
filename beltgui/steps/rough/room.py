"""Rough workpiece: the room."""

from __future__ import annotations

from typing import Any

from beltgui.jobs import Job
from beltgui.steps.clamping import acquire_blade_scans, common_clamping
from beltgui.steps.context import Context
from beltgui.steps.fine.step import common_flange
from beltgui.steps.room import Bench
from beltgui.steps.rough import step
from beltgui.steps.rough.picks import BY_PAIRS, method_of, pairs_of
from beltgui.steps.rough.step import RoughOutcome
from beltgui.steps.scans import KIND, scan_of
from beltgui.viewmodel.step import StepContent


class RoughRoom:
    """First pose of the blade; settings `method` (`automatic` or `pairs`) and `pairs`, see `picks`."""

    step = "rough"

    def acquire(self, bench: Bench, context: Context) -> None:
        """Have the blade clamped where a new round begins, and scan it from where there is no scan yet."""
        acquire_blade_scans(bench, context, self.step, fresh=True)

    def solve(self, bench: Bench, job: Job) -> RoughOutcome:
        """Find the blade in the scans, by the chosen method."""
        job.report(0.0, "reading the scans")
        samples = bench.session.kept(self.step, KIND)
        common_clamping(samples)
        scans = [scan_of(bench.session, sample) for sample in samples]
        common_flange(scans)
        stage, told = bench.found["ball"].stage, job.part(0.05, 0.95).report
        if method_of(bench) == BY_PAIRS:
            return step.solve_by_pairs(scans, stage, bench.model, bench.blade, pairs_of(bench), told)
        return step.solve(scans, stage, bench.model, bench.blade, told)

    def record(self, outcome: RoughOutcome) -> dict[str, Any]:
        """For the session and the report."""
        return step.record(outcome)

    def headline(self, outcome: RoughOutcome) -> str:
        """The number that matters."""
        return step.headline(outcome)

    def view(self, bench: Bench, outcome: RoughOutcome | None, error: str = "") -> StepContent:
        """What the screen shows."""
        from beltgui.steps.rough.view import content

        return content(bench, outcome, error)
