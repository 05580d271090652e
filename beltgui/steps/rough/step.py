"""Rough workpiece: the blade's first pose, found in the scan without a start; the fine step has to confirm it."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from beltgui.steps.context import Context
from beltgui.steps.fine.step import in_measure, limits_of
from beltgui.steps.rough.record import automatic_record
from beltgui.steps.scans import ScanSample, acquire_scans
from core.ball import StageFit
from core.cad import CadModel
from core.cad.blade_type import BladeType
from core.fine import FineFit, judge_fine, solve_fine
from core.rough import GlobalFit, GlobalSettings, register_globally
from core.verdict import Verdict
from devices.interfaces import Mount

Array = NDArray[np.float64]


@dataclass(frozen=True, eq=False)
class RoughOutcome:
    """What the step found.

    Attributes:
        fit: Pose of the blade in {M} and the fine registration that confirmed it.
        verdict: Of that confirmation.
    """

    fit: GlobalFit[FineFit]
    verdict: Verdict

    @property
    def measure_from_work(self) -> Array:
        """(4, 4)."""
        return self.fit.measure_from_work


def acquire(context: Context) -> list[ScanSample]:
    """Have the blade clamped and scan it."""
    context.cell.operator.perform(Mount("blade", context.serial))
    return acquire_scans(context, "rough", context.plan.fine_step)


def solve(samples: Sequence[ScanSample], stage: StageFit, model: CadModel, blade: BladeType) -> RoughOutcome:
    """Find the blade in its scans from any pose.

    Args:
        samples: Scans of the blade, all in one robot pose.
        stage: Result of the ball step.
        model: The blade's CAD model.
        blade: Its type: faces and limits.

    Raises:
        InputError: no pose was confirmed: this is not that blade, or too little of it was seen.
    """
    face_ids = [face.id for face in model.select(blade.registration_faces)]

    def confirm(cad: CadModel, scans: Sequence[Array], start: Array) -> FineFit:
        return solve_fine(cad, scans, start, face_ids=face_ids)

    settings = GlobalSettings(surface_mm=max(GlobalSettings.surface_mm, blade.stock_mm))
    points = np.concatenate(in_measure(samples, stage))
    fit = register_globally(model, points, confirm=confirm, settings=settings)
    return RoughOutcome(fit, judge_fine(fit.fine, limits_of(blade)))


def headline(outcome: RoughOutcome) -> str:
    """The number that matters."""
    return f"found automatically, RMS on the faces {1000.0 * outcome.fit.fine.rms_mm:.0f} µm"


def record(outcome: RoughOutcome) -> dict[str, Any]:
    """For the session and the report."""
    return automatic_record(outcome.fit, outcome.verdict)
