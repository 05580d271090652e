"""Stylus and tool: the stylus tip in the flange, then the wheel frame {H} of every grinder."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from beltgui.jobs import Job
from beltgui.steps.blocks import degrees, plain, verdict_block
from beltgui.steps.held_out import HeldOut, is_held_out
from beltgui.steps.room import Bench
from beltgui.steps.tool.record import stylus_record, wheel_record
from beltgui.steps.tool.touches import ConeTouch, ShaftTouch, Touches, Wanted, missing, read, wanted
from core.errors import InputError
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
from core.verdict import Code, Reason, Verdict
from devices.cell_plan import GrinderPlan

Array = NDArray[np.float64]
CONE_LIMIT_MM = 0.5
SHAFT_LIMIT_MM = 0.5


@dataclass(frozen=True, eq=False)
class ToolOutcome:
    """What the step found.

    Attributes:
        touches: All that were not deleted.
        fitted_cone: Those that the stylus was fitted to, in the order of its residuals.
        stylus: Tip in the flange.
        cone_misses_mm: By sample id, (3,) the tip less the pivot, in {B}.
        cone_held_out: Pivot by touches kept out.
        fitted_shafts: By grinder, those that its wheel was fitted to, in the order of its residuals.
        wheels: {H} of each grinder whose touches determine it.
        unsolved: By grinder, why its touches do not determine its wheel.
        shaft_misses_mm: By sample id, (3,) the touch less the centre mark at its head angle, in {B}.
        shafts_held_out: Of each solved grinder: the centre mark by touches kept out.
        rests_rad: What each head's sensor reads at the stop, for as long as its zero stays where it is.
        verdict: Of all of it.
    """

    touches: Touches
    fitted_cone: tuple[ConeTouch, ...]
    stylus: StylusFit
    cone_misses_mm: dict[int, Array]
    cone_held_out: HeldOut
    fitted_shafts: Mapping[str, tuple[ShaftTouch, ...]]
    wheels: Mapping[str, WheelFit]
    unsolved: Mapping[str, str]
    shaft_misses_mm: dict[int, Array]
    shafts_held_out: Mapping[str, HeldOut]
    rests_rad: Mapping[str, tuple[float, ...]]
    verdict: Verdict


@dataclass(frozen=True, eq=False)
class _Wheel:
    fitted: tuple[ShaftTouch, ...]
    fit: WheelFit
    misses_mm: dict[int, Array]
    held_out: HeldOut

    def reasons(self) -> list[Reason]:
        return [
            *judge_wheel(self.fit, WheelLimits(), [touch.name for touch in self.fitted]).reasons,
            *self.held_out.reasons("Touch the centre mark again; see that the head was held still."),
        ]


def solve(bench: Bench, job: Job) -> ToolOutcome:
    """Solve stylus and wheels on most touches, check on the rest.

    Raises:
        InputError: the touches do not determine the tip.
        Cancelled: the job was cancelled.
    """
    job.report(0.0, "solving stylus and wheels")
    touches = read(bench.session)
    included = [touch for touch in touches.cone if touch.included]
    planned = len(bench.plan.stylus.touches)
    fitted = [touch for touch in included if not is_held_out(touch.slot, planned)]
    stylus = solve_stylus(np.array([touch.base_from_flange for touch in fitted]).reshape(-1, 4, 4))
    cone_misses = {touch.id: tip_in_base(touch, stylus) - stylus.pivot_in_base_mm for touch in touches.cone}
    errors = [np.linalg.norm(cone_misses[touch.id]) for touch in included if is_held_out(touch.slot, planned)]
    cone_held_out = HeldOut("cone's point", np.array(errors), CONE_LIMIT_MM)
    wheels: dict[str, _Wheel] = {}
    unsolved: dict[str, str] = {}
    found: list[Reason] = []
    for name, plan in bench.plan.grinders.items():
        try:
            wheels[name] = _solve_wheel([touch for touch in touches.shafts if touch.grinder == name], stylus, plan)
        except InputError as error:
            unsolved[name] = str(error)
            reasons: Sequence[Reason] = [Reason(error.code, str(error))]
        else:
            reasons = wheels[name].reasons()
        found += [Reason(reason.code, f"Grinder {name}: {reason.message}") for reason in reasons]
    verdict = Verdict.of([
        *_missing_reasons(touches, wanted(bench.session, bench.plan)),
        *judge_stylus(stylus, StylusLimits(), [touch.name for touch in fitted]).reasons,
        *cone_held_out.reasons("Touch the cone again, pressing lightly, and see that the stylus sits tight."),
        *found,
        *_rest_reasons(touches),
    ])
    return ToolOutcome(
        touches=touches,
        fitted_cone=tuple(fitted),
        stylus=stylus,
        cone_misses_mm=cone_misses,
        cone_held_out=cone_held_out,
        fitted_shafts={name: wheel.fitted for name, wheel in wheels.items()},
        wheels={name: wheel.fit for name, wheel in wheels.items()},
        unsolved=unsolved,
        shaft_misses_mm={number: miss for wheel in wheels.values() for number, miss in wheel.misses_mm.items()},
        shafts_held_out={name: wheel.held_out for name, wheel in wheels.items()},
        rests_rad=touches.rests_rad(),
        verdict=verdict,
    )


def tip_in_base(touch: ConeTouch | ShaftTouch, stylus: StylusFit) -> Array:
    """(3,) the stylus tip of a touch in {B}."""
    return transform_points(touch.base_from_flange, stylus.tip_in_flange_mm)


def _solve_wheel(touches: Sequence[ShaftTouch], stylus: StylusFit, plan: GrinderPlan) -> _Wheel:
    included = [touch for touch in touches if touch.included]
    planned = len(plan.touch_angles_rad)
    fitted = [touch for touch in included if not is_held_out(touch.slot, planned)]
    fit = solve_wheel(
        WheelTouches(
            np.array([touch.angle_rad for touch in fitted]),
            np.array([tip_in_base(touch, stylus) for touch in fitted]).reshape(-1, 3),
        ),
        radius_mm=plan.head_radius_mm,
        shaft_offset_mm=-plan.shaft_side_offset_mm,
    )
    misses = {
        touch.id: tip_in_base(touch, stylus) - shaft_mark(fit, touch.angle_rad, plan.shaft_side_offset_mm)
        for touch in touches
    }
    errors = [np.linalg.norm(misses[touch.id]) for touch in included if is_held_out(touch.slot, planned)]
    held_out = HeldOut(f"centre mark of grinder {plan.name}", np.array(errors), SHAFT_LIMIT_MM)
    return _Wheel(tuple(fitted), fit, misses, held_out)


def shaft_mark(fit: WheelFit, angle_rad: float, shaft_side_offset_mm: float) -> Array:
    """Where the centre mark is in {B} at a head angle: the mark turns about the head's axis, z of {H}."""
    radius = fit.radius_mm
    in_tool = np.array([radius * (np.cos(angle_rad) - 1.0), radius * np.sin(angle_rad), shaft_side_offset_mm])
    return transform_points(fit.base_from_tool, in_tool)


def _missing_reasons(touches: Touches, want: Wanted) -> list[Reason]:
    absent = missing(touches, want)
    if not absent.count:
        return []
    return [Reason(
        Code.NOT_ENOUGH_POINTS,
        f"{absent.count} of {want.count} planned touches and readings are missing. Take the missing ones.",
    )]  # fmt: skip


def _rest_reasons(touches: Touches) -> list[Reason]:
    """A head that was read at its stop, but whose reading was left out."""
    read_there = {rest.grinder for rest in touches.rests}
    return [
        Reason(
            Code.BAD_INPUT,
            f"Grinder {name}: the reading of its head at the stop is left out, so a shift of the sensor's zero would "
            "not show later. Take it in again, or delete it and read it again.",
        )
        for name in sorted(read_there - touches.rests_rad().keys())
    ]


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


def headline(outcome: ToolOutcome) -> str:
    """How well the worst grinder's mark is predicted by what was not fitted to it."""
    held = [held.rms_mm for held in outcome.shafts_held_out.values() if len(held.errors_mm)]
    if not held:
        return f"fitted stylus {outcome.stylus.rms_mm:.3f} mm RMS"
    return f"held-out shaft mark {max(held):.3f} mm RMS"
