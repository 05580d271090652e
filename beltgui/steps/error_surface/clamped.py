"""The blade as it is clamped for probing: registered and judged before the robot presents it, and looked at again.

A blade that slips while the wheel presses on it spoils an hour of probing, so nothing is presented that is not
registered well, and what was begun is gone on with only if the blade is still where it was.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace
from typing import Any

from beltgui.session import Sample
from beltgui.steps.context import Context
from beltgui.steps.error_surface import probing
from beltgui.steps.error_surface.probing import Presenting
from beltgui.steps.error_surface.series import STEP, Clamping, current_clamping
from beltgui.steps.fine import step as fine
from beltgui.steps.fine.step import FineOutcome
from beltgui.steps.room import Bench
from beltgui.steps.scans import ScanSample, acquire_scans, scan_of
from core.errors import InputError
from core.path import CellFrames
from core.verdict import Code, Reason, Verdict, above

# The robot leaves the scanning pose to probe and comes back within its repeatability, at the far end of the blade too.
RETURNED_LIMIT_MM = 0.15
RETURN = "return_scan"
DEFAULT_GRINDER = "fine"
VOID = "What was probed in the earlier clamping does not count any more; the blade is clamped and probed anew."


def chosen_grinder(bench: Bench) -> str:
    """Whose error surface is measured: the setting `grinder`.

    Raises:
        InputError: the cell has no such grinder.
    """
    names = tuple(bench.plan.grinders)
    default = DEFAULT_GRINDER if DEFAULT_GRINDER in names else names[0]
    name = bench.session.setting(STEP, "grinder", default)
    if name not in names:
        raise InputError(f"The cell has no grinder {name!r}. Choose one of {', '.join(names)}.")
    return str(name)


def registered(bench: Bench, clamping: Clamping) -> FineOutcome:
    """The blade's frame by the scans after clamping.

    Raises:
        InputError: they do not determine it, or do not show this blade.
    """
    return _by_samples(bench, clamping.opening, None)


def registered_at_end(bench: Bench, closing: Mapping[int, Sample], earlier: FineOutcome) -> FineOutcome:
    """The blade's frame by the scans after the last line, and how far it is from where it was.

    Raises:
        InputError: they do not determine it, or do not show this blade.
    """
    return _by_samples(bench, closing, earlier)


def presenting_of(bench: Bench, clamped: FineOutcome, grinder: str) -> Presenting:
    """The chain to a grinder by the frames as they are known now.

    Raises:
        InputError: the tool step has no result.
    """
    plan, wheel = bench.plan.grinders[grinder], _found(bench, "tool").wheels[grinder]
    frames = CellFrames(wheel.base_from_tool, clamped.flange_from_work, plan.wheel_radius_mm, plan.contact_side)
    return with_frames(bench, frames, grinder)


def with_frames(bench: Bench, frames: CellFrames, grinder: str) -> Presenting:
    """The chain to a grinder by given frames."""
    key = (STEP, "airfoil")
    if key not in bench.cache:
        bench.cache[key] = bench.model.spline_surface(bench.blade.airfoil)
    return Presenting(bench.cache[key], frames, grinder)


def ready_to_present(bench: Bench, context: Context, grinder: str, why: str = "") -> FineOutcome:
    """The blade clamped, registered and accepted; what was probed before stays only if the blade has not moved.

    Args:
        bench: Samples and earlier outcomes.
        context: Cell and session.
        grinder: For the words.
        why: A sentence why the blade has to be clamped anew; empty to see whether it has to.

    Raises:
        InputError: the registration is rejected; the robot has not presented the blade to the wheel.
        DeviceError: a device failed or refused.
        Cancelled: the job was cancelled.
    """
    clamping = current_clamping(bench.session)
    if not why and clamping is not None and len(clamping.opening) == len(bench.plan.fine_step):
        clamped = _accepted_before(bench, clamping)
        if clamped is not None:
            verdict = _looked_again(bench, context.part(0.0, 0.0), clamped, RETURNED_LIMIT_MM)
            if verdict.ok:
                return clamped
            why = f"The blade is not where it had been clamped: {verdict.reasons[0].message} {VOID}"
    probing.clamp_and_scan(context.part(0.0, 0.4), why)
    clamping = current_clamping(bench.session)
    assert clamping is not None
    context.job.report(0.4, "registering the blade before it is presented to the wheel")
    try:
        clamped = registered(bench, clamping)
    except InputError as error:
        raise InputError(_not_presented(grinder, str(error)), error.code) from error
    # Two scans that see different faces say little about a blade that slips between them; two more do.
    verdict = clamped.verdict
    if verdict.ok:
        verdict = _looked_again(bench, context.part(0.5, 1.0), clamped, fine.UNMOVED_MM)
    if not verdict.ok:
        raise InputError(_not_presented(grinder, verdict.reasons[0].message), verdict.reasons[0].code)
    return clamped


def _not_presented(grinder: str, reason: str) -> str:
    return (
        f"The blade as it is clamped for probing is not accepted: {reason} Check the clamp and acquire again: the "
        f"blade is clamped and scanned anew. The robot has not presented it to the wheel of grinder {grinder}."
    )


def _accepted_before(bench: Bench, clamping: Clamping) -> FineOutcome | None:
    """The registration of an earlier run, if it may be gone on with; a rejected one is clamped anew."""
    try:
        clamped = registered(bench, clamping)
    except InputError:
        return None
    return clamped if clamped.verdict.ok else None


def _looked_again(bench: Bench, context: Context, clamped: FineOutcome, unmoved_mm: float) -> Verdict:
    """Scan once more and compare with where the blade was found."""
    poses = context.plan.fine_step
    scans = acquire_scans(context, STEP, poses, RETURN, slots=range(len(poses)))
    context.job.report(0.9, "comparing with where the blade was")
    try:
        return _register(bench, scans, clamped, unmoved_mm).verdict
    except InputError as error:
        return Verdict.of([Reason(error.code, str(error))])


def _by_samples(bench: Bench, samples: Mapping[int, Sample], earlier: FineOutcome | None) -> FineOutcome:
    """Registration by kept scans, computed once for the same scans and the same results before."""
    ids = tuple(sample.id for sample in samples.values())
    stands_on = (_found(bench, "ball"), _found(bench, "base"), _found(bench, "fine"), earlier)
    key = (STEP, "registered", ids)
    kept = bench.cache.get(key)
    if kept is not None and all(was is now for was, now in zip(kept[0], stands_on, strict=True)):
        known: FineOutcome = kept[1]
        return known
    scans = [scan_of(bench.session, samples[slot]) for slot in sorted(samples)]
    outcome = _register(bench, scans, earlier)
    bench.cache[key] = (stands_on, outcome)
    return outcome


def _register(
    bench: Bench, scans: list[ScanSample], earlier: FineOutcome | None, unmoved_mm: float = RETURNED_LIMIT_MM
) -> FineOutcome:
    stage, base = _found(bench, "ball").stage, _found(bench, "base").fit
    faces = _found(bench, "fine").face_ids
    if earlier is None:
        start = _found(bench, "fine").fit.measure_from_work
        return fine.solve(scans, stage, base, bench.model, bench.blade, start, face_ids=faces)
    start = earlier.fit.measure_from_work
    outcome = fine.solve(
        scans, stage, base, bench.model, bench.blade, start, unmoved_since=start, unmoved_mm=unmoved_mm, face_ids=faces
    )
    assert outcome.moved_mm is not None
    if outcome.moved_mm <= outcome.moved_limit_mm:
        return outcome
    # Here another step is to be done again than where the blade was scanned last.
    slipped = above(
        Code.HELD_OUT_ERROR, outcome.moved_mm, outcome.moved_limit_mm,
        "The distance of the blade from where the scans before found it",
        "It has slipped in its clamp: fasten the clamp and acquire again.",
    )  # fmt: skip
    return replace(outcome, verdict=Verdict.of([*outcome.verdict.reasons[:-1], *slipped]))


def _found(bench: Bench, step: str) -> Any:
    if step not in bench.found:
        raise InputError(f"The step '{step}' has no result yet; the error surface stands on it. Do that step first.")
    return bench.found[step]
