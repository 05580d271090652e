"""Is a rough pose good enough to start the fine step from?"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from core.rough.pairs import PairsFit
from core.verdict import Code, Reason, Verdict, above


@dataclass(frozen=True)
class PairsLimits:
    """What a rough pose from picks must fulfil; the defaults keep the fine step well inside its capture range.

    Attributes:
        max_rms_mm: RMS distance over the pairs.
        max_pair_mm: Distance of any one pair, by the fit and by leave-one-out.
        max_rotation_sigma_rad: Standard deviation of the rotation about its least certain axis.
        max_position_sigma_mm: Standard deviation of the centroid's position along its least certain direction.
        min_pairs: Set to 4 or more to demand that a bad pick can be found.
    """

    max_rms_mm: float = 2.0
    max_pair_mm: float = 4.0
    max_rotation_sigma_rad: float = 0.03
    max_position_sigma_mm: float = 2.0
    min_pairs: int = 3


def judge_pairs(fit: PairsFit, limits: PairsLimits | None = None) -> Verdict:
    """Accept or reject a pose from picked pairs; a bad pick is named where the others agree against it."""
    limits = limits or PairsLimits()
    reasons: list[Reason] = []
    if len(fit.names) < limits.min_pairs:
        reasons.append(Reason(Code.NO_REDUNDANCY, f"There are {len(fit.names)} pairs, at least {limits.min_pairs} are "
                                                  "asked for so that a bad pick shows. Pick more pairs."))
    bad_pick = _bad_pick(fit, limits)
    reasons += bad_pick
    if not bad_pick:
        reasons += above(Code.HIGH_RESIDUAL, fit.rms_mm, limits.max_rms_mm, "RMS distance of the pairs",
                         f"No single pick explains it; the largest distance is at '{fit.worst}'. Check that all "
                         "pairs are the same features on the same blade type and pick again.")
        reasons += above(Code.HIGH_RESIDUAL, float(fit.distances_mm.max()), limits.max_pair_mm,
                         f"The distance of pair '{fit.names[int(np.argmax(fit.distances_mm))]}'", "Pick it again.")
    spread = np.sqrt(np.linalg.eigvalsh(fit.covariance.matrix[:3, :3])[-1])
    reasons += above(Code.HIGH_UNCERTAINTY, float(np.degrees(spread)),
                     float(np.degrees(limits.max_rotation_sigma_rad)), "Uncertainty (1 sigma) of the rotation",
                     f"Least certain: {fit.conditioning.description}. Spread the picks wider or add pairs.", "deg")
    spread = np.sqrt(np.linalg.eigvalsh(fit.covariance.matrix[3:, 3:])[-1])
    reasons += above(Code.HIGH_UNCERTAINTY, float(spread), limits.max_position_sigma_mm,
                     "Uncertainty (1 sigma) of the position", "Pick more carefully or add pairs.")
    return Verdict.of(reasons)


def _bad_pick(fit: PairsFit, limits: PairsLimits) -> list[Reason]:
    """One reason that names the pick against which all others agree, if it is beyond the limit."""
    i = fit.names.index(fit.worst)
    if not fit.worst_is_clear or fit.leave_one_out_mm[i] <= limits.max_pair_mm:
        return []
    return [Reason(Code.HELD_OUT_ERROR, f"Pair '{fit.worst}' is {fit.leave_one_out_mm[i]:.1f} mm off where the other "
                                        f"pairs agree within {fit.others_rms_mm[i]:.2g} mm: pick it again.")]
