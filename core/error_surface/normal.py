"""Head angle to normal error and back; everything in {H}, where the head's axis is z and its lever is x."""

from __future__ import annotations

import numpy as np
from numpy.typing import ArrayLike, NDArray

from core.errors import InputError
from core.verdict import Code

Array = NDArray[np.float64]

# Below this the head moves almost along the blade's surface: friction, not the blade, decides where it stops.
LEAST_SENSITIVITY = 0.2


def normal_error(angle_rad: ArrayLike, normal_in_tool: ArrayLike, radius_mm: float) -> Array:
    """Normal error `e = n . (Rot(z, angle) - I) (K0 - O)` with `K0 - O = radius_mm * x`.

    Exact for the displacement of the wheel's centre on its circle; no small-angle approximation.

    Args:
        angle_rad: (N,) how far the head has turned against the nominal contact, right-handed about z of {H}.
        normal_in_tool: (N, 3) or (3,) outward unit normals of the airfoil at the contact, in {H}.
        radius_mm: Distance from the head's axis to the wheel's centre.

    Returns:
        (N,) mm; positive where material stands proud of the design.

    Raises:
        InputError: shapes, NaN, angles that look like degrees, normals that are not unit vectors or that the head
            cannot feel, or a radius that is not a positive length in mm.
    """
    angle, normal = _checked(angle_rad, normal_in_tool, radius_mm, "angle")
    if angle.size and np.abs(angle).max() > 1.0:
        row = int(np.argmax(np.abs(angle)))
        raise InputError(
            f"angle, sample {row + 1}: {np.degrees(angle[row]):.4g} degrees is more than a head in contact can turn "
            "(57 degrees). Check the unit of the angle and the sensor's zero."
        )
    return np.asarray(radius_mm * ((np.cos(angle) - 1.0) * normal[:, 0] + np.sin(angle) * normal[:, 1]))


def angle_for_error(error_mm: ArrayLike, normal_in_tool: ArrayLike, radius_mm: float) -> Array:
    """Head angle (N,) in rad at which `normal_error` is `error_mm` (N,); the solution nearest to zero.

    Raises:
        InputError: as `normal_error`, or an error farther than the head can reach on its circle.
    """
    error, normal = _checked(error_mm, normal_in_tool, radius_mm, "error_mm")
    amplitude = np.hypot(normal[:, 0], normal[:, 1])
    cosine = (error / radius_mm + normal[:, 0]) / amplitude
    if np.any(np.abs(cosine) > 1.0):
        row = int(np.argmax(np.abs(cosine)))
        raise InputError(
            f"error_mm, sample {row + 1}: {error[row]:.4g} mm is out of reach of a head of radius {radius_mm:.4g} mm."
        )
    phase = np.arctan2(normal[:, 1], normal[:, 0])
    return np.asarray(phase - np.sign(normal[:, 1]) * np.arccos(cosine))


def _checked(values: ArrayLike, normal_in_tool: ArrayLike, radius_mm: float, field: str) -> tuple[Array, Array]:
    scalar = np.asarray(values, dtype=float).reshape(-1)
    normal = np.atleast_2d(np.asarray(normal_in_tool, dtype=float))
    if normal.shape == (1, 3):
        normal = np.repeat(normal, scalar.size, axis=0)
    if normal.shape != (scalar.size, 3):
        raise InputError(f"normals: expected {scalar.size} rows of nx, ny, nz, found shape {normal.shape}.")
    if not np.isfinite(radius_mm) or not 5.0 <= radius_mm <= 5000.0:
        raise InputError(f"radius_mm: expected the head's radius in mm (5 to 5000), found {radius_mm:g}.")
    bad = ~(np.isfinite(scalar) & np.all(np.isfinite(normal), axis=1))
    if np.any(bad):
        row = int(np.argmax(bad))
        raise InputError(f"{field} or normal, sample {row + 1}: not a number ({int(bad.sum())} such samples).")
    length = np.linalg.norm(normal, axis=1)
    if np.any(np.abs(length - 1.0) > 0.01):
        row = int(np.argmax(np.abs(length - 1.0)))
        raise InputError(f"normal, sample {row + 1}: length {length[row]:.4g}, expected a unit vector.")
    normal = normal / length[:, None]
    if np.any(np.abs(normal[:, 1]) < LEAST_SENSITIVITY):
        row = int(np.argmin(np.abs(normal[:, 1])))
        raise InputError(
            f"normal, sample {row + 1}: ({normal[row, 0]:.2f}, {normal[row, 1]:.2f}, {normal[row, 2]:.2f}) is almost "
            "at right angles to the head's motion (y of the tool frame), so the head cannot feel an error there. "
            "Check that the normals are given in the tool frame.",
            Code.NOT_ENOUGH_VARIATION,
        )
    return scalar, normal
