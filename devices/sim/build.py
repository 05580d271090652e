"""Puts a simulated cell together from a cell file and a blade."""

from __future__ import annotations

import tomllib
from collections.abc import Mapping
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np

from devices.cell_plan import CellPlan, plan_from, read_cell_file
from devices.clock import Clock, InstantClock
from devices.interfaces.cell import Cell
from devices.interfaces.stage import StagePosition
from devices.sim.geometry import Array, pose
from devices.sim.grinder import SimulatedGrinder
from devices.sim.operator import SimulatedOperator
from devices.sim.robot import SimulatedRobot
from devices.sim.scanner import SimulatedScanner
from devices.sim.settings import truth_settings
from devices.sim.stage import SimulatedStage
from devices.sim.world import World

RESOURCES = Path(__file__).resolve().parents[2] / "resources"
DEFAULT_CELL = RESOURCES / "cells" / "simulated.toml"
DEFAULT_BLADE = RESOURCES / "blades" / "dr95.step"

STRIDES = {"full": 1, "fine": 2, "demo": 4, "test": 8}


class Truth:
    """What the calibration should find; read from the world at the moment of asking."""

    def __init__(self, world: World) -> None:
        self._world = world

    @property
    def base_from_measure(self) -> Array:
        """(4, 4); {M} has x along the stage's true x axis and y in the plane of its true x and y axes."""
        return self._world.base_from_measure

    @property
    def measure_from_scanner(self) -> Array:
        """(4, 4) with all stage axes at zero."""
        return self.measure_from_scanner_at(StagePosition(0.0, 0.0, 0.0, 0.0))

    def measure_from_scanner_at(self, position: StagePosition) -> Array:
        """(4, 4) at a stage position; without the stage's repeatability."""
        return self._world.stage.measure_from_scanner(position)

    @property
    def stage_axes(self) -> Array:
        """(3, 3) columns: the stage's axes in {M}, direction times scale."""
        return self._world.stage.axes

    @property
    def rotary_axis(self) -> tuple[Array, Array]:
        """(direction, point in mm) of the rotary axis in {M}."""
        return self._world.stage.rotary_axis, self._world.stage.rotary_point_mm

    @property
    def ball_in_flange_mm(self) -> Array:
        """(3,) centre of the ball."""
        return self._world.ball_in_flange

    @property
    def ball_in_measure_mm(self) -> Array:
        """(3,) centre of the ball now."""
        flange = self._world.true_flange()
        base = flange[:3, :3] @ self._world.ball_in_flange + flange[:3, 3]
        measure = self._world.base_from_measure
        return np.asarray(measure[:3, :3].T @ (base - measure[:3, 3]))

    @property
    def tip_in_flange_mm(self) -> Array:
        """(3,) stylus tip."""
        return self._world.tip_in_flange

    @property
    def cone_in_base_mm(self) -> Array:
        """(3,) the cone."""
        return self._world.cone_in_base

    @property
    def flange_from_work(self) -> Array:
        """(4, 4) of the blade that is clamped now, with slip."""
        return self._world.flange_from_work

    @property
    def measure_from_work(self) -> Array:
        """(4, 4) of the blade where it is now."""
        world = self._world
        base_from_work = world.true_flange() @ world.flange_from_work
        return np.asarray(np.linalg.inv(world.base_from_measure) @ base_from_work)

    def base_from_tool(self, grinder: str) -> Array:
        """(4, 4) {H} of a grinder at head angle 0."""
        return self._world.base_from_tool(grinder)

    def head_axis(self, grinder: str) -> tuple[Array, Array]:
        """(point in mm, direction) of a grinder's head axis in {B}."""
        head = self._world.head(grinder)
        return head.axis_point, head.axis

    def airfoil_error_mm(self, u: Array, v: Array) -> Array:
        """True error of the airfoil along the design's outward normal at parameters (N,), mm (N,)."""
        airfoil = self._world.blade.airfoil
        points, _, _ = airfoil.point_and_tangents(np.asarray(u, dtype=float), np.asarray(v, dtype=float))
        design, normal = airfoil.design.at(u, v)
        return np.asarray(np.einsum("ij,ij->i", points - design, normal))


@dataclass(frozen=True, eq=False)
class SimulatedCell:
    """A simulated cell.

    Attributes:
        cell: Its devices, as a calibration step sees them.
        plan: What an engineer knows about it.
        world: What is really there; faults are switched at `world.faults`.
        truth: What calibration should find.
    """

    cell: Cell
    plan: CellPlan
    world: World
    truth: Truth


def build_simulated_cell(
    config_path: Path | None = None,
    blade_step: Path | None = None,
    *,
    seed: int = 0,
    resolution: int | str = "test",
    clock: Clock | None = None,
    truth: Mapping[str, Any] | None = None,
) -> SimulatedCell:
    """Build a simulated cell.

    Args:
        config_path: Cell file; None: the one that comes with the program.
        blade_step: STEP file of the blade type; a TOML file of the same name beside it gives the nominal clamping in
            `[rough_start]`. None: DR95.
        seed: Everything that is left to chance follows from it.
        resolution: `full` (3 million rays), `fine`, `demo`, `test`, or a stride in pixels.
        clock: None: simulated time that passes at once.
        truth: Imperfections to use instead of the file's, by dotted name, e.g. `{"scanner.noise_mm": 0.0}`;
            `devices.sim.settings.perfect()` switches all disturbances off.

    Raises:
        CellFileError: the cell file cannot be used.
        BladeFileError: the STEP file cannot be used.
    """
    config = config_path or DEFAULT_CELL
    step = blade_step or DEFAULT_BLADE
    data = read_cell_file(config)
    plan = plan_from(data, str(config))
    settings = truth_settings(data, str(config), truth or {})
    the_clock = clock or InstantClock()
    world = World(plan, settings, step, _clamping(step, plan), the_clock, seed)
    cell = Cell(
        scanner=SimulatedScanner(world, STRIDES[resolution] if isinstance(resolution, str) else resolution),
        stage=SimulatedStage(world),
        robot=SimulatedRobot(world),
        grinders={name: SimulatedGrinder(world, name) for name in plan.grinders},
        operator=SimulatedOperator(world),
        clock=the_clock,
    )
    return SimulatedCell(cell, plan, world, Truth(world))


def _clamping(step: Path, plan: CellPlan) -> Array:
    """Nominal flange_from_work: of the blade type where its file has one, else of the cell."""
    file = step.with_suffix(".toml")
    if file.is_file():
        start = tomllib.loads(file.read_text(encoding="utf-8")).get("rough_start")
        if start is not None:
            return pose(start["translation_mm"], start["euler_zyx_deg"])
    return plan.flange_from_work
