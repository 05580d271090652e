"""One cell: everything that a calibration step may talk to."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass

from devices.clock import Clock
from devices.interfaces.grinder import GrinderSensors
from devices.interfaces.operator import Operator
from devices.interfaces.robot import RobotReporter
from devices.interfaces.scanner import Scanner
from devices.interfaces.stage import Stage


@dataclass(frozen=True, eq=False)
class Cell:
    """The devices of a cell.

    Attributes:
        scanner: On the stage.
        stage: Carries the scanner.
        robot: A `RobotReporter`; test with `isinstance(robot, RobotMover)` whether it also moves.
        grinders: By name: `rough`, `fine`.
        operator: The person.
        clock: The time of all readings.
    """

    scanner: Scanner
    stage: Stage
    robot: RobotReporter
    grinders: Mapping[str, GrinderSensors]
    operator: Operator
    clock: Clock
