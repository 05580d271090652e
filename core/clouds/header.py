"""Small helpers that the binary formats share."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from core.errors import InputError

Array = NDArray[np.float64]


def count_of(word: str, what: str, path: str) -> int:
    """A count from a header word, refused if it is no plain number."""
    if not (word.isascii() and word.isdigit() and len(word) <= 12):
        raise InputError(f"{path}: the header gives {word[:24]!r} as {what}, expected a whole number.")
    return int(word)


def columns_as_points(table: NDArray[np.void]) -> Array:
    """(N, 3) float64 of the fields x, y, z of a structured array (N,)."""
    points = np.empty((len(table), 3))
    # A damaged float may be a signalling NaN, which numpy would warn about; it is dropped later like any NaN.
    with np.errstate(invalid="ignore"):
        for index, axis in enumerate("xyz"):
            points[:, index] = table[axis]
    return points
