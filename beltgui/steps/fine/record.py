"""The fine step's result as a record."""

from __future__ import annotations

from typing import Any

from beltgui.steps.blocks import conditioning_block, plain, pose_block, verdict_block
from core.fine import FaceResult, FineFit
from core.verdict import Verdict


def record(fit: FineFit, verdict: Verdict) -> dict[str, Any]:
    """Pose of the blade, what each face says about it, and how two halves of the data agree."""
    return {
        "verdict": verdict_block(verdict),
        "measure_from_work": pose_block(fit.measure_from_work, fit.covariance),
        "faces": [_face(face) for face in fit.faces],
        "rms_mm": plain(fit.rms_mm),
        "sigma_mm": plain(fit.sigma_mm),
        "points": fit.points,
        "points_used": fit.points_used,
        "near_share": plain(fit.near_share),
        "iterations": fit.iterations,
        **conditioning_block(fit.conditioning),
        "ends_in_work_mm": plain(fit.ends_in_work_mm),
        "point_sigma_mm": plain(fit.point_sigma_mm),
        "half_split_mm": plain(fit.half_split_mm),
        "start_moved_mm": plain(fit.start_moved_mm),
    }


def _face(face: FaceResult) -> dict[str, Any]:
    return {"id": face.id, "name": face.name, "type": face.type, "points": face.points, "rms_mm": plain(face.rms_mm),
            "mean_mm": plain(face.mean_mm), "sigma_mm": plain(face.sigma_mm), "held_out_mm": plain(face.held_out_mm),
            "coverage": plain(face.coverage), "used": bool(face.used), "note": face.note}
