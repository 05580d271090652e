"""Whether a pose is good enough to grind by."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from core.fine.result import FineFit
from core.verdict import Code, Reason, Verdict, above


@dataclass(frozen=True)
class FineLimits:
    """Limits of a blade type; lengths in mm.

    Attributes:
        rms_mm: Of the points used.
        min_points_per_face: Of a face that the caller named. Where all faces were taken, a small one harms nothing.
        min_faces: Faces that have a say.
        point_sigma_mm: One sigma of the position at both ends and in the middle.
        held_out_mm: Largest mean distance of a face under the pose of the others.
        half_split_mm: Largest distance between the poses of the two halves; never judged tighter than what chance
            allows.
        condition: Ratio of best to worst observed direction.
        near_share: Least share of the points near the faces that lie on them.
    """

    rms_mm: float = 0.1
    min_points_per_face: int = 30
    min_faces: int = 3
    point_sigma_mm: float = 0.05
    held_out_mm: float = 0.15
    half_split_mm: float = 0.1
    condition: float = 50.0
    near_share: float = 0.5


def half_split_limit_mm(fit: FineFit, limits: FineLimits) -> float:
    """How far apart the poses of two halves of the data may be at an end of the blade: the limit, or chance."""
    return max(limits.half_split_mm, 4.0 * float(fit.point_sigma_mm.max()) * 2.0)


def judge_fine(fit: FineFit, limits: FineLimits | None = None) -> Verdict:
    """Every reason that speaks against a fit."""
    limits = limits or FineLimits()
    used = [face for face in fit.faces if face.used]
    reasons = above(Code.HIGH_RESIDUAL, fit.rms_mm, limits.rms_mm, "The RMS distance of the points from the faces",
                    "Check the scanner's exposure and that nothing moved during the scan.")
    if len(used) < limits.min_faces:
        reasons.append(Reason(Code.NOT_ENOUGH_VARIATION, f"Only {len(used)} faces have points, at least "
                              f"{limits.min_faces} are needed. Scan more faces of the blade."))
    few = [face for face in used if face.points < limits.min_points_per_face] if fit.faces_named else []
    if few:
        names = ", ".join(f"{face.name or face.id} ({face.points})" for face in few)
        reasons.append(Reason(Code.NOT_ENOUGH_POINTS, f"Faces with fewer than {limits.min_points_per_face} points: "
                              f"{names}. Scan them from another side, or take them off the list."))
    reasons += above(Code.HIGH_UNCERTAINTY, float(fit.point_sigma_mm.max()), limits.point_sigma_mm,
                     "The uncertainty (one sigma) of the position at an end of the blade",
                     f"Weakest is {fit.conditioning.description} in the CAD frame; scan faces that hold it.")
    held_out = [face for face in used if np.isfinite(face.held_out_mm)]
    if held_out:
        worst = max(held_out, key=lambda face: abs(face.held_out_mm))
        reasons += above(Code.HELD_OUT_ERROR, abs(worst.held_out_mm), limits.held_out_mm,
                         f"The mean distance of {worst.name or f'face {worst.id}'} under the pose of the other faces",
                         "The face is dirty, damaged or not as in the CAD model; or the blade is of another type.")
    reasons += above(Code.HELD_OUT_ERROR, float(fit.half_split_mm.max()), half_split_limit_mm(fit, limits),
                     "The distance between the poses from two halves of the scan", "Scan again; did anything move?")
    reasons += above(Code.ILL_CONDITIONED, fit.conditioning.condition, limits.condition, "The condition of the faces",
                     f"Weakest is {fit.conditioning.description} in the CAD frame; scan faces that hold it.", unit="")
    if fit.near_share < limits.near_share:
        reasons.append(Reason(Code.TOO_MANY_OUTLIERS, f"Only {fit.near_share:.0%} of the points near the faces lie on "
                              f"them, at least {limits.near_share:.0%} are expected. Look for dirt, clamps close to "
                              "the faces, or another blade type."))
    return Verdict.of(reasons)
