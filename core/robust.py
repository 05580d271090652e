"""Robust scale and weights."""

from __future__ import annotations

import numpy as np
from numpy.typing import ArrayLike, NDArray

Array = NDArray[np.float64]

# 1 / Phi^-1(3/4): makes the median absolute deviation consistent for Gaussian noise.
MAD_TO_SIGMA = 1.4826022185056018


def mad_sigma(residuals: ArrayLike, *, centred: bool = False) -> float:
    """Gaussian-consistent scale from the median absolute deviation.

    Args:
        residuals: (N,) any unit.
        centred: True if the residuals are known to have median zero.
    """
    values = np.asarray(residuals, dtype=float)
    centre = 0.0 if centred else np.median(values)
    return float(MAD_TO_SIGMA * np.median(np.abs(values - centre)))


def tukey_weights(residuals: ArrayLike, sigma: float, tuning: float = 4.685) -> Array:
    """Tukey's biweight (0 to 1); 95 % efficient on Gaussian noise at the default tuning."""
    x = np.asarray(residuals, dtype=float) / (tuning * sigma)
    return np.where(np.abs(x) < 1.0, (1.0 - x**2) ** 2, 0.0)


def huber_weights(residuals: ArrayLike, sigma: float, tuning: float = 1.345) -> Array:
    """Huber's weights (0 to 1]; 95 % efficient on Gaussian noise at the default tuning."""
    x = np.abs(np.asarray(residuals, dtype=float)) / (tuning * sigma)
    return np.asarray(1.0 / np.maximum(x, 1.0))
