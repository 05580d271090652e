"""Contact frames on the airfoil and on the wheel.

The contact frame C, the same drawing on blade and wheel::

        z  outward normal of the airfoil, from the blade into the wheel
        |
        |      y  along the shaft of the wheel, along the blade's span
        |    /
        |  /
        +--------- x = y cross z, along the belt's run, around the profile

On the blade its origin is the surface point. On the wheel it is the point of the wheel's circumference (belt included)
where the blade touches at head angle 0. The head moves the wheel's centre along y of {H} for a positive angle, so the
normal of a contact that the head can feel is parallel to that axis: `contact_side` +1 puts the outward normal on +y_H
(a proud blade turns the head in the positive sense), -1 on -y_H. `span_along_shaft` +1 lays the blade's span along
+z_H, -1 along -z_H; it decides at which end of the shaft the blade's root is.
"""

from __future__ import annotations

from typing import Protocol

import numpy as np
from numpy.typing import ArrayLike, NDArray

from core.errors import InputError
from core.frames import inverse, rigid
from core.verdict import Code

Array = NDArray[np.float64]


class AirfoilSurface(Protocol):
    """What the path needs of an airfoil: points and tangents in mm in the work frame, and the outward normal."""

    def derivatives(self, u: Array, v: Array, /) -> tuple[Array, Array, Array]:
        """Points (N, 3), derivatives by u (N, 3) and by v (N, 3)."""
        ...

    def normal(self, u: Array, v: Array, /) -> Array:
        """Outward unit normals (N, 3)."""
        ...


def contact_frames(position: Array, normal: Array, along_u: Array, along_v: Array) -> Array:
    """Frames (N, 4, 4) with z along the normal, y in the surface, at right angles to the u-line, towards rising v.

    Args:
        position: (N, 3) mm.
        normal: (N, 3) outward unit normals.
        along_u: (N, 3) tangents of the u-lines, any length.
        along_v: (N, 3) tangents of the v-lines, any length.

    Raises:
        InputError: the surface is degenerate at a point (no tangent plane).
    """
    x = along_u - np.sum(along_u * normal, axis=1, keepdims=True) * normal
    length = np.linalg.norm(x, axis=1)
    size = np.linalg.norm(along_u, axis=1)
    if not np.all(np.isfinite(normal)) or np.any(length <= 1e-6 * np.maximum(size, 1e-12)) or np.any(size <= 1e-9):
        raise InputError("The airfoil has no tangent plane at a point of the path.", Code.ILL_CONDITIONED)
    y = np.cross(normal, x / length[:, None])
    y *= np.where(np.sum(y * along_v, axis=1) < 0.0, -1.0, 1.0)[:, None]
    frames = np.tile(np.eye(4), (len(position), 1, 1))
    frames[:, :3, 0], frames[:, :3, 1], frames[:, :3, 2] = np.cross(y, normal), y, normal
    frames[:, :3, 3] = position
    return frames


def work_from_contact(airfoil: AirfoilSurface, u: ArrayLike, v: ArrayLike) -> Array:
    """Contact frames (N, 4, 4) of the nominal airfoil at (u, v) (N,)."""
    cu, cv = np.atleast_1d(np.asarray(u, dtype=float)), np.atleast_1d(np.asarray(v, dtype=float))
    position, along_u, along_v = airfoil.derivatives(cu, cv)
    return contact_frames(position, airfoil.normal(cu, cv), along_u, along_v)


def tool_from_contact(wheel_radius_mm: float, contact_side: int, span_along_shaft: int = 1) -> Array:
    """The contact frame on the wheel in {H}, at head angle 0.

    Args:
        wheel_radius_mm: Radius of the wheel at its middle, belt included.
        contact_side: +1 or -1, outward normal of the airfoil along +y_H or -y_H.
        span_along_shaft: +1 or -1, span of the blade along +z_H or -z_H.

    Raises:
        InputError: a sign is not +1 or -1, or the radius is not that of a wheel in mm.
    """
    for name, sign in (("contact_side", contact_side), ("span_along_shaft", span_along_shaft)):
        if sign not in (1, -1):
            raise InputError(f"{name}: expected 1 or -1, found {sign}.")
    if not np.isfinite(wheel_radius_mm) or not 2.0 <= wheel_radius_mm <= 1000.0:
        raise InputError(f"wheel_radius_mm: expected the wheel's radius in mm (2 to 1000), found {wheel_radius_mm:g}.")
    z = np.array([0.0, float(contact_side), 0.0])
    y = np.array([0.0, 0.0, float(span_along_shaft)])
    return rigid(np.column_stack([np.cross(y, z), y, z]), -wheel_radius_mm * z)


def presenting_poses(
    base_from_tool: Array, tool_from_contact: Array, work_from_contact: Array, flange_from_work: Array
) -> Array:
    """Flange poses (N, 4, 4) in B that bring contact frames (N, 4, 4) of the blade onto the one of the wheel."""
    return np.asarray(base_from_tool @ tool_from_contact @ inverse(work_from_contact) @ inverse(flange_from_work))
