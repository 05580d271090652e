"""Simulated robot: reports what its encoders and nominal geometry say, stands where its true geometry puts it."""

from __future__ import annotations

import threading

import numpy as np

from devices.interfaces.errors import DeadlineExceeded, Refused, Stopped
from devices.interfaces.limits import Limit
from devices.interfaces.robot import MAX_SPEED_MM_S, RobotPath, RobotReading
from devices.sim.geometry import Array
from devices.sim.kinematics import JOINT_LIMIT_RAD, reach_joints
from devices.sim.world import World

_TICK_S = 0.05
_PATH_STEPS = 24
_NAME = "robot"
_PEAK = 1.5  # of a motion that starts and ends smoothly, against its mean speed
_REACH_MM = 1750.0
_ARRIVED_MM, _ARRIVED_RAD = 1e-4, 1e-7


class SimulatedRobot:
    """The robot of a simulated cell (a `RobotMover`); joint motions, no collision check.

    Example:
        >>> from devices.sim import build_simulated_cell
        >>> robot = build_simulated_cell().cell.robot
        >>> robot.read().moving
        False
    """

    def __init__(self, world: World) -> None:
        self._world = world
        self._stop = threading.Event()

    @property
    def limits(self) -> tuple[Limit, ...]:
        """Reach, speed and joint angles."""
        joints = (Limit(f"joint {i}", -JOINT_LIMIT_RAD, JOINT_LIMIT_RAD, "rad") for i in range(1, 7))
        return (
            Limit("distance from the base", 0.0, _REACH_MM, "mm"),
            Limit("speed", 1.0, MAX_SPEED_MM_S, "mm/s"),
            *joints,
        )

    def read(self, *, deadline_s: float = 0.5) -> RobotReading:
        """Read the pose now."""
        self._world.faults.check(_NAME)
        with self._world.lock:
            motion, now = self._world.motion, self._world.clock.now_s()
            joints = motion.joints_at(now)
        settle = self._world.settings.robot.settle_s if motion.duration_s else 0.0
        moving = now < motion.begin_s + motion.duration_s + settle
        return RobotReading(now, self._world.nominal_arm.forward(joints), moving, joints)

    def preview(self, base_from_flange: Array, *, speed_mm_s: float = 100.0) -> RobotPath:
        """The path that `move_to` would take; nothing moves."""
        self._world.faults.check(_NAME)
        _, path = self._plan(base_from_flange, speed_mm_s)
        return path

    def move_to(
        self, base_from_flange: Array, *, speed_mm_s: float = 100.0, deadline_s: float = 120.0
    ) -> RobotReading:
        """Move and come back when the arm has settled; see `RobotMover.move_to`."""
        world = self._world
        world.faults.check(_NAME)
        joints, path = self._plan(base_from_flange, speed_mm_s)
        self._stop.clear()
        begin = world.clock.now_s()
        world.arrive(joints, path.duration_s)
        total = path.duration_s + (world.settings.robot.settle_s if path.duration_s else 0.0)
        while (passed := world.clock.now_s() - begin) < total:
            if self._stop.is_set():
                world.freeze()
                raise Stopped(_NAME, "stopped on the way. Check that the way is free, then move again.")
            if passed > deadline_s:
                world.freeze()
                raise DeadlineExceeded(_NAME, f"not at its target within {deadline_s:g} s, stopped.")
            world.faults.check(_NAME)
            world.clock.wait(min(_TICK_S, total - passed + 1e-6))
        return self.read()

    def stop(self) -> None:
        """Stop the motion; may be called from another thread."""
        self._stop.set()

    def _plan(self, base_from_flange: Array, speed_mm_s: float) -> tuple[Array, RobotPath]:
        world = self._world
        target = np.asarray(base_from_flange, dtype=float)
        reach, speed = self.limits[:2]
        here = world.joints()
        if not speed.contains(speed_mm_s):
            raise Refused.beyond(_NAME, speed, 0.0, speed_mm_s)
        distance = float(np.linalg.norm(target[:3, 3]))
        if not reach.contains(distance):
            now = float(np.linalg.norm(world.nominal_arm.forward(here)[:3, 3]))
            raise Refused.beyond(_NAME, reach, now, distance)
        joints = reach_joints(world.nominal_arm, target, here)
        if joints is None:
            where = ", ".join(f"{value:.1f}" for value in target[:3, 3])
            raise Refused(_NAME, f"the arm cannot take this orientation at ({where}) mm. Choose another pose.")
        way = here + np.linspace(0.0, 1.0, _PATH_STEPS + 1)[:, None] * (joints - here)
        poses = world.nominal_arm.forward(way)
        legs = np.linalg.norm(np.diff(poses[:, :3, 3], axis=0), axis=1)
        turn_rad = float(np.abs(joints - here).max())
        if legs.sum() < _ARRIVED_MM and turn_rad < _ARRIVED_RAD:
            return joints, RobotPath(poses, 0.0, float(legs.sum()))
        # the fastest leg of the flange's way, and the fastest joint, keep to their limits at the peak of the motion
        duration = _PEAK * max(
            float(legs.max()) * _PATH_STEPS / min(speed_mm_s, MAX_SPEED_MM_S),
            turn_rad / world.plan.robot.joint_speed_rad_s,
        )
        return joints, RobotPath(poses, duration, float(legs.sum()))
