"""What the tables of the ball and the base step say alike of a scan of the ball."""

from __future__ import annotations

import math

from beltgui.steps.ball.closing import Returned
from beltgui.steps.ball.found import BallScan
from beltgui.steps.held_out import is_held_out
from beltgui.steps.views.common import finite, in_um
from beltgui.viewmodel.step import Column, Use

WHERE_COLUMNS = (
    Column("stage_x", "Stage x", "mm", 1),
    Column("stage_y", "Stage y", "mm", 1),
    Column("stage_z", "Stage z", "mm", 1),
    Column("stage_theta", "Stage turn", "deg", 1),
    Column("noise", "Noise on the ball", "µm", 1),
    Column("seen", "Ball seen", "%", 0),
)


def where_cells(scan: BallScan) -> tuple[float | None, ...]:
    """Cells of `WHERE_COLUMNS`."""
    sphere = scan.seen.sphere
    return (
        *(float(value) for value in scan.stage_mm),
        math.degrees(scan.stage.theta_rad),
        None if sphere is None else in_um(sphere.sigma_mm),
        None if sphere is None else finite(100.0 * sphere.coverage),
    )


def use_of(scan: BallScan, planned: int) -> Use:
    """What a scan is used for; one that shows no ball is used for nothing."""
    if not scan.usable:
        return Use.EXCLUDED
    if scan.closing:
        return Use.CHECK
    return Use.HELD_OUT if is_held_out(scan.slot, planned) else Use.FIT


def note_of(scan: BallScan, back: Returned | None) -> str:
    """A sentence on a scan that is not like the others."""
    if scan.seen.sphere is None:
        return f"{scan.seen.refusal} Leave it out, or delete it and scan again."
    if not scan.closing:
        return ""
    if back is None or back.last is None or back.last.id != scan.id:
        return "Other scans were taken after this closing scan, so it no longer closes the series."
    moved = finite(back.moved_mm)
    if moved is None:
        return "Looks at the first place again."
    return f"The ball is {moved:.3f} mm from where the first scan saw it; the limit is {back.limit_mm:.3f} mm."
