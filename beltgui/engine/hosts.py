"""Who provides the cell's devices: for now the simulation.

It stands still while no engine runs, as a real cell does.
"""

from __future__ import annotations

import json
import threading
from collections.abc import Mapping
from pathlib import Path
from typing import Any, Protocol

import numpy as np

from beltgui.engine.faults import FAULTS
from beltgui.files import write_atomically
from core.errors import InputError
from devices.cell_plan import CellFileError, CellPlan
from devices.clock import InstantClock, RealClock
from devices.interfaces import Cell, Mount

STATE = "simulated_cell.json"


class Host(Protocol):
    """Provides a cell."""

    @property
    def cell(self) -> Cell:
        """The devices, without any guard."""
        ...

    @property
    def plan(self) -> CellPlan:
        """What is known about the cell."""
        ...

    @property
    def simulated(self) -> bool:
        """The devices are not real."""
        ...

    @property
    def mounted(self) -> Mount | None:
        """What is on the flange, if that is known."""
        ...

    def heartbeat(self, device: str) -> None:
        """Find out without disturbing the work whether a device is there.

        Raises:
            DeviceError: it is not.
        """
        ...

    def simulate(self, fault: str) -> None:
        """Let something go wrong.

        Raises:
            InputError: there is no such fault.
        """
        ...

    def remember(self) -> None:
        """Keep how the cell stands, for the next engine; a real cell does that by itself."""
        ...


class SimulatedHost:
    """The simulated cell of a session's folder; it goes on where it stood when the engine ended.

    Without that, a session that is gone on with would be about another clamping of the blade, another pose of the
    robot and noise that repeats itself.

    Args:
        folder: Of the session; the state is kept there.
        cell_file: Cell file.
        blade_step: STEP file of the blade type.
        info: What the session says of itself: `seed`, `resolution`, `speed`.

    Raises:
        InputError: an input cannot be used.
    """

    def __init__(self, folder: Path, cell_file: Path, blade_step: Path, info: Mapping[str, Any]) -> None:
        from devices.sim import build_simulated_cell
        from devices.sim.blade import BladeFileError

        speed = float(info.get("speed", 0.0))
        try:
            simulated = build_simulated_cell(
                cell_file, blade_step, seed=int(info.get("seed", 0)), resolution=info.get("resolution", "demo"),
                clock=RealClock(speed) if speed > 0.0 else InstantClock(),
            )  # fmt: skip
        except (CellFileError, BladeFileError) as error:
            raise InputError(str(error)) from error
        self._file = folder / STATE
        self._lock = threading.Lock()
        self.world = simulated.world
        self.truth = simulated.truth
        self.plan = simulated.plan
        self._mounts: list[Mount] = []
        self.cell = Cell(
            simulated.cell.scanner, simulated.cell.stage, simulated.cell.robot, simulated.cell.grinders,
            _Hand(simulated.cell.operator, self._mounts), simulated.cell.clock,
        )  # fmt: skip
        if self._file.exists():
            self._recall()

    simulated = True

    @property
    def mounted(self) -> Mount | None:
        """What is on the flange."""
        return self._mounts[-1] if self._mounts else None

    def heartbeat(self, device: str) -> None:
        """Raises `Lost` or `Stale` while that fault is on."""
        self.world.faults.check(device)

    def simulate(self, fault: str) -> None:
        """Let something go wrong, see `beltgui.engine.faults`.

        Raises:
            InputError: there is no such fault.
        """
        if fault not in FAULTS:
            raise InputError(f"There is no fault '{fault}' to simulate; there are: {', '.join(FAULTS)}.")
        with self.world.lock:
            FAULTS[fault](self.world.faults)

    def remember(self) -> None:
        """Write the state beside the session."""
        world, faults = self.world, self.world.faults
        with self._lock, world.lock:
            state = {
                "mounts": [[mount.item, mount.serial] for mount in self._mounts],
                "joints_rad": world.joints().tolist(),
                "repeatability": world.motion.noise.tolist(),
                "held_angle_rad": dict(world.held_angle_rad),
                "ball_moved_mm": faults.ball_moved_mm.tolist(),
                "blade_slip": faults.blade_slip.tolist(),
                "wheel_wear_mm": dict(faults.wheel_wear_mm),
                "angle_zero_rad": dict(faults.angle_zero_rad),
                "chance": {name: world.rng(name).bit_generator.state for name in self._streams()},
            }
            write_atomically(self._file, json.dumps(state).encode())

    def _recall(self) -> None:
        from devices.sim.world import Motion

        world, faults = self.world, self.world.faults
        try:
            state = json.loads(self._file.read_text(encoding="utf-8"))
            for item, serial in state["mounts"]:
                world.mount(item, serial)  # each clamping of a blade is another one: their number counts
                self._mounts.append(Mount(item, serial))
            joints = np.array(state["joints_rad"], dtype=float)
            world.motion = Motion(joints, joints, world.clock.now_s(), 0.0, np.array(state["repeatability"]))
            world.held_angle_rad.update(state["held_angle_rad"])
            faults.ball_moved_mm = np.array(state["ball_moved_mm"])
            faults.blade_slip = np.array(state["blade_slip"])
            faults.wheel_wear_mm = dict(state["wheel_wear_mm"])
            faults.angle_zero_rad = dict(state["angle_zero_rad"])
            for name in self._streams():
                world.rng(name).bit_generator.state = state["chance"][name]
        except (ValueError, KeyError, TypeError, OSError) as error:
            raise InputError(f"{self._file}: the state of the simulated cell cannot be read ({error!r}). Remove the "
                             "file; the simulated cell then begins anew.") from error

    def _streams(self) -> tuple[str, ...]:
        return ("stage", "robot", "scanner", "operator", *(f"grinder {name}" for name in self.plan.grinders))


class _Hand:
    """The simulated operator; what he has mounted is noted, and what is on the flange already stays there."""

    def __init__(self, operator: Any, mounts: list[Mount]) -> None:
        self._operator, self._mounts = operator, mounts

    def perform(self, request: Any, *, deadline_s: float = 600.0) -> None:
        """Do what is asked; a blade that is clamped already is not clamped anew, but looked at."""
        if isinstance(request, Mount) and self._mounts and self._mounts[-1] == request:
            return
        self._operator.perform(request, deadline_s=deadline_s)
        if isinstance(request, Mount):
            self._mounts.append(request)
