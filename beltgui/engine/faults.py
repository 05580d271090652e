"""Things that a trainer can let go wrong in the simulated cell, by name."""

from __future__ import annotations

from collections.abc import Callable, Mapping

import numpy as np

from devices.sim.faults import Faults

GRINDER = "fine"
BALL_MM = 0.5
HEAD_ZERO_RAD = float(np.radians(0.1))
SLIP_MM, SLIP_RAD = 0.4, float(np.radians(0.1))
WEAR_MM = 0.3
DEVICES = ("scanner", "stage", "robot", "grinder rough", "grinder fine")


def _restore_all(faults: Faults) -> None:
    for device in DEVICES:
        faults.restore(device)
    faults.ball_moved_mm = np.zeros(3)
    faults.blade_slip = np.eye(4)
    faults.wheel_wear_mm = {}
    faults.angle_zero_rad = {}


FAULTS: Mapping[str, Callable[[Faults], None]] = {
    "ball moved": lambda faults: faults.move_ball((BALL_MM, 0.0, 0.0)),
    "head zero shifted": lambda faults: faults.shift_angle_zero(GRINDER, HEAD_ZERO_RAD),
    "blade slipped": lambda faults: faults.slip_blade((0.0, SLIP_MM, 0.0), (0.0, 0.0, SLIP_RAD)),
    "wheel worn": lambda faults: faults.wear_wheel(GRINDER, WEAR_MM),
    "scanner lost": lambda faults: faults.lose("scanner"),
    "robot lost": lambda faults: faults.lose("robot"),
    "stage lost": lambda faults: faults.lose("stage"),
    "grinder fine lost": lambda faults: faults.lose("grinder fine"),
    "restore all": _restore_all,
}
