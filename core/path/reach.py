"""Where the flange may go. The arm's joints and its collisions are the controller's business."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from core.errors import InputError
from core.frames import Array
from core.verdict import Code


@dataclass(frozen=True)
class Workspace:
    """Limits of the flange's origin in B.

    Attributes:
        least_mm: (3,) lower corner of the allowed box, or None.
        greatest_mm: (3,) upper corner, or None.
        max_reach_mm: Greatest distance from the base's origin, or None.
    """

    least_mm: tuple[float, float, float] | None = None
    greatest_mm: tuple[float, float, float] | None = None
    max_reach_mm: float | None = None


def check_workspace(base_from_flange: Array, workspace: Workspace) -> None:
    """Refuse poses (N, 4, 4) outside the workspace.

    Raises:
        InputError: names the first pose, the axis, the value and the limit.
    """
    origin = base_from_flange[:, :3, 3]
    for sign, limit, word in ((1.0, workspace.least_mm, "below"), (-1.0, workspace.greatest_mm, "above")):
        if limit is None:
            continue
        outside = np.argwhere(sign * (origin - np.asarray(limit)) < 0.0)
        if outside.size:
            row, axis = (int(value) for value in outside[0])
            raise InputError(
                f"Pose {row + 1} of {len(origin)}: flange {'xyz'[axis]} = {origin[row, axis]:.1f} mm is {word} the "
                f"workspace limit {limit[axis]:.1f} mm. Change the pattern or where the blade is presented.",
                Code.OUTSIDE_LIMITS,
            )
    if workspace.max_reach_mm is not None:
        distance = np.linalg.norm(origin, axis=1)
        row = int(np.argmax(distance))
        if distance[row] > workspace.max_reach_mm:
            raise InputError(
                f"Pose {row + 1} of {len(origin)}: the flange is {distance[row]:.1f} mm from the base, the reach is "
                f"{workspace.max_reach_mm:.1f} mm.",
                Code.OUTSIDE_LIMITS,
            )
