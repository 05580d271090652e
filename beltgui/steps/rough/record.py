"""The rough step's result as a record."""

from __future__ import annotations

from typing import Any

from beltgui.steps.blocks import conditioning_block, plain, pose_block, verdict_block
from core.fine import FineFit
from core.frames import Array
from core.rough import PairsFit
from core.rough.automatic import GlobalFit
from core.verdict import Verdict


def record(fit: PairsFit, verdict: Verdict) -> dict[str, Any]:
    """Pose of the blade from picked pairs; `residuals_mm` are scan pick minus carried CAD pick, in M."""
    pairs = zip(fit.names, fit.distances_mm, fit.leave_one_out_mm, strict=True)
    return {
        "verdict": verdict_block(verdict),
        "measure_from_work": pose_block(fit.measure_from_work, fit.covariance),
        "residuals_mm": plain(fit.residuals_mm),
        "pairs": [{"name": name, "distance_mm": plain(distance), "leave_one_out_mm": plain(left_out)}
                  for name, distance, left_out in pairs],
        "rms_mm": plain(fit.rms_mm),
        "sigma_mm": plain(fit.sigma_mm),
        "worst_pair": fit.worst,
        "worst_is_clear": bool(fit.worst_is_clear),
        **conditioning_block(fit.conditioning),
        "remarks": list(fit.remarks),
    }


def confirmed_pairs_record(
    fit: PairsFit, confirmed: FineFit | None, measure_from_work: Array, apart_mm: Array, verdict: Verdict
) -> dict[str, Any]:
    """The same with the pose that the faces confirmed; `apart_mm` (N,) are the pairs' distances under that one."""
    pairs = record(fit, verdict)
    for pair, distance in zip(pairs["pairs"], apart_mm, strict=True):
        pair["distance_by_faces_mm"] = plain(distance)
    covariance = fit.covariance if confirmed is None else confirmed.covariance
    return {
        **pairs,
        "measure_from_work": pose_block(measure_from_work, covariance),
        "measure_from_work_by_pairs": pose_block(fit.measure_from_work, fit.covariance),
        "confirmed_rms_mm": None if confirmed is None else plain(confirmed.rms_mm),
    }


def automatic_record(fit: GlobalFit[FineFit], verdict: Verdict) -> dict[str, Any]:
    """Pose of the blade found without picks, confirmed by its faces; `residuals_mm` is the mean of each face."""
    used = [face for face in fit.fine.faces if face.used]
    return {
        "verdict": verdict_block(verdict),
        "measure_from_work": pose_block(fit.measure_from_work, fit.fine.covariance),
        "residuals_mm": [plain(face.mean_mm) for face in used],
        "faces": [{"id": face.id, "name": face.name, "points": face.points, "rms_mm": plain(face.rms_mm)}
                  for face in used],
        "rms_mm": plain(fit.fine.rms_mm),
        "sigma_mm": plain(fit.fine.sigma_mm),
        "share_explained": plain(fit.score),
        "candidates": len(fit.candidates),
        **conditioning_block(fit.fine.conditioning),
    }
