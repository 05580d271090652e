"""Base: the ball on the flange is scanned in several robot poses; gives the measuring frame in the robot's base."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np

from beltgui.steps.ball.step import find_balls, judge_balls, judge_returned
from beltgui.steps.base.record import record as fit_record
from beltgui.steps.blocks import plain, verdict_block
from beltgui.steps.context import Context
from beltgui.steps.held_out import HeldOut, split
from beltgui.steps.scans import ScanSample, acquire_scans
from core.ball import SphereFit, StageFit
from core.base import BaseFit, BaseLimits, judge_base, solve_base
from core.frames import transform_points
from core.verdict import Verdict
from devices.interfaces import Mount

HELD_OUT_LIMIT_MM = 1.0
# The robot comes back to a pose within its repeatability, some hundredths of a mm at the ball.
RETURNED_LIMIT_MM = 0.1


@dataclass(frozen=True, eq=False)
class BaseOutcome:
    """What the step found.

    Attributes:
        spheres: One per scan, in {S}.
        fit: From the poses that were not kept out.
        returned_mm: Distance between the ball in the first scan and in the last, which is taken in the same pose.
        held_out: Ball in {B} by scanner against ball by robot, at the poses kept out.
        verdict: Of all of it.
    """

    spheres: tuple[SphereFit, ...]
    fit: BaseFit
    held_out: HeldOut
    returned_mm: float
    verdict: Verdict


def acquire(context: Context) -> list[ScanSample]:
    """Scan the ball on the flange in the planned robot poses, and at the end in the first one again."""
    context.cell.operator.perform(Mount("ball"))
    poses = context.plan.base_step
    return acquire_scans(context, "base", [*poses, poses[0]])


def solve(samples: Sequence[ScanSample], diameter_mm: float, stage: StageFit) -> BaseOutcome:
    """Fit the ball in every scan, the base on most poses, and check on the rest.

    Args:
        samples: Scans of the ball on the flange; the last in the pose of the first.
        diameter_mm: The certified diameter.
        stage: Result of the ball step.

    Raises:
        InputError: a scan shows no ball, or the poses do not determine the frame.
    """
    spheres = find_balls(samples, diameter_mm)
    measure_from_scanner = [stage.measure_from_scanner_at(s.stage_mm, s.stage.theta_rad) for s in samples]
    balls = np.array([
        transform_points(pose, sphere.center_mm) for pose, sphere in zip(measure_from_scanner, spheres, strict=True)
    ])
    covariances = np.array([
        pose[:3, :3] @ sphere.covariance_mm2 @ pose[:3, :3].T
        for pose, sphere in zip(measure_from_scanner, spheres, strict=True)
    ])
    flanges = np.array([sample.base_from_flange for sample in samples])
    returned_mm = float(np.linalg.norm(balls[-1] - balls[0]))
    fitted, held = split(len(samples) - 1)
    fit = solve_base(flanges[fitted], balls[fitted], ball_covariance_mm2=covariances[fitted])
    by_robot = np.array([transform_points(flanges[i], fit.ball_in_flange_mm) for i in held]).reshape(-1, 3)
    by_scanner = transform_points(fit.base_from_measure, balls[held].reshape(-1, 3))
    held_out = HeldOut("ball centre in {B}", np.linalg.norm(by_robot - by_scanner, axis=1), HELD_OUT_LIMIT_MM)
    reasons = [
        *judge_returned(returned_mm, RETURNED_LIMIT_MM),
        *judge_balls(samples, spheres),
        *judge_base(fit, BaseLimits()).reasons,
        *held_out.reasons("The ball may have moved on the flange, or the robot's mastering is off: check both."),
    ]
    return BaseOutcome(spheres, fit, held_out, returned_mm, Verdict.of(reasons))


def record(outcome: BaseOutcome) -> dict[str, Any]:
    """For the session and the report."""
    return {
        **fit_record(outcome.fit, outcome.verdict),
        "held_out": plain(outcome.held_out.block()),
        "returned_mm": outcome.returned_mm,
        "verdict": verdict_block(outcome.verdict),
    }
