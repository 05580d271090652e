"""The stage's forward model in the scanner's frame: variable projection for the start, Gauss-Newton for the answer.

All unknowns are written in the scanner's frame as it stands at the zero position, `S0`. There

    ball_in_scanner_i = (I - R_i^T) c + R_i^T (b - A q_i),   R_i = Rot(axis, theta_i)

with A (3, k) the directions of the k moved linear axes times their scale, b the ball, `axis` the rotary axis and c a
point on it. For a given axis the rest (A, b, c) is linear, so that only the two angles of the axis need a search.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from core.ball.coverage import fibonacci_directions
from core.frames import rotation_from_rotvec, skew

Array = NDArray[np.float64]


@dataclass(frozen=True)
class StageModel:
    """Unknowns in S0: ball (3,), axes (3, k), rotary axis and point (3,) each (None if the rotary axis never moved)."""

    ball: Array
    axes: Array
    rotary: Array | None
    point: Array | None

    @property
    def unknowns(self) -> int:
        """Number of free unknowns."""
        return 3 + self.axes.size + (0 if self.rotary is None else 4)

    def moved(self, step: Array) -> StageModel:
        """The model after a step (ball 3, axes 3k column by column, axis tilt 2, axis shift 2)."""
        count = 3 + self.axes.size
        axes = self.axes + step[3:count].reshape(-1, 3).T
        if self.rotary is None or self.point is None:
            return StageModel(self.ball + step[:3], axes, None, None)
        sides = tangents(self.rotary)
        tilt = rotation_from_rotvec(step[count : count + 2] @ sides)
        rotary = tilt @ self.rotary
        point = self.point + step[count + 2 :] @ sides
        return StageModel(self.ball + step[:3], axes, rotary, point - rotary * (rotary @ point))

    def predicted(self, travel: Array, angle: Array) -> Array:
        """Ball in the scanner (N, 3) at the moved axes' travel (N, k), mm, and rotary angles (N,), rad."""
        at_zero = self.ball - travel @ self.axes.T
        if self.rotary is None or self.point is None:
            return at_zero
        back = rotation_from_rotvec(-angle[:, None] * self.rotary)
        return np.asarray(self.point + np.einsum("nij,nj->ni", back, at_zero - self.point))

    def jacobian(self, travel: Array, angle: Array) -> Array:
        """(N, 3, unknowns) derivative of `predicted` by the step of `moved`."""
        count = len(travel)
        out = np.zeros((count, 3, self.unknowns))
        linear = 3 + self.axes.size
        back = np.broadcast_to(np.eye(3), (count, 3, 3))
        if self.rotary is not None:
            back = rotation_from_rotvec(-angle[:, None] * self.rotary)
        out[:, :, :3] = back
        for k in range(self.axes.shape[1]):
            out[:, :, 3 + 3 * k : 6 + 3 * k] = -back * travel[:, k, None, None]
        if self.rotary is None or self.point is None:
            return out
        sides = tangents(self.rotary)
        arm = self.ball - travel @ self.axes.T - self.point
        turned = np.einsum("nij,nj->ni", back, arm)
        # Tilting the axis by w: Rot' = Rot(w) Rot Rot(-w).
        by_tilt = -skew(turned) + back @ skew(arm)
        out[:, :, linear : linear + 2] = by_tilt @ sides.T
        out[:, :, linear + 2 :] = (np.eye(3) - back) @ sides.T
        return out


def tangents(direction: Array) -> Array:
    """(2, 3) unit vectors at right angles to a direction and to each other."""
    helper = np.eye(3)[int(np.argmin(np.abs(direction)))]
    first = np.cross(direction, helper)
    first /= np.linalg.norm(first)
    return np.array([first, np.cross(direction, first)])


def _best_for_axis(
    rotary: Array | None, travel: Array, angle: Array, balls: Array, weights: Array
) -> tuple[StageModel, float]:
    """The linear unknowns for a given rotary axis and the weighted sum of squares left."""
    count, k = travel.shape
    identity = np.broadcast_to(np.eye(3), (count, 3, 3))
    back = identity if rotary is None else rotation_from_rotvec(-angle[:, None] * rotary)
    blocks = [back, *(-back * travel[:, i, None, None] for i in range(k))]
    if rotary is not None:
        blocks.append((np.eye(3) - back) @ tangents(rotary).T)
    design = (np.concatenate(blocks, axis=2) * weights[:, None, None]).reshape(3 * count, -1)
    right = (balls * weights[:, None]).ravel()
    solution: Array = np.asarray(np.linalg.lstsq(design, right, rcond=1e-12)[0], dtype=float)
    left = right - design @ solution
    axes = solution[3 : 3 + 3 * k].reshape(k, 3).T
    point = None if rotary is None else solution[3 + 3 * k :] @ tangents(rotary)
    return StageModel(solution[:3], axes, rotary, point), float(left @ left)


def solve_model(
    travel: Array, angle: Array, balls: Array, weights: Array, *, rotary: bool
) -> tuple[StageModel, int, bool]:
    """Weighted least squares from any set of positions; no pattern of moves is assumed.

    Args:
        travel: (N, k) positions of the moved linear axes, mm.
        angle: (N,) rad.
        balls: (N, 3) ball in the scanner, mm.
        weights: (N,) 1 / sigma.
        rotary: True if the rotary axis is among the unknowns.

    Returns:
        (model, iterations, converged).
    """
    if not rotary:
        model, _ = _best_for_axis(None, travel, angle, balls, weights)
        return model, 1, True
    starts = [_best_for_axis(axis, travel, angle, balls, weights) for axis in fibonacci_directions(100)]
    starts.sort(key=lambda start: start[1])
    results = [_gauss_newton(model, travel, angle, balls, weights) for model, _ in starts[:3]]
    model, iterations, converged, _ = min(results, key=lambda result: result[3])
    return model, iterations, converged


def _gauss_newton(
    model: StageModel, travel: Array, angle: Array, balls: Array, weights: Array
) -> tuple[StageModel, int, bool, float]:
    """Levenberg-Marquardt with column scaling; returns (model, iterations, converged, weighted sum of squares)."""

    def residuals(current: StageModel) -> Array:
        return np.asarray(((balls - current.predicted(travel, angle)) * weights[:, None]).ravel())

    left = residuals(model)
    cost = float(left @ left)
    damping = 1e-6
    for iteration in range(1, 101):
        jacobian = (model.jacobian(travel, angle) * weights[:, None, None]).reshape(len(left), -1)
        size = np.maximum(np.linalg.norm(jacobian, axis=0), 1e-300)
        scaled = jacobian / size
        system = np.vstack([scaled, np.sqrt(damping) * np.eye(len(size))])
        step, *_ = np.linalg.lstsq(system, np.concatenate([left, np.zeros(len(size))]), rcond=1e-13)
        trial = model.moved(step / size)
        trial_left = residuals(trial)
        trial_cost = float(trial_left @ trial_left)
        # The step's length in units of the noise: weights are 1 / sigma, or 1 / mm where none is known.
        if float(np.linalg.norm(step)) < 1e-9 * (1.0 + np.sqrt(cost)):
            return model, iteration, True, cost
        if trial_cost <= cost * (1.0 + 1e-12):
            model, left, cost = trial, trial_left, trial_cost
            damping = max(damping * 0.1, 1e-15)
        else:
            damping *= 10.0
            if damping > 1e8:
                return model, iteration, True, cost
    return model, 100, False, cost
