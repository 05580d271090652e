"""What the screen shows of the ball step."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import replace

import numpy as np
from numpy.typing import NDArray

from beltgui.steps.ball.advice import StageAdvice, advise, worst_point_sigma
from beltgui.steps.ball.closing import is_complete, taken
from beltgui.steps.ball.found import BallScan, ball_scans
from beltgui.steps.ball.pictures import plots, scene, scene_of_ball, scene_of_plan, scene_of_scan
from beltgui.steps.ball.rows import WHERE_COLUMNS, note_of, use_of, where_cells
from beltgui.steps.ball.step import STEP, BallOutcome, headline, wanted_poses
from beltgui.steps.room import Bench
from beltgui.steps.views.common import (
    UM_PER_MM,
    check_of,
    euler_numbers,
    finite,
    in_um,
    limit_check,
    missing,
    number_of,
    position_numbers,
    progress_text,
    reasons_of,
    with_worst_flagged,
)
from beltgui.viewmodel.step import Check, Column, Number, SampleRow, StepContent, Suggestion
from core.ball import StageFit, StageLimits
from core.ball.stage import propagated
from core.ball.stage_model import StageModel

Array = NDArray[np.float64]

COLUMNS = (Column("residual", "Off the model", "µm", 1), *WHERE_COLUMNS)


def content(bench: Bench, outcome: BallOutcome | None, error: str) -> StepContent:
    """See `Room.view`."""
    wanted = wanted_poses(bench)
    scans = ball_scans(bench, STEP)
    complete = is_complete(scans, len(wanted))
    progress = progress_text(taken(scans, len(wanted)), len(wanted) + 1, "scans")
    shown = StepContent(
        columns=COLUMNS,
        rows=rows(scans, outcome, len(bench.plan.stage_step)),
        reasons=missing(error),
        progress=progress,
        complete=complete,
    )
    if outcome is None:
        picture = scene_of_scan(bench.plan, scans[-1]) if scans else scene_of_plan(bench.plan)
        return replace(shown, headline=progress, scene=picture)
    absent = [pose for slot, pose in enumerate(wanted) if _absent(scans, slot)]
    advice = advise(outcome.stage, bench.plan, absent, outcome.sigma_mm)
    return replace(
        shown,
        numbers=numbers(outcome, worst_point_sigma(outcome.stage, bench.plan)),
        ok=outcome.verdict.ok,
        reasons=reasons_of(outcome.verdict),
        remarks=remarks(outcome),
        checks=checks(outcome),
        suggestion=None if advice is None else suggestion(advice),
        provisional=not complete,
        headline=headline(outcome),
        scene=scene(bench.plan, outcome, advice),
        second_scene=scene_of_ball(bench.plan, scans),
        plots=plots(outcome, len(bench.plan.stage_step)),
        extra={} if advice is None or advice.planned else {
            "suggested": stage_values(advice), "extra": bench.session.setting(STEP, "extra", []),
        },
    )


def _absent(scans: Sequence[BallScan], slot: int) -> bool:
    return all(scan.closing or scan.slot != slot for scan in scans)


def rows(scans: Sequence[BallScan], outcome: BallOutcome | None, planned: int) -> tuple[SampleRow, ...]:
    """One for each scan; scans left out keep the residual that they would have."""
    odd = None
    if outcome is not None and outcome.stage.outlier is not None:
        odd = outcome.fitted[outcome.stage.outlier].id
    found = []
    for scan in scans:
        miss = None if outcome is None else outcome.misses_mm.get(scan.id)
        residual = None if miss is None else in_um(float(np.linalg.norm(miss)))
        flag = "refused" if scan.seen.sphere is None else "outlier" if scan.id == odd else ""
        note = note_of(scan, None if outcome is None else outcome.returned)
        found.append(SampleRow(
            scan.id, scan.name, (residual, *where_cells(scan)), use_of(scan, planned), scan.included, flag, note
        ))  # fmt: skip
    return with_worst_flagged(found, 0)


def numbers(outcome: BallOutcome, point_sigma_mm: float) -> tuple[Number, ...]:
    """Of the stage, each with ± (k = 2) from the covariance."""
    fit, limits = outcome.stage, StageLimits()
    euler = None if fit.covariance is None else fit.covariance.matrix[:3, :3]
    ball = None if fit.model_covariance is None else fit.ball_covariance_mm2()
    square = [None] * 3 if fit.squareness_sigma_rad is None else np.degrees(fit.squareness_sigma_rad).tolist()
    return (
        number_of("Held-out ball, RMS", in_um(outcome.held_out.rms_mm), "µm", decimals=1,
                  limit=UM_PER_MM * outcome.held_out.limit_mm, main=True),
        number_of("Scanned point in {M}, uncertainty (k = 2), worst planned scan",
                  in_um(2.0 * point_sigma_mm), "µm", decimals=1, main=True),
        *(number_of(f"Squareness of axes {pair}, angle less 90 deg", float(np.degrees(angle)), "deg", sigma=sigma,
                    decimals=4, limit=float(np.degrees(limits.max_squareness_rad)), main=True)
          for pair, angle, sigma in zip(("xy", "yz", "zx"), fit.squareness_rad, square, strict=True)),
        *_scale_numbers(fit),
        *euler_numbers("Scanner {S} in {M} at stage zero, turn", fit.measure_from_scanner[:3, :3], euler),
        *_rotary_numbers(fit),
        *position_numbers("Ball in {M}", fit.ball_in_measure_mm, ball),
        number_of("Residuals of the fit, RMS", in_um(fit.rms_mm), "µm", decimals=1,
                  limit=UM_PER_MM * limits.max_rms_mm),
        number_of("Noise of a ball centre, each coordinate", in_um(outcome.sigma_mm), "µm", decimals=1),
        number_of("Scatter of the stage in it, each coordinate", in_um(outcome.scatter_mm), "µm", decimals=1),
        number_of("Ball from the first to the closing scan", in_um(outcome.returned_mm), "µm", decimals=1,
                  limit=UM_PER_MM * outcome.returned.limit_mm),
        _diameter_number(outcome),
        number_of("Condition of the fit", fit.conditioning.condition, "", decimals=1, limit=limits.max_condition),
    )  # fmt: skip


def _scale_numbers(fit: StageFit) -> list[Number]:
    sigmas: list[float | None] = [None] * 3
    if fit.model_covariance is not None:
        spread = np.sqrt(np.diag(of_model(fit, lambda model, _: np.linalg.norm(model.axes, axis=0))))
        for index, sigma in zip(np.flatnonzero(fit.moved), spread, strict=True):
            sigmas[index] = float(sigma)
    return [
        number_of(f"Scale of stage axis {axis}, moved per commanded", float(scale), "mm/mm", sigma=sigma, decimals=6)
        for axis, scale, sigma in zip("xyz", fit.scale, sigmas, strict=True)
    ]


def _rotary_numbers(fit: StageFit) -> list[Number]:
    if fit.rotary_axis is None:
        return []
    direction: list[float | None] = [None] * 3
    point = None
    if fit.model_covariance is not None:
        direction = np.sqrt(np.diag(of_model(fit, _direction))).tolist()
        point = of_model(fit, _point)
    return [
        *(number_of(f"Rotary axis in {{M}}, direction {axis}", float(value), "", sigma=sigma, decimals=5)
          for axis, value, sigma in zip("xyz", fit.rotary_axis.direction, direction, strict=True)),
        *position_numbers("Rotary axis in {M}, point nearest to the origin,", fit.rotary_axis.point_mm, point),
    ]  # fmt: skip


def of_model(fit: StageFit, function: Callable[[StageModel, Array], Array]) -> Array:
    """Covariance of a function of the model's unknowns and of the rotation (3, 3) of {M} from the scanner at zero."""
    assert fit.model_covariance is not None
    return propagated(fit.model, fit.model_covariance, lambda model: function(model, _gauge(fit, model)))


