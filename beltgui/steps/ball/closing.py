"""The closing scan: at the end the ball is looked at from the first place again, so that a move in between shows."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import NDArray

from beltgui.steps.ball.found import BallScan, ball_scans, usable
from beltgui.steps.context import Context
from beltgui.steps.room import Bench
from beltgui.steps.scans import CLOSING, KIND, missing_slots, take_scan
from core.verdict import Code, Reason, above
from devices.cell_plan import ScanPose

Array = NDArray[np.float64]


@dataclass(frozen=True, eq=False)
class Returned:
    """The ball in the first scan and in the last, taken from the same place.

    Attributes:
        first: The earliest scan that is used; None if there is none.
        last: The closing scan that looks at its place again after all others; None if there is none.
        moved_mm: Distance between the two balls; NaN while it is not known.
        limit_mm: What it may be.
    """

    first: BallScan | None
    last: BallScan | None
    moved_mm: float
    limit_mm: float

    def reasons(self) -> list[Reason]:
        """What speaks against the ball having stood still, or why that is not known."""
        if self.first is None or self.last is None:
            message = (
                "The closing scan is missing, so a ball that moved between the scans might not show. Take the missing "
                "scans; the closing one comes last."
            )
            return [Reason(Code.HELD_OUT_ERROR, message)]
        if not self.last.included:
            message = (
                f"The closing scan '{self.last.name}' is left out, so a ball that moved between the scans might not "
                "show. Take it in again, or delete it and scan again."
            )
            return [Reason(Code.HELD_OUT_ERROR, message)]
        if self.last.seen.sphere is None:
            message = "The closing scan shows no ball, so nothing shows that it stood still. Delete it and scan again."
            return [Reason(Code.HELD_OUT_ERROR, message)]
        return above(
            Code.HELD_OUT_ERROR,
            self.moved_mm,
            self.limit_mm,
            "The distance of the ball from where the first scan saw it, back at the same place after all other scans,",
            "The ball, the stage or the robot has moved meanwhile: fasten everything and scan again.",
        )


def closing_pair(scans: Sequence[BallScan]) -> tuple[BallScan | None, BallScan | None]:
    """The earliest scan that is used, and the newest closing scan at its place that is later than all scans used."""
    used = usable(scans)
    if not used:
        return None, None
    first = min(used, key=lambda scan: scan.id)
    latest = max(scan.id for scan in used)
    closings = [
        scan for scan in scans if scan.closing and scan.returns_to == first.slot and scan.id > latest
    ]
    return first, max(closings, key=lambda scan: scan.id, default=None)


def returned(scans: Sequence[BallScan], balls: dict[int, Array], limit_mm: float) -> Returned:
    """Compare first and closing scan; `balls` are centres (3,) by sample id, all in one frame."""
    first, last = closing_pair(scans)
    moved = float("nan")
    if first is not None and last is not None and last.usable:
        moved = float(np.linalg.norm(balls[last.id] - balls[first.id]))
    return Returned(first, last, moved, limit_mm)


def acquire_with_closing(bench: Bench, context: Context, step: str, poses: Sequence[ScanPose]) -> None:
    """Take the planned scans that are missing, then the closing scan unless there is one that is still valid.

    The closing scan looks at the place of the earliest scan that is used; after more scans, or without that scan,
    it has to be taken again.

    Raises:
        DeviceError: a device failed or refused; what was taken before stays in the session.
        Cancelled: the job was cancelled.
    """
    total = len(poses) + 1
    for slot in missing_slots(context.session, step, len(poses)):
        pose = poses[slot]
        context.job.report(slot / total, f"scan {slot + 1} of {total}: {pose.name}")
        take_scan(context, step, pose, KIND, {"slot": slot})
    context.job.report(len(poses) / total, f"scan {total} of {total}: the first place again")
    first, last = closing_pair(ball_scans(bench, step, context.job.part(len(poses) / total, 1.0)))
    if first is None or last is not None:
        return
    pose = replace(poses[first.slot], name=f"{first.name} again")
    take_scan(context, step, pose, CLOSING, {"slot": len(poses), "returns_to": first.slot})


def is_complete(scans: Sequence[BallScan], planned: int) -> bool:
    """True if every planned scan is there and a closing scan follows them."""
    there = {scan.slot for scan in scans if not scan.closing}
    return there >= set(range(planned)) and closing_pair(scans)[1] is not None


def taken(scans: Sequence[BallScan], planned: int) -> int:
    """How many of the planned scans and the closing one are there."""
    there = {scan.slot for scan in scans if not scan.closing} & set(range(planned))
    return len(there) + (closing_pair(scans)[1] is not None)
