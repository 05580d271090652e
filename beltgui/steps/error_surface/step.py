"""Error surface: from probed head angles to the normal error over the airfoil, the compensated path and its program."""

from __future__ import annotations

import re
from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any

import numpy as np

from beltgui.steps.blocks import degrees, plain, verdict_block
from beltgui.steps.error_surface.probing import Presenting, Probe, ProbeSamples
from beltgui.steps.error_surface.record import record as surface_record
from beltgui.steps.fine import step as fine
from beltgui.steps.fine.step import FineOutcome
from beltgui.steps.head_rest import HeadRest
from beltgui.steps.held_out import HeldOut
from core.cad.blade_type import ProbingGrid
from core.error_surface import (
    ErrorSurface,
    ErrorSurfaceLimits,
    fit_error_surface,
    judge_error_surface,
    normal_error,
)
from core.path import (
    PathPlan,
    PatternSettings,
    ProgramProof,
    ProgramSettings,
    plan_path,
    verify_program,
    write_urscript,
)
from core.verdict import Verdict

HELD_OUT_LIMIT_MM = 0.04
TRANSVERSE_LINES = 6
LONGITUDINAL_LINES = 9
_SPEED = re.compile(r"^\s*movel\(.*, v=([0-9.]+),", re.MULTILINE)


@dataclass(frozen=True, eq=False)
class Measured:
    """What the probed points say.

    Attributes:
        surface: Normal error over (u, v).
        held_out: Errors at points between the grid's nodes that the fit has not seen.
        head_rest: Whether the angle sensor's zero is where the tool step found it.
        verdict: Of these, and of the clamping that they stand on.
    """

    surface: ErrorSurface
    held_out: HeldOut
    head_rest: HeadRest
    verdict: Verdict


@dataclass(frozen=True, eq=False)
class Program:
    """A robot program with its plan and the proof that the text says what was planned."""

    name: str
    plan: PathPlan
    text: str
    proof: ProgramProof

    @property
    def length_mm(self) -> float:
        """Way of the contact over the blade, all strokes."""
        return float(sum(_way_mm(stroke.work_from_contact) for stroke in self.plan.strokes))

    @property
    def largest_speed_mm_s(self) -> float:
        """Largest speed of the flange that the text asks for."""
        return max(read_speeds(self.text))

    @property
    def duration_s(self) -> float:
        """From the first approach to the last retreat at the speeds of the text; acceleration is not counted."""
        poses, speeds = self.plan.robot_poses(), np.array(read_speeds(self.text))
        return float(np.sum(np.linalg.norm(np.diff(poses[:, :3, 3], axis=0), axis=1) / speeds[1:]))


@dataclass(frozen=True, eq=False)
class ErrorSurfaceOutcome:
    """What the step found.

    Attributes:
        surface: Normal error over (u, v).
        held_out: Errors at points between the grid's nodes that the fit has not seen.
        head_rest: Whether the angle sensor's zero is where the tool step found it.
        clamped_again: Registration of the blade as it was clamped for probing.
        presenting: The chain that presented the blade; errors and programs belong to it.
        apart_mm: How far the frames of the steps before, as they are now, would move the blade at the wheel.
        at_end: Registration by scans after the last line; None if there are none.
        complete: All planned lines are there, and what has to be done after the last one is done.
        programs: Robot programs by name; none unless all is accepted.
        verdict: Of all of it.
    """

    surface: ErrorSurface
    held_out: HeldOut
    head_rest: HeadRest
    clamped_again: FineOutcome
    presenting: Presenting
    apart_mm: float
    at_end: FineOutcome | None
    complete: bool
    programs: Mapping[str, Program]
    verdict: Verdict


def solve(
    samples: ProbeSamples,
    radius_mm: float,
    normal_in_tool: np.ndarray,
    info: dict[str, str],
    clamping: Verdict,
    rests_in_tool_step_rad: tuple[float, ...],
) -> Measured:
    """Fit the surface to the grid and check it between the nodes.

    Args:
        samples: Probed angles; NaN where none came.
        radius_mm: Rg of the grinder.
        normal_in_tool: (3,) airfoil's outward normal at the contact, in {H}.
        info: Blade type, grinder and the like, kept with the surface.
        clamping: Verdict of the registration that the probing stands on.
        rests_in_tool_step_rad: What the angle sensor read at the head's stop in the tool step.

    Raises:
        InputError: too few samples, or they determine no surface.
    """
    surface = fit_error_surface(
        samples.grid.u, samples.grid.v, errors_of(samples.grid, radius_mm, normal_in_tool), mode="smooth", info=info
    )
    check = errors_of(samples.check, radius_mm, normal_in_tool)
    predicted = surface.evaluate(samples.check.u, samples.check.v)
    known = np.isfinite(check) & np.isfinite(predicted)
    held_out = HeldOut("normal error between the samples", np.abs(check - predicted)[known], HELD_OUT_LIMIT_MM)
    rest = HeadRest(samples.grinder, radius_mm, rests_in_tool_step_rad, samples.rests_rad)
    reasons = [
        *clamping.reasons,
        *rest.reasons(),
        *judge_error_surface(surface, ErrorSurfaceLimits()).reasons,
        *held_out.reasons("Probe a finer grid, and see that the head moves freely."),
    ]
    return Measured(surface, held_out, rest, Verdict.of(reasons))


