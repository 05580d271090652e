"""The ball's centre and diameter from one scan: robust geometric sphere fit (docs/steps/ball.md)."""

from __future__ import annotations

from dataclasses import dataclass
from itertools import islice

import numpy as np
from numpy.typing import ArrayLike, NDArray

from core.ball.coverage import coverage
from core.ball.sphere_refine import Refined, Sphere, information, refine, step, truncation_factors
from core.ball.sphere_search import Candidate, RadiusRange, ball_candidates, shaped_like_a_ball, stands_out
from core.errors import FitError, InputError
from core.robust import mad_sigma
from core.verdict import Code

Array = NDArray[np.float64]
Mask = NDArray[np.bool_]

MIN_POINTS = 10
MIN_INLIERS = 10
# Without a named diameter there are many more spheres to be mistaken for the ball.
MIN_INLIERS_UNNAMED = 20
MIN_SHARE_UNNAMED = 0.01
# Balls that are looked for when no diameter is named.
SMALLEST_DIAMETER_MM = 2.0
LARGEST_DIAMETER_MM = 300.0
# A free diameter must lie this near to the one named as a hint.
HINT_TOLERANCE = 0.2
# Beyond this relative sigma a free diameter is not determined.
LARGEST_RELATIVE_SIGMA = 0.1
# A scanner noisier than this measures no ball.
NOISIEST_MM = 0.4
_SEARCH_POINTS = 5000
_MOST_CANDIDATES = 25
# Enough points for the figures that only check the fit.
_CHECK_POINTS = 20000


@dataclass(frozen=True)
class SphereFit:
    """A ball found in a scan; lengths in mm, in the frame of the scan.

    Attributes:
        center_mm: (3,) centre.
        diameter_mm: Diameter, fitted or the fixed one.
        diameter_sigma_mm: Standard deviation of the diameter; 0 if it was fixed.
        sigma_mm: Noise of the inliers along the radius, estimated from the residuals.
        sphericity_mm: Range (largest minus smallest) of the inliers' radial residuals.
        rms_mm: RMS of the inliers' radial residuals.
        inliers: (N,) bool, points used in the final least squares.
        covariance_mm2: (3, 3) covariance of the centre.
        center_diameter_covariance_mm2: (4, 4) covariance of centre and diameter; last row zero if it was fixed.
        coverage: Share (0 to 1) of the sphere's surface that inliers cover.
        iterations: Gauss-Newton steps of the final fit.
        converged: False if the final fit was still moving.
        expected_diameter_mm: The diameter that the caller named, None if none.
        diameter_fixed: True if the named diameter was kept.
        free_diameter_mm: Diameter of the same inliers when it is fitted (equal to `diameter_mm` if it was free).
        free_diameter_sigma_mm: Its standard deviation.
        held_out_mm: Largest distance between the centres of two opposite halves of the inliers, radius held.
        held_out_sigma_mm: Standard deviation of that distance from noise alone (along its weakest direction).
    """

    center_mm: Array
    diameter_mm: float
    diameter_sigma_mm: float
    sigma_mm: float
    sphericity_mm: float
    rms_mm: float
    inliers: Mask
    covariance_mm2: Array
    center_diameter_covariance_mm2: Array
    coverage: float
    iterations: int
    converged: bool
    expected_diameter_mm: float | None
    diameter_fixed: bool
    free_diameter_mm: float
    free_diameter_sigma_mm: float
    held_out_mm: float
    held_out_sigma_mm: float

    @property
    def inlier_share(self) -> float:
        """Share of all points that were used."""
        return float(np.mean(self.inliers))


