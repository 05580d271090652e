"""Which touch would sharpen the tool step most: a tilt of the flange in the cone, or a head angle at a shaft."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from itertools import product

import numpy as np
from numpy.typing import NDArray

from beltgui.steps.tool.step import ToolOutcome, shaft_mark
from beltgui.steps.views.common import largest_sigma
from core.frames import nearest_rotation, rigid, rotation_from_rotvec, skew
from core.tool import StylusFit, StylusLimits, WheelFit, WheelLimits
from devices.cell_plan import CellPlan, GrinderPlan

Array = NDArray[np.float64]
# Tilts are tried up to the largest planned one, in these shares of it, and turns about the flange's axis besides.
TILT_SHARES, TILT_DIRECTIONS, TURNS_DEG = (0.5, 1.0), 12, (-60.0, 0.0, 60.0)
HEAD_STEPS = 25
# The head is not held against its stops.
STOP_MARGIN_RAD = float(np.radians(1.0))
# A smaller fall of the standard deviation is not worth a touch.
LEAST_GAIN = 0.03


@dataclass(frozen=True, eq=False)
class ConeAdvice:
    """A touch of the cone.

    Attributes:
        slot: Of the planned touch; None for one beyond the plan.
        base_from_flange: (4, 4) roughly.
        tilt_rad: Of the flange's axis against the middle of the touches so far.
        azimuth_rad: Direction of that tilt in {B}, from x to y.
        before_mm: Standard deviation of the tip, worst direction, now.
        after_mm: The same with one more touch.
    """

    slot: int | None
    base_from_flange: Array
    tilt_rad: float
    azimuth_rad: float
    before_mm: float
    after_mm: float

    @property
    def gain(self) -> float:
        """Share by which the standard deviation falls."""
        return 1.0 - self.after_mm / self.before_mm


@dataclass(frozen=True)
class ShaftAdvice:
    """A touch of a wheel's shaft.

    Attributes:
        grinder: Its name.
        slot: Of the planned touch; None for one beyond the plan.
        angle_rad: Of the head.
        before_mm: Standard deviation of the wheel at its rim, worst direction, now.
        after_mm: The same with one more touch.
    """

    grinder: str
    slot: int | None
    angle_rad: float
    before_mm: float
    after_mm: float

    @property
    def gain(self) -> float:
        """Share by which the standard deviation falls."""
        return 1.0 - self.after_mm / self.before_mm


Advice = ConeAdvice | ShaftAdvice


def advise(
    outcome: ToolOutcome,
    plan: CellPlan,
    missing_cone: Mapping[int, Array],
    missing_shafts: Mapping[str, Mapping[int, float]],
) -> Advice | None:
    """The touch that helps most where the result is farthest from what its limits ask.

    Args:
        outcome: So far.
        plan: Taught touches and travel of the heads.
        missing_cone: Planned cone touches that are missing, (4, 4) by slot.
        missing_shafts: Planned head angles that are missing, rad by grinder and slot.

    Returns:
        None if nothing gains enough.
    """
    need = {"": largest_sigma(outcome.stylus.tip_covariance_mm2) / StylusLimits().tip_sigma_mm}
    limits = WheelLimits()
    for name, fit in outcome.wheels.items():
        position = largest_sigma(fit.covariance.matrix[3:, 3:]) / limits.position_sigma_mm
        need[name] = max(position, fit.axis_tilt_sigma_rad / limits.axis_tilt_sigma_rad)
    any_missing = bool(missing_cone) or any(missing_shafts.values())
    for name in sorted(need, key=lambda part: -need[part]):
        advice = _for_part(name, outcome, plan, missing_cone, missing_shafts.get(name, {}), any_missing)
        if advice is not None and (any_missing or advice.gain >= LEAST_GAIN):
            return advice
    return None


def _for_part(
    name: str,
    outcome: ToolOutcome,
    plan: CellPlan,
    missing_cone: Mapping[int, Array],
    missing_angles: Mapping[int, float],
    any_missing: bool,
) -> Advice | None:
    """Best touch of one part; while planned ones are missing anywhere, only those."""
    if name:
        if any_missing and not missing_angles:
            return None
        return advise_shaft(outcome.wheels[name], plan.grinders[name], missing_angles or None)
    if any_missing and not missing_cone:
        return None
    used = np.array([touch.base_from_flange for touch in outcome.fitted_cone])[outcome.stylus.used]
    return advise_cone(outcome.stylus, used, plan.stylus.touches, missing_cone or None)


# ---- cone


def advise_cone(
    fit: StylusFit, used: Array, planned: Sequence[Array], missing: Mapping[int, Array] | None
) -> ConeAdvice:
    """The tilt that sharpens the tip most; of the `missing` planned ones, or of all within the planned tilts.

    Args:
        fit: So far.
        used: (N, 4, 4) touches of the fit.
        planned: (4, 4) each; how far one tilts in this cell.
        missing: Planned poses by slot; None: any orientation.
    """
    jacobian = np.concatenate([used[:, :3, :3], np.tile(-np.eye(3), (len(used), 1, 1))], axis=2)
    covariance = fit.sigma_mm**2 * np.linalg.inv(np.einsum("nip,niq->pq", jacobian, jacobian))
    candidates: dict[int | None, list[Array]] = {None: orientations(planned)}
    if missing is not None:
        candidates = {slot: [pose[:3, :3]] for slot, pose in missing.items()}
    best: tuple[float, int | None, Array] | None = None
    for slot, rotations in candidates.items():
        for rotation in rotations:
            after = _with_touch(covariance, rotation, fit.sigma_mm)
            if best is None or after < best[0]:
                best = (after, slot, rotation)
    assert best is not None
    after, slot, rotation = best
    axis = rotation[:, 2]
    middle = used[:, :3, 2].mean(axis=0)
    away = axis - middle * (axis @ middle) / (middle @ middle)
    return ConeAdvice(
        slot=slot,
        base_from_flange=rigid(rotation, fit.pivot_in_base_mm - rotation @ fit.tip_in_flange_mm),
        tilt_rad=float(np.arccos(np.clip(axis @ middle / np.linalg.norm(middle), -1.0, 1.0))),
        azimuth_rad=float(np.arctan2(away[1], away[0])),
        before_mm=largest_sigma(covariance[:3, :3]),
        after_mm=after,
    )


def _with_touch(covariance: Array, rotation: Array, sigma_mm: float) -> float:
    jacobian = np.hstack([rotation, -np.eye(3)])
    return largest_sigma(_updated(covariance, jacobian, sigma_mm**2 * np.eye(3))[:3, :3])


def _updated(covariance: Array, jacobian: Array, noise: Array) -> Array:
    """`C - C J^T (S + J C J^T)^-1 J C`: one more observation with Jacobian J and noise S."""
    known = jacobian @ covariance
    return np.asarray(covariance - known.T @ np.linalg.solve(noise + known @ jacobian.T, known))


def orientations(planned: Sequence[Array]) -> list[Array]:
    """Flange orientations (3, 3) tilted at most as far as the planned ones, in all directions."""
    rotations = np.array([pose[:3, :3] for pose in planned])
    middle = nearest_rotation(rotations.mean(axis=0))
    axis = middle[:, 2]
    largest = float(angles_between_axes(rotations[:, :, 2], axis).max())
    sides = np.linalg.svd(axis[None, :])[2][1:]
    found = []
    turns = np.radians(TURNS_DEG)
    for share, step, turn in product(TILT_SHARES, range(TILT_DIRECTIONS), turns):
        direction = 2.0 * np.pi * step / TILT_DIRECTIONS
        about = np.cos(direction) * sides[0] + np.sin(direction) * sides[1]
        tilted = rotation_from_rotvec(share * largest * about) @ middle
        found.append(tilted @ rotation_from_rotvec(turn * np.array([0.0, 0.0, 1.0])))
    return found


def angles_between_axes(axes: Array, reference: Array) -> Array:
    """(N,) rad between unit directions (N, 3) and one (3,)."""
    return np.asarray(np.arccos(np.clip(axes @ reference / np.linalg.norm(reference), -1.0, 1.0)))


# ---- shaft


def advise_shaft(fit: WheelFit, plan: GrinderPlan, missing: Mapping[int, float] | None) -> ShaftAdvice:
    """The head angle that sharpens the wheel's place most; of the `missing` planned ones, or of the whole travel."""
    low, high = plan.travel_rad[0] + STOP_MARGIN_RAD, plan.travel_rad[1] - STOP_MARGIN_RAD
    candidates: list[tuple[int | None, float]] = [(None, float(a)) for a in np.linspace(low, high, HEAD_STEPS)]
    if missing is not None:
        candidates = list(missing.items())
    after, slot, angle = min(
        ((_rim_sigma(fit, plan, _with_angle(fit, plan, angle)), slot, angle) for slot, angle in candidates),
        key=lambda found: found[0],
    )
    return ShaftAdvice(plan.name, slot, angle, _rim_sigma(fit, plan, fit.covariance.matrix), after)


