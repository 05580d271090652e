"""Refusals of the fine step: what is said instead of a wrong pose."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
from numpy.typing import NDArray

from core.cad import CadFace, CadModel
from core.errors import FitError, InputError
from core.fine.capture import Capture
from core.fine.estimate import Estimate
from core.fine.report import conditioning_in_work, ends_of, largest_motion
from core.fine.settings import FineSettings
from core.frames import PoseCovariance, inverse, transform_points
from core.verdict import Code

Array = NDArray[np.float64]

_LEAST_POINTS = 50
# A scan in metres is a thousandth of its model; one of a small part of the model is still larger than this.
_METRES = 0.02
# A blade in front of a scanner is farther from the origin of {M} than this; in metres it is never.
_METRES_FROM_ORIGIN_MM = 5.0
# Measured on right and wrong blade types: 78 % and more of the surface on the right one, 51 % and less on a wrong one.
_LEAST_SURFACE, _CLEAR_SURFACE = 0.45, 0.7
_MANY_CONTRADICT = 0.75


def checked_points(scans: Sequence[Array]) -> Array:
    """All scans as one array (N, 3).

    Raises:
        InputError: a scan has no (N, 3) shape or contains NaN, or there is no point at all.
    """
    arrays = [np.asarray(scan, dtype=float) for scan in scans]
    for number, array in enumerate(arrays, start=1):
        if array.ndim != 2 or array.shape[1] != 3:
            raise InputError(f"scan {number}: expected points as (N, 3) in mm, found shape {array.shape}.")
        if not np.isfinite(array).all():
            raise InputError(f"scan {number}: contains NaN or infinite coordinates; drop these points first.")
    count = sum(len(array) for array in arrays)
    if count < _LEAST_POINTS:
        raise InputError(f"The scan has {count} points, at least {_LEAST_POINTS} are needed.", Code.NOT_ENOUGH_POINTS)
    return arrays[0] if len(arrays) == 1 else np.concatenate(arrays)


def chosen_faces(model: CadModel, face_ids: Sequence[int | str] | None) -> tuple[CadFace, ...]:
    """The faces to measure on.

    Raises:
        InputError: a named face is unknown or is neither plane nor cylinder, or the model has none at all.
    """
    if face_ids is None:
        faces = tuple(face for face in model.faces if face.usable)
        if not faces:
            raise InputError(f"{model.path.name}: none of its {len(model.faces)} faces is a plane or a cylinder that "
                             "registration can use.")
        return faces
    faces = model.select(face_ids)
    if not faces:
        raise InputError("The list of faces is empty. Name at least three, or none to use all.")
    for face in faces:
        if not face.usable:
            raise InputError(f"{model.path.name}: {face.label} can't be used for registration. {face.why_not or ''}")
    return faces


def check_scan(model: CadModel, points: Array) -> None:
    """Raise InputError where the scan's size speaks for metres, or for all points in one place."""
    extent = float(np.ptp(points, axis=0).max())
    size = float(np.ptp(model.bounds_mm, axis=0).max())
    if extent < _METRES * size:
        if 0.1 * size < 1000.0 * extent < 30.0 * size:
            raise InputError(f"The scan is {extent:.3g} mm across, the model {size:.3g} mm: the scan seems to be in "
                             "metres. Give it in mm.")
        raise InputError(f"The scan is only {extent:.3g} mm across, the model {size:.3g} mm. Give a scan in mm that "
                         "covers several faces.", Code.NOT_ENOUGH_VARIATION)
    if extent > 200.0 * size:
        raise InputError(f"The scan is {extent:.3g} mm across, the model {size:.3g} mm: one of them has the wrong "
                         "unit. Give both in mm.")


