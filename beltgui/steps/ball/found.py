"""Scans of the ball with what was found in them; a scan that shows no ball is a scan, not the end of the step."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from beltgui.jobs import Job
from beltgui.session import Sample
from beltgui.steps.room import Bench
from beltgui.steps.scans import CLOSING, KIND
from beltgui.steps.views.drawing import display, thin_index
from beltgui.viewmodel.scene import Floats
from core.ball import SphereFit, SphereLimits, fit_sphere, judge_sphere
from core.errors import InputError
from core.verdict import Code, Reason
from devices.interfaces import StagePosition

Array = NDArray[np.float64]
# Kept of every scan for the picture.
SHOWN_POINTS = 8_000


@dataclass(frozen=True, eq=False)
class Seen:
    """What one cloud shows, found once for each sample.

    Attributes:
        sphere: The ball in {S}; None where none was found.
        refusal: Why none was found; empty otherwise.
        code: Of the refusal.
        shown: (n, 3) some of the points in {S}, for the picture.
        shown_on_ball: (n,) which of them the fit used.
    """

    sphere: SphereFit | None
    refusal: str
    code: Code
    shown: Floats
    shown_on_ball: NDArray[np.bool_]


@dataclass(frozen=True, eq=False)
class BallScan:
    """One scan of the ball.

    Attributes:
        id: Of the sample.
        slot: Which planned scan it is.
        name: As a person calls it.
        included: False if a person left it out.
        closing: True for a scan that only looks at the first place again.
        returns_to: Slot whose place a closing scan looks at again; None otherwise.
        base_from_flange: (4, 4) as the robot reported it.
        stage: As the stage reported it.
        seen: What it shows.
    """

    id: int
    slot: int
    name: str
    included: bool
    closing: bool
    returns_to: int | None
    base_from_flange: Array
    stage: StagePosition
    seen: Seen

    @property
    def usable(self) -> bool:
        """Included, and it shows the ball."""
        return self.included and self.seen.sphere is not None

    @property
    def stage_mm(self) -> Array:
        """(3,) linear axes."""
        return np.array([self.stage.x_mm, self.stage.y_mm, self.stage.z_mm])

    @property
    def sphere(self) -> SphereFit:
        """The ball in {S}.

        Raises:
            InputError: the scan shows none.
        """
        if self.seen.sphere is None:
            raise InputError(self.seen.refusal, self.seen.code)
        return self.seen.sphere


def ball_scans(bench: Bench, step: str, job: Job | None = None) -> tuple[BallScan, ...]:
    """All scans of a step that were not deleted, in order of time.

    Args:
        bench: Session, plan and cache; each cloud is looked at once.
        step: `ball` or `base`.
        job: Progress and cancel.

    Raises:
        InputError: a cloud is gone or damaged.
        Cancelled: the job was cancelled.
    """
    samples = [sample for sample in bench.session.samples(step) if sample.kind in (KIND, CLOSING)]
    scans = []
    for index, sample in enumerate(samples):
        if job is not None:
            job.report(0.9 * index / len(samples), f"looking for the ball in scan {index + 1} of {len(samples)}")
        scans.append(_scan(sample, _seen(bench, sample)))
    return tuple(scans)


def _scan(sample: Sample, seen: Seen) -> BallScan:
    x, y, z = sample.data["stage_mm"]
    return BallScan(
        id=sample.id,
        slot=int(sample.data["slot"]),
        name=sample.data["name"],
        included=sample.included,
        closing=sample.kind == CLOSING,
        returns_to=sample.data.get("returns_to"),
        base_from_flange=np.array(sample.data["base_from_flange"]),
        stage=StagePosition(x, y, z, sample.data["stage_rad"]),
        seen=seen,
    )


def _seen(bench: Bench, sample: Sample) -> Seen:
    key = ("sphere", sample.id)
    found = bench.cache.get(key)
    if found is None:
        found = look(bench.session.points(sample), bench.plan.ball.diameter_mm)
        bench.cache[key] = found
    assert isinstance(found, Seen)
    return found


def look(points_in_scanner: Array, diameter_mm: float) -> Seen:
    """The ball of certified diameter in a cloud (N, 3), or why there is none."""
    some = thin_index(len(points_in_scanner), SHOWN_POINTS)
    shown = display(points_in_scanner[some])
    try:
        sphere = fit_sphere(points_in_scanner, diameter_mm=diameter_mm, fix_diameter=True)
    except InputError as error:
        return Seen(None, str(error), error.code, shown, np.zeros(len(shown), dtype=bool))
    return Seen(sphere, "", Code.BAD_INPUT, shown, sphere.inliers[some])


def usable(scans: Sequence[BallScan]) -> list[BallScan]:
    """Those that may go into a fit or be held out: included, no closing scan, with a ball."""
    return [scan for scan in scans if scan.usable and not scan.closing]


def judge_scans(scans: Sequence[BallScan]) -> list[Reason]:
    """What speaks against single scans that are included, each with the scan's name."""
    limits = SphereLimits()
    reasons = []
    for scan in scans:
        if not scan.included:
            continue
        if scan.seen.sphere is None:
            message = f"Scan '{scan.name}': {scan.seen.refusal} Leave it out, or delete it and scan again."
            reasons.append(Reason(scan.seen.code, message))
        else:
            found = judge_sphere(scan.seen.sphere, limits).reasons
            reasons += [Reason(reason.code, f"Scan '{scan.name}': {reason.message}") for reason in found]
    return reasons


def missing_reasons(scans: Sequence[BallScan], names: Sequence[str]) -> list[Reason]:
    """One reason if planned scans were not taken or were deleted; `names` of all planned ones by slot."""
    there = {scan.slot for scan in scans if not scan.closing}
    absent = [name for slot, name in enumerate(names) if slot not in there]
    if not absent:
        return []
    some = ", ".join(f"'{name}'" for name in absent[:3]) + (" and others" if len(absent) > 3 else "")
    return [Reason(
        Code.NOT_ENOUGH_POINTS,
        f"{len(absent)} of {len(names)} planned scans are missing: {some}. Take the missing scans.",
    )]  # fmt: skip
