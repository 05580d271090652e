"""Simulated head sensors: the contact of the true wheel with the true blade, quantised, noisy, sometimes wrong."""

from __future__ import annotations

import numpy as np

from devices.interfaces.errors import DeadlineExceeded
from devices.interfaces.grinder import GrinderReading
from devices.interfaces.limits import Limit
from devices.sim.world import World

_FORCE_LIMIT_N = 200.0
_TOUCHING_N = 5.0


class SimulatedGrinder:
    """The sensors of one simulated grinder (a `GrinderSensors`)."""

    def __init__(self, world: World, name: str) -> None:
        self._world = world
        self._name = name
        self._device = f"grinder {name}"

    @property
    def limits(self) -> tuple[Limit, ...]:
        """Travel of the head (rad) and range of the force sensor (N)."""
        low, high = self._world.plan.grinders[self._name].travel_rad
        angle = Limit(f"{self._device} angle", low, high, "rad")
        return (angle, Limit(f"{self._device} force", 0.0, _FORCE_LIMIT_N, "N"))

    def read(self, *, deadline_s: float = 0.1) -> GrinderReading:
        """Read the newest sample; see `GrinderSensors.read`."""
        world, settings = self._world, self._world.settings.grinder
        world.faults.check(self._device)
        rng = world.rng(self._device)
        # all draws are made whatever happens, so that one lost sample does not shift the chance of the next ones
        lost, bounced, sign = rng.uniform(size=3)
        bounce_mm = rng.uniform(settings.bounce_low_mm, settings.bounce_high_mm)
        angle_noise, force_noise = rng.normal(size=2)
        angle, force = self._true_angle_and_force()
        touching = force > _TOUCHING_N  # the belt runs only then: it is what disturbs head and bus
        if touching and lost < settings.lost_share:
            world.clock.wait(deadline_s)
            raise DeadlineExceeded(self._device, f"no sample came within {deadline_s:g} s. Ask again.")
        if touching and bounced < settings.bounce_share:
            angle += (1.0 if sign < 0.5 else -1.0) * bounce_mm / world.plan.grinders[self._name].head_radius_mm
        angle += angle_noise * np.deg2rad(settings.angle_noise_deg) + world.faults.angle_zero_rad.get(self._name, 0.0)
        step = 2.0 * np.pi / 2**settings.angle_bits
        force = max(0.0, force + force_noise * settings.force_noise_n)
        return GrinderReading(world.clock.now_s(), float(np.round(angle / step) * step), float(force))

    def _true_angle_and_force(self) -> tuple[float, float]:
        world, settings = self._world, self._world.settings.grinder
        held = world.held_angle_rad.get(self._name)
        if held is not None:
            return held, 0.0
        rest = world.rest_angle(self._name)
        if world.mounted.item != "blade":
            return rest, 0.0
        contact = world.contact(self._name, world.true_flange())
        if contact is None:
            return rest, 0.0
        return contact.angle_rad, settings.force_rest_n + settings.force_n_per_rad * abs(contact.angle_rad - rest)
