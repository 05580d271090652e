"""Where the blade was measured: grid lines behind the samples, and the patch that may be evaluated."""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property

import numpy as np
from numpy.typing import NDArray
from scipy.spatial import Delaunay

Array = NDArray[np.float64]
LINE_TOLERANCE = 1e-6
EDGE_TOLERANCE = 1e-6
# Samples that share a coordinate make a scan line if there are this many of them on average.
SAMPLES_ON_LINE = 4


def grid_lines(x: Array) -> tuple[Array, NDArray[np.int64]]:
    """Cluster coordinates into lines: the lines in rising order and the line number of each sample."""
    order = np.argsort(x, kind="stable")
    extent = float(np.ptp(x))
    starts = np.concatenate([[True], np.diff(x[order]) > LINE_TOLERANCE * max(extent, 1e-300)])
    number = np.empty(x.size, dtype=np.int64)
    number[order] = np.cumsum(starts) - 1
    lines = np.bincount(number, weights=x) / np.bincount(number)
    return lines, number


def is_grid(u: Array, v: Array) -> bool:
    """True if the samples lie on grid lines of which at least half of the nodes are occupied."""
    return bool(2 * u.size >= grid_lines(u)[0].size * grid_lines(v)[0].size)


def sample_axes(u: Array, v: Array) -> tuple[tuple[Array, Array], tuple[Array, Array]]:
    """For each parameter, coordinates in rising order and their place in units of the sample spacing.

    Grid lines where there are any: on a grid both ways, on scan lines one way, with the samples along them as the other
    spacing. Otherwise both ends of the range, with as many spacings both ways.
    """
    lines_u, lines_v = grid_lines(u)[0], grid_lines(v)[0]
    if is_grid(u, v):
        return (lines_u, _positions(lines_u)), (lines_v, _positions(lines_v))
    if min(lines_u.size, lines_v.size) * SAMPLES_ON_LINE <= u.size:
        number = min(lines_u.size, lines_v.size)
        along = np.array([0.0, u.size / number])
        if lines_u.size < lines_v.size:
            return (lines_u, _positions(lines_u)), (lines_v[[0, -1]], along)
        return (lines_u[[0, -1]], along), (lines_v, _positions(lines_v))
    ends = np.array([0.0, np.sqrt(u.size)])
    return (lines_u[[0, -1]], ends), (lines_v[[0, -1]], ends)


def _positions(lines: Array) -> Array:
    """Line numbers stretched where lines are missing: each step is measured in typical steps near it."""
    steps = np.diff(lines)
    window = 3
    typical = [np.median(steps[max(0, i - window) : i + window + 1]) for i in range(steps.size)]
    return np.concatenate([[0.0], np.cumsum(np.maximum(steps / typical, 1.0))])


@dataclass(frozen=True)
class MeasuredRegion:
    """The patch covered by samples: its holes and its outside belong to nobody.

    The samples are triangulated (Delaunay) in units of the sample spacing; triangles whose circumscribed circle, which
    contains no sample, is larger than `reach_steps` are holes or lie outside (an alpha shape).

    Attributes:
        sample_u: (N,) accepted samples.
        sample_v: (N,).
        reach_steps: Largest radius of an empty circle that is still bridged, in sample spacings.
    """

    sample_u: Array
    sample_v: Array
    reach_steps: float

    @property
    def bounds(self) -> tuple[float, float, float, float]:
        """(u least, u greatest, v least, v greatest)."""
        return (
            float(self.sample_u.min()),
            float(self.sample_u.max()),
            float(self.sample_v.min()),
            float(self.sample_v.max()),
        )

    @cached_property
    def _axes(self) -> tuple[tuple[Array, Array], tuple[Array, Array]]:
        return sample_axes(self.sample_u, self.sample_v)

    def _scaled(self, u: Array, v: Array) -> Array:
        axis_u, axis_v = self._axes
        return np.column_stack([np.interp(u, *axis_u), np.interp(v, *axis_v)])

    @cached_property
    def _complete(self) -> bool:
        """Every node of the grid is there and no line is missing: the patch is a rectangle."""
        axis_u, axis_v = self._axes
        full = self.sample_u.size == axis_u[0].size * axis_v[0].size
        return bool(full and max(np.diff(axis_u[1]).max(), np.diff(axis_v[1]).max()) <= self.reach_steps)

    @cached_property
    def _triangles(self) -> tuple[Delaunay, NDArray[np.bool_]]:
        mesh = Delaunay(self._scaled(self.sample_u, self.sample_v))
        a, b, c = (mesh.points[mesh.simplices[:, k]] for k in range(3))
        sides = [np.linalg.norm(p - q, axis=1) for p, q in ((a, b), (b, c), (c, a))]
        edge, other = b - a, c - a
        area = 0.5 * np.abs(edge[:, 0] * other[:, 1] - edge[:, 1] * other[:, 0])
        radius = sides[0] * sides[1] * sides[2] / np.maximum(4.0 * area, 1e-12)
        return mesh, radius <= self.reach_steps

    def contains(self, u: Array, v: Array) -> NDArray[np.bool_]:
        """For each point (N,) whether it lies in the measured patch."""
        u0, u1, v0, v1 = self.bounds
        slack_u, slack_v = EDGE_TOLERANCE * (u1 - u0), EDGE_TOLERANCE * (v1 - v0)
        inside = (u >= u0 - slack_u) & (u <= u1 + slack_u) & (v >= v0 - slack_v) & (v <= v1 + slack_v)
        if self._complete or not np.any(inside):
            return np.asarray(inside)
        mesh, kept = self._triangles
        found = mesh.find_simplex(self._scaled(u[inside], v[inside]), tol=EDGE_TOLERANCE)
        inside[inside] = (found >= 0) & kept[found]
        return np.asarray(inside)
