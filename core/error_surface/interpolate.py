"""Interpolation of a full grid, with true leave-one-out errors in closed form."""

from __future__ import annotations

from collections.abc import Mapping

import numpy as np
from numpy.typing import NDArray

from core.error_surface.basis import collocation, energies, interpolation_knots
from core.error_surface.region import grid_lines, is_grid
from core.error_surface.surface import ErrorSurface
from core.errors import InputError
from core.robust import mad_sigma
from core.verdict import Code

Array = NDArray[np.float64]
Terms = list[tuple[Array, Array]]

# A sample is called wrong only if it is off by this many robust sigmas and by a distance that matters on a blade.
OUTLIER_SIGMAS = 10.0
OUTLIER_FLOOR_MM = 0.1
USE_SMOOTH = "Measure again there or use smoothing (--smooth), which bridges small gaps and drops bad samples."


def interpolate_grid(
    u: Array, v: Array, error_mm: Array, *, sigma_mm: float | None, reach_steps: float, info: Mapping[str, str]
) -> ErrorSurface:
    """Tensor-product cubic spline through every sample of a full grid; see `fit_error_surface`."""
    lines_u, number_u, lines_v, number_v = _full_grid(u, v, error_mm)
    grid = np.empty((lines_u.size, lines_v.size))
    grid[number_u, number_v] = error_mm
    knots_u, knots_v = interpolation_knots(lines_u), interpolation_knots(lines_v)
    inverse_u = np.asarray(np.linalg.inv(collocation(knots_u, lines_u)), dtype=float)
    inverse_v = np.asarray(np.linalg.inv(collocation(knots_v, lines_v)), dtype=float)
    control = inverse_u @ grid @ inverse_v.T
    terms = bending_terms(lines_u, lines_v, inverse_u, inverse_v)
    pull, own, spread = _pull(terms, grid)
    left_out = pull / own
    _refuse_outliers(left_out, lines_u, lines_v)
    estimated = mad_sigma(pull / np.sqrt(spread), centred=True)
    return ErrorSurface(
        mode="interpolate",
        knots_u=knots_u,
        knots_v=knots_v,
        control_points=control,
        sample_u=u,
        sample_v=v,
        sample_error_mm=error_mm,
        used=np.ones(u.size, dtype=bool),
        leave_one_out_mm=left_out[number_u, number_v],
        residuals_mm=np.zeros(u.size),
        sigma_mm=estimated if sigma_mm is None else sigma_mm,
        sigma_known=sigma_mm is not None,
        penalty=None,
        effective_unknowns=float(u.size),
        reach_steps=reach_steps,
        info=info,
    )


def bending_terms(lines_u: Array, lines_v: Array, inverse_u: Array, inverse_v: Array) -> Terms:
    """The bending energy of the interpolant as a quadratic form in the samples, `sum_k X_k (x) Y_k`.

    Thin-plate energy `int e_ss^2 + 2 e_st^2 + e_tt^2` with s and t in mean grid steps, so that both directions count
    alike. `inverse_*` turn samples on the lines into control points.
    """
    sides = []
    for lines, inverse in ((lines_u, inverse_u), (lines_v, inverse_v)):
        step = float(np.mean(np.diff(lines)))
        mass, slope, bend = energies(interpolation_knots(lines))
        sides.append(
            [inverse.T @ gram @ inverse * scale for gram, scale in ((mass, 1 / step), (slope, step), (bend, step**3))]
        )
    (mass_u, slope_u, bend_u), (mass_v, slope_v, bend_v) = sides
    return [(bend_u, mass_v), (2.0 * slope_u, slope_v), (mass_u, bend_v)]


def _pull(terms: Terms, grid: Array) -> tuple[Array, Array, Array]:
    """Q y, the diagonal of Q and the diagonal of Q^2, each on the grid.

    With one sample k left free, the least energy y^T Q y is at y_k - (Q y)_k / Q_kk: the leave-one-out error of the
    spline of least bending through all the others. White noise sigma gives (Q y)_k the deviation sigma sqrt((Q^2)_kk).
    """
    pull = np.sum([x @ grid @ y for x, y in terms], axis=0)
    own = np.sum([np.outer(np.diag(x), np.diag(y)) for x, y in terms], axis=0)
    spread = np.sum(
        [
            np.outer(np.einsum("ij,ji->i", x1, x2), np.einsum("ij,ji->i", y1, y2))
            for x1, y1 in terms
            for x2, y2 in terms
        ],
        axis=0,
    )
    return np.asarray(pull), np.asarray(own), np.asarray(spread)


def _full_grid(u: Array, v: Array, error_mm: Array) -> tuple[Array, NDArray[np.int64], Array, NDArray[np.int64]]:
    lines_u, number_u = grid_lines(u)
    lines_v, number_v = grid_lines(v)
    if lines_u.size < 4 or lines_v.size < 4:
        raise InputError(
            f"Samples lie on {lines_u.size} lines of u and {lines_v.size} lines of v; a cubic surface needs at least "
            "4 of each. Measure a wider grid.",
            Code.NOT_ENOUGH_VARIATION,
        )
    if not is_grid(u, v):
        raise InputError(
            f"The {u.size} samples are not on a grid ({lines_u.size} different u, {lines_v.size} different v). "
            "Interpolation needs a full grid; use smoothing (--smooth) for scattered samples."
        )
    count = np.zeros((lines_u.size, lines_v.size), dtype=np.int64)
    np.add.at(count, (number_u, number_v), 1)
    if np.any(count > 1):
        i, j = np.argwhere(count > 1)[0]
        twice = error_mm[(number_u == i) & (number_v == j)]
        raise InputError(
            f"The grid node u {lines_u[i]:.6g}, v {lines_v[j]:.6g} was given {count[i, j]} times (errors "
            f"{twice[0]:.4g} and {twice[1]:.4g} mm). Keep one sample per node or use smoothing (--smooth)."
        )
    count[number_u[np.isnan(error_mm)], number_v[np.isnan(error_mm)]] = 0
    gaps = np.argwhere(count == 0)
    if gaps.size:
        named = ", ".join(f"(u {lines_u[i]:.5g}, v {lines_v[j]:.5g})" for i, j in gaps[:3])
        raise InputError(
            f"{len(gaps)} of {count.size} grid nodes have no sample: {named}{' ...' if len(gaps) > 3 else ''}. "
            + USE_SMOOTH,
            Code.LOW_COVERAGE,
        )
    return lines_u, number_u, lines_v, number_v


def _refuse_outliers(left_out: Array, lines_u: Array, lines_v: Array) -> None:
    size = np.abs(left_out)
    limit = max(OUTLIER_SIGMAS * mad_sigma(left_out, centred=True), OUTLIER_FLOOR_MM)
    if size.max() <= limit:
        return
    i, j = np.unravel_index(int(np.argmax(size)), size.shape)
    raise InputError(
        f"The sample at u {lines_u[i]:.5g}, v {lines_v[j]:.5g} is {left_out[i, j]:+.3g} mm off its neighbours "
        f"(limit {limit:.2g} mm; {int(np.sum(size > limit))} samples beyond it, neighbours of bad ones among them). "
        "Interpolation would go through it. " + USE_SMOOTH,
        Code.TOO_MANY_OUTLIERS,
    )
