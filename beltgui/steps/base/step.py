"""Base: the ball on the flange is scanned in several robot poses; gives the measuring frame in the robot's base."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from beltgui.jobs import Job
from beltgui.steps.ball.closing import Returned, acquire_with_closing, is_complete, returned
from beltgui.steps.ball.found import BallScan, ball_scans, judge_scans, missing_reasons, usable
from beltgui.steps.ball.step import carried
from beltgui.steps.base.record import record as fit_record
from beltgui.steps.blocks import plain, verdict_block
from beltgui.steps.context import Context
from beltgui.steps.held_out import HeldOut, is_held_out
from beltgui.steps.room import Bench
from core.ball import SphereFit, StageFit
from core.base import BaseFit, BaseLimits, judge_base, solve_base
from core.errors import InputError
from core.frames import rigid, rotation_from_euler_zyx, transform_points
from core.verdict import Code, Verdict
from devices.cell_plan import ScanPose
from devices.interfaces import Mount, StagePosition

Array = NDArray[np.float64]
STEP = "base"
HELD_OUT_LIMIT_MM = 1.0
# The robot comes back to a pose within its repeatability, some hundredths of a mm at the ball.
RETURNED_LIMIT_MM = 0.1


@dataclass(frozen=True, eq=False)
class BaseOutcome:
    """What the step found.

    Attributes:
        scans: All that were not deleted, in order of time.
        fitted: Those that the base was fitted to, in the order of its residuals.
        fit: From the poses that were not kept out.
        balls_mm: By sample id, (3,) the ball in {M}; scans that show none are not in it.
        misses_mm: By sample id, (3,) the ball by the robot less the ball by the scanner, in {B}.
        held_out: Ball in {B} by scanner against ball by robot, at the poses kept out.
        returned: The ball in the first scan and in the closing one, which is taken in the same pose.
        verdict: Of all of it.
    """

    scans: tuple[BallScan, ...]
    fitted: tuple[BallScan, ...]
    fit: BaseFit
    balls_mm: dict[int, Array]
    misses_mm: dict[int, Array]
    held_out: HeldOut
    returned: Returned
    verdict: Verdict

    @property
    def spheres(self) -> tuple[SphereFit, ...]:
        """The balls of all scans that are included, in {S}."""
        return tuple(scan.sphere for scan in self.scans if scan.usable)

    @property
    def returned_mm(self) -> float:
        """Distance between the ball in the first scan and in the closing one; NaN while it is not known."""
        return self.returned.moved_mm


def wanted_poses(bench: Bench) -> tuple[ScanPose, ...]:
    """The planned poses, then those asked for in addition.

    Setting `extra`: each {`translation_mm`, `euler_zyx_deg`} of base_from_flange and `stage`: [x, y, z in mm, theta in
    deg].
    """
    extra = bench.session.setting(STEP, "extra", [])
    return (*bench.plan.base_step, *(_extra_pose(number, entry) for number, entry in enumerate(extra, start=1)))


def _extra_pose(number: int, entry: Mapping[str, Sequence[float]]) -> ScanPose:
    x, y, z, theta_deg = entry["stage"]
    rotation = rotation_from_euler_zyx(*np.radians(entry["euler_zyx_deg"]))
    stage = StagePosition(x, y, z, float(np.radians(theta_deg)))
    return ScanPose(f"extra {number}", rigid(rotation, entry["translation_mm"]), stage)


def acquire(bench: Bench, context: Context) -> None:
    """Scan the ball on the flange in the planned poses that are missing, and at the end in the first one again."""
    poses = wanted_poses(bench)
    if is_complete(ball_scans(bench, STEP), len(poses)):
        return
    context.cell.operator.perform(Mount("ball"))
    acquire_with_closing(bench, context, STEP, poses)


def solve(bench: Bench, job: Job) -> BaseOutcome:
    """Fit the ball in every scan, the base on most poses, and check on the rest.

    Raises:
        InputError: the ball step has no result, no scan shows a ball, or the poses do not determine the frame.
        Cancelled: the job was cancelled.
    """
    if "ball" not in bench.found:
        raise InputError("The ball step has no result yet, so the scans cannot be placed. Finish the ball step first.")
    stage: StageFit = bench.found["ball"].stage
    scans = ball_scans(bench, STEP, job)
    used = usable(scans)
    if not used:
        raise InputError("No scan shows the ball yet. Take the scans.", Code.NOT_ENOUGH_POINTS)
    balls = {scan.id: carried(stage, scan) for scan in scans if scan.seen.sphere is not None}
    planned = len(bench.plan.base_step)
    fitted = [scan for scan in used if not is_held_out(scan.slot, planned)]
    fit = solve_base(
        np.array([scan.base_from_flange for scan in fitted]).reshape(-1, 4, 4),
        np.array([balls[scan.id] for scan in fitted]).reshape(-1, 3),
        ball_covariance_mm2=np.array([_ball_covariance(stage, scan) for scan in fitted]).reshape(-1, 3, 3),
    )
    misses = {scan.id: by_robot(fit, scan) - by_scanner(fit, balls[scan.id]) for scan in scans if scan.id in balls}
    errors = [np.linalg.norm(misses[scan.id]) for scan in used if is_held_out(scan.slot, planned)]
    held_out = HeldOut("ball centre in {B}", np.array(errors), HELD_OUT_LIMIT_MM)
    back = returned(scans, balls, RETURNED_LIMIT_MM)
    reasons = [
        *missing_reasons(scans, [pose.name for pose in wanted_poses(bench)]),
        *back.reasons(),
        *judge_scans(scans),
        *judge_base(fit, BaseLimits(), [scan.name for scan in fitted]).reasons,
        *held_out.reasons("The ball may have moved on the flange, or the robot's mastering is off: check both."),
    ]
    return BaseOutcome(scans, tuple(fitted), fit, balls, misses, held_out, back, Verdict.of(reasons))


def _ball_covariance(stage: StageFit, scan: BallScan) -> Array:
    """(3, 3) of the ball's centre in {M}, from its scan."""
    rotation = stage.measure_from_scanner_at(scan.stage_mm, scan.stage.theta_rad)[:3, :3]
    return np.asarray(rotation @ scan.sphere.covariance_mm2 @ rotation.T)


def by_robot(fit: BaseFit, scan: BallScan) -> Array:
    """(3,) the ball in {B}, as the flange carries it."""
    return transform_points(scan.base_from_flange, fit.ball_in_flange_mm)


def by_scanner(fit: BaseFit, ball_in_measure: Array) -> Array:
    """(3,) the ball in {B}, as the scanner sees it."""
    return transform_points(fit.base_from_measure, ball_in_measure)


def record(outcome: BaseOutcome) -> dict[str, Any]:
    """For the session and the report."""
    return {
        **fit_record(outcome.fit, outcome.verdict),
        "held_out": plain(outcome.held_out.block()),
        "returned_mm": plain(outcome.returned_mm),
        "verdict": verdict_block(outcome.verdict),
    }


def headline(outcome: BaseOutcome) -> str:
    """How well the ball is predicted in poses that were not fitted."""
    if not len(outcome.held_out.errors_mm):
        return f"fitted ball {outcome.fit.rms_mm:.3f} mm RMS, nothing held out"
    return f"held-out ball {outcome.held_out.rms_mm:.3f} mm RMS"
