"""Planes and cylinders that a CAD system stored as free-form or swept surfaces; some exporters do so throughout."""

from __future__ import annotations

from typing import Any

import numpy as np

from core.cad.surfaces import Array, Cylinder, Plane, Surface

# A face is what it looks like when every sample lies this near.
RECOGNISED_MM = 0.001
RECOGNISED_RAD = 1e-4
SAMPLES = 9
# A rounder cylinder would be a plane in disguise.
LARGEST_RADIUS_MM = 1e5


def recognise(adaptor: Any, outward: int) -> Surface | None:
    """The plane or cylinder that a face's surface coincides with, None where it is neither.

    Args:
        adaptor: Kernel surface adaptor, limited to the face's box in its parameters.
        outward: +1 where du x dv points away from the material, else -1.
    """
    points, normals = _samples(adaptor, outward)
    if len(points) < SAMPLES:
        return None
    return _as_plane(points, normals) or _as_cylinder(points, normals)


def _samples(adaptor: Any, outward: int) -> tuple[Array, Array]:
    """Points and outward unit normals (N, 3) on a grid; singular ones are left out."""
    from OCP.gp import gp_Pnt, gp_Vec

    rows = []
    for u in np.linspace(adaptor.FirstUParameter(), adaptor.LastUParameter(), SAMPLES):
        for v in np.linspace(adaptor.FirstVParameter(), adaptor.LastVParameter(), SAMPLES):
            point, du, dv = gp_Pnt(), gp_Vec(), gp_Vec()
            adaptor.D1(float(u), float(v), point, du, dv)
            rows.append([(item.X(), item.Y(), item.Z()) for item in (point, du, dv)])
    points, du, dv = np.array(rows).swapaxes(0, 1)
    cross = outward * np.cross(du, dv)
    length = np.linalg.norm(cross, axis=1)
    good = np.isfinite(length) & (length > 1e-9 * np.nanmax(length, initial=0.0)) & (length > 0.0)
    return points[good], cross[good] / length[good, None]


def _as_plane(points: Array, normals: Array) -> Plane | None:
    mean = normals.mean(axis=0)
    if np.linalg.norm(normals - mean, axis=1).max() > RECOGNISED_RAD:
        return None
    origin, normal = points.mean(axis=0), mean / np.linalg.norm(mean)
    if np.abs((points - origin) @ normal).max() > RECOGNISED_MM:
        return None
    x_axis = _across(normal)
    return Plane(origin, normal, x_axis, np.cross(normal, x_axis))


def _as_cylinder(points: Array, normals: Array) -> Cylinder | None:
    """The axis is at right angles to all normals; then `p = centre + r n` is linear in centre and signed radius."""
    axis = np.linalg.svd(normals)[2][2]
    if np.abs(normals @ axis).max() > RECOGNISED_RAD:
        return None
    x_axis = _across(axis)
    y_axis = np.cross(axis, x_axis)
    flat = np.column_stack([points @ x_axis, points @ y_axis])
    turned = np.column_stack([normals @ x_axis, normals @ y_axis])
    one, zero = np.ones(len(flat)), np.zeros(len(flat))
    rows = np.vstack([np.column_stack([one, zero, turned[:, 0]]), np.column_stack([zero, one, turned[:, 1]])])
    (x, y, radius), _, rank, _ = np.linalg.lstsq(rows, flat.T.ravel(), rcond=1e-9)
    if rank < 3 or not 0.0 < abs(radius) < LARGEST_RADIUS_MM:
        return None
    cylinder = Cylinder(x * x_axis + y * y_axis, axis, x_axis, float(abs(radius)), 1 if radius > 0.0 else -1)
    return cylinder if np.abs(cylinder.to_surface(points)[2]).max() < RECOGNISED_MM else None


def _across(direction: Array) -> Array:
    """A unit vector at right angles to a unit vector."""
    helper = np.eye(3)[np.argmin(np.abs(direction))]
    across = np.cross(helper, direction)
    return np.asarray(across / np.linalg.norm(across))
