"""Picture and plots of the base step."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from beltgui.steps.ball.found import BallScan
from beltgui.steps.ball.rows import use_of
from beltgui.steps.base.advice import PoseAdvice
from beltgui.steps.base.step import BaseOutcome, by_robot, by_scanner
from beltgui.steps.views import drawing
from beltgui.steps.views.common import ROLE_OF_USE, marks_by_use
from beltgui.viewmodel.plot import LimitLine, Marks, Plot
from beltgui.viewmodel.scene import Arrow, Item, Points, Role, Scene
from beltgui.viewmodel.step import Use
from core.base import BaseLimits
from devices.cell_plan import CellPlan

Array = NDArray[np.float64]
TRIAD_MM = 25.0
# The largest residual is drawn about this long.
RESIDUAL_LENGTH_MM = 60.0
LEGEND = (
    (Role.FIT, "ball by the robot"),
    (Role.SCAN, "ball by the scanner"),
    (Role.HELD_OUT, "pose kept out of the fit"),
    (Role.EXCLUDED, "pose left out"),
    (Role.SUGGESTION, "pose that would add most"),
    (Role.ROBOT, "robot"),
)
# From behind the robot and above: poses, balls and {M} lie side by side.
LOOK_FROM = (-0.5, -0.7, 0.5)


def scene_of_plan(plan: CellPlan) -> Scene:
    """Before the first scan: the planned poses of the flange and {M} as drawn, in {B}."""
    poses = [pose.base_from_flange for pose in plan.base_step]
    flanges = np.array([pose[:3, 3] for pose in poses])
    items: list[Item] = [
        drawing.frame("B", np.eye(4), 120.0),
        drawing.robot_base("robot", np.eye(4)),
        drawing.frame("M", plan.base_from_measure, 80.0),
        *drawing.triads("flange", poses, TRIAD_MM),
        Points("planned poses", drawing.display(flanges), Role.SUGGESTION, size_px=8.0),
        *_towards_base(flanges),
    ]
    legend = ((Role.SUGGESTION, "planned pose of the flange"), (Role.ROBOT, "robot"))
    return drawing.scene("The ball on the flange, as planned", "B", items, view="base", legend=legend,
                         look_from=LOOK_FROM, fit_to=("{M}", "flange", "planned", "towards"))  # fmt: skip


def scene(outcome: BaseOutcome, advice: PoseAdvice | None, planned: int, ball_radius_mm: float) -> Scene:
    """Robot base, flange poses, the balls by robot and scanner, and {M}, in {B}."""
    fit = outcome.fit
    shown = [scan for scan in outcome.scans if scan.id in outcome.misses_mm]
    items: list[Item | None] = [
        drawing.frame("B", np.eye(4), 120.0),
        drawing.robot_base("robot", np.eye(4)),
        drawing.frame("M", fit.base_from_measure, 80.0),
        *drawing.triads("flange", [scan.base_from_flange for scan in shown], TRIAD_MM),
    ]
    if shown:
        seen = np.array([by_scanner(fit, outcome.balls_mm[scan.id]) for scan in shown])
        items.append(drawing.spheres("balls by the scanner", seen, ball_radius_mm, Role.SCAN, 0.35))
    for use in Use:
        items += _of_use(outcome, [scan for scan in shown if use_of(scan, planned) is use], use, shown, ball_radius_mm)
    legend = list(LEGEND)
    if shown:
        away = np.array([outcome.misses_mm[scan.id] for scan in shown])
        times = drawing.exaggeration(away, RESIDUAL_LENGTH_MM)
        legend.insert(1, (Role.FIT, f"residuals drawn {times:.0f} times as long"))
        items += _towards_base(np.array([scan.base_from_flange[:3, 3] for scan in shown]))
    items += _suggested(advice)
    title = "The ball on the flange, seen in many robot poses"
    return drawing.scene(title, "B", items, view="base", legend=legend, look_from=LOOK_FROM,
                         fit_to=("{M}", "flange", "balls", "residuals", "suggested", "towards"))  # fmt: skip


def _towards_base(flanges: Array) -> list[Item]:
    """An arrow from the poses towards the robot's base, with its distance: the base itself stands far off."""
    middle = flanges.mean(axis=0)
    distance = float(np.linalg.norm(middle))
    reach = float(np.linalg.norm(flanges - middle, axis=1).max()) + 60.0
    if distance < 2.0 * reach:
        return []
    way = -middle / distance
    text = f"{{B}} {distance:.0f} mm"
    return [Arrow("towards the base", middle + 0.45 * reach * way, 0.35 * reach * way, Role.ROBOT, text)]


