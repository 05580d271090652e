"""Picked pairs: five picks as an operator makes them, known and unknown noise."""

from __future__ import annotations

import numpy as np
from scipy.spatial.transform import Rotation

from benchmarks.efficiency.common import Array, Case, Trial
from core.frames import pose_error
from core.rough import solve_pairs

SIGMA_MM = 0.5
# Corners of edge plate and shroud of a 300 mm blade, frame W.
PICKS_MM = np.array(
    [[-30.0, -20.0, 5.0], [35.0, -15.0, 0.0], [10.0, 22.0, 12.0], [-20.0, 5.0, 300.0], [25.0, 18.0, 310.0]]
)


def cases() -> list[Case]:
    return [
        Case("rough, 5 pairs, known noise", 6, lambda rng: _trial(rng, PICKS_MM, True)),
        Case("rough, 3 pairs, known noise", 6, lambda rng: _trial(rng, PICKS_MM[[0, 2, 4]], True)),
        Case("rough, 60 pairs, noise from residuals", 6, lambda rng: _trial(rng, np.tile(PICKS_MM, (12, 1)), False)),
    ]


def _trial(rng: np.random.Generator, picks: Array, known: bool) -> Trial:
    truth = np.eye(4)
    truth[:3, :3] = Rotation.random(random_state=rng).as_matrix()
    truth[:3, 3] = rng.uniform(-200.0, 200.0, 3)
    exact = picks @ truth[:3, :3].T + truth[:3, 3]
    fit = solve_pairs(exact + rng.normal(0.0, SIGMA_MM, exact.shape), picks, sigma_mm=SIGMA_MM if known else None)
    about = fit.covariance.about_mm
    return Trial(pose_error(fit.measure_from_work, truth, about), fit.covariance.matrix, _bound(exact, about))


def _bound(points: Array, about: Array) -> Array:
    """Inverse Fisher information by central differences of the forward model (rotate about a point, then shift)."""
    step, columns = 1e-5, []
    for k in range(6):
        moved = []
        for sign in (1.0, -1.0):
            change = np.zeros(6)
            change[k] = sign * step
            turn = Rotation.from_rotvec(change[:3])
            moved.append(turn.apply(points - about) + about + change[3:])
        columns.append((moved[0] - moved[1]).ravel() / (2.0 * step))
    jacobian = np.stack(columns, axis=1)
    return np.asarray(SIGMA_MM**2 * np.linalg.inv(jacobian.T @ jacobian))
