"""Geometric least squares of a sphere: one Gauss-Newton step, robust iteration, scale, covariance."""

from __future__ import annotations

from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import NDArray
from scipy.stats import norm

from core.ball.coverage import Cells, contaminated
from core.robust import tukey_weights

Array = NDArray[np.float64]
Mask = NDArray[np.bool_]

# Inliers are cut at this many sigma: 0.7 % of the efficiency is lost, against 3 % at 3 sigma.
CUT = 3.5
# With visible contamination next to the shell a tighter cut costs 11 % of variance and lets less of it in.
TIGHT_CUT = 2.5
# Share of points in the band beside the shell (a clean Gaussian leaves 0.05 % there) that calls for the tight cut.
CONTAMINATED = 0.02
# Points on which the fit settles before the passes over all of them.
_FEW = 30000


@dataclass(frozen=True)
class Sphere:
    """Centre (3,) and radius in mm."""

    center: Array
    radius: float

    def residuals(self, points: Array) -> Array:
        """Signed geometric distance |p - c| - r of points (N, 3), positive outside."""
        offsets = points - self.center
        return np.asarray(np.sqrt(np.einsum("ij,ij->i", offsets, offsets)) - self.radius)


def _rows(sphere: Sphere, points: Array) -> tuple[Array, Array]:
    offsets = points - sphere.center
    distances = np.maximum(np.sqrt(np.einsum("ij,ij->i", offsets, offsets)), 1e-12)
    jacobian = np.empty((len(points), 4))
    jacobian[:, :3] = offsets / -distances[:, None]
    jacobian[:, 3] = -1.0
    return jacobian, distances - sphere.radius


def information(sphere: Sphere, points: Array, *, fixed: bool) -> Array:
    """J^T J of the geometric residuals for (centre, radius), or for the centre alone if the radius is fixed."""
    jacobian, _ = _rows(sphere, points)
    used = jacobian[:, :3] if fixed else jacobian
    return np.asarray(used.T @ used)


def step(sphere: Sphere, points: Array, weights: Array | None, *, fixed: bool) -> Sphere:
    """One Gauss-Newton step on sum w (|p - c| - r)^2; a free radius moves by at most half of itself."""
    jacobian, residuals = _rows(sphere, points)
    used = jacobian[:, :3] if fixed else jacobian
    weighted = used if weights is None else used * weights[:, None]
    normal = weighted.T @ used
    normal += np.eye(len(normal)) * (1e-12 * np.trace(normal) + 1e-300)
    delta = -np.linalg.solve(normal, weighted.T @ residuals)
    longest = np.abs(delta).max()
    delta *= min(1.0, 0.5 * sphere.radius / max(longest, 1e-300))
    return Sphere(sphere.center + delta[:3], sphere.radius if fixed else sphere.radius + float(delta[3]))


def robust(sphere: Sphere, points: Array, threshold: float, *, fixed: bool, iterations: int = 10) -> Sphere:
    """Tukey iterations whose scale anneals from `threshold` (mm) to twice the spread inside of it."""
    current = sphere
    scale = threshold
    for _ in range(iterations):
        residuals = current.residuals(points)
        weights = tukey_weights(residuals, scale, tuning=2.0)
        near = weights > 0.0
        if np.count_nonzero(near) < 5 or not np.isfinite(current.radius) or current.radius <= 0.0:
            return current
        spread = float(np.sqrt(np.average(residuals[near] ** 2, weights=weights[near])))
        scale = min(threshold, max(2.5 * spread, 1e-6 * current.radius))
        current = step(current, points[near], weights[near], fixed=fixed)
    return current


def truncation_factors(cut: float) -> tuple[float, float]:
    """(second moment of a unit Gaussian cut at +-cut, variance of the hard-cut M-estimate relative to the mean's).

    Huber & Ronchetti, Robust Statistics, section 3: V = E[psi^2] / (E[psi'])^2 with psi = x inside the cut; the jumps
    of psi count in psi'.
    """
    inside = float(norm.cdf(cut) - norm.cdf(-cut))
    kept = inside - 2.0 * cut * float(norm.pdf(cut))
    return kept / inside, 1.0 / kept


def scale_beside_background(residuals: Array, sigma: float, cut: float) -> tuple[float, float]:
    """Sigma of the points inside cut * sigma, less a flat background measured in the equally wide band beside it.

    Returns:
        (new sigma, share of points in the band relative to those inside).
    """
    reach = cut * sigma
    size = np.abs(residuals)
    inside = size <= reach
    count = int(np.count_nonzero(inside))
    beside = int(np.count_nonzero((size > reach) & (size <= 2.0 * reach)))
    if count == 0:
        return sigma, 1.0
    background = min(float(beside), 0.7 * count)
    moment = float(np.sum(residuals[inside] ** 2)) - background * reach**2 / 3.0
    # More background than the moment holds: keep a fifth, so that the iteration shrinks instead of stopping.
    moment = max(moment, 0.04 * float(np.sum(residuals[inside] ** 2)))
    second, _ = truncation_factors(cut)
    return float(np.sqrt(moment / (count - background) / second)), beside / count