def _of_use(
    outcome: BaseOutcome, scans: list[BallScan], use: Use, shown: list[BallScan], ball_radius_mm: float
) -> list[Item]:
    if not scans:
        return []
    times = drawing.exaggeration(np.array([outcome.misses_mm[scan.id] for scan in shown]), RESIDUAL_LENGTH_MM)
    robot = np.array([by_robot(outcome.fit, scan) for scan in scans])
    away = np.array([outcome.misses_mm[scan.id] for scan in scans])
    flanges = np.array([scan.base_from_flange[:3, 3] for scan in scans])
    role = ROLE_OF_USE[use]
    return [
        drawing.spheres(f"balls by the robot, {use.value}", robot, 0.6 * ball_radius_mm, role, 1.0),
        drawing.segments(f"flange to ball, {use.value}", flanges, robot, Role.MUTED, 1.0),
        drawing.exaggerated(f"residuals, {use.value}", robot - away, away, times, role, 3.0),
        Points(f"flange origins, {use.value}", drawing.display(flanges), role, size_px=7.0),
    ]


def _suggested(advice: PoseAdvice | None) -> list[Item]:
    if advice is None:
        return []
    pose = advice.pose.base_from_flange
    return [
        drawing.flange("suggested flange", pose, Role.SUGGESTION),
        *drawing.triads("suggested", [pose], 2.0 * TRIAD_MM, 3.0),
        drawing.label("suggested label", pose[:3, 3], f"next: {advice.pose.name}", Role.SUGGESTION),
    ]


def plots(outcome: BaseOutcome, planned: int) -> tuple[Plot, ...]:
    """Residual of each pose, its components, and each pose predicted from the others."""
    number = {scan.id: float(index) for index, scan in enumerate(outcome.scans, start=1)}
    lengths = [
        (use_of(scan, planned), scan.id, number[scan.id], float(np.linalg.norm(outcome.misses_mm[scan.id])))
        for scan in outcome.scans if scan.id in outcome.misses_mm
    ]  # fmt: skip
    alone = [
        (Use.FIT, scan.id, number[scan.id], float(error))
        for scan, error in zip(outcome.fitted, outcome.fit.leave_one_out_mm, strict=True)
    ]
    held = [row for row in lengths if row[0] is Use.HELD_OUT]
    limits = BaseLimits()
    return (
        Plot("residuals", "Residuals", "scan", "ball by robot off ball by scanner, mm", marks_by_use(lengths),
             (LimitLine(outcome.held_out.limit_mm, "limit of the held-out RMS"),)),
        Plot("components", "Components", "scan", "ball by robot less by scanner in {B}, mm",
             _components(outcome, number)),
        Plot("predicted", "Predicted", "scan", "distance from the prediction by all others, mm",
             marks_by_use([*alone, *held]),
             (LimitLine(limits.outlier_mm, "limit where the others contradict"),
              LimitLine(limits.worst_leave_one_out_mm, "limit of any"))),
    )  # fmt: skip


def _components(outcome: BaseOutcome, number: dict[int, float]) -> tuple[Marks, ...]:
    ids = tuple(scan.id for scan in outcome.scans if scan.id in outcome.misses_mm and scan.included)
    if not ids:
        return ()
    away = np.array([outcome.misses_mm[sample] for sample in ids])
    x = np.array([number[sample] for sample in ids])
    roles = ((0, Role.X, "x"), (1, Role.Y, "y"), (2, Role.Z, "z"))
    return tuple(Marks(x, away[:, index], role, name, ids) for index, role, name in roles)
