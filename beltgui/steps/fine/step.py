"""Fine workpiece: the blade's frame from the faces of its STEP model, then carried to the flange."""

from __future__ import annotations

import math
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
from core.fine import FineFit, FineLimits, assign_points, judge_fine, solve_fine
from core.frames import PoseCovariance, inverse, transform_points
from core.progress import Progress, silent
from core.verdict import Code, Reason, Verdict, above

Array = NDArray[np.float64]
# A robot that stood still reports the same pose but for its encoders' last digits.
STANDSTILL_MM = 0.01
# A blade that stays in its clamp is found in the same place twice, but for the noise of both registrations.
UNMOVED_MM = 0.05
SIGMAS = 4.0
# So many points of a scan give its share and its RMS to half a percent.
ENOUGH_POINTS = 200_000


@dataclass(frozen=True)
class ScanShare:
    """What one scan says about the faces under the common pose.

    Attributes:
        name: Of the scan.
        points: In the scan.
        on_faces: Of them within the faces' filter boxes.
        mean_mm: Of their signed distances; NaN without points.
        rms_mm: The same, root mean square.
    """

    name: str
    points: int
    on_faces: int
    mean_mm: float
    rms_mm: float


@dataclass(frozen=True, eq=False)
class FineOutcome:
    """What the step found.

    Attributes:
        fit: Pose of the blade in {M}.
        flange_from_work: (4, 4) the blade in the flange.
        flange_covariance: Of its error in {F}: of this fit and of the base step, not of the robot's own pose.
        base_from_flange: (4, 4) where the flange was during the scans.
        face_ids: Of the faces measured on.
        scans: What each scan says, in their order.
        moved_mm: How far the blade's ends and middle are at most from where earlier scans of the same clamping found
            them; None if there were none.
        moved_limit_mm: How far they may be.
        verdict: Of the fit, its held-out checks included.
    """

    fit: FineFit
    flange_from_work: Array
    flange_covariance: PoseCovariance
    base_from_flange: Array
    face_ids: tuple[int, ...]
    scans: tuple[ScanShare, ...]
    moved_mm: float | None
    moved_limit_mm: float
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
    face_ids: Sequence[int] | None = None,
    progress: Progress = silent,
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
        face_ids: Faces to measure on; None takes the blade type's own.
        progress: Told of each stage; what it raises ends the work.

    Raises:
        InputError: the scans do not determine the pose, or do not show this blade.
    """
    base_from_flange = common_flange(samples)
    faces = type_faces(model, blade) if face_ids is None else tuple(face_ids)
    clouds = in_measure(samples, stage)
    fit = solve_fine(model, clouds, start, face_ids=faces, progress=progress)
    moved_mm = None if unmoved_since is None else _moved_mm(fit, unmoved_since)
    limit_mm = max(unmoved_mm, SIGMAS * math.sqrt(2.0) * float(fit.point_sigma_mm.max()))
    reasons = [*judge_fine(fit, limits_of(blade)).reasons, *_judge_moved(moved_mm, limit_mm)]
    flange_from_base = inverse(base_from_flange)
    in_base = _added(base.covariance, base.base_from_measure, fit.covariance)
    return FineOutcome(
        fit=fit,
        flange_from_work=flange_from_base @ base.base_from_measure @ fit.measure_from_work,
        flange_covariance=_carried(flange_from_base, in_base),
        base_from_flange=base_from_flange,
        face_ids=faces,
        scans=scan_shares([sample.name for sample in samples], clouds, model, fit, faces),
        moved_mm=moved_mm,
        moved_limit_mm=limit_mm,
        verdict=Verdict.of(reasons),
    )


def type_faces(model: CadModel, blade: BladeType) -> tuple[int, ...]:
    """Ids of the faces that a blade type registers on."""
    return tuple(face.id for face in model.select(blade.registration_faces))


def scan_shares(
    names: Sequence[str], clouds: Sequence[Array], model: CadModel, fit: FineFit, face_ids: Sequence[int]
) -> tuple[ScanShare, ...]:
    """What each scan (N, 3) in {M} says about the faces under the common pose."""
    shares = []
    for name, cloud in zip(names, clouds, strict=True):
        some = cloud[:: max(1, len(cloud) // ENOUGH_POINTS)]
        found = assign_points(
            model, some, fit.measure_from_work, face_ids, half_thickness_mm=SIGMAS * fit.sigma_mm,
            margin_mm=fit.settings.edge_margin_mm,
        )  # fmt: skip
        distances = found.distance_mm[found.face_id > 0]
        share = len(distances) / max(len(some), 1)
        mean, rms = float("nan"), float("nan")
        if len(distances):
            mean, rms = float(np.mean(distances)), float(np.sqrt(np.mean(distances**2)))
        shares.append(ScanShare(name, len(cloud), round(share * len(cloud)), mean, rms))
    return tuple(shares)


def _carried(a_from_b: Array, in_b: PoseCovariance) -> PoseCovariance:
    """The uncertainty of a pose in {b} when it is carried to {a} by a transform that is known exactly."""
    turn = np.zeros((6, 6))
    turn[:3, :3] = turn[3:, 3:] = a_from_b[:3, :3]
    return PoseCovariance(turn @ in_b.matrix @ turn.T, transform_points(a_from_b, in_b.about_mm))


def _added(of_a_from_b: PoseCovariance, a_from_b: Array, in_b: PoseCovariance) -> PoseCovariance:
    """The uncertainty in {a} of a pose known in {b}, where `a_from_b` is uncertain too; the two are independent."""
    carried = _carried(a_from_b, in_b)
    return PoseCovariance(carried.matrix + of_a_from_b.moved_to(carried.about_mm).matrix, carried.about_mm)


def _moved_mm(fit: FineFit, earlier: Array) -> float:
    ends = fit.ends_in_work_mm
    apart = transform_points(fit.measure_from_work, ends) - transform_points(earlier, ends)
    return float(np.linalg.norm(apart, axis=1).max())


def _judge_moved(moved_mm: float | None, limit_mm: float) -> list[Reason]:
    if moved_mm is None:
        return []
    return above(
        Code.HELD_OUT_ERROR,
        moved_mm,
        limit_mm,
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
        "flange_from_work": pose_block(outcome.flange_from_work, outcome.flange_covariance),
        "base_from_flange_at_scan": plain(outcome.base_from_flange),
        "moved_since_earlier_scans_mm": plain(outcome.moved_mm),
        "verdict": verdict_block(outcome.verdict),
    }
