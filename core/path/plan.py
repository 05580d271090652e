"""From pattern and error surface to robot poses.

Compensation moves the contact along the design normal by the measured error and keeps the design orientation:
`R' = R + e n`. The error is the head's displacement along that normal in that orientation, so the wheel's centre then
sits where the head found it, and the head stands at its zero angle. Turning the blade to the normal of `R + e n`
spoils this (measured: docs/decisions/0006-compensation-keeps-orientation.md).
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from core.error_surface import ErrorSurface
from core.errors import InputError
from core.frames import Array, checked_rigid
from core.path.contact import AirfoilSurface, presenting_poses, tool_from_contact, work_from_contact
from core.path.pattern import PatternSettings, pattern_lines
from core.path.reach import Workspace, check_workspace
from core.verdict import Code


@dataclass(frozen=True)
class CellFrames:
    """What calibration supplies to a path.

    Attributes:
        base_from_tool: (4, 4) {H} in B at head angle 0.
        flange_from_work: (4, 4) the blade in the gripper.
        wheel_radius_mm: Radius at the wheel's middle, belt included.
        contact_side: +1 or -1, see `core.path.contact`.
        span_along_shaft: +1 or -1.
    """

    base_from_tool: Array
    flange_from_work: Array
    wheel_radius_mm: float
    contact_side: int
    span_along_shaft: int = 1

    def checked(self) -> CellFrames:
        """The same with rotations made exact.

        Raises:
            InputError: a matrix is not a rigid transform.
        """
        return CellFrames(
            checked_rigid(self.base_from_tool, "base_from_tool"),
            checked_rigid(self.flange_from_work, "flange_from_work"),
            self.wheel_radius_mm,
            self.contact_side,
            self.span_along_shaft,
        )

    def poses(self, work_from_contact: Array) -> Array:
        """Flange poses (N, 4, 4) that present contact frames (N, 4, 4)."""
        on_wheel = tool_from_contact(self.wheel_radius_mm, self.contact_side, self.span_along_shaft)
        return presenting_poses(self.base_from_tool, on_wheel, work_from_contact, self.flange_from_work)


@dataclass(frozen=True)
class Stroke:
    """One line of the pattern in working order.

    Attributes:
        u: (n,) airfoil parameters.
        v: (n,).
        error_mm: (n,) measured normal error that was compensated; zero without an error surface.
        nominal_work_from_contact: (n, 4, 4) contact frames of the design.
        work_from_contact: (n, 4, 4) compensated contact frames.
        nominal_base_from_flange: (n, 4, 4) flange poses of the design.
        base_from_flange: (n, 4, 4) compensated flange poses: what the robot runs.
        approach_base_from_flange: (4, 4) clear of the wheel before the first point.
        retract_base_from_flange: (4, 4) clear of the wheel after the last point.
    """

    u: Array
    v: Array
    error_mm: Array
    nominal_work_from_contact: Array
    work_from_contact: Array
    nominal_base_from_flange: Array
    base_from_flange: Array
    approach_base_from_flange: Array
    retract_base_from_flange: Array


@dataclass(frozen=True)
class PathPlan:
    """A planned path.

    Attributes:
        strokes: Lines in working order.
        cell: Frames and wheel it was planned for.
        compensated: False if no error surface was given.
        trimmed_points: Points dropped because the error surface was not measured there (`clip` only).
    """

    strokes: tuple[Stroke, ...]
    cell: CellFrames
    compensated: bool
    trimmed_points: int

    @property
    def points(self) -> int:
        """Number of contact points."""
        return sum(stroke.u.size for stroke in self.strokes)

    def robot_poses(self) -> Array:
        """(K, 4, 4) every flange pose in running order: approach, contacts, retract for each stroke."""
        parts = []
        for s in self.strokes:
            parts += [s.approach_base_from_flange[None], s.base_from_flange, s.retract_base_from_flange[None]]
        return np.concatenate(parts)


def compensate(nominal_work_from_contact: Array, error_mm: Array) -> Array:
    """Contact frames (N, 4, 4) moved by `error_mm` (N,) along their outward normals."""
    frames = nominal_work_from_contact.copy()
    frames[:, :3, 3] += error_mm[:, None] * frames[:, :3, 2]
    return frames


def plan_path(
    airfoil: AirfoilSurface,
    cell: CellFrames,
    pattern: PatternSettings,
    *,
    error_surface: ErrorSurface | None = None,
    approach_mm: float = 20.0,
    clip: bool = False,
    workspace: Workspace | None = None,
) -> PathPlan:
    """Plan a path over the airfoil.

    Args:
        airfoil: Surface in the work frame, mm.
        cell: Calibrated frames and the wheel.
        pattern: Which lines, sampled how.
        error_surface: Measured errors to compensate; None plans the design path (to measure the errors by).
        approach_mm: Distance along the normal at which strokes begin and end.
        clip: Leave out what the error surface does not cover, instead of refusing.
        workspace: Box and reach that the flange has to stay in.

    Raises:
        InputError: unusable settings, a path outside of the measured patch, or poses out of reach.
    """
    cell = cell.checked()
    if not np.isfinite(approach_mm) or not 0.0 < approach_mm <= 500.0:
        raise InputError(f"approach_mm: expected a distance above 0 and up to 500 mm, found {approach_mm:g}.")
    strokes, trimmed = [], 0
    for u, v in pattern_lines(airfoil, pattern):
        error = np.zeros(u.size) if error_surface is None else error_surface.evaluate(u, v)
        known = np.isfinite(error)
        if error_surface is not None and not np.all(known):
            if not clip:
                raise _not_measured(error_surface, u[~known], v[~known])
            kept = _longest_run(known)
            trimmed += int(u.size - kept.size)
            if kept.size < 2:
                continue
            u, v, error = u[kept], v[kept], error[kept]
        strokes.append(_stroke(airfoil, cell, u, v, error, approach_mm))
    if not strokes:
        raise InputError("The error surface was measured nowhere on this path.", Code.LOW_COVERAGE)
    plan = PathPlan(tuple(strokes), cell, error_surface is not None, trimmed)
    if workspace is not None:
        check_workspace(plan.robot_poses(), workspace)
    return plan


def _stroke(airfoil: AirfoilSurface, cell: CellFrames, u: Array, v: Array, error: Array, approach_mm: float) -> Stroke:
    nominal = work_from_contact(airfoil, u, v)
    moved = compensate(nominal, error)
    # Moving the contact frame outward moves the blade away from the wheel.
    ends = cell.poses(compensate(moved[[0, -1]], np.full(2, approach_mm)))
    return Stroke(u, v, error, nominal, moved, cell.poses(nominal), cell.poses(moved), ends[0], ends[1])


def _longest_run(known: NDArray[np.bool_]) -> NDArray[np.int64]:
    edges = np.flatnonzero(np.diff(np.concatenate([[0], known.astype(np.int8), [0]])))
    starts, ends = edges[::2], edges[1::2]
    if starts.size == 0:
        return np.zeros(0, dtype=np.int64)
    best = int(np.argmax(ends - starts))
    return np.arange(starts[best], ends[best])


def _not_measured(surface: ErrorSurface, u: Array, v: Array) -> InputError:
    u0, u1, v0, v1 = surface.region.bounds
    inside = (u >= u0) & (u <= u1) & (v >= v0) & (v <= v1)
    where = "in a hole of the measured patch" if bool(inside[0]) else "outside the measured patch"
    return InputError(
        f"The path leaves what was measured: (u {u[0]:.6g}, v {v[0]:.6g}) lies {where}, which spans u {u0:.6g} to "
        f"{u1:.6g}, v {v0:.6g} to {v1:.6g} ({u.size} points of this line). Narrow u_range and v_range, measure there, "
        "or set clip = true to leave those points out.",
        Code.LOW_COVERAGE,
    )
