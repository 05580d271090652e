"""Picture and plots of the stylus and tool step."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
from numpy.typing import NDArray

from beltgui.steps.held_out import is_held_out
from beltgui.steps.tool.advice import Advice, ConeAdvice, angles_between_axes
from beltgui.steps.tool.step import ToolOutcome, shaft_mark, tip_in_base
from beltgui.steps.tool.touches import ConeTouch, ShaftTouch, Touches
from beltgui.steps.views import drawing
from beltgui.steps.views.common import ROLE_OF_USE, in_deg, marks_by_use
from beltgui.viewmodel.plot import Curve, LimitLine, Marks, Plot
from beltgui.viewmodel.scene import Arrow, Item, Lines, Points, Role, Scene
from beltgui.viewmodel.step import Use
from core.frames import transform_points
from core.tool import StylusLimits
from devices.cell_plan import CellPlan, GrinderPlan

Array = NDArray[np.float64]
# The directions of the flange are drawn on a ball of this size around the cone.
DIRECTIONS_MM = 60.0
RESIDUAL_LENGTH_MM = 40.0
LEGEND = (
    (Role.FIT, "touch in the fit"),
    (Role.HELD_OUT, "kept out of the fit"),
    (Role.EXCLUDED, "touch left out"),
    (Role.WHEEL, "contact wheel and its head axis"),
    (Role.SUGGESTION, "touch that would add most"),
)


PLANNED = (Role.SUGGESTION, "planned touch")
ALL = "all"
CONE = "cone"
# Beside the cone there is room for so many pictures.
MOST_GRINDERS = 2
LOOK_FROM = (0.3, -0.9, 0.35)


def scene(plan: CellPlan, touches: Touches, outcome: ToolOutcome | None, advice: Advice | None, focus: str) -> Scene:
    """The stylus in the cone and the grinders with their touches, in {B}.

    Args:
        plan: Nominal places where nothing has been found yet.
        touches: All of them.
        outcome: None before there is one.
        advice: Where one more touch would add most.
        focus: `CONE`, a grinder's name, or `ALL`: cone and grinders stand metres apart, each has a picture of its own.
    """
    grinders = {
        name: _grinder_scene(name, plan, touches, outcome, advice) for name in plan.grinders if focus in (name, ALL)
    }
    if focus in grinders:
        return grinders[focus]
    cone = _cone(plan, touches, outcome)
    legend = list(LEGEND) if touches.cone else [PLANNED]
    if outcome is not None:
        ways = np.array([outcome.cone_misses_mm[touch.id] for touch in outcome.touches.cone])
        starts = np.repeat(outcome.stylus.pivot_in_base_mm[None], len(ways), axis=0)
        residuals, words = _residuals(starts, ways)
        cone += residuals
        legend += words
        if isinstance(advice, ConeAdvice):
            cone += _suggested(advice, outcome, plan)
    beside = tuple(grinders.values())[:MOST_GRINDERS]
    return drawing.scene("Stylus in the cone", "B", cone, view=f"tool {focus}", legend=legend,
                         look_from=LOOK_FROM, fit_to=("cone", "stylus", "directions", "flange", "suggested"),
                         beside=beside)  # fmt: skip


def _grinder_scene(
    name: str, plan: CellPlan, touches: Touches, outcome: ToolOutcome | None, advice: Advice | None
) -> Scene:
    """A grinder's head with its wheel: as found, or as drawn while nothing is known."""
    grinder = plan.grinders[name]
    tip = plan.stylus.nominal_tip_in_flange_mm if outcome is None else outcome.stylus.tip_in_flange_mm
    fit = None if outcome is None else outcome.wheels.get(name)
    base_from_tool = grinder.base_from_tool if fit is None else fit.base_from_tool
    radius_mm = grinder.head_radius_mm if fit is None else fit.radius_mm
    shafts = [touch for touch in touches.shafts if touch.grinder == name]
    items = [
        *_wheel(name, base_from_tool, radius_mm, grinder, 0.5 if fit is not None else 0.25),
        *_touch_points(name, shafts, tip, len(grinder.touch_angles_rad)),
    ]
    legend = list(LEGEND)
    if fit is None:
        there = {touch.slot for touch in shafts}
        angles = np.array([angle for slot, angle in enumerate(grinder.touch_angles_rad) if slot not in there])
        marks = radius_mm * np.stack([np.cos(angles) - 1.0, np.sin(angles), 0.0 * angles], axis=1)
        marks[:, 2] = grinder.shaft_side_offset_mm
        marks = transform_points(base_from_tool, marks)
        items.append(Points(f"planned {name}", drawing.display(marks), Role.SUGGESTION, size_px=9.0))
        legend[-1] = PLANNED
    if outcome is not None:
        known = [shaft for shaft in outcome.touches.shafts
                 if shaft.grinder == name and shaft.id in outcome.shaft_misses_mm]  # fmt: skip
        ways = np.array([outcome.shaft_misses_mm[shaft.id] for shaft in known]).reshape(-1, 3)
        tips = np.array([tip_in_base(shaft, outcome.stylus) for shaft in known]).reshape(-1, 3)
        residuals, words = _residuals(tips - ways, ways)
        items += residuals
        legend += words
        if advice is not None and not isinstance(advice, ConeAdvice) and advice.grinder == name:
            items += _suggested(advice, outcome, plan)
    axis = base_from_tool[:3, 2] * (1.0 if grinder.shaft_side_offset_mm >= 0.0 else -1.0)
    look_from = axis + 0.45 * np.array([0.0, 0.0, 1.0]) + 0.5 * np.cross([0.0, 0.0, 1.0], axis)
    return drawing.scene(f"Grinder {name}", "B", items, view=f"tool {name}", legend=legend, look_from=look_from)


