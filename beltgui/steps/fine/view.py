"""What the screen shows of the fine step.

The table's rows are the scans. The scene is in {W}: the CAD model, pickable (a click on a face chooses it or takes it
off, setting `faces`), the filter boxes of the chosen faces, and the scan's points coloured by the face they are of.

`extra`:
    faces_table: (columns, rows) of a second table, one row for each face that can be measured on, the chosen ones
        first; a row's id is the face's, its tick box is the choice.
    chosen_faces: Ids.
    default_faces: Ids that the blade type itself says.
    hold: Sentence if the chosen faces leave the blade free to move or are too few; empty otherwise.
    free: True if they leave it free.
    scenes: Other pictures of the same by name, e.g. `signed distance`.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np

from beltgui.steps.fine.faces import chosen_faces
from beltgui.steps.fine.step import FineOutcome, headline, limits_of, type_faces
from beltgui.steps.room import Bench
from beltgui.steps.views import blade, common, drawing
from beltgui.viewmodel.scene import Arrow, Item, Lines, Points, Role, Scale, Scene
from beltgui.viewmodel.step import Check, Column, Number, ReasonView, SampleRow, StepContent, Suggestion, Use
from core.conditioning import direction_text
from core.errors import InputError
from core.fine import FaceResult, FineLimits, FineSettings, Hold, analyse_faces, assign_points, box_outlines
from core.frames import Array, inverse, transform_points
from core.verdict import Code

FACE_COLUMNS = (
    Column("type", "Type", "", None),
    Column("points", "Points", "", 0),
    Column("mean", "Mean", "µm", 1),
    Column("rms", "RMS", "µm", 1),
    Column("sigma", "Scatter", "µm", 1),
    Column("held_out", "By the other faces", "µm", 1),
    Column("coverage", "Covered", "%", 0),
)
# Points off the faces only say where the scan is; the ones on the faces are what counts.
MOST_OTHER = 8000
SIGNED_DISTANCE = "signed distance"
_ARROW_MM = 70.0
# The boxes take in this many sigmas at the end; before there is a result they are shown as they begin.
_BOX_SIGMAS = 13.0
_SCALE_SIGMAS = 3.0


@dataclass(frozen=True, eq=False)
class _Choice:
    """The chosen faces and how they hold the blade; a problem instead where they cannot be used."""

    faces: tuple[int, ...]
    hold: Hold | None
    sentence: str

    @property
    def free(self) -> bool:
        return self.hold is not None and self.hold.free


def content(bench: Bench, outcome: FineOutcome | None, error: str) -> StepContent:
    """See `Room.view`."""
    choice = _choice(bench)
    scans = blade.shown_scans(bench, "fine")
    progress, complete = blade.scans_progress(bench, "fine")
    limits = limits_of(bench.blade)
    scenes = _scenes(bench, scans, choice, outcome, limits)
    return StepContent(
        columns=blade.SCAN_COLUMNS,
        rows=blade.scan_rows(scans, outcome.scans if outcome else ()),
        numbers=_numbers(outcome, limits) if outcome else (),
        ok=outcome.verdict.ok if outcome else None,
        reasons=common.reasons_of(outcome.verdict) if outcome else _missing(choice, error),
        remarks=_remarks(outcome, choice),
        checks=_checks(outcome, limits) if outcome else (),
        suggestion=_suggestion(choice),
        progress=progress,
        complete=complete,
        headline=headline(outcome) if outcome else "",
        scene=scenes[0],
        plots=blade.face_plots(outcome.fit) if outcome else (),
        extra=_extra(bench, choice, outcome, scenes[1:]),
    )


# ---- the choice of faces


def _choice(bench: Bench) -> _Choice:
    try:
        faces = chosen_faces(bench)
        hold = analyse_faces(bench.model, faces)
    except InputError as error:
        return _Choice((), None, str(error))
    least = FineLimits.min_faces
    sentence = ""
    if hold.free:
        sentence = (f"The chosen faces leave the blade free to move: {_motion(hold)} in the CAD frame. Choose one more "
                    f"face that holds it{_which(hold)}.")
    elif len(faces) < least:
        sentence = f"{len(faces)} faces are chosen, at least {least} are needed. Choose more."
    return _Choice(faces, hold, sentence)


def _motion(hold: Hold) -> str:
    return f"{'turn about' if hold.turns else 'shift along'} {direction_text(hold.axis[1])}"


def _which(hold: Hold) -> str:
    return "" if hold.turns else f", with its normal along {direction_text(hold.axis[1])} at least partly"


def _missing(choice: _Choice, error: str) -> tuple[ReasonView, ...]:
    """What is missing for a result; faces that cannot hold the blade are told before anything is scanned."""
    reasons = common.missing(error)
    if choice.sentence:
        code = Code.ILL_CONDITIONED if choice.free else Code.NOT_ENOUGH_VARIATION
        reasons = (ReasonView(str(code), choice.sentence), *reasons)
    return reasons


def _suggestion(choice: _Choice) -> Suggestion | None:
    if not choice.free or choice.hold is None:
        return None
    return Suggestion(f"Choose one more face that holds the blade{_which(choice.hold)}.", f"the {_motion(choice.hold)}")


def _remarks(outcome: FineOutcome | None, choice: _Choice) -> tuple[str, ...]:
    remarks = []
    if outcome is not None and outcome.moved_mm is None:
        remarks.append("The blade was clamped anew after the rough step, so nothing shows whether it has slipped.")
    if outcome is not None:
        remarks.append("The uncertainty is that of scanner noise and of the base step; it does not include the robot's "
                       "own error in its reported pose.")
        remarks += [f"{face.name or f'face {face.id}'}: {face.note}." for face in outcome.fit.faces if face.note]
    return tuple(remarks)


# ---- numbers and checks


def _numbers(outcome: FineOutcome, limits: FineLimits) -> tuple[Number, ...]:
    fit = outcome.fit
    return (
        *blade.quality_numbers(fit, limits),
        *blade.pose_numbers("Blade in {F}", outcome.flange_from_work, outcome.flange_covariance, main=True),
        *blade.pose_numbers("Blade in {M}", fit.measure_from_work, fit.covariance),
    )


def _checks(outcome: FineOutcome, limits: FineLimits) -> tuple[Check, ...]:
    moved = common.limit_check(
        "How far the blade has moved since the rough step's scans of the same clamping",
        common.in_um(outcome.moved_mm), common.UM_PER_MM * outcome.moved_limit_mm, "µm",
        0 if outcome.moved_mm is None else len(outcome.fit.ends_in_work_mm),
    )  # fmt: skip
    return (moved, *blade.fit_checks(outcome.fit, limits))


def _extra(bench: Bench, choice: _Choice, outcome: FineOutcome | None, scenes: Sequence[Scene]) -> dict[str, Any]:
    return {
        "faces_table": (FACE_COLUMNS, _face_rows(bench, choice.faces, outcome)),
        "chosen_faces": choice.faces,
        "default_faces": tuple(sorted(type_faces(bench.model, bench.blade))),
        "hold": choice.sentence,
        "free": choice.free,
        "scenes": dict(zip((SIGNED_DISTANCE,), scenes, strict=False)),
    }


def _face_rows(bench: Bench, chosen: Sequence[int], outcome: FineOutcome | None) -> tuple[SampleRow, ...]:
    results = {face.id: face for face in outcome.fit.faces} if outcome is not None else {}
    usable = [face for face in bench.model.faces if face.usable]
    rows = []
    for face in sorted(usable, key=lambda face: (face.id not in chosen, face.id)):
        result = results.get(face.id) if face.id in chosen else None
        use = Use.FIT if face.id in chosen and (result is None or result.used) else Use.EXCLUDED
        cells = (face.type, *_face_cells(result))
        rows.append(SampleRow(face.id, face.label, cells, use, face.id in chosen, note=result.note if result else ""))
    return tuple(rows)


def _face_cells(result: FaceResult | None) -> tuple[float | None, ...]:
    if result is None:
        return (None,) * (len(FACE_COLUMNS) - 1)
    lengths = (result.mean_mm, result.rms_mm, result.sigma_mm, result.held_out_mm)
    return (float(result.points), *(common.in_um(value) for value in lengths), 100.0 * result.coverage)


# ---- pictures


def _scenes(
    bench: Bench, scans: Sequence[blade.ShownScan], choice: _Choice, outcome: FineOutcome | None, limits: FineLimits
) -> tuple[Scene, ...]:
    """The picture in {W}, and with a result the same coloured by signed distance."""
    basis: list[Item | None] = [
        blade.cad_mesh(bench, "blade", chosen=choice.faces, pickable=True, opacity=0.6 if outcome else 1.0),
        drawing.frame("W", np.eye(4)),
        _boxes(bench, choice.faces, outcome),
        *_free_arrows(choice, outcome, limits),
    ]
    legend = [(Role.CHOSEN, "chosen faces"), (Role.BOX, "filter boxes")]
    if outcome is not None:
        return _result_scenes(bench, scans, choice, outcome, basis, legend)
    rough = bench.found.get("rough")
    if rough is not None:
        basis += blade.scan_items(scans, inverse(rough.measure_from_work))
        legend.append((Role.SCAN, "scan"))
    look_from = _look_from(bench)
    return (drawing.scene("Faces to measure on", "W", basis, view="fine", legend=legend, look_from=look_from,
                          up=blade.lying(look_from), fit_to=("blade",)),)  # fmt: skip


def _look_from(bench: Bench) -> Array:
    """From the scanner's side."""
    rough = bench.found.get("rough")
    return blade.seen_from(bench, blade.planned_pose(bench) if rough is None else rough.measure_from_work)


