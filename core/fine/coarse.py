"""From a start several mm and degrees off to within some hundredths of a mm: the thinned scan against the whole model.

Plain boxes would pick wrong points here: at 2.5 degrees the end of a 300 mm blade is 6 mm away from where it seems to
be.
Point-to-plane alignment with normals in the search and a Geman-McClure kernel that narrows (graduated non-convexity:
Black & Rangarajan, 1996; Zhou, Park & Koltun, Fast Global Registration, 2016), on all faces, the airfoil included.
"""

from __future__ import annotations

from collections.abc import Collection
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray
from scipy.spatial import cKDTree

from core.cad import Mesh
from core.frames import inverse, perturbed, rotate, transform_points

Array = NDArray[np.float64]

MODEL_SAMPLES = 40_000
# A normal that is 90 degrees off counts like a distance of 1.4 times this.
NORMAL_LENGTH_MM = 8.0
SUPPORT_POINTS = 60_000
SUPPORT_SPACING_MM = 0.5
NEIGHBOURS = 14
_CANDIDATES = 4
_KERNEL_START_MM, _KERNEL_END_MM, _KERNEL_SHRINK = 4.0, 0.12, 0.68
# Weight of faces that were not chosen, at the end: they hold what the chosen ones leave free, and bend nothing.
_OTHER_FACES_END = 0.02
_RIDGE = 1e-6
_ON_MM = 0.2
_SURFACE = 0.3
# Points this far beyond a face's edge, in line with it, say that it isn't that face; each takes away this many.
_OVERHANG_MM, _OVERHANG_COUNTS, _OVERHANG_LEAST = 8.0, 5.0, 6.0


@dataclass(frozen=True, eq=False)
class ModelSamples:
    """Points spread evenly over the model, with a search tree over position and normal.

    Attributes:
        points: (S, 3) mm in W.
        normals: (S, 3) outward unit normals.
        face_ids: (S,) id of the CadFace.
        chosen: (S,) True on the faces to be registered on.
        spacing_mm: Typical distance of neighbours.
        tree: Over (point, NORMAL_LENGTH_MM normal).
    """

    points: Array
    normals: Array
    face_ids: NDArray[np.int64]
    chosen: NDArray[np.bool_]
    spacing_mm: float
    tree: cKDTree


@dataclass(frozen=True, eq=False)
class ThinScan:
    """Thinned scan with the directions of its normals, side unknown.

    Attributes:
        points: (n, 3) mm in M.
        normals: (n, 3) unit, either sign.
        flatness: (n,) 0 to 1; 0 where the neighbourhood is no surface.
    """

    points: Array
    normals: Array
    flatness: Array

    def part(self, index: NDArray[np.int64]) -> ThinScan:
        """Some of the points."""
        return ThinScan(self.points[index], self.normals[index], self.flatness[index])


def sample_model(mesh: Mesh, chosen_ids: Collection[int], seed: int) -> ModelSamples:
    """Spread points over a model's triangles in proportion to their area, at least one on each."""
    rng = np.random.default_rng(seed)
    corners = mesh.vertices[mesh.triangles]
    cross = np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
    double = np.linalg.norm(cross, axis=1)
    real = double > 1e-12
    corners, cross, double, ids = corners[real], cross[real], double[real], mesh.face_ids[real]
    share = double / double.sum()
    count = 1 + np.floor(share * MODEL_SAMPLES + rng.random(len(share))).astype(int)
    triangle = np.repeat(np.arange(len(share)), count)
    a, b = rng.random(len(triangle)), rng.random(len(triangle))
    flip = a + b > 1.0
    a[flip], b[flip] = 1.0 - a[flip], 1.0 - b[flip]
    base = corners[triangle]
    points = base[:, 0] + a[:, None] * (base[:, 1] - base[:, 0]) + b[:, None] * (base[:, 2] - base[:, 0])
    normals = (cross / double[:, None])[triangle]
    spacing = float(np.sqrt(double.sum() / 2.0 / len(points)))
    return ModelSamples(points, normals, ids[triangle], np.isin(ids[triangle], list(chosen_ids)), spacing,
                        cKDTree(np.hstack([points, NORMAL_LENGTH_MM * normals])))


