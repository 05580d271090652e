"""Ray casting against solids: open3d finds the triangle, the exact surface behind it gives the point.

A triangle mesh is only the index here. Hits on planes and cylinders are intersected in closed form, hits on the true
airfoil by Newton steps; other faces keep the point of their fine tessellation.
"""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property
from typing import Any

import numpy as np
from numpy.typing import NDArray

from devices.sim.airfoil import TrueAirfoil
from devices.sim.geometry import Array

_CHUNK = 100_000
_NEWTON_STEPS = 3  # the mesh is within a few micrometres of the surface: two are enough, one for oblique rays
_LIFT_MM = 0.08  # start of a shadow ray above the surface: more than the tessellation's chord


@dataclass(frozen=True, eq=False)
class PlaneSurface:
    """A plane: points with normal . p = offset_mm."""

    normal: Array
    offset_mm: float


@dataclass(frozen=True, eq=False)
class CylinderSurface:
    """An endless cylinder; `outward` is -1 where the material is outside."""

    point: Array
    axis: Array
    radius_mm: float
    outward: int


@dataclass(frozen=True, eq=False)
class AirfoilSurface:
    """The true airfoil, with the parameters of the mesh vertices (V, 2)."""

    airfoil: TrueAirfoil
    vertex_uv: Array


Surface = PlaneSurface | CylinderSurface | AirfoilSurface


@dataclass(frozen=True, eq=False)
class Solid:
    """A triangle mesh whose faces know their exact surface.

    Attributes:
        vertices: (V, 3) mm in the solid's own frame.
        triangles: (T, 3) int, outward.
        face: (T,) int, index into `surfaces` and `names`.
        surfaces: Exact surface of each face, None where the tessellation is all there is.
        names: Name of each face, empty where it has none.
    """

    vertices: Array
    triangles: NDArray[np.intp]
    face: NDArray[np.intp]
    surfaces: tuple[Surface | None, ...]
    names: tuple[str, ...]


@dataclass(frozen=True, eq=False)
class Hits:
    """What rays hit; all (N, ...), in the frame of the rays.

    Attributes:
        distance_mm: Along the unit direction; inf where nothing was hit.
        normal: Outward unit normal at the hit; 0 where nothing was hit.
        face: Face index of the solid, -1 where nothing was hit.
    """

    distance_mm: Array
    normal: Array
    face: NDArray[np.intp]


class RayScene:
    """One solid, ready for rays given in its own frame; its search tree is made at the first ray."""

    def __init__(self, solid: Solid) -> None:
        self.solid = solid
        corners = solid.vertices[solid.triangles]
        normals = np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
        self._normals = normals / np.maximum(np.linalg.norm(normals, axis=1, keepdims=True), 1e-300)
        self._used = np.unique(solid.triangles)

    @cached_property
    def _scene(self) -> Any:
        open3d = _open3d()
        scene = open3d.t.geometry.RaycastingScene(nthreads=2)
        vertices = open3d.core.Tensor(self.solid.vertices.astype(np.float32))
        scene.add_triangles(vertices, open3d.core.Tensor(self.solid.triangles.astype(np.uint32)))
        return scene

    def bounding_sphere(self) -> tuple[Array, float]:
        """Centre (3,) and radius in mm of a sphere around the solid."""
        points = self.solid.vertices[self._used]
        centre = (points.min(axis=0) + points.max(axis=0)) / 2.0
        return centre, float(np.linalg.norm(points - centre, axis=1).max())

    def cast(self, origins: Array, directions: Array) -> Hits:
        """First hits of rays (N, 3) with unit directions (N, 3)."""
        count = len(directions)
        distance, normal = np.full(count, np.inf), np.zeros((count, 3))
        face = np.full(count, -1, dtype=np.intp)
        if count == 0:
            return Hits(distance, normal, face)
        answer = self._scene.cast_rays(_rays(origins, directions))
        triangle = answer["primitive_ids"].numpy().astype(np.int64)
        distance[:] = answer["t_hit"].numpy()
        hit = np.flatnonzero(np.isfinite(distance))
        face[hit] = self.solid.face[triangle[hit]]
        normal[hit] = self._normals[triangle[hit]]
        barycentric = answer["primitive_uvs"].numpy()
        for index in np.unique(face[hit]):
            surface = self.solid.surfaces[index]
            rows = hit[face[hit] == index]
            if isinstance(surface, PlaneSurface):
                _on_plane(surface, origins, directions, rows, distance, normal)
            elif isinstance(surface, CylinderSurface):
                _on_cylinder(surface, origins, directions, rows, distance, normal)
            elif isinstance(surface, AirfoilSurface):
                corners = surface.vertex_uv[self.solid.triangles[triangle[rows]]]
                weight = barycentric[rows].astype(float)
                start = corners[:, 0] + weight[:, :1] * (corners[:, 1] - corners[:, 0])
                start += weight[:, 1:] * (corners[:, 2] - corners[:, 0])
                _on_airfoil(surface, start, origins, directions, rows, distance, normal)
        return Hits(distance, normal, face)

    def blocked(self, points: Array, normals: Array, source: Array) -> NDArray[np.bool_]:
        """Which points (N, 3) do not see the light at `source` (3,), seen from just above their surface."""
        start = points + _LIFT_MM * normals
        way = source - start
        rays = _rays(start, way / np.linalg.norm(way, axis=1, keepdims=True))
        return np.asarray(self._scene.test_occlusions(rays, tnear=0.0, tfar=float("inf")).numpy())


