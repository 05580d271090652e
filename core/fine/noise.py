"""What is noise and what is not: residuals of a face as a Gaussian on two flat shelves, one behind and one in front.

Ghosts of a scanner (mixed pixels at edges, reflections) and clutter lie on one side of a surface more often than on the
other. A symmetric robust weight then pulls the pose towards them. Here the density of the strangers is estimated on
each
side and the weight of a point is the probability that it belongs to the surface, which makes the estimating equation
`sum w d = 0` unbiased under one-sided strangers too (score of the mixture's likelihood; McLachlan & Peel, Finite
Mixture
Models, 2000, section 2.8).
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray
from scipy.special import ndtr

Array = NDArray[np.float64]

# Half width of the window in which the shelves are measured, in sigmas.
WINDOW_SIGMAS = 12.0
# Strangers are never quite impossible: this share of the points is spread over the window.
LEAST_STRANGERS = 2e-4
_BINS = 240
_SQRT_2PI = float(np.sqrt(2.0 * np.pi))


@dataclass(frozen=True)
class Mixture:
    """Residuals d of one group of points: `n N(mean, sigma) + shelf`, the shelf changing from one side to the other.

    Attributes:
        count: Number of points of the surface itself.
        mean_mm: Their mean.
        sigma_mm: Their scatter.
        behind: Strangers per mm at d < 0 (inside the material).
        front: Strangers per mm at d > 0.
    """

    count: float
    mean_mm: float
    sigma_mm: float
    behind: float
    front: float

    def shelf(self, d: Array) -> Array:
        """Density of strangers per mm at residuals (N,); the step between the sides is as soft as the noise."""
        return np.asarray(self.behind + (self.front - self.behind) * ndtr(d / self.sigma_mm))

    def weights(self, d: Array) -> Array:
        """Probability (N,) that a point at residual d belongs to the surface; the surface is taken to be at d = 0."""
        bell = self.count / (_SQRT_2PI * self.sigma_mm) * np.exp(-0.5 * (d / self.sigma_mm) ** 2)
        return np.asarray(bell / (bell + self.shelf(d)))

    @property
    def stranger_share(self) -> float:
        """Share of strangers among the points within three sigmas."""
        strangers = 3.0 * self.sigma_mm * (self.behind + self.front)
        return strangers / (strangers + self.count)

    def efficiency(self) -> tuple[float, float, float]:
        """(E w, E psi', E psi^2 / sigma^2) with psi = w d over the density of all points, per surface point."""
        x = np.linspace(-WINDOW_SIGMAS, WINDOW_SIGMAS, 1201) * self.sigma_mm
        step = x[1] - x[0]
        w = self.weights(x)
        density = np.exp(-0.5 * (x / self.sigma_mm) ** 2) / (_SQRT_2PI * self.sigma_mm) + self.shelf(x) / self.count
        psi = w * x
        slope = np.gradient(psi, step)
        return (float((density * w).sum() * step), float((density * slope).sum() * step),
                float((density * psi**2).sum() * step / self.sigma_mm**2))


def shortest_half_sigma(d: Array, share: float = 0.5) -> tuple[float, float]:
    """Scale and middle of the narrowest interval that holds a share of the residuals (N,).

    Source: Rousseeuw & Leroy, Robust Regression and Outlier Detection (1987), section 4.3 (shortest half).
    """
    from scipy.special import ndtri

    ordered = np.sort(d)
    held = max(int(share * len(ordered)), 2)
    widths = ordered[held - 1 :] - ordered[: len(ordered) - held + 1]
    first = int(np.argmin(widths))
    sigma = float(widths[first]) / (2.0 * float(ndtri(0.5 + share / 2.0)))
    return sigma, float(ordered[first : first + held].mean())


def fit_mixture(d: Array, sigma_start: float, *, sigma_known: float | None = None, rounds: int = 60) -> Mixture:
    """Expectation-maximisation on a histogram of the residuals.

    Args:
        d: (N,) residuals in mm; those outside of 12 sigmas are not looked at.
        sigma_start: First guess of the scatter in mm.
        sigma_known: Keeps the scatter at this value.
        rounds: Rounds of the iteration.
    """
    sigma = sigma_known or sigma_start
    window = WINDOW_SIGMAS * sigma
    counts, edges = np.histogram(d, bins=_BINS, range=(-window, window))
    middles, width = 0.5 * (edges[1:] + edges[:-1]), edges[1] - edges[0]
    total = float(counts.sum())
    if total == 0.0:
        return Mixture(0.0, 0.0, sigma, 0.0, 0.0)
    least = (LEAST_STRANGERS * total + 0.5) / (2.0 * window)
    far = np.abs(middles) > 6.0 * sigma
    behind = max(counts[far & (middles < 0)].sum() / (6.0 * sigma), least)
    front = max(counts[far & (middles > 0)].sum() / (6.0 * sigma), least)
    mean, count = 0.0, max(total - window * (behind + front), 0.2 * total)
    for _ in range(rounds):
        bell = count / (_SQRT_2PI * sigma) * np.exp(-0.5 * ((middles - mean) / sigma) ** 2)
        rise = ndtr(middles / sigma)
        low, high = behind * (1.0 - rise), front * rise
        everything = bell + low + high
        own = counts * bell / everything
        count = max(float(own.sum()), 1e-9)
        mean = float(own @ middles) / count
        if sigma_known is None:
            # The bins add width^2 / 12 (Sheppard's correction).
            sigma = float(np.sqrt(max(own @ (middles - mean) ** 2 / count - width**2 / 12.0, (0.3 * width) ** 2)))
        behind = max(float((counts * low / everything).sum()) / window, least)
        front = max(float((counts * high / everything).sum()) / window, least)
    return Mixture(count, mean, sigma, behind, front)
