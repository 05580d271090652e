"""The sensors of one belt grinder's floating head: head angle and contact force."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Protocol

from devices.interfaces.limits import Limit


@dataclass(frozen=True)
class GrinderReading:
    """One sample of the head's sensors.

    Attributes:
        time_s: When it was sampled, on the cell's clock.
        angle_rad: Head angle, positive right-handed about the head axis; 0 is the nominal contact.
        force_N: Force of the wheel on what it touches; 0 without contact.
    """

    time_s: float
    angle_rad: float
    force_N: float  # noqa: N815  (the unit is newton)


class GrinderSensors(Protocol):
    """Angle and force sensors of one grinder."""

    @property
    def limits(self) -> tuple[Limit, ...]:
        """Travel of the head (rad) and range of the force sensor (N)."""
        ...

    def read(self, *, deadline_s: float = 0.1) -> GrinderReading:
        """Read the newest sample.

        Raises:
            Lost: no heartbeat.
            DeadlineExceeded: no sample came within `deadline_s` (a lost frame); asking again is allowed.
        """
        ...
