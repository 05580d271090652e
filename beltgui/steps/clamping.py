"""Which clamping of the blade a scan belongs to: only scans of one clamping may be put together."""

from __future__ import annotations

from collections.abc import Sequence

from beltgui.session import Sample, Session
from beltgui.steps.context import Context
from beltgui.steps.room import Bench
from beltgui.steps.scans import KIND, acquire_scans, missing_slots
from beltgui.steps.state import STEPS
from core.errors import InputError
from devices.interfaces import Mount

_KEY = ("blade", "clamping")


def acquire_blade_scans(bench: Bench, context: Context, step: str, *, fresh: bool) -> None:
    """Take the missing scans of the clamped blade; ask for the blade where it may not be on the flange.

    A scan's `clamping` counts how often the blade has been asked for after something else was on the flange, or for a
    new round.

    Args:
        bench: Session, and the clamping that was asked for since the program started.
        context: Cell, job.
        step: `rough` or `fine`.
        fresh: True where a first scan of the step begins a new clamping.

    Raises:
        InputError: some scans are there, but the blade has been off the flange since.
        DeviceError: a device failed or refused; what was taken before stays.
        Cancelled: the job was cancelled.
    """
    poses = context.plan.fine_step
    slots = missing_slots(bench.session, step, len(poses))
    if not slots:
        return
    there = bench.session.samples(step, KIND)
    on_flange = _on_flange(bench.session)
    if there and on_flange != there[-1].data.get("clamping"):
        raise InputError(
            "The blade has been off the flange since the scans that are there, and scans of two clampings do not "
            "belong together. Start this step over and scan it from all sides again."
        )
    if there or not fresh:
        clamping = on_flange
    else:
        clamping = None
    if clamping is None or bench.cache.get(_KEY) != clamping:
        context.job.report(0.0, "the blade is to be clamped")
        context.cell.operator.perform(Mount("blade", context.serial))
        clamping = _latest(bench.session) + 1 if clamping is None else clamping
    bench.cache[_KEY] = clamping
    acquire_scans(context, step, poses, note={"clamping": clamping}, slots=slots)


def common_clamping(samples: Sequence[Sample]) -> int | None:
    """The clamping of scans of the blade; None where they do not say.

    Raises:
        InputError: they are of different clampings.
    """
    found = {sample.data.get("clamping") for sample in samples}
    if len(found) > 1:
        raise InputError(
            "The blade was clamped anew between its scans, so they do not belong together. Start this step over and "
            "scan the blade again."
        )
    return found.pop() if found else None


def _on_flange(session: Session) -> int | None:
    """The clamping that the newest sample of all shows; None where something else was on the flange."""
    newest = max(_all(session), key=lambda sample: sample.id, default=None)
    return None if newest is None else newest.data.get("clamping")


def _latest(session: Session) -> int:
    return max((sample.data.get("clamping", 0) for sample in _all(session)), default=0)


def _all(session: Session) -> list[Sample]:
    """Samples of all steps, those a person deleted too: they were taken all the same."""
    return [sample for step in STEPS for sample in session.samples(step, deleted=True)]
