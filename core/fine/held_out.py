"""Checks on data that a pose has not seen: every face predicted by the others, and two halves against each other."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

from core.fine.moments import accumulate, normal_equations, solve_moments
from core.frames import transform_points

if TYPE_CHECKING:
    from core.fine.estimate import Estimate

Array = NDArray[np.float64]

_BLOCK_MM = 5.0
# Without a face, a direction may be seen this much worse (in standard deviations) before the others can't predict it.
_STILL_SEEN = 30.0


def held_out_means(result: Estimate) -> list[tuple[float, float]]:
    """Mean distance of each used face's points under the pose without that face, and its standard error; mm.

    One Gauss-Newton step on the moments that are left, from the common pose. NaN where they don't hold the pose.
    """
    used = result.used
    moments = [face.moments for face in used if face.moments is not None]
    scales = [face.mixture.sigma_mm**-2 for face in used]
    pose = result.measure_from_work
    matrix, right = normal_equations(moments, scales, pose)
    root = np.linalg.cholesky(_regular(matrix, result.lever_mm))
    means = []
    for face, moment, scale in zip(used, moments, scales, strict=True):
        own, own_right = moment.normal_equations(pose)
        left = matrix - scale * own
        row, mean = moment.mean_row(pose)
        white = np.linalg.solve(root, np.linalg.solve(root, left).T)
        if np.linalg.eigvalsh(white)[0] < _STILL_SEEN**-2:
            means.append((float("nan"), float("nan")))
            continue
        step = np.linalg.solve(left, right - scale * own_right)
        variance = row @ np.linalg.solve(left, row) + face.mixture.sigma_mm**2 / moment.weight
        means.append((float(mean - row @ step), float(np.sqrt(variance))))
    return means


def half_split(result: Estimate, points_in_measure: Array) -> Array:
    """Distances (k,) in mm at points (k, 3) of M between the poses of two halves of the data.

    The halves are alternating blocks of 5 mm, so that what neighbours have in common doesn't hide.
    """
    poses = []
    for half in (0, 1):
        moments = []
        for face in result.used:
            block = np.floor(face.box.points / _BLOCK_MM).astype(np.int64).sum(axis=1) % 2 == half
            moments.append(accumulate(face.target, face.box.points[block], face.weights[block],
                                      result.measure_from_work, result.centre))
        scales = [face.mixture.sigma_mm**-2 for face in result.used]
        poses.append(solve_moments(moments, scales, result.measure_from_work, result.centre, least_ratio=1e-4,
                                   lever_mm=result.lever_mm))
    apart = poses[1] @ np.linalg.inv(poses[0])
    return np.asarray(np.linalg.norm(transform_points(apart, points_in_measure) - points_in_measure, axis=1))


def _regular(matrix: Array, lever: float) -> Array:
    """The matrix with a trace of itself on the diagonal, so that a free direction has a factor too."""
    units = np.array([lever**2] * 3 + [1.0] * 3)
    return matrix + np.diag(units) * (1e-12 * float(np.trace(matrix[3:, 3:])))