def _result_scenes(
    bench: Bench,
    scans: Sequence[blade.ShownScan],
    choice: _Choice,
    outcome: FineOutcome,
    basis: list[Item | None],
    legend: list[tuple[Role, str]],
) -> tuple[Scene, ...]:
    fit = outcome.fit
    used = [scan.in_measure for scan in scans if scan.sample.included]
    points = np.concatenate(used) if used else np.zeros((0, 3))
    found = assign_points(
        bench.model, points, fit.measure_from_work, outcome.face_ids, half_thickness_mm=_BOX_SIGMAS * fit.sigma_mm,
        margin_mm=fit.settings.edge_margin_mm,
    )  # fmt: skip
    in_work = transform_points(inverse(fit.measure_from_work), points)
    other = Points("other points", drawing.thinned(in_work[found.face_id == 0], MOST_OTHER), Role.EXCLUDED, size_px=1.0)
    legend = [*legend, (Role.EXCLUDED, "points off the chosen faces")]
    by_face: list[Item | None] = [*basis, other]
    named = list(legend)
    for face_id, role in blade.face_roles(outcome.face_ids).items():
        mine = in_work[found.face_id == face_id]
        label = blade.face_label(bench, face_id)
        by_face.append(Points(f"points of {label}", drawing.display(mine), role, size_px=3.0))
        named.append((role, label))
    look_from = _look_from(bench)
    on = found.face_id > 0
    reach = _round_up(_SCALE_SIGMAS * common.UM_PER_MM * fit.sigma_mm)
    values = (common.UM_PER_MM * found.distance_mm[on]).astype(np.float32)
    coloured = Points("distances", drawing.display(in_work[on]), values=values, size_px=3.0,
                      scale=Scale("signed distance from the face, µm", -reach, reach))
    return (
        drawing.scene("Scan on the CAD model, by face", "W", by_face, view="fine", legend=named, look_from=look_from,
                      up=blade.lying(look_from), fit_to=("blade",)),
        drawing.scene("Scan on the CAD model, by signed distance", "W", [*basis, other, coloured], view="fine",
                      legend=legend, look_from=look_from, up=blade.lying(look_from), fit_to=("blade",)),
    )  # fmt: skip


