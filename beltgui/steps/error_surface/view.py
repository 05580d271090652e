"""What the screen shows of the step: lines, numbers, checks, what to probe next."""

from __future__ import annotations

from typing import Any

import numpy as np

from beltgui.steps.error_surface.clamped import RETURNED_LIMIT_MM
from beltgui.steps.error_surface.picture import scene_of
from beltgui.steps.error_surface.plots import plots_of
from beltgui.steps.error_surface.probing import PRESENTED_LIMIT_MM
from beltgui.steps.error_surface.series import CHECK, current_clamping
from beltgui.steps.error_surface.shown import LARGEST_EXAGGERATION, Shown, ShownLine, maps_of, shown_of
from beltgui.steps.error_surface.step import ErrorSurfaceOutcome, Program, headline
from beltgui.steps.head_rest import LIMIT_MM
from beltgui.steps.room import Bench
from beltgui.steps.views.common import (
    K,
    check_of,
    finite,
    in_deg,
    in_um,
    limit_check,
    missing,
    number_of,
    progress_text,
    reasons_of,
    with_worst_flagged,
)
from beltgui.viewmodel.step import Check, Column, Number, SampleRow, StepContent, Suggestion, Use
from core.error_surface import ErrorSurfaceLimits
from devices.interfaces import MAX_SPEED_MM_S

COLUMNS = (
    Column("v", "v", decimals=4),
    Column("points", "points", decimals=0),
    Column("missing", "missing", decimals=0),
    Column("rejected", "rejected", decimals=0),
    Column("error", "RMS of the normal error", "µm", 0),
    Column("deviation", "RMS of its prediction's error", "µm", 1),
)
DEVIATION = 5
# A line of which so many points were rejected stands out.
MANY_REJECTED = 0.2
# Where the surface is less certain than usual by this factor, probing again is worth the while.
WORTH_PROBING = 2.0


def content(bench: Bench, outcome: ErrorSurfaceOutcome | None, error: str = "") -> StepContent:
    """See `Room.view`."""
    shown = shown_of(bench, outcome)
    taken = shown.planned - len(shown.todo)
    return StepContent(
        columns=COLUMNS,
        rows=_rows(shown),
        numbers=() if outcome is None else numbers_of(bench, outcome),
        ok=None if outcome is None else outcome.verdict.ok,
        reasons=missing(error) if outcome is None else reasons_of(outcome.verdict),
        remarks=_remarks(shown),
        checks=_checks(shown),
        suggestion=_suggestion(shown),
        progress=progress_text(taken, shown.planned, "lines"),
        complete=not shown.todo and (outcome is None or outcome.complete),
        provisional=outcome is not None and not outcome.complete,
        headline=_headline(shown, error),
        scene=scene_of(shown),
        plots=plots_of(shown),
        extra=_extra(shown),
    )


def _headline(shown: Shown, error: str) -> str:
    if shown.outcome is not None:
        return headline(shown.outcome)
    if shown.todo and shown.counted:
        return f"line {shown.planned - len(shown.todo)} of {shown.planned}"
    return error


# ---- rows


def _rows(shown: Shown) -> tuple[SampleRow, ...]:
    return with_worst_flagged([_row(line) for line in shown.lines], DEVIATION)


def _row(line: ShownLine) -> SampleRow:
    known = line.error_mm[np.isfinite(line.error_mm)]
    rms = float(np.sqrt(np.mean(known**2))) if len(known) else None
    rejected = int(line.rejected.sum())
    flag, note = "", ""
    if line.void:
        flag, note = "refused", "Of an earlier clamping, or probed with other frames; it does not count any more."
    elif rejected > MANY_REJECTED * len(line.u):
        flag, note = "outlier", f"{rejected} of {len(line.u)} points were found to be wrong."
    elif line.is_check:
        note = "Between the nodes of the grid; the fit does not see it. Delete it to probe it again."
    cells = (float(line.v[0]), float(len(line.u)), float(line.missing), float(rejected), in_um(rms),
             in_um(line.rms_mm))  # fmt: skip
    return SampleRow(
        line.sample.id, line.name, cells, line.use, included=line.sample.included and not line.void, flag=flag,
        note=note, can_exclude=not (line.void or line.is_check),
    )  # fmt: skip


# ---- numbers


