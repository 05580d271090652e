"""The 3D scanner: one capture is one cloud in the scanner's own frame {S}."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Protocol

import numpy as np
from numpy.typing import NDArray

from devices.interfaces.limits import Limit
from devices.shared_array import SharedArray


@dataclass(frozen=True, eq=False)
class Scan:
    """One capture.

    Attributes:
        points_mm: float32, (N, 3) or organised (H, W, 3), in {S}; NaN = no measurement at that pixel.
        time_s: When it was taken, on the cell's clock.
    """

    points_mm: NDArray[np.float32]
    time_s: float

    def valid_points_mm(self) -> NDArray[np.float64]:
        """(N, 3) float64 in {S}: the measurements, without the pixels that saw nothing."""
        flat = self.points_mm.reshape(-1, 3)
        return flat[np.isfinite(flat).all(axis=1)].astype(np.float64)


@dataclass(frozen=True)
class SharedScan:
    """A scan as it crosses a process boundary: the points stay in shared memory, only their address travels."""

    points: SharedArray
    time_s: float

    @classmethod
    def put(cls, scan: Scan) -> SharedScan:
        """Copy a scan into new shared memory; the receiver unlinks it."""
        return cls(SharedArray.put(scan.points_mm), scan.time_s)

    def take(self) -> Scan:
        """Copy the points out and free the shared memory; to be called once, by the receiver."""
        with self.points.attach() as view:
            points = np.array(view, dtype=np.float32)
        self.points.unlink()
        return Scan(points, self.time_s)


class Scanner(Protocol):
    """A 3D scanner with a software trigger."""

    @property
    def limits(self) -> tuple[Limit, ...]:
        """The measuring volume: working distance, width and height at it."""
        ...

    def capture(self, *, deadline_s: float = 10.0) -> Scan:
        """Take one scan where the stage stands now.

        Raises:
            Lost: the connection is gone.
            DeadlineExceeded: no complete scan arrived within `deadline_s`.
        """
        ...
