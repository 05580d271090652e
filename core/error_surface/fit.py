"""Entry of the step: check the samples, then interpolate or smooth them."""

from __future__ import annotations

from collections.abc import Mapping

import numpy as np
from numpy.typing import ArrayLike, NDArray

from core.error_surface.interpolate import interpolate_grid
from core.error_surface.smooth import smooth_samples
from core.error_surface.surface import ErrorSurface
from core.errors import FitError, InputError
from core.verdict import Code

Array = NDArray[np.float64]
FEWEST_SAMPLES = 16
# Grinding allowances are tenths of a mm: a typical error beyond this is a wrong unit, not a bad blade.
UNIT_SUSPICION_MM = 20.0
LEAST_WIDTH_RATIO = 1e-3
DEFAULT_REACH_STEPS = 2.1


def fit_error_surface(
    u: ArrayLike,
    v: ArrayLike,
    error_mm: ArrayLike,
    *,
    mode: str = "interpolate",
    sigma_mm: float | None = None,
    intervals: tuple[int, int] | None = None,
    penalty: tuple[float, float] | None = None,
    reject: bool = True,
    reach_steps: float = DEFAULT_REACH_STEPS,
    domain: tuple[float, float, float, float] | None = None,
    info: Mapping[str, str] | None = None,
) -> ErrorSurface:
    """Fit the normal error over the airfoil's (u, v) by a tensor-product cubic B-spline.

    Args:
        u: (N,) airfoil parameter around the profile, any order.
        v: (N,) airfoil parameter along the span.
        error_mm: (N,) normal errors in mm; NaN marks a missing sample (smoothing only).
        mode: "interpolate" needs a full grid and goes through every sample, with as many control points as samples.
            "smooth" takes scattered or incomplete samples, rejects wrong ones and chooses its smoothing from the data
            (REML). With `intervals` it is a plain least-squares spline, efficient where that many knots suffice.
        sigma_mm: Noise of one sample if known; otherwise it is estimated.
        intervals: Knot intervals in u and v: regression instead of smoothing.
        penalty: Fixed weights of the bending energies in u and v, instead of REML.
        reject: False keeps every sample in a smoothing fit.
        reach_steps: Gaps are bridged up to empty circles of this radius, in sample spacings.
        domain: (u least, u greatest, v least, v greatest) of the airfoil, if known.
        info: Date, blade type, tool and the like, kept with the surface.

    Returns:
        The surface. It answers NaN wherever nothing was measured.

    Raises:
        InputError: unusable numbers, too few samples, an incomplete grid or an outlier when interpolating.
        FitError: the samples do not determine a surface.
    """
    columns = _checked(u, v, error_mm, domain)
    if sigma_mm is not None and not (np.isfinite(sigma_mm) and sigma_mm > 0.0):
        raise InputError(f"sigma_mm: expected a positive noise in mm, found {sigma_mm:g}.")
    kept = dict(info or {})
    if mode == "interpolate":
        return interpolate_grid(*columns, sigma_mm=sigma_mm, reach_steps=reach_steps, info=kept)
    if mode != "smooth":
        raise InputError(f"mode: expected 'interpolate' or 'smooth', found '{mode}'.")
    if intervals is not None and min(intervals) < 1:
        raise InputError(f"intervals: expected at least 1 in u and v, found {intervals}.")
    return smooth_samples(
        *columns,
        sigma_mm=sigma_mm,
        intervals=intervals,
        penalty=penalty,
        reject=reject,
        reach_steps=reach_steps,
        info=kept,
    )


def _checked(
    u: ArrayLike, v: ArrayLike, error_mm: ArrayLike, domain: tuple[float, float, float, float] | None
) -> tuple[Array, Array, Array]:
    columns = [np.asarray(column, dtype=float) for column in (u, v, error_mm)]
    if any(column.ndim != 1 or column.shape != columns[0].shape for column in columns):
        raise InputError(f"u, v, error_mm: expected three columns of equal length, found {[c.shape for c in columns]}.")
    cu, cv, error = columns
    bad = ~(np.isfinite(cu) & np.isfinite(cv)) | np.isinf(error)
    if np.any(bad):
        raise InputError(f"Sample {int(np.argmax(bad)) + 1}: u, v or error_mm is not a number ({bad.sum()} samples).")
    present = np.isfinite(error)
    if present.sum() < FEWEST_SAMPLES:
        raise InputError(
            f"{int(present.sum())} samples with an error, at least {FEWEST_SAMPLES} are needed. Measure more points.",
            Code.NOT_ENOUGH_POINTS,
        )
    if domain is not None:
        _check_domain(cu, cv, domain)
    typical = float(np.median(np.abs(error[present])))
    if typical > UNIT_SUSPICION_MM:
        raise InputError(
            f"error_mm: the typical error is {typical:.4g}, which no blade in a cell has in mm. "
            "Check the unit (micrometres?)."
        )
    spread = np.column_stack([cu[present], cv[present]])
    values = np.linalg.svd(spread - spread.mean(axis=0), compute_uv=False)
    if values[0] <= 0.0 or values[1] < LEAST_WIDTH_RATIO * values[0]:
        raise FitError(
            "The samples lie on one line of the airfoil; a surface needs samples that spread in u and in v. "
            "Measure several lines.",
            Code.NOT_ENOUGH_VARIATION,
        )
    return cu, cv, error


def _check_domain(u: Array, v: Array, domain: tuple[float, float, float, float]) -> None:
    outside = (u < domain[0] - 1e-9) | (u > domain[1] + 1e-9) | (v < domain[2] - 1e-9) | (v > domain[3] + 1e-9)
    if np.any(outside):
        row = int(np.argmax(outside))
        raise InputError(
            f"Sample {row + 1}: (u {u[row]:.6g}, v {v[row]:.6g}) is outside the airfoil's domain u {domain[0]:g} to "
            f"{domain[1]:g}, v {domain[2]:g} to {domain[3]:g} ({int(outside.sum())} such samples). "
            "Check that u and v are not swapped."
        )