def fit_sphere(
    points_mm: ArrayLike,
    *,
    diameter_mm: float | None = None,
    fix_diameter: bool = False,
    sigma_mm: float | None = None,
    seed: int = 0,
) -> SphereFit:
    """Find the ball in a scan and fit it by geometric least squares on its inliers.

    Args:
        points_mm: (N, 3) points of one scan, mm, any frame; fixture, stem and ghosts may be the majority.
        diameter_mm: Expected diameter. Alone it is a hint within 20 %; with `fix_diameter` it is kept.
        fix_diameter: Keep `diameter_mm` (the certified one).
        sigma_mm: Known noise along the radius; scales the covariance in place of the estimated one.
        seed: Of the random samples; the same input and seed give the same result.

    Raises:
        InputError: shape, NaN, unit or diameter unusable; too few points.
        FitError: the points have no extent in space, hold no ball, or show too small a cap for a free diameter.
    """
    points = _checked_points(points_mm)
    _check_options(diameter_mm, fix_diameter, sigma_mm)
    middle = np.median(points, axis=0)
    local = points - middle
    _check_extent(local, diameter_mm)
    rng = np.random.default_rng(seed)
    some = local if len(local) <= _SEARCH_POINTS else local[rng.choice(len(local), _SEARCH_POINTS, replace=False)]
    _check_shape(some)
    radii = _radius_range(diameter_mm, fix_diameter)
    for candidate in islice(ball_candidates(some, radii, rng), _MOST_CANDIDATES):
        refined = _refined(local, some, candidate, rng, radii)
        if refined is not None:
            return _result(local, middle, refined, diameter_mm, fix_diameter, sigma_mm, rng)
    raise FitError(_not_found(some, radii, rng), Code.NOT_ENOUGH_VARIATION)


def _checked_points(points_mm: ArrayLike) -> Array:
    try:
        points = np.asarray(points_mm, dtype=float)
    except (TypeError, ValueError) as error:
        raise InputError("Scan of the ball: expected points as rows of three numbers.") from error
    if points.ndim != 2 or points.shape[1] != 3:
        raise InputError(f"Scan of the ball: expected points of shape (N, 3), found {points.shape}.")
    bad = int(np.count_nonzero(~np.isfinite(points).all(axis=1)))
    if bad:
        raise InputError(
            f"Scan of the ball: {bad} of {len(points)} points are NaN or infinite. Drop points without a measurement."
        )
    if len(points) < MIN_POINTS:
        raise InputError(
            f"Scan of the ball: found {len(points)} points, at least {MIN_POINTS} are needed. Scan the ball again.",
            Code.NOT_ENOUGH_POINTS,
        )
    return points


def _check_options(diameter_mm: float | None, fix_diameter: bool, sigma_mm: float | None) -> None:
    if diameter_mm is not None and not (np.isfinite(diameter_mm) and diameter_mm > 0.0):
        raise InputError(f"Ball diameter: expected a positive number of mm, found {diameter_mm:g}.")
    if fix_diameter and diameter_mm is None:
        raise InputError("The diameter cannot be fixed without its value: name the certified diameter in mm.")
    if sigma_mm is not None and not (np.isfinite(sigma_mm) and sigma_mm > 0.0):
        raise InputError(f"Scanner noise: expected a positive sigma in mm, found {sigma_mm:g}.")


def _check_extent(local: Array, diameter_mm: float | None) -> None:
    low, high = local.min(axis=0), local.max(axis=0)
    extent = float(np.linalg.norm(high - low))
    if extent <= 1e-9 * max(1.0, float(np.abs(local).max())):
        raise FitError(
            "Scan of the ball: all points coincide. Check the scan file; one that holds a surface is needed.",
            Code.NOT_ENOUGH_VARIATION,
        )
    least = 1.0 if diameter_mm is None else 0.05 * diameter_mm
    if extent < least:
        raise InputError(
            f"Scan of the ball: the whole cloud is only {extent:.3g} wide where mm are expected. It looks like metres: "
            "multiply by 1000 or export in mm."
        )


