"""Is a base fit good enough to grind by?"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from core.base.solve import BaseFit
from core.verdict import Code, Reason, Verdict, above


@dataclass(frozen=True)
class BaseLimits:
    """Limits of `judge_base`; the defaults suit a robot whose absolute error is a few tenths of a mm.

    Attributes:
        rms_mm: RMS residual.
        leave_one_out_mm: RMS of the held-out errors.
        worst_leave_one_out_mm: Largest held-out error of a single observation.
        outlier_mm: Largest held-out error of an observation that the others contradict; a robot's own errors of a few
            tenths, which are no noise, must stay below.
        position_sigma_mm: Largest standard deviation, over directions, of the pose at the centroid of the balls.
        rotation_sigma_rad: Largest standard deviation of the rotation, over axes.
        ball_sigma_mm: Largest standard deviation of the ball offset, over directions.
        condition: Largest condition number of the nine unknowns.
        different_poses: Fewest different poses; five leave enough over to notice a mistake.
        unchecked_observations: Most observations that are the only witness of something.
    """

    rms_mm: float = 0.5
    leave_one_out_mm: float = 1.0
    worst_leave_one_out_mm: float = 2.0
    outlier_mm: float = 0.5
    position_sigma_mm: float = 0.5
    rotation_sigma_rad: float = 2e-3
    ball_sigma_mm: float = 0.5
    condition: float = 300.0
    different_poses: int = 5
    unchecked_observations: int = 1


def judge_base(fit: BaseFit, limits: BaseLimits | None = None, names: Sequence[str] | None = None) -> Verdict:
    """Judge residuals, held-out errors, uncertainty, conditioning and redundancy.

    Args:
        fit: To judge.
        limits: Its limits.
        names: What a person calls each observation; None: their numbers, counted from 0.
    """
    use = limits or BaseLimits()
    reasons: list[Reason] = []
    if fit.different_poses < use.different_poses:
        reasons.append(
            Reason(
                Code.NO_REDUNDANCY,
                f"There are {fit.different_poses} different poses, {use.different_poses} are needed so that a mistake "
                "would show. Add poses with the flange tilted.",
            )
        )
    worst = _called(fit.worst, names)
    weak = f"Weakest: {fit.conditioning.description}. Add poses that tilt the flange more and about other axes."
    reasons += above(Code.HIGH_RESIDUAL, fit.rms_mm, use.rms_mm, "The RMS residual", f"Look at {worst} first.")
    reasons += _judge_held_out(fit, use, worst, names)
    sigma = float(np.sqrt(np.linalg.eigvalsh(fit.covariance.matrix[3:, 3:])[-1]))
    turn = float(np.sqrt(np.linalg.eigvalsh(fit.covariance.matrix[:3, :3])[-1]))
    ball = float(np.sqrt(np.linalg.eigvalsh(fit.ball_covariance_mm2)[-1]))
    uncertain = Code.HIGH_UNCERTAINTY
    reasons += above(uncertain, sigma, use.position_sigma_mm, "The standard deviation of the position", weak)
    reasons += above(
        uncertain,
        float(np.degrees(turn)),
        float(np.degrees(use.rotation_sigma_rad)),
        "The standard deviation of the rotation",
        weak,
        "deg",
    )
    reasons += above(uncertain, ball, use.ball_sigma_mm, "The standard deviation of the ball offset", weak)
    reasons += above(
        Code.ILL_CONDITIONED, fit.conditioning.condition, use.condition, "The condition of the fit", weak, "(ratio)"
    )
    return Verdict.of(reasons)


def _judge_held_out(
    fit: BaseFit, use: BaseLimits, worst: str, names: Sequence[str] | None
) -> list[Reason]:
    alone = np.flatnonzero(fit.unchecked_directions)
    if len(alone) > use.unchecked_observations:
        return [
            Reason(
                Code.NO_REDUNDANCY,
                f"{len(alone)} observations (the first is {_called(int(alone[0]), names)}) are the only witnesses of "
                f"something; at most {use.unchecked_observations} may be. Add poses like them.",
            )
        ]
    errors = fit.leave_one_out_mm[np.isfinite(fit.leave_one_out_mm)]
    rms = float(np.sqrt(np.mean(errors**2)))
    advice = f"Look at {worst} first; repeat it or add poses."
    held = Code.HELD_OUT_ERROR
    odd = above(
        held,
        float(fit.leave_one_out_mm[fit.outlier]),
        use.outlier_mm,
        f"The held-out error of {_called(fit.outlier, names)}, which the others contradict,",
        "Repeat it or leave it out.",
    ) if fit.outlier is not None else []
    return odd + above(held, rms, use.leave_one_out_mm, "The RMS held-out error", advice) + above(
        held, float(errors.max()), use.worst_leave_one_out_mm, "The largest held-out error", advice
    )


def _called(index: int, names: Sequence[str] | None) -> str:
    return f"observation {index} (counted from 0)" if names is None else f"'{names[index]}'"
