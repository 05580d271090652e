"""Simulated person: mounts things, guides the stylus into the cone and onto the wheel's shaft, not quite steadily."""

from __future__ import annotations

import numpy as np

from devices.interfaces.errors import DeadlineExceeded, Refused
from devices.interfaces.operator import Mount, Request, TouchCone, TouchShaft
from devices.sim.geometry import Array, random_unit, rigid, turn
from devices.sim.kinematics import reach_joints
from devices.sim.world import World

_NAME = "operator"


class SimulatedOperator:
    """The person of a simulated cell (an `Operator`)."""

    def __init__(self, world: World) -> None:
        self._world = world

    def perform(self, request: Request, *, deadline_s: float = 600.0) -> None:
        """Do what is asked; see `Operator.perform`."""
        world = self._world
        action_s = world.settings.operator.action_s
        if action_s > deadline_s:
            world.clock.wait(deadline_s)
            raise DeadlineExceeded(_NAME, f"nobody confirmed within {deadline_s:g} s: {request.instruction}")
        world.clock.wait(action_s)
        if isinstance(request, Mount):
            world.mount(request.item, request.serial)
            return
        if world.mounted.item != "stylus":
            raise Refused(_NAME, f"the {world.mounted.item} is on the flange. Ask for the stylus to be mounted first.")
        if isinstance(request, TouchCone):
            touches = world.plan.stylus.touches
            near = request.near if request.near is not None else touches[request.index % len(touches)]
            self._touch(near, world.cone_in_base)
        else:
            self._touch_shaft(request)

    def _touch_shaft(self, request: TouchShaft) -> None:
        world, rng = self._world, self._world.rng(_NAME)
        if request.grinder not in world.plan.grinders:
            raise Refused(_NAME, f"there is no grinder {request.grinder}; there are {', '.join(world.plan.grinders)}.")
        plan = world.plan.grinders[request.grinder]
        angle = request.head_angle_rad
        if not plan.travel_rad[0] <= angle <= plan.travel_rad[1]:
            low, high = np.rad2deg(plan.travel_rad)
            raise Refused(
                _NAME, f"the head of grinder {request.grinder} turns from {low:.1f} to {high:.1f} degrees, "
                f"{np.rad2deg(angle):.1f} degrees was asked for. Choose another angle.",
            )  # fmt: skip
        held = angle + rng.normal() * np.deg2rad(world.settings.operator.head_angle_deg) if angle else angle
        self._touch(request.near if request.near is not None else plan.touch_from_flange,
                    world.shaft_mark(request.grinder, held))  # fmt: skip
        world.held_angle_rad[request.grinder] = held

    def _touch(self, near: Array, point_in_base: Array) -> None:
        """Bring the true tip to a point, with about this orientation of the flange."""
        world, settings, rng = self._world, self._world.settings.operator, self._world.rng(_NAME)
        tilt = random_unit(rng) * abs(rng.normal()) * np.deg2rad(settings.hand_tilt_deg)
        goal = point_in_base + rng.normal(0.0, 1.0, 3) * settings.touch_mm
        orientation = turn(tilt) @ near[:3, :3]
        flange = rigid(orientation, goal - orientation @ world.tip_in_flange)
        joints = world.joints()
        for _ in range(8):
            found = reach_joints(world.nominal_arm, flange, joints)
            if found is None:
                raise Refused(_NAME, "the arm cannot be guided there with this orientation. Choose another one.")
            joints = found
            true = world.true_arm.forward(joints)
            miss = goal - (true[:3, :3] @ world.tip_in_flange + true[:3, 3])
            flange = flange.copy()
            flange[:3, 3] += miss
            if np.linalg.norm(miss) < 1e-7:
                break
        motion = world.arrive(joints, 0.0)
        # a guided arm has no repeatability of its own: the tip rests where the person put it
        world.motion = type(motion)(motion.start_rad, motion.end_rad, motion.begin_s, 0.0, np.eye(4))
