"""Faces that lie on one surface, joined: what registration measures on."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass, replace
from typing import TYPE_CHECKING

import numpy as np

from core.cad.model import CadFace
from core.cad.surfaces import Array, Cylinder, Plane, Surface
from core.cad.trims import recentred
from core.errors import InputError

if TYPE_CHECKING:
    from shapely import MultiPolygon, Polygon

# Two faces lie on the same surface when each boundary is this near to the other's surface and the normals agree.
SAME_SURFACE_MM = 0.002
SAME_NORMAL_RAD = 1e-3
SAME_RADIUS = 0.01
# Faces whose regions are nearer than this are neighbours; twice the chord error, for arcs may be cut differently.
TOUCHING_MM = 0.005


@dataclass(frozen=True, eq=False)
class Patch:
    """One surface with everything of it that the chosen faces cover.

    Attributes:
        surface: Common surface; its (s, t) are those of `trim`.
        face_ids: Faces that were joined, ascending.
        label: Names of the faces for messages, e.g. `S2` or `face 3 + face 7`.
        trim: Union of the faces' regions in (s, t), mm; no edge where two faces only meet. A full cylinder fills
            -pi radius .. pi radius in s; its two ends in s are one line of the surface and no edge.
    """

    surface: Surface
    face_ids: tuple[int, ...]
    label: str
    trim: Polygon | MultiPolygon

    def shrunk(self, inset_mm: float) -> Polygon | MultiPolygon:
        """The region without a border of `inset_mm` along its true edges; empty where nothing is left.

        The cut of a full cylinder is no edge and keeps its points.
        """
        import shapely

        if not self._goes_round():
            return shapely.buffer(self.trim, -inset_mm)
        period = _period(self.surface)
        copies = [_shifted(self.trim, shift) for shift in (-period, 0.0, period)]
        inner = shapely.buffer(_welded(copies), -inset_mm)
        return shapely.intersection(inner, shapely.box(-period / 2, self.trim.bounds[1], period / 2,
                                                       self.trim.bounds[3]))

    def _goes_round(self) -> bool:
        s0, _, s1, _ = self.trim.bounds
        return isinstance(self.surface, Cylinder) and s1 - s0 > _period(self.surface) - 2 * TOUCHING_MM


def merge_patches(faces: Iterable[CadFace]) -> tuple[Patch, ...]:
    """Join neighbouring faces on the same surface with the same outward side.

    Faces on the same surface that don't touch stay apart, so that results name them apart.

    Args:
        faces: Usable faces (planes and cylinders), in any order.

    Returns:
        Patches in the order of their lowest face id.

    Raises:
        InputError: a face is not usable, or given twice.
    """
    open_patches: list[Patch] = []
    seen: set[int] = set()
    for face in sorted(faces, key=lambda item: item.id):
        if not face.usable or face.surface is None or face.trim is None:
            raise InputError(f"{face.label} can't be used for registration. {face.why_not}")
        if face.id in seen:
            raise InputError(f"{face.label} is given twice.")
        seen.add(face.id)
        patch = Patch(face.surface, (face.id,), face.label, face.trim)
        # A face may close the gap between patches that were apart until now: take in every one that it touches.
        apart = []
        for other in open_patches:
            joined = _joined(other, patch)
            if joined is None:
                apart.append(other)
            else:
                patch = joined
        open_patches = [*apart, patch]
    return tuple(sorted(open_patches, key=lambda patch: patch.face_ids[0]))


def _joined(first: Patch, second: Patch) -> Patch | None:
    """Both as one patch on the first one's surface, None where they are not one."""
    import shapely

    if not (_may_be_one(first.surface, second.surface) and _lies_on(second, first) and _lies_on(first, second)):
        return None
    moved = _in_coordinates_of(first.surface, second)
    surface: Surface = first.surface
    if isinstance(surface, Cylinder):
        period = _period(surface)
        copies = [_shifted(moved, shift) for shift in (-period, 0.0, period)]
        if min(shapely.distance(first.trim, copy) for copy in copies) > TOUCHING_MM:
            return None
        surface, trim = _cut_in_gap(surface, [first.trim, moved])
    else:
        if shapely.distance(first.trim, moved) > TOUCHING_MM:
            return None
        trim = _welded([first.trim, moved])
    surface, trim = recentred(surface, trim)
    order = sorted([first, second], key=lambda patch: patch.face_ids[0])
    return Patch(surface, tuple(sorted(first.face_ids + second.face_ids)),
                 " + ".join(patch.label for patch in order), trim)


