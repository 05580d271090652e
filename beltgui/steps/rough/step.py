"""Rough workpiece: the blade's first pose, from the scan alone or from picked pairs; its faces have to confirm it."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from beltgui.steps.fine.step import ScanShare, in_measure, limits_of, scan_shares, type_faces
from beltgui.steps.rough.picks import AUTOMATIC, BY_PAIRS, LEAST_PAIRS, Pair
from beltgui.steps.rough.record import automatic_record, confirmed_pairs_record
from beltgui.steps.scans import ScanSample
from core.ball import StageFit
from core.cad import CadModel
from core.cad.blade_type import BladeType
from core.errors import FitError
from core.fine import FineFit, judge_fine, solve_fine
from core.frames import transform_points
from core.progress import Progress, part, silent
from core.rough import GlobalFit, GlobalSettings, PairsFit, PairsLimits, judge_pairs, register_globally, solve_pairs
from core.verdict import Code, Reason, Verdict

Array = NDArray[np.float64]
LIMITS = PairsLimits()


@dataclass(frozen=True, eq=False)
class RoughOutcome:
    """What the step found.

    Attributes:
        method: `automatic` or `pairs`.
        measure_from_work: (4, 4) by the faces that confirmed it; as the pairs say where nothing confirms them, and then
            the verdict rejects it.
        confirmed: The fine registration that confirmed the pose; None where it refused.
        search: Of the automatic method.
        pairs: Of the other one.
        pairs_apart_mm: (N,) distance of each pair under the confirmed pose, which has not seen them; NaN without one.
        scans: What each scan says of the faces; none without a confirmation.
        verdict: Of all of it.
    """

    method: str
    measure_from_work: Array
    confirmed: FineFit | None
    search: GlobalFit[FineFit] | None
    pairs: PairsFit | None
    pairs_apart_mm: Array
    scans: tuple[ScanShare, ...]
    verdict: Verdict


@dataclass(frozen=True, eq=False)
class _Work:
    names: list[str]
    clouds: list[Array]
    model: CadModel
    blade: BladeType
    progress: Progress

    def confirm(self, start: Array, told: Progress) -> FineFit:
        faces = type_faces(self.model, self.blade)
        return solve_fine(self.model, self.clouds, start, face_ids=faces, progress=told)

    def search(self, told: Progress) -> GlobalFit[FineFit]:
        def confirm(model: CadModel, scans: Sequence[Array], start: Array) -> FineFit:
            return self.confirm(start, part(told, 0.65, 1.0))

        settings = GlobalSettings(surface_mm=max(GlobalSettings.surface_mm, self.blade.stock_mm))
        points = np.concatenate(self.clouds)
        return register_globally(
            self.model, points, confirm=confirm, settings=settings, progress=part(told, 0.0, 0.65)
        )

    def shares(self, fit: FineFit) -> tuple[ScanShare, ...]:
        return scan_shares(self.names, self.clouds, self.model, fit, type_faces(self.model, self.blade))


def solve(
    samples: Sequence[ScanSample], stage: StageFit, model: CadModel, blade: BladeType, progress: Progress = silent
) -> RoughOutcome:
    """Find the blade in its scans from any pose.

    Args:
        samples: Scans of the blade, all in one robot pose.
        stage: Result of the ball step.
        model: The blade's CAD model.
        blade: Its type: faces and limits.
        progress: Told of each stage; what it raises ends the work.

    Raises:
        InputError: no pose was confirmed: this is not that blade, or too little of it was seen.
    """
    work = _Work([sample.name for sample in samples], in_measure(samples, stage), model, blade, progress)
    found = work.search(progress)
    verdict = judge_fine(found.fine, limits_of(blade))
    return RoughOutcome(
        AUTOMATIC, found.measure_from_work, found.fine, found, None, np.zeros(0), work.shares(found.fine), verdict
    )


def solve_by_pairs(
    samples: Sequence[ScanSample],
    stage: StageFit,
    model: CadModel,
    blade: BladeType,
    picked: Sequence[Pair],
    progress: Progress = silent,
) -> RoughOutcome:
    """Find the blade from picked pairs and let its faces, which the pairs have not seen, confirm the pose.

    A wrong pair is named: where there are pairs to spare by the others; otherwise by the pose that the faces give, from
    the pairs' own pose or, if the faces refuse that one, from the automatic search.

    Args:
        samples: Scans of the blade, all in one robot pose.
        stage: Result of the ball step.
        model: The blade's CAD model.
        blade: Its type: faces and limits.
        picked: The pairs; those not ticked or not whole take no part.
        progress: Told of each stage; what it raises ends the work.

    Raises:
        InputError: the pairs do not determine a pose: too few, on a line, mirrored.
    """
    used = [pair for pair in picked if pair.used]
    if len(used) < LEAST_PAIRS:
        missing = LEAST_PAIRS - len(used)
        raise FitError(
            f"{len(used)} of at least {LEAST_PAIRS} pairs are picked: pick {missing} more, each on the scan and on the "
            "CAD model, spread over the whole blade.", Code.NOT_ENOUGH_POINTS,
        )  # fmt: skip
    cad = np.array([pair.cad_mm for pair in used])
    fit = solve_pairs(np.array([pair.scan_mm for pair in used]), cad, names=[pair.name for pair in used])
    by_others = [reason for reason in judge_pairs(fit, LIMITS).reasons if reason.code is Code.HELD_OUT_ERROR]
    if by_others:
        return _not_confirmed(fit, by_others)
    work = _Work([sample.name for sample in samples], in_measure(samples, stage), model, blade, progress)
    try:
        confirmed = work.confirm(fit.measure_from_work, part(progress, 0.0, 0.3))
    except FitError as error:
        return _not_confirmed(fit, [_refused(fit, cad, error, work)])
    apart = _apart_mm(fit, cad, confirmed.measure_from_work)
    reasons = [*_pair_reasons(fit, apart), *judge_fine(confirmed, limits_of(blade)).reasons]
    return RoughOutcome(
        BY_PAIRS, confirmed.measure_from_work, confirmed, None, fit, apart, work.shares(confirmed), Verdict.of(reasons)
    )


def _not_confirmed(fit: PairsFit, reasons: Sequence[Reason]) -> RoughOutcome:
    unknown = np.full(len(fit.names), np.nan)
    return RoughOutcome(BY_PAIRS, fit.measure_from_work, None, None, fit, unknown, (), Verdict.of(reasons))


def _apart_mm(fit: PairsFit, cad: Array, measure_from_work: Array) -> Array:
    """Distance of each pick on the scan from its CAD point at another pose than the pairs' own."""
    scan = transform_points(fit.measure_from_work, cad) + fit.residuals_mm
    return np.asarray(np.linalg.norm(scan - transform_points(measure_from_work, cad), axis=1))


