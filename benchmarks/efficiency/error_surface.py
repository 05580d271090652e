"""Efficiency of the error surface: values at seven points, least-squares spline on scattered samples; and the grid."""

from __future__ import annotations

import numpy as np

from benchmarks.efficiency.common import Case, Trial
from core.error_surface import fit_error_surface

SIGMA_MM = 0.03
INTERVALS = (3, 4)
POINTS_U = np.array([0.12, 0.2, 0.35, 0.5, 0.65, 0.8, 0.88])
POINTS_V = np.array([0.5, 0.85, 0.15, 0.62, 0.3, 0.77, 0.45])


def _powers(x, intervals):
    """Truncated powers: the space of cubic splines with these knots, without B-splines."""
    knots = np.linspace(0.0, 1.0, intervals + 1)[1:-1]
    return np.column_stack([np.ones_like(x), x, x**2, x**3, *(np.maximum(x - k, 0.0) ** 3 for k in knots)])


def _design(u, v):
    rows_u, rows_v = _powers(u, INTERVALS[0]), _powers(v, INTERVALS[1])
    return (rows_u[:, :, None] * rows_v[:, None, :]).reshape(u.size, -1)


def _scattered(rng, bounced):
    """Random spline of the model's own space; `bounced` samples are off by 0.5 to 3 mm, and the bound knows which."""
    # One sample at random in each of 20 x 20 cells: scattered, but without accidental holes.
    u, v = (np.mgrid[0:20, 0:20].reshape(2, -1) + rng.uniform(0.0, 1.0, (2, 400))) / 20.0
    u[:4], v[:4] = [0.0, 0.0, 1.0, 1.0], [0.0, 1.0, 0.0, 1.0]
    coefficients = rng.normal(0.0, 0.3, (INTERVALS[0] + 3) * (INTERVALS[1] + 3))
    design, at = _design(u, v), _design(POINTS_U, POINTS_V)
    error = design @ coefficients + rng.normal(0.0, SIGMA_MM, u.size)
    bad = 4 + rng.choice(u.size - 4, bounced, replace=False)
    error[bad] += rng.uniform(0.5, 3.0, bad.size)
    surface = fit_error_surface(u, v, error, mode="smooth", intervals=INTERVALS, sigma_mm=SIGMA_MM)
    rows = np.linalg.solve(np.linalg.qr(np.delete(design, bad, axis=0))[1].T, at.T).T
    return Trial(
        surface.evaluate(POINTS_U, POINTS_V) - at @ coefficients,
        surface.covariance_at(POINTS_U, POINTS_V),
        SIGMA_MM**2 * rows @ rows.T,
    )


def _interpolated(rng):
    """Seven lines each way span exactly the polynomials and knots of the not-a-knot spline."""
    lines = np.linspace(0.0, 1.0, 7)
    u, v = (axis.ravel() for axis in np.meshgrid(lines, lines, indexing="ij"))
    truth = np.array([0.3, -0.2, 0.5])

    def model(a, b):
        return truth[0] * a**3 + truth[1] * a * b**2 + truth[2] * b

    error = model(u, v) + rng.normal(0.0, SIGMA_MM, u.size)
    surface = fit_error_surface(u, v, error, sigma_mm=SIGMA_MM)
    knots = lines[2:-2]

    def rows(x):
        return np.column_stack([np.ones_like(x), x, x**2, x**3, *(np.maximum(x - k, 0.0) ** 3 for k in knots)])

    inverse = np.linalg.inv(rows(lines))
    side_u, side_v = rows(POINTS_U) @ inverse, rows(POINTS_V) @ inverse
    return Trial(
        surface.evaluate(POINTS_U, POINTS_V) - model(POINTS_U, POINTS_V),
        surface.covariance_at(POINTS_U, POINTS_V),
        SIGMA_MM**2 * (side_u @ side_u.T) * (side_v @ side_v.T),
    )


def cases() -> list[Case]:
    d = POINTS_U.size
    return [
        Case("error surface, regression, 400 scattered", d, lambda rng: _scattered(rng, 0)),
        Case("error surface, regression, 5 % bounced", d, lambda rng: _scattered(rng, 20)),
        Case("error surface, interpolation, 7 x 7", d, _interpolated),
    ]
