"""Simulated stage: takes its time, repeats to a few micrometres, reports its scales."""

from __future__ import annotations

import threading
from dataclasses import replace

import numpy as np

from devices.interfaces.errors import DeadlineExceeded, Refused, Stopped
from devices.interfaces.limits import Limit
from devices.interfaces.stage import StagePosition
from devices.sim.geometry import Array
from devices.sim.world import World

_TICK_S = 0.05
_SETTLE_S = 0.1
_NAME = "stage"


class SimulatedStage:
    """The stage of a simulated cell (a `Stage`).

    Example:
        >>> from devices.sim import build_simulated_cell
        >>> stage = build_simulated_cell().cell.stage
        >>> stage.home()
        >>> stage.move_to(StagePosition(10.0, 0.0, 0.0)).x_mm
        10.0
    """

    def __init__(self, world: World) -> None:
        self._world = world
        self._reported = StagePosition(0.0, 0.0, 0.0, 0.0)
        self._moving = False
        self._homed = False
        self._stop = threading.Event()

    @property
    def limits(self) -> tuple[Limit, Limit, Limit, Limit]:
        """Travel of x, y, z (mm) and theta (rad)."""
        plan = self._world.plan.stage
        return (
            Limit("stage x", *plan.x_mm, "mm"),
            Limit("stage y", *plan.y_mm, "mm"),
            Limit("stage z", *plan.z_mm, "mm"),
            Limit("stage theta", *plan.theta_rad, "rad"),
        )

    @property
    def homed(self) -> bool:
        """False after power-up or loss."""
        return self._homed

    def home(self, *, deadline_s: float = 60.0) -> None:
        """Find the reference marks and go to zero."""
        self._check_connection()
        self._homed = True
        self._travel(StagePosition(0.0, 0.0, 0.0, 0.0), deadline_s)

    def position(self, *, deadline_s: float = 1.0) -> StagePosition:
        """Read the scales."""
        self._check_connection()
        return replace(self._reported, time_s=self._world.clock.now_s(), moving=self._moving)

    def move_to(self, target: StagePosition, *, deadline_s: float = 60.0) -> StagePosition:
        """Move all axes at once; see `Stage.move_to`."""
        self._check_connection()
        if not self._homed:
            raise Refused(_NAME, "the axes have no reference yet. Home the stage first.")
        now, then = _values(self._reported), _values(target)
        for limit, current, value in zip(self.limits, now, then, strict=True):
            if not limit.contains(value):
                raise Refused.beyond(_NAME, limit, current, value)
        self._travel(target, deadline_s)
        return self.position()

    def stop(self) -> None:
        """Stop all axes; may be called from another thread."""
        self._stop.set()

    def _travel(self, target: StagePosition, deadline_s: float) -> None:
        world, plan = self._world, self._world.plan.stage
        begin, start, end = world.clock.now_s(), np.array(_values(self._reported)), np.array(_values(target))
        speeds = np.array([plan.speed_mm_s] * 3 + [plan.speed_rad_s])
        duration = float((np.abs(end - start) / speeds).max()) + _SETTLE_S
        self._stop.clear()
        self._moving = True
        try:
            while (passed := world.clock.now_s() - begin) < duration:
                self._place(start + (end - start) * min(1.0, passed / duration))
                self._check_connection()
                if self._stop.is_set():
                    raise Stopped(_NAME, "stopped on the way. Check that the way is free, then move again.")
                if passed > deadline_s:
                    raise DeadlineExceeded(_NAME, f"not at its target within {deadline_s:g} s, stopped.")
                world.clock.wait(min(_TICK_S, duration - passed + 1e-6))
            self._place(end, settled=True)
        finally:
            self._moving = False

    def _place(self, values: Array, *, settled: bool = False) -> None:
        noise = np.zeros(4)
        if settled:  # drawn once per move: how often the clock ticked on the way must not change what follows
            settings = self._world.settings.stage
            size = [settings.repeatability_mm] * 3 + [np.deg2rad(settings.repeatability_deg)]
            noise = self._world.rng(_NAME).normal(0.0, 1.0, 4) * size
        self._reported = _position(values)
        self._world.stage_position = _position(values + noise)

    def _check_connection(self) -> None:
        try:
            self._world.faults.check(_NAME)
        except Exception:
            self._homed = False
            raise


def _position(values: Array) -> StagePosition:
    x, y, z, theta = (float(value) for value in values)
    return StagePosition(x, y, z, theta)


def _values(position: StagePosition) -> tuple[float, float, float, float]:
    return position.x_mm, position.y_mm, position.z_mm, position.theta_rad