def _round_up(value: float) -> float:
    """The next of 1, 2, 5 times a power of ten."""
    decade = 10.0 ** np.floor(np.log10(max(value, 1e-3)))
    return float(decade * min(step for step in (1.0, 2.0, 5.0, 10.0) if step * decade >= value * (1.0 - 1e-12)))


def _boxes(bench: Bench, faces: Sequence[int], outcome: FineOutcome | None) -> Lines:
    half = FineSettings.half_thickness_mm if outcome is None else _BOX_SIGMAS * outcome.fit.sigma_mm
    lines: list[Array] = []
    for face_id in faces:
        lines += box_outlines(bench.model.face(face_id), half_thickness_mm=half, margin_mm=FineSettings.edge_margin_mm)
    return Lines("filter boxes", tuple(drawing.display(line) for line in lines), Role.BOX, 2.0)


def _free_arrows(choice: _Choice, outcome: FineOutcome | None, limits: FineLimits) -> list[Item | None]:
    """An arrow to both sides along what the faces hold too loosely; none where they hold it."""
    hold = choice.hold
    if hold is None:
        return []
    loose = outcome is not None and (
        outcome.fit.conditioning.condition > limits.condition
        or float(outcome.fit.point_sigma_mm.max()) > limits.point_sigma_mm
    )
    if not (hold.free or loose):
        return []
    at, direction = hold.axis
    word = "not held: turn" if hold.turns else "not held: shift"
    return [
        Arrow("weakest direction", at, _ARROW_MM * direction, Role.ATTENTION, word),
        Arrow("weakest direction, back", at, -_ARROW_MM * direction, Role.ATTENTION),
    ]
