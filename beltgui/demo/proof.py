"""The proof that matters: normal error left on the airfoil along the nominal and the compensated path."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from beltgui.jobs import Job
from beltgui.steps.error_surface.step import Program
from devices.sim import World

Array = NDArray[np.float64]
POINTS_PER_STROKE = 30


@dataclass(frozen=True, eq=False)
class StrokeProof:
    """True normal errors along one stroke.

    Attributes:
        u: (N,) around the profile; nowhere near the probing grid's nodes but by chance.
        v: (N,) along the span.
        nominal_mm: (N,) with the blade on the design path.
        compensated_mm: (N,) with the blade on the compensated path.
    """

    u: Array
    v: Array
    nominal_mm: Array
    compensated_mm: Array


@dataclass(frozen=True, eq=False)
class Proof:
    """All strokes of all programs."""

    strokes: Mapping[str, tuple[StrokeProof, ...]]

    @property
    def nominal_rms_mm(self) -> float:
        """RMS over all points, design path."""
        return _rms(np.concatenate([stroke.nominal_mm for part in self.strokes.values() for stroke in part]))

    @property
    def compensated_rms_mm(self) -> float:
        """RMS over all points, compensated path."""
        return _rms(np.concatenate([stroke.compensated_mm for part in self.strokes.values() for stroke in part]))

    @property
    def compensated_worst_mm(self) -> float:
        """Largest absolute value on the compensated path."""
        return float(max(np.abs(stroke.compensated_mm).max() for part in self.strokes.values() for stroke in part))


def prove(world: World, grinder: str, programs: Mapping[str, Program], job: Job) -> Proof:
    """Present the blade along both paths in the simulated world and look where the wheel really goes.

    The world applies the robot's true kinematics, the true clamping, wheel and airfoil; no sensor is involved.
    """
    strokes: dict[str, tuple[StrokeProof, ...]] = {}
    total = sum(len(program.plan.strokes) for program in programs.values())
    done = 0
    for name, program in programs.items():
        found = []
        for stroke in program.plan.strokes:
            job.report(done / total, f"checking the path {name}")
            chosen = np.unique(np.linspace(0, len(stroke.u) - 1, POINTS_PER_STROKE).round().astype(int))
            nominal = [world.true_normal_error(grinder, pose) for pose in stroke.nominal_base_from_flange[chosen]]
            moved = [world.true_normal_error(grinder, pose) for pose in stroke.base_from_flange[chosen]]
            found.append(StrokeProof(stroke.u[chosen], stroke.v[chosen], np.array(nominal), np.array(moved)))
            done += 1
        strokes[name] = tuple(found)
    return Proof(strokes)


def _rms(values: Array) -> float:
    return float(np.sqrt(np.mean(values**2)))
