"""The base step's result as a record."""

from __future__ import annotations

from typing import Any

import numpy as np

from beltgui.steps.blocks import conditioning_block, plain, pose_block, verdict_block
from core.base import BaseFit
from core.verdict import Verdict


def record(fit: BaseFit, verdict: Verdict) -> dict[str, Any]:
    """Pose of the measurement frame in the base, the ball in the flange, and how far to trust them.

    `residuals_mm` are vectors in B, one per observation; `leave_one_out_mm` is null where the other poses predict
    nothing.
    """
    return {
        "verdict": verdict_block(verdict),
        "base_from_measure": pose_block(fit.base_from_measure, fit.covariance),
        "ball_in_flange_mm": plain(fit.ball_in_flange_mm),
        "ball_sigma_mm": plain(np.sqrt(np.diag(fit.ball_covariance_mm2))),
        "rms_mm": plain(fit.rms_mm),
        "residuals_mm": plain(fit.residuals_mm),
        "leave_one_out_mm": plain(fit.leave_one_out_mm),
        **conditioning_block(fit.conditioning),
        "robot_sigma_mm": plain(fit.robot_sigma_mm),
        "different_poses": fit.different_poses,
        "iterations": fit.iterations,
    }
