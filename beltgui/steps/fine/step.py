"""Fine workpiece: the blade's frame from the faces of its STEP model, then carried to the flange."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from beltgui.steps.blocks import plain, pose_block, verdict_block
from beltgui.steps.context import Context
from beltgui.steps.fine.record import record as fit_record
from beltgui.steps.scans import ScanSample, acquire_scans
from core.ball import StageFit
from core.base import BaseFit
from core.cad import CadModel
from core.cad.blade_type import BladeType
from core.errors import InputError
from core.fine import FineFit, FineLimits, judge_fine, solve_fine
from core.frames import inverse, transform_points
from core.verdict import Code, Reason, Verdict, above

Array = NDArray[np.float64]
# A robot that stood still reports the same pose but for its encoders' last digits.
STANDSTILL_MM = 0.01
# A blade that stays in its clamp is found in the same place twice, but for the noise of both registrations.
UNMOVED_MM = 0.05
SIGMAS = 4.0


@dataclass(frozen=True, eq=False)
class FineOutcome:
    """What the step found.

    Attributes:
        fit: Pose of the blade in {M}.
        flange_from_work: (4, 4) the blade in the flange.
        base_from_flange: (4, 4) where the flange was during the scans.
        moved_mm: How far the blade's ends and middle are at most from where earlier scans of the same clamping found
            them; None if there were none.
        verdict: Of the fit, its held-out checks included.
    """

    fit: FineFit
    flange_from_work: Array
    base_from_flange: Array
    moved_mm: float | None
    verdict: Verdict


def acquire(context: Context) -> list[ScanSample]:
    """Scan the clamped blade."""
    return acquire_scans(context, "fine", context.plan.fine_step)


def in_measure(samples: Sequence[ScanSample], stage: StageFit) -> list[Array]:
    """The clouds (N, 3) of all scans in {M}, mm."""
    return [
        transform_points(stage.measure_from_scanner_at(s.stage_mm, s.stage.theta_rad), s.points_in_scanner)
        for s in samples
    ]


def common_flange(samples: Sequence[ScanSample]) -> Array:
    """base_from_flange of scans that were taken in one robot pose.

    Raises:
        InputError: no scans, or the robot moved between them.
    """
    if not samples:
        raise InputError("There are no scans of the blade. Scan it first.")
    first = samples[0].base_from_flange
    for sample in samples[1:]:
        moved = float(np.linalg.norm(sample.base_from_flange[:3, 3] - first[:3, 3]))
        if moved > STANDSTILL_MM:
            raise InputError(
                f"The robot moved by {moved:.3f} mm between the scans '{samples[0].name}' and '{sample.name}'; all "
                "scans of one blade must be taken in the same robot pose. Scan again."
            )
    return first


def solve(
    samples: Sequence[ScanSample],
    stage: StageFit,
    base: BaseFit,
    model: CadModel,
    blade: BladeType,
    start: Array,
    *,
    unmoved_since: Array | None = None,
    unmoved_mm: float = UNMOVED_MM,
) -> FineOutcome:
    """Register the scans to the model's faces.

    Args:
        samples: Scans of the blade, all in one robot pose.
        stage: Result of the ball step.
        base: Result of the base step.
        model: The blade's CAD model.
        blade: Its type: faces and limits.
        start: (4, 4) measure_from_work, roughly.
        unmoved_since: (4, 4) measure_from_work by other scans of the same clamping, as exact as these. Two scans that
            see different faces say little about a blade that slips between them; other scans do.
        unmoved_mm: How far from there the blade may be; more where the robot has moved in between.

    Raises:
        InputError: the scans do not determine the pose, or do not show this blade.
    """
    base_from_flange = common_flange(samples)
    face_ids = [face.id for face in model.select(blade.registration_faces)]
    fit = solve_fine(model, in_measure(samples, stage), start, face_ids=face_ids)
    flange_from_work = inverse(base_from_flange) @ base.base_from_measure @ fit.measure_from_work
    moved_mm = None if unmoved_since is None else _moved_mm(fit, unmoved_since)
    reasons = [*judge_fine(fit, limits_of(blade)).reasons, *_judge_moved(fit, moved_mm, unmoved_mm)]
    return FineOutcome(fit, flange_from_work, base_from_flange, moved_mm, Verdict.of(reasons))


def _moved_mm(fit: FineFit, earlier: Array) -> float:
    ends = fit.ends_in_work_mm
    apart = transform_points(fit.measure_from_work, ends) - transform_points(earlier, ends)
    return float(np.linalg.norm(apart, axis=1).max())


def _judge_moved(fit: FineFit, moved_mm: float | None, limit_mm: float) -> list[Reason]:
    if moved_mm is None:
        return []
    chance = SIGMAS * np.sqrt(2.0) * float(fit.point_sigma_mm.max())
    return above(
        Code.HELD_OUT_ERROR,
        moved_mm,
        max(limit_mm, chance),
        "The distance of the blade from where earlier scans of the same clamping found it",
        "It has slipped in its clamp, or robot or stage have moved: fasten it and begin again with the rough step.",
    )


def limits_of(blade: BladeType) -> FineLimits:
    """The type's own limits."""
    return FineLimits(
        rms_mm=blade.limits.rms_mm,
        min_points_per_face=blade.limits.min_points_per_face,
        point_sigma_mm=blade.limits.contact_sigma_mm,
    )


def headline(outcome: FineOutcome) -> str:
    """The number that matters."""
    return f"RMS on the faces {1000.0 * outcome.fit.rms_mm:.0f} µm, {outcome.fit.points_used} points"


def record(outcome: FineOutcome) -> dict[str, Any]:
    """For the session and the report."""
    return {
        **fit_record(outcome.fit, outcome.verdict),
        "flange_from_work": pose_block(outcome.flange_from_work),
        "base_from_flange_at_scan": plain(outcome.base_from_flange),
        "moved_since_earlier_scans_mm": plain(outcome.moved_mm),
        "verdict": verdict_block(outcome.verdict),
    }
