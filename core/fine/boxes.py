"""Filter boxes: which scan points belong to which face, seen from a pose."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from core.cad import Cylinder, Plane
from core.cad.patches import Patch
from core.fine.trim_field import TrimField, trim_field
from core.frames import inverse, transform_points

Array = NDArray[np.float64]
Index = NDArray[np.int64]

_CHUNK = 65_536
_BOX_SLACK_MM = 1.0


@dataclass(frozen=True, eq=False)
class Target:
    """A patch prepared for many look-ups.

    Attributes:
        patch: Surface and trim, frame W.
        field: Raster of the trim.
        box_mm: (2, 3) lower and upper corner of the patch's box in W.
        anchors: (K, 3) points in W spread over the patch.
    """

    patch: Patch
    field: TrimField
    box_mm: Array
    anchors: Array

    @property
    def is_plane(self) -> bool:
        """True for a plane, False for a cylinder."""
        return isinstance(self.patch.surface, Plane)


@dataclass(frozen=True, eq=False)
class FacePoints:
    """Points in one face's filter box.

    Attributes:
        index: (n,) places in the cloud.
        points: (n, 3) mm in M.
        depth: (n,) mm to the edge of the trim.
    """

    index: Index
    points: Array
    depth: NDArray[np.float32]


def make_target(patch: Patch) -> Target:
    """Raster, box and anchor points of a patch."""
    field = trim_field(patch.surface, patch.trim)
    rows, columns = np.nonzero(field.depth > 0.0)
    if len(rows) == 0:
        rows, columns = np.nonzero(field.depth >= field.depth.max())
    chosen = np.unique(np.linspace(0, len(rows) - 1, 2000).astype(int))
    s = field.corner[0] + (columns[chosen] + 0.5) * field.cell_mm
    t = field.corner[1] + (rows[chosen] + 0.5) * field.cell_mm
    anchors = patch.surface.from_surface(s, t)
    reach = _BOX_SLACK_MM + 2.0 * np.sqrt(field.area_mm2(0.0) / len(chosen))
    return Target(patch, field, np.array([anchors.min(axis=0) - reach, anchors.max(axis=0) + reach]), anchors)


def gather(targets: Sequence[Target], points: Array, measure_from_work: Array, *, half_thickness_mm: float,
           margin_mm: float) -> list[FacePoints]:
    """Points in exactly one face's box, seen from a pose.

    Args:
        targets: F faces.
        points: (N, 3) mm in M.
        measure_from_work: 4x4.
        half_thickness_mm: Largest distance from the surface, to either side.
        margin_mm: Smallest distance from the edge of the trim, along the surface.

    Returns:
        F lists of points; a point in two boxes belongs to neither.
    """
    work_from_measure = inverse(measure_from_work)
    found: list[list[tuple[Index, NDArray[np.float32]]]] = [[] for _ in targets]
    for start in range(0, len(points), _CHUNK):
        in_work = transform_points(work_from_measure, points[start : start + _CHUNK])
        times = np.zeros(len(in_work), dtype=np.int8)
        here = list(_in_boxes(targets, in_work, half_thickness_mm, margin_mm))
        for index, _ in here:
            times[index] += 1
        for lists, (index, depth) in zip(found, here, strict=True):
            alone = times[index] == 1
            lists.append((index[alone] + start, depth[alone]))
    result = []
    for lists in found:
        index = np.concatenate([part[0] for part in lists]) if lists else np.zeros(0, dtype=np.int64)
        depth = np.concatenate([part[1] for part in lists]) if lists else np.zeros(0, dtype=np.float32)
        result.append(FacePoints(index, points[index], depth))
    return result


def _in_boxes(targets: Sequence[Target], in_work: Array, half_thickness_mm: float,
              margin_mm: float) -> Iterator[tuple[Index, NDArray[np.float32]]]:
    """For each target the places and depths of the points (n, 3) of frame W in its box."""
    planes = [target.patch.surface for target in targets if isinstance(target.patch.surface, Plane)]
    if planes:
        normals = np.array([plane.normal for plane in planes])
        offsets = np.array([plane.normal @ plane.origin for plane in planes])
        # One matrix product for all planes; its columns are read one by one.
        near = np.abs((normals @ in_work.T) - offsets[:, None]) < half_thickness_mm
    at = 0
    for target in targets:
        low, high = target.box_mm[0] - half_thickness_mm, target.box_mm[1] + half_thickness_mm
        if target.is_plane:
            index = np.flatnonzero(near[at])
            at += 1
        else:
            axis = int(np.argmin(high - low))
            index = np.flatnonzero((in_work[:, axis] > low[axis]) & (in_work[:, axis] < high[axis]))
        candidates = in_work[index]
        inside = np.all((candidates > low) & (candidates < high), axis=1)
        index, candidates = index[inside], candidates[inside]
        s, t, d = target.patch.surface.to_surface(candidates)
        depth = target.field.depth_at(s, t)
        keep = (depth > margin_mm) & (np.abs(d) < half_thickness_mm)
        yield index[keep], depth[keep]


def distances(target: Target, points: Array, measure_from_work: Array) -> Array:
    """Signed distances (n,) of points (n, 3) in M from the untrimmed surface; positive outside the material."""
    surface = target.patch.surface
    if isinstance(surface, Plane):
        normal = measure_from_work[:3, :3] @ surface.normal
        origin = transform_points(measure_from_work, surface.origin)
        return np.asarray(points @ normal - normal @ origin)
    return cylinder_rows(surface, points, measure_from_work)[0]


def cylinder_rows(surface: Cylinder, points: Array, measure_from_work: Array) -> tuple[Array, Array]:
    """Signed distances (n,) and outward normals (n, 3) in M of points (n, 3) in M."""
    axis = measure_from_work[:3, :3] @ surface.axis
    offset = points - transform_points(measure_from_work, surface.origin)
    radial = offset - np.outer(offset @ axis, axis)
    rho = np.maximum(np.sqrt(np.einsum("ij,ij->i", radial, radial)), 1e-9)
    return surface.outward * (rho - surface.radius_mm), surface.outward * radial / rho[:, None]
