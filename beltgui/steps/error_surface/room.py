"""The error surface's room: the blade is clamped, registered, probed, scanned again; out come surface and programs."""

from __future__ import annotations

from typing import Any

from beltgui.jobs import Job
from beltgui.steps.context import Context
from beltgui.steps.error_surface import probing, step
from beltgui.steps.error_surface.clamped import (
    VOID,
    chosen_grinder,
    presenting_of,
    ready_to_present,
    registered,
    registered_at_end,
    with_frames,
)
from beltgui.steps.error_surface.export import export
from beltgui.steps.error_surface.probing import CHECK_LINES, PRESENTED_LIMIT_MM
from beltgui.steps.error_surface.series import STEP, Series, current_clamping
from beltgui.steps.error_surface.step import ErrorSurfaceOutcome, Program
from beltgui.steps.room import Bench
from beltgui.viewmodel.step import StepContent
from core.errors import InputError
from core.verdict import Code, Reason, Verdict, above

__all__ = ["ErrorSurfaceRoom", "export"]

# A surface is what was measured: a few lines may be left out, as many as samples may be rejected.
LARGEST_SHARE_LEFT_OUT = 0.1


class ErrorSurfaceRoom:
    """Step 6."""

    step = STEP

    def acquire(self, bench: Bench, context: Context) -> None:
        """Clamp, scan, register and judge; then probe the lines that are missing; then scan again.

        Raises:
            InputError: the blade as it is clamped is not accepted; it has not been presented to the wheel.
            DeviceError: a device failed or refused; what was taken before stays.
            Cancelled: the job was cancelled.
        """
        grinder, grid = chosen_grinder(bench), bench.blade.probing
        series = _series(bench, grinder)
        series = _series(bench, grinder)
        why = ""
        if series is not None and not probing.missing_lines(series, grid) and _as_presented(bench, series):
            why = _finished(bench, context, series)
            if not why:
                return
        clamped = ready_to_present(bench, context.part(0.0, 0.08), grinder, why)
        probing.acquire(context.part(0.08, 0.94), presenting_of(bench, clamped, grinder), grid)
        probing.scan_at_the_end(context.part(0.94, 1.0))

    def solve(self, bench: Bench, job: Job) -> ErrorSurfaceOutcome:
        """Fit the surface to the lines that are included, check it, and write the programs if all is accepted.

        Raises:
            InputError: the samples do not determine the result.
            Cancelled: the job was cancelled.
        """
        grinder, grid = chosen_grinder(bench), bench.blade.probing
        samples = probing.read(bench.session, grinder)
        clamping, series = current_clamping(bench.session), _series(bench, grinder)
        assert clamping is not None and series is not None
        job.report(0.0, "registering the clamped blade")
        clamped = registered(bench, clamping)
        at_end = None
        if len(series.closing) == len(bench.plan.fine_step):
            job.report(0.2, "registering the blade after probing")
            at_end = registered_at_end(bench, series.closing, clamped)
        job.report(0.4, "fitting the error surface")
        presenting = with_frames(bench, series.frames, grinder)
        apart_mm = _frames_apart(bench, series)
        tool = bench.found["tool"]
        info = {"blade_type": bench.blade.name, "grinder": grinder, "date": bench.date}
        before = [*clamped.verdict.reasons, *(at_end.verdict.reasons if at_end is not None else [])]
        measured = step.solve(
            samples, tool.wheels[grinder].radius_mm, presenting.normal_in_tool, info, Verdict.of(before),
            tuple(tool.rests_rad.get(grinder, ())),
        )  # fmt: skip
        missing = probing.missing_lines(series, grid)
        open_ends = _not_done(series, len(missing), grid.v_count, at_end is None)
        verdict = Verdict.of([
            *measured.verdict.reasons,
            *open_ends,
            *_left_out(series),
            *above(
                Code.WRONG_MODEL, apart_mm, PRESENTED_LIMIT_MM,
                "The distance at the wheel between where the blade was presented and where the results of the steps "
                "before, as they are now, would present it",
                "The errors belong to the frames they were measured by: probe the blade again.",
            ),
        ])  # fmt: skip
        programs: dict[str, Program] = {}
        if verdict.ok:
            for name, pattern in step.patterns(grid).items():
                job.report(0.7 + 0.15 * len(programs), f"writing the program {name}")
                programs[name] = step.write_program(
                    name, presenting, measured.surface, pattern, blade_type=bench.blade.name, date=bench.date
                )
        return ErrorSurfaceOutcome(
            measured.surface, measured.held_out, measured.head_rest, clamped, presenting, apart_mm, at_end,
            not open_ends, programs, verdict,
        )  # fmt: skip

    def record(self, outcome: ErrorSurfaceOutcome) -> dict[str, Any]:
        """For the session, the report and replay."""
        return step.record(outcome)

    def headline(self, outcome: ErrorSurfaceOutcome) -> str:
        """The number that matters."""
        return step.headline(outcome)

    def view(self, bench: Bench, outcome: ErrorSurfaceOutcome | None, error: str = "") -> StepContent:
        """What the screen shows; see `Room.view`."""
        from beltgui.steps.error_surface.view import content

        return content(bench, outcome, error)


