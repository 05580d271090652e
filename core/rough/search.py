"""Candidate poses without a start: rotations from pairs of flat directions, translations by correlation; mm, rad."""

from __future__ import annotations

from itertools import permutations

import numpy as np
from scipy import fft
from scipy.spatial import KDTree

from core.frames import Array, nearest_rotation, rigid
from core.rough.shape import Shape, nearest

# Two flat directions of the scan may differ by this much from the angle between two of the model.
ANGLE_TOLERANCE_RAD = np.radians(4.0)
# Directions closer than this to each other (or opposite) don't fix a rotation.
LEAST_ANGLE_RAD = np.radians(14.0)
# Rotations closer than this are one.
SAME_ROTATION_RAD = np.radians(4.0)
# Rotations that go on to the translation search.
MOST_ROTATIONS = 100
# Side of a cell of the translation search.
CELL_MM = 4.0
PEAKS_PER_ROTATION = 3


def rotations_from_directions(scan: Shape, scan_directions: Array, model: Shape, model_directions: Array) -> Array:
    """Rotations (K, 3, 3) work_from_measure that lay two flat directions of the scan on two of the model.

    The best ones by how well all flat normals of the scan then meet the model's flat directions.

    Args:
        scan: For its normals.
        scan_directions: (A, 3) unit, unsigned.
        model: For its normals.
        model_directions: (B, 3) unit, unsigned.
    """
    scan_pairs = _frames(scan_directions, signed=False)
    model_pairs = _frames(model_directions, signed=True)
    angle = np.abs(scan_pairs[1][:, None] - model_pairs[1][None, :])
    i, j = np.nonzero(angle < ANGLE_TOLERANCE_RAD)
    rotations = model_pairs[0][j] @ np.swapaxes(scan_pairs[0][i], 1, 2)
    if not len(rotations):
        return rotations
    votes = _normal_votes(rotations, scan, model)
    return _distinct(rotations, votes)


def _frames(directions: Array, *, signed: bool) -> tuple[Array, Array]:
    """Right-handed frames (K, 3, 3) by columns of every ordered pair of directions, and the pairs' angles (K,).

    The frame is the bisector, the difference and the normal of the pair, so that an error is shared by both.
    """
    frames, angles = [], []
    for a, b in permutations(range(len(directions)), 2):
        for sign_a, sign_b in ((1, 1), (1, -1), (-1, 1), (-1, -1)) if signed else ((1, 1),):
            first, second = sign_a * directions[a], sign_b * directions[b]
            angle = np.arccos(np.clip(first @ second, -1.0, 1.0))
            if not LEAST_ANGLE_RAD < angle < np.pi - LEAST_ANGLE_RAD or (not signed and a > b):
                continue
            bisector, difference = first + second, first - second
            bisector, difference = bisector / np.linalg.norm(bisector), difference / np.linalg.norm(difference)
            frames.append(np.stack([bisector, difference, np.cross(bisector, difference)], axis=1))
            angles.append(angle)
    return np.array(frames).reshape(-1, 3, 3), np.array(angles)


def _normal_votes(rotations: Array, scan: Shape, model: Shape) -> Array:
    """How much of the scan has a normal that much of the model has too, for each rotation (K,)."""
    normals = scan.normals[scan.flat]
    normals = normals[:: max(1, len(normals) // 200)]
    axes = _sphere(900)
    axes_tree = KDTree(np.vstack([axes, -axes]))
    _, cell = nearest(axes_tree, model.normals)
    share = np.bincount(cell % len(axes), minlength=len(axes)) / len(model.normals)
    # A narrow smoothing, so that a peak between two cells is not lost.
    weight = np.exp(-0.5 * (np.arccos(np.abs(axes @ axes.T).clip(max=1.0)) / np.radians(2.5)) ** 2)
    density = np.minimum(weight @ share, 0.05)
    votes = np.zeros(len(rotations))
    for start in range(0, len(rotations), 500):
        turned = np.einsum("kij,nj->kni", rotations[start:start + 500], normals)
        _, cell = nearest(axes_tree, turned.reshape(-1, 3))
        votes[start:start + 500] = density[cell % len(axes)].reshape(turned.shape[:2]).mean(axis=1)
    return votes


def _sphere(count: int) -> Array:
    """Evenly spread axes (count, 3) on the upper half sphere (golden spiral)."""
    k = np.arange(count) + 0.5
    height, turn = k / count, np.pi * (1.0 + np.sqrt(5.0)) * k
    radius = np.sqrt(1.0 - height**2)
    return np.stack([radius * np.cos(turn), radius * np.sin(turn), height], axis=1)


def _distinct(rotations: Array, votes: Array) -> Array:
    """The rotations with most votes, without near copies."""
    order = np.argsort(-votes)
    chosen: list[Array] = []
    limit = 1.0 + 2.0 * np.cos(SAME_ROTATION_RAD)
    for index in order:
        candidate = rotations[index]
        if chosen and np.einsum("kij,ij->k", np.array(chosen), candidate).max() > limit:
            continue
        chosen.append(candidate)
        if len(chosen) == MOST_ROTATIONS:
            break
    return np.array([nearest_rotation(rotation) for rotation in chosen])


class TranslationSearch:
    """All translations at once: correlation of the scan's cells with a field that is high near the model's surface.

    The grid is twice the model's box, so that a scan that reaches past the model doesn't wrap onto it.
    """

    def __init__(self, model: Shape) -> None:
        low, high = model.points.min(axis=0), model.points.max(axis=0)
        cells = np.ceil((high - low) / CELL_MM).astype(int) + 4
        self._size = tuple(fft.next_fast_len(int(2 * n), real=True) for n in cells)
        self._low = low - 2.0 * CELL_MM
        grid = np.stack(np.meshgrid(*[np.arange(n) for n in cells], indexing="ij"), axis=-1).reshape(-1, 3)
        distance, _ = nearest(model.tree, self._low + (grid + 0.5) * CELL_MM, 2.0 * CELL_MM)
        field = np.zeros(self._size, dtype=np.float32)
        field[grid[:, 0], grid[:, 1], grid[:, 2]] = np.exp(-0.5 * (distance / (0.6 * CELL_MM)) ** 2)
        self._spectrum = fft.rfftn(field)

    def poses(self, rotation: Array, scan_points: Array) -> tuple[Array, Array]:
        """Best translations for one rotation work_from_measure.

        Returns:
            (K, 4, 4) work_from_measure and (K,) mean of the field over the scan's points.
        """
        turned = scan_points @ rotation.T
        corner = turned.min(axis=0)
        cells = np.floor((turned - corner) / CELL_MM).astype(int) % self._size
        counts = np.zeros(self._size, dtype=np.float32)
        np.add.at(counts, tuple(cells.T), 1.0)
        score = fft.irfftn(self._spectrum * np.conj(fft.rfftn(counts)), self._size)
        poses, heights = [], []
        for _ in range(PEAKS_PER_ROTATION):
            peak = np.array(np.unravel_index(int(np.argmax(score)), self._size))
            heights.append(score[tuple(peak)] / len(scan_points))
            # Shifts past the middle of the grid are negative ones.
            shift = np.where(peak > np.array(self._size) // 2, peak - np.array(self._size), peak)
            poses.append(rigid(rotation, self._low + shift * CELL_MM - corner))
            around = np.ix_(*[np.arange(p - 2, p + 3) % n for p, n in zip(peak, self._size, strict=True)])
            score[around] = -np.inf
        return np.array(poses), np.array(heights)
