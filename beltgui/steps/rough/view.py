"""What the screen shows of the rough step.

The table's rows are the scans with the method `automatic`, and the picked pairs with the method `pairs`; pairs have
negative ids (see `picks`): ticking and deleting them changes the setting `pairs`.

`scene` shows the scan in {M}, pickable; `second_scene` the CAD model in {W}, pickable: a pair is a pick in each.

`extra`:
    method: `automatic` or `pairs`.
    pairs: For each pair a dict with `row`, `name`, `scan_mm`, `cad_mm` (None while missing), `included`, `worst`, and
        `distance_mm`, `leave_one_out_mm`, `by_faces_mm` (None where not known).
    worst: Name of the pair that stands out, empty if none does.
    more_needed: How many pairs are missing for a pose.
    message: What to do next, one sentence.
    next_name: For the next pair.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

import numpy as np

from beltgui.steps.fine.step import limits_of
from beltgui.steps.room import Bench
from beltgui.steps.rough.picks import (
    AUTOMATIC,
    BY_PAIRS,
    CHECKED_PAIRS,
    LEAST_PAIRS,
    METHOD,
    STEP,
    Pair,
    next_name,
    pairs_of,
    row_id,
)
from beltgui.steps.rough.step import LIMITS, RoughOutcome, headline
from beltgui.steps.views import blade, common, drawing
from beltgui.viewmodel.plot import Bars, LimitLine, Plot
from beltgui.viewmodel.scene import Item, Points, Role, Scene
from beltgui.viewmodel.step import Check, Column, Number, SampleRow, StepContent, Suggestion, Use
from core.errors import InputError
from core.frames import Array, transform_points

PAIR_COLUMNS = (
    Column("dx", "dX in {M}", "mm", 2),
    Column("dy", "dY in {M}", "mm", 2),
    Column("dz", "dZ in {M}", "mm", 2),
    Column("distance", "Distance", "mm", 2),
    Column("left_out", "By the other pairs", "mm", 2),
    Column("by_faces", "By the faces", "mm", 2),
)
_PICK_PX = 12.0


@dataclass(frozen=True, eq=False)
class _PairRow:
    """A pair with what the outcome says of it; NaN where it says nothing."""

    row: int
    pair: Pair
    residual_mm: Array
    left_out_mm: float
    by_faces_mm: float
    worst: bool

    @property
    def distance_mm(self) -> float:
        return float(np.linalg.norm(self.residual_mm))


def content(bench: Bench, outcome: RoughOutcome | None, error: str) -> StepContent:
    """See `Room.view`."""
    # An unknown method is refused when solving, with the reason; the view has to show that.
    method = BY_PAIRS if bench.session.setting(STEP, METHOD) == BY_PAIRS else AUTOMATIC
    found = outcome if outcome is not None and outcome.method == method else None
    scans = blade.shown_scans(bench, "rough")
    picked, problem = _picked(bench)
    pairs = _pair_rows(picked, found)
    progress, complete = blade.scans_progress(bench, "rough")
    by_pairs = method == BY_PAIRS
    return StepContent(
        columns=PAIR_COLUMNS if by_pairs else blade.SCAN_COLUMNS,
        rows=_rows(pairs) if by_pairs else blade.scan_rows(scans, found.scans if found else ()),
        numbers=_numbers(bench, found) if found else (),
        ok=found.verdict.ok if found else None,
        reasons=common.reasons_of(found.verdict) if found else common.missing(error or problem),
        remarks=found.pairs.remarks if found and found.pairs else (),
        checks=_checks(bench, found) if found else (),
        suggestion=_suggestion(pairs) if by_pairs else None,
        progress=progress,
        complete=complete,
        headline=headline(found) if found else "",
        scene=_scene(bench, scans, pairs if by_pairs else (), found),
        second_scene=_cad_scene(bench, pairs if by_pairs else (), None if by_pairs else found),
        plots=_plots(pairs if by_pairs else (), found),
        extra=_extra(method, pairs, found),
    )


# ---- pairs


def _picked(bench: Bench) -> tuple[tuple[Pair, ...], str]:
    """The pairs, or none and what is wrong with the setting: a view must show that instead of failing."""
    try:
        return pairs_of(bench), ""
    except InputError as error:
        return (), str(error)


def _pair_rows(pairs: tuple[Pair, ...], outcome: RoughOutcome | None) -> tuple[_PairRow, ...]:
    fit = outcome.pairs if outcome is not None else None
    worst = _worst(outcome)
    rows = []
    for index, pair in enumerate(pairs):
        residual, left_out, by_faces = np.full(3, np.nan), float("nan"), float("nan")
        if fit is not None and outcome is not None and pair.used and pair.name in fit.names:
            k = fit.names.index(pair.name)
            residual, left_out = fit.residuals_mm[k], float(fit.leave_one_out_mm[k])
            by_faces = float(outcome.pairs_apart_mm[k])
        rows.append(_PairRow(row_id(index), pair, residual, left_out, by_faces, pair.name == worst and pair.used))
    return tuple(rows)


def _worst(outcome: RoughOutcome | None) -> str:
    """The pair that stands out: the one a reason names, else the clearly worst one; empty if none does."""
    if outcome is None or outcome.pairs is None:
        return ""
    told = " ".join(reason.message for reason in outcome.verdict.reasons)
    named = [name for name in outcome.pairs.names if f"'{name}'" in told]
    if len(named) == 1:
        return named[0]
    known = np.nan_to_num(outcome.pairs_apart_mm)
    if named and known.max() > 0.0:
        return outcome.pairs.names[int(np.argmax(known))]
    return outcome.pairs.worst if outcome.pairs.worst_is_clear else ""


def _rows(pairs: tuple[_PairRow, ...]) -> tuple[SampleRow, ...]:
    rows = []
    for item in pairs:
        sizes = (*item.residual_mm.tolist(), item.distance_mm, item.left_out_mm, item.by_faces_mm)
        note = "" if item.pair.whole else f"Still to be picked on the {_missing_side(item.pair)}."
        rows.append(SampleRow(
            item.row, item.pair.name, tuple(common.finite(value) for value in sizes),
            Use.FIT if item.pair.used else Use.EXCLUDED, item.pair.included, "worst" if item.worst else "", note,
        ))  # fmt: skip
    return tuple(rows)


def _missing_side(pair: Pair) -> str:
    return "scan" if pair.scan_mm is None else "CAD model"


def _message(pairs: tuple[_PairRow, ...], outcome: RoughOutcome | None) -> tuple[str, int]:
    """What to do next, and how many pairs are missing."""
    half = next((item.pair for item in pairs if not item.pair.whole), None)
    count = sum(item.pair.used for item in pairs)
    needed = max(LEAST_PAIRS - count, 0)
    if half is not None:
        return f"Pick '{half.name}' on the {_missing_side(half)} too.", needed
    worst = _worst(outcome)
    if needed:
        return f"Pick {needed} more: the same point on the scan and on the CAD model.", needed
    if worst:
        return f"Pair '{worst}' stands out: pick it again, or leave it out.", 0
    if count < CHECKED_PAIRS:
        return "Enough for a pose; with one more pair the others can name a wrong one.", 0
    return f"{count} pairs are picked.", 0


def _suggestion(pairs: tuple[_PairRow, ...]) -> Suggestion | None:
    if sum(item.pair.used for item in pairs) != LEAST_PAIRS:
        return None
    return Suggestion("Pick a fourth pair, away from the others.", "a wrong pair is then named by the others")


def _extra(method: str, pairs: tuple[_PairRow, ...], outcome: RoughOutcome | None) -> dict[str, Any]:
    message, needed = _message(pairs, outcome)
    listed = [
        {"row": item.row, **item.pair.plain(), "worst": item.worst, "distance_mm": common.finite(item.distance_mm),
         "leave_one_out_mm": common.finite(item.left_out_mm), "by_faces_mm": common.finite(item.by_faces_mm)}
        for item in pairs
    ]  # fmt: skip
    return {"method": method, "pairs": listed, "worst": _worst(outcome), "more_needed": needed, "message": message,
            "next_name": next_name([item.pair for item in pairs])}


# ---- numbers and checks


def _numbers(bench: Bench, outcome: RoughOutcome) -> tuple[Number, ...]:
    confirmed, pairs = outcome.confirmed, outcome.pairs
    numbers: list[Number] = []
    if confirmed is not None:
        numbers += blade.pose_numbers("Blade in {M}", outcome.measure_from_work, confirmed.covariance)
        numbers += blade.quality_numbers(confirmed, limits_of(bench.blade))
    elif pairs is not None:
        numbers += blade.pose_numbers("Blade in {M}, by pairs", pairs.measure_from_work, pairs.covariance)
    if outcome.search is not None:
        numbers.append(common.number_of("Scan that lies on the CAD model", 100.0 * outcome.search.score, "%",
                                        decimals=0, main=True))
    if pairs is not None:
        numbers.append(common.number_of("RMS distance of the pairs", pairs.rms_mm, "mm", decimals=2,
                                        limit=LIMITS.max_rms_mm, main=True))
    return tuple(numbers)


def _checks(bench: Bench, outcome: RoughOutcome) -> tuple[Check, ...]:
    checks: list[Check] = []
    if outcome.pairs is not None:
        left_out = outcome.pairs.leave_one_out_mm
        checks.append(common.limit_check("Largest distance of a pair from where the other pairs put it",
                                         _largest(left_out), LIMITS.max_pair_mm, "mm", _count(left_out)))
        apart = outcome.pairs_apart_mm
        checks.append(common.limit_check("Largest distance of a pair from where the faces put it",
                                         _largest(apart), LIMITS.max_pair_mm, "mm", _count(apart)))
    if outcome.confirmed is not None:
        checks += blade.fit_checks(outcome.confirmed, limits_of(bench.blade))
    return tuple(checks)


def _largest(values: Array) -> float | None:
    known = values[np.isfinite(values)]
    return float(known.max()) if len(known) else None


def _count(values: Array) -> int:
    return int(np.count_nonzero(np.isfinite(values)))


# ---- pictures


def _scene(
    bench: Bench, scans: tuple[blade.ShownScan, ...], pairs: tuple[_PairRow, ...], outcome: RoughOutcome | None
) -> Scene:
    """The scan in {M}, with the CAD model where it was found."""
    there = any(len(scan.in_measure) for scan in scans)
    items: list[Item | None] = [drawing.frame("M", np.eye(4))]
    legend: list[tuple[Role, str]] = []
    if not there:
        title = "The blade as it is to be scanned"
        items += blade.planned_items(bench)
        legend.append((Role.BOX, "what the scanner sees"))
    else:
        title = "Scan of the blade"
        items += blade.scan_items(scans, np.eye(4), pickable=True)
        legend.append((Role.SCAN, "scan"))
    if outcome is not None:
        title = "CAD model found in the scan"
        items.append(blade.cad_mesh(bench, "blade", scene_from_work=outcome.measure_from_work, opacity=0.45))
        legend.append((Role.BLADE, "CAD model"))
    for item in pairs:
        if item.pair.scan_mm is not None:
            items += _pick(item, np.array(item.pair.scan_mm))
    if outcome is not None:
        both = [item for item in pairs if item.pair.used]
        scan, cad = (np.array([getattr(item.pair, side) for item in both]).reshape(-1, 3)
                     for side in ("scan_mm", "cad_mm"))  # fmt: skip
        items.append(drawing.segments("distances of the pairs", transform_points(outcome.measure_from_work, cad), scan,
                                      Role.ATTENTION, 3.0))
    planned = blade.planned_pose(bench)
    return drawing.scene(
        title, "M", items, view="rough scan" if there else "rough plan", legend=legend,
        look_from=planned[:3, :3] @ blade.seen_from(bench, planned), up=planned[:3, 2],
        fit_to=("scan", "blade", "pick", "name"),
    )  # fmt: skip


def _cad_scene(bench: Bench, pairs: tuple[_PairRow, ...], found: RoughOutcome | None) -> Scene:
    """The CAD model in {W}, turned as it is in the scan: as found, else as the drawings say."""
    items: list[Item | None] = [blade.cad_mesh(bench, "blade", pickable=True), drawing.frame("W", np.eye(4))]
    for item in pairs:
        if item.pair.cad_mm is not None:
            items += _pick(item, np.array(item.pair.cad_mm))
    pose = blade.planned_pose(bench) if found is None else found.measure_from_work
    upright = blade.planned_pose(bench)[:3, 2]
    return drawing.scene(
        "CAD model", "W", items, view="rough cad" if found is None else "rough cad found",
        look_from=blade.seen_from(bench, pose), up=pose[:3, :3].T @ upright,
    )  # fmt: skip


def _pick(item: _PairRow, at: Array) -> list[Item]:
    role = Role.OUTLIER if item.worst else Role.CHOSEN if item.pair.included else Role.EXCLUDED
    return [Points(f"pick {item.row}", drawing.display(at), role, size_px=_PICK_PX),
            drawing.label(f"name {item.row}", at, item.pair.name, role)]


# ---- plots


def _plots(pairs: tuple[_PairRow, ...], outcome: RoughOutcome | None) -> tuple[Plot, ...]:
    plots: list[Plot] = []
    solved = [item for item in pairs if np.isfinite(item.distance_mm)]
    if solved:
        plots.append(_pair_plot(solved))
    if outcome is not None and outcome.confirmed is not None:
        plots += blade.face_plots(outcome.confirmed)
    return tuple(plots)


def _pair_plot(pairs: list[_PairRow]) -> Plot:
    places = np.arange(len(pairs), dtype=float)
    series = []
    for shift, role, name, key in (
        (-0.27, Role.FIT, "in the fit", "distance_mm"),
        (0.0, Role.HELD_OUT, "by the other pairs", "left_out_mm"),
        (0.27, Role.ATTENTION, "by the faces", "by_faces_mm"),
    ):
        values = np.array([getattr(item, key) for item in pairs], dtype=float)
        known = np.isfinite(values)
        labels = tuple(item.pair.name for item, there in zip(pairs, known, strict=True) if there)
        if known.any():
            series.append(Bars(places[known] + shift, values[known], role, name, labels, 0.25))
    return Plot("pairs", "Pairs", "pair", "distance, mm", tuple(series), (LimitLine(LIMITS.max_pair_mm, "limit"),))