def thin_scan(points: Array, samples: ModelSamples, start: Array, count: int, capture_mm: float,
              seed: int) -> ThinScan:
    """Evenly thinned points near the model with their normals.

    Args:
        points: (N, 3) mm in M.
        samples: Of the model.
        start: measure_from_work.
        count: About how many points to keep.
        capture_mm: Points farther than this from the model, seen from the start, are left out.
        seed: Of the random choice.
    """
    rng = np.random.default_rng(seed)
    some = points if len(points) <= 4 * SUPPORT_POINTS else points[rng.choice(len(points), 4 * SUPPORT_POINTS, False)]
    in_work = transform_points(inverse(start), some)
    box = np.array([samples.points.min(axis=0) - capture_mm, samples.points.max(axis=0) + capture_mm])
    some = some[np.all((in_work > box[0]) & (in_work < box[1]), axis=1)]
    support = some[_one_per_voxel(some, SUPPORT_SPACING_MM, SUPPORT_POINTS, rng)]
    kept = support[_one_per_voxel(support, SUPPORT_SPACING_MM, _CANDIDATES * count, rng)]
    position_tree = cKDTree(samples.points)
    near = position_tree.query(transform_points(inverse(start), kept), distance_upper_bound=capture_mm)[0] < capture_mm
    kept = kept[near]
    if len(support) < NEIGHBOURS or len(kept) == 0:
        return ThinScan(kept[:0], kept[:0], np.zeros(0))
    _, neighbours = cKDTree(support).query(kept, k=NEIGHBOURS)
    spread = support[neighbours] - support[neighbours].mean(axis=1, keepdims=True)
    values, vectors = np.linalg.eigh(np.einsum("nki,nkj->nij", spread, spread))
    flatness = np.clip(1.0 - 8.0 * values[:, 0] / np.maximum(values[:, 1], 1e-12), 0.0, 1.0)
    # Ghosts fill many voxels with few points: what is evenly thinned must be surface.
    surface = np.flatnonzero(flatness > _SURFACE)
    surface = surface[_one_per_voxel(kept[surface], 2.0 * SUPPORT_SPACING_MM, count, rng)]
    return ThinScan(kept[surface], vectors[surface, :, 0], flatness[surface])


def _one_per_voxel(points: Array, least_mm: float, count: int, rng: np.random.Generator) -> NDArray[np.int64]:
    """Places of one point per voxel, the voxel grown from `least_mm` until about `count` points are left."""
    if len(points) == 0:
        return np.zeros(0, dtype=np.int64)
    size = least_mm
    while True:
        cell = np.floor((points - points.min(axis=0)) / size).astype(np.int64)
        extent = cell.max(axis=0) + 1
        _, first = np.unique((cell[:, 0] * extent[1] + cell[:, 1]) * extent[2] + cell[:, 2], return_index=True)
        if len(first) <= 1.5 * count:
            return first if len(first) <= count else np.sort(rng.choice(first, count, replace=False))
        size *= max(1.1, float(np.sqrt(len(first) / (1.3 * count))))


@dataclass(frozen=True, eq=False)
class Support:
    """Thinned points in line with each face of the model.

    Attributes:
        on: (F + 1,) weighted number of points on face `id`, at place `id`.
        over: (F + 1,) the same for points that continue the face beyond its edge, where the model has none.
        chosen: (F + 1,) True for the faces to be registered on.
        face_of_point: (n,) id of the face with which each thinned point is in line, 0 for none.
    """

    on: Array
    over: Array
    chosen: NDArray[np.bool_]
    face_of_point: NDArray[np.int64]

    @property
    def score(self) -> float:
        """Points on the model, those on the chosen faces counting full, those on overhung faces less or nothing."""
        return float(np.where(self.chosen, 1.0, 0.5) @ np.maximum(self.on - _OVERHANG_COUNTS * self.over, 0.0))

    @property
    def overhung(self) -> frozenset[int]:
        """Ids of faces whose surface goes on beyond their edges: a table or a clamp of the fixture, no face."""
        overhung = (self.over > _OVERHANG_LEAST) & (_OVERHANG_COUNTS * self.over > self.on)
        return frozenset(np.flatnonzero(overhung).tolist())


def support(samples: ModelSamples, scan: ThinScan, pose: Array) -> Support:
    """How much of the thinned scan stands behind each face at a pose."""
    nearest, found = _match(samples, scan, pose, _OVERHANG_MM)
    at = np.flatnonzero(found)
    hit = nearest[at]
    normals = rotate(pose, samples.normals[hit])
    offset = scan.points[at] - transform_points(pose, samples.points[hit])
    d = np.einsum("ij,ij->i", offset, normals)
    beside = np.sqrt(np.maximum(np.einsum("ij,ij->i", offset, offset) - d**2, 0.0))
    flush = (np.abs(d) < _ON_MM) & (np.abs(np.einsum("ij,ij->i", normals, scan.normals[at])) > 0.85)
    inside = beside < 2.5 * samples.spacing_mm
    weights, ids, length = scan.flatness[at], samples.face_ids[hit], int(samples.face_ids.max()) + 1
    chosen = np.zeros(length, dtype=bool)
    chosen[samples.face_ids[samples.chosen]] = True
    on, beyond = flush & inside, flush & (beside > 3.5 * samples.spacing_mm) & samples.chosen[hit]

    def summed(mask: NDArray[np.bool_]) -> Array:
        return np.bincount(ids[mask], weights[mask], length).astype(float)

    face_of_point = np.zeros(len(scan.points), dtype=np.int64)
    face_of_point[at[flush]] = ids[flush]
    return Support(summed(on), summed(beyond), chosen, face_of_point)