def check_capture(found: Capture | None, model: CadModel, points: Array, start: Array,
                  settings: FineSettings) -> Capture:
    """Refuse a capture that caught nothing, or something else.

    Raises:
        FitError: no points near the model, or points that don't lie on its faces.
    """
    if found is None or found.near == 0:
        in_work = transform_points(inverse(start), points)
        gap = np.maximum(np.maximum(model.bounds_mm[0] - in_work, in_work - model.bounds_mm[1]), 0.0)
        nearest = float(np.linalg.norm(gap, axis=1).min())
        length, away = float(np.linalg.norm(start[:3, 3])), float(np.linalg.norm(points.mean(axis=0)))
        if nearest > 0.5 and length < _METRES_FROM_ORIGIN_MM < away:
            raise InputError("Seen from the start, no scan points lie near the model, and the start's translation is "
                             f"only {length:.3g} mm long: it seems to be in metres. Give it in mm.")
        where = f"the nearest point is {nearest:.1f} mm away from the model's box" if nearest > 0.5 else \
            "points come near the model, but not onto the chosen faces"
        raise FitError(f"Seen from the start, no scan points lie on the chosen faces: {where}. Check that scan, start "
                       "and STEP file belong together, or redo the rough step.", Code.NOT_ENOUGH_POINTS)
    if found.sigma_mm > settings.max_sigma_mm:
        raise FitError(f"The scan does not fit the model: points scatter by {found.sigma_mm:.3f} mm about its faces, "
                       f"at most {settings.max_sigma_mm:.3f} mm is scanner noise. Is it the right blade type, and is "
                       "the start within a few mm and degrees?", Code.WRONG_MODEL)
    if found.share < settings.min_near_share:
        raise FitError(f"The scan does not fit the model: of {found.near} points within 2 mm of its faces only "
                       f"{found.share:.0%} lie on them, at least {settings.min_near_share:.0%} are expected. Is it the "
                       "right blade type, and is the start within a few mm and degrees?", Code.WRONG_MODEL)
    contradicted = found.contradicting >= _MANY_CONTRADICT * found.agreeing
    if found.surface_share < _LEAST_SURFACE or (contradicted and found.surface_share < _CLEAR_SURFACE):
        raise FitError(f"The scan does not fit the model: {found.agreeing} of its faces agree with the scan, "
                       f"{found.contradicting} contradict it, and {found.surface_share:.0%} of the surface scanned "
                       f"near the faces lies on them (at least {_CLEAR_SURFACE:.0%} is usual). Is it the right blade "
                       "type, and is the start within a few mm and degrees?", Code.WRONG_MODEL)
    return found


def check_start(model: CadModel, start: Array, found: Array, settings: FineSettings) -> None:
    """Refuse a pose that is farther from the start than a start may be.

    Raises:
        FitError: a corner of the model has moved too far.
    """
    moved = largest_motion(model, start, found)
    if not moved <= settings.max_start_motion_mm:
        raise FitError(f"The pose found carries the model by up to {moved:.0f} mm from the start, at most "
                       f"{settings.max_start_motion_mm:.0f} mm is trusted: another pose may fit as well. Redo the "
                       "rough step, or check the start.", Code.NOT_CONVERGED)


def check_geometry(result: Estimate, model: CadModel, settings: FineSettings) -> None:
    """Refuse a pose that the faces leave free.

    Raises:
        FitError: a direction is not held; the message names it and the kind of face that would hold it.
    """
    conditioning = conditioning_in_work(result)
    labels = ", ".join(face.target.patch.label for face in result.used)
    if not conditioning.condition < settings.max_condition:
        raise FitError(f"The faces with points ({labels}) leave the blade free to move: {conditioning.description} in "
                       f"the CAD frame (condition {conditioning.condition:.3g}, at most {settings.max_condition:.3g}). "
                       + _advice(conditioning.weakest_direction), Code.ILL_CONDITIONED)
    covariance = PoseCovariance(result.covariance, result.centre)
    worst = max(float(np.sqrt(np.trace(covariance.of_point(point))))
                for point in transform_points(result.measure_from_work, ends_of(model)))
    if not worst < settings.max_point_sigma_mm:
        raise FitError(f"The points on {labels} hold the blade too loosely: one sigma of {worst:.3f} mm at an end "
                       f"of the model, at most {settings.max_point_sigma_mm:.3f} mm. Weakest: "
                       f"{conditioning.description} in the CAD frame. "
                       "Scan more points or more faces.", Code.ILL_CONDITIONED)


def _advice(direction: Array) -> str:
    """Which face would hold a weak direction (6,)."""
    rotation, translation = direction[:3], direction[3:]
    if np.linalg.norm(translation) >= np.linalg.norm(rotation):
        axis = translation / np.linalg.norm(translation) + 0.0
        return f"Add a face whose normal points along ({axis[0]:.2f}, {axis[1]:.2f}, {axis[2]:.2f}), even partly."
    axis = rotation / np.linalg.norm(rotation) + 0.0
    return ("Add a plane beside the line through the middle of the faces along "
            f"({axis[0]:.2f}, {axis[1]:.2f}, {axis[2]:.2f}), its normal crosswise to that line.")
