"""What a cloud file yields, and the one place where "no measurement" is decided."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from core.errors import InputError
from core.verdict import Code

Array = NDArray[np.float64]

# Ten kilometres: no scanner of a grinding cell sees that far, a damaged float does.
LARGEST_COORDINATE_MM = 1e7


@dataclass(frozen=True)
class Cloud:
    """Points of one file.

    Attributes:
        points_mm: (N, 3) float64 in the frame in which the file was written.
        dropped: How many points were at NaN or exactly (0, 0, 0), which scanners write for "no measurement".
        total: How many points the file holds.
        format: E.g. `PLY binary little-endian`.
    """

    points_mm: Array
    dropped: int
    total: int
    format: str


def measured_only(points: Array, path: str, name: str) -> Cloud:
    """Drop what is no measurement, count it, and refuse what cannot be a measurement.

    Args:
        points: (N, 3) in mm as they stand in the file.
        path: File name for messages.
        name: Format for the record.

    Raises:
        InputError: no point is left, or a coordinate is beyond any scanner.
    """
    finite = np.isfinite(points).all(axis=1)
    keep = finite & (points != 0.0).any(axis=1)
    total = len(points)
    count = int(keep.sum())
    if total == 0:
        raise InputError(f"{path}: the file holds no points.", Code.NOT_ENOUGH_POINTS)
    if count == 0:
        raise InputError(f"{path}: all {total} points are NaN or (0, 0, 0), which means \"no measurement\". "
                         "Scan again with more exposure or a shorter distance.", Code.NOT_ENOUGH_POINTS)
    kept = np.ascontiguousarray(points if count == total else points[keep])
    largest = max(float(kept.max()), -float(kept.min()))
    if largest > LARGEST_COORDINATE_MM:
        index = int(np.flatnonzero((np.abs(points) > LARGEST_COORDINATE_MM).any(axis=1) & keep)[0])
        raise InputError(f"{path}: point {index + 1} has a coordinate of {largest:.3g} mm, beyond any scanner. "
                         "The file is damaged, or its header describes other data.")
    return Cloud(kept, total - count, total, name)
