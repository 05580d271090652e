"""Scans as samples: taken with robot and stage standing still, kept at once, read back for solving."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from beltgui.session import Sample, Session
from beltgui.steps.context import Context
from devices.cell_plan import ScanPose
from devices.interfaces import StagePosition

Array = NDArray[np.float64]
KIND = "scan"
CLOSING = "closing_scan"
# What the robot's report of a pose and the commanded pose may differ by when it is there.
THERE_MM, THERE_RAD = 1e-3, 1e-6


@dataclass(frozen=True, eq=False)
class ScanSample:
    """One scan and where everything stood.

    Attributes:
        name: What is seen.
        base_from_flange: (4, 4) as the robot reported it.
        stage: As the stage reported it.
        points_in_scanner: (N, 3) mm.
    """

    name: str
    base_from_flange: Array
    stage: StagePosition
    points_in_scanner: Array

    @property
    def stage_mm(self) -> Array:
        """(3,) linear axes."""
        return np.array([self.stage.x_mm, self.stage.y_mm, self.stage.z_mm])


def missing_slots(session: Session, step: str, count: int, kind: str = KIND) -> list[int]:
    """Which of the planned samples 0 to `count` - 1 have not been taken, or were deleted."""
    there = {sample.data["slot"] for sample in session.samples(step, kind)}
    return [slot for slot in range(count) if slot not in there]


def acquire_scans(
    context: Context,
    step: str,
    poses: Sequence[ScanPose],
    kind: str = KIND,
    note: Mapping[str, Any] | None = None,
    slots: Sequence[int] | None = None,
) -> list[ScanSample]:
    """Visit the poses that have no scan yet and scan at each; the robot moves only if it is not there already.

    Args:
        context: Cell and session.
        step: Which step the samples are kept for.
        poses: Where to scan; a pose's place in the list is its sample's `slot`.
        kind: Which kind of sample.
        note: What else to keep with each sample.
        slots: Which poses to scan; None takes those that have no scan yet.

    Returns:
        The scans taken now.

    Raises:
        DeviceError: a device failed or refused; what was taken before stays in the session.
        Cancelled: the job was cancelled.
    """
    if slots is None:
        slots = missing_slots(context.session, step, len(poses), kind)
    samples: list[ScanSample] = []
    for slot in slots:
        pose = poses[slot]
        context.job.report(slot / len(poses), f"scan {slot + 1} of {len(poses)}: {pose.name}")
        samples.append(take_scan(context, step, pose, kind, {**(note or {}), "slot": slot}))
    return samples


def take_scan(context: Context, step: str, pose: ScanPose, kind: str, note: Mapping[str, Any]) -> ScanSample:
    """Go to a pose and scan there; the robot moves only if it is not there already.

    Args:
        context: Cell and session.
        step: Which step the sample is kept for.
        pose: Where to scan.
        kind: Which kind of sample.
        note: What else to keep with the sample, its `slot` among it.

    Raises:
        DeviceError: a device failed or refused.
    """
    if not context.cell.stage.homed:
        context.cell.stage.home()
    if not _stands_at(context.cell.robot.read().base_from_flange, pose.base_from_flange):
        context.move(pose.base_from_flange, f"to the scanning pose '{pose.name}'")
    return _take(context, step, pose, kind, note)


def _stands_at(base_from_flange: Array, target: Array) -> bool:
    """True if a motion would change nothing but the robot's repeatability error."""
    shift_mm = np.abs(base_from_flange[:3, 3] - target[:3, 3]).max()
    turn_rad = np.abs(base_from_flange[:3, :3] - target[:3, :3]).max()
    return bool(shift_mm < THERE_MM and turn_rad < THERE_RAD)


def _take(context: Context, step: str, pose: ScanPose, kind: str, note: Mapping[str, Any]) -> ScanSample:
    stage = context.cell.stage.move_to(pose.stage)
    scan = context.cell.scanner.capture()
    reading = context.cell.robot.read()
    data = {
        "name": pose.name,
        "base_from_flange": reading.base_from_flange.tolist(),
        "stage_mm": [stage.x_mm, stage.y_mm, stage.z_mm],
        "stage_rad": stage.theta_rad,
        "time_s": scan.time_s,
        **note,
    }
    sample = context.session.add_sample(step, kind, data, scan.points_mm)
    context.on_sample(sample)
    return _scan_sample(sample, scan.valid_points_mm())


def read_scans(session: Session, step: str, kind: str = KIND) -> list[ScanSample]:
    """The scans of a step as they were kept.

    Raises:
        InputError: there are none, or a cloud is gone or damaged.
    """
    return [scan_of(session, sample) for sample in session.kept(step, kind)]


def scan_of(session: Session, sample: Sample) -> ScanSample:
    """A scan as it was kept.

    Raises:
        InputError: its cloud is gone or damaged.
    """
    return _scan_sample(sample, session.points(sample))


def _scan_sample(sample: Sample, points_in_scanner: Array) -> ScanSample:
    x, y, z = sample.data["stage_mm"]
    return ScanSample(
        sample.data["name"],
        np.array(sample.data["base_from_flange"]),
        StagePosition(x, y, z, sample.data["stage_rad"]),
        points_in_scanner,
    )
