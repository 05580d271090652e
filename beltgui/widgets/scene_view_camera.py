"""A camera in numbers: where it looks from, what a point's place in the picture is, which ray a pixel stands for.

Both the drawing and the picking use it, so that a click means what is seen. Pixels are counted from the top left corner
of a viewport; lengths are mm in the scene's frame.
"""

from __future__ import annotations

from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import NDArray

Array = NDArray[np.float64]

ANGLE_RAD = np.deg2rad(25.0)
MARGIN = 0.84
SMALLEST_MM, LARGEST_MM = 0.05, 1.0e6


def _rows(right: tuple[float, float, float], up: tuple[float, float, float]) -> Array:
    x, y = np.asarray(right, dtype=float), np.asarray(up, dtype=float)
    x = x / np.linalg.norm(x)
    y = y - (y @ x) * x
    y /= np.linalg.norm(y)
    return np.stack([x, y, np.cross(x, y)])


def rotation_from(look_from: tuple[float, float, float], up: tuple[float, float, float]) -> Array:
    """(3, 3) rows to the right, up, and towards the person, who stands in the direction `look_from` (3,).

    Where `up` (3,) points along the view, another direction is taken for it.

    Raises:
        ValueError: `look_from` has no length.
    """
    toward = np.asarray(look_from, dtype=float)
    if not np.linalg.norm(toward) > 0.0:
        raise ValueError("A direction to look from has no length.")
    toward = toward / np.linalg.norm(toward)
    right = np.cross(np.asarray(up, dtype=float), toward)
    if np.linalg.norm(right) < 1e-6 * max(float(np.linalg.norm(up)), 1.0):
        right = np.cross(np.eye(3)[int(np.argmin(np.abs(toward)))], toward)
    right /= np.linalg.norm(right)
    return np.stack([right, np.cross(toward, right), toward])


# Rows: to the right, up, and towards the person, in the scene's frame.
DIRECTIONS = {
    "front": _rows((1.0, 0.0, 0.0), (0.0, 0.0, 1.0)),
    "side": _rows((0.0, 1.0, 0.0), (0.0, 0.0, 1.0)),
    "top": _rows((1.0, 0.0, 0.0), (0.0, 1.0, 0.0)),
    "oblique": _rows((0.8, 0.6, 0.0), (-0.27, 0.36, 0.9)),
}


@dataclass(frozen=True, eq=False)
class Camera:
    """A perspective camera.

    Attributes:
        target: (3,) what it turns about, mm.
        distance: From the target, mm.
        rotation: (3, 3) rows: unit vectors to the right, up, and towards the person, in the scene's frame.
    """

    target: Array
    distance: float
    rotation: Array

    @classmethod
    def looking(cls, direction: str = "oblique") -> Camera:
        """One of `DIRECTIONS`, at the origin."""
        return cls(np.zeros(3), 300.0, DIRECTIONS[direction])

    @property
    def position(self) -> Array:
        """(3,) of the eye, mm."""
        return self.target + self.distance * self.rotation[2]

    def mm_per_pixel(self, height: float) -> float:
        """At the target, in a viewport so many pixels high."""
        return 2.0 * self.distance * np.tan(ANGLE_RAD / 2.0) / max(height, 1.0)

    def project(self, xyz: NDArray[np.floating], width: float, height: float) -> tuple[Array, Array]:
        """Pixels (N, 2) and depths (N,) in mm along the view of points (N, 3); a depth <= 0 is behind the eye."""
        local = (np.asarray(xyz, dtype=float).reshape(-1, 3) - self.position) @ self.rotation.T
        depth = -local[:, 2]
        scale = height / (2.0 * np.tan(ANGLE_RAD / 2.0)) / np.where(np.abs(depth) < 1e-9, 1e-9, depth)
        return np.stack([width / 2.0 + local[:, 0] * scale, height / 2.0 - local[:, 1] * scale], axis=1), depth

    def ray(self, x: float, y: float, width: float, height: float) -> tuple[Array, Array]:
        """Eye (3,) and unit direction (3,) of what lies behind a pixel."""
        tangent = np.tan(ANGLE_RAD / 2.0)
        local = np.array([(2.0 * x - width) / height * tangent, (height - 2.0 * y) / height * tangent, -1.0])
        direction = local @ self.rotation
        return self.position, direction / np.linalg.norm(direction)

    def turned(self, right_rad: float, up_rad: float) -> Camera:
        """The scene turned about the target: to the right about the picture's upright, up about its level axis."""
        cos, sin = np.cos(right_rad), np.sin(right_rad)
        about_up = np.array([[cos, 0.0, sin], [0.0, 1.0, 0.0], [-sin, 0.0, cos]])
        cos, sin = np.cos(up_rad), np.sin(up_rad)
        about_right = np.array([[1.0, 0.0, 0.0], [0.0, cos, sin], [0.0, -sin, cos]])
        u, _, vt = np.linalg.svd(about_right @ about_up @ self.rotation)
        return replace(self, rotation=u @ vt)

    def moved(self, right_px: float, down_px: float, height: float) -> Camera:
        """The scene carried along by so many pixels."""
        step = self.mm_per_pixel(height)
        return replace(self, target=self.target - step * (right_px * self.rotation[0] - down_px * self.rotation[1]))

    def zoomed(self, factor: float, x: float, y: float, width: float, height: float) -> Camera:
        """`factor` > 1 is nearer; what lies at the pixel in the target's plane stays there."""
        distance = float(np.clip(self.distance / factor, SMALLEST_MM, LARGEST_MM))
        gain = 1.0 - distance / self.distance
        step = self.mm_per_pixel(height) * gain
        shift = step * ((x - width / 2.0) * self.rotation[0] - (y - height / 2.0) * self.rotation[1])
        return replace(self, target=self.target + shift, distance=distance)

    def fitted(self, xyz: NDArray[np.floating], aspect: float) -> Camera:
        """The same direction, moved so that all points (N, 3) are in a picture of this width / height."""
        if not len(xyz):
            return self
        local = np.asarray(xyz, dtype=float) @ self.rotation.T
        middle = (local.min(axis=0) + local.max(axis=0)) / 2.0
        across = np.abs(local - middle)
        tangent = np.tan(ANGLE_RAD / 2.0) * MARGIN
        toward = local[:, 2] - middle[2]
        needed = np.maximum(across[:, 0] / (tangent * max(aspect, 0.05)), across[:, 1] / tangent) + toward
        return replace(
            self, target=middle @ self.rotation, distance=float(np.clip(needed.max(), SMALLEST_MM * 20.0, LARGEST_MM))
        )
