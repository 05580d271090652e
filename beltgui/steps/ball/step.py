"""Ball: the ball stands still, the stage moves the scanner; gives the scanner's place at every stage position."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray
from scipy.optimize import brentq

from beltgui.jobs import Job
from beltgui.steps.ball.closing import Returned, acquire_with_closing, is_complete, returned
from beltgui.steps.ball.found import BallScan, ball_scans, judge_scans, missing_reasons, usable
from beltgui.steps.ball.record import sphere_record, stage_record
from beltgui.steps.blocks import plain, verdict_block
from beltgui.steps.context import Context
from beltgui.steps.held_out import HeldOut, is_held_out
from beltgui.steps.room import Bench
from core.ball import SphereFit, StageFit, StageLimits, StageObservations, judge_stage, solve_stage
from core.ball.stage_checks import STILL_RAD
from core.errors import InputError
from core.frames import transform_points
from core.verdict import Code, Verdict
from devices.cell_plan import ScanPose
from devices.interfaces import Mount, StagePosition

Array = NDArray[np.float64]
STEP = "ball"
HELD_OUT_LIMIT_MM = 0.03
# Nothing but the stage moved: its repeatability and the noise of a ball centre are some µm.
RETURNED_LIMIT_MM = 0.03


@dataclass(frozen=True, eq=False)
class BallOutcome:
    """What the step found.

    Attributes:
        scans: All that were not deleted, in order of time.
        fitted: Those that the stage was fitted to, in the order of its residuals.
        stage: The stage's axes, from the scans that were not kept out.
        scatter_mm: What the stage's repeatability adds to the noise of a ball's centre, each coordinate; 0 if the
            noise of the scans explains the residuals.
        misses_mm: By sample id, (3,) the ball as that scan sees it less the fitted one, in {M}; scans that show none or
            stand where the stage is not known are not in it.
        held_out: Ball centre in {M} from the scans kept out, against the fitted one.
        returned: The ball in the first scan and in the closing one, which is taken at the same place.
        verdict: Of all of it.
    """

    scans: tuple[BallScan, ...]
    fitted: tuple[BallScan, ...]
    stage: StageFit
    scatter_mm: float
    misses_mm: dict[int, Array]
    held_out: HeldOut
    returned: Returned
    verdict: Verdict

    @property
    def sigma_mm(self) -> float:
        """Noise of each coordinate of a ball's centre, the stage's repeatability in it; RMS over the fit."""
        return float(np.sqrt(np.mean(_sphere_sigmas(self.fitted) ** 2) + self.scatter_mm**2))

    @property
    def spheres(self) -> tuple[SphereFit, ...]:
        """The balls of all scans that are included, in {S}."""
        return tuple(scan.sphere for scan in self.scans if scan.usable)

    @property
    def returned_mm(self) -> float:
        """Distance between the ball in the first scan and in the closing one; NaN while it is not known."""
        return self.returned.moved_mm


def wanted_poses(bench: Bench) -> tuple[ScanPose, ...]:
    """The planned scans, then those asked for in addition: setting `extra`, each [x, y, z in mm, theta in deg]."""
    planned = bench.plan.stage_step
    extra = bench.session.setting(STEP, "extra", [])
    return (*planned, *(
        ScanPose(f"extra {number}", planned[0].base_from_flange, StagePosition(x, y, z, float(np.radians(theta_deg))))
        for number, (x, y, z, theta_deg) in enumerate(extra, start=1)
    ))  # fmt: skip


def acquire(bench: Bench, context: Context) -> None:
    """Mount the ball, take the scans that are missing, and at the end the first place again."""
    poses = wanted_poses(bench)
    if is_complete(ball_scans(bench, STEP), len(poses)):
        return
    context.cell.operator.perform(Mount("ball"))
    acquire_with_closing(bench, context, STEP, poses)


def solve(bench: Bench, job: Job) -> BallOutcome:
    """Fit the ball in every scan, then the stage on most of them, then check on the rest.

    Raises:
        InputError: no scan shows a ball, or the positions do not determine the stage.
        Cancelled: the job was cancelled.
    """
    scans = ball_scans(bench, STEP, job)
    used = usable(scans)
    if not used:
        raise InputError("No scan shows the ball yet. Take the scans.", Code.NOT_ENOUGH_POINTS)
    planned = len(bench.plan.stage_step)
    fitted = [scan for scan in used if not is_held_out(scan.slot, planned)]
    stage, scatter_mm = fit_stage(fitted)
    misses = {scan.id: carried(stage, scan) - stage.ball_in_measure_mm for scan in scans if can_carry(stage, scan)}
    held = [scan for scan in used if is_held_out(scan.slot, planned) and scan.id in misses]
    errors = [np.linalg.norm(misses[scan.id]) for scan in held]
    held_out = HeldOut("ball centre in {M}", np.array(errors), HELD_OUT_LIMIT_MM)
    centers = {scan.id: scan.sphere.center_mm for scan in scans if scan.usable}
    back = returned(scans, centers, RETURNED_LIMIT_MM)
    reasons = [
        *missing_reasons(scans, [pose.name for pose in wanted_poses(bench)]),
        *back.reasons(),
        *judge_scans(scans),
        *judge_stage(stage, StageLimits(), [scan.name for scan in fitted]).reasons,
        *held_out.reasons("The ball or the scanner may have moved between the scans: fasten both, scan again."),
    ]
    return BallOutcome(scans, tuple(fitted), stage, scatter_mm, misses, held_out, back, Verdict.of(reasons))


def fit_stage(scans: Sequence[BallScan]) -> tuple[StageFit, float]:
    """The stage, and the scatter (mm, each coordinate) that it adds to the noise of the ball centres.

    A ball's centre is known to 2 µm, a stage comes back to 3 µm: with the noise of the scans alone the covariance would
    be too small. The scatter is the isotropic variance with which the weighted squares equal their degrees of freedom
    (Paule & Mandel, J. Res. NBS 87, 1982).

    Raises:
        InputError: the positions do not determine the stage.
    """
    sigmas = _sphere_sigmas(scans)
    fit = solve_stage(_observations(scans, sigmas))
    squares = np.sum(fit.residuals_mm**2, axis=1)

    def excess(scatter_mm: float) -> float:
        return float(np.sum(squares / (sigmas**2 + scatter_mm**2))) - fit.redundancy

    if not fit.redundancy or excess(0.0) <= 0.0:
        return fit, 0.0
    scatter_mm = float(brentq(excess, 0.0, float(np.sqrt(squares.sum() / fit.redundancy))))
    return solve_stage(_observations(scans, np.hypot(sigmas, scatter_mm))), scatter_mm


def _sphere_sigmas(scans: Sequence[BallScan]) -> Array:
    """(N,) noise of each coordinate of the ball centres by their own scans, mm."""
    return np.array([np.sqrt(np.trace(scan.sphere.covariance_mm2) / 3.0) for scan in scans])


def _observations(scans: Sequence[BallScan], sigma_mm: Array) -> StageObservations:
    return StageObservations(
        stage_mm=np.array([scan.stage_mm for scan in scans]).reshape(-1, 3),
        stage_rad=np.array([scan.stage.theta_rad for scan in scans]),
        ball_in_scanner_mm=np.array([scan.sphere.center_mm for scan in scans]).reshape(-1, 3),
        sigma_mm=sigma_mm,
    )


def can_carry(stage: StageFit, scan: BallScan) -> bool:
    """True if the scan shows a ball and stands where the stage is known."""
    turned = abs(scan.stage.theta_rad - stage.rotary_reference_rad) > STILL_RAD
    return scan.seen.sphere is not None and (stage.rotary_axis is not None or not turned)


def carried(stage: StageFit, scan: BallScan) -> Array:
    """(3,) the ball of a scan in {M}."""
    return transform_points(stage.measure_from_scanner_at(scan.stage_mm, scan.stage.theta_rad), scan.sphere.center_mm)


def record(outcome: BallOutcome) -> dict[str, Any]:
    """For the session and the report."""
    return {
        "stage": stage_record(outcome.stage, Verdict()),
        "stage_scatter_mm": outcome.scatter_mm,
        "spheres": [sphere_record(sphere, Verdict()) for sphere in outcome.spheres],
        "held_out": plain(outcome.held_out.block()),
        "returned_mm": plain(outcome.returned_mm),
        "verdict": verdict_block(outcome.verdict),
    }


def headline(outcome: BallOutcome) -> str:
    """How well the ball is predicted by what was not fitted to it."""
    if not len(outcome.held_out.errors_mm):
        return f"fitted ball {outcome.stage.rms_mm:.3f} mm RMS, nothing held out"
    return f"held-out ball {outcome.held_out.rms_mm:.3f} mm RMS"
