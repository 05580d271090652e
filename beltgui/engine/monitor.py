"""Looks at the devices several times a second: the strip of devices, where robot and stage are, who has dropped."""

from __future__ import annotations

import threading
import time
import traceback
from collections.abc import Callable, Mapping
from dataclasses import dataclass
from datetime import datetime

import numpy as np
from numpy.typing import NDArray

from beltgui.engine.guard import MotionGuard
from beltgui.engine.hosts import Host
from beltgui.engine.messages import CellMoved, Crashed, DevicesChanged, DeviceState, Event
from beltgui.engine.watch import Watch
from devices.interfaces import DeadlineExceeded, DeviceError, RobotReading, StagePosition, Stale

REST_S, MOVING_S = 0.2, 0.1
ANSWER_S = 0.3  # of wall time, after which a call counts as waiting
STILL = 1e-6  # mm and the elements of a rotation


@dataclass(frozen=True, eq=False)
class _Found:
    """One look at the cell."""

    robot: RobotReading | None
    stage: StagePosition | None
    errors: Mapping[str, DeviceError]


class Monitor:
    """A thread from `start` to `close`.

    Robot and stage are asked for their place, which neither disturbs a motion nor uses up chance of the simulation;
    scanner and heads are judged by their heartbeat, and whether a call of the work waits for them.

    Args:
        host: Provides the devices.
        watch: What the work's calls said.
        guard: Told when a device drops.
        emit: Shows events.
    """

    def __init__(self, host: Host, watch: Watch, guard: MotionGuard, emit: Callable[[Event], None]) -> None:
        self._host, self._watch, self._guard, self._emit = host, watch, guard, emit
        self._names = ("scanner", "stage", "robot", *(f"grinder {name}" for name in host.cell.grinders))
        self._lock = threading.Lock()
        self._failed: dict[str, DeviceError] = {}
        self._since: dict[str, str] = {}
        self._shown: DevicesChanged | None = None
        self._moved: CellMoved | None = None
        self._last: RobotReading | None = None
        self._wake = threading.Event()
        self._closed = False
        self._thread = threading.Thread(target=self._run, name="engine monitor", daemon=True)

    def start(self) -> None:
        """Begin to look."""
        self._thread.start()

    def look_now(self) -> None:
        """Do not wait for the next time."""
        self._wake.set()

    def close(self) -> None:
        """End; does not wait."""
        self._closed = True
        self._wake.set()

    def join(self, timeout_s: float) -> bool:
        """Wait for the thread's end; whether it has ended."""
        self._thread.join(timeout_s)
        return not self._thread.is_alive()

    def check(self) -> None:
        """Before a motion: raise where a device that was found dropped still is.

        Raises:
            DeviceError: of that device.
        """
        with self._lock:
            failed = dict(self._failed)
        for device in failed:
            self._host.heartbeat(device)
            if device == "robot":
                self._host.cell.robot.read(deadline_s=ANSWER_S)
            elif device == "stage":
                self._host.cell.stage.position(deadline_s=ANSWER_S)
            with self._lock:
                self._failed.pop(device, None)

    def _run(self) -> None:
        try:
            while not self._closed:
                moving = self._look()
                self._wake.wait(MOVING_S if moving else REST_S)
                self._wake.clear()
        except Exception:
            self._emit(Crashed(f"The monitor of the devices has ended.\n{traceback.format_exc()}"))
            # nobody would notice a dropped device any more
            self._guard.stop()

    def _look(self) -> bool:
        found = self._ask_all()
        failed = {name: error for name, error in found.errors.items() if not isinstance(error, DeadlineExceeded)}
        with self._lock:
            self._failed = failed
        for error in failed.values():
            self._guard.device_failed(error)
        for name in self._names:
            if name not in found.errors:
                self._since.pop(name, None)
        strip = DevicesChanged(tuple(self._state(name, found.errors.get(name)) for name in self._names))
        if strip != self._shown:
            self._shown = strip
            self._emit(strip)
        self._show_places(found)
        return self._guard.moving or bool(found.robot and found.robot.moving)

    def _ask_all(self) -> _Found:
        errors: dict[str, DeviceError] = {}
        robot: RobotReading | None = None
        stage: StagePosition | None = None
        for name in self._names:
            try:
                self._host.heartbeat(name)
                if name == "robot":
                    robot = self._host.cell.robot.read(deadline_s=ANSWER_S)
                elif name == "stage":
                    stage = self._host.cell.stage.position(deadline_s=ANSWER_S)
            except DeviceError as error:
                errors[name] = error
        return _Found(robot, stage, errors)

    def _state(self, name: str, error: DeviceError | None) -> DeviceState:
        if isinstance(error, DeadlineExceeded):
            return DeviceState(name, "waiting", error.message)
        if error is not None:
            since = self._since.setdefault(name, datetime.now().astimezone().strftime("%H:%M:%S"))
            if isinstance(error, Stale):
                return DeviceState(name, "stale", f"since {since}: {error.message}")
            return DeviceState(name, "fault", error.message)
        doing = self._watch.doing(name)
        if doing.what and not doing.moving and time.monotonic() - doing.since_s > ANSWER_S:
            return DeviceState(name, "waiting", doing.what)
        healthy = "simulated" if self._host.simulated else "connected"
        return DeviceState(name, healthy, doing.what if doing.moving else "")

    def _show_places(self, found: _Found) -> None:
        if found.robot is None or found.stage is None:
            return
        robot, stage = found.robot, found.stage
        readings = self._watch.readings()
        place = CellMoved(
            robot.base_from_flange, (stage.x_mm, stage.y_mm, stage.z_mm, float(np.degrees(stage.theta_rad))),
            robot.moving, self._speed(robot),
            {name: float(np.degrees(reading.angle_rad)) for name, reading in readings.items()},
            {name: reading.force_N for name, reading in readings.items()},
        )  # fmt: skip
        if self._moved is None or _differ(self._moved, place):
            self._moved = place
            self._emit(place)

    def _speed(self, robot: RobotReading) -> float:
        last, self._last = self._last, robot
        if last is None or not robot.moving or robot.time_s <= last.time_s:
            return 0.0
        way = float(np.linalg.norm(robot.base_from_flange[:3, 3] - last.base_from_flange[:3, 3]))
        return way / (robot.time_s - last.time_s)


def _differ(one: CellMoved, other: CellMoved) -> bool:
    rest = (one.moving, one.head_deg, one.force_n) != (other.moving, other.head_deg, other.force_n)
    if rest or _far(one.base_from_flange, other.base_from_flange):
        return True
    return _far(np.array(one.stage), np.array(other.stage))


def _far(one: NDArray[np.float64], other: NDArray[np.float64]) -> bool:
    return bool(np.abs(one - other).max() > STILL)
