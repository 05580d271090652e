"""What the screen shows of the stylus and tool step."""

from __future__ import annotations

import math
from dataclasses import replace
from typing import Any

import numpy as np
from numpy.typing import NDArray

from beltgui.steps.room import Bench
from beltgui.steps.tool.advice import Advice, ConeAdvice, advise
from beltgui.steps.tool.numbers import numbers
from beltgui.steps.tool.pictures import ALL, CONE, plots, scene, use_of
from beltgui.steps.tool.step import ToolOutcome, headline
from beltgui.steps.tool.touches import (
    STEP,
    ConeTouch,
    Missing,
    Rest,
    ShaftTouch,
    Touches,
    Wanted,
    missing,
    read,
    wanted,
)
from beltgui.steps.views.common import check_of, finite, in_deg, progress_text, reasons_of, with_worst_flagged
from beltgui.steps.views.common import missing as missing_reason
from beltgui.viewmodel.step import Check, Column, SampleRow, StepContent, Suggestion, Use
from core.frames import euler_zyx_from_rotation
from devices.cell_plan import CellPlan

Array = NDArray[np.float64]

COLUMNS = (
    Column("residual", "Off the model", "mm", 3),
    Column("kind", "Kind", decimals=None),
    Column("head", "Head angle", "deg", 3),
    Column("flange_x", "Flange x in {B}", "mm", 1),
    Column("flange_y", "Flange y in {B}", "mm", 1),
    Column("flange_z", "Flange z in {B}", "mm", 1),
    Column("tilt", "Flange tilt against vertical", "deg", 1),
)
STRAIGHT_DOWN = np.array([0.0, 0.0, -1.0])


def content(bench: Bench, outcome: ToolOutcome | None, error: str) -> StepContent:
    """See `Room.view`."""
    touches = read(bench.session)
    want = wanted(bench.session, bench.plan)
    absent = missing(touches, want)
    progress = progress_text(want.count - absent.count, want.count, "touches and readings")
    shown = StepContent(
        columns=COLUMNS,
        rows=rows(touches, outcome, bench.plan),
        reasons=missing_reason(error),
        progress=progress,
        complete=not absent.count,
        extra={"parts": parts(want, absent)},
    )
    if outcome is None:
        return replace(shown, headline=progress, scene=scene(bench.plan, touches, None, None, focus(absent)))
    advice = _advice(outcome, bench.plan, touches, want)
    return replace(
        shown,
        numbers=numbers(outcome, bench.plan),
        ok=outcome.verdict.ok,
        reasons=reasons_of(outcome.verdict),
        remarks=remarks(outcome),
        checks=checks(outcome),
        suggestion=None if advice is None else suggestion(advice),
        provisional=bool(absent.count),
        headline=headline(outcome),
        scene=scene(bench.plan, touches, outcome, advice, focus(absent)),
        plots=plots(outcome, bench.plan),
        extra={**shown.extra, **_to_be_added(bench, advice)},
    )


def _to_be_added(bench: Bench, advice: Advice | None) -> dict[str, Any]:
    """The touch that is worth planning in addition, and what was planned in addition before; see `touch_values`."""
    if advice is None or advice.slot is not None:
        return {}
    setting = bench.session.setting
    return {
        "suggested": touch_values(advice),
        "extra_cone": setting(STEP, "extra_cone", []),
        "extra_shafts": setting(STEP, "extra_shafts", {}),
    }


def parts(want: Wanted, absent: Missing) -> tuple[dict[str, Any], ...]:
    """How far each part is: the cone (`grinder` empty), then each grinder; `rest`: its head was read at its stop."""
    cone = {"grinder": "", "done": len(want.cone) - len(absent.cone), "planned": len(want.cone)}
    shafts = (
        {"grinder": name, "done": len(angles) - len(absent.shafts[name]), "planned": len(angles),
         "rest": name not in absent.rests}
        for name, angles in want.shafts.items()
    )  # fmt: skip
    return (cone, *shafts)


def _advice(outcome: ToolOutcome, plan: CellPlan, touches: Touches, want: Wanted) -> Advice | None:
    absent = missing(touches, want)
    return advise(
        outcome,
        plan,
        {slot: want.cone[slot] for slot in absent.cone},
        {name: {slot: want.shafts[name][slot] for slot in slots} for name, slots in absent.shafts.items()},
    )


def focus(absent: Missing) -> str:
    """What the picture shows: where the next touches are, and all of it once they are there."""
    if absent.cone:
        return CONE
    return next((name for name, slots in absent.shafts.items() if slots), ALL)


# ---- rows


