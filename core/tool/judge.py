"""Are stylus and wheel known well enough to grind by?"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from core.tool.stylus import StylusFit
from core.tool.wheel import WheelFit, arc_needed_rad
from core.verdict import Code, Reason, Verdict, above


@dataclass(frozen=True)
class StylusLimits:
    """Limits of `judge_stylus`; published pivot calibrations of belt-grinding cells reach 0.1 mm RMS.

    Attributes:
        rms_mm: RMS length of the residuals.
        leave_one_out_mm: Largest held-out error of a single touch.
        outlier_mm: Largest held-out error of a touch that the others contradict.
        tip_sigma_mm: Largest standard deviation of the tip, over directions.
        turn_rad: Smallest accepted largest angle between two orientations (20 deg).
        condition: Largest condition number of tip and pivot together.
        different_poses: Fewest different poses; five leave enough over to notice a bad touch.
        unchecked_observations: Most touches that are the only witness of something.
        rejected: Most touches that the robust fit may have left out.
    """

    rms_mm: float = 0.3
    leave_one_out_mm: float = 0.8
    outlier_mm: float = 0.2
    tip_sigma_mm: float = 0.2
    turn_rad: float = 0.35
    condition: float = 50.0
    different_poses: int = 5
    unchecked_observations: int = 0
    rejected: int = 1


def judge_stylus(fit: StylusFit, limits: StylusLimits | None = None, names: Sequence[str] | None = None) -> Verdict:
    """Judge residuals, held-out errors, uncertainty, spread of orientations and redundancy.

    Args:
        fit: To judge.
        limits: Its limits.
        names: What a person calls each touch; None: their numbers, counted from 0.
    """
    use = limits or StylusLimits()
    worst = f"Look at {_called(fit.worst, names)} first; repeat it or add touches."
    weak = f"Weakest: {fit.conditioning.description}. Tilt the flange further and about other axes."
    reasons = _too_few(fit, use, names)
    reasons += above(Code.HIGH_RESIDUAL, fit.rms_mm, use.rms_mm, "The RMS residual", worst)
    errors = fit.leave_one_out_mm[fit.used & np.isfinite(fit.leave_one_out_mm)]
    largest = float(errors.max()) if len(errors) else 0.0
    reasons += above(Code.HELD_OUT_ERROR, largest, use.leave_one_out_mm, "The largest held-out error", worst)
    if fit.outlier is not None:
        what = f"The held-out error of {_called(fit.outlier, names)}, which the others contradict,"
        odd = float(fit.leave_one_out_mm[fit.outlier])
        reasons += above(Code.HELD_OUT_ERROR, odd, use.outlier_mm, what, "Repeat it or leave it out.")
    sigma = float(np.sqrt(np.linalg.eigvalsh(fit.tip_covariance_mm2)[-1]))
    reasons += above(Code.HIGH_UNCERTAINTY, sigma, use.tip_sigma_mm, "The standard deviation of the tip", weak)
    if not fit.turn_rad >= use.turn_rad:
        reasons.append(
            Reason(
                Code.NOT_ENOUGH_VARIATION,
                f"The flange orientations differ by {np.degrees(fit.turn_rad):.3g} deg at most, "
                f"{np.degrees(use.turn_rad):.3g} deg are needed. Tilt the flange further.",
            )
        )
    condition = fit.conditioning.condition
    reasons += above(Code.ILL_CONDITIONED, condition, use.condition, "The condition of the fit", weak, "(ratio)")
    return Verdict.of(reasons)


def _too_few(fit: StylusFit, use: StylusLimits, names: Sequence[str] | None) -> list[Reason]:
    reasons = []
    if fit.different_poses < use.different_poses:
        reasons.append(
            Reason(
                Code.NO_REDUNDANCY,
                f"There are {fit.different_poses} different poses, {use.different_poses} are needed so that a bad "
                "touch would show. Add touches.",
            )
        )
    alone = np.flatnonzero(fit.unchecked_directions)
    if len(alone) > use.unchecked_observations:
        reasons.append(
            Reason(
                Code.NO_REDUNDANCY,
                f"Only {_called(int(alone[0]), names)} is a witness of something, so a mistake in it would not show. "
                "Add touches like it.",
            )
        )
    rejected = int(np.count_nonzero(~fit.used))
    if rejected > use.rejected:
        reasons.append(
            Reason(
                Code.TOO_MANY_OUTLIERS,
                f"{rejected} of {len(fit.used)} touches were rejected, at most {use.rejected} may be. Check that the "
                "tip sits in the cone and repeat.",
            )
        )
    return reasons


@dataclass(frozen=True)
class WheelLimits:
    """Limits of `judge_wheel`; the defaults suit a floating head of 100 to 300 mm that swings by 20 deg or more.

    Attributes:
        rms_mm: RMS length of the residuals.
        leave_one_out_mm: Largest distance of a held-out touch from the circle of the others.
        leave_one_out_rad: Largest angle error of a held-out touch (0.5 deg).
        angle_rms_rad: RMS of the sensor's residuals (0.3 deg).
        axis_tilt_sigma_rad: Standard deviation of the axis direction (about 1 deg): 0.2 mm at the
            edge of a 25 mm wheel.
        position_sigma_mm: Largest standard deviation of the wheel centre, over directions.
        radius_sigma_mm: Standard deviation of a fitted radius.
        radius_error_mm: Largest difference between a given radius and what the data say, if beyond three sigma.
        angle_scale_error: Largest deviation of the sensor's scale from 1, if beyond three sigma.
        different_touches: Fewest touches at different places; four allow each to be checked by the others, with three a
            slip of 2 mm turns the axis by degrees and nothing shows it.
        expected_axis_in_base: (3,) rough direction about which the sensor should count right-handed; None: not checked.
    """

    rms_mm: float = 0.3
    leave_one_out_mm: float = 0.8
    leave_one_out_rad: float = 0.0087
    angle_rms_rad: float = 0.0052
    axis_tilt_sigma_rad: float = 0.0175
    position_sigma_mm: float = 0.3
    radius_sigma_mm: float = 1.0
    radius_error_mm: float = 0.5
    angle_scale_error: float = 0.02
    different_touches: int = 4
    expected_axis_in_base: tuple[float, float, float] | None = None


def judge_wheel(fit: WheelFit, limits: WheelLimits | None = None, names: Sequence[str] | None = None) -> Verdict:
    """Judge residuals, held-out errors, uncertainty, and the given radius and sensor against the data.

    Args:
        fit: To judge.
        limits: Its limits.
        names: What a person calls each touch; None: their numbers, counted from 0.
    """
    use = limits or WheelLimits()
    reasons: list[Reason] = []
    if fit.different_touches < use.different_touches:
        reasons.append(
            Reason(
                Code.NO_REDUNDANCY,
                f"There are {fit.different_touches} touches at different places, {use.different_touches} are needed "
                "so that a mistake would show. Touch the shaft at more head angles.",
            )
        )
    reasons += _judge_wheel_residuals(fit, use, names)
    reasons += _judge_wheel_uncertainty(fit, use)
    reasons += _judge_wheel_model(fit, use)
    return Verdict.of(reasons)


def _judge_wheel_residuals(fit: WheelFit, use: WheelLimits, names: Sequence[str] | None) -> list[Reason]:
    reasons = above(
        Code.HIGH_RESIDUAL,
        fit.rms_mm,
        use.rms_mm,
        "The RMS residual",
        "Repeat the touches; check that the tip is in place.",
    )
    angle_rms = float(np.degrees(np.sqrt(np.mean(fit.angle_residuals_rad**2))))
    sensor = "Check the angle sensor and that it is read at the moment of the touch."
    limit = float(np.degrees(use.angle_rms_rad))
    reasons += above(Code.HIGH_RESIDUAL, angle_rms, limit, "The RMS of the angle residuals", sensor, "deg")
    checked = np.isfinite(fit.leave_one_out_mm)
    if not np.any(checked):
        return reasons
    distance = float(fit.leave_one_out_mm[checked].max())
    turn = float(np.degrees(np.abs(fit.leave_one_out_rad[checked]).max()))
    held = Code.HELD_OUT_ERROR
    advice = f"Look at {_called(fit.worst, names)} and its angle first; repeat it or add touches."
    reasons += above(held, distance, use.leave_one_out_mm, "The largest held-out distance", advice)
    limit = float(np.degrees(use.leave_one_out_rad))
    return reasons + above(held, turn, limit, "The largest held-out angle error", advice, "deg")


def _judge_wheel_uncertainty(fit: WheelFit, use: WheelLimits) -> list[Reason]:
    code = Code.HIGH_UNCERTAINTY
    needed = np.degrees(arc_needed_rad(fit, use.axis_tilt_sigma_rad))
    longer = f"about {needed:.0f} deg would do" if np.isfinite(needed) else "no arc would do with this noise"
    arc = f"The touches span {np.degrees(fit.arc_rad):.3g} deg; {longer}. Turn the head farther or add touches."
    tilt, tilt_limit = float(np.degrees(fit.axis_tilt_sigma_rad)), float(np.degrees(use.axis_tilt_sigma_rad))
    reasons = above(code, tilt, tilt_limit, "The standard deviation of the axis direction", arc, "deg")
    position = float(np.sqrt(np.linalg.eigvalsh(fit.covariance.matrix[3:, 3:])[-1]))
    more = "Add touches, one of them near head angle 0, over a longer arc."
    reasons += above(code, position, use.position_sigma_mm, "The standard deviation of the wheel centre", more)
    radius = "Give the known radius or turn the head farther."
    return reasons + above(
        code, fit.radius_sigma_mm, use.radius_sigma_mm, "The standard deviation of the radius", radius
    )


def _judge_wheel_model(fit: WheelFit, use: WheelLimits) -> list[Reason]:
    reasons = []
    off = abs(fit.free_radius_mm - fit.radius_mm)
    if off > max(use.radius_error_mm, 3.0 * fit.free_radius_sigma_mm):
        reasons.append(
            Reason(
                Code.WRONG_MODEL,
                f"The radius given is {fit.radius_mm:.3f} mm, the touches say {fit.free_radius_mm:.3f} mm (standard "
                f"deviation {fit.free_radius_sigma_mm:.2g} mm). Check the radius and the angle sensor's scale.",
            )
        )
    deviation = abs(fit.free_angle_scale - 1.0)
    if deviation > max(use.angle_scale_error, 3.0 * fit.free_angle_scale_sigma):
        reasons.append(
            Reason(
                Code.WRONG_MODEL,
                f"The head turns {fit.free_angle_scale:.4f} times what its sensor says (standard deviation "
                f"{fit.free_angle_scale_sigma:.2g}). Check the sensor's steps per turn.",
            )
        )
    if use.expected_axis_in_base is not None and fit.head_axis_direction @ np.asarray(use.expected_axis_in_base) < 0.0:
        reasons.append(
            Reason(
                Code.WRONG_MODEL,
                "The head's axis points against the direction expected: the angle sensor counts the wrong way round. "
                "Reverse its sign.",
            )
        )
    return reasons


def _called(index: int, names: Sequence[str] | None) -> str:
    return f"touch {index} (counted from 0)" if names is None else f"'{names[index]}'"
