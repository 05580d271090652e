"""Shared by all steps: one trial, one case, and the two figures made of many trials."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray
from scipy.stats import chi2

Array = NDArray[np.float64]


@dataclass(frozen=True)
class Trial:
    """One simulated run.

    Attributes:
        error: (d,) estimate minus truth.
        covariance: (d, d) what the estimator reported.
        crb: (d, d) Cramér–Rao bound from an independent forward model.
    """

    error: Array
    covariance: Array
    crb: Array


@dataclass(frozen=True)
class Case:
    """A named experiment; `run` draws one trial from the given generator."""

    name: str
    dimension: int
    run: Callable[[np.random.Generator], Trial]


@dataclass(frozen=True)
class Row:
    """What many trials say.

    Attributes:
        nees: Mean normalised estimation error squared, divided by the dimension (1 is ideal).
        nees_band: 95 % band of that mean if the stated covariance is true.
        spread_over_crb: Square root of the mean of e^T CRB^-1 e / d (1 is ideal, below 1.1 is asked).
    """

    name: str
    runs: int
    dimension: int
    nees: float
    nees_band: tuple[float, float]
    spread_over_crb: float

    @property
    def ok(self) -> bool:
        return self.nees_band[0] <= self.nees <= self.nees_band[1] and 0.9 <= self.spread_over_crb <= 1.1


def measure(case: Case, runs: int, seed: int) -> Row:
    """Run a case `runs` times with independent, reproducible random streams."""
    nees, spread = [], []
    for stream in np.random.SeedSequence(seed).spawn(runs):
        trial = case.run(np.random.default_rng(stream))
        nees.append(trial.error @ np.linalg.solve(trial.covariance, trial.error))
        spread.append(trial.error @ np.linalg.solve(trial.crb, trial.error))
    degrees = runs * case.dimension
    low, high = chi2.ppf([0.025, 0.975], degrees) / degrees
    return Row(
        case.name,
        runs,
        case.dimension,
        float(np.mean(nees)) / case.dimension,
        (float(low), float(high)),
        float(np.sqrt(np.mean(spread) / case.dimension)),
    )