def _gauge(fit: StageFit, model: StageModel) -> Array:
    at = 0.0 if fit.rotary_axis is not None else fit.rotary_reference_rad
    return np.asarray(replace(fit, model=model).measure_from_scanner_at(np.zeros(3), at)[:3, :3])


def _direction(model: StageModel, rotation: Array) -> Array:
    assert model.rotary is not None
    return np.asarray(rotation @ model.rotary)


def _point(model: StageModel, rotation: Array) -> Array:
    assert model.point is not None
    return np.asarray(rotation @ model.point)


def _diameter_number(outcome: BallOutcome) -> Number:
    """Weighted mean of what the scans themselves say about the certified diameter."""
    free = np.array([[sphere.free_diameter_mm, sphere.free_diameter_sigma_mm] for sphere in outcome.spheres])
    weights = 1.0 / free[:, 1] ** 2
    certified = outcome.spheres[0].diameter_mm
    mean, sigma = float(weights @ free[:, 0] / weights.sum()), float(1.0 / np.sqrt(weights.sum()))
    return number_of(f"Ball's diameter by the scans alone, certified {certified:.3f} mm", mean, "mm", sigma=sigma)


def checks(outcome: BallOutcome) -> tuple[Check, ...]:
    """On scans that the fit has not seen."""
    back = outcome.returned
    return (
        check_of(outcome.held_out, "µm"),
        limit_check("Ball at the first place again, after all other scans", in_um(back.moved_mm),
                    UM_PER_MM * back.limit_mm, "µm"),
    )  # fmt: skip


def remarks(outcome: BallOutcome) -> tuple[str, ...]:
    """Worth knowing, without rejecting."""
    fit = outcome.stage
    found = [
        f"Stage axis {name} has not moved: its direction and scale are assumed, not measured." for name in fit.assumed
    ]
    if fit.rotary_axis is None:
        found.append("The rotary axis has not moved: scans at another angle cannot be placed.")
    left_out = sum(not scan.included for scan in outcome.scans)
    if left_out:
        found.append(f"{left_out} scans are left out.")
    if finite(fit.conditioning.condition) is not None:
        found.append(f"Least certain together: {fit.conditioning.description}.")
    return tuple(found)


def suggestion(advice: StageAdvice) -> Suggestion:
    """In words."""
    if advice.opens:
        return Suggestion(
            f"Scan '{advice.pose.name}' next: stage axis {', '.join(advice.opens)} has not moved yet.",
            "Its direction becomes known.",
        )
    before, after = 2.0 * UM_PER_MM * advice.before_mm, 2.0 * UM_PER_MM * advice.after_mm
    improves = f"Uncertainty of a scanned point (k = 2): from {before:.1f} to {after:.1f} µm."
    if advice.planned:
        return Suggestion(f"Scan '{advice.pose.name}' next: of the missing scans it adds most.", improves)
    x, y, z, theta_deg = stage_values(advice)
    return Suggestion(
        f"One more scan adds most with the stage at x {x:.1f} mm, y {y:.1f} mm, z {z:.1f} mm, turned by "
        f"{theta_deg:.1f} deg.",
        improves,
    )


def stage_values(advice: StageAdvice) -> list[float]:
    """[x, y, z in mm, theta in deg]: what the setting `extra` holds."""
    stage = advice.pose.stage
    return [stage.x_mm, stage.y_mm, stage.z_mm, float(np.degrees(stage.theta_rad))]
