"""The ball step's results as records: one ball in one scan, and the scanner on its stage."""

from __future__ import annotations

from typing import Any

from beltgui.steps.blocks import conditioning_block, degrees, plain, pose_block, verdict_block
from core.ball import SphereFit, StageFit
from core.verdict import Verdict


def sphere_record(fit: SphereFit, verdict: Verdict, dropped: int = 0) -> dict[str, Any]:
    """One ball; `points` are the measured points of the scan, `dropped` those without a measurement."""
    return {
        "verdict": verdict_block(verdict),
        "center_mm": plain(fit.center_mm),
        "diameter_mm": plain(fit.diameter_mm),
        "diameter_sigma_mm": plain(fit.diameter_sigma_mm),
        "diameter_fixed": bool(fit.diameter_fixed),
        "free_diameter_mm": plain(fit.free_diameter_mm),
        "sigma_mm": plain(fit.sigma_mm),
        "sphericity_mm": plain(fit.sphericity_mm),
        "points": len(fit.inliers),
        "inliers": int(fit.inliers.sum()),
        "dropped": dropped,
        "covariance_mm2": plain(fit.covariance_mm2),
        "coverage": plain(fit.coverage),
        "held_out_mm": plain(fit.held_out_mm),
        "iterations": fit.iterations,
    }


def stage_record(fit: StageFit, verdict: Verdict) -> dict[str, Any]:
    """The scanner on its stage.

    `measure_from_scanner` holds at the stage's zero; `axes` are three directions in M, one per row; `squareness_deg` is
    the angle less 90 degrees between x and y, y and z, z and x; `residuals_mm` are vectors in the scanner's frame.
    """
    rotary = fit.rotary_axis
    return {
        "verdict": verdict_block(verdict),
        "measure_from_scanner": pose_block(fit.measure_from_scanner, fit.covariance),
        "axes": plain(fit.axes.T),
        "scale": plain(fit.scale),
        "assumed_axes": list(fit.assumed),
        "squareness_deg": degrees(fit.squareness_rad),
        "squareness_sigma_deg": None if fit.squareness_sigma_rad is None else degrees(fit.squareness_sigma_rad),
        "rotary_axis": rotary and {"direction": plain(rotary.direction), "point_mm": plain(rotary.point_mm)},
        "scanner_axis_angles_deg": degrees(fit.scanner_axis_angles_rad),
        "ball_in_measure_mm": plain(fit.ball_in_measure_mm),
        "rms_mm": plain(fit.rms_mm),
        "sigma_mm": plain(fit.sigma_mm),
        "residuals_mm": plain(fit.residuals_mm),
        "leave_one_out_mm": plain(fit.leave_one_out_mm),
        **conditioning_block(fit.conditioning),
        "iterations": fit.iterations,
    }
