"""Wheel: known noise of touches and of the angle sensor."""

import numpy as np
from numpy.typing import NDArray
from scipy.spatial.transform import Rotation

from benchmarks.efficiency.common import Case, Trial
from core.tool import WheelTouches, solve_wheel

Array = NDArray[np.float64]

SIGMA_MM = 0.05
ANGLE_SIGMA_RAD = 5e-4
RADIUS_MM = 210.0
OFFSET_MM = 15.0
TOOL = Rotation.from_euler("ZYX", [30.0, -20.0, 75.0], degrees=True)
WHEEL_MM = np.array([-650.0, 420.0, 480.0])


def observations(unknowns: Array, n: int) -> Array:
    """Forward model (4N,) of points and sensor, from pose error of {H} about its origin, radius, scale and true angles.

    Seen from {H} the head's axis stands at x = -radius and the touched side at z = -offset.
    """
    radius, inverse_scale, phi = unknowns[6], unknowns[7], unknowns[8:]
    in_tool = np.column_stack([radius * (np.cos(phi) - 1.0), radius * np.sin(phi), np.full(n, -OFFSET_MM)])
    points = Rotation.from_rotvec(unknowns[:3]).apply(TOOL.apply(in_tool)) + WHEEL_MM + unknowns[3:6]
    return np.concatenate([points.ravel(), inverse_scale * phi])


def bound(phi: Array, free: list[int]) -> Array:
    """Cramér–Rao bound of the pose by central differences; `free` are the unknowns beside the true angles."""
    n = len(phi)
    at = np.concatenate([np.zeros(6), [RADIUS_MM, 1.0], phi])
    columns = []
    for k in [*free, *range(8, 8 + n)]:
        step = np.zeros(len(at))
        step[k] = 1e-3 if 3 <= k <= 6 else 1e-5
        columns.append((observations(at + step, n) - observations(at - step, n)) / (2.0 * step[k]))
    jacobian = np.column_stack(columns)
    jacobian[: 3 * n] /= SIGMA_MM
    jacobian[3 * n :] /= ANGLE_SIGMA_RAD
    return np.linalg.inv(jacobian.T @ jacobian)[:6, :6]


def trial(rng: np.random.Generator, degrees: list[float], *, known_radius: bool, scale: bool = False) -> Trial:
    phi = np.radians(degrees)
    n = len(phi)
    truth = observations(np.concatenate([np.zeros(6), [RADIUS_MM, 1.0], phi]), n)
    points = truth[: 3 * n].reshape(n, 3) + rng.normal(0.0, SIGMA_MM, (n, 3))
    fit = solve_wheel(
        WheelTouches(phi + rng.normal(0.0, ANGLE_SIGMA_RAD, n), points),
        radius_mm=RADIUS_MM if known_radius else None,
        shaft_offset_mm=OFFSET_MM,
        fit_angle_scale=scale,
        sigma_mm=SIGMA_MM,
        angle_sigma_rad=ANGLE_SIGMA_RAD,
    )
    turn = fit.base_from_tool[:3, :3] @ TOOL.as_matrix().T
    about = fit.covariance.about_mm
    shift = fit.base_from_tool[:3, 3] - about + turn @ (about - WHEEL_MM)
    error = np.concatenate([Rotation.from_matrix(turn).as_rotvec(), shift])
    free = [*range(6), *([] if known_radius else [6]), *([7] if scale else [])]
    return Trial(error, fit.covariance.matrix, bound(phi, free))


def cases() -> list[Case]:
    short, wide = [0.0, 15.0, 30.0], [-20.0, 0.0, 20.0, 40.0]
    many = list(np.linspace(-30.0, 50.0, 8))
    return [
        Case("wheel, 3 touches over 30 deg, radius known", 6, lambda rng: trial(rng, short, known_radius=True)),
        Case("wheel, 4 touches over 60 deg, radius fitted", 6, lambda rng: trial(rng, wide, known_radius=False)),
        Case(
            "wheel, 8 touches over 80 deg, radius known, scale fitted",
            6,
            lambda rng: trial(rng, many, known_radius=True, scale=True),
        ),
    ]
