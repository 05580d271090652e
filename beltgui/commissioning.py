"""The six steps in their order: samples in, calibrated cell and robot programs out; live and replayed alike."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, field
from typing import Any

import numpy as np
from numpy.typing import NDArray

from beltgui.jobs import Cancelled, Job
from beltgui.steps.ball import step as ball
from beltgui.steps.base import step as base
from beltgui.steps.error_surface import step as error_surface
from beltgui.steps.error_surface.probing import Presenting
from beltgui.steps.fine import step as fine
from beltgui.steps.rough import step as rough
from beltgui.steps.scans import ScanSample
from beltgui.steps.sources import Source
from beltgui.steps.state import TITLES, StepEvent, StepState
from beltgui.steps.tool import step as tool
from core.cad import CadModel
from core.cad.blade_type import BladeType
from core.path import CellFrames
from core.verdict import Verdict
from devices.cell_plan import CellPlan

Keep = Callable[[str, Mapping[str, Any], bool], None]
Listener = Callable[[StepEvent], None]
# The robot leaves the scanning pose to probe and comes back within its repeatability, at the far end of the blade too.
RETURNED_LIMIT_MM = 0.15
# Share of the whole time, roughly, at which each step begins.
BEGINS = {"ball": 0.0, "base": 0.15, "rough": 0.3, "fine": 0.45, "tool": 0.52, "error_surface": 0.55}
ENDS = dict(zip(BEGINS, [*list(BEGINS.values())[1:], 1.0], strict=True))


@dataclass
class Commissioning:
    """What has been found so far; a step that was not reached is None.

    Attributes:
        scan_points: (N, 3) scan of the fine step in {M}, mm.
        clamped_again: Registration of the blade as it was clamped for probing.
        presenting: The chain to the grinder whose error surface was measured.
        programs: Robot programs by name.
    """

    ball: ball.BallOutcome | None = None
    base: base.BaseOutcome | None = None
    rough: rough.RoughOutcome | None = None
    fine: fine.FineOutcome | None = None
    tool: tool.ToolOutcome | None = None
    error_surface: error_surface.ErrorSurfaceOutcome | None = None
    scan_points: NDArray[np.float64] = field(default_factory=lambda: np.zeros((0, 3)))
    clamped_again: fine.FineOutcome | None = None
    presenting: Presenting | None = None
    programs: dict[str, error_surface.Program] = field(default_factory=dict)

    @property
    def verdicts(self) -> dict[str, Verdict]:
        """The verdict of each step that was reached."""
        outcomes = {name: getattr(self, name) for name in BEGINS}
        return {name: outcome.verdict for name, outcome in outcomes.items() if outcome is not None}

    @property
    def accepted(self) -> bool:
        """True if all six steps were reached and accepted."""
        return len(self.verdicts) == len(BEGINS) and all(verdict.ok for verdict in self.verdicts.values())


@dataclass(frozen=True, eq=False)
class Commissioner:
    """Runs the steps; a rejected step ends the run, because everything after it would stand on it.

    Attributes:
        source: Where samples come from.
        plan: What is known about the cell.
        blade: The blade's type.
        model: Its CAD model.
        grinder: Whose error surface is measured.
        date: For the programs' headers.
        job: Progress and cancel.
        keep: Called with each step's record and whether it was accepted.
        on_step: Called when a step changes its state.
    """

    source: Source
    plan: CellPlan
    blade: BladeType
    model: CadModel
    grinder: str
    date: str
    job: Job
    keep: Keep
    on_step: Listener

    def run(self, found: Commissioning, only: Sequence[str] = tuple(BEGINS)) -> None:
        """All steps, until one is rejected.

        Args:
            found: Filled step by step, so that a listener can look at what is there.
            only: Names of the first steps, to end early.

        Raises:
            InputError: the samples of a step do not determine its result.
            DeviceError: a device failed or refused.
            Cancelled: the job was cancelled.
        """
        for name, step in (
            ("ball", self._ball),
            ("base", self._base),
            ("rough", self._rough),
            ("fine", self._fine),
            ("tool", self._tool),
            ("error_surface", self._error_surface),
        ):
            if name not in only:
                return
            self.on_step(StepEvent(name, StepState.RUNNING))
            self.job.report(BEGINS[name], TITLES[name])
            try:
                record, headline = step(found)
            except Cancelled:
                self.on_step(StepEvent(name, StepState.NOT_STARTED, "cancelled"))
                raise
            except Exception as error:
                self.on_step(StepEvent(name, StepState.FAILED, str(error)))
                raise
            verdict = found.verdicts[name]
            self.keep(name, record, verdict.ok)
            if not verdict.ok:
                self.on_step(StepEvent(name, StepState.FAILED, verdict.reasons[0].message))
                return
            self.on_step(StepEvent(name, StepState.ACCEPTED, headline))
        self.job.report(1.0, "done")

    def _part(self, step: str, start: float = 0.0, end: float = 1.0) -> Job:
        """The share of the whole work that acquiring a step's samples is."""
        begin, span = BEGINS[step], ENDS[step] - BEGINS[step]
        return self.job.part(begin + start * span, begin + end * span, f"{TITLES[step]}: ")

    def _ball(self, found: Commissioning) -> tuple[dict[str, Any], str]:
        found.ball = ball.solve(self.source.ball(self._part("ball")), self.plan.ball.diameter_mm)
        return ball.record(found.ball), f"held-out ball {found.ball.held_out.rms_mm:.3f} mm RMS"

    def _base(self, found: Commissioning) -> tuple[dict[str, Any], str]:
        assert found.ball is not None
        found.base = base.solve(self.source.base(self._part("base")), self.plan.ball.diameter_mm, found.ball.stage)
        return base.record(found.base), f"held-out ball {found.base.held_out.rms_mm:.3f} mm RMS"

    def _rough(self, found: Commissioning) -> tuple[dict[str, Any], str]:
        assert found.ball is not None
        found.rough = rough.solve(self.source.rough(self._part("rough")), found.ball.stage, self.model, self.blade)
        return rough.record(found.rough), rough.headline(found.rough)

    def _fine(self, found: Commissioning) -> tuple[dict[str, Any], str]:
        assert found.ball is not None and found.rough is not None
        samples = self.source.fine(self._part("fine"))
        found.scan_points = np.concatenate(fine.in_measure(samples, found.ball.stage))
        start = found.rough.measure_from_work
        found.fine = self._registered(found, samples, start, unmoved_since=start)
        return fine.record(found.fine), fine.headline(found.fine)

    def _registered(
        self, found: Commissioning, scans: Sequence[ScanSample], start: NDArray[np.float64], **unmoved: Any
    ) -> fine.FineOutcome:
        """The blade's frame from scans; `unmoved` as in the fine step's `solve`."""
        assert found.ball is not None and found.base is not None
        return fine.solve(scans, found.ball.stage, found.base.fit, self.model, self.blade, start, **unmoved)

    def _tool(self, found: Commissioning) -> tuple[dict[str, Any], str]:
        found.tool = tool.solve(self.source.tool(self._part("tool")), self.plan.grinders)
        held = found.tool.shafts_held_out[self.grinder]
        return tool.record(found.tool), f"held-out shaft mark {held.rms_mm:.3f} mm RMS"

    def _error_surface(self, found: Commissioning) -> tuple[dict[str, Any], str]:
        assert found.rough is not None and found.tool is not None
        scans = self.source.clamped_again(self._part("error_surface", 0.0, 0.1))
        clamped = self._registered(found, scans, found.rough.measure_from_work)
        found.clamped_again = clamped
        grinder = self.plan.grinders[self.grinder]
        wheel = found.tool.wheels[self.grinder]
        frames = CellFrames(
            wheel.base_from_tool, clamped.flange_from_work, grinder.wheel_radius_mm, grinder.contact_side
        )
        presenting = Presenting(self.model.spline_surface(self.blade.airfoil), frames, self.grinder)
        found.presenting = presenting
        samples = self.source.error_surface(
            self._part("error_surface", 0.1, 0.95), presenting, self.blade.probing
        )
        scans = self.source.after_probing(self._part("error_surface", 0.95, 1.0))
        start = clamped.fit.measure_from_work
        at_end = self._registered(found, scans, start, unmoved_since=start, unmoved_mm=RETURNED_LIMIT_MM)
        clamping = Verdict.of([*clamped.verdict.reasons, *at_end.verdict.reasons])
        info = {"blade_type": self.blade.name, "grinder": self.grinder, "date": self.date}
        rests_rad = found.tool.rests_rad.get(self.grinder, ())
        outcome = error_surface.solve(
            samples, wheel.radius_mm, presenting.normal_in_tool, info, clamping, rests_rad
        )
        found.error_surface = outcome
        if outcome.verdict.ok:
            for name, pattern in error_surface.patterns(self.blade.probing).items():
                found.programs[name] = error_surface.write_program(
                    name, presenting, outcome.surface, pattern, blade_type=self.blade.name, date=self.date
                )
        record = {
            **error_surface.record(outcome),
            "clamped_again": fine.record(clamped),
            "after_probing": fine.record(at_end),
        }
        return record, f"held-out error {outcome.held_out.rms_mm:.3f} mm RMS"