def _pair_reasons(fit: PairsFit, apart_mm: Array) -> list[Reason]:
    """One reason for each pair that the faces contradict."""
    return [
        Reason(Code.HELD_OUT_ERROR, f"Pair '{name}' is {distance:.1f} mm off where the faces of the blade put it, the "
                                    f"limit is {LIMITS.max_pair_mm:g} mm. Pick it again, or leave it out.")
        for name, distance in zip(fit.names, apart_mm, strict=True) if distance > LIMITS.max_pair_mm
    ]  # fmt: skip


def _refused(fit: PairsFit, cad: Array, error: FitError, work: _Work) -> Reason:
    """Why the faces refuse the pairs' pose, and which pair is to blame."""
    try:
        witness = work.search(part(work.progress, 0.3, 1.0))
    except FitError:
        blame = f"The pair with the largest distance is '{fit.worst}'. Pick the pairs again, at clear corners."
    else:
        apart = _apart_mm(fit, cad, witness.measure_from_work)
        worst = int(np.argmax(apart))
        if apart[worst] > LIMITS.max_pair_mm:
            blame = (f"The automatic search finds the blade where pair '{fit.names[worst]}' is {apart[worst]:.1f} mm "
                     "off: pick it again, or leave it out.")
        else:
            blame = "The automatic search finds the blade near these pairs: use it, or pick the pairs wider apart."
    return Reason(error.code, f"The pose of the pairs is not confirmed by the faces. {blame} ({error})")


def headline(outcome: RoughOutcome) -> str:
    """The number that matters."""
    how = "found automatically" if outcome.method == AUTOMATIC else "found by pairs"
    if outcome.confirmed is None:
        assert outcome.pairs is not None
        return f"{how}, not confirmed, RMS of the pairs {outcome.pairs.rms_mm:.1f} mm"
    return f"{how}, RMS on the faces {1000.0 * outcome.confirmed.rms_mm:.0f} µm"


def record(outcome: RoughOutcome) -> dict[str, Any]:
    """For the session and the report."""
    if outcome.search is not None:
        return {"method": outcome.method, **automatic_record(outcome.search, outcome.verdict)}
    assert outcome.pairs is not None
    pose, apart = outcome.measure_from_work, outcome.pairs_apart_mm
    return {"method": outcome.method,
            **confirmed_pairs_record(outcome.pairs, outcome.confirmed, pose, apart, outcome.verdict)}