def _check_shape(some: Array) -> None:
    values = np.linalg.svd(some - some.mean(axis=0), compute_uv=False)
    if values[1] < 1e-4 * values[0]:
        raise FitError(
            "Scan of the ball: the points lie on one line, no ball can be found. Scan an area of the ball.",
            Code.NOT_ENOUGH_VARIATION,
        )
    if values[2] < 1e-5 * values[1]:
        raise FitError(
            "Scan of the ball: the points lie in one plane, no ball can be found. Aim the scanner at the ball.",
            Code.NOT_ENOUGH_VARIATION,
        )


def _radius_range(diameter_mm: float | None, fixed: bool) -> RadiusRange:
    if diameter_mm is None:
        return RadiusRange(0.5 * SMALLEST_DIAMETER_MM, 0.5 * LARGEST_DIAMETER_MM, None, False)
    radius = 0.5 * diameter_mm
    return RadiusRange(radius * (1.0 - HINT_TOLERANCE), radius * (1.0 + HINT_TOLERANCE), radius, fixed)


def _not_found(some: Array, radii: RadiusRange, rng: np.random.Generator) -> str:
    if radii.expected is None:
        return (
            f"No ball of {SMALLEST_DIAMETER_MM:g} to {LARGEST_DIAMETER_MM:g} mm diameter was found in the scan ("
            "planes, cylinders and scattered points do not count, nor a cap too flat to tell from a plane). Aim at the "
            "ball, or give its certified diameter with --diameter and --fix-diameter."
        )
    wanted = f"No ball of diameter {2.0 * radii.expected:.4g} mm was found in the scan"
    unnamed = _radius_range(None, False)
    others = (
        _refined(some, some, candidate, rng, unnamed)
        for candidate in islice(ball_candidates(some, unnamed, rng), _MOST_CANDIDATES)
    )
    other = next((refined for refined in others if refined is not None), None)
    if other is None:
        return f"{wanted}. Aim the scanner at the ball and see that nothing hides it."
    found = 2.0 * other.sphere.radius
    halved = " Was the radius given instead of the diameter?" if 0.8 < found / (4.0 * radii.expected) < 1.2 else ""
    return f"{wanted}, but one of about {found:.4g} mm is there. Check the diameter.{halved}"


def _refined(
    local: Array, some: Array, candidate: Candidate, rng: np.random.Generator, radii: RadiusRange
) -> Refined | None:
    """The candidate fitted to all points; None if that leads away from it or leaves too little of a ball."""
    start, fixed = candidate.sphere, radii.fixed
    residuals = start.residuals(some)
    inside = np.abs(residuals) <= candidate.threshold
    sigma = max(mad_sigma(residuals[inside], centred=True), 1e-9 * start.radius)
    settled = refine(start, some, sigma, fixed=fixed, rng=rng)
    # A fit that shrinks onto a coincidence keeps few of the candidate's points and does not settle.
    count = int(np.count_nonzero(settled.inliers))
    least = MIN_INLIERS if radii.expected is not None else max(MIN_INLIERS_UNNAMED, MIN_SHARE_UNNAMED * len(some))
    if not settled.converged or count < max(least, 0.4 * np.count_nonzero(inside)):
        return None
    if settled.sigma > min(0.05 * start.radius, NOISIEST_MM):
        return None
    sphere = settled.sphere
    shift = float(np.linalg.norm(sphere.center - start.center))
    if shift > 0.3 * start.radius or not radii.low <= sphere.radius <= radii.high:
        return None
    width = max(2.5 * settled.sigma, 1e-6 * start.radius)
    if not stands_out(some, Candidate(sphere, width, 0.0), rng, fixed=fixed):
        return None
    if not shaped_like_a_ball(sphere, some[settled.inliers], width, fixed=fixed):
        return None
    return settled if some is local else refine(sphere, local, settled.sigma, fixed=fixed, rng=rng)


