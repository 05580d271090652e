"""What the screen shows of the base step."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

import numpy as np

from beltgui.steps.ball.closing import is_complete, taken
from beltgui.steps.ball.found import BallScan, ball_scans
from beltgui.steps.ball.pictures import scene_of_scan
from beltgui.steps.ball.rows import WHERE_COLUMNS, note_of, use_of, where_cells
from beltgui.steps.base.advice import PoseAdvice, advise, point_sigma_mm, pose_values
from beltgui.steps.base.pictures import plots, scene, scene_of_plan
from beltgui.steps.base.step import STEP, BaseOutcome, headline, wanted_poses
from beltgui.steps.room import Bench
from beltgui.steps.views.common import (
    check_of,
    euler_numbers,
    finite,
    largest_sigma,
    limit_check,
    missing,
    number_of,
    position_numbers,
    progress_text,
    reasons_of,
    with_worst_flagged,
)
from beltgui.viewmodel.step import Check, Column, Number, SampleRow, StepContent, Suggestion
from core.base import BaseLimits

COLUMNS = (
    Column("residual", "Robot off scanner", "mm", 3),
    Column("flange_x", "Flange x in {B}", "mm", 1),
    Column("flange_y", "Flange y in {B}", "mm", 1),
    Column("flange_z", "Flange z in {B}", "mm", 1),
    *WHERE_COLUMNS,
)


def content(bench: Bench, outcome: BaseOutcome | None, error: str) -> StepContent:
    """See `Room.view`."""
    wanted = wanted_poses(bench)
    scans = ball_scans(bench, STEP)
    complete = is_complete(scans, len(wanted))
    progress = progress_text(taken(scans, len(wanted)), len(wanted) + 1, "scans")
    planned = len(bench.plan.base_step)
    shown = StepContent(
        columns=COLUMNS,
        rows=rows(scans, outcome, planned),
        reasons=missing(error),
        progress=progress,
        complete=complete,
    )
    if outcome is None:
        picture = scene_of_scan(bench.plan, scans[-1]) if scans else scene_of_plan(bench.plan)
        return replace(shown, headline=progress, scene=picture)
    there = {scan.slot for scan in scans if not scan.closing}
    advice = advise(outcome.fit, wanted, [pose for slot, pose in enumerate(wanted) if slot not in there])
    return replace(
        shown,
        numbers=numbers(outcome),
        ok=outcome.verdict.ok,
        reasons=reasons_of(outcome.verdict),
        remarks=remarks(outcome),
        checks=checks(outcome),
        suggestion=None if advice is None else suggestion(advice),
        provisional=not complete,
        headline=headline(outcome),
        scene=scene(outcome, advice, planned, 0.5 * bench.plan.ball.diameter_mm),
        plots=plots(outcome, planned),
        extra={} if advice is None or advice.planned else {
            "suggested": pose_values(advice.pose), "extra": bench.session.setting(STEP, "extra", []),
        },
    )


def rows(scans: Sequence[BallScan], outcome: BaseOutcome | None, planned: int) -> tuple[SampleRow, ...]:
    """One for each scan; scans left out keep the residual that they would have."""
    odd = None
    if outcome is not None and outcome.fit.outlier is not None:
        odd = outcome.fitted[outcome.fit.outlier].id
    found = []
    for scan in scans:
        miss = None if outcome is None else outcome.misses_mm.get(scan.id)
        residual = None if miss is None else finite(float(np.linalg.norm(miss)))
        flag = "refused" if scan.seen.sphere is None else "outlier" if scan.id == odd else ""
        at = (float(value) for value in scan.base_from_flange[:3, 3])
        note = note_of(scan, None if outcome is None else outcome.returned)
        found.append(SampleRow(
            scan.id, scan.name, (residual, *at, *where_cells(scan)), use_of(scan, planned), scan.included, flag, note
        ))  # fmt: skip
    return with_worst_flagged(found, 0)


def numbers(outcome: BaseOutcome) -> tuple[Number, ...]:
    """Of the measuring frame and the ball, each with ± (k = 2) from the covariance."""
    fit, limits = outcome.fit, BaseLimits()
    pose = fit.base_from_measure
    origin = fit.covariance.of_point(pose[:3, 3])
    turn = fit.covariance.matrix[:3, :3]
    return (
        number_of("Held-out ball by robot against scanner, RMS", outcome.held_out.rms_mm, "mm",
                  limit=outcome.held_out.limit_mm, main=True),
        number_of("Middle of the balls in {B}, uncertainty (k = 2)", 2.0 * largest_sigma(fit.covariance.matrix[3:, 3:]),
                  "mm", limit=2.0 * limits.position_sigma_mm, main=True),
        number_of("Turn of {M} in {B}, uncertainty (k = 2)", float(np.degrees(2.0 * largest_sigma(turn))), "deg",
                  decimals=4, limit=float(np.degrees(2.0 * limits.rotation_sigma_rad)), main=True),
        *position_numbers("Origin of {M} in {B},", pose[:3, 3], origin, main=True),
        *euler_numbers("{M} in {B}, turn", pose[:3, :3], turn, main=True),
        *position_numbers("Ball in {F}", fit.ball_in_flange_mm, fit.ball_covariance_mm2),
        number_of("Ball in {F}, uncertainty (k = 2)", 2.0 * largest_sigma(fit.ball_covariance_mm2), "mm",
                  limit=2.0 * limits.ball_sigma_mm),
        number_of("Residuals of the fit, RMS", fit.rms_mm, "mm", limit=limits.rms_mm),
        number_of("Scatter of the robot, each coordinate", fit.robot_sigma_mm, "mm"),
        number_of("Ball from the first to the closing scan", outcome.returned_mm, "mm",
                  limit=outcome.returned.limit_mm),
        number_of("Point carried to {B} as far out as the balls, uncertainty (k = 2)", 2.0 * point_sigma_mm(fit), "mm"),
        number_of("Different poses in the fit", float(fit.different_poses), "", decimals=0),
        number_of("Condition of the fit", fit.conditioning.condition, "", decimals=1, limit=limits.condition),
    )  # fmt: skip


def checks(outcome: BaseOutcome) -> tuple[Check, ...]:
    """On poses that the fit has not seen."""
    back = outcome.returned
    return (
        check_of(outcome.held_out),
        limit_check("Ball in the first pose again, after all other poses", back.moved_mm, back.limit_mm, "mm"),
    )


def remarks(outcome: BaseOutcome) -> tuple[str, ...]:
    """Worth knowing, without rejecting."""
    fit = outcome.fit
    found = [f"Least certain together: {fit.conditioning.description}."]
    left_out = sum(not scan.included for scan in outcome.scans)
    if left_out:
        found.append(f"{left_out} scans are left out.")
    alone = [scan.name for scan, free in zip(outcome.fitted, fit.unchecked_directions, strict=True) if free]
    if alone:
        found.append(f"Only '{alone[0]}' is a witness of something: a pose like it would check it.")
    return tuple(found)


def suggestion(advice: PoseAdvice) -> Suggestion:
    """In words."""
    improves = (
        f"Uncertainty of a point carried to {{B}} (k = 2): from {2.0 * advice.before_mm:.3f} to "
        f"{2.0 * advice.after_mm:.3f} mm."
    )
    if advice.planned:
        return Suggestion(f"Scan '{advice.pose.name}' next: of the missing poses it adds most.", improves)
    x, y, z = advice.pose.base_from_flange[:3, 3]
    a, b, c = pose_values(advice.pose)["euler_zyx_deg"]
    return Suggestion(
        f"One more scan adds most with the flange at x {x:.1f} mm, y {y:.1f} mm, z {z:.1f} mm in {{B}}, turned by Z "
        f"{a:.1f} deg, Y' {b:.1f} deg, X'' {c:.1f} deg.",
        improves,
    )
