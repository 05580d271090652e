"""The few transforms that the simulator needs; written apart from the estimators' on purpose."""

from __future__ import annotations

import numpy as np
from numpy.typing import ArrayLike, NDArray
from scipy.spatial.transform import Rotation

Array = NDArray[np.float64]


def rigid(rotation: ArrayLike, translation_mm: ArrayLike) -> Array:
    """4x4 transform from a rotation (3, 3) and a translation (3,) in mm."""
    matrix = np.eye(4)
    matrix[:3, :3] = rotation
    matrix[:3, 3] = translation_mm
    return matrix


def pose(translation_mm: ArrayLike, euler_zyx_deg: ArrayLike) -> Array:
    """4x4 transform with R = Rot(Z, a) Rot(Y, b) Rot(X, c), angles in degrees as in cell files."""
    rotation = Rotation.from_euler("ZYX", np.asarray(euler_zyx_deg, dtype=float), degrees=True).as_matrix()
    return rigid(rotation, translation_mm)


def inverse(a_from_b: Array) -> Array:
    """b_from_a of one rigid transform."""
    rotation = a_from_b[:3, :3]
    return rigid(rotation.T, -rotation.T @ a_from_b[:3, 3])


def apply(a_from_b: Array, points_in_b: ArrayLike) -> Array:
    """Map points (..., 3) from b to a."""
    return np.asarray(np.asarray(points_in_b, dtype=float) @ a_from_b[:3, :3].T + a_from_b[:3, 3])


def turn(rotvec_rad: ArrayLike) -> Array:
    """3x3 rotation of a rotation vector."""
    return np.asarray(Rotation.from_rotvec(np.asarray(rotvec_rad, dtype=float)).as_matrix())


def unit(vector: ArrayLike) -> Array:
    """A vector (3,) at length one."""
    array = np.asarray(vector, dtype=float)
    return np.asarray(array / np.linalg.norm(array))


def random_unit(rng: np.random.Generator) -> Array:
    """A direction, evenly distributed over the sphere."""
    return unit(rng.standard_normal(3))


def small_pose(rng: np.random.Generator, shift_mm: float, tilt_rad: float) -> Array:
    """A transform of a random direction with exactly this shift and this tilt."""
    return rigid(turn(random_unit(rng) * tilt_rad), random_unit(rng) * shift_mm)
