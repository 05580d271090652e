"""Are stylus and wheel known well enough to grind by?"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from core.tool.stylus import StylusFit
from core.verdict import Code, Reason, Verdict, above


@dataclass(frozen=True)
class StylusLimits:
    """Limits of `judge_stylus`; published pivot calibrations of belt-grinding cells reach 0.1 mm RMS.

    Attributes:
        rms_mm: RMS length of the residuals.
        leave_one_out_mm: Largest held-out error of a single touch.
        tip_sigma_mm: Largest standard deviation of the tip, over directions.
        turn_rad: Smallest accepted largest angle between two orientations (20 deg).
        condition: Largest condition number of tip and pivot together.
        different_poses: Fewest different poses; five leave enough over to notice a bad touch.
        unchecked_observations: Most touches that are the only witness of something.
        rejected: Most touches that the robust fit may have left out.
    """

    rms_mm: float = 0.3
    leave_one_out_mm: float = 0.8
    tip_sigma_mm: float = 0.2
    turn_rad: float = 0.35
    condition: float = 50.0
    different_poses: int = 5
    unchecked_observations: int = 0
    rejected: int = 1


def judge_stylus(fit: StylusFit, limits: StylusLimits | None = None) -> Verdict:
    """Judge residuals, held-out errors, uncertainty, spread of orientations and redundancy."""
    use = limits or StylusLimits()
    worst = f"Look at touch {fit.worst} (counted from 0) first; repeat it or add touches."
    weak = f"Weakest: {fit.conditioning.description}. Tilt the flange further and about other axes."
    reasons = _too_few(fit, use)
    reasons += above(Code.HIGH_RESIDUAL, fit.rms_mm, use.rms_mm, "The RMS residual", worst)
    errors = fit.leave_one_out_mm[fit.used & np.isfinite(fit.leave_one_out_mm)]
    largest = float(errors.max()) if len(errors) else 0.0
    reasons += above(Code.HELD_OUT_ERROR, largest, use.leave_one_out_mm, "The largest held-out error", worst)
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


def _too_few(fit: StylusFit, use: StylusLimits) -> list[Reason]:
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
                f"Touch {alone[0]} (counted from 0) is the only witness of something, so a mistake in it would not "
                "show. Add touches like it.",
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