def _with_angle(fit: WheelFit, plan: GrinderPlan, angle_rad: float) -> Array:
    """(6, 6) covariance of {H} with one more touch at a head angle."""
    mark = shaft_mark(fit, angle_rad, plan.shaft_side_offset_mm)
    arm = mark - fit.covariance.about_mm
    jacobian = np.hstack([-skew(arm), np.eye(3)])
    # The sensor's noise moves the mark along its circle.
    along = np.cross(fit.head_axis_direction, mark - fit.head_axis_point_mm)
    noise = fit.sigma_mm**2 * np.eye(3) + fit.angle_sigma_rad**2 * np.outer(along, along)
    return _updated(fit.covariance.matrix, jacobian, noise)


def _rim_sigma(fit: WheelFit, plan: GrinderPlan, covariance: Array) -> float:
    """Standard deviation of the wheel's rim, worst point and direction, of a pose covariance about the wheel centre."""
    center = fit.base_from_tool[:3, 3]
    worst = 0.0
    for angle in np.linspace(0.0, 2.0 * np.pi, 8, endpoint=False):
        in_tool = plan.wheel_radius_mm * np.array([np.cos(angle), np.sin(angle), 0.0])
        arm = fit.base_from_tool[:3, :3] @ in_tool + center - fit.covariance.about_mm
        carry = np.hstack([-skew(arm), np.eye(3)])
        worst = max(worst, largest_sigma(carry @ covariance @ carry.T))
    return worst
