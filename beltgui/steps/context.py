"""What every step works with: the cell, what is known about it, where samples go, who is asked before a motion."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, field, replace

import numpy as np
from numpy.typing import NDArray

from beltgui.jobs import Job
from beltgui.session import Sample, Session
from core.cad.blade_type import BladeType
from devices.cell_plan import CellPlan
from devices.interfaces import Cell, Refused, RobotMover, RobotPath, RobotReading
from devices.interfaces.robot import MAX_SPEED_MM_S

Consent = Callable[[RobotPath, str], bool]
SampleListener = Callable[[Sample], None]


def _nobody(sample: Sample) -> None:
    """Nobody listens."""


@dataclass(frozen=True, eq=False)
class Context:
    """Everything a step may use.

    Attributes:
        cell: The devices.
        plan: Sizes, taught poses, nominal places.
        blade: The blade's type.
        serial: The blade's serial number.
        session: Where every sample is kept at once.
        consent: Shown each path before the robot takes it; answers whether a person wants the motion.
        job: Progress and cancel.
        speed_mm_s: Of the flange, at most 250.
        on_sample: Told of each sample once it is kept.
    """

    cell: Cell
    plan: CellPlan
    blade: BladeType
    serial: str
    session: Session
    consent: Consent
    job: Job = field(default_factory=Job)
    speed_mm_s: float = MAX_SPEED_MM_S
    on_sample: SampleListener = _nobody

    def part(self, start: float, end: float) -> Context:
        """The same for a part of the work, from `start` to `end` (0 to 1) of it."""
        return replace(self, job=self.job.part(start, end))

    def mover(self) -> RobotMover:
        """The robot, if it moves on request.

        Raises:
            Refused: it only reports its pose.
        """
        robot = self.cell.robot
        if not isinstance(robot, RobotMover):
            raise Refused("robot", "it only reports its pose and cannot be moved from here. Move it by its own panel.")
        return robot

    def move(self, target: NDArray[np.float64], purpose: str) -> RobotReading:
        """Preview a motion, ask for it, move, and come back with the settled reading.

        Raises:
            Refused: out of reach or too fast, or the person does not want the motion.
        """
        robot = self.mover()
        path = robot.preview(target, speed_mm_s=self.speed_mm_s)
        if not self.consent(path, purpose):
            raise Refused("robot", f"the motion was not wanted: {purpose}. Nothing has moved.")
        return robot.move_to(target, speed_mm_s=self.speed_mm_s)
