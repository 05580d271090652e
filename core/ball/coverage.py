"""Equal-area cells on a sphere: which share of it was seen, and where contamination sits beside the surface."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray
from scipy.spatial import cKDTree

Array = NDArray[np.float64]
Mask = NDArray[np.bool_]

_CELLS = 20000
_MOST_POINTS = 4000


def fibonacci_directions(count: int) -> Array:
    """(count, 3) unit vectors, each standing for the same area of the sphere (golden-angle spiral)."""
    index = np.arange(count) + 0.5
    z = 1.0 - 2.0 * index / count
    angle = np.pi * (1.0 + np.sqrt(5.0)) * index
    flat = np.sqrt(1.0 - z**2)
    return np.column_stack([flat * np.cos(angle), flat * np.sin(angle), z])


def coverage(directions: Array, rng: np.random.Generator) -> float:
    """Share (0 to 1) of the sphere seen by points in unit directions (N, 3).

    Cells near a point are marked (dilation), then those near an unmarked cell are taken back (erosion): the gaps
    between points close, but neither the rim of a cap nor a lone stray point adds area.
    """
    if len(directions) > _MOST_POINTS:
        directions = directions[rng.choice(len(directions), _MOST_POINTS, replace=False)]
    tree = cKDTree(directions)
    gaps = np.asarray(tree.query(directions, k=2)[0])[:, 1]
    # For a random scatter of density n the median gap is 0.47 / sqrt(n); 2 % of the area is farther than 2.4 gaps
    # from every point. The cells themselves are 0.025 rad apart.
    reach = float(np.clip(2.4 * np.median(gaps), 0.05, 0.5))
    cells = fibonacci_directions(_CELLS)
    marked = np.asarray(tree.query(cells, distance_upper_bound=reach)[0]) <= reach
    if marked.all():
        return 1.0
    away = cKDTree(cells[~marked]).query(cells[marked], distance_upper_bound=reach)[0]
    return float(np.count_nonzero(away > reach) / _CELLS)


@dataclass(frozen=True)
class Cells:
    """Cells of equal area, rings about an axis cut in sectors, and which of them are not to be trusted.

    Attributes:
        axis: (3,) unit, the middle of the cap.
        dirty: (rings, sectors) True where many points lie just off the surface.
    """

    axis: Array
    dirty: Mask

    def trusted(self, directions: Array) -> Mask:
        """(N,) which unit directions (N, 3) lie in clean cells."""
        if not self.dirty.any():
            return np.ones(len(directions), dtype=bool)
        ring, sector = _cell_of(directions, self.axis, *self.dirty.shape)
        return np.asarray(~self.dirty[ring, sector])


def _cell_of(directions: Array, axis: Array, rings: int, sectors: int) -> tuple[NDArray[np.intp], NDArray[np.intp]]:
    side = np.linalg.svd(axis[None, :])[2][1:]
    ring = np.clip(((1.0 - directions @ axis) * 0.5 * rings).astype(int), 0, rings - 1)
    turn = np.arctan2(directions @ side[0], directions @ side[1]) / (2.0 * np.pi) + 0.5
    return ring, np.clip((turn * sectors).astype(int), 0, sectors - 1)


def contaminated(directions: Array, inside: Mask, axis: Array) -> Cells:
    """Mark the cells that edge ghosts or a stem's root contaminate.

    A ray that just misses the ball passes the surface at a shallow angle, so that its ghosts lie partly inside the
    noise: where a whole ring near the rim shows points beside the surface, it and all rings outward are marked.

    Args:
        directions: (N, 3) unit, of the points on the surface and of those in the band beside it.
        inside: (N,) True for the points on the surface; the others are beside it.
        axis: (3,) unit, the middle of the cap.
    """
    rings = 2 * int(np.clip(np.sqrt(np.count_nonzero(inside) / 30.0), 5.0, 30.0))
    sectors = rings
    ring, sector = _cell_of(directions, axis, rings, sectors)
    on, beside = np.zeros((rings, sectors)), np.zeros((rings, sectors))
    np.add.at(on, (ring[inside], sector[inside]), 1.0)
    np.add.at(beside, (ring[~inside], sector[~inside]), 1.0)
    dirty = beside > 2.0 + 0.1 * on
    dirty_rings = beside.sum(axis=1) > 4.0 + 0.05 * on.sum(axis=1)
    # Rings closer than about 45 degrees to the middle are not a rim.
    dirty_rings[: int(0.15 * rings)] = False
    if dirty_rings.any():
        dirty[int(np.argmax(dirty_rings)) :] = True
    return Cells(axis, dirty)
