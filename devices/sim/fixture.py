"""What else is on the flange and may hide the part: adapter, gripper, the ball's stem; frame {F}, mm."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from devices.sim.geometry import Array, unit
from devices.sim.rays import CylinderSurface, PlaneSurface, Solid, Surface

ADAPTER_RADIUS_MM, ADAPTER_HEIGHT_MM = 45.0, 25.0
STEM_RADIUS_MM = 4.0
GRIPPER_HALF_MM = (36.0, 27.0)
GRIPPER_DEPTH_MM = 30.0  # how much of the root, below the foot of the airfoil, stays outside the gripper
_SIDES = 96

_Part = tuple[Array, NDArray[np.intp], NDArray[np.intp], list[Surface | None]]


def ball_fixture(ball_in_flange: Array) -> Solid:
    """Adapter with a stem to the ball."""
    return _joined([_adapter(), _cylinder(np.array([0.0, 0.0, ADAPTER_HEIGHT_MM]), ball_in_flange, STEM_RADIUS_MM)])


def blade_fixture(flange_from_work: Array) -> Solid:
    """Adapter with a gripper that reaches up to the clamped root."""
    top = float(flange_from_work[2, 3]) - GRIPPER_DEPTH_MM
    parts = [_adapter()]
    if top > ADAPTER_HEIGHT_MM:
        x, y = GRIPPER_HALF_MM
        middle = flange_from_work[:3, 3]
        low = np.array([middle[0] - x, middle[1] - y, ADAPTER_HEIGHT_MM])
        parts.append(_box(low, np.array([middle[0] + x, middle[1] + y, top])))
    return _joined(parts)


def bare_fixture() -> Solid:
    """The adapter alone."""
    return _joined([_adapter()])


def _adapter() -> _Part:
    return _cylinder(np.zeros(3), np.array([0.0, 0.0, ADAPTER_HEIGHT_MM]), ADAPTER_RADIUS_MM)


def _box(low: Array, high: Array) -> _Part:
    corners = np.array([[i, j, k] for i in (0, 1) for j in (0, 1) for k in (0, 1)], dtype=float)
    quads = [(0, 1, 3, 2), (4, 6, 7, 5), (0, 4, 5, 1), (2, 3, 7, 6), (0, 2, 6, 4), (1, 5, 7, 3)]
    triangles = [row for a, b, c, d in quads for row in ((a, b, c), (a, c, d))]
    surfaces: list[Surface | None] = []
    for axis in range(3):
        for sign, value in ((-1.0, low[axis]), (1.0, high[axis])):
            normal = np.zeros(3)
            normal[axis] = sign
            surfaces.append(PlaneSurface(normal, float(sign * value)))
    return low + corners * (high - low), np.array(triangles, dtype=np.intp), np.repeat(np.arange(6), 2), surfaces


def _cylinder(start: Array, end: Array, radius_mm: float) -> _Part:
    axis = unit(end - start)
    across = unit(np.cross(axis, [1.0, 0.0, 0.0] if abs(axis[0]) < 0.9 else [0.0, 1.0, 0.0]))
    phi = np.linspace(0.0, 2.0 * np.pi, _SIDES, endpoint=False)
    # circumscribed, so that the mesh never hides the exact surface
    outer = radius_mm / np.cos(np.pi / _SIDES)
    ring = outer * (np.outer(np.cos(phi), across) + np.outer(np.sin(phi), np.cross(axis, across)))
    points = np.concatenate([start + ring, end + ring, [start, end]])
    a = np.arange(_SIDES)
    b = (a + 1) % _SIDES
    side = np.concatenate([np.stack([a, b, b + _SIDES], 1), np.stack([a, b + _SIDES, a + _SIDES], 1)])
    bottom = np.stack([b, a, np.full(_SIDES, 2 * _SIDES)], 1)
    top = np.stack([a + _SIDES, b + _SIDES, np.full(_SIDES, 2 * _SIDES + 1)], 1)
    face = np.repeat([0, 1, 2], [2 * _SIDES, _SIDES, _SIDES])
    surfaces: list[Surface | None] = [
        CylinderSurface(start, axis, radius_mm, 1),
        PlaneSurface(-axis, float(-axis @ start)),
        PlaneSurface(axis, float(axis @ end)),
    ]
    return points, np.concatenate([side, bottom, top]), face, surfaces


def _joined(parts: list[_Part]) -> Solid:
    vertices, triangles, face, surfaces = [], [], [], list[Surface | None]()
    used = 0
    for points, corners, faces, part_surfaces in parts:
        vertices.append(points)
        triangles.append(corners + used)
        face.append(faces + len(surfaces))
        surfaces.extend(part_surfaces)
        used += len(points)
    return Solid(
        np.concatenate(vertices), np.concatenate(triangles), np.concatenate(face), tuple(surfaces),
        ("",) * len(surfaces),
    )  # fmt: skip
