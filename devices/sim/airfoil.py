"""The true airfoil: the design surface with its manufacturing error, as piecewise bicubic patches, fast to evaluate.

The error is laid along the design's outward normal and a shift is added; the displaced surface is interpolated by a
bicubic spline on a fine grid, and that spline *is* the true airfoil: scans and contacts both use it.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from math import factorial

import numpy as np
from numpy.typing import NDArray
from scipy.interpolate import BSpline, NdBSpline, make_interp_spline

from devices.sim.geometry import Array

GRID_U, GRID_V = 641, 161


@dataclass(frozen=True, eq=False)
class SplinePoles:
    """A non-rational tensor-product B-spline surface.

    Attributes:
        poles: (U, V, 3) mm.
        knots_u: Knots in u, repeated as the degree asks for.
        knots_v: Knots in v.
        degree_u: Degree in u.
        degree_v: Degree in v.
        outward: +1 where du x dv points away from the material, -1 otherwise.
    """

    poles: Array
    knots_u: Array
    knots_v: Array
    degree_u: int
    degree_v: int
    outward: int

    @property
    def domain(self) -> tuple[float, float, float, float]:
        """(u low, u high, v low, v high)."""
        return (
            float(self.knots_u[self.degree_u]),
            float(self.knots_u[-self.degree_u - 1]),
            float(self.knots_v[self.degree_v]),
            float(self.knots_v[-self.degree_v - 1]),
        )

    def on_grid(self, u: Array, v: Array, nu: int = 0, nv: int = 0) -> Array:
        """Points (or their derivatives of order nu, nv) on the grid of u (N,) and v (M,): (N, M, 3)."""
        along_u = BSpline(self.knots_u, self.poles, self.degree_u)(u, nu=nu)
        along_v = BSpline(self.knots_v, np.swapaxes(along_u, 0, 1), self.degree_v)(v, nu=nv)
        return np.asarray(np.swapaxes(along_v, 0, 1))

    def at(self, u: Array, v: Array) -> tuple[Array, Array]:
        """Points and outward unit normals, each (N, 3), at parameters (N,)."""
        where = np.stack([np.asarray(u, dtype=float), np.asarray(v, dtype=float)], axis=1)
        spline = NdBSpline((self.knots_u, self.knots_v), self.poles, (self.degree_u, self.degree_v))
        normal = self.outward * np.cross(spline(where, nu=(1, 0)), spline(where, nu=(0, 1)))
        return spline(where), np.asarray(normal / np.linalg.norm(normal, axis=1, keepdims=True))

    def normals_on_grid(self, u: Array, v: Array) -> Array:
        """Outward unit normals (N, M, 3)."""
        normal = self.outward * np.cross(self.on_grid(u, v, nu=1), self.on_grid(u, v, nv=1))
        return np.asarray(normal / np.linalg.norm(normal, axis=-1, keepdims=True))


class TrueAirfoil:
    """The airfoil as it was made.

    Attributes:
        design: The design surface.
        u: (GRID_U,) parameter grid.
        v: (GRID_V,) parameter grid.
        points: (GRID_U, GRID_V, 3) true points in {W}, mm.
    """

    def __init__(self, design: SplinePoles, error: Callable[[Array], Array], shift_mm: Array) -> None:
        self.design = design
        u_low, u_high, v_low, v_high = design.domain
        self.u, self.v = np.linspace(u_low, u_high, GRID_U), np.linspace(v_low, v_high, GRID_V)
        share = (self.v - v_low) / (v_high - v_low)
        offset = error(share)[None, :, None] * design.normals_on_grid(self.u, self.v)
        self.points = design.on_grid(self.u, self.v) + offset + shift_mm
        self._step_u, self._step_v = self.u[1] - self.u[0], self.v[1] - self.v[0]
        self._middle_u, self._middle_v = (self.u[1:] + self.u[:-1]) / 2.0, (self.v[1:] + self.v[:-1]) / 2.0
        self._cells = self._taylor()

    def _taylor(self) -> Array:
        """(cells u, cells v, 4, 4, 3): power series of each bicubic piece about the middle of its cell."""
        cells = np.zeros((GRID_U - 1, GRID_V - 1, 4, 4, 3))
        around = make_interp_spline(self.u, self.points, k=3)
        for i in range(4):
            rows = np.swapaxes(around(self._middle_u, nu=i), 0, 1)
            upward = make_interp_spline(self.v, rows, k=3)
            for j in range(4):
                cells[:, :, i, j] = np.swapaxes(upward(self._middle_v, nu=j), 0, 1) / (factorial(i) * factorial(j))
        return cells

    def _locate(self, u: Array, v: Array) -> tuple[NDArray[np.intp], NDArray[np.intp], Array, Array]:
        i = np.clip(((u - self.u[0]) / self._step_u).astype(np.intp), 0, GRID_U - 2)
        j = np.clip(((v - self.v[0]) / self._step_v).astype(np.intp), 0, GRID_V - 2)
        return i, j, u - self._middle_u[i], v - self._middle_v[j]

    def point_and_tangents(self, u: Array, v: Array) -> tuple[Array, Array, Array]:
        """Points and first derivatives, each (N, 3), at parameters (N,)."""
        i, j, du, dv = self._locate(u, v)
        cells = self._cells[i, j]
        one, zero = np.ones_like(du), np.zeros_like(du)
        pu, pv = np.stack([one, du, du**2, du**3], 1), np.stack([one, dv, dv**2, dv**3], 1)
        qu, qv = np.stack([zero, one, 2 * du, 3 * du**2], 1), np.stack([zero, one, 2 * dv, 3 * dv**2], 1)
        along_v = np.matmul(pv[:, None, None, :], cells)[:, :, 0, :]
        point = np.matmul(pu[:, None, :], along_v)[:, 0]
        tangent_u = np.matmul(qu[:, None, :], along_v)[:, 0]
        tangent_v = np.matmul(pu[:, None, :], np.matmul(qv[:, None, None, :], cells)[:, :, 0, :])[:, 0]
        return point, tangent_u, tangent_v

    def jet(self, u: float, v: float) -> tuple[Array, Array, Array, Array, Array, Array]:
        """Point, du, dv, duu, duv, dvv, each (3,), at one parameter."""
        i = min(max(int((u - self.u[0]) / self._step_u), 0), GRID_U - 2)
        j = min(max(int((v - self.v[0]) / self._step_v), 0), GRID_V - 2)
        x, y = u - self._middle_u[i], v - self._middle_v[j]
        basis_u = np.array([[1.0, x, x * x, x**3], [0.0, 1.0, 2 * x, 3 * x * x], [0.0, 0.0, 2.0, 6 * x]])
        basis_v = np.array([[1.0, y, y * y, y**3], [0.0, 1.0, 2 * y, 3 * y * y], [0.0, 0.0, 2.0, 6 * y]])
        mixed = np.matmul(basis_v, self._cells[i, j])  # (4, 3, 3): power of u, order in v, axis
        all_orders = np.tensordot(basis_u, mixed, axes=(1, 0))  # (order in u, order in v, axis)
        return (
            all_orders[0, 0], all_orders[1, 0], all_orders[0, 1],
            all_orders[2, 0], all_orders[1, 1], all_orders[0, 2],
        )  # fmt: skip
