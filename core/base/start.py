"""A start for the base fit that is right from any data: least squares over all rotations, no guess needed."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray
from scipy.spatial.transform import Rotation

from core.frames import rotation_from_rotvec, skew

Array = NDArray[np.float64]

_ITERATIONS = 60


@dataclass(frozen=True)
class Start:
    """Unweighted least-squares answer.

    Attributes:
        rotation: (3, 3) base_from_measure.
        translation_mm: (3,) of base_from_measure.
        ball_in_flange_mm: (3,).
        rms_mm: RMS of the residual vectors' length.
        rival_rms_mm: The same for the best answer with a different rotation; inf if there is none.
    """

    rotation: Array
    translation_mm: Array
    ball_in_flange_mm: Array
    rms_mm: float
    rival_rms_mm: float


def global_start(base_from_flange: Array, ball_in_measure_mm: Array) -> Start:
    """Minimise `sum |R_i b + t_i - R C_i - t|^2` over the rotation R and the vectors t, b.

    Centring removes t; projecting on the complement of the centred R_i removes b. What is left is a quadratic
    function of the nine entries of R, minimised over the rotations by Levenberg-Marquardt from the 60 rotations of
    the icosahedral group at once. The cost of a step does not depend on the number of poses.

    Args:
        base_from_flange: (N, 4, 4), N >= 4.
        ball_in_measure_mm: (N, 3).
    """
    n = len(base_from_flange)
    turns, shifts = base_from_flange[:, :3, :3], base_from_flange[:, :3, 3]
    turn_rows = (turns - turns.mean(axis=0)).reshape(3 * n, 3)
    shift_rows = (shifts - shifts.mean(axis=0)).reshape(3 * n)
    balls = ball_in_measure_mm - ball_in_measure_mm.mean(axis=0)
    entry_rows = np.einsum("ac,ib->iacb", np.eye(3), balls).reshape(3 * n, 9)
    offset_basis = np.linalg.qr(turn_rows)[0]
    system = np.column_stack([entry_rows, shift_rows])
    system = system - offset_basis @ (offset_basis.T @ system)
    reduced = np.asarray(np.linalg.qr(system, mode="r"))
    rotations, costs = _minimise(reduced[:, :9], reduced[:, 9])
    best = int(np.argmin(costs))
    rotation = rotations[best]
    different = np.linalg.norm(rotations - rotation, axis=(1, 2)) > 0.05
    rival = float(np.sqrt(costs[different].min() / n)) if np.any(different) else float("inf")
    ball = np.linalg.lstsq(turn_rows, entry_rows @ rotation.ravel() - shift_rows, rcond=None)[0]
    translation = (turns @ ball + shifts - ball_in_measure_mm @ rotation.T).mean(axis=0)
    return Start(rotation, translation, ball, float(np.sqrt(costs[best] / n)), rival)


def _minimise(matrix: Array, target: Array) -> tuple[Array, Array]:
    """Local minima of |matrix vec(R) - target|^2 over rotations, from all starts: (K, 3, 3) and costs (K,)."""
    rotations = np.asarray(Rotation.create_group("I").as_matrix())
    generators = skew(np.eye(3))
    damping = np.full(len(rotations), 1e-3)

    def residual(r: Array) -> Array:
        return np.asarray(r.reshape(-1, 9) @ matrix.T - target)

    errors = residual(rotations)
    costs = np.sum(errors**2, axis=1)
    for _ in range(_ITERATIONS):
        turned = np.einsum("mab,kbc->kmac", generators, rotations).reshape(-1, 3, 9)
        jacobian = turned @ matrix.T
        normal = jacobian @ np.swapaxes(jacobian, 1, 2)
        size = np.trace(normal, axis1=1, axis2=2) + np.finfo(float).tiny
        normal = normal + (damping * size)[:, None, None] * np.eye(3)
        step = -np.linalg.solve(normal, np.einsum("kmr,kr->km", jacobian, errors)[..., None])[..., 0]
        trial = rotation_from_rotvec(step) @ rotations
        trial_errors = residual(trial)
        trial_costs = np.sum(trial_errors**2, axis=1)
        better = trial_costs < costs
        rotations = np.where(better[:, None, None], trial, rotations)
        errors = np.where(better[:, None], trial_errors, errors)
        costs = np.where(better, trial_costs, costs)
        damping = np.clip(np.where(better, damping * 0.2, damping * 5.0), 1e-12, 1e6)
        if np.max(np.linalg.norm(step, axis=1)) < 1e-10:
            break
    return rotations, costs
