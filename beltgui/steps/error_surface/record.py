"""The error surface as a record that the path step reads back."""

from __future__ import annotations

from typing import Any

from beltgui.steps.blocks import plain, verdict_block
from core.error_surface import ErrorSurface
from core.frames import Array
from core.verdict import Verdict


def record(surface: ErrorSurface, verdict: Verdict) -> dict[str, Any]:
    """Spline, samples and leave-one-out errors; `rejected` names the samples that were found to be wrong."""
    rejected = [{"index": int(i), "u": plain(surface.sample_u[i]), "v": plain(surface.sample_v[i]),
                 "error_mm": plain(surface.sample_error_mm[i]), "deviation_mm": plain(surface.leave_one_out_mm[i])}
                for i in surface.rejected]
    return {
        "verdict": verdict_block(verdict),
        **plain(surface.to_json_dict()),
        "leave_one_out_mm": plain(surface.leave_one_out_mm),
        "leave_one_out_rms_mm": plain(surface.leave_one_out_rms_mm),
        "rejected": rejected,
        "missing": int(surface.missing.sum()),
    }


def evaluation(surface: ErrorSurface, u: Array, v: Array) -> dict[str, Any]:
    """`error_mm` and its standard deviation at (u, v) (N,); null outside the measured patch."""
    return {"u": plain(u), "v": plain(v), "error_mm": plain(surface.evaluate(u, v)),
            "error_sigma_mm": plain(surface.sigma_at(u, v))}
