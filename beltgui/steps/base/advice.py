"""Which robot pose would sharpen the base fit most."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from core.base import BaseFit, suggest_next_pose
from core.frames import euler_zyx_from_rotation, rigid, rotation_from_rotvec
from devices.cell_plan import ScanPose

Array = NDArray[np.float64]
# A variation turns the flange about the ball, so that the ball stays where the scanner saw it before.
TURNS_DEG = (-25.0, 25.0)
# A smaller share is not worth a scan.
LEAST_GAIN = 0.05


@dataclass(frozen=True, eq=False)
class PoseAdvice:
    """The pose that would help most.

    Attributes:
        pose: Where to scan.
        planned: True if it is one of the planned poses.
        before_mm: Standard deviation of a point carried to {B}, as far from the middle of the balls as they are.
        after_mm: The same with one more scan there.
    """

    pose: ScanPose
    planned: bool
    before_mm: float
    after_mm: float


def advise(fit: BaseFit, planned: Sequence[ScanPose], missing: Sequence[ScanPose]) -> PoseAdvice | None:
    """The missing planned pose that helps most, or, with all of them there, the best variation of one.

    Args:
        fit: So far.
        planned: All planned poses: within the robot's reach and the scanner's view.
        missing: Those without a scan.

    Returns:
        None if nothing gains enough.
    """
    candidates = list(missing) or variations(planned, fit.ball_in_flange_mm)
    gain = suggest_next_pose(fit, np.array([pose.base_from_flange for pose in candidates]))
    best = int(gain.by_a[0])
    share = float(gain.a_gain[best])
    if not missing and share < LEAST_GAIN:
        return None
    before = point_sigma_mm(fit)
    return PoseAdvice(candidates[best], bool(missing), before, before * float(np.sqrt(1.0 - share)))


def point_sigma_mm(fit: BaseFit) -> float:
    """Standard deviation of a point carried to {B} at the lever arm of the data, over all directions."""
    scale = np.array([fit.lever_arm_mm**2] * 3 + [1.0] * 3)
    return float(np.sqrt(np.diag(fit.covariance.matrix) @ scale))


def variations(planned: Sequence[ScanPose], ball_in_flange: Array) -> list[ScanPose]:
    """Planned poses with the flange turned about the ball, about each of its own axes."""
    found = []
    for pose in planned:
        rotation = pose.base_from_flange[:3, :3]
        ball = rotation @ ball_in_flange + pose.base_from_flange[:3, 3]
        for axis in np.eye(3):
            for turn_deg in TURNS_DEG:
                turned = rotation @ rotation_from_rotvec(np.radians(turn_deg) * axis)
                flange = rigid(turned, ball - turned @ ball_in_flange)
                found.append(ScanPose(f"{pose.name}, turned", flange, pose.stage))
    return found


def pose_values(pose: ScanPose) -> dict[str, list[float]]:
    """What the setting `extra` holds of a pose: mm and deg."""
    stage = pose.stage
    return {
        "translation_mm": pose.base_from_flange[:3, 3].tolist(),
        "euler_zyx_deg": np.degrees(euler_zyx_from_rotation(pose.base_from_flange[:3, :3])).tolist(),
        "stage": [stage.x_mm, stage.y_mm, stage.z_mm, float(np.degrees(stage.theta_rad))],
    }
