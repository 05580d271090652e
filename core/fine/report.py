"""From the estimate to what people read: per face, per direction, per point."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
from numpy.typing import NDArray

from core.cad import CadFace, CadModel
from core.conditioning import Conditioning, analyse_pose
from core.fine.boxes import Target
from core.fine.estimate import Estimate, FaceFit
from core.fine.result import FaceResult
from core.fine.trim_field import trim_field
from core.frames import inverse, transform_points

Array = NDArray[np.float64]
Mask = NDArray[np.bool_]

COVERAGE_CELL_MM = 2.0
# A histogram of distances reaches this many sigmas to either side.
HISTOGRAM_SIGMAS, HISTOGRAM_BINS = 8.0, 48


def conditioning_in_work(result: Estimate) -> Conditioning:
    """Conditioning of the geometry alone, each face with the weight 1, in W about the middle of the points."""
    information = np.zeros((6, 6))
    for face in result.used:
        if face.moments is not None:
            information += face.moments.normal_equations(result.measure_from_work)[0] / face.moments.weight
    turn = np.zeros((6, 6))
    turn[:3, :3] = turn[3:, 3:] = result.measure_from_work[:3, :3].T
    return analyse_pose(turn @ information @ turn.T, result.lever_mm)


def ends_of(model: CadModel) -> Array:
    """(3, 3) one end, middle and other end of the model's box along its longest side, in W."""
    low, high = model.bounds_mm
    middle, longest = 0.5 * (low + high), int(np.argmax(high - low))
    ends = np.tile(middle, (3, 1))
    ends[0, longest], ends[2, longest] = low[longest], high[longest]
    return ends


def largest_motion(model: CadModel, start: Array, end: Array) -> float:
    """Largest distance in mm by which a corner of the model's box moves between two poses."""
    corners = model.bounds_mm[np.array(list(np.ndindex(2, 2, 2))), np.arange(3)]
    return float(np.linalg.norm(transform_points(end, corners) - transform_points(start, corners), axis=1).max())


def bins_of(result: Estimate) -> Array:
    """Edges (k + 1,) in mm of the histograms' bins."""
    reach = HISTOGRAM_SIGMAS * result.sigma_mm
    return np.linspace(-reach, reach, HISTOGRAM_BINS + 1)


def face_results(faces: Sequence[CadFace], result: Estimate,
                 held_out: Sequence[tuple[float, float]]) -> tuple[FaceResult, ...]:
    """One result per CAD face; faces that were joined are told apart again by their own trims."""
    predicted = {id(face): mean for face, (mean, _) in zip(result.used, held_out, strict=True)}
    by_id = {number: fit for fit in result.faces for number in fit.target.patch.face_ids}
    bins = bins_of(result)
    return tuple(_face_result(face, by_id[face.id], result.measure_from_work, predicted.get(id(by_id[face.id])), bins)
                 for face in sorted(faces, key=lambda item: item.id))


def _face_result(face: CadFace, fit: FaceFit, pose: Array, held_out: float | None, bins: Array) -> FaceResult:
    mine = _own_points(face, fit, pose)
    weights, d = fit.weights[mine], fit.distances_mm[mine]
    total = float(weights.sum())
    if not fit.used or total < 1.0:
        note = fit.note or "no points of its own; it shares its surface with another face"
        return FaceResult(face.id, face.name, face.type, 0, float("nan"), float("nan"), float("nan"), float("nan"),
                          0.0, False, note)
    mean = float(weights @ d) / total
    note = "" if fit.rim_used is not False else "its border was left out: ghosts or burrs there"
    return FaceResult(
        id=face.id, name=face.name, type=face.type, points=round(total), rms_mm=float(np.sqrt(weights @ d**2 / total)),
        mean_mm=mean, sigma_mm=fit.mixture.sigma_mm, held_out_mm=float("nan") if held_out is None else held_out,
        coverage=_coverage(fit.target, fit.box.points[mine][weights > 0.5], pose), used=True, note=note,
        counts=tuple(np.histogram(d, bins)[0].tolist()))


def _own_points(face: CadFace, fit: FaceFit, pose: Array) -> Mask:
    """Which of a target's points lie within this face's own trim."""
    if len(fit.target.patch.face_ids) == 1 or face.surface is None or face.trim is None:
        return np.ones(len(fit.box.index), dtype=bool)
    s, t, _ = face.surface.to_surface(transform_points(inverse(pose), fit.box.points))
    return np.asarray(trim_field(face.surface, face.trim).depth_at(s, t) >= 0.0)


def _coverage(target: Target, points: Array, pose: Array) -> float:
    """Share of 2 mm squares of the target that hold points."""
    inside = target.patch.surface.to_surface(target.anchors)
    whole = np.unique(target.field.cells(inside[0], inside[1], COVERAGE_CELL_MM))
    s, t, _ = target.patch.surface.to_surface(transform_points(inverse(pose), points))
    return len(np.intersect1d(whole, target.field.cells(s, t, COVERAGE_CELL_MM))) / max(len(whole), 1)