def _cone(plan: CellPlan, touches: Touches, outcome: ToolOutcome | None) -> list[Item | None]:
    tip = plan.stylus.nominal_tip_in_flange_mm if outcome is None else outcome.stylus.tip_in_flange_mm
    cone = plan.stylus.cone_in_base_mm if outcome is None else outcome.stylus.pivot_in_base_mm
    items: list[Item | None] = [
        drawing.label("cone label", cone - np.array([0.0, 0.0, 30.0]), "cone"),
        drawing.funnel("cone", cone, (0.0, 0.0, 1.0), 12.0, 18.0, Role.MUTED, 0.8),
    ]
    if touches.cone:
        return [*items, *_styluses(touches.cone, tip, cone, len(plan.stylus.touches))]
    flanges = np.array(plan.stylus.touches)
    ends = np.repeat(np.asarray(cone, dtype=float)[None], len(flanges), axis=0)
    return [
        *items,
        drawing.segments("stylus, planned", flanges[:, :3, 3], ends, Role.SUGGESTION, 1.5),
        *drawing.triads("flange", flanges, 25.0, 1.5),
    ]


def use_of(touch: ConeTouch | ShaftTouch, planned: int) -> Use:
    """What a touch is used for; `planned` touches there are of its cone or shaft."""
    if not touch.included:
        return Use.EXCLUDED
    return Use.HELD_OUT if is_held_out(touch.slot, planned) else Use.FIT


def _styluses(touches: Sequence[ConeTouch], tip: Array, cone: Array, planned: int) -> list[Item]:
    """Each touch as a line from the flange to the tip, and its direction on a small ball around the cone."""
    items: list[Item] = []
    for use in Use:
        chosen = [touch for touch in touches if use_of(touch, planned) is use]
        if not chosen:
            continue
        flanges = np.array([touch.base_from_flange for touch in chosen])
        tips = np.array([transform_points(flange, tip) for flange in flanges])
        role = ROLE_OF_USE[use]
        ways = flanges[:, :3, 3] - tips
        on_ball = cone + DIRECTIONS_MM * ways / np.linalg.norm(ways, axis=1, keepdims=True)
        items += [
            drawing.segments(f"stylus, {use.value}", flanges[:, :3, 3], tips, role, 1.5),
            Points(f"directions, {use.value}", drawing.display(on_ball), role, size_px=9.0),
        ]
    if touches:
        items += drawing.triads("flange", [touch.base_from_flange for touch in touches], 25.0, 1.5)
        items.append(drawing.sphere("directions", cone, DIRECTIONS_MM, Role.MUTED, 0.12))
    return items


def _touch_points(name: str, touches: Sequence[ShaftTouch], tip: Array, planned: int) -> list[Item]:
    items: list[Item] = []
    for use in Use:
        chosen = [touch for touch in touches if use_of(touch, planned) is use]
        if chosen:
            at = np.array([transform_points(touch.base_from_flange, tip) for touch in chosen])
            items.append(Points(f"touches {name}, {use.value}", drawing.display(at), ROLE_OF_USE[use], size_px=9.0))
    return items


def _wheel(name: str, base_from_tool: Array, radius_mm: float, plan: GrinderPlan, opacity: float) -> list[Item | None]:
    """Wheel circle and plane, the arc of the marks, the head axis and {H}."""
    center, axis = base_from_tool[:3, 3], base_from_tool[:3, 2]
    middle = transform_points(base_from_tool, [-radius_mm, 0.0, 0.0])
    on_mark = transform_points(base_from_tool, [-radius_mm, 0.0, plan.shaft_side_offset_mm])
    marks = drawing.arc(on_mark, axis, base_from_tool[:3, 0], radius_mm, *plan.travel_rad, 33)
    return [
        drawing.frame(f"H {name}", base_from_tool, 60.0),
        drawing.cylinder(
            f"wheel {name}", center, axis, plan.wheel_radius_mm, plan.wheel_width_mm, Role.WHEEL, opacity
        ),
        Lines(f"wheel circle {name}", (drawing.circle(center, axis, plan.wheel_radius_mm),), Role.WHEEL, 2.5),
        drawing.disc(f"wheel plane {name}", center, axis, 1.4 * plan.wheel_radius_mm, Role.WHEEL, 0.12),
        Lines(f"marks {name}", (marks,), Role.MUTED, 1.5),
        Lines(f"head {name}", (drawing.display(np.array([middle, center])),), Role.MUTED, 3.0),
        Arrow(f"head axis {name}", middle - 60.0 * axis, 120.0 * axis, Role.WHEEL, f"head axis {name}"),
    ]  # fmt: skip


