"""The fine step: pose of a blade from scans and its CAD faces."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
from numpy.typing import NDArray

from core.cad import CadFace, CadModel, merge_patches
from core.fine.boxes import make_target
from core.fine.capture import Capture, capture
from core.fine.checks import check_capture, check_geometry, check_scan, check_start, checked_points, chosen_faces
from core.fine.estimate import Estimate, estimate
from core.fine.held_out import half_split, held_out_means
from core.fine.report import bins_of, conditioning_in_work, ends_of, face_results, largest_motion
from core.fine.result import FineFit
from core.fine.settings import FineSettings
from core.frames import PoseCovariance, checked_rigid, transform_points
from core.progress import Progress, part, silent

Array = NDArray[np.float64]


def solve_fine(model: CadModel, scans: Sequence[Array], start: Array, *, face_ids: Sequence[int | str] | None = None,
               settings: FineSettings | None = None, progress: Progress = silent) -> FineFit:
    """Register scans on the faces of a CAD model.

    Args:
        model: The blade.
        scans: Clouds (N, 3) in mm, all in M; together one scan. Points that aren't the blade's may be among them.
        start: 4x4 measure_from_work, some degrees and mm off.
        face_ids: Ids or names of the faces to measure on (planes and cylinders); None for all that can be used and
            have points.
        settings: See `FineSettings`.
        progress: Told of each start tried and each pass over the points; what it raises ends the work.

    Raises:
        InputError: unusable points, start or face.
        FitError: the points don't determine the pose, or don't fit the model; the message names the face or direction.
    """
    settings = settings or FineSettings()
    start = checked_rigid(start, "start (measure_from_work)")
    points = checked_points(scans)
    faces = chosen_faces(model, face_ids)
    check_scan(model, points)
    progress(0.0, "faces of the CAD model")
    targets = [make_target(patch) for patch in merge_patches(faces)]
    captured = capture(model, targets, points, start, settings, part(progress, 0.05, 0.8))
    found = check_capture(captured, model, points, start, settings)
    asked_for = face_ids is not None
    result = estimate(targets, points, found, settings, asked_for=asked_for, progress=part(progress, 0.8, 1.0))
    check_geometry(result, model, settings)
    check_start(model, start, result.measure_from_work, settings)
    return _assembled(model, start, faces, asked_for, result, found, len(points), settings)


def _assembled(model: CadModel, start: Array, faces: Sequence[CadFace], named: bool, result: Estimate, found: Capture,
               count: int, settings: FineSettings) -> FineFit:
    ends = ends_of(model)
    in_measure = transform_points(result.measure_from_work, ends)
    covariance = PoseCovariance(result.covariance, result.centre)
    sigmas = np.array([np.sqrt(np.trace(covariance.of_point(point))) for point in in_measure])
    return FineFit(
        measure_from_work=result.measure_from_work,
        covariance=covariance,
        faces=face_results(faces, result, held_out_means(result)),
        faces_named=named,
        sigma_mm=result.sigma_mm,
        rms_mm=result.rms_mm,
        points=count,
        points_used=round(result.weight),
        near_share=found.share,
        iterations=result.passes,
        converged=True,
        conditioning=conditioning_in_work(result),
        ends_in_work_mm=ends,
        point_sigma_mm=sigmas,
        half_split_mm=half_split(result, in_measure),
        start_moved_mm=largest_motion(model, start, result.measure_from_work),
        bins_mm=bins_of(result),
        settings=settings,
    )