def numbers_of(bench: Bench, outcome: ErrorSurfaceOutcome) -> tuple[Number, ...]:
    """All numbers of the result."""
    surface, limits = outcome.surface, ErrorSurfaceLimits()
    known = surface.sample_error_mm[surface.used]
    sigma = maps_of(bench, surface)[1]
    sigma = sigma[np.isfinite(sigma)]
    least, largest = (float(known.min()), float(known.max())) if len(known) else (None, None)
    typical, worst = (float(np.median(sigma)), float(sigma.max())) if len(sigma) else (None, None)
    return (
        number_of("Held-out error, RMS", outcome.held_out.rms_mm, "mm", limit=outcome.held_out.limit_mm, main=True),
        number_of("Normal error, RMS", float(np.sqrt(np.mean(known**2))), "mm", main=True),
        number_of("Normal error, smallest", least, "mm", sigma=surface.sigma_mm),
        number_of("Normal error, largest", largest, "mm", sigma=surface.sigma_mm, limit=limits.max_error_mm),
        number_of("Leave-one-out error, RMS", surface.leave_one_out_rms_mm, "mm", decimals=4,
                  limit=limits.max_leave_one_out_rms_mm),
        number_of("Noise of a sample (1 sigma)", surface.sigma_mm, "mm", decimals=4, limit=limits.max_sigma_mm),
        number_of("± of the surface at the contact, typical (k = 2)", _twice(typical), "mm", decimals=4, main=True),
        number_of("± of the surface at the contact, largest (k = 2)", _twice(worst), "mm", decimals=4),
        number_of("Points used", float(surface.used.sum()), "", decimals=0),
        number_of("Points rejected", float(len(surface.rejected)), "", decimals=0),
        number_of("Points missing", float(surface.missing.sum()), "", decimals=0),
        number_of("Wheel at the head's stop, moved since the tool step", outcome.head_rest.moved_mm, "mm",
                  limit=LIMIT_MM),
        *_clamping_numbers(bench, outcome),
        *(number for program in outcome.programs.values() for number in _program_numbers(program)),
    )  # fmt: skip


def _twice(sigma: float | None) -> float | None:
    return None if sigma is None else K * sigma


def _clamping_numbers(bench: Bench, outcome: ErrorSurfaceOutcome) -> tuple[Number, ...]:
    fit, limits = outcome.clamped_again.fit, bench.blade.limits
    moved = None if outcome.at_end is None else outcome.at_end.moved_mm
    return (
        number_of("Clamped blade, RMS on the faces", fit.rms_mm, "mm", limit=limits.rms_mm),
        number_of("Clamped blade, two halves of the data apart", float(np.max(fit.half_split_mm)), "mm"),
        number_of("Clamped blade, ± at its ends (k = 2)", K * float(np.max(fit.point_sigma_mm)), "mm",
                  limit=K * limits.contact_sigma_mm),
        number_of("Clamped blade, moved while it was probed", moved, "mm", limit=RETURNED_LIMIT_MM),
        number_of("Frames at the wheel, apart from those of the probing", outcome.apart_mm, "mm",
                  limit=PRESENTED_LIMIT_MM),
    )  # fmt: skip


def _program_numbers(program: Program) -> tuple[Number, ...]:
    name, proof = f"Program {program.name}", program.proof
    return (
        number_of(f"{name}, strokes", float(len(program.plan.strokes)), "", decimals=0),
        number_of(f"{name}, contacts", float(program.plan.points), "", decimals=0),
        number_of(f"{name}, contacts left out", float(program.plan.trimmed_points), "", decimals=0),
        number_of(f"{name}, way of the contact", program.length_mm, "mm", decimals=0),
        number_of(f"{name}, time", program.duration_s, "s", decimals=0),
        number_of(f"{name}, largest speed of the flange", program.largest_speed_mm_s, "mm/s", decimals=1,
                  limit=MAX_SPEED_MM_S),
        number_of(f"{name}, read back: largest difference of a pose", proof.max_position_mm, "mm", decimals=7),
        number_of(f"{name}, read back: largest turn", in_deg(proof.max_rotation_rad), "deg", decimals=8),
        number_of(f"{name}, read back: largest difference of a contact", proof.max_contact_mm, "mm", decimals=7),
    )  # fmt: skip


# ---- checks, remarks, what to do next


def _checks(shown: Shown) -> tuple[Check, ...]:
    outcome = shown.outcome
    if outcome is None:
        return ()
    registered = outcome.clamped_again
    at_end = outcome.at_end
    at_end_ok = None if at_end is None else at_end.verdict.ok
    faces_mm = float(registered.fit.rms_mm)
    return (
        check_of(outcome.held_out, "µm"),
        limit_check("Wheel at the head's stop, moved since the tool step", in_um(outcome.head_rest.moved_mm),
                    1000.0 * LIMIT_MM, "µm", len(outcome.head_rest.now_rad)),
        Check("Blade registered after clamping, RMS on the faces", in_um(faces_mm), "µm",
              1000.0 * shown.bench.blade.limits.rms_mm, registered.fit.points_used, registered.verdict.ok),
        Check("Blade after probing, moved in its clamp", in_um(None if at_end is None else at_end.moved_mm), "µm",
              1000.0 * (RETURNED_LIMIT_MM if at_end is None else at_end.moved_limit_mm),
              len(shown.series.closing) if shown.series is not None else 0, at_end_ok),
    )  # fmt: skip