def _series(bench: Bench, grinder: str) -> Series | None:
    clamping = current_clamping(bench.session)
    return None if clamping is None else clamping.series.get(grinder)


def _as_presented(bench: Bench, series: Series) -> bool:
    return _frames_apart(bench, series) <= PRESENTED_LIMIT_MM


def _finished(bench: Bench, context: Context, series: Series) -> str:
    """Do what is left to do after the last line; a sentence if the blade was found to have slipped before.

    Closing scans that were rejected are taken once more, because something may have stood before the blade.
    """
    if not series.rested_after:
        presenting = with_frames(bench, series.frames, series.grinder)
        probing.acquire(context, presenting, bench.blade.probing)
    scanned = len(series.closing) == len(bench.plan.fine_step)
    if scanned and not _slipped(bench, series):
        return ""
    probing.scan_at_the_end(context)
    now = _series(bench, series.grinder)
    assert now is not None
    return _slipped(bench, now) if scanned else ""


def _slipped(bench: Bench, series: Series) -> str:
    """Why the closing scans reject the series; empty if they do not."""
    clamping = current_clamping(bench.session)
    assert clamping is not None
    try:
        at_end = registered_at_end(bench, series.closing, registered(bench, clamping))
    except InputError as error:
        return f"After probing the blade could not be found: {error} {VOID}"
    return "" if at_end.verdict.ok else f"After probing: {at_end.verdict.reasons[0].message} {VOID}"


def _frames_apart(bench: Bench, series: Series) -> float:
    """How far the results of the steps before, as they are now, would move the blade at the wheel, mm."""
    clamping = current_clamping(bench.session)
    assert clamping is not None
    now = presenting_of(bench, registered(bench, clamping), series.grinder)
    return probing.presented_apart_mm(with_frames(bench, series.frames, series.grinder), now, bench.blade.probing)


def _not_done(series: Series, missing: int, planned: int, no_closing_scans: bool) -> list[Reason]:
    """What is still to be taken."""
    go_on = "Acquire goes on with it; what is there is not taken again."
    reasons = []
    if missing:
        there = planned + CHECK_LINES - missing
        what = f"{there} of {planned + CHECK_LINES} lines of the airfoil are probed."
        reasons.append(Reason(Code.LOW_COVERAGE, f"{what} {go_on}"))
    if not series.rested_after:
        what = f"The head of grinder {series.grinder} has not been read at its stop after the last line."
        reasons.append(Reason(Code.HELD_OUT_ERROR, f"{what} {go_on}"))
    if no_closing_scans:
        what = "The blade has not been scanned after the last line, so nothing shows that it stayed in its clamp."
        reasons.append(Reason(Code.HELD_OUT_ERROR, f"{what} {go_on}"))
    return reasons


def _left_out(series: Series) -> list[Reason]:
    lines, checks = ([s for s in group.values() if not s.included] for group in (series.lines, series.checks))
    reasons = []
    if len(lines) > LARGEST_SHARE_LEFT_OUT * len(series.lines):
        reasons.append(Reason(
            Code.LOW_COVERAGE,
            f"{len(lines)} of {len(series.lines)} lines are left out, at most {LARGEST_SHARE_LEFT_OUT:.0%} may be. "
            "Delete them and probe them again.",
        ))  # fmt: skip
    if checks:
        reasons.append(Reason(
            Code.HELD_OUT_ERROR,
            f"{len(checks)} of {len(series.checks)} check lines are left out. A check that fails may not be left out: "
            "delete it and probe it again.",
        ))  # fmt: skip
    return reasons
