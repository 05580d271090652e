"""Simulated partial scans of a blade for the automatic rough registration; shares no code with the estimator."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray
from scipy.spatial.transform import Rotation

Array = NDArray[np.float64]
NOISE_MM = 0.035


@dataclass(frozen=True)
class Blade:
    """Fine triangles of a blade in frame W and where its two measuring areas are."""

    vertices: Array
    triangles: NDArray[np.int64]
    areas_mm: tuple[Array, Array]


@dataclass(frozen=True)
class Scan:
    """Points in M, the true pose, and the share of points that is not blade."""

    points: Array
    measure_from_work: Array
    clutter: float


def blade(vertices: Array, triangles: NDArray[np.int64]) -> Blade:
    """Measuring areas: edge plate (z about 0) and shroud (the upper end)."""
    top = vertices[:, 2].max()
    return Blade(vertices, triangles, (np.array([0.0, 0.0, -4.0]), np.array([0.0, 0.0, top - 6.0])))


def two_area_scan(body: Blade, rng: np.random.Generator, count: int, clutter: float) -> Scan:
    """Edge plate and shroud, each through a window across one diagonal line of sight, and what else was in view."""
    sight = np.array([rng.choice([-1.0, 1.0]), rng.choice([-1.0, 1.0]), rng.uniform(0.3, 0.8)])
    sight += rng.normal(0.0, 0.15, 3)
    return _scan(body, rng, count, clutter, sight, rng.uniform(30.0, 45.0))


def whole_view_scan(body: Blade, rng: np.random.Generator, count: int, clutter: float) -> Scan:
    """Everything that one oblique line of sight reaches."""
    azimuth, height = rng.uniform(0.0, 2.0 * np.pi), rng.uniform(0.2, 0.8)
    return _scan(body, rng, count, clutter, np.array([np.cos(azimuth), np.sin(azimuth), height]), None)


def _scan(body: Blade, rng: np.random.Generator, count: int, clutter: float, sight: Array,
          window_mm: float | None) -> Scan:
    sight = sight / np.linalg.norm(sight)
    seen, normals = _visible(body, rng, sight, window_mm)
    keep = rng.integers(0, len(seen), round(count * (1.0 - clutter)))
    points = seen[keep] + rng.normal(0.0, NOISE_MM, (len(keep), 1)) * normals[keep]
    points = np.vstack([points, _clutter(points, rng, count - len(keep), sight)])
    rotation, shift = Rotation.random(random_state=rng).as_matrix(), rng.uniform(-400.0, 400.0, 3)
    pose = np.eye(4)
    pose[:3, :3], pose[:3, 3] = rotation, shift
    return Scan(rng.permutation(points) @ rotation.T + shift, pose, clutter)


def _visible(body: Blade, rng: np.random.Generator, sight: Array, window_mm: float | None) -> tuple[Array, Array]:
    """Uniform samples of the surface that the line of sight reaches, within the windows if any."""
    import open3d as o3d

    corner = body.vertices[body.triangles]
    cross = np.cross(corner[:, 1] - corner[:, 0], corner[:, 2] - corner[:, 0])
    twice_area = np.linalg.norm(cross, axis=1)
    pick = rng.choice(len(corner), 120_000, p=twice_area / twice_area.sum())
    a, b = np.sqrt(rng.random((len(pick), 1))), rng.random((len(pick), 1))
    points = (1 - a) * corner[pick, 0] + a * (1 - b) * corner[pick, 1] + a * b * corner[pick, 2]
    normals = cross[pick] / twice_area[pick, None]
    wanted = normals @ sight > 0.2
    if window_mm is not None:
        inside = np.zeros(len(points), dtype=bool)
        for centre in body.areas_mm:
            offset = points - centre
            across = offset - (offset @ sight)[:, None] * sight
            inside |= np.linalg.norm(across, axis=1) < window_mm
        wanted &= inside
    points, normals = points[wanted], normals[wanted]
    scene = o3d.t.geometry.RaycastingScene(nthreads=1)
    scene.add_triangles(body.vertices.astype(np.float32), body.triangles.astype(np.uint32))
    rays = np.hstack([points + 1e-2 * normals, np.broadcast_to(sight, points.shape)]).astype(np.float32)
    free = ~scene.test_occlusions(o3d.core.Tensor(rays)).numpy()
    return points[free], normals[free]


def _clutter(points: Array, rng: np.random.Generator, count: int, sight: Array) -> Array:
    """Fixture jaws (boxes beside the blade), ghosts along the line of sight, and stray points."""
    ghosts, stray = count // 6, count // 6
    low, high = points.min(axis=0) - 25.0, points.max(axis=0) + 25.0
    ghost = points[rng.integers(0, len(points), ghosts)] - rng.exponential(4.0, (ghosts, 1)) * sight
    parts = [ghost, rng.uniform(low, high, (stray, 3))]
    rest = count - ghosts - stray
    for share in (rest // 2, rest - rest // 2):
        size, middle = rng.uniform(15.0, 45.0, 3), rng.uniform(low, high)
        local = rng.uniform(-0.5, 0.5, (share, 3)) * size
        side = rng.integers(0, 3, share)
        local[np.arange(share), side] = 0.5 * size[side]
        parts.append(local @ Rotation.random(random_state=rng).as_matrix().T + middle)
    return np.vstack(parts)
