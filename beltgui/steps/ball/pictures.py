"""Pictures and plots of the ball step."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
from numpy.typing import NDArray

from beltgui.steps.ball.advice import StageAdvice
from beltgui.steps.ball.found import BallScan
from beltgui.steps.ball.rows import use_of
from beltgui.steps.ball.step import BallOutcome
from beltgui.steps.views import drawing
from beltgui.steps.views.common import ROLE_OF_USE, UM_PER_MM, in_um, marks_by_use
from beltgui.viewmodel.plot import LimitLine, Marks, Plot
from beltgui.viewmodel.scene import Item, Lines, Points, Role, Scene
from beltgui.viewmodel.step import Use
from core.ball import StageFit, StageLimits
from core.frames import transform_points
from devices.cell_plan import CellPlan

Array = NDArray[np.float64]
AXIS_LENGTH_MM = 70.0
# The largest residual is drawn about this long.
RESIDUAL_LENGTH_MM = 50.0
# From the scanner, a little from its right and from above: {S} has z away from the scanner and y down.
SCANNER_SIDE = (0.35, -0.35, -1.0)
LEGEND = (
    (Role.INLIER, "points on the ball"),
    (Role.OUTLIER, "other points of the scan"),
)


def scan_items(scan: BallScan, scene_from_scanner: Array) -> list[Item]:
    """The points of one scan in two roles and the ball found in them."""
    shown = drawing.display(transform_points(scene_from_scanner, scan.seen.shown))
    on_ball = scan.seen.shown_on_ball
    items: list[Item] = [
        Points("scan on the ball", shown[on_ball], Role.INLIER, size_px=3.0),
        Points("scan beside the ball", shown[~on_ball], Role.OUTLIER),
    ]
    if scan.seen.sphere is not None:
        center = transform_points(scene_from_scanner, scan.sphere.center_mm)
        items.append(drawing.sphere("ball", center, 0.5 * scan.sphere.diameter_mm))
    return items


def scene_of_plan(plan: CellPlan) -> Scene:
    """Before the first scan: where the stage will take the scanner, as drawn, in {M}."""
    at = np.array([[pose.stage.x_mm, pose.stage.y_mm, pose.stage.z_mm] for pose in plan.stage_step])
    items: list[Item] = [
        drawing.label("{M}", np.zeros(3), "{M}"),
        *drawing.triads("scanner", [np.eye(4)], 25.0),
        drawing.scanner_volume("scanner's volume", np.eye(4), plan.scanner),
        *drawing.arrows("stage axis", np.zeros(3), np.eye(3), AXIS_LENGTH_MM, [f"stage {name}" for name in "xyz"]),
        Points("planned scans", drawing.display(at), Role.SUGGESTION, size_px=8.0),
    ]
    legend = ((Role.SUGGESTION, "planned scan"), (Role.BOX, "where the scanner can see"))
    return drawing.scene("Scanner on its stage, as planned", "M", items, view="ball", legend=legend)


def scene_of_scan(plan: CellPlan, newest: BallScan) -> Scene:
    """A scan alone, in {S}."""
    items: list[Item] = [
        drawing.frame("S", np.eye(4)),
        drawing.scanner_volume("scanner's volume", np.eye(4), plan.scanner),
        *scan_items(newest, np.eye(4)),
    ]
    return drawing.scene(f"Scan '{newest.name}' as the scanner sees it", "S", items, view="scanner", legend=LEGEND)


def scene_of_ball(plan: CellPlan, scans: Sequence[BallScan]) -> Scene | None:
    """What the newest scan shows of the ball, large, in {S}; None before there is one."""
    if not scans:
        return None
    items = [drawing.scanner_volume("scanner's volume", np.eye(4), plan.scanner), *scan_items(scans[-1], np.eye(4))]
    return drawing.scene("Ball in the newest scan", "S", items, view="ball scan", legend=LEGEND,
                         look_from=SCANNER_SIDE, up=(0.0, -1.0, 0.0),
                         fit_to=("ball", "scan on the ball"))  # fmt: skip


def scene(plan: CellPlan, outcome: BallOutcome, advice: StageAdvice | None) -> Scene:
    """Scanner, stage axes and the ball in {M}."""
    fit = outcome.stage
    at_zero = fit.measure_from_scanner
    residuals, times = _residuals(outcome, len(plan.stage_step))
    items: list[Item | None] = [
        drawing.label("{M}", np.zeros(3), "{M}"),
        *drawing.triads("scanner", [at_zero], 25.0),
        drawing.scanner_volume("scanner's volume", at_zero, plan.scanner),
        *_axes(fit),
        drawing.sphere("ball", fit.ball_in_measure_mm, 0.5 * plan.ball.diameter_mm, opacity=0.35),
        *_positions(outcome, len(plan.stage_step)),
        *residuals,
        *_suggested(fit, advice),
    ]
    legend = (
        (Role.FIT, "in the fit"),
        (Role.HELD_OUT, "kept out of the fit"),
        (Role.SUGGESTION, "where one more scan would add most"),
        (Role.FIT, f"residuals drawn {times:.0f} times as long"),
    )
    return drawing.scene("Scanner on its stage", "M", items, view="ball", legend=legend)


def _axes(fit: StageFit) -> list[Item]:
    labels = [f"stage {name}{' (assumed)' if name in fit.assumed else ''}" for name in "xyz"]
    items: list[Item] = list(drawing.arrows("stage axis", np.zeros(3), fit.axes, AXIS_LENGTH_MM, labels))
    for (i, j), pair in zip(((0, 1), (1, 2), (2, 0)), ("xy", "yz", "zx"), strict=True):
        corner = 0.3 * AXIS_LENGTH_MM * np.array([fit.axes[:, i], fit.axes[:, i] + fit.axes[:, j], fit.axes[:, j]])
        items.append(Lines(f"square {pair}", (drawing.display(corner),), Role.MUTED, 1.0))
    if fit.rotary_axis is not None:
        low, high = (fit.rotary_axis.point_mm + way * fit.rotary_axis.direction for way in (-120.0, 120.0))
        items.append(drawing.segments("rotary axis", [low], [high], Role.MUTED))
        items.append(drawing.label("rotary axis label", high, "rotary axis"))
    return items


def _positions(outcome: BallOutcome, planned: int) -> list[Item]:
    """Where the scanner stood, by use."""
    found: dict[Use, list[Array]] = {}
    for scan in outcome.scans:
        if scan.id in outcome.misses_mm:
            pose = outcome.stage.measure_from_scanner_at(scan.stage_mm, scan.stage.theta_rad)
            found.setdefault(use_of(scan, planned), []).append(pose[:3, 3])
    return [
        Points(f"scanner, {use.value}", drawing.display(at), ROLE_OF_USE[use], size_px=8.0) for use, at in found.items()
    ]


def _residuals(outcome: BallOutcome, planned: int) -> tuple[list[Item], float]:
    """Lines at the ball, and how many times as long they are."""
    shown = [scan for scan in outcome.scans if scan.id in outcome.misses_mm]
    if not shown:
        return [], 1.0
    away = np.array([outcome.misses_mm[scan.id] for scan in shown])
    ball = outcome.stage.ball_in_measure_mm
    used = np.array([scan.usable for scan in shown])
    times = drawing.exaggeration(away[used] if used.any() else away, RESIDUAL_LENGTH_MM)
    items: list[Item] = []
    for use in Use:
        chosen = np.array([use_of(scan, planned) is use for scan in shown])
        if chosen.any():
            start = np.repeat(ball[None], int(chosen.sum()), axis=0)
            items.append(
                drawing.exaggerated(f"residuals, {use.value}", start, away[chosen], times, ROLE_OF_USE[use])
            )
    return items, times


def _suggested(fit: StageFit, advice: StageAdvice | None) -> list[Item]:
    if advice is None or advice.opens:
        return []
    stage = advice.pose.stage
    at = fit.measure_from_scanner_at([stage.x_mm, stage.y_mm, stage.z_mm], stage.theta_rad)[:3, 3]
    return [
        Points("suggested scanner", drawing.display(at), Role.SUGGESTION, size_px=12.0),
        drawing.label("suggested label", at, "next scan", Role.SUGGESTION),
    ]


def plots(outcome: BallOutcome, planned: int) -> tuple[Plot, ...]:
    """Residual of each scan, its components, and each scan predicted from the others."""
    number = {scan.id: float(index) for index, scan in enumerate(outcome.scans, start=1)}
    lengths = [
        (use_of(scan, planned), scan.id, number[scan.id], in_um(_length(outcome.misses_mm[scan.id])))
        for scan in outcome.scans if scan.id in outcome.misses_mm
    ]  # fmt: skip
    limits = StageLimits()
    limit = LimitLine(UM_PER_MM * outcome.held_out.limit_mm, "limit of the held-out RMS")
    alone = [
        (Use.FIT, scan.id, number[scan.id], in_um(float(error)))
        for scan, error in zip(outcome.fitted, outcome.stage.leave_one_out_mm, strict=True)
    ]
    held = [row for row in lengths if row[0] is Use.HELD_OUT]
    return (
        Plot("residuals", "Residuals", "scan", "distance of the ball from the model, µm",
             marks_by_use(lengths), (limit,)),
        Plot("components", "Components", "scan", "ball less model in {M}, µm", _components(outcome, number)),
        Plot("predicted", "Predicted", "scan", "distance from the prediction by all others, µm",
             marks_by_use([*alone, *held]),
             (LimitLine(UM_PER_MM * limits.max_outlier_mm, "limit where the others contradict"),)),
    )  # fmt: skip


def _components(outcome: BallOutcome, number: dict[int, float]) -> tuple[Marks, ...]:
    ids = tuple(scan.id for scan in outcome.scans if scan.id in outcome.misses_mm and scan.included)
    if not ids:
        return ()
    away = UM_PER_MM * np.array([outcome.misses_mm[sample] for sample in ids])
    x = np.array([number[sample] for sample in ids])
    roles = ((0, Role.X, "x"), (1, Role.Y, "y"), (2, Role.Z, "z"))
    return tuple(Marks(x, away[:, index], role, name, ids) for index, role, name in roles)


def _length(vector: Array) -> float:
    return float(np.linalg.norm(vector))
