"""Probing: the robot presents the airfoil to the wheel point by point, the head's angle says where the wheel went."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from beltgui.session import Sample, Session
from beltgui.steps import head_rest
from beltgui.steps.context import Context
from beltgui.steps.error_surface.series import CHECK, CLAMPING, LINE, SERIES, STEP, Series, current_clamping
from beltgui.steps.scans import CLOSING, KIND, ScanSample, acquire_scans
from core.cad.blade_type import ProbingGrid
from core.errors import InputError
from core.frames import transform_points
from core.path import AirfoilSurface, CellFrames, compensate, work_from_contact
from devices.interfaces import DeadlineExceeded, Mount, Refused, RobotPath

Array = NDArray[np.float64]
# A check point decides over the whole surface, so one bounce must not spoil it.
CHECK_READINGS = 3
CHECK_LINES = 3
CHECK_POINTS = 12
# The blade comes to the wheel along the normal and leaves it so.
CLEAR_MM = 20.0
# Errors are measured against the frames that presented the blade. Frames that have been computed again since then and
# lie farther off than this are those of another cell.
PRESENTED_LIMIT_MM = 0.05


@dataclass(frozen=True, eq=False)
class Probe:
    """Probed points.

    Attributes:
        u: (N,) around the profile.
        v: (N,) along the span.
        angle_rad: (N,) head angle in contact; NaN where no reading came.
    """

    u: Array
    v: Array
    angle_rad: Array


@dataclass(frozen=True, eq=False)
class ProbeSamples:
    """Points to fit on, points between them to check on, and the head at its stop before and after, rad."""

    grinder: str
    grid: Probe
    check: Probe
    rests_rad: tuple[float, ...]


@dataclass(frozen=True, eq=False)
class Presenting:
    """The chain that brings a point of the airfoil to the wheel.

    Attributes:
        airfoil: Surface of the STEP model's airfoil face, {W}.
        frames: The calibrated frames and the wheel.
        grinder: Name of the grinder.
    """

    airfoil: AirfoilSurface
    frames: CellFrames
    grinder: str

    def poses(self, u: Array, v: Array, clear_mm: float = 0.0) -> Array:
        """base_from_flange (N, 4, 4) for the nominal contact at (u, v), or that far clear of the wheel."""
        contacts = work_from_contact(self.airfoil, u, v)
        return self.frames.poses(compensate(contacts, np.full(len(contacts), clear_mm)))

    @property
    def normal_in_tool(self) -> Array:
        """(3,) outward normal of the airfoil at every contact, in {H}."""
        return np.array([0.0, float(self.frames.contact_side), 0.0])


def clamp_and_scan(context: Context, why: str = "") -> list[ScanSample]:
    """Have the blade clamped and scan it: every clamping is another one, so its frame is measured again.

    Args:
        context: Cell and session.
        why: Kept: why what was probed before does not count any more.
    """
    context.cell.operator.perform(Mount("blade", context.serial))
    _add(context, CLAMPING, {"why": why, "time_s": context.cell.clock.now_s()})
    return _scan_all(context, KIND)


def scan_at_the_end(context: Context) -> list[ScanSample]:
    """Scan the blade after probing: the wheel has pressed on it for an hour, it may have slipped."""
    return _scan_all(context, CLOSING)


def _scan_all(context: Context, kind: str) -> list[ScanSample]:
    poses = context.plan.fine_step
    return acquire_scans(context, STEP, poses, kind, slots=range(len(poses)))


def acquire(context: Context, presenting: Presenting, grid: ProbingGrid) -> ProbeSamples:
    """Probe the grid line by line, then some points between its nodes; each line is kept at once.

    Lines that were probed before in this clamping, with these frames, are not probed again. Before and after, with the
    blade away from the wheel, the head is read at its stop.

    Raises:
        InputError: the blade has not been clamped.
        DeviceError: a device failed or refused, or nobody wants the motion.
        Cancelled: the job was cancelled; the lines probed before stay in the session.
    """
    series = _series(context, presenting, grid)
    todo = missing_lines(series, grid)
    if todo:
        _ask(context, presenting, todo)
        head_rest.acquire(context, STEP, presenting.grinder)
        context.mover().move_to(_clear(presenting, todo[0], 0), speed_mm_s=context.speed_mm_s)
        planned = grid.v_count + CHECK_LINES
        for line in todo:
            _probe_line(context, presenting, series, line, planned)
        context.mover().move_to(_clear(presenting, todo[-1], -1), speed_mm_s=context.speed_mm_s)
    if todo or not series.rested_after:
        context.move(context.plan.fine_step[0].base_from_flange, "away from the wheel, back to the scanning pose")
        head_rest.acquire(context, STEP, presenting.grinder)
    return read(context.session, presenting.grinder)


@dataclass(frozen=True, eq=False)
class Line:
    """A planned line: a slot of the grid or of the check lines."""

    kind: str
    slot: int
    u: Array
    v: Array


def planned_lines(grid: ProbingGrid) -> list[Line]:
    """All lines in the order of the work: to and fro along u, then the check lines."""
    u, v = grid.u(), grid.v()
    lines = [
        Line(LINE, slot, u if slot % 2 == 0 else u[::-1], np.full(len(u), position)) for slot, position in enumerate(v)
    ]
    return lines + [Line(CHECK, slot, *points) for slot, points in enumerate(check_lines(u, v))]


def missing_lines(series: Series | None, grid: ProbingGrid) -> list[Line]:
    """The planned lines that were not probed in a series, or not at these points."""
    return [line for line in planned_lines(grid) if not _there(series, line)]


def _there(series: Series | None, line: Line) -> bool:
    if series is None:
        return False
    found = (series.lines if line.kind == LINE else series.checks).get(line.slot)
    return found is not None and all(
        len(found.data[key]) == len(values) and np.allclose(found.data[key], values)
        for key, values in (("u", line.u), ("v", line.v))
    )


def check_lines(u: Array, v: Array) -> list[tuple[Array, Array]]:
    """Points half-way between grid nodes, spread over the patch."""
    columns = np.unique(np.linspace(0, len(u) - 2, CHECK_POINTS).astype(int))
    rows = np.unique(np.linspace(0, len(v) - 2, CHECK_LINES + 2).astype(int)[1:-1])
    middle_u = 0.5 * (u[columns] + u[columns + 1])
    return [(middle_u, np.full(len(middle_u), 0.5 * (v[row] + v[row + 1]))) for row in rows]


def presented_apart_mm(presented: Presenting, now: Presenting, grid: ProbingGrid) -> float:
    """How far the blade would be moved at the wheel, at most, if it were presented by other frames.

    Args:
        presented: The frames of the probing.
        now: The frames as they are known now.
        grid: The patch, {W}.
    """
    nodes = np.meshgrid(np.linspace(grid.u_min, grid.u_max, 9), np.linspace(grid.v_min, grid.v_max, 5))
    u, v = (axis.ravel() for axis in nodes)
    in_work = work_from_contact(presented.airfoil, u, v)[:, :3, 3]
    in_flange = transform_points(presented.frames.flange_from_work, in_work)
    points = np.concatenate([in_flange, np.ones((len(in_flange), 1))], axis=1)
    before, after = (np.einsum("nij,nj->ni", chain.poses(u, v), points)[:, :3] for chain in (presented, now))
    return float(np.linalg.norm(after - before, axis=1).max())


def _series(context: Context, presenting: Presenting, grid: ProbingGrid) -> Series:
    """The series to go on with, or a new one."""
    clamping = current_clamping(context.session)
    if clamping is None:
        raise InputError("The blade has not been clamped and scanned for probing. Clamp it first.")
    series = clamping.series.get(presenting.grinder)
    if series is not None:
        old = Presenting(presenting.airfoil, series.frames, presenting.grinder)
        if presented_apart_mm(old, presenting, grid) <= PRESENTED_LIMIT_MM:
            return series
    frames = presenting.frames
    data = {
        "grinder": presenting.grinder,
        "base_from_tool": frames.base_from_tool.tolist(),
        "flange_from_work": frames.flange_from_work.tolist(),
        "wheel_radius_mm": frames.wheel_radius_mm,
        "contact_side": frames.contact_side,
        "time_s": context.cell.clock.now_s(),
    }
    return Series(_add(context, SERIES, data), {}, {}, (), False, {})


def _clear(presenting: Presenting, line: Line, end: int) -> Array:
    """Clear of the wheel before the first (0) or after the last (-1) point of a line."""
    return np.asarray(presenting.poses(line.u[[end]], line.v[[end]], CLEAR_MM)[0])


def _ask(context: Context, presenting: Presenting, lines: list[Line]) -> None:
    """One question for the whole series: the outline of the lines shows where the robot will go."""
    first, last = lines[0], lines[-1]
    way = context.mover().preview(_clear(presenting, first, 0), speed_mm_s=context.speed_mm_s)
    ends_u = np.array([(line.u.min(), line.u.max()) for line in lines])
    ends_v = np.array([line.v[0] for line in lines])
    lowest, highest = int(ends_v.argmin()), int(ends_v.argmax())
    low_u, high_u = np.sort(lines[lowest].u), np.sort(lines[highest].u)
    outline_u = np.concatenate([low_u, ends_u[:, 1], high_u[::-1], ends_u[::-1, 0]])
    outline_v = np.concatenate([lines[lowest].v, ends_v, lines[highest].v, ends_v[::-1]])
    poses = [way.base_from_flange, presenting.poses(outline_u, outline_v), _clear(presenting, last, -1)[None]]
    outline = np.concatenate(poses)
    length = float(np.linalg.norm(np.diff(outline[:, :3, 3], axis=0), axis=1).sum())
    path = RobotPath(outline, length / context.speed_mm_s, length)
    points = sum(len(line.u) for line in lines)
    purpose = f"to probe {points} points of the airfoil on grinder {presenting.grinder} (outline shown)"
    if not context.consent(path, purpose):
        raise Refused("robot", f"the motion was not wanted: {purpose}. Nothing has moved.")


def _probe_line(context: Context, presenting: Presenting, series: Series, line: Line, planned: int) -> None:
    robot, sensors = context.mover(), context.cell.grinders[presenting.grinder]
    is_check = line.kind == CHECK
    number = planned - CHECK_LINES + line.slot if is_check else line.slot
    name = f"check line {line.slot + 1} of {CHECK_LINES}" if is_check else (
        f"probing line {line.slot + 1} of {planned - CHECK_LINES}"
    )
    angles = np.full(len(line.u), np.nan)
    for index, pose in enumerate(presenting.poses(line.u, line.v)):
        context.job.report((number + index / len(line.u)) / planned, name)
        robot.move_to(pose, speed_mm_s=context.speed_mm_s)
        found = []
        for _ in range(CHECK_READINGS if is_check else 1):
            try:
                found.append(sensors.read().angle_rad)
            except DeadlineExceeded:
                # A lost frame is a missing sample; the surface says how many it bridged.
                continue
        if found:
            angles[index] = np.median(found)
    data = {
        "slot": line.slot,
        "series": series.marker.id,
        "grinder": presenting.grinder,
        "u": line.u.tolist(),
        "v": line.v.tolist(),
        "angle_rad": [float(angle) if np.isfinite(angle) else None for angle in angles],
        "time_s": context.cell.clock.now_s(),
    }
    _add(context, line.kind, data)


def _add(context: Context, kind: str, data: dict[str, object]) -> Sample:
    sample = context.session.add_sample(STEP, kind, data)
    context.on_sample(sample)
    return sample


def read(session: Session, grinder: str) -> ProbeSamples:
    """The points probed on a grinder in the latest clamping, as they were kept; lines that were left out are not there.

    Raises:
        InputError: there are none.
    """
    clamping = current_clamping(session)
    series = None if clamping is None else clamping.series.get(grinder)
    lines = [] if series is None else [sample for sample in series.lines.values() if sample.included]
    if series is None or not lines:
        raise InputError(f"No line of the airfoil has been probed on grinder {grinder}. Probe it first.")
    checks = [sample for sample in series.checks.values() if sample.included]
    rests = tuple(float(sample.data["angle_rad"]) for sample in series.rests)
    return ProbeSamples(grinder, joined(lines), joined(checks), rests)


def joined(samples: list[Sample]) -> Probe:
    """The points of several lines in the order of their slots."""
    ordered = sorted(samples, key=lambda sample: int(sample.data["slot"]))
    columns = {
        key: np.array([value for sample in ordered for value in sample.data[key]], dtype=float)
        for key in ("u", "v", "angle_rad")
    }
    return Probe(columns["u"], columns["v"], columns["angle_rad"])