def _remarks(shown: Shown) -> tuple[str, ...]:
    remarks = []
    clamping = current_clamping(shown.bench.session)
    if clamping is not None and clamping.why:
        remarks.append(clamping.why)
    void = sum(line.void for line in shown.lines)
    if void:
        remarks.append(f"{void} lines of an earlier clamping or of other frames do not count any more.")
    outcome = shown.outcome
    if outcome is not None:
        for program in outcome.programs.values():
            if program.plan.trimmed_points:
                remarks.append(
                    f"Program {program.name}: {program.plan.trimmed_points} contacts are left out, nothing was "
                    "measured there."
                )
    return tuple(remarks)


def _suggestion(shown: Shown) -> Suggestion | None:
    """What is missing first; then the line whose lost points leave the surface least certain."""
    if shown.todo:
        following = shown.todo[0]
        what = "check line" if following.kind == CHECK else "line"
        return Suggestion(f"Probe {what} {following.slot + 1} at v = {following.v[0]:.3f}.")
    if shown.outcome is None or shown.outcome.surface.sigma_mm is None:
        return None
    best: tuple[float, ShownLine, float] | None = None
    for line in shown.counted:
        lost = ~np.isfinite(line.error_mm) | line.rejected
        if line.is_check or not (lost.any() or line.use is Use.EXCLUDED):
            continue
        where = lost if line.use is not Use.EXCLUDED else np.ones(len(lost), dtype=bool)
        sigma = shown.outcome.surface.sigma_at(line.u[where], line.v[where])
        # Outside the measured patch nothing is known at all.
        worst = float(np.max(np.where(np.isfinite(sigma), sigma, np.inf)))
        if best is None or worst > best[0]:
            best = (worst, line, float(where.sum()))
    sigma = maps_of(shown.bench, shown.outcome.surface)[1]
    typical = float(np.nanmedian(sigma))
    if best is None or best[0] < WORTH_PROBING * typical:
        return None
    worst, line, count = best
    noise = shown.outcome.surface.sigma_mm
    text = (
        f"Delete {line.name} (v = {line.v[0]:.3f}) and acquire: it is probed again, points lost now: {count:.0f} of "
        f"{len(line.u)}."
    )
    if not np.isfinite(worst):
        return Suggestion(text, "Its part of the airfoil is not measured now.")
    after = worst * noise / np.hypot(worst, noise)
    return Suggestion(text, f"± there (k = 2) from {2000.0 * worst:.1f} to {2000.0 * after:.1f} µm")


# ---- extra


def _extra(shown: Shown) -> dict[str, Any]:
    """For the step's own panel.

    `tables`: each with `key`, `title`, `columns` and `rows`; `choices`: settings with what may be chosen.
    """
    settings, grid = shown.settings, shown.bench.blade.probing
    rejected = tuple(
        (line.name, float(u), float(v), in_um(error), in_um(deviation))
        for line in shown.counted
        for u, v, error, deviation, bad in zip(
            line.u, line.v, line.error_mm, line.deviation_mm, line.rejected, strict=True
        )
        if bad
    )
    programs = () if shown.outcome is None else tuple(
        (program.name, len(program.plan.strokes), program.plan.points, program.length_mm, program.duration_s,
         program.largest_speed_mm_s, program.proof.max_position_mm, finite(in_deg(program.proof.max_rotation_rad)),
         program.proof.max_contact_mm)
        for program in shown.outcome.programs.values()
    )  # fmt: skip
    return {
        "tables": (
            {"key": "rejected", "title": "Rejected points", "rows": rejected, "columns": (
                Column("line", "line", decimals=None), Column("u", "u", decimals=4), Column("v", "v", decimals=4),
                Column("error", "normal error", "µm", 0), Column("deviation", "off the surface", "µm", 0))},
            {"key": "programs", "title": "Robot programs, read back", "rows": programs, "columns": (
                Column("name", "program", decimals=None), Column("strokes", "strokes", decimals=0),
                Column("contacts", "contacts", decimals=0), Column("length", "way", "mm", 0),
                Column("time", "time", "s", 0), Column("speed", "largest speed", "mm/s", 1),
                Column("position", "largest difference", "mm", 7), Column("rotation", "largest turn", "deg", 8),
                Column("contact", "largest difference of a contact", "mm", 7))},
        ),
        "choices": (
            {"key": "grinder", "title": "Grinder", "value": settings.grinder,
             "options": tuple(shown.bench.plan.grinders)},
            {"key": "show_path", "title": "Path shown", "value": settings.path,
             "options": ("transverse", "longitudinal", "none")},
            {"key": "show_exaggeration", "title": "Compensation drawn", "value": settings.exaggeration,
             "low": 1.0, "high": LARGEST_EXAGGERATION, "unit": "x"},
            {"key": "show_section", "title": "Section at v", "value": settings.section_v,
             "low": grid.v_min, "high": grid.v_max, "unit": ""},
        ),
    }  # fmt: skip
