"""The tool step's results as records: the stylus tip, and the wheel of one grinder."""

from __future__ import annotations

from typing import Any

import numpy as np

from beltgui.steps.blocks import conditioning_block, degrees, plain, pose_block, verdict_block
from core.tool import StylusFit, WheelFit
from core.verdict import Verdict


def stylus_record(fit: StylusFit, verdict: Verdict) -> dict[str, Any]:
    """Tip in the flange and pivot in the base; `residuals_mm` are vectors in B, one per touch."""
    return {
        "verdict": verdict_block(verdict),
        "tip_in_flange_mm": plain(fit.tip_in_flange_mm),
        "tip_covariance_mm2": plain(fit.tip_covariance_mm2),
        "pivot_in_base_mm": plain(fit.pivot_in_base_mm),
        "pivot_sigma_mm": plain(np.sqrt(np.diag(fit.pivot_covariance_mm2))),
        "rms_mm": plain(fit.rms_mm),
        "sigma_mm": plain(fit.sigma_mm),
        "residuals_mm": plain(fit.residuals_mm),
        "leave_one_out_mm": plain(fit.leave_one_out_mm),
        "used": plain(fit.used),
        "largest_turn_deg": degrees(fit.turn_rad),
        **conditioning_block(fit.conditioning),
        "different_poses": fit.different_poses,
    }


def wheel_record(fit: WheelFit, verdict: Verdict) -> dict[str, Any]:
    """The tool frame at head angle 0, the head's axis in B and the distance between the two."""
    return {
        "verdict": verdict_block(verdict),
        "base_from_tool": pose_block(fit.base_from_tool, fit.covariance),
        "head_axis": {"point_mm": plain(fit.head_axis_point_mm), "direction": plain(fit.head_axis_direction),
                      "tilt_sigma_deg": degrees(fit.axis_tilt_sigma_rad)},
        "radius_mm": plain(fit.radius_mm),
        "radius_sigma_mm": plain(fit.radius_sigma_mm),
        "free_radius_mm": plain(fit.free_radius_mm),
        "free_radius_sigma_mm": plain(fit.free_radius_sigma_mm),
        "free_angle_scale": plain(fit.free_angle_scale),
        "free_angle_scale_sigma": plain(fit.free_angle_scale_sigma),
        "arc_deg": degrees(fit.arc_rad),
        "rms_mm": plain(fit.rms_mm),
        "residuals_mm": plain(fit.residuals_mm),
        "angle_residuals_deg": degrees(fit.angle_residuals_rad),
        "leave_one_out_mm": plain(fit.leave_one_out_mm),
        "leave_one_out_deg": degrees(fit.leave_one_out_rad),
        **conditioning_block(fit.conditioning),
        "iterations": fit.iterations,
    }
