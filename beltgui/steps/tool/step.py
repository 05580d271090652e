"""Stylus and tool: the stylus tip in the flange, then the wheel frame {H} of every grinder."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from beltgui.session import Session
from beltgui.steps import head_rest
from beltgui.steps.blocks import degrees, plain, verdict_block
from beltgui.steps.context import Context
from beltgui.steps.held_out import HeldOut, split
from beltgui.steps.tool.record import stylus_record, wheel_record
from core.frames import transform_points
from core.tool import (
    StylusFit,
    StylusLimits,
    WheelFit,
    WheelLimits,
    WheelTouches,
    judge_stylus,
    judge_wheel,
    solve_stylus,
    solve_wheel,
)
from core.verdict import Reason, Verdict
from devices.cell_plan import GrinderPlan
from devices.interfaces import Mount, TouchCone, TouchShaft

Array = NDArray[np.float64]
CONE = "cone_touch"
SHAFT = "shaft_touch"
CONE_LIMIT_MM = 0.5
SHAFT_LIMIT_MM = 0.5


@dataclass(frozen=True, eq=False)
class ShaftTouch:
    """One touch of a wheel shaft's centre mark.

    Attributes:
        grinder: Its name.
        angle_rad: Head angle by the grinder's sensor.
        base_from_flange: (4, 4) as the robot reported it.
    """

    grinder: str
    angle_rad: float
    base_from_flange: Array


@dataclass(frozen=True, eq=False)
class ToolSamples:
    """All touches of the step.

    Attributes:
        cone: (4, 4) each, base_from_flange with the tip in the cone.
        shafts: Touches of all grinders.
        rests_rad: Head angles at the stop, by grinder.
    """

    cone: tuple[Array, ...]
    shafts: tuple[ShaftTouch, ...]
    rests_rad: Mapping[str, tuple[float, ...]]


@dataclass(frozen=True, eq=False)
class ToolOutcome:
    """What the step found.

    Attributes:
        stylus: Tip in the flange.
        cone_held_out: Pivot by touches kept out.
        wheels: {H} of each grinder.
        shafts_held_out: Of each grinder: the centre mark by touches kept out.
        rests_rad: What each head's sensor reads at the stop, for as long as its zero stays where it is.
        verdict: Of all of it.
    """

    stylus: StylusFit
    cone_held_out: HeldOut
    wheels: Mapping[str, WheelFit]
    shafts_held_out: Mapping[str, HeldOut]
    rests_rad: Mapping[str, tuple[float, ...]]
    verdict: Verdict


def acquire(context: Context) -> ToolSamples:
    """Ask for the stylus, the touches in the cone and the touches of every wheel shaft."""
    operator, touches = context.cell.operator, context.plan.stylus.touches
    operator.perform(Mount("stylus"))
    total = len(touches) + sum(len(grinder.touch_angles_rad) for grinder in context.plan.grinders.values())
    done = 0
    for index, near in enumerate(touches):
        context.job.report(done / total, f"cone touch {index + 1} of {len(touches)}")
        operator.perform(TouchCone(index, len(touches), near))
        reading = context.cell.robot.read()
        data = {"base_from_flange": reading.base_from_flange.tolist(), "time_s": reading.time_s}
        context.session.add_sample("tool", CONE, data)
        done += 1
    for name, grinder in context.plan.grinders.items():
        head_rest.acquire(context, "tool", name)
        for angle_rad in grinder.touch_angles_rad:
            context.job.report(done / total, f"grinder {name}: shaft at {np.degrees(angle_rad):+.0f} degrees")
            operator.perform(TouchShaft(name, angle_rad, grinder.touch_from_flange))
            reading = context.cell.robot.read()
            head = context.cell.grinders[name].read()
            data = {
                "grinder": name,
                "angle_rad": head.angle_rad,
                "base_from_flange": reading.base_from_flange.tolist(),
                "time_s": reading.time_s,
            }
            context.session.add_sample("tool", SHAFT, data)
            done += 1
    return read(context.session)


def read(session: Session) -> ToolSamples:
    """The touches as they were kept.

    Raises:
        InputError: there are none.
    """
    cone = tuple(np.array(sample.data["base_from_flange"]) for sample in session.kept("tool", CONE))
    shafts = tuple(
        ShaftTouch(s.data["grinder"], s.data["angle_rad"], np.array(s.data["base_from_flange"]))
        for s in session.kept("tool", SHAFT)
    )
    return ToolSamples(cone, shafts, head_rest.read(session, "tool"))


def solve(samples: ToolSamples, grinders: Mapping[str, GrinderPlan]) -> ToolOutcome:
    """Solve stylus and wheels on most touches, check on the rest.

    Args:
        samples: All touches.
        grinders: What is known of each grinder: Rg and the way from the touched mark to the wheel's mid-plane.

    Raises:
        InputError: the touches do not determine the tip or a wheel.
    """
    fitted, held = split(len(samples.cone))
    cone = np.array(samples.cone)
    stylus = solve_stylus(cone[fitted])
    missed = [transform_points(cone[i], stylus.tip_in_flange_mm) - stylus.pivot_in_base_mm for i in held]
    cone_held_out = HeldOut("cone's point", np.linalg.norm(np.reshape(missed, (-1, 3)), axis=1), CONE_LIMIT_MM)
    reasons = [
        *judge_stylus(stylus, StylusLimits()).reasons,
        *cone_held_out.reasons("Touch the cone again, pressing lightly, and see that the stylus sits tight."),
    ]
    wheels: dict[str, WheelFit] = {}
    shafts_held_out: dict[str, HeldOut] = {}
    for name, plan in grinders.items():
        touches = [touch for touch in samples.shafts if touch.grinder == name]
        wheels[name], shafts_held_out[name] = _solve_wheel(touches, stylus, plan)
        found = [
            *judge_wheel(wheels[name], WheelLimits()).reasons,
            *shafts_held_out[name].reasons("Touch the centre mark again; see that the head was held still."),
        ]
        reasons += [Reason(reason.code, f"Grinder {name}: {reason.message}") for reason in found]
    return ToolOutcome(stylus, cone_held_out, wheels, shafts_held_out, samples.rests_rad, Verdict.of(reasons))


def _solve_wheel(touches: Sequence[ShaftTouch], stylus: StylusFit, plan: GrinderPlan) -> tuple[WheelFit, HeldOut]:
    angles = np.array([touch.angle_rad for touch in touches])
    points = np.array([
        transform_points(touch.base_from_flange, stylus.tip_in_flange_mm) for touch in touches
    ]).reshape(-1, 3)
    fitted, held = split(len(touches))
    fit = solve_wheel(
        WheelTouches(angles[fitted], points[fitted]),
        radius_mm=plan.head_radius_mm,
        shaft_offset_mm=-plan.shaft_side_offset_mm,
    )
    predicted = np.array([shaft_mark(fit, angles[i], plan.shaft_side_offset_mm) for i in held]).reshape(-1, 3)
    errors = np.linalg.norm(predicted - points[held], axis=1)
    return fit, HeldOut(f"centre mark of grinder {plan.name}", errors, SHAFT_LIMIT_MM)


def shaft_mark(fit: WheelFit, angle_rad: float, shaft_side_offset_mm: float) -> Array:
    """Where the centre mark is in {B} at a head angle: the mark turns about the head's axis, z of {H}."""
    radius = fit.radius_mm
    in_tool = np.array([radius * (np.cos(angle_rad) - 1.0), radius * np.sin(angle_rad), shaft_side_offset_mm])
    return transform_points(fit.base_from_tool, in_tool)


def record(outcome: ToolOutcome) -> dict[str, Any]:
    """For the session and the report."""
    return {
        "stylus": stylus_record(outcome.stylus, Verdict()),
        "cone_held_out": plain(outcome.cone_held_out.block()),
        "wheels": {name: wheel_record(fit, Verdict()) for name, fit in outcome.wheels.items()},
        "shafts_held_out": {name: plain(held.block()) for name, held in outcome.shafts_held_out.items()},
        "head_rests_deg": {name: degrees(angles) for name, angles in outcome.rests_rad.items()},
        "verdict": verdict_block(outcome.verdict),
    }
