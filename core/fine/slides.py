"""Slides: a pose in which the scan lies on the wrong ones of parallel faces, and how to get out of it.

Blades have many parallel faces a few mm apart, and the table of a fixture is parallel to them too. Where the coarse
stage
ends on the wrong ones, the error is a plain shift along their common normal. All faces that are not parallel to the
shift
vote for it: each point beside a face, with the face's direction, votes for the shift that would put it onto the face (a
Hough transform in one unknown).
"""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
from numpy.typing import NDArray

from core.fine.boxes import Target
from core.fine.coarse import ThinScan
from core.frames import inverse, rotate, transform_points

Array = NDArray[np.float64]

_BIN_MM = 0.1
_SAME_DIRECTION = 0.999
_AGREES = 0.93
_INNER_MM = 0.6
_LEAST_ALONG = 0.25
_LEAST_VOTES = 8.0
_PEAKS = 4
_APART_MM = 0.6
_MOST = 24


def slid_poses(targets: Sequence[Target], scan: ThinScan, pose: Array, reach_mm: float) -> list[Array]:
    """Poses shifted along the common normals of the planes to where many points would lie on them.

    Args:
        targets: Chosen faces.
        scan: Thinned scan.
        pose: measure_from_work, right up to such a shift.
        reach_mm: Largest shift.

    Returns:
        measure_from_work, most votes first.
    """
    found: list[tuple[float, Array]] = []
    work_from_measure = inverse(pose)
    points, normals = transform_points(work_from_measure, scan.points), rotate(work_from_measure, scan.normals)
    flat = scan.flatness > 0.5
    planes = [(target, target.patch.surface.normal_at(target.anchors[0])) for target in targets if target.is_plane]
    beside = [points[flat & (np.abs(normals @ normal) > _AGREES)] for _, normal in planes]
    for direction in _directions([normal for _, normal in planes]):
        votes = np.zeros(2 * int(reach_mm / _BIN_MM) + 1)
        for (target, normal), near in zip(planes, beside, strict=True):
            along = float(normal @ direction)
            if abs(along) < _LEAST_ALONG:
                continue
            shift = target.patch.surface.to_surface(near)[2] / along
            s, t, _ = target.patch.surface.to_surface(near - shift[:, None] * direction)
            votes += _counted(shift[target.field.depth_at(s, t) > _INNER_MM], reach_mm, len(votes))
        found += [(count, direction * shift) for count, shift in _peaks(np.convolve(votes, np.ones(3), mode="same"))]
    found.sort(key=lambda item: -item[0])
    result = []
    for _, shift in found[:_MOST]:
        moved = pose.copy()
        moved[:3, 3] += pose[:3, :3] @ shift
        result.append(moved)
    return result


def _counted(shifts: Array, reach_mm: float, bins: int) -> Array:
    """Histogram of shifts with a bin in the middle of zero."""
    return np.histogram(shifts, bins=bins, range=(-reach_mm - _BIN_MM / 2, reach_mm + _BIN_MM / 2))[0].astype(float)


def _directions(normals: Sequence[Array]) -> list[Array]:
    """The different lines along which normals point."""
    different: list[Array] = []
    for normal in normals:
        if all(abs(normal @ other) < _SAME_DIRECTION for other in different):
            different.append(normal)
    return different


def _peaks(votes: Array) -> list[tuple[float, float]]:
    """Votes and shifts in mm of the highest peaks away from zero."""
    middle = len(votes) // 2
    bins = round(_APART_MM / _BIN_MM)
    left = votes.copy()
    left[middle - bins : middle + bins + 1] = 0.0
    found: list[tuple[float, float]] = []
    while len(found) < _PEAKS and left.max() > _LEAST_VOTES:
        at = int(np.argmax(left))
        found.append((float(left[at]), (at - middle) * _BIN_MM))
        left[max(at - bins, 0) : at + bins + 1] = 0.0
    return found
