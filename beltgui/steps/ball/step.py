"""Ball: the ball stands still, the stage moves the scanner; gives the scanner's place at every stage position."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np

from beltgui.steps.ball.record import sphere_record, stage_record
from beltgui.steps.blocks import plain, verdict_block
from beltgui.steps.context import Context
from beltgui.steps.held_out import HeldOut, split
from beltgui.steps.scans import ScanSample, acquire_scans
from core.ball import (
    SphereFit,
    SphereLimits,
    StageFit,
    StageLimits,
    StageObservations,
    fit_sphere,
    judge_sphere,
    judge_stage,
    solve_stage,
)
from core.frames import transform_points
from core.verdict import Code, Reason, Verdict, above
from devices.interfaces import Mount

HELD_OUT_LIMIT_MM = 0.03
# Nothing but the stage moved: its repeatability and the noise of a ball centre are some µm.
RETURNED_LIMIT_MM = 0.03


@dataclass(frozen=True, eq=False)
class BallOutcome:
    """What the step found.

    Attributes:
        spheres: One per scan, in {S}.
        stage: The stage's axes, from the scans that were not kept out.
        held_out: Ball centre in {M} from the scans kept out, against the fitted one.
        returned_mm: Distance between the ball in the first scan and in the last, which is taken at the same place.
        verdict: Of all of it.
    """

    spheres: tuple[SphereFit, ...]
    stage: StageFit
    held_out: HeldOut
    returned_mm: float
    verdict: Verdict


def acquire(context: Context) -> list[ScanSample]:
    """Mount the ball, scan it from the planned stage positions, and at the end from the first one again."""
    context.cell.operator.perform(Mount("ball"))
    poses = context.plan.stage_step
    return acquire_scans(context, "ball", [*poses, poses[0]])


def find_balls(samples: Sequence[ScanSample], diameter_mm: float) -> tuple[SphereFit, ...]:
    """The ball of certified diameter in each scan."""
    return tuple(
        fit_sphere(sample.points_in_scanner, diameter_mm=diameter_mm, fix_diameter=True) for sample in samples
    )


def judge_balls(samples: Sequence[ScanSample], spheres: Sequence[SphereFit]) -> list[Reason]:
    """What speaks against single scans, each with the scan's name."""
    limits = SphereLimits()
    return [
        Reason(reason.code, f"Scan '{sample.name}': {reason.message}")
        for sample, sphere in zip(samples, spheres, strict=True)
        for reason in judge_sphere(sphere, limits).reasons
    ]


def judge_returned(returned_mm: float, limit_mm: float) -> list[Reason]:
    """What the scan says that was taken at the first place again after all others."""
    return above(
        Code.HELD_OUT_ERROR,
        returned_mm,
        limit_mm,
        "The distance of the ball from where the first scan saw it, back at the same place after all other scans,",
        "The ball, the stage or the robot has moved meanwhile: fasten everything and scan again.",
    )


def solve(samples: Sequence[ScanSample], diameter_mm: float) -> BallOutcome:
    """Fit the ball in every scan, then the stage on most of them, then check on the rest.

    Args:
        samples: Scans of the ball standing still; the last at the place of the first.
        diameter_mm: The certified diameter.

    Raises:
        InputError: a scan shows no ball, or the positions do not determine the stage.
    """
    spheres = find_balls(samples, diameter_mm)
    returned_mm = float(np.linalg.norm(spheres[-1].center_mm - spheres[0].center_mm))
    fitted, held = split(len(samples) - 1)
    stage = solve_stage(_observations([samples[i] for i in fitted], [spheres[i] for i in fitted]))
    errors = [
        np.linalg.norm(
            transform_points(
                stage.measure_from_scanner_at(samples[i].stage_mm, samples[i].stage.theta_rad), spheres[i].center_mm
            )
            - stage.ball_in_measure_mm
        )
        for i in held
    ]
    held_out = HeldOut("ball centre in {M}", np.array(errors), HELD_OUT_LIMIT_MM)
    reasons = [
        *judge_returned(returned_mm, RETURNED_LIMIT_MM),
        *judge_balls(samples, spheres),
        *judge_stage(stage, StageLimits()).reasons,
        *held_out.reasons("The ball or the scanner may have moved between the scans: fasten both, scan again."),
    ]
    return BallOutcome(spheres, stage, held_out, returned_mm, Verdict.of(reasons))


def _observations(samples: Sequence[ScanSample], spheres: Sequence[SphereFit]) -> StageObservations:
    return StageObservations(
        stage_mm=np.array([sample.stage_mm for sample in samples]),
        stage_rad=np.array([sample.stage.theta_rad for sample in samples]),
        ball_in_scanner_mm=np.array([sphere.center_mm for sphere in spheres]),
        sigma_mm=np.array([np.sqrt(np.trace(sphere.covariance_mm2) / 3.0) for sphere in spheres]),
    )


def record(outcome: BallOutcome) -> dict[str, Any]:
    """For the session and the report."""
    return {
        "stage": stage_record(outcome.stage, Verdict()),
        "spheres": [sphere_record(sphere, Verdict()) for sphere in outcome.spheres],
        "held_out": plain(outcome.held_out.block()),
        "returned_mm": outcome.returned_mm,
        "verdict": verdict_block(outcome.verdict),
    }
