"""The robot, as two capabilities: one that only reports its pose, and one that also moves on request.

The program requests motion; it is never a safety function.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Protocol, runtime_checkable

import numpy as np
from numpy.typing import NDArray

from devices.interfaces.limits import Limit

MAX_SPEED_MM_S = 250.0
"""Speed with a person in the cell (ISO 10218-1, reduced speed control); every mover enforces it."""


@dataclass(frozen=True, eq=False)
class RobotReading:
    """The robot's report.

    Attributes:
        time_s: The controller's time of the reading, on the cell's clock.
        base_from_flange: (4, 4), mm.
        moving: True until the arm has settled.
        joints_rad: (6,) joint angles where the robot reports them.
    """

    time_s: float
    base_from_flange: NDArray[np.float64]
    moving: bool
    joints_rad: NDArray[np.float64] | None = None


@dataclass(frozen=True, eq=False)
class RobotPath:
    """A path to look at before the robot takes it.

    Attributes:
        base_from_flange: (n, 4, 4), from where the robot stands to the target, both included.
        duration_s: At the speed that was asked for.
        length_mm: Of the flange origin's way.
    """

    base_from_flange: NDArray[np.float64]
    duration_s: float
    length_mm: float


class RobotReporter(Protocol):
    """A robot that reports where its flange is; somebody else moves it."""

    def read(self, *, deadline_s: float = 0.5) -> RobotReading:
        """Read the pose now.

        Raises:
            Lost: the connection is gone.
            Stale: the controller's time stands still.
        """
        ...


@runtime_checkable
class RobotMover(RobotReporter, Protocol):
    """A robot that also moves on request."""

    @property
    def limits(self) -> tuple[Limit, ...]:
        """Reach (mm), speed (mm/s) and joint angles (rad)."""
        ...

    def preview(self, base_from_flange: NDArray[np.float64], *, speed_mm_s: float = 100.0) -> RobotPath:
        """The path that `move_to` would take; nothing moves.

        Raises:
            Refused: target out of reach, or speed above 250 mm/s.
        """
        ...

    def move_to(
        self, base_from_flange: NDArray[np.float64], *, speed_mm_s: float = 100.0, deadline_s: float = 120.0
    ) -> RobotReading:
        """Move and come back when the arm has settled.

        Returns:
            The reading after settling.

        Raises:
            Refused: target out of reach, or speed above 250 mm/s; nothing has moved.
            Stopped: `stop` was called on the way.
            Lost: the connection is gone.
            DeadlineExceeded: not there within `deadline_s`; the robot has been told to stop.
        """
        ...

    def stop(self) -> None:
        """Stop the motion; may be called from another thread."""
        ...
