"""Stylus: known noise of a touch."""

import numpy as np
from numpy.typing import NDArray
from scipy.spatial.transform import Rotation

from benchmarks.efficiency.common import Case, Trial
from core.tool import solve_stylus

Array = NDArray[np.float64]

SIGMA_MM = 0.05
TIP_MM = np.array([12.0, -8.0, 160.0])
PIVOT_MM = np.array([-900.0, 350.0, 410.0])


def flange_origin(tip: Array, pivot: Array, turns: Array) -> Array:
    """Forward model: (3N,) where the flange must be for its tip to sit in the cone."""
    return (pivot - turns @ tip).ravel()


def bound(turns: Array) -> Array:
    """Cramér–Rao bound of the tip by differences (the model is linear) with the pivot unknown."""
    at = flange_origin(np.zeros(3), np.zeros(3), turns)
    columns = [flange_origin(unit, np.zeros(3), turns) - at for unit in np.eye(3)]
    columns += [flange_origin(np.zeros(3), unit, turns) - at for unit in np.eye(3)]
    jacobian = np.column_stack(columns)
    return np.linalg.inv(jacobian.T @ jacobian / SIGMA_MM**2)[:3, :3]


def trial(rng: np.random.Generator, n: int, tilt_rad: float) -> Trial:
    turns = Rotation.from_rotvec(rng.uniform(-tilt_rad, tilt_rad, (n, 3))).as_matrix()
    poses = np.tile(np.eye(4), (n, 1, 1))
    poses[:, :3, :3] = turns
    poses[:, :3, 3] = flange_origin(TIP_MM, PIVOT_MM, turns).reshape(n, 3) + rng.normal(0.0, SIGMA_MM, (n, 3))
    fit = solve_stylus(poses, sigma_mm=SIGMA_MM)
    return Trial(fit.tip_in_flange_mm - TIP_MM, fit.tip_covariance_mm2, bound(turns))


def cases() -> list[Case]:
    return [
        Case("stylus, 5 touches tilted 20 deg", 3, lambda rng: trial(rng, 5, 0.35)),
        Case("stylus, 12 touches tilted 30 deg", 3, lambda rng: trial(rng, 12, 0.5)),
    ]
