"""Rough workpiece: the room."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

from beltgui.jobs import Job
from beltgui.session import Sample
from beltgui.steps.clamping import acquire_blade_scans, common_clamping
from beltgui.steps.context import Context
from beltgui.steps.fine.step import common_flange
from beltgui.steps.room import Bench
from beltgui.steps.rough import step
from beltgui.steps.rough.picks import BY_PAIRS, method_of, pairs_of
from beltgui.steps.rough.step import RoughOutcome
from beltgui.steps.scans import KIND, ScanSample, scan_of
from beltgui.viewmodel.step import StepContent
from core.ball import StageFit

_BY_PAIRS = ("rough", "by pairs")


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
        stage = bench.found["ball"].stage
        if method_of(bench) == BY_PAIRS:
            return self._solve_by_pairs(bench, samples, stage, job)
        return step.solve(self._scans(bench, samples), stage, bench.model, bench.blade, job.part(0.05, 0.95).report)

    def _solve_by_pairs(self, bench: Bench, samples: Sequence[Sample], stage: StageFit, job: Job) -> RoughOutcome:
        """As before where only a pair was edited that takes no part: nobody is kept waiting for a half picked one."""
        pairs = tuple(pair for pair in pairs_of(bench) if pair.used)
        basis = (pairs, tuple(sample.id for sample in samples))
        solved_of, solved_from, outcome = bench.cache.get(_BY_PAIRS, (None, None, None))
        if solved_of is not stage or solved_from != basis:
            scans, told = self._scans(bench, samples), job.part(0.05, 0.95).report
            outcome = step.solve_by_pairs(scans, stage, bench.model, bench.blade, pairs, told)
            bench.cache[_BY_PAIRS] = (stage, basis, outcome)
        return outcome

    def _scans(self, bench: Bench, samples: Sequence[Sample]) -> list[ScanSample]:
        scans = [scan_of(bench.session, sample) for sample in samples]
        common_flange(scans)
        return scans

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
