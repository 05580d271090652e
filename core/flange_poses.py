"""Flange poses as a robot reports them: validation, and which of them are repeats."""

from __future__ import annotations

import numpy as np
from numpy.typing import ArrayLike, NDArray

from core.errors import InputError
from core.frames import checked_rigid

Array = NDArray[np.float64]

# Real cells are larger than this; anything smaller was written in metres.
METRES_BELOW_MM = 10.0


def checked_flange_poses(base_from_flange: ArrayLike) -> Array:
    """Validate a stack of rigid flange poses in mm: (N, 4, 4).

    Raises:
        InputError: not a stack of rigid transforms, or written in metres.
    """
    try:
        stack = np.asarray(base_from_flange, dtype=float)
    except (TypeError, ValueError) as error:
        raise InputError("base_from_flange: expected N matrices of 4x4 numbers.") from error
    if stack.ndim != 3 or stack.shape[1:] != (4, 4):
        raise InputError(f"base_from_flange: expected N matrices 4x4, found shape {stack.shape}.")
    poses = [checked_rigid(matrix, f"observations[{i}].base_from_flange") for i, matrix in enumerate(stack)]
    result = np.array(poses).reshape(-1, 4, 4)
    if len(result) and np.abs(result[:, :3, 3]).max() < METRES_BELOW_MM:
        raise InputError(
            f"base_from_flange: no flange is farther than {np.abs(result[:, :3, 3]).max():.3g} from the robot base. "
            "That looks like metres; positions must be in mm."
        )
    return result


def pose_groups(matrices: Array, *, distance_mm: float = 0.5, angle_rad: float = 2e-3) -> NDArray[np.int64]:
    """Number poses (N, 4, 4) so that repeats of one pose share a number; repeats add no geometry.

    Args:
        matrices: (N, 4, 4) rigid transforms.
        distance_mm: Poses nearer than this ...
        angle_rad: ... and turned by less than this are the same pose.
    """
    groups = np.full(len(matrices), -1, dtype=np.int64)
    found = 0
    for i in range(len(matrices)):
        if groups[i] >= 0:
            continue
        near = np.linalg.norm(matrices[:, :3, 3] - matrices[i, :3, 3], axis=1) < distance_mm
        turned = angles_between(matrices[:, :3, :3], matrices[i, :3, :3]) < angle_rad
        groups[near & turned & (groups < 0)] = found
        found += 1
    return groups


def angles_between(rotations: Array, reference: Array) -> Array:
    """Angle in rad between each of (N, 3, 3) rotations and one (3, 3); chord formula, exact near zero."""
    chord = np.linalg.norm(rotations - reference, axis=(-2, -1))
    return np.asarray(2.0 * np.arcsin(np.minimum(chord / np.sqrt(8.0), 1.0)))
