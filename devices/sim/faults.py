"""Things that go wrong in a cell, to be switched on while it runs."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from devices.interfaces.errors import Lost, Stale
from devices.sim.geometry import Array, rigid, turn


class Faults:
    """The present faults; everything starts healthy.

    Device names: `scanner`, `stage`, `robot`, `grinder rough`, `grinder fine` (`grinder ` and its name).

    Attributes:
        ball_moved_mm: (3,) in {F}: how far the ball has been knocked from where it was.
        blade_slip: (4, 4) in {W}: how the blade has moved in its clamp.
        wheel_wear_mm: By grinder: how much smaller the wheel's radius has become.
        angle_zero_rad: By grinder: shift of the angle sensor's zero.
    """

    def __init__(self) -> None:
        self.ball_moved_mm = np.zeros(3)
        self.blade_slip = np.eye(4)
        self.wheel_wear_mm: dict[str, float] = {}
        self.angle_zero_rad: dict[str, float] = {}
        self._lost: set[str] = set()
        self._stalled: set[str] = set()

    def move_ball(self, shift_in_flange_mm: Sequence[float] | Array) -> None:
        """Knock the ball by this much in {F}."""
        self.ball_moved_mm = self.ball_moved_mm + np.asarray(shift_in_flange_mm, dtype=float)

    def slip_blade(
        self, shift_in_work_mm: Sequence[float] | Array, rotvec_in_work_rad: Sequence[float] | Array
    ) -> None:
        """Let the blade slip in its clamp by a shift and a turn about the origin of {W}."""
        self.blade_slip = self.blade_slip @ rigid(turn(rotvec_in_work_rad), np.asarray(shift_in_work_mm, dtype=float))

    def wear_wheel(self, grinder: str, by_mm: float) -> None:
        """Make a contact wheel smaller."""
        self.wheel_wear_mm[grinder] = self.wheel_wear_mm.get(grinder, 0.0) + by_mm

    def shift_angle_zero(self, grinder: str, by_rad: float) -> None:
        """Shift the zero of a head's angle sensor."""
        self.angle_zero_rad[grinder] = self.angle_zero_rad.get(grinder, 0.0) + by_rad

    def lose(self, device: str) -> None:
        """Cut the connection to a device."""
        self._lost.add(device)

    def stall(self, device: str) -> None:
        """Let a device answer with its last value for ever."""
        self._stalled.add(device)

    def restore(self, device: str) -> None:
        """Connect a device again, with fresh values."""
        self._lost.discard(device)
        self._stalled.discard(device)

    def check(self, device: str) -> None:
        """Raise `Lost` while the device is cut off, `Stale` while its values stand still."""
        if device in self._lost:
            raise Lost(device, "the connection is gone. Check its cable and power, then connect it again.")
        if device in self._stalled:
            raise Stale(device, "it answers, but its values stand still. Wait, or connect it again.")
