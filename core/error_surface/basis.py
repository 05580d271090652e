"""Tensor-product cubic B-spline basis: knots, sparse design rows and bending energies."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray
from scipy.interpolate import BSpline
from scipy.sparse import csr_array, kron

from core.error_surface.banded import lower_band

Array = NDArray[np.float64]
DEGREE = 3


def clamped_knots(breaks: Array) -> Array:
    """Knot vector of a clamped cubic spline with the given increasing break points."""
    return np.concatenate([[breaks[0]] * DEGREE, breaks, [breaks[-1]] * DEGREE])


def interpolation_knots(lines: Array) -> Array:
    """Not-a-knot cubic knots: as many control points as `lines`, no knot at the second and the last but one."""
    return clamped_knots(np.concatenate([lines[:1], lines[2:-2], lines[-1:]]))


def collocation(knots: Array, x: Array) -> Array:
    """(len(x), number of basis functions) dense values of the basis."""
    return np.asarray(BSpline.design_matrix(np.clip(x, knots[0], knots[-1]), knots, DEGREE).toarray())


def energies(knots: Array) -> tuple[Array, Array, Array]:
    """Gram matrices of the values, first and second derivatives: integrals of b_i b_j, b_i' b_j', b_i'' b_j''.

    Exact: four Gauss points per knot span integrate polynomials up to degree seven.
    """
    breaks = np.unique(knots)
    nodes, weights = np.polynomial.legendre.leggauss(4)
    half = np.diff(breaks) / 2.0
    x = (breaks[:-1, None] + half[:, None] * (nodes + 1.0)).ravel()
    w = (half[:, None] * weights).ravel()
    spline = BSpline(knots, np.eye(knots.size - DEGREE - 1), DEGREE)
    grams = []
    for order in range(3):
        values = spline(x, nu=order)
        grams.append(np.asarray((values * w[:, None]).T @ values))
    return grams[0], grams[1], grams[2]


@dataclass(frozen=True)
class TensorBasis:
    """Basis functions b_i(u) b_j(v), numbered so that the normal matrix has the narrower of the two bands.

    Attributes:
        knots_u: Clamped cubic knots in u.
        knots_v: Clamped cubic knots in v.
    """

    knots_u: Array
    knots_v: Array

    @property
    def shape(self) -> tuple[int, int]:
        """Number of control points in u and v."""
        return self.knots_u.size - DEGREE - 1, self.knots_v.size - DEGREE - 1

    @property
    def u_is_major(self) -> bool:
        """True if the numbering runs through v first."""
        return self.shape[0] >= self.shape[1]

    @property
    def bandwidth(self) -> int:
        """Half bandwidth of the normal matrix."""
        return DEGREE * min(self.shape) + DEGREE

    def grid(self, coefficients: Array) -> Array:
        """Control points (nu, nv) from the vector of unknowns."""
        nu, nv = self.shape
        return coefficients.reshape(nu, nv) if self.u_is_major else coefficients.reshape(nv, nu).T

    def vector(self, control_points: Array) -> Array:
        """The vector of unknowns from control points (nu, nv)."""
        return np.ascontiguousarray(control_points if self.u_is_major else control_points.T).ravel()

    def support(self, u: Array, v: Array) -> tuple[NDArray[np.int64], Array]:
        """For each point the 16 unknowns that act there and the values of their basis functions, (N, 16) each."""
        first_u, values_u = _local(self.knots_u, u)
        first_v, values_v = _local(self.knots_v, v)
        steps = np.arange(DEGREE + 1)
        index_u, index_v = first_u[:, None] + steps, first_v[:, None] + steps
        nu, nv = self.shape
        if self.u_is_major:
            index = index_u[:, :, None] * nv + index_v[:, None, :]
        else:
            index = index_v[:, None, :] * nu + index_u[:, :, None]
        values = values_u[:, :, None] * values_v[:, None, :]
        return index.reshape(u.size, -1), values.reshape(u.size, -1)

    def design(self, u: Array, v: Array) -> csr_array:
        """(N, number of unknowns) sparse design matrix."""
        index, values = self.support(u, v)
        n, width = index.shape
        pointers = np.arange(0, n * width + 1, width)
        return csr_array((values.ravel(), index.ravel(), pointers), shape=(n, self.shape[0] * self.shape[1]))

    def gram_band(self, design: csr_array, weights: Array) -> Array:
        """Lower band of B^T W B."""
        weighted = design.multiply(weights[:, None]).tocsr()
        return lower_band(design.T @ weighted, self.bandwidth)

    def product_band(self, matrix_u: Array, matrix_v: Array) -> Array:
        """Lower band of the Kronecker product of two banded 1-D matrices."""
        major, minor = (matrix_u, matrix_v) if self.u_is_major else (matrix_v, matrix_u)
        return lower_band(kron(csr_array(major), csr_array(minor), format="coo"), self.bandwidth)

    def quadratic_forms(self, inverse_band: Array, u: Array, v: Array) -> Array:
        """b(u, v)^T Z b(u, v) for each point (N,), with Z given by its band."""
        index, values = self.support(u, v)
        total = np.zeros(u.size)
        for a in range(index.shape[1]):
            for b in range(a + 1):
                low, high = np.minimum(index[:, a], index[:, b]), np.maximum(index[:, a], index[:, b])
                factor = 1.0 if a == b else 2.0
                total += factor * values[:, a] * values[:, b] * inverse_band[high - low, low]
        return total


def _local(knots: Array, x: Array) -> tuple[NDArray[np.int64], Array]:
    rows = BSpline.design_matrix(np.clip(x, knots[0], knots[-1]), knots, DEGREE)
    return rows.indices.reshape(-1, DEGREE + 1)[:, 0].astype(np.int64), rows.data.reshape(-1, DEGREE + 1)