def _residuals(starts: Array, ways: Array) -> tuple[list[Item | None], list[tuple[Role, str]]]:
    """Lines from `starts` (N, 3) along `ways` (N, 3), and what the legend says of them."""
    if not len(ways):
        return [], []
    times = drawing.exaggeration(ways, RESIDUAL_LENGTH_MM)
    lines = drawing.exaggerated("residuals", starts, ways, times, Role.ATTENTION, 3.0)
    return [lines], [(Role.ATTENTION, f"residuals drawn {times:.0f} times as long")]


def _suggested(advice: Advice, outcome: ToolOutcome, plan: CellPlan) -> list[Item]:
    if isinstance(advice, ConeAdvice):
        at = advice.base_from_flange[:3, 3]
        return [
            drawing.flange("suggested flange", advice.base_from_flange, Role.SUGGESTION),
            drawing.segments("suggested stylus", [at], [outcome.stylus.pivot_in_base_mm], Role.SUGGESTION, 3.0),
            drawing.label("suggested label", at, "next touch", Role.SUGGESTION),
        ]
    offset = plan.grinders[advice.grinder].shaft_side_offset_mm
    mark = shaft_mark(outcome.wheels[advice.grinder], advice.angle_rad, offset)
    return [
        Points("suggested mark", drawing.display(mark), Role.SUGGESTION, size_px=13.0),
        drawing.label("suggested label", mark, "next touch", Role.SUGGESTION),
    ]


# ---- plots


def plots(outcome: ToolOutcome, plan: CellPlan) -> tuple[Plot, ...]:
    """Residuals of cone and shafts, spread of the orientations, angle sensor."""
    return (
        _cone_plot(outcome, len(plan.stylus.touches)),
        *(_shaft_plot(name, outcome, grinder) for name, grinder in plan.grinders.items() if name in outcome.wheels),
        _orientations(outcome, len(plan.stylus.touches)),
    )


def _cone_plot(outcome: ToolOutcome, planned: int) -> Plot:
    misses = {sample: float(np.linalg.norm(miss)) for sample, miss in outcome.cone_misses_mm.items()}
    marks = [
        (use_of(touch, planned), touch.id, float(touch.slot + 1), misses[touch.id]) for touch in outcome.touches.cone
    ]
    return Plot(
        "cone", "Cone", "touch", "tip off the cone's point, mm", marks_by_use(marks),
        (LimitLine(outcome.cone_held_out.limit_mm, "limit of the held-out RMS"),
         LimitLine(StylusLimits().outlier_mm, "limit where the others contradict")),
    )  # fmt: skip


def _shaft_plot(name: str, outcome: ToolOutcome, plan: GrinderPlan) -> Plot:
    planned = len(plan.touch_angles_rad)
    marks = [
        (use_of(touch, planned), touch.id, in_deg(touch.angle_rad) or 0.0,
         float(np.linalg.norm(outcome.shaft_misses_mm[touch.id])))
        for touch in outcome.touches.shafts if touch.grinder == name and touch.id in outcome.shaft_misses_mm
    ]  # fmt: skip
    limit = LimitLine(outcome.shafts_held_out[name].limit_mm, "limit of the held-out RMS")
    return Plot(f"shaft {name}", f"Shaft {name}", "head angle, deg", "touch off the mark's circle, mm",
                marks_by_use(marks), (limit,))  # fmt: skip


def _orientations(outcome: ToolOutcome, planned: int) -> Plot:
    """The flange's axis in each cone touch: tilt as distance from the middle, azimuth as direction."""
    touches = outcome.touches.cone
    axes = np.array([touch.base_from_flange[:3, 2] for touch in touches])
    middle = axes.mean(axis=0)
    middle /= np.linalg.norm(middle)
    tilt = np.degrees(angles_between_axes(axes, middle))
    aside = (axes - np.outer(axes @ middle, middle))[:, :2]
    flat = aside * (tilt / np.maximum(np.linalg.norm(aside, axis=1), 1e-12))[:, None]
    uses = np.array([use_of(touch, planned).value for touch in touches])
    series: list[Marks | Curve] = []
    for use in Use:
        chosen = np.flatnonzero(uses == use.value)
        if len(chosen):
            ids = tuple(touches[index].id for index in chosen)
            series.append(Marks(flat[chosen, 0], flat[chosen, 1], ROLE_OF_USE[use], use.value, ids))
    turn = np.linspace(0.0, 2.0 * np.pi, 73)
    for ring in (10.0, 20.0, 30.0):
        series.append(Curve(ring * np.cos(turn), ring * np.sin(turn), Role.MUTED, f"tilt {ring:.0f} deg", dashed=True))
    return Plot(
        "orientations", "Orientations", "tilt of the flange towards x of {B}, deg",
        "tilt of the flange towards y of {B}, deg", tuple(series),
    )  # fmt: skip
