"""Find the ball among fixture planes, stem and clutter: local random samples, band-contrast score, shape checks."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray
from scipy.special import gammaln
from scipy.stats import binom
from scipy.stats import f as f_distribution

from core.ball.sphere_refine import Sphere, information, robust

Array = NDArray[np.float64]

# Half-widths of the shell relative to the radius, tried for every hypothesis.
_THRESHOLDS = 0.0005 * 3.0 ** (0.5 * np.arange(10))
# A scanner whose noise fills a wider shell measures no ball.
_WIDEST_MM = 1.0
_SAMPLE_SIZES = (4, 6, 12, 30)
_SEEDS = 240
_SCORE_POINTS = 2000
_FINALISTS = 30
_CONTRAST_BY_LUCK = 1e-4
_RADIUS_BINS = 5
# Thresholds tried, divided by the accepted number of false alarms.
_LOG_ALARMS = float(np.log(10.0 / 0.1))
# Points inside the shell for each point beside it, up to three half-widths: a plane that touches the shell gives 1,
# even clutter 0.5.
_LEAST_CONTRAST = 1.5


@dataclass(frozen=True)
class Candidate:
    """A sphere, the half-width of its shell (mm), and its support."""

    sphere: Sphere
    threshold: float
    score: float


@dataclass(frozen=True)
class RadiusRange:
    """Radii in mm that may be found; `expected` if the caller named one, `fixed` if it must be exactly that."""

    low: float
    high: float
    expected: float | None
    fixed: bool


def ball_candidates(points: Array, radii: RadiusRange, rng: np.random.Generator) -> Iterator[Candidate]:
    """Spheres among points (n, 3), a few thousand at most, that stand out, the best supported first.

    Their shape is not checked yet, see `shaped_like_a_ball`.
    """
    hypotheses = _hypotheses(points, radii, rng)
    if not hypotheses:
        return
    centers = np.array([sphere.center for sphere in hypotheses])
    radius = np.array([sphere.radius for sphere in hypotheses])
    some = points if len(points) <= _SCORE_POINTS else points[rng.choice(len(points), _SCORE_POINTS, replace=False)]
    scores = _band_scores(some, centers, radius)
    best_level = np.argmax(scores, axis=1)
    order = np.argsort(-scores[np.arange(len(scores)), best_level])
    finalists = _finalists(order, centers, radius, best_level, radii)
    polished = (_polished(some, hypotheses[index], radii) for index in finalists)
    found = sorted((candidate for candidate in polished if candidate), key=lambda candidate: -candidate.score)
    tried: list[Candidate] = []
    for candidate in found:
        if any(_same(candidate, other) for other in tried):
            continue
        tried.append(candidate)
        if stands_out(points, candidate, rng, fixed=radii.fixed):
            yield candidate


def _same(one: Candidate, other: Candidate) -> bool:
    near = 0.1 * min(one.threshold, other.threshold)
    shift = float(np.linalg.norm(one.sphere.center - other.sphere.center))
    return shift < near and abs(one.sphere.radius - other.sphere.radius) < near


def _finalists(
    order: NDArray[np.intp], centers: Array, radius: Array, level: NDArray[np.intp], radii: RadiusRange
) -> list[int]:
    """The first few of `order`, distinct, from every range of radii: else huge spheres along planes fill the list."""
    bins = _RADIUS_BINS if radii.expected is None else 1
    edges = np.geomspace(radii.low, radii.high, bins + 1)[1:-1]
    belongs = np.searchsorted(edges, radius)
    result: list[int] = []
    for number in range(bins):
        result += _distinct(order[belongs[order] == number], centers, radius, level, _FINALISTS // bins)
    return result


def _distinct(order: NDArray[np.intp], centers: Array, radius: Array, level: NDArray[np.intp], most: int) -> list[int]:
    chosen: list[int] = []
    for index in order[: 20 * most]:
        width = _THRESHOLDS[level[index]] * radius[index]
        same = (
            np.linalg.norm(centers[index] - centers[other]) < width and abs(radius[index] - radius[other]) < width
            for other in chosen
        )
        if not any(same):
            chosen.append(int(index))
        if len(chosen) == most:
            break
    return chosen


def _hypotheses(points: Array, radii: RadiusRange, rng: np.random.Generator) -> list[Sphere]:
    """Spheres through random samples of the k nearest neighbours of random points, k from 8 to all."""
    count = len(points)
    seeds = rng.choice(count, min(count, _SEEDS), replace=False)
    seeds = np.resize(seeds, _SEEDS)
    squared = np.sum((points[seeds][:, None, :] - points[None, :, :]) ** 2, axis=2, dtype=np.float32)
    near_first = np.argsort(squared, axis=1)
    if radii.expected is not None:
        # No pair of points on the ball is farther apart than its diameter.
        reach = np.maximum(np.sum(squared < (2.1 * radii.expected) ** 2, axis=1), 8)
    else:
        reach = np.full(len(seeds), count)
    result: list[Sphere] = []
    levels = np.unique(np.geomspace(min(8, count), count, 9).astype(int))
    for level in levels:
        for size in _SAMPLE_SIZES:
            if size > level:
                continue
            limit = np.minimum(level, np.minimum(reach, count))
            picks = (rng.random((len(seeds), size)) * limit[:, None]).astype(int)
            samples = points[np.take_along_axis(near_first, picks, axis=1)]
            result += _spheres_through(samples, radii)
    return result


def _spheres_through(samples: Array, radii: RadiusRange) -> list[Sphere]:
    """Algebraic spheres (Kasa's linear equation) through samples (m, k, 3); only a start, it is biased on caps."""
    middle = samples.mean(axis=1, keepdims=True)
    local = samples - middle
    spread = np.sqrt(np.mean(np.sum(local**2, axis=2), axis=1))
    good = spread > 0.0
    local, middle, spread = local[good] / spread[good, None, None], middle[good, 0], spread[good]
    rows = np.concatenate([2.0 * local, np.ones((*local.shape[:2], 1))], axis=2)
    normal = np.swapaxes(rows, 1, 2) @ rows
    normal += 1e-12 * np.eye(4)
    right = np.swapaxes(rows, 1, 2) @ np.sum(local**2, axis=2)[..., None]
    solution = np.linalg.solve(normal, right)[..., 0]
    radius = np.sqrt(np.maximum(solution[:, 3] + np.sum(solution[:, :3] ** 2, axis=1), 0.0)) * spread
    offset = solution[:, :3] * spread[:, None]
    if radii.expected is None:
        keep = (radius >= radii.low) & (radius <= radii.high)
        return [Sphere(c, float(r)) for c, r in zip((middle + offset)[keep], radius[keep], strict=True)]
    # The radius is known (nearly): keep the side on which the centre lies, correct the distance to it.
    length = np.linalg.norm(offset, axis=1)
    keep = (length > 1e-9 * spread) & (spread < radii.expected)
    depth = np.sqrt(np.maximum(radii.expected**2 - spread[keep] ** 2, 0.0))
    centers = middle[keep] + offset[keep] / length[keep, None] * depth[:, None]
    return [Sphere(c, radii.expected) for c in centers]


def _band_scores(points: Array, centers: Array, radius: Array) -> Array:
    """(m, thresholds): points within each half-width minus points from there to three half-widths (both sides).

    The difference peaks at the width of the noise; at any half-width it vanishes for planes (the area of a plane
    inside a tangent shell grows in proportion to the depth) and is negative for even clutter.
    """
    scores = np.empty((len(centers), len(_THRESHOLDS)))
    edges = np.concatenate([_THRESHOLDS, 3.0 * _THRESHOLDS[-2:]])
    small = points.astype(np.float32)
    for first in range(0, len(centers), 256):
        part = slice(first, first + 256)
        c = centers[part].astype(np.float32)
        squared = (small**2).sum(axis=1)[None, :] - 2.0 * c @ small.T + (c**2).sum(axis=1)[:, None]
        relative = np.abs(np.sqrt(np.maximum(squared, 0.0)) / radius[part, None].astype(np.float32) - 1.0)
        within = np.stack([np.count_nonzero(relative < edge, axis=1) for edge in edges], axis=1)
        inside, beyond = within[:, :-2], within[:, 2:]
        # Wider shells hold more by chance: a small price per level makes the tightest sufficient one win.
        contrast = (2.0 * inside - beyond) * (1.0 - 0.02 * np.arange(len(_THRESHOLDS)))
        wide = _THRESHOLDS * radius[part, None] > _WIDEST_MM
        scores[part] = np.where(wide, -np.inf, contrast)
    return scores


def _polished(points: Array, start: Sphere, radii: RadiusRange) -> Candidate | None:
    """The hypothesis after robust geometric iterations from wide to narrow shells; None if it leaves the range."""
    best: Candidate | None = None
    for level in (8, 4):
        threshold = float(_THRESHOLDS[level]) * start.radius
        near = points[np.abs(start.residuals(points)) < 3.0 * threshold]
        if len(near) < 8:
            continue
        fitted = robust(start, near, threshold, fixed=radii.fixed, iterations=6)
        if not np.isfinite(fitted.radius) or not 0.99 * radii.low <= fitted.radius <= 1.01 * radii.high:
            continue
        score = _band_scores(points, fitted.center[None], np.array([fitted.radius]))[0]
        width = int(np.argmax(score))
        if best is None or score[width] > best.score:
            best = Candidate(fitted, float(_THRESHOLDS[width]) * fitted.radius, float(score[width]))
    return best if best is None or np.isfinite(best.score) else None


def stands_out(points: Array, candidate: Candidate, rng: np.random.Generator, *, fixed: bool) -> bool:
    """True if the shell is better filled than its neighbourhood and than chance would fill it."""
    size = np.abs(candidate.sphere.residuals(points))
    count = int(np.count_nonzero(size <= candidate.threshold))
    beside = int(np.count_nonzero(size <= 3.0 * candidate.threshold)) - count
    if count < 10 or count < _LEAST_CONTRAST * beside:
        return False
    # A handful of points on planes and stems can show that contrast by luck: half of them inside is what those give.
    if binom.sf(count - 1, count + beside, 0.5) > _CONTRAST_BY_LUCK:
        return False
    return _better_than_chance(points, candidate.sphere, candidate.threshold, count, rng, fixed=fixed)


def shaped_like_a_ball(sphere: Sphere, on_ball: Array, width: float, *, fixed: bool) -> bool:
    """True if the points on the surface are curved, alike in all directions, with the sphere's radius."""
    return not curved_unequally(sphere, on_ball) and curvature_is_seen(sphere, on_ball, width, fixed=fixed)


def _better_than_chance(
    points: Array, sphere: Sphere, width: float, count: int, rng: np.random.Generator, *, fixed: bool
) -> bool:
    """A-contrario test (Moisan & Stival 2004): would points strewn evenly over the cloud's box fill the shell so?"""
    middle = points.mean(axis=0)
    _, _, axes = np.linalg.svd(points - middle, full_matrices=False)
    local = (points - middle) @ axes.T
    low, high = local.min(axis=0), local.max(axis=0)
    strewn = rng.uniform(low, high, (20000, 3)) @ axes + middle
    share = max(float(np.mean(np.abs(sphere.residuals(strewn)) <= width)), 1.0 / 20000)
    # Every choice of four points (three for a known radius) is a hypothesis, and they lie on it by construction.
    total, chosen = len(points), 3 if fixed else 4
    log_choices = float(gammaln(total + 1) - gammaln(chosen + 1) - gammaln(total - chosen + 1))
    return bool(float(binom.logsf(count - chosen - 1, total - chosen, share)) + log_choices + _LOG_ALARMS < 0.0)


def curved_unequally(sphere: Sphere, points: Array) -> bool:
    """True if terms of second order in the direction explain the residuals: a cylinder, a saddle, a wrong radius."""
    residuals = sphere.residuals(points)
    # A quarter of a million points prove no more than ten thousand.
    every = max(1, len(points) // 10000)
    residuals, points = residuals[::every], points[::every]
    # Unit directions: scaled offsets would carry the residual itself into the columns.
    x, y, z = ((points - sphere.center) / (residuals + sphere.radius)[:, None]).T
    columns = np.column_stack([np.ones_like(x), x, y, z, x * y, y * z, z * x, x * x - z * z, y * y - z * z])
    fitted, *_ = np.linalg.lstsq(columns, residuals, rcond=1e-10)
    left = residuals - columns @ fitted
    free = len(points) - columns.shape[1]
    before, after = float(residuals @ residuals), float(left @ left)
    if free <= 0 or before < (1e-9 * sphere.radius) ** 2 * len(points):
        return False
    ratio = (before - after) / 5.0 / max(after / free, 1e-300)
    share = 1.0 - (after / free) / (before / len(points))
    return bool(share > 0.35 and ratio > float(f_distribution.isf(1e-4, 5, free)))


def curvature_is_seen(sphere: Sphere, points: Array, width: float, *, fixed: bool) -> bool:
    """True if the points, freed of the given radius, are curved like the sphere and distinctly not flat.

    The test uses the curvature k = 1 / r: its estimate is near normal where that of r is not.
    """
    free = robust(sphere, points, max(3.0 * width, 1e-6 * sphere.radius), fixed=False)
    if not np.isfinite(free.radius) or free.radius <= 0.0:
        return False
    residuals = free.residuals(points)
    noise = float(np.sqrt(residuals @ residuals / max(len(points) - 4, 1)))
    covariance = np.linalg.pinv(information(free, points, fixed=False), rcond=1e-13)
    sigma_curvature = noise * float(np.sqrt(covariance[3, 3])) / free.radius**2
    curvature = 1.0 / free.radius
    if curvature < 6.0 * sigma_curvature:
        return False
    if not fixed:
        return True
    return bool(abs(curvature * sphere.radius - 1.0) < max(5.0 * sigma_curvature * sphere.radius, 0.05))
