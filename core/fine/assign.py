"""Which face each scan point belongs to under a finished fit; for overlays and reports."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from core.cad import CadModel, merge_patches
from core.fine.boxes import distances, gather, make_target
from core.frames import checked_rigid

Array = NDArray[np.float64]


@dataclass(frozen=True, eq=False)
class Assignment:
    """Faces of scan points.

    Attributes:
        face_id: (N,) id of the CadFace, 0 for none.
        distance_mm: (N,) signed distance from that face, positive outside the material; NaN for none.
    """

    face_id: NDArray[np.int64]
    distance_mm: Array


def assign_points(model: CadModel, points: Array, measure_from_work: Array, face_ids: Sequence[int], *,
                  half_thickness_mm: float = 0.2, margin_mm: float = 0.0) -> Assignment:
    """Assign points to faces at a pose.

    Args:
        model: The blade.
        points: (N, 3) mm in M.
        measure_from_work: 4x4.
        face_ids: Faces to look at; faces of one surface are not joined here.
        half_thickness_mm: Largest distance from a face.
        margin_mm: Smallest distance from its edge.

    Returns:
        A point near two faces belongs to neither.

    Raises:
        InputError: a face is unknown or can't be used, or the pose is no rigid transform.
    """
    pose = checked_rigid(measure_from_work, "measure_from_work")
    targets = [make_target(patch) for face in model.select(face_ids) for patch in merge_patches([face])]
    boxes = gather(targets, np.asarray(points, dtype=float), pose, half_thickness_mm=half_thickness_mm,
                   margin_mm=margin_mm)
    face_id = np.zeros(len(points), dtype=np.int64)
    distance = np.full(len(points), np.nan)
    for target, box in zip(targets, boxes, strict=True):
        face_id[box.index] = target.patch.face_ids[0]
        distance[box.index] = distances(target, box.points, pose)
    return Assignment(face_id, distance)
