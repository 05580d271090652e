"""Scan and model as thinned points with unit normals: what automatic registration compares; mm."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray
from scipy.spatial import KDTree

from core.frames import Array
from core.progress import Progress, silent

# Above this number of points a random share stands for the scan; spacing on a blade is then still below 0.3 mm.
RANDOM_SHARE = 300_000
# Thinned scan: one point (the mean) per cube of this side, more where that leaves too many.
CUBE_MM = 1.0
MOST_POINTS = 20_000
# Larger cubes for a thin scan, until a stray point, alone in its cube, can be told from a surface.
USUAL_COUNT, LARGEST_CUBE_MM = 5, 2.0
NEIGHBOURS = 18
# A cube with less than this share of the points that the cube of a typical point holds is taken for stray.
STRAY_SHARE = 0.35
# ... and so is a point whose neighbours reach this many times farther than those of a typical point.
STRAY_REACH = 1.6
# Normals within this angle belong to one flat direction, and the next direction must be at least twice as far.
MODE_RAD = np.radians(3.0)


@dataclass(frozen=True, eq=False)
class Shape:
    """Points spread evenly over a surface.

    Attributes:
        points: (N, 3) mm.
        normals: (N, 3) unit; signs are arbitrary for a scan.
        flat: (N,) True where the neighbourhood is flat, so that the normal is trusted.
        tree: Of the points.
    """

    points: Array
    normals: Array
    flat: NDArray[np.bool_]
    tree: KDTree


def nearest(tree: KDTree, points: Array, reach_mm: float = np.inf) -> tuple[Array, NDArray[np.int64]]:
    """Distances and places of the nearest points of a tree; infinite beyond `reach_mm`."""
    distance, index = tree.query(points, distance_upper_bound=reach_mm)
    return np.asarray(distance, dtype=float), np.asarray(index, dtype=np.int64)


def scan_shape(points: Array, rng: np.random.Generator, progress: Progress = silent) -> Shape:
    """Thin a scan (N, 3) and estimate its normals from neighbours (smallest eigenvector of their covariance)."""
    if len(points) > RANDOM_SHARE:
        points = points[rng.choice(len(points), RANDOM_SHARE, replace=False)]
    progress(0.0, "thinning the scan")
    cube = CUBE_MM
    thin, usual = _thinned(points, cube)
    while len(thin) > MOST_POINTS or (usual < USUAL_COUNT and cube < LARGEST_CUBE_MM):
        progress(0.3, "thinning the scan")
        cube *= 1.25
        thin, usual = _thinned(points, cube)
    progress(0.6, "directions of the scan's surfaces")
    reach = np.asarray(KDTree(thin).query(thin, k=[min(NEIGHBOURS // 2, len(thin))])[0])[:, 0]
    thin = thin[reach < STRAY_REACH * np.median(reach)]
    tree = KDTree(thin)
    _, index = tree.query(thin, k=min(NEIGHBOURS, len(thin)))
    offset = thin[index] - thin[index].mean(axis=1, keepdims=True)
    values, vectors = np.linalg.eigh(np.einsum("nki,nkj->nij", offset, offset))
    # Roughness against width of the neighbourhood: an edge, a ghost or a stray point is not flat.
    flat = values[:, 0] < 0.01 * values[:, 1]
    return Shape(thin, np.asarray(vectors[:, :, 0]), np.asarray(flat), tree)


def _thinned(points: Array, cube_mm: float) -> tuple[Array, float]:
    """Mean point of every cube that holds about as many points as a surface does (fewer are stray), and that number."""
    cells = np.floor((points - points.min(axis=0)) / cube_mm).astype(np.int64)
    span = cells.max(axis=0) + 1
    key = (cells[:, 0] * span[1] + cells[:, 1]) * span[2] + cells[:, 2]
    _, inverse, counts = np.unique(key, return_inverse=True, return_counts=True)
    sums = np.stack([np.bincount(inverse, weights=points[:, k]) for k in range(3)], axis=1)
    usual = float(np.median(counts[inverse]))
    return np.asarray((sums / counts[:, None])[counts >= STRAY_SHARE * usual]), usual


def mesh_shape(vertices: Array, triangles: NDArray[np.int64], spacing_mm: float, rng: np.random.Generator) -> Shape:
    """Random points on triangles, one per `spacing_mm`^2 of area, with the triangles' normals."""
    corner = vertices[triangles]
    cross = np.cross(corner[:, 1] - corner[:, 0], corner[:, 2] - corner[:, 0])
    twice_area = np.linalg.norm(cross, axis=1)
    count = int(np.ceil(0.5 * twice_area.sum() / spacing_mm**2))
    place = (np.arange(count) + rng.random()) / count * twice_area.sum()
    pick = np.searchsorted(np.cumsum(twice_area), place).clip(max=len(corner) - 1)
    a, b = np.sqrt(rng.random((count, 1))), rng.random((count, 1))
    points = (1 - a) * corner[pick, 0] + a * (1 - b) * corner[pick, 1] + a * b * corner[pick, 2]
    normals = cross[pick] / twice_area[pick, None]
    return Shape(points, normals, np.ones(count, dtype=bool), KDTree(points))


def flat_directions(shape: Shape, most: int, least_share: float) -> tuple[Array, Array]:
    """Directions (K, 3) that many normals share, the most frequent first, and their share (K,) of the flat points.

    Greedy: the normal with most others within 3 degrees is refined to their mean, they and their surroundings are taken
    out, and so on.
    """
    normals = shape.normals[shape.flat]
    normals = normals[:: max(1, len(normals) // 5000)]
    free = np.ones(len(normals), dtype=bool)
    directions: list[Array] = []
    shares: list[float] = []
    seeds = normals[:: max(1, len(normals) // 400)]
    while len(directions) < most and np.any(free):
        counts = np.count_nonzero(np.abs(seeds @ normals[free].T) > np.cos(MODE_RAD), axis=1)
        direction = seeds[int(np.argmax(counts))]
        for _ in range(3):
            near = free & (np.abs(normals @ direction) > np.cos(MODE_RAD))
            if not np.any(near):
                break
            direction = np.linalg.eigh(normals[near].T @ normals[near])[1][:, -1]
        share = float(np.count_nonzero(near)) / len(normals)
        if share < least_share:
            break
        directions.append(direction)
        shares.append(share)
        free &= np.abs(normals @ direction) < np.cos(2.0 * MODE_RAD)
    return np.array(directions).reshape(-1, 3), np.array(shares)
