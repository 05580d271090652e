"""Where a scene's items are, so that a camera can take them all in."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from beltgui.viewmodel.scene import Arrow, Frame, Item, Label, Lines, Mesh, Points, Scene
from beltgui.widgets.scene_view_camera import DIRECTIONS, Camera, rotation_from

OUTLINE_POINTS = 3000


def first_camera(scene: Scene) -> Camera:
    """From where the scene says; else obliquely, unless the last word of its view is a direction, e.g. `base top`."""
    if scene.look_from is not None:
        return Camera(np.zeros(3), 300.0, rotation_from(scene.look_from, scene.up))
    last = scene.view.split()[-1:] or [""]
    return Camera.looking(last[0] if last[0] in DIRECTIONS else "oblique")


def wanted_items(scene: Scene, extras: tuple[Item, ...]) -> tuple[Item, ...]:
    """What the first picture takes in: what the scene says, else all of its own items."""
    every = (*scene.items, *extras)
    if scene.fit_to:
        return tuple(item for item in every if item.name.startswith(scene.fit_to)) or every
    return scene.items or extras


def outline_of(items: tuple[Item, ...]) -> NDArray[np.float64]:
    """(N, 3) points that tell where the items are; few of each, finite."""
    found: list[NDArray[np.floating]] = []
    for item in items:
        if isinstance(item, Points):
            found.append(_few(item.xyz))
        elif isinstance(item, Mesh):
            found.append(_few(item.vertices))
        elif isinstance(item, Lines):
            found.extend(_few(line) for line in item.polylines)
        elif isinstance(item, Arrow):
            found.append(np.stack([item.start, np.asarray(item.start) + item.vector]))
        elif isinstance(item, Frame):
            pose = np.asarray(item.scene_from_frame)
            found.append(np.vstack([pose[:3, 3], pose[:3, 3] + item.length_mm * pose[:3, :3].T]))
        elif isinstance(item, Label):
            found.append(np.asarray(item.at).reshape(1, 3))
    if not found:
        return np.zeros((0, 3))
    outline = np.concatenate([np.asarray(points, dtype=float).reshape(-1, 3) for points in found])
    return outline[np.isfinite(outline).all(axis=1)]


def _few(points: NDArray[np.floating]) -> NDArray[np.floating]:
    """At most about `OUTLINE_POINTS`, with the outermost along each axis among them."""
    points = np.asarray(points).reshape(-1, 3)
    if len(points) <= OUTLINE_POINTS:
        return points
    ends = np.concatenate([np.nanargmin(points, axis=0), np.nanargmax(points, axis=0)])
    return np.vstack([points[:: len(points) // OUTLINE_POINTS + 1], points[ends]])
