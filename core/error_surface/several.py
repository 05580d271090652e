"""Several surfaces: their average with its spread, and whether an old one still fits new samples."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike, NDArray

from core.error_surface.fit import fit_error_surface
from core.error_surface.region import grid_lines, is_grid
from core.error_surface.surface import ErrorSurface
from core.errors import InputError
from core.verdict import Code

Array = NDArray[np.float64]
FEWEST_COMMON = 16
NODES = 40


@dataclass(frozen=True)
class SurfaceAverage:
    """Mean of several surfaces.

    Attributes:
        mean: The mean as a surface of its own, valid where every surface is.
        u: (N,) nodes at which the surfaces were compared.
        v: (N,).
        spread_mm: (N,) standard deviation between the surfaces at the nodes.
        offset_mm: (K,) mean of each surface minus the common mean: which blade stands apart.
        count: Number of surfaces K.
    """

    mean: ErrorSurface
    u: Array
    v: Array
    spread_mm: Array
    offset_mm: Array
    count: int

    @property
    def spread_rms_mm(self) -> float:
        """RMS over the nodes of the spread between the surfaces."""
        return float(np.sqrt(np.mean(self.spread_mm**2)))


def average_surfaces(surfaces: Sequence[ErrorSurface]) -> SurfaceAverage:
    """Average surfaces of several blades of one type on one tool.

    The nodes are the grid lines of the first surface (or a grid of 40 x 40 over its bounds if its samples are
    scattered); nodes that one of the surfaces did not measure are left out.

    Raises:
        InputError: fewer than two surfaces, different blade types, or no patch that all of them measured.
    """
    if len(surfaces) < 2:
        raise InputError(f"An average needs at least two error surfaces, found {len(surfaces)}.")
    types = {surface.info["blade_type"] for surface in surfaces if "blade_type" in surface.info}
    if len(types) > 1:
        raise InputError(f"The surfaces belong to different blade types ({', '.join(sorted(types))}).")
    u, v = _nodes(surfaces[0])
    errors = np.array([surface.evaluate(u, v) for surface in surfaces])
    common = np.all(np.isfinite(errors), axis=0)
    if common.sum() < FEWEST_COMMON:
        raise InputError("The surfaces have no measured patch in common.", Code.LOW_COVERAGE)
    u, v, errors = u[common], v[common], errors[:, common]
    mean = errors.mean(axis=0)
    fitted = fit_error_surface(
        u,
        v,
        mean,
        mode="interpolate" if common.all() else "smooth",
        reject=False,
        reach_steps=min(surface.reach_steps for surface in surfaces),
        info={**surfaces[0].info, "average_of": str(len(surfaces))},
    )
    return SurfaceAverage(fitted, u, v, errors.std(axis=0, ddof=1), (errors - mean).mean(axis=1), len(surfaces))


def _nodes(surface: ErrorSurface) -> tuple[Array, Array]:
    u0, u1, v0, v1 = surface.region.bounds
    lines_u, lines_v = np.linspace(u0, u1, NODES), np.linspace(v0, v1, NODES)
    if is_grid(surface.region.sample_u, surface.region.sample_v):
        lines_u, lines_v = grid_lines(surface.region.sample_u)[0], grid_lines(surface.region.sample_v)[0]
    grid_u, grid_v = np.meshgrid(lines_u, lines_v, indexing="ij")
    return grid_u.ravel(), grid_v.ravel()


@dataclass(frozen=True)
class SurfaceMismatch:
    """New samples against an old surface.

    Attributes:
        difference_mm: (N,) sample minus old surface; NaN where the old one was not measured.
        compared: Samples inside the old patch.
        outside: Samples that the old surface says nothing about.
        mean_mm: Mean difference.
        rms_mm: RMS difference.
        robust_rms_mm: The same from the median of the squares (a few bounced samples do not count).
        expected_mm: What noise and the old surface's own uncertainty explain; None if either is unknown.
    """

    difference_mm: Array
    compared: int
    outside: int
    mean_mm: float
    rms_mm: float
    robust_rms_mm: float
    expected_mm: float | None


def surface_mismatch(
    old: ErrorSurface, u: ArrayLike, v: ArrayLike, error_mm: ArrayLike, *, sigma_mm: float | None = None
) -> SurfaceMismatch:
    """Compare new samples (N,) with a stored surface; judge the result with `judge_mismatch`.

    Args:
        old: The stored surface.
        u: (N,) parameters of the new samples.
        v: (N,).
        error_mm: (N,) new errors.
        sigma_mm: Noise of one new sample; the old surface's by default.

    Raises:
        InputError: fewer than 16 new samples lie inside the old patch.
    """
    errors = np.asarray(error_mm, dtype=float)
    difference = errors - old.evaluate(u, v)
    inside = np.isfinite(difference)
    if inside.sum() < FEWEST_COMMON:
        raise InputError(
            f"Only {int(inside.sum())} new samples lie where the old error surface was measured, {FEWEST_COMMON} are "
            "needed to tell whether it still fits.",
            Code.NOT_ENOUGH_POINTS,
        )
    values = difference[inside]
    noise = old.sigma_mm if sigma_mm is None else sigma_mm
    expected = None
    if noise is not None and old.sigma_mm is not None:
        own = old.sigma_at(np.asarray(u, dtype=float)[inside], np.asarray(v, dtype=float)[inside])
        expected = float(np.sqrt(noise**2 + np.mean(own**2)))
    # 0.4549 is the median of a chi-square variable with one degree of freedom.
    robust = float(np.sqrt(np.median(values**2) / 0.4549))
    return SurfaceMismatch(
        difference,
        int(inside.sum()),
        int(np.sum(~inside & np.isfinite(errors))),
        float(values.mean()),
        float(np.sqrt(np.mean(values**2))),
        robust,
        expected,
    )
