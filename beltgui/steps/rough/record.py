"""The rough step's result as a record."""

from __future__ import annotations

from typing import Any

from beltgui.steps.blocks import conditioning_block, plain, pose_block, verdict_block
from core.rough import PairsFit
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
