"""Probing: the robot presents the airfoil to the wheel point by point, the head's angle says where the wheel went."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from beltgui.session import Session
from beltgui.steps import head_rest
from beltgui.steps.context import Context
from beltgui.steps.scans import CLOSING, ScanSample, acquire_scans
from core.cad.blade_type import ProbingGrid
from core.path import AirfoilSurface, CellFrames, work_from_contact
from devices.interfaces import DeadlineExceeded, Mount, Refused, RobotPath

Array = NDArray[np.float64]
LINE = "line"
CHECK = "check"
# A check point decides over the whole surface, so one bounce must not spoil it.
CHECK_READINGS = 3
CHECK_LINES = 3
CHECK_POINTS = 12


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

    def poses(self, u: Array, v: Array) -> Array:
        """base_from_flange (N, 4, 4) for the nominal contact at (u, v)."""
        return self.frames.poses(work_from_contact(self.airfoil, u, v))

    @property
    def normal_in_tool(self) -> Array:
        """(3,) outward normal of the airfoil at every contact, in {H}."""
        return np.array([0.0, float(self.frames.contact_side), 0.0])


def clamp_and_scan(context: Context) -> list[ScanSample]:
    """Have the blade clamped and scan it: every clamping is another one, so its frame is measured again."""
    context.cell.operator.perform(Mount("blade", context.serial))
    return acquire_scans(context, "error_surface", context.plan.fine_step)


def scan_at_the_end(context: Context) -> list[ScanSample]:
    """Scan the blade after probing: the wheel has pressed on it for an hour, it may have slipped."""
    return acquire_scans(context, "error_surface", context.plan.fine_step, CLOSING)


def acquire(context: Context, presenting: Presenting, grid: ProbingGrid) -> ProbeSamples:
    """Probe the grid line by line, then some points between its nodes; each line is kept at once.

    Before and after, with the blade away from the wheel, the head is read at its stop.

    Raises:
        DeviceError: a device failed or refused, or nobody wants the motion.
        Cancelled: the job was cancelled; the lines probed before stay in the session.
    """
    u, v = grid.u(), grid.v()
    _ask(context, presenting, u, v)
    head_rest.acquire(context, "error_surface", presenting.grinder)
    lines = [(u if number % 2 == 0 else u[::-1], np.full(len(u), position)) for number, position in enumerate(v)]
    for number, (line_u, line_v) in enumerate(lines):
        context.job.report(number / (len(v) + CHECK_LINES), f"probing line {number + 1} of {len(v)}")
        angles = _probe(context, presenting, line_u, line_v, readings=1)
        _keep(context, presenting.grinder, LINE, line_u, line_v, angles)
    for number, (line_u, line_v) in enumerate(check_lines(u, v)):
        context.job.report((len(v) + number) / (len(v) + CHECK_LINES), f"check line {number + 1} of {CHECK_LINES}")
        angles = _probe(context, presenting, line_u, line_v, readings=CHECK_READINGS)
        _keep(context, presenting.grinder, CHECK, line_u, line_v, angles)
    context.move(context.plan.fine_step[0].base_from_flange, "away from the wheel, back to the scanning pose")
    head_rest.acquire(context, "error_surface", presenting.grinder)
    return read(context.session)


def check_lines(u: Array, v: Array) -> list[tuple[Array, Array]]:
    """Points half-way between grid nodes, spread over the patch."""
    columns = np.unique(np.linspace(0, len(u) - 2, CHECK_POINTS).astype(int))
    rows = np.unique(np.linspace(0, len(v) - 2, CHECK_LINES + 2).astype(int)[1:-1])
    middle_u = 0.5 * (u[columns] + u[columns + 1])
    return [(middle_u, np.full(len(middle_u), 0.5 * (v[row] + v[row + 1]))) for row in rows]


def _ask(context: Context, presenting: Presenting, u: Array, v: Array) -> None:
    """One question for the whole series: the outline of the patch shows where the robot will go."""
    outline_u = np.concatenate([u, np.full(len(v), u[-1]), u[::-1], np.full(len(v), u[0])])
    outline_v = np.concatenate([np.full(len(u), v[0]), v, np.full(len(u), v[-1]), v[::-1]])
    poses = presenting.poses(outline_u, outline_v)
    length = float(np.linalg.norm(np.diff(poses[:, :3, 3], axis=0), axis=1).sum())
    path = RobotPath(poses, length / context.speed_mm_s, length)
    purpose = f"to probe {len(u) * len(v)} points of the airfoil on grinder {presenting.grinder} (outline shown)"
    if not context.consent(path, purpose):
        raise Refused("robot", f"the motion was not wanted: {purpose}. Nothing has moved.")


def _probe(context: Context, presenting: Presenting, u: Array, v: Array, *, readings: int) -> Array:
    robot, sensors = context.mover(), context.cell.grinders[presenting.grinder]
    angles = np.full(len(u), np.nan)
    for index, pose in enumerate(presenting.poses(u, v)):
        robot.move_to(pose, speed_mm_s=context.speed_mm_s)
        found = []
        for _ in range(readings):
            try:
                found.append(sensors.read().angle_rad)
            except DeadlineExceeded:
                # A lost frame is a missing sample; the surface says how many it bridged.
                continue
        if found:
            angles[index] = np.median(found)
    return angles


def _keep(context: Context, grinder: str, kind: str, u: Array, v: Array, angles: Array) -> None:
    data = {
        "grinder": grinder,
        "u": u.tolist(),
        "v": v.tolist(),
        "angle_rad": [float(angle) if np.isfinite(angle) else None for angle in angles],
        "time_s": context.cell.clock.now_s(),
    }
    context.session.add_sample("error_surface", kind, data)


def read(session: Session) -> ProbeSamples:
    """The probed points as they were kept.

    Raises:
        InputError: there are none.
    """
    grid, check = (_joined(session, kind) for kind in (LINE, CHECK))
    first = session.kept("error_surface", LINE)[0]
    grinder = first.data["grinder"]
    return ProbeSamples(grinder, grid, check, head_rest.read(session, "error_surface").get(grinder, ()))


def _joined(session: Session, kind: str) -> Probe:
    samples = session.kept("error_surface", kind)
    columns = {
        key: np.array([value for sample in samples for value in sample.data[key]], dtype=float)
        for key in ("u", "v", "angle_rad")
    }
    return Probe(columns["u"], columns["v"], columns["angle_rad"])
