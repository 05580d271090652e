"""A face's trim as a raster: is a point inside, how far from the edge, on which of the joined faces."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

from core.cad import Plane, Surface

if TYPE_CHECKING:
    from shapely import MultiPolygon, Polygon

Array = NDArray[np.float64]
Index = NDArray[np.int64]

CELLS = 60_000
SMALLEST_CELL_MM = 0.02


@dataclass(frozen=True, eq=False)
class TrimField:
    """Distance to the edge on a grid over the surface coordinates (s, t).

    A look-up costs the same for a rectangle and for a trim of a thousand corners, and one field serves every margin.

    Attributes:
        corner: (2,) mm, lower corner of cell (0, 0).
        cell_mm: Edge length of a cell.
        depth: (ny, nx) float32 mm from the cell's middle to the edge of the trim, -1 outside.
        period: Circumference in s after which a cylinder repeats itself, infinite for a plane.
    """

    corner: Array
    cell_mm: float
    depth: NDArray[np.float32]
    period: float

    def depth_at(self, s: Array, t: Array) -> NDArray[np.float32]:
        """Distance in mm to the edge of the trim for coordinates (N,), -1 outside."""
        if np.isfinite(self.period):
            s = self.corner[0] + np.mod(s - self.corner[0], self.period)
        column = ((s - self.corner[0]) / self.cell_mm).astype(np.int32)
        row = ((t - self.corner[1]) / self.cell_mm).astype(np.int32)
        rows, columns = self.depth.shape
        known = (s >= self.corner[0]) & (t >= self.corner[1]) & (column < columns) & (row < rows)
        result = np.full(s.shape, -1.0, dtype=np.float32)
        result[known] = self.depth[row[known], column[known]]
        return result

    def area_mm2(self, margin_mm: float) -> float:
        """Area that lies at least `margin_mm` inside the edge."""
        return float(np.count_nonzero(self.depth > margin_mm)) * self.cell_mm**2

    def cells(self, s: Array, t: Array, size_mm: float) -> Index:
        """Number of the coarse square of `size_mm` in which each point (N,) lies; for counting coverage."""
        columns = int(self.depth.shape[1] * self.cell_mm / size_mm) + 2
        column = np.clip(((s - self.corner[0]) / size_mm).astype(np.int64), 0, columns - 1)
        return np.asarray(column + columns * np.maximum(((t - self.corner[1]) / size_mm).astype(np.int64), 0))


def trim_field(surface: Surface, trim: Polygon | MultiPolygon) -> TrimField:
    """Rasterise a trim (even-odd rule over all loops) and take the distance transform."""
    from scipy.ndimage import distance_transform_edt

    lower, upper = np.array(trim.bounds[:2]), np.array(trim.bounds[2:])
    extent = upper - lower
    cell = max(float(np.sqrt(extent[0] * extent[1] / CELLS)), float(extent.max()) / 2000.0, SMALLEST_CELL_MM)
    corner = lower - 1.5 * cell
    shape = np.ceil((upper - corner) / cell).astype(int)[::-1] + 2
    inside = _fill(_loops(trim), corner, cell, (int(shape[0]), int(shape[1])))
    depth = np.asarray(distance_transform_edt(inside), dtype=np.float32) * np.float32(cell) - np.float32(cell / 2)
    depth[~inside] = -1.0
    period = np.inf if isinstance(surface, Plane) else 2.0 * np.pi * surface.radius_mm
    if extent[0] > period - cell:
        depth = _closed_ring(inside, cell, period, round(period / cell))
    return TrimField(corner, cell, depth, period)


def _closed_ring(inside: NDArray[np.bool_], cell: float, period: float, columns: int) -> NDArray[np.float32]:
    """Distance field of a cylinder that closes on itself: its seam is no edge."""
    from scipy.ndimage import distance_transform_edt

    one_turn = inside[:, 1 : 1 + columns].copy()
    one_turn[:, [0, -1]] |= one_turn[:, [1, -2]]
    steps = distance_transform_edt(np.hstack([one_turn] * 3))[:, columns - 1 : 2 * columns + 2]
    depth = np.asarray(steps, dtype=np.float32) * np.float32(cell) - np.float32(cell / 2)
    depth[depth < 0.0] = -1.0
    return depth


def _loops(trim: Polygon | MultiPolygon) -> list[Array]:
    """Closed outlines (K, 2) of all loops, outer ones and holes."""
    polygons = list(trim.geoms) if hasattr(trim, "geoms") else [trim]
    return [np.asarray(ring.coords)[:, :2] for polygon in polygons for ring in (polygon.exterior, *polygon.interiors)]


def _fill(loops: list[Array], corner: Array, cell: float, shape: tuple[int, int]) -> NDArray[np.bool_]:
    """Even-odd fill at cell middles: each edge toggles its rows from its crossing on."""
    starts = np.vstack([(loop[:-1] - corner) / cell - 0.5 for loop in loops])
    ends = np.vstack([(loop[1:] - corner) / cell - 0.5 for loop in loops])
    low = np.ceil(np.minimum(starts[:, 1], ends[:, 1])).astype(int)
    count = np.ceil(np.maximum(starts[:, 1], ends[:, 1])).astype(int) - low
    edge = np.repeat(np.arange(len(starts)), count)
    row = np.arange(len(edge)) - np.repeat(np.cumsum(count) - count, count) + low[edge]
    slope = (ends[edge, 0] - starts[edge, 0]) / (ends[edge, 1] - starts[edge, 1])
    crossing = starts[edge, 0] + (row - starts[edge, 1]) * slope
    toggles = np.zeros((shape[0], shape[1] + 1), dtype=np.int32)
    np.add.at(toggles, (row, np.clip(np.ceil(crossing).astype(int), 0, shape[1])), 1)
    return np.asarray(np.cumsum(toggles, axis=1)[:, :-1] % 2 == 1)
