"""The numbers of the stylus and tool step, each with ± (k = 2) from the covariance."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from beltgui.steps.tool.step import ToolOutcome
from beltgui.steps.views.common import finite, in_deg, largest_sigma, number_of, position_numbers
from beltgui.viewmodel.step import Number
from core.frames import rotvec_from_rotation, skew
from core.tool import StylusFit, StylusLimits, WheelFit, WheelLimits, arc_needed_rad
from devices.cell_plan import CellPlan, GrinderPlan

Array = NDArray[np.float64]


def numbers(outcome: ToolOutcome, plan: CellPlan) -> tuple[Number, ...]:
    """Of the stylus, then of each grinder."""
    found = [
        number_of("Held-out cone point, RMS", outcome.cone_held_out.rms_mm, "mm", limit=outcome.cone_held_out.limit_mm,
                  main=True),
        *_stylus(outcome.stylus),
    ]  # fmt: skip
    for name, fit in outcome.wheels.items():
        held = outcome.shafts_held_out[name]
        found.append(number_of(
            f"Grinder {name}: held-out shaft mark, RMS", held.rms_mm, "mm", limit=held.limit_mm, main=True
        ))  # fmt: skip
        found += _wheel(name, fit, plan.grinders[name])
    return tuple(found)


def _stylus(fit: StylusFit) -> list[Number]:
    limits = StylusLimits()
    return [
        *position_numbers("Stylus tip in {F}", fit.tip_in_flange_mm, fit.tip_covariance_mm2, main=True),
        number_of("Stylus tip, uncertainty (k = 2)", 2.0 * largest_sigma(fit.tip_covariance_mm2), "mm",
                  limit=2.0 * limits.tip_sigma_mm),
        *position_numbers("Cone in {B}", fit.pivot_in_base_mm, fit.pivot_covariance_mm2),
        number_of("Stylus, residuals of the fit, RMS", fit.rms_mm, "mm", limit=limits.rms_mm),
        number_of("Stylus, noise of a touch, each coordinate", fit.sigma_mm, "mm"),
        number_of("Stylus, largest turn between two touches", in_deg(fit.turn_rad), "deg", decimals=1),
        number_of("Stylus, condition of the fit", fit.conditioning.condition, "", decimals=1, limit=limits.condition),
    ]  # fmt: skip


def _wheel(name: str, fit: WheelFit, plan: GrinderPlan) -> list[Number]:
    limits, who = WheelLimits(), f"Grinder {name}"
    certified_mm = plan.head_radius_mm
    origin = fit.base_from_tool[:3, 3]
    needed = arc_needed_rad(fit, limits.axis_tilt_sigma_rad)
    sensor_rms = float(np.sqrt(np.mean(fit.angle_residuals_rad**2)))
    return [
        *position_numbers(f"{who}: origin of {{H}} in {{B}},", origin, fit.covariance.of_point(origin), main=True),
        *_turn_against_drawing(who, fit, plan),
        *_axis(who, fit),
        number_of(f"{who}: wheel centre, uncertainty (k = 2)", 2.0 * largest_sigma(fit.covariance.of_point(origin)),
                  "mm", limit=2.0 * limits.position_sigma_mm),
        number_of(f"{who}: head axis, uncertainty of its direction (k = 2)", in_deg(2.0 * fit.axis_tilt_sigma_rad),
                  "deg", limit=in_deg(2.0 * limits.axis_tilt_sigma_rad)),
        number_of(f"{who}: Rg by the touches alone, certified {certified_mm:.3f} mm", fit.free_radius_mm, "mm",
                  sigma=finite(fit.free_radius_sigma_mm)),
        number_of(f"{who}: difference to the certified Rg", abs(fit.free_radius_mm - certified_mm), "mm",
                  limit=max(limits.radius_error_mm, 3.0 * fit.free_radius_sigma_mm)
                  if np.isfinite(fit.free_radius_sigma_mm) else None),
        number_of(f"{who}: scale of the angle sensor by the touches alone", fit.free_angle_scale, "deg/deg",
                  sigma=finite(fit.free_angle_scale_sigma), decimals=4),
        number_of(f"{who}: arc between the outermost touches", in_deg(fit.arc_rad), "deg", decimals=1),
        number_of(f"{who}: arc that would be needed", in_deg(needed), "deg", decimals=1),
        number_of(f"{who}: residuals of the fit, RMS", fit.rms_mm, "mm", limit=limits.rms_mm),
        number_of(f"{who}: residuals of the angle sensor, RMS", in_deg(sensor_rms), "deg",
                  limit=in_deg(limits.angle_rms_rad)),
    ]  # fmt: skip


def _turn_against_drawing(who: str, fit: WheelFit, plan: GrinderPlan) -> list[Number]:
    """A rotation vector: a wheel's Euler angles are undetermined where z of {H} is level."""
    away = np.degrees(rotvec_from_rotation(fit.base_from_tool[:3, :3] @ plan.base_from_tool[:3, :3].T))
    sigmas = np.degrees(np.sqrt(np.diag(fit.covariance.matrix[:3, :3])))
    return [
        number_of(f"{who}: {{H}} turned against the drawing about {axis} of {{B}}", float(value), "deg",
                  sigma=float(sigma))
        for axis, value, sigma in zip("xyz", away, sigmas, strict=True)
    ]  # fmt: skip


def _axis(who: str, fit: WheelFit) -> list[Number]:
    """Direction of the head axis in {B}; a small turn r of {H} moves a direction d by r x d."""
    carry = -skew(fit.head_axis_direction)
    sigmas = np.sqrt(np.maximum(np.diag(carry @ fit.covariance.matrix[:3, :3] @ carry.T), 0.0))
    return [
        number_of(f"{who}: head axis in {{B}}, direction {axis}", float(value), "", sigma=float(sigma), decimals=5)
        for axis, value, sigma in zip("xyz", fit.head_axis_direction, sigmas, strict=True)
    ]
