"""Boundary loops of kernel faces as polygons in the flat coordinates (s, t) of their surface, mm."""

from __future__ import annotations

from dataclasses import replace
from typing import TYPE_CHECKING, Any, TypeVar

import numpy as np

from core.cad.surfaces import Array, Cylinder, Plane, Surface

if TYPE_CHECKING:
    from shapely import MultiPolygon, Polygon

# Largest distance of a chord from the arc that it stands for.
CHORD_ERROR_MM = 0.002
# Largest turn between neighbouring chords; keeps tiny arcs round.
CHORD_TURN_RAD = 0.2
# Ends of consecutive edges that are further apart than this don't form a loop.
GAP_MM = 0.05
# Consecutive points of a loop nearer than this are one point.
SAME_POINT_MM = 1e-7

SurfaceT = TypeVar("SurfaceT", Plane, Cylinder, Surface)


class TrimError(ValueError):
    """The loops of a face can't be turned into a polygon; the text completes `can't be used: ..`."""


def plane_trim(face: Any, plane: Plane) -> Polygon | MultiPolygon:
    """Region of a planar kernel face in the plane's (s, t).

    Raises:
        TrimError: the loops don't close or enclose nothing.
    """
    loops = []
    for wire in _wires(face):
        pieces = [np.column_stack(plane.to_surface(points)[:2]) for points in _edges(wire, face)]
        loops.append(_closed(pieces, period=None))
    return _region(loops, period=None)


def cylinder_trim(face: Any, cylinder: Cylinder) -> Polygon | MultiPolygon:
    """Region of a cylindrical kernel face in (s, t), unwrapped without a jump; s may lie outside (-pi, pi] radius.

    The loop is followed in space; on a full cylinder it walks the seam twice, a turn apart.

    Raises:
        TrimError: the loops don't close, go around the axis without a seam, or enclose nothing.
    """
    period = 2.0 * np.pi * cylinder.radius_mm
    loops = []
    for wire in _wires(face):
        pieces = []
        for points in _edges(wire, face):
            s, t, _ = cylinder.to_surface(points)
            pieces.append(np.column_stack([np.unwrap(s, period=period), t]))
        loops.append(_closed(pieces, period))
    return _region(loops, period)


def recentred(surface: SurfaceT, trim: Polygon | MultiPolygon) -> tuple[SurfaceT, Polygon | MultiPolygon]:
    """The same surface and region with s = t = 0 in the middle of the region's box."""
    import shapely

    s0, t0, s1, t1 = trim.bounds
    s, t = (s0 + s1) / 2, (t0 + t1) / 2
    moved = shapely.transform(trim, lambda xy: xy - np.array([s, t]))
    if isinstance(surface, Plane):
        return replace(surface, origin=surface.from_surface(s, t)), moved
    phi = s / surface.radius_mm
    x_axis = np.cos(phi) * surface.x_axis + np.sin(phi) * surface.y_axis
    return replace(surface, origin=surface.origin + t * surface.axis, x_axis=x_axis), moved


def _wires(face: Any) -> list[Any]:
    """Loops of a face, seen on its surface's own side."""
    from OCP.TopAbs import TopAbs_Orientation, TopAbs_ShapeEnum
    from OCP.TopExp import TopExp_Explorer
    from OCP.TopoDS import TopoDS

    explorer = TopExp_Explorer(face.Oriented(TopAbs_Orientation.TopAbs_FORWARD), TopAbs_ShapeEnum.TopAbs_WIRE)
    wires = []
    while explorer.More():
        wires.append(TopoDS.Wire(explorer.Current()))
        explorer.Next()
    if not wires:
        raise TrimError("it has no boundary")
    return wires


def _edges(wire: Any, face: Any) -> list[Array]:
    """Points (N, 3) of the edges of a loop, edges and points in walking order."""
    from OCP.BRep import BRep_Tool
    from OCP.BRepAdaptor import BRepAdaptor_Curve
    from OCP.BRepTools import BRepTools_WireExplorer
    from OCP.GCPnts import GCPnts_TangentialDeflection
    from OCP.TopAbs import TopAbs_Orientation
    from OCP.TopoDS import TopoDS

    explorer = BRepTools_WireExplorer(wire, TopoDS.Face(face.Oriented(TopAbs_Orientation.TopAbs_FORWARD)))
    found = []
    while explorer.More():
        edge = explorer.Current()
        if not BRep_Tool.Degenerated_s(edge):
            sampler = GCPnts_TangentialDeflection(BRepAdaptor_Curve(edge), CHORD_TURN_RAD, CHORD_ERROR_MM)
            places = [sampler.Value(i) for i in range(1, sampler.NbPoints() + 1)]
            points = np.array([(place.X(), place.Y(), place.Z()) for place in places])
            backward = edge.Orientation() == TopAbs_Orientation.TopAbs_REVERSED
            found.append(points[::-1] if backward else points)
        explorer.Next()
    return found


def _closed(pieces: list[Array], period: float | None) -> Array:
    """Join polylines (N, 2) to one loop; along s a piece may be a whole number of periods away."""
    if not pieces:
        raise TrimError("a loop has no edges")
    loop = [pieces[0]]
    for piece in [*pieces[1:], pieces[0]]:
        step = loop[-1][-1] - piece[0]
        if period is not None:
            turns = period * np.round(step[0] / period)
            piece, step = piece + np.array([turns, 0.0]), step - np.array([turns, 0.0])
        if np.hypot(*step) > GAP_MM:
            raise TrimError(f"a loop has a gap of {np.hypot(*step):.3g} mm")
        loop.append(piece)
    if abs(loop[-1][0, 0] - loop[0][0, 0]) > GAP_MM:
        raise TrimError("a loop goes around the axis without a seam")
    points = np.vstack(loop[:-1])
    return np.asarray(points[np.hypot(*(points - np.roll(points, 1, axis=0)).T) > SAME_POINT_MM])


def _region(loops: list[Array], period: float | None) -> Polygon | MultiPolygon:
    """Polygon of the largest loop without the others."""
    import shapely

    if any(len(loop) < 3 for loop in loops):
        raise TrimError("a loop has no area")
    polygons = sorted((shapely.make_valid(shapely.Polygon(loop)) for loop in loops), key=lambda p: -p.area)
    outer, holes = polygons[0], polygons[1:]
    for hole in holes:
        # A hole's loop may start a turn away from the outer loop.
        places = [0.0] if period is None else [-2 * period, -period, 0.0, period, 2 * period]
        moved = [shapely.transform(hole, lambda xy, shift=shift: xy + np.array([shift, 0.0])) for shift in places]
        outer = shapely.difference(outer, max(moved, key=lambda candidate: candidate.intersection(outer).area))
    parts = [part for part in shapely.get_parts(outer) if part.geom_type == "Polygon" and part.area > 0.0]
    if not parts:
        raise TrimError("its boundary encloses no area")
    if period is not None and outer.bounds[2] - outer.bounds[0] > period * (1.0 + 1e-6):
        raise TrimError("its boundary goes around the axis more than once")
    return parts[0] if len(parts) == 1 else shapely.MultiPolygon(parts)
