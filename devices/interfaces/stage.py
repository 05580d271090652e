"""The motion stage that carries the scanner: three linear axes and one rotary axis."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Protocol

from devices.interfaces.limits import Limit


@dataclass(frozen=True)
class StagePosition:
    """Where the stage stands, by its own scales.

    Attributes:
        x_mm: First linear axis.
        y_mm: Second linear axis.
        z_mm: Third linear axis.
        theta_rad: Rotary axis.
        time_s: When it was read, on the cell's clock; None in a target.
        moving: True while an axis is still moving.
    """

    x_mm: float
    y_mm: float
    z_mm: float
    theta_rad: float = 0.0
    time_s: float | None = None
    moving: bool = False


class Stage(Protocol):
    """A stage that must be homed before it moves to absolute positions."""

    @property
    def limits(self) -> tuple[Limit, Limit, Limit, Limit]:
        """Travel of x, y, z (mm) and theta (rad)."""
        ...

    @property
    def homed(self) -> bool:
        """False after power-up or loss, until `home` has been done."""
        ...

    def home(self, *, deadline_s: float = 60.0) -> None:
        """Find the reference marks and go to zero."""
        ...

    def position(self, *, deadline_s: float = 1.0) -> StagePosition:
        """Read where the stage stands (not where it was told to go)."""
        ...

    def move_to(self, target: StagePosition, *, deadline_s: float = 60.0) -> StagePosition:
        """Move all axes and come back when they stand still.

        Returns:
            The position read after settling.

        Raises:
            Refused: target outside the limits, or not homed; nothing has moved.
            Stopped: `stop` was called on the way.
            Lost: the connection is gone.
            DeadlineExceeded: not there within `deadline_s`; the stage has been told to stop.
        """
        ...

    def stop(self) -> None:
        """Stop all axes; may be called from another thread."""
        ...
