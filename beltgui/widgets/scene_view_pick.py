"""What lies under a pixel: the point or the face that the person sees there."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from beltgui.viewmodel.scene import Mesh, Points, Scene
from beltgui.widgets.scene_view_camera import Camera

Array = NDArray[np.float64]

REACH_PX = 10.0
# Points no deeper than this behind what is in front count as seen: a scan lies on its blade, not exactly.
BEHIND_PX = 14.0
SOLID = 0.6


@dataclass(frozen=True, eq=False)
class Hit:
    """What was hit: an item, where (3,) mm in the scene's frame, and on a mesh with faces which face."""

    item: str
    xyz: Array
    face_id: int | None = None


def pick(scene: Scene, camera: Camera, x: float, y: float, width: float, height: float, mode: str) -> Hit | None:
    """What is under a pixel.

    Args:
        scene: What is shown.
        camera: As it is shown.
        x: Pixel, from the left.
        y: Pixel, from the top.
        width: Of the viewport.
        height: Of the viewport.
        mode: `point`: a pickable cloud's point or a place on a pickable mesh; `face`: a face of a pickable mesh.
    """
    eye, direction = camera.ray(x, y, width, height)
    surface, nearest, solid = None, np.inf, np.inf
    for item in scene.items:
        if not isinstance(item, Mesh) or item.wireframe:
            continue
        wanted = item.pickable and (mode == "point" or item.face_id is not None)
        if not wanted and item.opacity < SOLID:
            continue
        along, triangle = _first_triangle(item, eye, direction)
        if triangle is None:
            continue
        solid = min(solid, along) if item.opacity >= SOLID else solid
        if wanted and along < nearest:
            face = None if item.face_id is None else int(np.asarray(item.face_id)[triangle])
            surface, nearest = Hit(item.name, eye + along * direction, face), along
    if mode == "face":
        return surface
    point = _nearest_point(scene, camera, x, y, width, height, min(solid, nearest))
    return point or surface


def _nearest_point(
    scene: Scene, camera: Camera, x: float, y: float, width: float, height: float, surface: float
) -> Hit | None:
    near: list[tuple[str, Array, Array, Array]] = []
    for item in scene.items:
        if isinstance(item, Points) and item.pickable and len(item.xyz):
            pixels, depth = camera.project(item.xyz, width, height)
            away = np.hypot(pixels[:, 0] - x, pixels[:, 1] - y)
            within = np.flatnonzero((away <= REACH_PX) & (depth > 0.0))
            near.append((item.name, np.asarray(item.xyz, dtype=float)[within], away[within], depth[within]))
    front = min([surface, *(float(depth.min()) for _, _, _, depth in near if len(depth))])
    best: Hit | None = None
    least = np.inf
    for name, xyz, away, depth in near:
        seen = depth <= front + BEHIND_PX * camera.mm_per_pixel(height)
        if seen.any():
            place = int(np.argmin(np.where(seen, away, np.inf)))
            if away[place] < least:
                best, least = Hit(name, xyz[place]), float(away[place])
    return best


def _first_triangle(mesh: Mesh, eye: Array, direction: Array) -> tuple[float, int | None]:
    """Distance along the ray and number of the first triangle that it meets (Moeller and Trumbore, both sides)."""
    if not len(mesh.triangles):
        return np.inf, None
    a, b, c = np.asarray(mesh.vertices, dtype=float)[np.asarray(mesh.triangles, dtype=np.intp).T]
    ab, ac = b - a, c - a
    p = np.cross(direction, ac)
    with np.errstate(divide="ignore", invalid="ignore"):
        inverse = 1.0 / np.einsum("nd,nd->n", ab, p)
        s = eye - a
        u = np.einsum("nd,nd->n", s, p) * inverse
        q = np.cross(s, ab)
        v = (q @ direction) * inverse
        along = np.einsum("nd,nd->n", ac, q) * inverse
        hit = (u >= 0.0) & (v >= 0.0) & (u + v <= 1.0) & (along > 0.0)
    if not hit.any():
        return np.inf, None
    place = int(np.argmin(np.where(hit, along, np.inf)))
    return float(along[place]), place
