"""Base: known noise of the robot and of every ball centre."""

import numpy as np
from numpy.typing import NDArray
from scipy.spatial.transform import Rotation

from benchmarks.efficiency.common import Case, Trial
from core.base import solve_base

Array = NDArray[np.float64]

ROBOT_SIGMA_MM = 0.05
BALL_IN_FLANGE_MM = np.array([86.0, -165.0, 35.0])
MEASURE_ROTATION = Rotation.from_euler("ZYX", [20.0, -10.0, 30.0], degrees=True)
MEASURE_ORIGIN_MM = np.array([-1180.0, -1695.0, 980.0])


def ball_in_measure(unknowns: Array, about: Array, turns: Array, shifts: Array) -> Array:
    """Forward model: (3N,) from pose error about a point of B and ball offset."""
    rotation = Rotation.from_rotvec(unknowns[:3]).as_matrix()
    in_base = turns @ unknowns[6:] + shifts
    before = (in_base - about - unknowns[3:6]) @ rotation + about
    return ((before - MEASURE_ORIGIN_MM) @ MEASURE_ROTATION.as_matrix()).ravel()


def bound(about: Array, turns: Array, shifts: Array, covariances: Array) -> Array:
    """Cramér–Rao bound of all nine unknowns by central differences."""
    at = np.concatenate([np.zeros(6), BALL_IN_FLANGE_MM])
    steps = np.array([1e-5] * 3 + [1e-3] * 6)
    columns = [
        (ball_in_measure(at + step, about, turns, shifts) - ball_in_measure(at - step, about, turns, shifts))
        / (2.0 * steps[i])
        for i, step in enumerate(np.diag(steps))
    ]
    jacobian = np.column_stack(columns).reshape(len(turns), 3, 9)
    information = np.einsum("nip,nij,njq->pq", jacobian, np.linalg.inv(covariances), jacobian)
    return np.linalg.inv(information)


def trial(rng: np.random.Generator, n: int, tilt_rad: float) -> Trial:
    # The same poses in every run: a random set of four may determine nothing, and is then refused.
    geometry = np.random.default_rng(n)
    turns = Rotation.from_rotvec(geometry.uniform(-tilt_rad, tilt_rad, (n, 3))).as_matrix()
    balls = geometry.uniform(-100.0, 100.0, (n, 3))
    in_base = MEASURE_ROTATION.apply(balls) + MEASURE_ORIGIN_MM
    shifts = in_base - turns @ BALL_IN_FLANGE_MM
    # A cap seen from one side: the centre is worst along the viewing axis.
    sigmas = rng.uniform(0.5, 2.0, (n, 1)) * np.array([0.01, 0.01, 0.06])
    ball_covariance = sigmas[:, :, None] ** 2 * np.eye(3)
    seen = balls + rng.normal(0.0, 1.0, (n, 3)) * sigmas
    reported = np.tile(np.eye(4), (n, 1, 1))
    reported[:, :3, :3] = turns
    reported[:, :3, 3] = shifts + rng.normal(0.0, ROBOT_SIGMA_MM, (n, 3))
    fit = solve_base(reported, seen, ball_covariance_mm2=ball_covariance, robot_sigma_mm=ROBOT_SIGMA_MM)
    about = fit.covariance.about_mm
    estimate, origin = fit.base_from_measure[:3, :3], fit.base_from_measure[:3, 3]
    error_rotation = estimate @ MEASURE_ROTATION.as_matrix().T
    error_translation = origin - about + error_rotation @ (about - MEASURE_ORIGIN_MM)
    error = np.concatenate(
        [
            Rotation.from_matrix(error_rotation).as_rotvec(),
            error_translation,
            fit.ball_in_flange_mm - BALL_IN_FLANGE_MM,
        ]
    )
    noise = ball_covariance + ROBOT_SIGMA_MM**2 * np.eye(3)
    return Trial(error, fit.joint_covariance, bound(about, turns, shifts, noise))


def cases() -> list[Case]:
    return [
        Case("base, 4 poses tilted 20 deg", 9, lambda rng: trial(rng, 4, 0.35)),
        Case("base, 8 poses tilted 10 deg", 9, lambda rng: trial(rng, 8, 0.17)),
        Case("base, 20 poses tilted 30 deg", 9, lambda rng: trial(rng, 20, 0.5)),
    ]