def rows(touches: Touches, outcome: ToolOutcome | None, plan: CellPlan) -> tuple[SampleRow, ...]:
    """One for each touch and reading, in order of time; touches left out keep the residual that they would have."""
    odd = _odd_ones(outcome)
    found: list[SampleRow] = [_rest_row(rest) for rest in touches.rests]
    for cone in touches.cone:
        miss = None if outcome is None else outcome.cone_misses_mm.get(cone.id)
        use = use_of(cone, len(plan.stylus.touches))
        found.append(_touch_row(cone, miss, "cone", None, use, cone.id in odd))
    for shaft in touches.shafts:
        miss = None if outcome is None else outcome.shaft_misses_mm.get(shaft.id)
        use = use_of(shaft, len(plan.grinders[shaft.grinder].touch_angles_rad))
        found.append(_touch_row(shaft, miss, "shaft", in_deg(shaft.angle_rad), use, shaft.id in odd))
    found.sort(key=lambda row: row.id)
    return with_worst_flagged(found, 0)


def _odd_ones(outcome: ToolOutcome | None) -> set[int]:
    if outcome is None or outcome.stylus.outlier is None:
        return set()
    return {outcome.fitted_cone[outcome.stylus.outlier].id}


def _touch_row(
    touch: ConeTouch | ShaftTouch, miss: Array | None, kind: str, head_deg: float | None, use: Use, odd: bool
) -> SampleRow:
    residual = None if miss is None else finite(float(np.linalg.norm(miss)))
    at = (float(value) for value in touch.base_from_flange[:3, 3])
    tilt = math.degrees(math.acos(float(np.clip(touch.base_from_flange[:3, 2] @ STRAIGHT_DOWN, -1.0, 1.0))))
    cells = (residual, kind, head_deg, *at, tilt)
    return SampleRow(touch.id, touch.name, cells, use, touch.included, "outlier" if odd else "")


def _rest_row(rest: Rest) -> SampleRow:
    use = Use.CHECK if rest.included else Use.EXCLUDED
    note = "The head at its stop: read again around the probing, so that a shift of the sensor's zero shows."
    cells = (None, "stop", in_deg(rest.angle_rad), None, None, None, None)
    return SampleRow(rest.id, rest.name, cells, use, rest.included, "", note)


# ---- checks, remarks, suggestion


def checks(outcome: ToolOutcome) -> tuple[Check, ...]:
    """On touches that the fits have not seen."""
    return (check_of(outcome.cone_held_out), *(check_of(held) for held in outcome.shafts_held_out.values()))


def remarks(outcome: ToolOutcome) -> tuple[str, ...]:
    """Worth knowing, without rejecting."""
    found = [f"Stylus, least certain together: {outcome.stylus.conditioning.description}."]
    found += [
        f"Grinder {name}, least certain together: {fit.conditioning.description}."
        for name, fit in outcome.wheels.items()
    ]
    left_out = sum(not sample.included for sample in (*outcome.touches.cone, *outcome.touches.shafts))
    if left_out:
        found.append(f"{left_out} touches are left out.")
    return tuple(found)


def suggestion(advice: Advice) -> Suggestion:
    """In words."""
    before, after = 2.0 * advice.before_mm, 2.0 * advice.after_mm
    if isinstance(advice, ConeAdvice):
        improves = f"Uncertainty of the stylus tip (k = 2): from {before:.3f} to {after:.3f} mm."
        if advice.slot is not None:
            return Suggestion(f"Take cone touch {advice.slot + 1} next: of the missing ones it adds most.", improves)
        return Suggestion(
            f"One more touch of the cone adds most with the flange tilted by {math.degrees(advice.tilt_rad):.0f} deg "
            f"towards {math.degrees(advice.azimuth_rad):.0f} deg in {{B}}, counted from x to y.",
            improves,
        )
    improves = f"Uncertainty of the wheel of grinder {advice.grinder} (k = 2): from {before:.3f} to {after:.3f} mm."
    angle = math.degrees(advice.angle_rad)
    if advice.slot is not None:
        return Suggestion(f"Touch the shaft of grinder {advice.grinder} at {angle:+.1f} deg next.", improves)
    return Suggestion(
        f"One more touch of the shaft of grinder {advice.grinder} adds most at a head angle of {angle:+.1f} deg.",
        improves,
    )


def touch_values(advice: Advice) -> dict[str, Any]:
    """What the settings `extra_cone` or `extra_shafts` hold of a touch: mm and deg."""
    if isinstance(advice, ConeAdvice):
        pose = advice.base_from_flange
        return {
            "translation_mm": pose[:3, 3].tolist(),
            "euler_zyx_deg": np.degrees(euler_zyx_from_rotation(pose[:3, :3])).tolist(),
        }
    return {"grinder": advice.grinder, "angle_deg": math.degrees(advice.angle_rad)}
