"""Analytic surfaces of a CAD model with their own flat coordinates (s, t, d); all in mm, frame W (the CAD frame)."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike, NDArray

Array = NDArray[np.float64]


@dataclass(frozen=True, eq=False)
class Plane:
    """A plane with an outward side.

    Surface coordinates: `p = origin + s x_axis + t y_axis + d normal`.

    Attributes:
        origin: (3,) mm, a point of the plane near the face (the middle of its box).
        normal: (3,) unit, away from the material; `normal = x_axis x y_axis`.
        x_axis: (3,) unit.
        y_axis: (3,) unit.
    """

    origin: Array
    normal: Array
    x_axis: Array
    y_axis: Array

    def to_surface(self, points: ArrayLike) -> tuple[Array, Array, Array]:
        """Coordinates (s, t, d) in mm of points (..., 3); d is positive outside the material."""
        offset = np.asarray(points, dtype=float) - self.origin
        return offset @ self.x_axis, offset @ self.y_axis, offset @ self.normal

    def from_surface(self, s: ArrayLike, t: ArrayLike, d: ArrayLike = 0.0) -> Array:
        """Points (..., 3) in mm of surface coordinates; the inverse of `to_surface`."""
        s, t, d = np.broadcast_arrays(*(np.asarray(value, dtype=float) for value in (s, t, d)))
        return np.asarray(self.origin + s[..., None] * self.x_axis + t[..., None] * self.y_axis
                          + d[..., None] * self.normal)

    def normal_at(self, points: ArrayLike) -> Array:
        """Outward unit normals (..., 3) at the feet of points (..., 3)."""
        return np.array(np.broadcast_to(self.normal, np.shape(points)))


@dataclass(frozen=True, eq=False)
class Cylinder:
    """A circular cylinder with an outward side, unwrapped to a flat strip.

    Surface coordinates: `s = radius * phi`, `t` = height along the axis, `d` = signed distance, where
    `p = origin + (radius + outward d) (cos(phi) x_axis + sin(phi) y_axis) + t axis` and phi lies in (-pi, pi].
    `x_axis` points to the middle of the face, so that a face doesn't straddle the cut at phi = pi.

    Attributes:
        origin: (3,) mm, on the axis, at the height of the middle of the face.
        axis: (3,) unit.
        x_axis: (3,) unit, at right angles to the axis.
        radius_mm: Radius.
        outward: +1 where the material is inside (a shaft), -1 where it is outside (a hole, a concave face).
    """

    origin: Array
    axis: Array
    x_axis: Array
    radius_mm: float
    outward: int

    @property
    def y_axis(self) -> Array:
        """(3,) unit, `axis x x_axis`."""
        return np.asarray(np.cross(self.axis, self.x_axis))

    def to_surface(self, points: ArrayLike) -> tuple[Array, Array, Array]:
        """Coordinates (s, t, d) in mm of points (..., 3); d is positive outside the material."""
        offset = np.asarray(points, dtype=float) - self.origin
        x, y = offset @ self.x_axis, offset @ self.y_axis
        return (self.radius_mm * np.arctan2(y, x), offset @ self.axis,
                self.outward * (np.hypot(x, y) - self.radius_mm))

    def from_surface(self, s: ArrayLike, t: ArrayLike, d: ArrayLike = 0.0) -> Array:
        """Points (..., 3) in mm of surface coordinates; the inverse of `to_surface`."""
        s, t, d = np.broadcast_arrays(*(np.asarray(value, dtype=float) for value in (s, t, d)))
        phi, rho = s / self.radius_mm, self.radius_mm + self.outward * d
        return np.asarray(self.origin + (rho * np.cos(phi))[..., None] * self.x_axis
                          + (rho * np.sin(phi))[..., None] * self.y_axis + t[..., None] * self.axis)

    def normal_at(self, points: ArrayLike) -> Array:
        """Outward unit normals (..., 3) at the feet of points (..., 3); undefined (NaN) on the axis itself."""
        offset = np.asarray(points, dtype=float) - self.origin
        radial = offset - (offset @ self.axis)[..., None] * self.axis
        length = np.linalg.norm(radial, axis=-1, keepdims=True)
        return np.asarray(self.outward * np.divide(radial, length, out=np.full_like(radial, np.nan),
                                                   where=length > 1e-12 * self.radius_mm))


Surface = Plane | Cylinder