def _result(
    local: Array,
    middle: Array,
    refined: Refined,
    expected_mm: float | None,
    fixed: bool,
    sigma_mm: float | None,
    rng: np.random.Generator,
) -> SphereFit:
    sphere = refined.sphere
    on_ball = local[refined.inliers]
    residuals = sphere.residuals(on_ball)
    unknowns = 3 if fixed else 4
    second, lost = truncation_factors(refined.cut)
    squares = float(residuals @ residuals)
    estimated = float(np.sqrt(squares / (len(on_ball) - unknowns) / second))
    variance = (estimated if sigma_mm is None else sigma_mm) ** 2 * lost
    covariance = np.zeros((4, 4))
    covariance[:unknowns, :unknowns] = variance * np.linalg.inv(information(sphere, on_ball, fixed=fixed))
    to_diameter = np.diag([1.0, 1.0, 1.0, 2.0])
    covariance = to_diameter @ covariance @ to_diameter
    checked = on_ball if len(on_ball) <= _CHECK_POINTS else on_ball[rng.choice(len(on_ball), _CHECK_POINTS, False)]
    free_diameter, free_sigma = 2.0 * sphere.radius, float(np.sqrt(covariance[3, 3]))
    if fixed:
        free_diameter, free_sigma = _freed(sphere, checked, variance)
    elif free_sigma > LARGEST_RELATIVE_SIGMA * free_diameter:
        raise FitError(
            f"The cap seen is too small to determine the ball's diameter ({free_diameter:.4g} mm with a sigma of "
            f"{free_sigma:.2g} mm). Scan more of the ball, or give its certified diameter with --diameter and "
            "--fix-diameter.",
            Code.HIGH_UNCERTAINTY,
        )
    held_out, held_out_sigma = _halves(sphere, checked, variance)
    return SphereFit(
        center_mm=sphere.center + middle,
        diameter_mm=2.0 * sphere.radius,
        diameter_sigma_mm=float(np.sqrt(covariance[3, 3])),
        sigma_mm=estimated,
        sphericity_mm=float(residuals.max() - residuals.min()),
        rms_mm=float(np.sqrt(np.mean(residuals**2))),
        inliers=refined.inliers,
        covariance_mm2=covariance[:3, :3],
        center_diameter_covariance_mm2=covariance,
        coverage=coverage((on_ball - sphere.center) / (residuals + sphere.radius)[:, None], rng),
        iterations=refined.iterations,
        converged=refined.converged,
        expected_diameter_mm=expected_mm,
        diameter_fixed=fixed,
        free_diameter_mm=free_diameter,
        free_diameter_sigma_mm=free_sigma,
        held_out_mm=held_out,
        held_out_sigma_mm=held_out_sigma,
    )


def _freed(sphere: Sphere, on_ball: Array, variance: float) -> tuple[float, float]:
    """Diameter and its sigma when the radius of the inliers is let go."""
    free = sphere
    for _ in range(10):
        free = step(free, on_ball, None, fixed=False)
    inverse = np.linalg.pinv(information(free, on_ball, fixed=False), rcond=1e-13)
    return 2.0 * free.radius, 2.0 * float(np.sqrt(variance * inverse[3, 3]))


def _halves(sphere: Sphere, on_ball: Array, variance: float) -> tuple[float, float]:
    """Largest distance between the centres of opposite halves of the cap, cut two ways, and its sigma from noise."""
    offsets = on_ball - sphere.center
    _, _, axes = np.linalg.svd(offsets.mean(axis=0)[None, :])
    largest, sigma = 0.0, 0.0
    for direction in axes[1:]:
        side = offsets @ direction
        high = side > np.median(side)
        fits, spread = [], np.zeros((3, 3))
        for half in (on_ball[high], on_ball[~high]):
            fitted = sphere
            for _ in range(5):
                fitted = step(fitted, half, None, fixed=True)
            fits.append(fitted.center)
            spread += variance * np.linalg.pinv(information(fitted, half, fixed=True), rcond=1e-13)
        largest = max(largest, float(np.linalg.norm(fits[0] - fits[1])))
        sigma = max(sigma, float(np.sqrt(np.linalg.eigvalsh(spread)[-1])))
    return largest, sigma
