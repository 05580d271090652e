"""A simulated cell with a session, and what earlier steps would have found, quickly made from the truth."""

from collections.abc import Callable
from contextlib import AbstractContextManager
from dataclasses import dataclass, replace
from pathlib import Path
from typing import Any, Self

import numpy as np

from beltgui.jobs import Job
from beltgui.session import Session
from beltgui.steps.context import Context
from core.ball import StageFit, StageObservations, solve_stage
from core.base import BaseFit, solve_base
from core.cad import CadModel, read_step
from core.cad.blade_type import BladeType, read_blade_type
from core.frames import inverse, transform_points
from devices.sim import SimulatedCell, build_simulated_cell
from resources import blade_type_path

BALL_IN_MEASURE = np.array([5.0, -4.0, 225.0])


class Hooked:
    """Stands in for a device and calls back before one of its methods; everything else goes through."""

    def __init__(self, device: Any, method: str, before: Callable[[int], None]) -> None:
        self._device, self._method, self._before = device, method, before
        self.calls = 0

    def __getattr__(self, name: str) -> Any:
        value = getattr(self._device, name)
        if name != self._method:
            return value

        def call(*words: Any, **named: Any) -> Any:
            self._before(self.calls)
            self.calls += 1
            return value(*words, **named)

        return call


@dataclass(eq=False)
class Live(AbstractContextManager["Live"]):
    """The cell, a fresh session and a context; `hook` replaces a device by one that calls back."""

    sim: SimulatedCell
    context: Context

    @classmethod
    def start(cls, folder: Path, *, seed: int = 0, consent: Callable[..., bool] = lambda path, purpose: True) -> Self:
        blade, _ = blade_and_model()
        sim = build_simulated_cell(None, blade.step_path, seed=seed, resolution="test")
        session = Session.create(folder, {"software": "test"})
        return cls(sim, Context(sim.cell, sim.plan, blade, "DR95-0001", session, consent))

    def __exit__(self, *exception: object) -> None:
        self.context.session.close()

    @property
    def session(self) -> Session:
        return self.context.session

    def hook(self, device: str, method: str, before: Callable[[int], None]) -> None:
        """Call `before(number of the call)` before each call of a device's method."""
        cell = self.context.cell
        self.context = replace(
            self.context, cell=replace(cell, **{device: Hooked(getattr(cell, device), method, before)})
        )

    def hook_grinder(self, name: str, before: Callable[[int], None]) -> None:
        """The same for the sensors of a grinder."""
        cell = self.context.cell
        grinders = {**cell.grinders, name: Hooked(cell.grinders[name], "read", before)}
        self.context = replace(self.context, cell=replace(cell, grinders=grinders))

    def with_job(self, job: Job) -> Context:
        return replace(self.context, job=job)

    def stage_fit(self) -> StageFit:
        """What a ball step without any noise would find."""
        poses = [pose.stage for pose in self.sim.plan.stage_step]
        seen = [
            transform_points(inverse(self.sim.truth.measure_from_scanner_at(pose)), BALL_IN_MEASURE) for pose in poses
        ]
        return solve_stage(
            StageObservations(
                np.array([[pose.x_mm, pose.y_mm, pose.z_mm] for pose in poses]),
                np.array([pose.theta_rad for pose in poses]),
                np.array(seen),
                np.full(len(poses), 0.01),
            )
        )

    def base_fit(self) -> BaseFit:
        """What a base step with an ideal robot would find."""
        truth = self.sim.truth
        flanges = np.array([pose.base_from_flange for pose in self.sim.plan.base_step])
        balls = [transform_points(inverse(truth.base_from_measure) @ flange, truth.ball_in_flange_mm)
                 for flange in flanges]
        return solve_base(flanges, np.array(balls), robot_sigma_mm=0.1)


_loaded: list[tuple[BladeType, CadModel]] = []


def blade_and_model() -> tuple[BladeType, CadModel]:
    """DR95, read once per process: reading STEP takes a second."""
    if not _loaded:
        blade = read_blade_type(blade_type_path("dr95"))
        _loaded.append((blade, read_step(blade.step_path)))
    return _loaded[0]
