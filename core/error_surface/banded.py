"""Symmetric positive definite banded matrices: factor, log determinant and the inverse inside the band."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
import scipy.linalg as sl
from numpy.typing import NDArray
from scipy.sparse import coo_array, csr_array

Array = NDArray[np.float64]


def lower_band(matrix: csr_array | coo_array, bandwidth: int) -> Array:
    """(bandwidth + 1, n) lower band storage, `band[i - j, j] = matrix[i, j]`, of a symmetric sparse matrix."""
    entries = coo_array(matrix)
    row, column = entries.coords
    keep = row >= column
    band = np.zeros((bandwidth + 1, int(matrix.shape[0])))
    np.add.at(band, (row[keep] - column[keep], column[keep]), entries.data[keep])
    return band


@dataclass(frozen=True)
class BandedFactor:
    """Cholesky factor L (lower band storage) of A = L L^T."""

    lower: Array

    @classmethod
    def of(cls, band: Array) -> BandedFactor:
        """Factor a matrix in lower band storage."""
        return cls(np.asarray(sl.cholesky_banded(band, lower=True)))

    def solve(self, rhs: Array) -> Array:
        """A^-1 rhs for (n,) or (n, k)."""
        return np.asarray(sl.cho_solve_banded((self.lower, True), rhs))

    def log_determinant(self) -> float:
        """Logarithm of the determinant of A."""
        return float(2.0 * np.sum(np.log(self.lower[0])))

    def inverse_band(self) -> Array:
        """The entries of A^-1 inside the band, in lower band storage.

        Takahashi's recurrence: from L^T A^-1 = L^-1, column by column from the last one. Costs n * bandwidth^2 and
        never forms the full inverse.
        """
        width, n = self.lower.shape
        out = np.zeros((width, n))
        window = np.zeros((width - 1, width - 1))
        for j in range(n - 1, -1, -1):
            pivot = self.lower[0, j]
            multipliers = self.lower[1:, j] / pivot
            column = -(window @ multipliers)
            diagonal = 1.0 / pivot**2 - multipliers @ column
            out[0, j], out[1:, j] = diagonal, column
            shifted = np.empty_like(window)
            shifted[1:, 1:] = window[:-1, :-1]
            shifted[0, 0] = diagonal
            shifted[0, 1:] = shifted[1:, 0] = column[:-1]
            window = shifted
        return out
