"""Refuses wheel touches that cannot give the head's axis, in words."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from core.errors import FitError, InputError
from core.flange_poses import METRES_BELOW_MM
from core.verdict import Code

Array = NDArray[np.float64]

MIN_TOUCHES = 3
_SAME_PLACE_MM = 0.5
_SAME_ANGLE_RAD = 1e-3
_COLLINEAR = 1e-5


@dataclass(frozen=True)
class WheelTouches:
    """Centre of the wheel shaft's side, touched at several head angles.

    Attributes:
        angle_rad: (N,) head angle from its sensor; any zero, all readings of one touching session.
        point_in_base_mm: (N, 3) stylus tip in B.
    """

    angle_rad: Array
    point_in_base_mm: Array


def checked_touches(touches: WheelTouches) -> tuple[Array, Array]:
    """Validate numbers, units and variety: (N,) rad and (N, 3) mm.

    Raises:
        InputError: shapes, NaN, metres, degrees.
        FitError: too few, coincident, collinear, or all at one angle.
    """
    try:
        angles = np.asarray(touches.angle_rad, dtype=float)
        points = np.asarray(touches.point_in_base_mm, dtype=float)
    except (TypeError, ValueError) as error:
        raise InputError("touches: expected one angle and three coordinates per touch, all numbers.") from error
    if angles.ndim != 1 or points.shape != (len(angles), 3):
        raise InputError(
            f"touches: expected N angles and N points of three numbers, found shapes {angles.shape} and {points.shape}."
        )
    bad = np.flatnonzero(~(np.isfinite(angles) & np.all(np.isfinite(points), axis=1)))
    if len(bad):
        raise InputError(f"touches[{bad[0]}]: NaN or infinite number. Touch the shaft again at that head angle.")
    if len(points) and np.abs(points).max() < METRES_BELOW_MM:
        raise InputError(
            f"point_in_base_mm: no touch is farther than {np.abs(points).max():.3g} from the robot base. That looks "
            "like metres; points must be in mm."
        )
    if len(angles) and np.ptp(angles) > 2.0 * np.pi:
        raise InputError(
            f"angle_rad: the head angles span {np.ptp(angles):.3g} rad, more than a full turn. They look like degrees."
        )
    _check_variety(angles, points)
    return angles, points


def different_touches(points: Array) -> int:
    """Number of touches that lie at different places; repeats count once."""
    kept: list[Array] = []
    for point in points:
        if all(np.linalg.norm(point - other) > _SAME_PLACE_MM for other in kept):
            kept.append(point)
    return len(kept)


def _check_variety(angles: Array, points: Array) -> None:
    different = different_touches(points)
    if different == 1 and len(points) >= MIN_TOUCHES:
        raise FitError(
            f"All {len(points)} touches are at the same place (within {_SAME_PLACE_MM} mm): the head has not turned. "
            "Turn it as far as it goes between touches.",
            Code.NOT_ENOUGH_VARIATION,
        )
    if different < MIN_TOUCHES:
        raise FitError(
            f"Found {different} touches at different places, at least {MIN_TOUCHES} are needed, 5 or more are better. "
            "Touch the shaft at more head angles.",
            Code.NOT_ENOUGH_POINTS,
        )
    if np.ptp(angles) < _SAME_ANGLE_RAD:
        raise FitError(
            f"All head angles are the same ({np.degrees(angles[0]):.3g} deg) although the touches differ by up to "
            f"{np.linalg.norm(np.ptp(points, axis=0)):.3g} mm. Check that the angle sensor is read at every touch.",
            Code.NOT_ENOUGH_VARIATION,
        )
    values = np.linalg.svd(points - points.mean(axis=0), compute_uv=False)
    if values[1] < _COLLINEAR * values[0]:
        raise FitError(
            "The touches lie on a straight line: no circle and no axis follows from them. Turn the head farther "
            "between touches.",
            Code.NOT_ENOUGH_VARIATION,
        )
