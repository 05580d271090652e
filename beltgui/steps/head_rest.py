"""The head at its stop: what its sensor reads there must be the same in the tool step and around the probing.

A constant shift of the sensor's zero looks just like a blade that is proud all over, so nothing in the error surface
itself can show it; the stop can.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any

import numpy as np

from beltgui.steps.blocks import degrees
from beltgui.steps.context import Context
from core.verdict import Code, Reason
from devices.interfaces import DeadlineExceeded

KIND = "head_rest"
READINGS = 5
LIMIT_MM = 0.03


@dataclass(frozen=True)
class HeadRest:
    """Readings at the stop.

    Attributes:
        grinder: Its name.
        radius_mm: Rg; turns an angle into the wheel's way.
        in_tool_step_rad: Readings of the tool step, in which the zero was found.
        now_rad: Readings before and after the probing.
    """

    grinder: str
    radius_mm: float
    in_tool_step_rad: tuple[float, ...]
    now_rad: tuple[float, ...]

    @property
    def moved_mm(self) -> float:
        """The wheel's largest way between two readings; NaN if there is none to compare."""
        if not self.in_tool_step_rad or not self.now_rad:
            return float("nan")
        return self.radius_mm * float(np.abs(np.subtract.outer(self.now_rad, self.in_tool_step_rad)).max())

    def reasons(self) -> list[Reason]:
        """What speaks against the sensor's zero."""
        if self.moved_mm <= LIMIT_MM:
            return []
        advice = "Check the angle sensor's coupling and the stop, then calibrate the tool again."
        if not np.isfinite(self.moved_mm):
            what = f"There is no reading of the head of grinder {self.grinder} at its stop"
            return [Reason(Code.BAD_INPUT, f"{what}, so a shift of its zero would not show. {advice}")]
        before, now = (
            ", ".join(f"{np.degrees(angle):+.3f}" for angle in angles)
            for angles in (self.in_tool_step_rad, self.now_rad)
        )
        return [Reason(
            Code.WRONG_MODEL,
            f"The head of grinder {self.grinder} reads {now} degrees at its stop and read {before} degrees in the tool "
            f"step: {self.moved_mm:.3f} mm at the wheel, the limit is {LIMIT_MM:.3f} mm. {advice}",
        )]  # fmt: skip

    def block(self) -> dict[str, object]:
        """For the record."""
        return {
            "in_tool_step_deg": degrees(self.in_tool_step_rad),
            "now_deg": degrees(self.now_rad),
            "moved_mm": self.moved_mm,
            "limit_mm": LIMIT_MM,
        }


def acquire(context: Context, step: str, grinder: str, note: Mapping[str, Any] | None = None) -> None:
    """Read the head while nothing touches the wheel, and keep the median of some readings.

    Args:
        context: Cell and session.
        step: Which step the sample is kept for.
        grinder: Its name.
        note: What else to keep with the sample.

    Raises:
        DeviceError: the sensor is lost, or gave no reading at all.
    """
    sensors = context.cell.grinders[grinder]
    angles: list[float] = []
    for _ in range(READINGS):
        try:
            angles.append(sensors.read().angle_rad)
        except DeadlineExceeded:
            continue  # a lost frame; the others will do
    if not angles:
        raise DeadlineExceeded(f"grinder {grinder}", "no reading of the head at its stop. Check the sensor's link.")
    data = {
        "grinder": grinder,
        "angle_rad": float(np.median(angles)),
        "time_s": context.cell.clock.now_s(),
        **(note or {}),
    }
    context.on_sample(context.session.add_sample(step, KIND, data))