def _may_be_one(first: Surface, second: Surface) -> bool:
    """A quick look before every boundary point is compared."""
    if isinstance(first, Plane) and isinstance(second, Plane):
        return float(np.linalg.norm(first.normal - second.normal)) < SAME_NORMAL_RAD
    if isinstance(first, Cylinder) and isinstance(second, Cylinder):
        return first.outward == second.outward and abs(first.radius_mm / second.radius_mm - 1.0) < SAME_RADIUS
    return False


def _lies_on(patch: Patch, other: Patch) -> bool:
    """True where the patch's boundary lies on the other's surface, same side out."""
    import shapely

    s, t = shapely.get_coordinates(patch.trim).T
    points = patch.surface.from_surface(s, t)
    distance = np.abs(other.surface.to_surface(points)[2])
    turn = np.linalg.norm(patch.surface.normal_at(points) - other.surface.normal_at(points), axis=1)
    return bool(distance.max() < SAME_SURFACE_MM and turn.max() < SAME_NORMAL_RAD)


def _in_coordinates_of(surface: Surface, patch: Patch) -> Polygon | MultiPolygon:
    """The patch's region in (s, t) of another surface that is the same in space; unwrapped in one piece."""
    import shapely

    own = patch.surface
    s0, t0, _ = surface.to_surface(own.from_surface(0.0, 0.0))
    if isinstance(surface, Plane) and isinstance(own, Plane):
        turn = np.array([[own.x_axis @ surface.x_axis, own.x_axis @ surface.y_axis],
                         [own.y_axis @ surface.x_axis, own.y_axis @ surface.y_axis]])
    elif isinstance(surface, Cylinder) and isinstance(own, Cylinder):
        # Against the other axis both the angle and the height run backward.
        turn = np.sign(own.axis @ surface.axis) * np.diag([surface.radius_mm / own.radius_mm, 1.0])

    def moved(coordinates: Array) -> Array:
        return np.asarray(coordinates @ turn + [float(s0), float(t0)])

    return shapely.transform(patch.trim, moved)


def _cut_in_gap(surface: Cylinder, trims: list[Polygon | MultiPolygon]) -> tuple[Cylinder, Polygon | MultiPolygon]:
    """Union of regions of one cylinder, its cut laid into the widest gap around the axis."""
    import shapely

    period = _period(surface)
    spans = sorted((float(np.mod(trim.bounds[0], period)), trim.bounds[2] - trim.bounds[0]) for trim in trims)
    reach, widest, cut = sum(spans[0]), 0.0, spans[0][0]
    for start, length in [*spans[1:], (spans[0][0] + period, 0.0)]:
        if start - reach > widest:
            widest, cut = start - reach, (start + reach) / 2
        reach = max(reach, start + length)
    phi = (cut + period / 2) / surface.radius_mm
    x_axis = np.cos(phi) * surface.x_axis + np.sin(phi) * surface.y_axis
    shifts = [turn * period - cut - period / 2 for turn in (-2, -1, 0, 1, 2)]
    union = _welded([_shifted(trim, shift) for trim in trims for shift in shifts])
    _, low, _, high = union.bounds
    window = shapely.box(-period / 2, low - 1.0, period / 2, high + 1.0)
    return replace(surface, x_axis=x_axis), shapely.intersection(union, window)


def _welded(trims: list[Polygon | MultiPolygon]) -> Polygon | MultiPolygon:
    """Union without the hair cracks between neighbours whose common edge was cut into different chords."""
    import shapely

    grown = shapely.union_all([shapely.buffer(trim, TOUCHING_MM, join_style="mitre") for trim in trims])
    return shapely.buffer(grown, -TOUCHING_MM, join_style="mitre")


def _shifted(trim: Polygon | MultiPolygon, shift: float) -> Polygon | MultiPolygon:
    import shapely

    return shapely.transform(trim, lambda xy: xy + np.array([shift, 0.0]))


def _period(surface: Surface) -> float:
    """Circumference in mm; infinite for a plane."""
    return 2.0 * np.pi * surface.radius_mm if isinstance(surface, Cylinder) else np.inf
