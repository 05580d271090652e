"""Small things that move in a scene of the robot's base frame: the planned motion, the flange as it is now."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray
from PySide6.QtCore import QCoreApplication

from beltgui.viewmodel.scene import Arrow, Frame, Item, Label, Lines, Mesh, Role, Scene
from beltgui.widgets.scene_view_overlay import UNWRITTEN

Array = NDArray[np.float64]

BASE_RADIUS_MM = 95.0
PLATE_MM = 31.5
MOTION = f"{UNWRITTEN}motion "
TOWARDS = "towards the base"
SIDES = 32
HEADS = 4


def motion_items(path: Array) -> tuple[Item, ...]:
    """The way of the flange with heads along it that say which way, the flange at its start and at its end.

    Args:
        path: (n, 4, 4) base_from_flange.
    """
    path = np.asarray(path, dtype=float).reshape(-1, 4, 4)
    places = path[:, :3, 3]
    extent = float(np.ptp(places, axis=0).max())
    size = float(np.clip(0.12 * extent, PLATE_MM, 110.0))
    items: list[Item] = [
        _plate(f"{MOTION}end plate", path[-1], size, Role.SUGGESTION, 0.85),
        Frame(f"{MOTION}end frame", path[-1], 1.8 * size),
    ]
    if len(path) > 1 and extent > 1.0:
        items += [
            _plate(f"{MOTION}start plate", path[0], size, Role.ROBOT, 0.85),
            Frame(f"{MOTION}start frame", path[0], 1.8 * size),
            Lines(f"{MOTION}way", (places.astype(np.float32),), Role.SUGGESTION, 5.0),
            Label(f"{MOTION}start", places[0], QCoreApplication.translate("SceneView", "start"), Role.MUTED),
        ]
        items += _heads(places, 0.45 * size)
    items.append(Label(f"{MOTION}end", places[-1], QCoreApplication.translate("SceneView", "end"), Role.SUGGESTION))
    return tuple(items)


def _heads(places: Array, length: float) -> list[Item]:
    """Cones along a way (n, 3), evenly by its length and pointing along it; fewer where it is short."""
    steps = np.linalg.norm(np.diff(places, axis=0), axis=1)
    at = np.concatenate([[0.0], np.cumsum(steps)])
    count = int(np.clip(at[-1] / (3.0 * length), 1, HEADS))
    items: list[Item] = []
    for number in range(count):
        tip, tail = ((number + 0.5) / count * at[-1] + side * 0.5 * length for side in (1.0, -1.0))
        ends = np.stack([np.interp([tail, tip], at, places[:, axis]) for axis in range(3)], axis=1)
        way = ends[1] - ends[0]
        if np.linalg.norm(way) > 0.0:
            items.append(_cone(f"{MOTION}head {number}", ends[0], length * way / np.linalg.norm(way)))
    return items


def _ring(center: Array, normal: Array, radius: float) -> Array:
    aside = np.cross(normal, np.eye(3)[int(np.argmin(np.abs(normal)))])
    aside /= np.linalg.norm(aside)
    angle = np.linspace(0.0, 2.0 * np.pi, SIDES, endpoint=False)[:, None]
    return np.asarray(center + radius * (np.cos(angle) * aside + np.sin(angle) * np.cross(normal, aside)))


def _fan(name: str, tip: Array, ring: Array, role: Role, opacity: float) -> Mesh:
    here = np.arange(SIDES)
    triangles = np.stack([np.zeros(SIDES), 1 + here, 1 + (here + 1) % SIDES], axis=1).astype(np.int32)
    return Mesh(name, np.vstack([tip, ring]).astype(np.float32), triangles, role, opacity)


def _cone(name: str, foot: Array, way: Array) -> Mesh:
    normal = way / np.linalg.norm(way)
    return _fan(name, foot + way, _ring(foot, normal, 0.4 * float(np.linalg.norm(way))), Role.SUGGESTION, 1.0)


def _plate(name: str, pose: Array, radius: float, role: Role, opacity: float) -> Mesh:
    return _fan(name, pose[:3, 3], _ring(pose[:3, 3], pose[:3, 2], radius), role, opacity)


def robot_items(base_from_flange: Array) -> tuple[Item, ...]:
    """The flange as it is now: a plate and its frame.

    Args:
        base_from_flange: (4, 4).
    """
    pose = np.asarray(base_from_flange, dtype=float)
    return (Frame("{F}", pose, 60.0), _plate(f"{UNWRITTEN}flange", pose, PLATE_MM, Role.ROBOT, 0.6))


def towards_base(middle: Array, reach: float) -> tuple[Item, ...]:
    """An arrow from beside what is seen to the robot's base, with the distance; none where the base is near.

    Args:
        middle: (3,) of what is seen, {B}.
        reach: How far that extends from its middle, mm.
    """
    distance = float(np.linalg.norm(middle))
    if distance < 2.5 * reach:
        return ()
    way = -np.asarray(middle, dtype=float) / distance
    return (Arrow(TOWARDS, middle + 0.9 * reach * way, 0.4 * reach * way, Role.ROBOT,
                  f"{{B}} {distance:.0f} mm"),)  # fmt: skip


def motion_scene(path: Array) -> Scene:
    """A scene of the robot's base, for a motion that is planned while the step shows another frame.

    Args:
        path: (n, 4, 4) base_from_flange.
    """
    path = np.asarray(path, dtype=float).reshape(-1, 4, 4)
    ends = path[[0, -1], :3, 3].round(1).tolist() if len(path) else []
    foot = _ring(np.zeros(3), np.array([0.0, 0.0, 1.0]), BASE_RADIUS_MM)
    items: list[Item] = [
        Frame("{B}", np.eye(4), 1.3 * BASE_RADIUS_MM),
        Lines(f"{UNWRITTEN}foot", (np.vstack([foot, foot[:1]]).astype(np.float32),), Role.ROBOT, 2.0),
    ]
    if len(path):
        places = path[:, :3, 3]
        low, high = places.min(axis=0), places.max(axis=0)
        items += towards_base((low + high) / 2.0, max(0.5 * float(np.linalg.norm(high - low)), 2.5 * PLATE_MM))
    return Scene(
        title=QCoreApplication.translate("SceneView", "Planned motion of the robot"),
        frame="B",
        items=tuple(items),
        view=f"planned motion {ends}",  # each one is shown as a whole at first
        legend=((Role.SUGGESTION, QCoreApplication.translate("SceneView", "way of the flange")),),
        fit_to=(MOTION, TOWARDS) if len(items) > 2 else (MOTION, *(item.name for item in items)),
    )
