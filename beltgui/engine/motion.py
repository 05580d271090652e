"""Robot and stage behind the guard: nothing moves that no person wanted, everything stops when it has to."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np
from numpy.typing import NDArray

from beltgui.engine.guard import MotionGuard, Released
from beltgui.engine.watch import Watch
from devices.interfaces import (
    MAX_SPEED_MM_S,
    Limit,
    Refused,
    RobotMover,
    RobotPath,
    RobotReading,
    RobotReporter,
    Stage,
    StagePosition,
)

Check = Callable[[], None]
SPEED = Limit("speed", 0.0, MAX_SPEED_MM_S, "mm/s")


class WatchedRobot:
    """A `RobotReporter` whose calls are noted."""

    def __init__(self, robot: RobotReporter, watch: Watch) -> None:
        self._reporter, self._watch = robot, watch

    def read(self, *, deadline_s: float = 0.5) -> RobotReading:
        """Read the pose now."""
        with self._watch.call("robot", "reading the pose"):
            return self._reporter.read(deadline_s=deadline_s)


class GuardedRobot(WatchedRobot):
    """A `RobotMover` that moves only while a person wants it.

    Args:
        robot: The driver.
        guard: Shared with the stage.
        watch: Where calls are noted.
        check: Called before each motion; raises where a device has dropped.
    """

    def __init__(self, robot: RobotMover, guard: MotionGuard, watch: Watch, check: Check) -> None:
        super().__init__(robot, watch)
        self._robot, self._guard, self._check = robot, guard, check

    @property
    def limits(self) -> tuple[Limit, ...]:
        """Reach, speed and joint angles."""
        return self._robot.limits

    def preview(self, base_from_flange: NDArray[np.float64], *, speed_mm_s: float = 100.0) -> RobotPath:
        """The path that `move_to` would take; nothing moves."""
        _refuse_fast(speed_mm_s)
        with self._watch.call("robot", "planning a path"):
            return self._robot.preview(base_from_flange, speed_mm_s=speed_mm_s)

    def move_to(
        self, base_from_flange: NDArray[np.float64], *, speed_mm_s: float = 100.0, deadline_s: float = 120.0
    ) -> RobotReading:
        """Move; where the motion is interrupted by letting the button go, ask again and go on from there.

        Raises:
            Refused: out of reach, too fast, or the person does not want to go on.
            Stopped: a person stopped it.
            Cancelled: a person ended the work.
            DeviceError: as `RobotMover.move_to`, or another device dropped meanwhile.
        """
        _refuse_fast(speed_mm_s)
        while True:
            self._check()
            if not self._guard.may_move():
                path = self.preview(base_from_flange, speed_mm_s=speed_mm_s)
                if not self._guard.consent_to_go_on(path):
                    raise Refused("robot", "the motion was not wanted. It stands where it was stopped.")
            try:
                with self._watch.call("robot", "moving", moving=True):
                    return self._guard.carry_out(
                        self._robot,
                        lambda: self._robot.move_to(base_from_flange, speed_mm_s=speed_mm_s, deadline_s=deadline_s),
                    )
            except Released:
                continue

    def stop(self) -> None:
        """Stop the motion."""
        self._robot.stop()


class GuardedStage:
    """A `Stage` that stops with everything else."""

    def __init__(self, stage: Stage, guard: MotionGuard, watch: Watch, check: Check) -> None:
        self._stage, self._guard, self._watch, self._check = stage, guard, watch, check

    @property
    def limits(self) -> tuple[Limit, Limit, Limit, Limit]:
        """Travel of x, y, z (mm) and theta (rad)."""
        return self._stage.limits

    @property
    def homed(self) -> bool:
        """False until `home` has been done."""
        return self._stage.homed

    def home(self, *, deadline_s: float = 60.0) -> None:
        """Find the reference marks and go to zero."""
        self._check()
        with self._watch.call("stage", "finding its reference", moving=True):
            self._guard.carry_out(self._stage, lambda: self._stage.home(deadline_s=deadline_s))

    def position(self, *, deadline_s: float = 1.0) -> StagePosition:
        """Read where the stage stands."""
        with self._watch.call("stage", "reading the scales"):
            return self._stage.position(deadline_s=deadline_s)

    def move_to(self, target: StagePosition, *, deadline_s: float = 60.0) -> StagePosition:
        """Move all axes, see `Stage.move_to`."""
        self._check()
        with self._watch.call("stage", "moving", moving=True):
            return self._guard.carry_out(self._stage, lambda: self._stage.move_to(target, deadline_s=deadline_s))

    def stop(self) -> None:
        """Stop all axes."""
        self._stage.stop()


def _refuse_fast(speed_mm_s: float) -> None:
    if not SPEED.contains(speed_mm_s):
        raise Refused.beyond("robot", SPEED, 0.0, speed_mm_s)
