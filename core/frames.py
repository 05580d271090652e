"""Rigid transforms, written `a_from_b` with `p_a = a_from_b @ p_b`; mm and rad.

A pose error is the six-vector (rx, ry, rz, tx, ty, tz), expressed in the target frame `a`, about a stated point `c`:
`p_a' = c + Rot(r) (p_a - c) + t`.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike, NDArray
from scipy.spatial.transform import Rotation

from core.errors import InputError

Array = NDArray[np.float64]

# A matrix typed with four decimals is still a rotation; a scaled or sheared one is not.
ORTHONORMAL_TOLERANCE = 2e-3


def rigid(rotation: ArrayLike, translation: ArrayLike) -> Array:
    """Build a 4x4 transform from a 3x3 rotation and a translation (3,) in mm."""
    matrix = np.eye(4)
    matrix[:3, :3] = np.asarray(rotation, dtype=float)
    matrix[:3, 3] = np.asarray(translation, dtype=float)
    return matrix


def inverse(a_from_b: Array) -> Array:
    """`b_from_a`; works on one (4, 4) or a stack (..., 4, 4)."""
    rotation_t = np.swapaxes(a_from_b[..., :3, :3], -1, -2)
    result = np.zeros_like(a_from_b)
    result[..., :3, :3] = rotation_t
    result[..., :3, 3] = -(rotation_t @ a_from_b[..., :3, 3:4])[..., 0]
    result[..., 3, 3] = 1.0
    return result


def transform_points(a_from_b: Array, points_in_b: ArrayLike) -> Array:
    """Map points (..., 3) in mm from frame b to frame a by one (4, 4) transform."""
    points = np.asarray(points_in_b, dtype=float)
    return np.asarray(points @ a_from_b[:3, :3].T + a_from_b[:3, 3])


def rotate(a_from_b: Array, vectors_in_b: ArrayLike) -> Array:
    """Rotate direction vectors (..., 3) from frame b to frame a by one (4, 4) transform."""
    return np.asarray(np.asarray(vectors_in_b, dtype=float) @ a_from_b[:3, :3].T)


def rotation_from_rotvec(rotvec_rad: ArrayLike) -> Array:
    """3x3 rotation (or a stack) from rotation vectors (..., 3) in rad."""
    return np.asarray(Rotation.from_rotvec(np.asarray(rotvec_rad, dtype=float)).as_matrix())


def rotvec_from_rotation(rotation: ArrayLike) -> Array:
    """Rotation vector(s) (..., 3) in rad of 3x3 rotation(s)."""
    return np.asarray(Rotation.from_matrix(np.asarray(rotation, dtype=float)).as_rotvec())


def rotation_from_euler_zyx(alpha_rad: float, beta_rad: float, gamma_rad: float) -> Array:
    """R = Rot(Z, alpha) Rot(Y, beta) Rot(X, gamma), intrinsic ZYX, rad."""
    return np.asarray(Rotation.from_euler("ZYX", [alpha_rad, beta_rad, gamma_rad]).as_matrix())


def euler_zyx_from_rotation(rotation: ArrayLike) -> Array:
    """(alpha, beta, gamma) in rad with R = Rot(Z, alpha) Rot(Y, beta) Rot(X, gamma)."""
    matrix = np.asarray(rotation, dtype=float)
    beta = float(np.arctan2(-matrix[2, 0], np.hypot(matrix[0, 0], matrix[1, 0])))
    if np.hypot(matrix[0, 0], matrix[1, 0]) < 1e-9:
        # Gimbal lock: only alpha -/+ gamma is determined; gamma is set to zero.
        return np.array([np.arctan2(-matrix[0, 1], matrix[1, 1]), beta, 0.0])
    alpha = float(np.arctan2(matrix[1, 0], matrix[0, 0]))
    gamma = float(np.arctan2(matrix[2, 1], matrix[2, 2]))
    return np.array([alpha, beta, gamma])


def nearest_rotation(matrix: ArrayLike) -> Array:
    """The rotation nearest to a 3x3 matrix in the Frobenius norm (SVD, determinant kept at +1)."""
    u, _, vt = np.linalg.svd(np.asarray(matrix, dtype=float))
    sign = np.diag([1.0, 1.0, np.sign(np.linalg.det(u @ vt))])
    return np.asarray(u @ sign @ vt)


def skew(vectors: ArrayLike) -> Array:
    """Cross-product matrices (..., 3, 3) with `skew(a) @ b = a x b`."""
    v = np.asarray(vectors, dtype=float)
    out = np.zeros((*v.shape[:-1], 3, 3))
    out[..., 0, 1], out[..., 0, 2], out[..., 1, 2] = -v[..., 2], v[..., 1], -v[..., 0]
    out[..., 1, 0], out[..., 2, 0], out[..., 2, 1] = v[..., 2], -v[..., 1], v[..., 0]
    return out


def perturbed(a_from_b: Array, error: ArrayLike, about_in_a: ArrayLike) -> Array:
    """Apply a pose error (6,) (rx ry rz tx ty tz; rad, mm) about a point (3,) of frame a."""
    xi = np.asarray(error, dtype=float)
    centre = np.asarray(about_in_a, dtype=float)
    rotation = rotation_from_rotvec(xi[:3])
    step = rigid(rotation, centre - rotation @ centre + xi[3:])
    return np.asarray(step @ a_from_b)


def pose_error(estimate: Array, truth: Array, about_in_a: ArrayLike) -> Array:
    """The six-vector `e` with `estimate = perturbed(truth, e, about_in_a)`."""
    centre = np.asarray(about_in_a, dtype=float)
    step = estimate @ inverse(truth)
    rotvec = rotvec_from_rotation(step[:3, :3])
    translation = step[:3, 3] - centre + step[:3, :3] @ centre
    return np.concatenate([rotvec, translation])


@dataclass(frozen=True)
class PoseCovariance:
    """6x6 covariance of a pose error (rx ry rz tx ty tz; rad, mm) about a point of the target frame.

    Attributes:
        matrix: (6, 6), symmetric.
        about_mm: (3,) the point in the target frame about which the rotation turns.
    """

    matrix: Array
    about_mm: Array

    def moved_to(self, point_mm: ArrayLike) -> PoseCovariance:
        """The same uncertainty stated about another point (3,) of the target frame."""
        point = np.asarray(point_mm, dtype=float)
        jacobian = np.eye(6)
        jacobian[3:, :3] = -skew(point - self.about_mm)
        return PoseCovariance(jacobian @ self.matrix @ jacobian.T, point)

    def of_point(self, point_mm: ArrayLike) -> Array:
        """3x3 covariance in mm^2 of a carried point (3,), given in the target frame."""
        return self.moved_to(point_mm).matrix[3:, 3:]


def checked_rigid(matrix: object, field: str) -> Array:
    """Validate a 4x4 rigid transform in mm that a person or a file supplied.

    Args:
        matrix: Nested lists or array.
        field: What to call it in the message, e.g. `observations[3].base_from_flange`.

    Returns:
        (4, 4) with its rotation part made exactly orthonormal.

    Raises:
        InputError: shape, numbers, bottom row, scale, handedness or shear are wrong.
    """
    try:
        array = np.asarray(matrix, dtype=float)
    except (TypeError, ValueError) as error:
        raise InputError(f"{field}: expected a 4x4 matrix of numbers, row by row.") from error
    if array.shape != (4, 4):
        raise InputError(f"{field}: expected a 4x4 matrix, found shape {array.shape}.")
    if not np.all(np.isfinite(array)):
        raise InputError(f"{field}: the matrix contains NaN or infinite numbers.")
    if np.abs(array[3] - [0.0, 0.0, 0.0, 1.0]).max() > 1e-9:
        found = " ".join(f"{value:g}" for value in array[3])
        hint = " It looks transposed." if np.abs(array[:3, 3]).max() < 1e-9 else ""
        raise InputError(f"{field}: the last row must be 0 0 0 1, found {found}.{hint}")
    rotation = array[:3, :3]
    if np.linalg.det(rotation) <= 0.0:
        raise InputError(f"{field}: the rotation part is left-handed or singular (determinant "
                         f"{np.linalg.det(rotation):.4g}, expected +1). Check for swapped or mirrored axes.")
    lengths = np.linalg.norm(rotation, axis=0)
    if np.abs(lengths - 1.0).max() > ORTHONORMAL_TOLERANCE:
        raise InputError(f"{field}: the rotation part is scaled (axis lengths {lengths[0]:.4g}, {lengths[1]:.4g}, "
                         f"{lengths[2]:.4g}, expected 1). Give a pure rotation.")
    if np.abs(rotation.T @ rotation - np.eye(3)).max() > ORTHONORMAL_TOLERANCE:
        raise InputError(f"{field}: the axes of the rotation part are not at right angles. Give a pure rotation.")
    return rigid(nearest_rotation(rotation), array[:3, 3])