@dataclass(frozen=True)
class Refined:
    """The sphere after least squares on the inliers of all points."""

    sphere: Sphere
    sigma: float
    inliers: Mask
    cut: float
    iterations: int
    converged: bool


def refine(start: Sphere, points: Array, sigma_start: float, *, fixed: bool, rng: np.random.Generator) -> Refined:
    """Least squares on the inliers; cut and scale follow from the data until centre, radius and scale stand still.

    Edge ghosts and the stem's root sit close to the ball, on one side of it, in few directions: where many points lie
    just beside the surface, the surface's points are left out too, as long as that costs less than half of them.

    Args:
        start: Sphere within a few sigma of the answer.
        points: (N, 3) all points, mm.
        sigma_start: Rough noise in mm.
        fixed: Keep the radius.
        rng: Chooses the points on which the fit settles before it sees all of them.
    """
    gate_width = max(25.0 * sigma_start, 0.02 * start.radius)
    gate = np.flatnonzero(np.abs(start.residuals(points)) < gate_width)
    near = points[gate]
    few = near if len(near) <= _FEW else near[rng.choice(len(near), _FEW, replace=False)]
    result = _settle(start, few, sigma_start, fixed=fixed)
    trusted = np.ones(len(near), dtype=bool)
    iterations = result.iterations
    for _ in range(2):
        cells = _cells(result, few)
        clean = cells.trusted(_directions(result.sphere, few))
        kept = np.count_nonzero(np.abs(result.sphere.residuals(few[clean])) <= result.cut * result.sigma)
        if clean.all() or kept < max(0.5 * np.count_nonzero(result.inliers), 10):
            break
        result = _settle(result.sphere, few[clean], result.sigma, fixed=fixed)
        iterations += result.iterations
        trusted = cells.trusted(_directions(result.sphere, near))
    result = _settle(result.sphere, near[trusted], result.sigma, fixed=fixed)
    inliers = np.zeros(len(points), dtype=bool)
    inliers[gate[trusted][result.inliers]] = True
    return replace(result, inliers=inliers, iterations=iterations + result.iterations)


def _directions(sphere: Sphere, points: Array) -> Array:
    offsets = points - sphere.center
    lengths = np.sqrt(np.einsum("ij,ij->i", offsets, offsets))
    return np.asarray(offsets / np.maximum(lengths, 1e-12)[:, None])


def _cells(result: Refined, near: Array) -> Cells:
    directions = _directions(result.sphere, near)
    size = np.abs(result.sphere.residuals(near))
    inside = size <= result.cut * result.sigma
    seen = directions[inside].sum(axis=0)
    axis = seen / max(float(np.linalg.norm(seen)), 1e-300)
    band = size <= 20.0 * result.sigma
    return contaminated(directions[band], inside[band], axis)


def _settle(start: Sphere, near: Array, sigma_start: float, *, fixed: bool, most: int = 40) -> Refined:
    sphere, sigma, cut = start, sigma_start, CUT
    floor = max(1e-9 * start.radius, 1e-13 * float(np.abs(near).max(initial=0.0)))
    converged = False
    iterations = 0
    inside = np.zeros(len(near), dtype=bool)
    for iterations in range(1, most + 1):
        residuals = sphere.residuals(near)
        new_sigma, beside = scale_beside_background(residuals, sigma, cut)
        sigma_moved = abs(new_sigma - sigma)
        sigma = max(new_sigma, floor)
        # Only ever tightened: a cut that could go back and forth would never settle.
        if iterations > 3 and beside > CONTAMINATED and np.count_nonzero(np.abs(residuals) < cut * sigma) > 200:
            cut = TIGHT_CUT
        inside = np.abs(residuals) <= cut * sigma
        if np.count_nonzero(inside) < 5:
            break
        moved = step(sphere, near[inside], None, fixed=fixed)
        shift = float(np.linalg.norm(moved.center - sphere.center)) + abs(moved.radius - sphere.radius)
        sphere = moved
        if shift < 0.02 * sigma / np.sqrt(len(near)) + floor and sigma_moved < 2e-3 * sigma + floor:
            converged = True
            break
    return Refined(sphere, sigma, inside, cut, iterations, converged)
