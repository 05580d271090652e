"""Verdicts of the ball step: is the sphere good enough, is the stage good enough."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from core.ball.sphere import SphereFit
from core.ball.stage import StageFit
from core.verdict import Code, Reason, Verdict, above

AIM = "Clean the ball, scan it closer and from a side on which nothing hides it."


@dataclass(frozen=True)
class SphereLimits:
    """Limits of one ball scan; defaults suit a scanner of 0.035 to 0.05 mm noise and a ball of about 20 mm.

    Attributes:
        max_sigma_mm: Noise along the radius.
        max_sphericity_mm: Range of the inliers' residuals (about 7 sigma for many points).
        min_coverage: Share of the sphere seen; 0.015 is a cap of 14 degrees half-angle.
        min_inlier_share: Share of the points on the ball; below it the ball is lost in its surroundings.
        min_inliers: Points on the ball.
        max_center_sigma_mm: Standard deviation of the centre along its worst direction.
        certified_diameter_mm: If known, a free diameter is compared with it.
        max_diameter_error_mm: Allowed difference between the certified and the freely fitted diameter, beyond 4 sigma.
        max_hint_error: Allowed relative difference between a hinted and the fitted diameter.
        max_held_out_mm: Allowed difference between the centres of opposite halves, beyond 5 sigma of the noise.
    """

    max_sigma_mm: float = 0.1
    max_sphericity_mm: float = 0.7
    min_coverage: float = 0.015
    min_inlier_share: float = 0.01
    min_inliers: int = 25
    max_center_sigma_mm: float = 0.1
    certified_diameter_mm: float | None = None
    max_diameter_error_mm: float = 0.1
    max_hint_error: float = 0.05
    max_held_out_mm: float = 0.1


def judge_sphere(fit: SphereFit, limits: SphereLimits | None = None) -> Verdict:
    """Judge a ball scan; every reason says what to do."""
    limits = limits or SphereLimits()
    inliers = int(np.count_nonzero(fit.inliers))
    worst = float(np.sqrt(max(np.linalg.eigvalsh(fit.covariance_mm2)[-1], 0.0)))
    free = "" if fit.diameter_fixed else " or fix the certified diameter"
    reasons = [
        *above(Code.HIGH_RESIDUAL, fit.sigma_mm, limits.max_sigma_mm, "The noise of the ball's surface", AIM),
        *above(Code.HIGH_RESIDUAL, fit.sphericity_mm, limits.max_sphericity_mm, "The sphericity", AIM),
        *above(
            Code.HIGH_UNCERTAINTY,
            worst,
            limits.max_center_sigma_mm,
            "The uncertainty of the ball's centre",
            f"Scan more of the ball{free}.",
        ),
        *above(
            Code.HELD_OUT_ERROR,
            fit.held_out_mm,
            max(limits.max_held_out_mm, 5.0 * fit.held_out_sigma_mm),
            "The distance between the centres of two halves of the ball",
            "Look for something that touches the ball, dirt or edge ghosts on one side.",
        ),
        *_share_reasons(fit, inliers, limits),
        *_diameter_reasons(fit, limits),
    ]
    if not fit.converged:
        reasons.append(Reason(Code.NOT_CONVERGED, "The sphere fit was still moving. Scan the ball again."))
    return Verdict.of(reasons)


def _share_reasons(fit: SphereFit, inliers: int, limits: SphereLimits) -> list[Reason]:
    reasons = []
    if inliers < limits.min_inliers:
        message = f"Only {inliers} points lie on the ball, {limits.min_inliers} are asked. Scan it closer."
        reasons.append(Reason(Code.NOT_ENOUGH_POINTS, message))
    if fit.coverage < limits.min_coverage:
        message = (
            f"Only {100.0 * fit.coverage:.2g} % of the ball's surface was seen, {100.0 * limits.min_coverage:.2g} % "
            "are asked. Turn the ball's free side to the scanner."
        )
        reasons.append(Reason(Code.LOW_COVERAGE, message))
    if fit.inlier_share < limits.min_inlier_share:
        message = (
            f"Only {100.0 * fit.inlier_share:.2g} % of the points lie on the ball, "
            f"{100.0 * limits.min_inlier_share:.2g} % are asked. Cut away the surroundings or scan the ball closer."
        )
        reasons.append(Reason(Code.TOO_MANY_OUTLIERS, message))
    return reasons


def _diameter_reasons(fit: SphereFit, limits: SphereLimits) -> list[Reason]:
    certified = fit.diameter_mm if fit.diameter_fixed else limits.certified_diameter_mm
    advice = "Check the certified diameter and the scanner's scale."
    reasons = []
    if certified is not None:
        error = abs(fit.free_diameter_mm - certified)
        limit = max(limits.max_diameter_error_mm, 4.0 * fit.free_diameter_sigma_mm)
        what = f"The difference between the fitted ({fit.free_diameter_mm:.4f} mm) and the certified diameter"
        reasons += above(Code.OUTSIDE_LIMITS, error, limit, what, advice)
    elif fit.expected_diameter_mm is not None:
        error = abs(fit.diameter_mm - fit.expected_diameter_mm)
        limit = max(limits.max_hint_error * fit.expected_diameter_mm, 4.0 * fit.diameter_sigma_mm)
        what = f"The difference between the fitted ({fit.diameter_mm:.4f} mm) and the expected diameter"
        reasons += above(Code.OUTSIDE_LIMITS, error, limit, what, advice)
    return reasons


@dataclass(frozen=True)
class StageLimits:
    """Limits of a stage calibration.

    Attributes:
        max_rms_mm: RMS length of the residuals.
        max_leave_one_out_mm: Largest leave-one-out error.
        max_outlier_mm: Largest leave-one-out error of an observation that the others contradict.
        max_squareness_rad: Largest deviation of a pair of axes from 90 degrees (0.5 degrees).
        max_scale_error: Largest deviation of mm moved per mm commanded from 1.
        max_point_sigma_mm: Uncertainty of the ball in {M}, worst direction.
        max_condition: Of all unknowns.
        require_redundancy: Reject a set of observations that leaves nothing to check; with one position for each axis
            a slip of 0.5 mm turns an axis by 0.3 degrees and nothing shows it.
        require_right_handed: Reject axes that are no right-handed set: one counts backwards or two are exchanged.
    """

    max_rms_mm: float = 0.1
    max_leave_one_out_mm: float = 0.3
    max_outlier_mm: float = 0.1
    max_squareness_rad: float = 0.5 * np.pi / 180.0
    max_scale_error: float = 0.005
    max_point_sigma_mm: float = 0.1
    max_condition: float = 1e3
    require_redundancy: bool = True
    require_right_handed: bool = True


def judge_stage(fit: StageFit, limits: StageLimits | None = None, names: Sequence[str] | None = None) -> Verdict:
    """Judge a stage calibration; every reason says what to do.

    Args:
        fit: To judge.
        limits: Its limits.
        names: What a person calls each observation; None: their numbers, counted from 0.
    """
    limits = limits or StageLimits()
    add = "Add scans of the ball at positions that differ more."
    repeat = "Check that the ball did not move and repeat the worst observation."
    reasons = above(Code.HIGH_RESIDUAL, fit.rms_mm, limits.max_rms_mm, "The RMS residual", repeat)
    known = np.flatnonzero(np.isfinite(fit.leave_one_out_mm))
    if known.size:
        worst = int(known[np.argmax(fit.leave_one_out_mm[known])])
        what = f"The error of {_called(worst, names)} predicted from the others"
        value = float(fit.leave_one_out_mm[worst])
        reasons += above(Code.HELD_OUT_ERROR, value, limits.max_leave_one_out_mm, what, repeat)
    if fit.outlier is not None:
        what = f"The error of {_called(fit.outlier, names)}, which the others contradict,"
        value = float(fit.leave_one_out_mm[fit.outlier])
        reasons += above(Code.HELD_OUT_ERROR, value, limits.max_outlier_mm, what, "Repeat it or leave it out.")
    if limits.require_right_handed and np.linalg.det(fit.axes) < 0.0:
        message = (
            "The axes x, y, z form a left-handed set: one axis counts backwards, or two are exchanged. Check the signs "
            "and the order of stage_mm and of the ball centres."
        )
        reasons.append(Reason(Code.WRONG_MODEL, message))
    for pair, angle in zip(("xy", "yz", "zx"), fit.squareness_rad, strict=True):
        degrees = float(np.degrees(abs(angle)))
        limit = float(np.degrees(limits.max_squareness_rad))
        advice = "Check the mounting of the axes and that their order and signs are right."
        reasons += above(Code.OUTSIDE_LIMITS, degrees, limit, f"The squareness error of {pair}", advice, "deg")
    for name, scale in zip("xyz", fit.scale, strict=True):
        what = f"The scale error of axis {name} ({scale:.5f} mm per mm)"
        advice = "Check the unit and pitch of the axis and the scanner's scale."
        reasons += above(Code.OUTSIDE_LIMITS, abs(float(scale) - 1.0), limits.max_scale_error, what, advice, "mm/mm")
    if fit.model_covariance is not None:
        sigma = float(np.sqrt(np.linalg.eigvalsh(fit.ball_covariance_mm2())[-1]))
        what = "The uncertainty of the ball in the measurement frame"
        reasons += above(Code.HIGH_UNCERTAINTY, sigma, limits.max_point_sigma_mm, what, add)
    weak = f"The condition number (weak: {fit.conditioning.description})"
    reasons += above(Code.ILL_CONDITIONED, fit.conditioning.condition, limits.max_condition, weak, add, "")
    if limits.require_redundancy and fit.redundancy == 0:
        message = "The observations just determine the stage and leave nothing to check it with. Add one position."
        reasons.append(Reason(Code.NO_REDUNDANCY, message))
    if not fit.converged:
        reasons.append(Reason(Code.NOT_CONVERGED, f"The stage fit was still moving after its iterations. {add}"))
    return Verdict.of(reasons)


def _called(index: int, names: Sequence[str] | None) -> str:
    return f"observation {index}" if names is None else f"'{names[index]}'"