def read_speeds(text: str) -> list[float]:
    """Speed of each move of a program's text, mm/s."""
    return [1000.0 * float(found) for found in _SPEED.findall(text)]


def _way_mm(frames: np.ndarray) -> float:
    return float(np.linalg.norm(np.diff(frames[:, :3, 3], axis=0), axis=1).sum())


def errors_of(probe: Probe, radius_mm: float, normal_in_tool: np.ndarray) -> np.ndarray:
    """Normal errors (N,) in mm of probed points; NaN where no reading came."""
    errors = np.full(len(probe.u), np.nan)
    read = np.isfinite(probe.angle_rad)
    errors[read] = normal_error(probe.angle_rad[read], normal_in_tool, radius_mm)
    return errors


def patterns(grid: ProbingGrid) -> dict[str, PatternSettings]:
    """The usual two: along the profile at six heights of the grid, and along the span."""
    rows = np.linspace(0, grid.v_count - 1, TRANSVERSE_LINES).round().astype(int)
    u_range, v_range = (grid.u_min, grid.u_max), (grid.v_min, grid.v_max)
    heights = tuple(float(v) for v in grid.v()[rows])
    return {
        "transverse": PatternSettings("transverse", u_range, v_range, positions=heights),
        "longitudinal": PatternSettings("longitudinal", u_range, v_range, count=LONGITUDINAL_LINES),
    }


def write_program(
    name: str, presenting: Presenting, surface: ErrorSurface, pattern: PatternSettings, *, blade_type: str, date: str
) -> Program:
    """Plan a compensated path, write it as URScript and read it back.

    Args:
        name: Name of the program.
        presenting: The calibrated chain to the wheel.
        surface: What to compensate; points outside its measured patch are left out.
        pattern: Which lines.
        blade_type: For the program's header.
        date: For the program's header.

    Raises:
        InputError: the path was measured nowhere, or the text read back does not say what was planned.
    """
    plan = plan_path(presenting.airfoil, presenting.frames, pattern, error_surface=surface, clip=True)
    text = write_urscript(plan, ProgramSettings(name=name, blade_type=blade_type, date=date))
    return Program(name, plan, text, verify_program(plan, text))


def headline(outcome: ErrorSurfaceOutcome) -> str:
    """The number that matters."""
    return f"held-out error {outcome.held_out.rms_mm:.3f} mm RMS"


def record(outcome: ErrorSurfaceOutcome) -> dict[str, Any]:
    """For the session and the report."""
    return {
        **surface_record(outcome.surface, outcome.verdict),
        "held_out": plain(outcome.held_out.block()),
        "head_rest": plain(outcome.head_rest.block()),
        "grinder": outcome.presenting.grinder,
        "frames_apart_mm": plain(outcome.apart_mm),
        "clamped_again": fine.record(outcome.clamped_again),
        "after_probing": None if outcome.at_end is None else fine.record(outcome.at_end),
        "programs": {name: program_figures(program) for name, program in outcome.programs.items()},
        "verdict": verdict_block(outcome.verdict),
    }


def program_figures(program: Program) -> dict[str, Any]:
    """A program in figures; lengths of the contact's way on the blade."""
    plan, proof = program.plan, program.proof
    return {
        "strokes": len(plan.strokes),
        "contacts": plan.points,
        "trimmed_points": plan.trimmed_points,
        "length_mm": plain(program.length_mm),
        "duration_s": plain(program.duration_s),
        "largest_speed_mm_s": plain(program.largest_speed_mm_s),
        "proof": {"poses": proof.poses, "max_position_mm": proof.max_position_mm,
                  "max_rotation_deg": degrees(proof.max_rotation_rad), "max_contact_mm": proof.max_contact_mm},
    }  # fmt: skip
