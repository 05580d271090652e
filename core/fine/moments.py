"""Sums over the points of a face from which a pose is solved without seeing the points again.

A pose change is `perturbed(measure_from_work, xi, centre)`: the model moves by `xi_r x (p - c) + xi_t`, so a point's
distance `d = n . (p - foot)` changes by `-J xi` with `J = [(p - c) x n, n]`.

Plane: with `q = (p - c, 1)`, `pi = (n, n . c - offset)` the distance is `pi . q` and `J = K q`, so that
`sum w J J^T = K S K^T` and `sum w J d = K S pi` for the 4x4 moments `S = sum w q q^T`, at any pose.
Cylinder: `sum w (J, d)(J, d)^T` at the pose of the pass; exact to first order in the change since.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from core.cad import Plane
from core.fine.boxes import Target, cylinder_rows
from core.frames import perturbed, pose_error, skew, transform_points

Array = NDArray[np.float64]


@dataclass(frozen=True, eq=False)
class PlaneMoments:
    """Weighted moments of a plane's points.

    Attributes:
        surface: The plane in W.
        sums: (4, 4) sum of w q q^T.
        centre: (3,) c in M.
    """

    surface: Plane
    sums: Array
    centre: Array

    @property
    def weight(self) -> float:
        """Sum of the weights."""
        return float(self.sums[3, 3])

    def normal_equations(self, measure_from_work: Array) -> tuple[Array, Array]:
        """(6, 6) sum of w J J^T and (6,) sum of w J d at a pose."""
        rows, plane = self._at(measure_from_work)
        return rows @ self.sums @ rows.T, rows @ self.sums @ plane

    def mean_row(self, measure_from_work: Array) -> tuple[Array, float]:
        """Weighted means of J (6,) and of d in mm."""
        rows, plane = self._at(measure_from_work)
        return rows @ self.sums[3] / self.weight, float(plane @ self.sums[3]) / self.weight

    def _at(self, measure_from_work: Array) -> tuple[Array, Array]:
        """K (6, 4) and pi (4,) of a pose."""
        normal = measure_from_work[:3, :3] @ self.surface.normal
        origin = transform_points(measure_from_work, self.surface.origin)
        rows = np.zeros((6, 4))
        rows[:3, :3] = -skew(normal)
        rows[3:, 3] = normal
        return rows, np.append(normal, normal @ (self.centre - origin))


@dataclass(frozen=True, eq=False)
class LinearMoments:
    """Weighted normal equations of any surface at one pose.

    Attributes:
        sums: (8, 8) sum of w (J, d, 1)(J, d, 1)^T.
        pose: measure_from_work of the pass.
        centre: (3,) c in M.
    """

    sums: Array
    pose: Array
    centre: Array

    @property
    def weight(self) -> float:
        """Sum of the weights."""
        return float(self.sums[7, 7])

    def normal_equations(self, measure_from_work: Array) -> tuple[Array, Array]:
        """(6, 6) sum of w J J^T and (6,) sum of w J d at a pose near that of the pass."""
        moved = pose_error(measure_from_work, self.pose, self.centre)
        return self.sums[:6, :6], self.sums[:6, 6] - self.sums[:6, :6] @ moved

    def mean_row(self, measure_from_work: Array) -> tuple[Array, float]:
        """Weighted means of J (6,) and of d in mm."""
        moved = pose_error(measure_from_work, self.pose, self.centre)
        row = self.sums[7, :6] / self.weight
        return row, float(self.sums[7, 6] / self.weight - row @ moved)


Moments = PlaneMoments | LinearMoments


def accumulate(target: Target, points: Array, weights: Array, measure_from_work: Array, centre: Array) -> Moments:
    """One face's share of a pass over the points.

    Args:
        target: The face.
        points: (n, 3) mm in M.
        weights: (n,).
        measure_from_work: Pose of the pass.
        centre: (3,) mm in M, common to all faces.
    """
    surface = target.patch.surface
    if isinstance(surface, Plane):
        q = np.empty((len(points), 4))
        q[:, :3] = points - centre
        q[:, 3] = 1.0
        return PlaneMoments(surface, q.T @ (q * weights[:, None]), centre)
    d, normals = cylinder_rows(surface, points, measure_from_work)
    rows = np.column_stack([np.cross(points - centre, normals), normals, d, np.ones(len(points))])
    return LinearMoments(rows.T @ (rows * weights[:, None]), measure_from_work, centre)


def normal_equations(moments: Sequence[Moments], scales: Sequence[float],
                     measure_from_work: Array) -> tuple[Array, Array]:
    """Sum over the faces of (6, 6) and (6,), each face's share multiplied by its scale."""
    matrix, right = np.zeros((6, 6)), np.zeros(6)
    for moment, scale in zip(moments, scales, strict=True):
        part, part_right = moment.normal_equations(measure_from_work)
        matrix += scale * part
        right += scale * part_right
    return matrix, right


def solve_moments(moments: Sequence[Moments], scales: Sequence[float], start: Array, centre: Array, *,
                  least_ratio: float = 0.0, lever_mm: float = 1.0, rounds: int = 10) -> Array:
    """Gauss-Newton on the moments alone.

    Args:
        moments: One per face.
        scales: One per face, 1 / sigma^2.
        start: measure_from_work.
        centre: (3,) about which the rotation turns.
        least_ratio: Directions observed worse than this share of the best (in singular values) stay where they are.
        lever_mm: Makes rotations comparable with translations.
        rounds: Upper limit.

    Returns:
        measure_from_work.
    """
    units = np.array([1.0 / lever_mm] * 3 + [1.0] * 3)
    pose = start
    for _ in range(rounds):
        matrix, right = normal_equations(moments, scales, pose)
        values, vectors = np.linalg.eigh(matrix * np.outer(units, units))
        seen = values > max(values[-1] * max(least_ratio, 1e-9) ** 2, 0.0)
        step = units * (vectors[:, seen] @ ((vectors[:, seen].T @ (units * right)) / values[seen]))
        pose = perturbed(pose, step, centre)
        if np.abs(step / units).max() < 1e-9:
            break
    return pose
