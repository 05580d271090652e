"""Small things that move in a scene of the robot's base frame: the planned motion, the flange as it is now."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray
from PySide6.QtCore import QCoreApplication

from beltgui.viewmodel.scene import Frame, Item, Label, Lines, Role, Scene
from beltgui.widgets.scene_view_overlay import UNWRITTEN

Array = NDArray[np.float64]

STATIONS = 6
BASE_RADIUS_MM = 120.0


def motion_items(path: Array) -> tuple[Item, ...]:
    """The way of the flange, frames along it, and which end is which.

    Args:
        path: (n, 4, 4) base_from_flange.
    """
    path = np.asarray(path, dtype=float).reshape(-1, 4, 4)
    places = path[:, :3, 3]
    extent = float(np.ptp(places, axis=0).max())
    length = min(max(0.12 * extent, 15.0), 80.0)
    stations = np.unique(np.linspace(0, len(path) - 1, min(STATIONS, len(path))).round().astype(int))
    items: list[Item] = [
        Frame(f"{UNWRITTEN}station {number}", path[place], length) for number, place in enumerate(stations)
    ]
    if len(path) > 1:
        items.append(Lines(f"{UNWRITTEN}way", (places.astype(np.float32),), Role.SUGGESTION, 3.0))
    start = QCoreApplication.translate("SceneView", "start")
    end = QCoreApplication.translate("SceneView", "end")
    if extent > 1.0:
        items.append(Label(f"{UNWRITTEN}start", places[0], start, Role.SUGGESTION))
    items.append(Label(f"{UNWRITTEN}end", places[-1], end, Role.SUGGESTION))
    return tuple(items)


def robot_items(base_from_flange: Array) -> tuple[Item, ...]:
    """The flange as a frame, and a plumb line down to the base's level.

    Args:
        base_from_flange: (4, 4).
    """
    pose = np.asarray(base_from_flange, dtype=float)
    foot = pose[:3, 3] * (1.0, 1.0, 0.0)
    plumb = np.stack([pose[:3, 3], foot]).astype(np.float32)
    return (Frame("{F}", pose, 70.0), Lines(f"{UNWRITTEN}plumb", (plumb,), Role.ROBOT, 1.5))


def motion_scene() -> Scene:
    """A scene of the robot's base, for a motion that is planned while the step shows another frame."""
    turn = np.linspace(0.0, 2.0 * np.pi, 49)
    ring = BASE_RADIUS_MM * np.stack([np.cos(turn), np.sin(turn), 0.0 * turn], axis=1)
    return Scene(
        title=QCoreApplication.translate("SceneView", "Planned motion of the robot"),
        frame="B",
        items=(
            Frame("{B}", np.eye(4), BASE_RADIUS_MM),
            Lines(f"{UNWRITTEN}foot", (ring.astype(np.float32),), Role.ROBOT, 2.0),
        ),
        view="planned motion",
        legend=((Role.SUGGESTION, QCoreApplication.translate("SceneView", "way of the flange")),),
    )