def _open3d() -> Any:
    import open3d

    return open3d


def _rays(origins: Array, directions: Array) -> Any:
    rays = np.empty((len(directions), 6), dtype=np.float32)
    rays[:, :3], rays[:, 3:] = origins, directions
    return _open3d().core.Tensor(rays)


def _on_plane(
    surface: PlaneSurface, origins: Array, directions: Array, rows: NDArray[np.intp], distance: Array, normal: Array
) -> None:
    slope = directions[rows] @ surface.normal
    usable = np.abs(slope) > 1e-6
    rows, slope = rows[usable], slope[usable]
    distance[rows] = (surface.offset_mm - origins[rows] @ surface.normal) / slope
    normal[rows] = surface.normal


def _on_cylinder(
    surface: CylinderSurface, origins: Array, directions: Array, rows: NDArray[np.intp], distance: Array, normal: Array
) -> None:
    offset, ray = origins[rows] - surface.point, directions[rows]
    offset_across = offset - np.outer(offset @ surface.axis, surface.axis)
    ray_across = ray - np.outer(ray @ surface.axis, surface.axis)
    a = np.einsum("ij,ij->i", ray_across, ray_across)
    b = np.einsum("ij,ij->i", ray_across, offset_across)
    c = np.einsum("ij,ij->i", offset_across, offset_across) - surface.radius_mm**2
    root = b**2 - a * c
    usable = (root > 0.0) & (a > 1e-12)
    rows, a, b, root = rows[usable], a[usable], b[usable], np.sqrt(root[usable])
    first, second = (-b - root) / a, (-b + root) / a
    nearer = np.abs(first - distance[rows]) < np.abs(second - distance[rows])
    distance[rows] = np.where(nearer, first, second)
    across = offset_across[usable] + distance[rows, None] * ray_across[usable]
    normal[rows] = surface.outward * across / surface.radius_mm


def _on_airfoil(
    surface: AirfoilSurface,
    start_uv: Array,
    origins: Array,
    directions: Array,
    rows: NDArray[np.intp],
    distance: Array,
    normal: Array,
) -> None:
    airfoil, outward = surface.airfoil, surface.airfoil.design.outward
    u_low, u_high, v_low, v_high = airfoil.design.domain
    for begin in range(0, len(rows), _CHUNK):
        part = rows[begin : begin + _CHUNK]
        u, v = start_uv[begin : begin + _CHUNK].T
        reach = distance[part]
        origin, ray = origins[part], directions[part]
        for _ in range(_NEWTON_STEPS):
            point, du, dv = airfoil.point_and_tangents(u, v)
            across = np.cross(du, dv)
            gap = origin + reach[:, None] * ray - point
            slope = np.einsum("ij,ij->i", across, ray)
            usable = np.abs(slope) > 1e-3 * np.linalg.norm(across, axis=1)
            slope = np.where(usable, slope, np.inf)
            step = -np.einsum("ij,ij->i", across, gap) / slope
            gap = gap + step[:, None] * ray
            gram_uu, gram_vv = np.einsum("ij,ij->i", du, du), np.einsum("ij,ij->i", dv, dv)
            gram_uv = np.einsum("ij,ij->i", du, dv)
            right_u, right_v = np.einsum("ij,ij->i", du, gap), np.einsum("ij,ij->i", dv, gap)
            det = gram_uu * gram_vv - gram_uv**2
            u = np.clip(u + usable * (gram_vv * right_u - gram_uv * right_v) / det, u_low, u_high)
            v = np.clip(v + usable * (gram_uu * right_v - gram_uv * right_u) / det, v_low, v_high)
            reach = reach + step
        # near the silhouette Newton may run off: keep the mesh point there
        good = np.abs(reach - distance[part]) < 0.05
        distance[part[good]] = reach[good]
        normal[part] = outward * across / np.linalg.norm(across, axis=1, keepdims=True)
