"""Penalised and plain least-squares splines for scattered, incomplete or partly wrong samples."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from functools import cached_property

import numpy as np
from numpy.typing import NDArray
from scipy.linalg import eigh
from scipy.optimize import minimize
from scipy.sparse import csr_array

from core.error_surface.banded import BandedFactor
from core.error_surface.basis import TensorBasis, clamped_knots, energies
from core.error_surface.region import sample_axes
from core.error_surface.surface import ErrorSurface
from core.errors import FitError
from core.robust import huber_weights, mad_sigma, tukey_weights
from core.verdict import Code

Array = NDArray[np.float64]
Mask = NDArray[np.bool_]

MOST_INTERVALS = 40
REJECT_SIGMAS = 4.5
# Nothing nearer than this to the surface is called a bounce, however quiet the other samples are.
REJECT_FLOOR_MM = 0.02
# Beyond 10^0 the surface is bilinear to within 0.2 % of what the data say, and the equations lose digits.
LOG_PENALTY_RANGE = (-16.0, 0.0)
# Readings are never better than this; without it, noise-free samples would be followed by every control point.
LEAST_NOISE_MM = 5e-4
# Least squares with few knots: just enough penalty to keep knots without samples from being singular.
REGRESSION_LOG_PENALTY = -12.0
UNPENALISED = 4


@dataclass(frozen=True)
class _Problem:
    """Everything about a penalised fit that does not depend on weights and penalties."""

    basis: TensorBasis
    design: csr_array
    error_mm: Array
    sigma_mm: float | None
    penalised: bool

    @cached_property
    def scale(self) -> tuple[float, float]:
        """Penalty weights that make `10^0` comparable with the data: samples per area, unit extents."""
        extent_u = float(np.ptp(self.basis.knots_u))
        extent_v = float(np.ptp(self.basis.knots_v))
        per_area = self.error_mm.size / (extent_u * extent_v)
        return per_area * extent_u**4, per_area * extent_v**4

    @cached_property
    def bends(self) -> tuple[Array, Array]:
        mass_u, _, bend_u = energies(self.basis.knots_u)
        mass_v, _, bend_v = energies(self.basis.knots_v)
        return (
            self.scale[0] * self.basis.product_band(bend_u, mass_v),
            self.scale[1] * self.basis.product_band(mass_u, bend_v),
        )

    @cached_property
    def spectra(self) -> tuple[Array, Array]:
        """Generalised eigenvalues of the bending energies, which diagonalise both penalties together."""
        out = []
        for knots, scale in zip((self.basis.knots_u, self.basis.knots_v), self.scale, strict=True):
            mass, _, bend = energies(knots)
            values = eigh(bend, mass, eigvals_only=True)
            values[:2] = 0.0
            out.append(scale * np.maximum(values, 0.0))
        return out[0], out[1]

    def penalty_log_determinant(self, weights: tuple[float, float]) -> float:
        """Logarithm of the determinant of P over the space that P penalises, up to a constant."""
        spectrum_u, spectrum_v = self.spectra
        joint = weights[0] * spectrum_u[:, None] + weights[1] * spectrum_v[None, :]
        return float(np.sum(np.log(joint.ravel()[np.argsort(joint.ravel())[UNPENALISED:]])))


@dataclass(frozen=True)
class _Solution:
    coefficients: Array
    factor: BandedFactor
    objective: float
    criterion: float


def _solve(problem: _Problem, gram: Array, rhs: Array, square: float, count: float, log: Array) -> _Solution:
    """Penalised least squares and its REML criterion for penalties 10^log (relative to the noise variance).

    Criterion (Wood 2011, Gaussian case): log |B'WB + P| - log |P|+ plus (rss + penalty) / sigma^2 if sigma is known,
    or (n - 4) log(rss + penalty) with sigma profiled out.
    """
    weights = (float(10.0 ** log[0]), float(10.0 ** log[1]))
    factor = BandedFactor.of(gram + weights[0] * problem.bends[0] + weights[1] * problem.bends[1])
    coefficients = factor.solve(rhs)
    # rss + penalty, written so that it needs no second pass over the samples.
    objective = max(square - float(coefficients @ rhs), 0.0) + count * LEAST_NOISE_MM**2
    if problem.sigma_mm is None:
        misfit = (count - UNPENALISED) * np.log(objective)
    else:
        misfit = objective / problem.sigma_mm**2
    criterion = factor.log_determinant() - problem.penalty_log_determinant(weights) + misfit
    return _Solution(coefficients, factor, objective, float(criterion))


def _choose(problem: _Problem, weights: Array, start: Array | None) -> tuple[Array, _Solution]:
    """Penalties of least REML criterion for given sample weights."""
    gram = problem.basis.gram_band(problem.design, weights)
    weighted = weights * problem.error_mm
    rhs = np.asarray(problem.design.T @ weighted)
    square = float(weighted @ problem.error_mm)

    def criterion(log: Array) -> float:
        bounded = np.clip(log, *LOG_PENALTY_RANGE)
        solution = _solve(problem, gram, rhs, square, float(weights.sum()), bounded)
        return solution.criterion + float(np.sum((log - bounded) ** 2))

    if start is None:
        coarse = [np.array([a, b]) for a in (-10.0, -7.0, -4.0) for b in (-10.0, -7.0, -4.0)]
        start = min(coarse, key=criterion)
    simplex = start + np.array([[0.0, 0.0], [1.5, 0.0], [0.0, 1.5]])
    found = minimize(
        criterion,
        start,
        method="Nelder-Mead",
        options={"initial_simplex": simplex, "xatol": 0.05, "fatol": 0.02, "maxfev": 60},
    )
    best = np.clip(found.x, *LOG_PENALTY_RANGE)
    return best, _solve(problem, gram, rhs, square, float(weights.sum()), best)


def _at(problem: _Problem, weights: Array, log: Array) -> _Solution:
    gram = problem.basis.gram_band(problem.design, weights)
    weighted = weights * problem.error_mm
    rhs = np.asarray(problem.design.T @ weighted)
    return _solve(problem, gram, rhs, float(weighted @ problem.error_mm), float(weights.sum()), log)


def _first_weights(problem: _Problem) -> Array:
    """Weights from a stiff surface, which a bounce of several neighbouring samples cannot bend."""
    weights = np.ones(problem.error_mm.size)
    for _ in range(8):
        residuals = problem.error_mm - problem.design @ _at(problem, weights, np.array([-6.0, -6.0])).coefficients
        scale = max(mad_sigma(residuals), REJECT_FLOOR_MM / REJECT_SIGMAS)
        weights = huber_weights(residuals, scale)
    return tukey_weights(residuals, scale, 8.0)


def smooth_samples(
    u: Array,
    v: Array,
    error_mm: Array,
    *,
    sigma_mm: float | None,
    intervals: tuple[int, int] | None,
    penalty: tuple[float, float] | None,
    reject: bool,
    reach_steps: float,
    info: Mapping[str, str],
) -> ErrorSurface:
    """Smoothing or regression spline; see `fit_error_surface`. NaN errors are missing samples."""
    present = np.isfinite(error_mm)
    basis = _basis(u[present], v[present], intervals)
    pu, pv, pe = u[present], v[present], error_mm[present]
    problem = _Problem(basis, basis.design(pu, pv), pe, sigma_mm, intervals is None)
    fixed = _fixed_log_penalty(problem, intervals, penalty)
    used, log, solution = _robust(problem, pu, pv, fixed) if reject else _plain(problem, fixed)
    residuals = pe - problem.design @ solution.coefficients
    hat = np.where(used, basis.quadratic_forms(solution.factor.inverse_band(), pu, pv), 0.0)
    estimated = _noise(problem, residuals[used], float(hat.sum()), solution) if sigma_mm is None else sigma_mm
    scale = problem.scale
    return ErrorSurface(
        mode="smooth" if intervals is None else "regression",
        knots_u=basis.knots_u,
        knots_v=basis.knots_v,
        control_points=basis.grid(solution.coefficients),
        sample_u=u,
        sample_v=v,
        sample_error_mm=error_mm,
        used=_spread(used, present, False).astype(bool),
        leave_one_out_mm=_spread(residuals / np.maximum(1.0 - hat, 1e-9), present, np.nan),
        residuals_mm=_spread(residuals, present, np.nan),
        sigma_mm=estimated,
        sigma_known=sigma_mm is not None,
        penalty=(float(10.0 ** log[0] * scale[0]), float(10.0 ** log[1] * scale[1])),
        effective_unknowns=float(hat.sum()),
        reach_steps=reach_steps,
        info=info,
    )


def _noise(problem: _Problem, residuals: Array, unknowns: float, solution: _Solution) -> float:
    """Noise of one sample, from the residuals (K,) of the samples used.

    With a real penalty it is the REML estimate, which fits together with the penalty into one covariance even where
    the surface follows nearly every sample; a least-squares spline has the usual degrees of freedom.
    """
    count = residuals.size
    if problem.penalised:
        return float(np.sqrt(solution.objective / (count - UNPENALISED)))
    if count - unknowns < 1.0:
        raise FitError(
            f"{count} samples are too few for {unknowns:.0f} unknowns: nothing is left to estimate the noise from. "
            "Use fewer intervals, or state the noise.",
            Code.NOT_ENOUGH_POINTS,
        )
    return float(np.sqrt(np.sum(residuals**2) / (count - unknowns)))


def _fixed_log_penalty(
    problem: _Problem, intervals: tuple[int, int] | None, penalty: tuple[float, float] | None
) -> Array | None:
    if penalty is not None:
        return np.asarray(np.log10(np.asarray(penalty) / np.asarray(problem.scale)))
    return None if intervals is None else np.full(2, REGRESSION_LOG_PENALTY)


def _plain(problem: _Problem, fixed: Array | None) -> tuple[Mask, Array, _Solution]:
    weights = np.ones(problem.error_mm.size)
    if fixed is not None:
        return weights > 0.0, fixed, _at(problem, weights, fixed)
    log, solution = _choose(problem, weights, None)
    return weights > 0.0, log, solution


def _robust(problem: _Problem, u: Array, v: Array, fixed: Array | None) -> tuple[Mask, Array, _Solution]:
    """Tukey weights first, then hard rejection, so that the final fit and its covariance are least squares."""
    weights = _first_weights(problem)
    log = fixed
    for _ in range(2):
        log, solution = _choose(problem, weights, log) if fixed is None else (fixed, _at(problem, weights, fixed))
        residuals = problem.error_mm - problem.design @ solution.coefficients
        weights = tukey_weights(residuals, max(mad_sigma(residuals), REJECT_FLOOR_MM / REJECT_SIGMAS), 6.0)
    used = np.asarray(weights > 0.0)
    for _ in range(6):
        ones = used.astype(float)
        log, solution = _choose(problem, ones, log) if fixed is None else (fixed, _at(problem, ones, fixed))
        kept = _acceptable(problem, u, v, used, solution)
        if np.array_equal(kept, used):
            return used, np.asarray(log), solution
        used = kept
    raise FitError(
        "The set of rejected samples does not settle: good and bad samples cannot be told apart. "
        "Measure the airfoil again.",
        Code.NOT_CONVERGED,
    )


def _acceptable(problem: _Problem, u: Array, v: Array, used: Mask, solution: _Solution) -> Mask:
    """Samples whose distance to the surface fits the noise and the surface's own uncertainty there."""
    residuals = problem.error_mm - problem.design @ solution.coefficients
    hat = problem.basis.quadratic_forms(solution.factor.inverse_band(), u, v)
    if problem.sigma_mm is None:
        sigma = _noise(problem, residuals[used], float(hat[used].sum()), solution)
    else:
        sigma = max(problem.sigma_mm, mad_sigma(residuals[used], centred=True))
    spread = sigma * np.sqrt(np.where(used, np.maximum(1.0 - hat, 1e-6), 1.0 + hat))
    return np.asarray(np.abs(residuals) <= np.maximum(REJECT_SIGMAS * spread, REJECT_FLOOR_MM))


def _basis(u: Array, v: Array, intervals: tuple[int, int] | None) -> TensorBasis:
    knots = []
    for axis, (lines, places) in enumerate(sample_axes(u, v)):
        if intervals is not None:
            breaks = np.linspace(lines[0], lines[-1], intervals[axis] + 1)
        else:
            # Between two ends alone, as many intervals as spacings; on lines, one between neighbours.
            count = int(places[-1]) if lines.size == 2 else lines.size - 1
            count = max(min(count, MOST_INTERVALS), 1)
            breaks = np.interp(np.linspace(0.0, 1.0, count + 1), np.linspace(0.0, 1.0, lines.size), lines)
        knots.append(clamped_knots(breaks))
    return TensorBasis(knots[0], knots[1])


def _spread(values: Array | Mask, present: Mask, missing: float | bool) -> Array:
    out = np.full(present.size, missing, dtype=float)
    out[present] = values
    return out