def surface_share(samples: ModelSamples, scan: ThinScan, pose: Array, reach_mm: float) -> float:
    """Share of the thinned surface points near the chosen faces that lie on them; 0 without any.

    Ghosts and stray points have no flat neighbourhood and don't count; surfaces of another blade, or of this one in
    another place, do.
    """
    nearest, found = _match(samples, scan, pose, reach_mm)
    at = np.flatnonzero(found & (scan.flatness > _SURFACE))
    at = at[samples.chosen[nearest[at]]]
    if len(at) == 0:
        return 0.0
    offset = scan.points[at] - transform_points(pose, samples.points[nearest[at]])
    d = np.einsum("ij,ij->i", offset, rotate(pose, samples.normals[nearest[at]]))
    return float(np.mean(np.abs(d) < _ON_MM))


def align(samples: ModelSamples, scan: ThinScan, start: Array, reach_mm: float, *,
          kernel_mm: float = _KERNEL_START_MM) -> Array:
    """Graduated point-to-plane alignment of a thinned scan.

    Args:
        samples: Of the model.
        scan: Thinned scan.
        start: measure_from_work.
        reach_mm: Search distance at the start.
        kernel_mm: Width of the kernel at the start; below the default for a start that is nearly right.

    Returns:
        measure_from_work.
    """
    pose, kernel = start, kernel_mm
    centre = scan.points.mean(axis=0)
    lever = max(float(np.sqrt(((scan.points - centre) ** 2).sum(axis=1).mean())), 1.0)
    while kernel > _KERNEL_END_MM:
        progress = np.log(kernel / _KERNEL_START_MM) / np.log(_KERNEL_END_MM / _KERNEL_START_MM)
        others = _OTHER_FACES_END**progress
        reach = max(reach_mm * (1.0 - 1.3 * progress), 3.0 * samples.spacing_mm)
        for _ in range(2):
            pose = _step(samples, scan, pose, kernel, float(reach), float(others), centre, lever)
        kernel *= _KERNEL_SHRINK
    return pose


def _step(samples: ModelSamples, scan: ThinScan, pose: Array, kernel: float, reach: float, others: float,
          centre: Array, lever: float) -> Array:
    """One matching and one weighted Gauss-Newton step."""
    nearest, found = _match(samples, scan, pose, reach)
    at = np.flatnonzero(found)
    hit = nearest[at]
    normals = rotate(pose, samples.normals[hit])
    offset = scan.points[at] - transform_points(pose, samples.points[hit])
    d = np.einsum("ij,ij->i", offset, normals)
    agreement = np.abs(np.einsum("ij,ij->i", normals, scan.normals[at]))
    weights = scan.flatness[at] * np.clip((agreement - 0.7) / 0.2, 0.0, 1.0)
    weights *= (kernel**2 / (kernel**2 + d**2)) ** 2
    # A plane of the fixture in line with a face ends where the face ends.
    beside = np.maximum(np.einsum("ij,ij->i", offset, offset) - d**2, 0.0)
    sideways = (2.0 * kernel) ** 2 + (2.0 * samples.spacing_mm) ** 2
    weights *= (sideways / (sideways + beside)) ** 2
    weights[~samples.chosen[hit]] *= others
    rows = np.hstack([np.cross(scan.points[at] - centre, normals) / lever, normals])
    matrix = rows.T @ (rows * weights[:, None])
    matrix += np.eye(6) * (_RIDGE * np.trace(matrix) + 1e-12)
    step = np.linalg.solve(matrix, rows.T @ (weights * d))
    step[:3] /= lever
    return perturbed(pose, step, centre)


def _match(samples: ModelSamples, scan: ThinScan, pose: Array,
           reach: float) -> tuple[NDArray[np.int64], NDArray[np.bool_]]:
    """Nearest model sample in position and normal for each scan point, and whether one is within reach."""
    work_from_measure = inverse(pose)
    points = transform_points(work_from_measure, scan.points)
    normals = NORMAL_LENGTH_MM * rotate(work_from_measure, scan.normals)
    one, at_one = samples.tree.query(np.hstack([points, normals]), distance_upper_bound=reach)
    other, at_other = samples.tree.query(np.hstack([points, -normals]), distance_upper_bound=reach)
    nearest = np.where(one <= other, at_one, at_other).astype(np.int64)
    return nearest, np.minimum(one, other) < reach
