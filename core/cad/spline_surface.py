"""A tensor-product B-spline surface, evaluated for many points at once; mm, frame W.

Evaluation follows Piegl and Tiller, The NURBS Book: basis functions A2.2, derivative nets eq. 3.24, rational
derivatives eq. 4.20.
"""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from core.cad.kernel import faces_of, is_reversed, outward_flip, quiet_kernel
from core.cad.mesh import kernel_shape
from core.cad.surfaces import Array
from core.errors import InputError

if TYPE_CHECKING:
    from core.cad.model import CadFace, CadModel

Domain = tuple[tuple[float, float], tuple[float, float]]
DOMAIN_TOLERANCE = 1e-9
NEWTON_STEPS = 30
# Converged when a step moves the foot by less than this.
FOOT_TOLERANCE_MM = 1e-9
STEP_HALVINGS = 8
CLOSED_MM = 1e-6


@dataclass(frozen=True, eq=False)
class ClosestPoints:
    """Feet of points on a surface.

    Attributes:
        u: (N,) parameter of each foot.
        v: (N,).
        foot_mm: (N, 3).
        distance_mm: (N,) along the outward normal at the foot: positive outside the material.
        converged: (N,) the foot no longer moved, or the nearest point lies on the edge of the domain.
    """

    u: Array
    v: Array
    foot_mm: Array
    distance_mm: Array
    converged: NDArray[np.bool_]


@dataclass(frozen=True)
class _Net:
    """Control net (U, V, D) with its degrees and knots."""

    control: Array
    degree_u: int
    degree_v: int
    knots_u: Array
    knots_v: Array

    def at(self, u: Array, v: Array) -> Array:
        """(N, D) for parameters (N,)."""
        first_u, basis_u = _basis(self.knots_u, self.degree_u, self.control.shape[0], u)
        first_v, basis_v = _basis(self.knots_v, self.degree_v, self.control.shape[1], v)
        index_u = first_u[:, None] + np.arange(self.degree_u + 1)
        index_v = first_v[:, None] + np.arange(self.degree_v + 1)
        local = self.control[index_u[:, :, None], index_v[:, None, :]]
        return np.asarray(np.einsum("ni,nij...,nj->n...", basis_u, local, basis_v))

    def along_u(self) -> _Net:
        """Net of the derivative with respect to u."""
        p = self.degree_u
        if p == 0:
            return _Net(np.zeros_like(self.control), 0, self.degree_v, self.knots_u, self.knots_v)
        span = self.knots_u[p + 1:-1] - self.knots_u[1:-p - 1]
        # Where a knot is repeated as often as the degree, the function that belongs to the pole is zero everywhere.
        scale = np.divide(p, span, out=np.zeros_like(span), where=span > 0.0)
        control = np.diff(self.control, axis=0) * scale[:, None, None]
        return _Net(control, p - 1, self.degree_v, self.knots_u[1:-1], self.knots_v)

    def along_v(self) -> _Net:
        """Net of the derivative with respect to v."""
        turned = _Net(np.swapaxes(self.control, 0, 1), self.degree_v, self.degree_u, self.knots_v, self.knots_u)
        derived = turned.along_u()
        return _Net(np.swapaxes(derived.control, 0, 1), self.degree_u, derived.degree_u, self.knots_u,
                    derived.knots_u)


def _basis(knots: Array, degree: int, count: int, x: Array) -> tuple[NDArray[np.int64], Array]:
    """Non-zero basis functions (N, degree + 1) at x (N,) and the index of the first one (N,)."""
    span = np.clip(np.searchsorted(knots, x, side="right") - 1, degree, count - 1)
    values = np.ones((x.size, degree + 1))
    for order in range(1, degree + 1):
        saved = np.zeros(x.size)
        for r in range(order):
            right = knots[span + r + 1]
            left = knots[span + 1 - order + r]
            part = values[:, r] / (right - left)
            values[:, r] = saved + (right - x) * part
            saved = (x - left) * part
        values[:, order] = saved
    return span - degree, values


@dataclass(frozen=True, eq=False)
class SplineSurface:
    """B-spline surface, polynomial or rational, with an outward side.

    Attributes:
        poles_mm: (U, V, 3).
        weights: (U, V), or None where all are equal.
        degree_u: Degree in u.
        degree_v: Degree in v.
        knots_u: (U + degree_u + 1,) non-decreasing, repeated as multiplicities ask.
        knots_v: (V + degree_v + 1,).
        outward: +1 where du x dv points away from the material, -1 where it points into it.
        face_domain: ((u0, u1), (v0, v1)) box of the part of the domain that the face covers.
    """

    poles_mm: Array
    weights: Array | None
    degree_u: int
    degree_v: int
    knots_u: Array
    knots_v: Array
    outward: int
    face_domain: Domain

    @property
    def domain(self) -> Domain:
        """((u0, u1), (v0, v1)) where the surface is defined; a face may cover less, see `face_domain`."""
        return ((float(self.knots_u[self.degree_u]), float(self.knots_u[-self.degree_u - 1])),
                (float(self.knots_v[self.degree_v]), float(self.knots_v[-self.degree_v - 1])))

    @cached_property
    def _nets(self) -> dict[str, _Net]:
        """Nets of the surface and of its derivatives up to order two; homogeneous (x w, y w, z w, w) where rational."""
        control = self.poles_mm
        if self.weights is not None:
            control = np.concatenate([control * self.weights[..., None], self.weights[..., None]], axis=-1)
        net = _Net(control, self.degree_u, self.degree_v, self.knots_u, self.knots_v)
        du, dv = net.along_u(), net.along_v()
        return {"": net, "u": du, "v": dv, "uu": du.along_u(), "uv": du.along_v(), "vv": dv.along_v()}

    @cached_property
    def _closed(self) -> NDArray[np.bool_]:
        """(2,) True where the surface meets itself at both ends of u, of v."""
        (u0, u1), (v0, v1) = self.domain
        u, v = np.linspace(u0, u1, 2 * self.poles_mm.shape[0]), np.linspace(v0, v1, 2 * self.poles_mm.shape[1])
        return np.array([np.abs(self.point(u0, v) - self.point(u1, v)).max() < CLOSED_MM,
                         np.abs(self.point(u, v0) - self.point(u, v1)).max() < CLOSED_MM])

    def _checked(self, u: ArrayLike, v: ArrayLike) -> tuple[Array, Array, tuple[int, ...]]:
        """Flat parameters inside the domain and the shape to give back."""
        u, v = np.broadcast_arrays(np.asarray(u, dtype=float), np.asarray(v, dtype=float))
        for name, values, (low, high) in zip("uv", (u, v), self.domain, strict=True):
            slack = DOMAIN_TOLERANCE * (high - low)
            if values.size and not (values.min() >= low - slack and values.max() <= high + slack):
                raise InputError(f"{name} must lie in {low:g} .. {high:g} of the surface, found "
                                 f"{values.min():g} .. {values.max():g}.")
        (u0, u1), (v0, v1) = self.domain
        return np.clip(u, u0, u1).ravel(), np.clip(v, v0, v1).ravel(), u.shape

    def _evaluated(self, u: Array, v: Array, orders: tuple[str, ...]) -> tuple[Array, ...]:
        """Point and the asked derivatives (N, 3) each, rational ones by the quotient rule."""
        raw = {order: self._nets[order].at(u, v) for order in orders}
        if self.weights is None:
            return tuple(raw.values())
        weight = {order: values[:, 3:] for order, values in raw.items()}
        done: dict[str, Array] = {"": raw[""][:, :3] / weight[""]}
        for order in orders[1:3]:
            done[order] = (raw[order][:, :3] - weight[order] * done[""]) / weight[""]
        for order in orders[3:]:
            a, b = order[0], order[1]
            done[order] = (raw[order][:, :3] - weight[a] * done[b] - weight[b] * done[a]
                           - weight[order] * done[""]) / weight[""]
        return tuple(done.values())

    def point(self, u: ArrayLike, v: ArrayLike) -> Array:
        """Points (..., 3) in mm at parameters (...).

        Raises:
            InputError: a parameter lies outside the domain.
        """
        flat_u, flat_v, shape = self._checked(u, v)
        return self._evaluated(flat_u, flat_v, ("",))[0].reshape(*shape, 3)

    def derivatives(self, u: ArrayLike, v: ArrayLike) -> tuple[Array, Array, Array]:
        """Points and first derivatives `(p, du, dv)`, (..., 3) each, at parameters (...)."""
        flat_u, flat_v, shape = self._checked(u, v)
        p, du, dv = (value.reshape(*shape, 3) for value in self._evaluated(flat_u, flat_v, ("", "u", "v")))
        return p, du, dv

    def second_derivatives(self, u: ArrayLike, v: ArrayLike) -> tuple[Array, Array, Array]:
        """Second derivatives `(duu, duv, dvv)`, (..., 3) each, at parameters (...)."""
        flat_u, flat_v, shape = self._checked(u, v)
        values = self._evaluated(flat_u, flat_v, ("", "u", "v", "uu", "uv", "vv"))
        duu, duv, dvv = (value.reshape(*shape, 3) for value in values[3:])
        return duu, duv, dvv

    def normal(self, u: ArrayLike, v: ArrayLike) -> Array:
        """Unit normals (..., 3) away from the material at parameters (...); NaN where the surface is degenerate."""
        _, du, dv = self.derivatives(u, v)
        cross = self.outward * np.cross(du, dv)
        length = np.linalg.norm(cross, axis=-1, keepdims=True)
        return np.asarray(np.divide(cross, length, out=np.full_like(cross, np.nan), where=length > 0.0))

    def closest(self, points: ArrayLike, start_uv: ArrayLike | None = None) -> ClosestPoints:
        """Nearest points of the surface by Newton's method on the squared distance, kept inside the domain.

        Args:
            points: (N, 3) mm.
            start_uv: (N, 2) start parameters; None takes the nearest node of a grid over the domain.
        """
        target = np.atleast_2d(np.asarray(points, dtype=float))
        uv = self._grid_start(target) if start_uv is None else np.array(start_uv, dtype=float).reshape(-1, 2)
        low, high = np.array(self.domain).T
        uv = np.clip(uv, low, high)
        converged = np.zeros(len(target), dtype=bool)
        for _ in range(NEWTON_STEPS):
            active = np.flatnonzero(~converged)
            if active.size == 0:
                break
            stepped, moved = self._newton_step(target[active], uv[active], low, high)
            uv[active] = stepped
            converged[active] = moved < FOOT_TOLERANCE_MM
        foot = self.point(uv[:, 0], uv[:, 1])
        distance = np.sum((target - foot) * self.normal(uv[:, 0], uv[:, 1]), axis=1)
        return ClosestPoints(uv[:, 0], uv[:, 1], foot, distance, converged)

    def _grid_start(self, target: Array) -> Array:
        """Parameters (N, 2) of the nearest node of a grid twice as fine as the control net."""
        from scipy.spatial import KDTree

        (u0, u1), (v0, v1) = self.domain
        u, v = np.meshgrid(np.linspace(u0, u1, 2 * self.poles_mm.shape[0] + 9),
                           np.linspace(v0, v1, 2 * self.poles_mm.shape[1] + 9), indexing="ij")
        nearest = KDTree(self.point(u, v).reshape(-1, 3)).query(target)[1]
        return np.column_stack([u.ravel()[nearest], v.ravel()[nearest]])

    def _newton_step(self, target: Array, uv: Array, low: Array, high: Array) -> tuple[Array, Array]:
        """One damped step: new parameters (N, 2) and how far in mm each foot moves."""
        p, du, dv, duu, duv, dvv = self._evaluated(uv[:, 0], uv[:, 1], ("", "u", "v", "uu", "uv", "vv"))
        offset = p - target
        gradient = np.column_stack([np.sum(offset * du, axis=1), np.sum(offset * dv, axis=1)])
        metric = np.stack([[np.sum(du * du, axis=1), np.sum(du * dv, axis=1)],
                           [np.sum(du * dv, axis=1), np.sum(dv * dv, axis=1)]]).transpose(2, 0, 1)
        bend = np.stack([[np.sum(offset * duu, axis=1), np.sum(offset * duv, axis=1)],
                         [np.sum(offset * duv, axis=1), np.sum(offset * dvv, axis=1)]]).transpose(2, 0, 1)
        hessian = metric + bend
        # Inside a strong bend the Hessian may point uphill; there the first-order metric is used.
        safe = (np.linalg.det(hessian) > 0.05 * np.linalg.det(metric)) & (np.trace(hessian, axis1=1, axis2=2) > 0.0)
        hessian = np.where(safe[:, None, None], hessian, metric)
        # A parameter held at the edge of the domain, with the descent pointing outside, takes no part.
        closed = self._closed
        held = ~closed & (((uv <= low) & (gradient > 0.0)) | ((uv >= high) & (gradient < 0.0)))
        gradient = np.where(held, 0.0, gradient)
        hessian = np.where(held[:, :, None] | held[:, None, :], np.eye(2) * metric, hessian)
        step = -np.linalg.solve(hessian, gradient[..., None])[..., 0]
        before = np.sum(offset**2, axis=1)
        scale = np.ones((len(target), 1))
        for _ in range(STEP_HALVINGS):
            stepped = uv + scale * step
            stepped = np.where(closed, stepped, np.clip(stepped, low, high))
            wrapped = np.where(closed, low + np.mod(stepped - low, high - low), stepped)
            after = np.sum((self._evaluated(wrapped[:, 0], wrapped[:, 1], ("",))[0] - target) ** 2, axis=1)
            worse = after > before * (1.0 + 1e-12) + 1e-18
            if not worse.any():
                break
            scale[worse] /= 2
        change = stepped - uv
        return wrapped, np.linalg.norm(change[:, :1] * du + change[:, 1:] * dv, axis=1)


def spline_surface_of(model: CadModel, face: CadFace) -> SplineSurface:
    """The B-spline surface of a face; periodic ones are cut open, their seam being the domain's two ends.

    Raises:
        InputError: the face is no B-spline.
    """
    from OCP.BRep import BRep_Tool
    from OCP.BRepTools import BRepTools
    from OCP.GeomConvert import GeomConvert

    if face.type != "bspline":
        raise InputError(f"{model.path.name}: {face.label} is a {face.type}, "
                         "expected a B-spline surface (the airfoil).")
    quiet_kernel()
    shape = kernel_shape(model)
    kernel_face = faces_of(shape)[face.id - 1]
    surface = GeomConvert.SurfaceToBSplineSurface_s(BRep_Tool.Surface_s(kernel_face))
    surface.SetUNotPeriodic()
    surface.SetVNotPeriodic()
    count_u, count_v = surface.NbUPoles(), surface.NbVPoles()
    poles = np.array([[_xyz(surface.Pole(i, j)) for j in range(1, count_v + 1)] for i in range(1, count_u + 1)])
    weights = None
    if surface.IsURational() or surface.IsVRational():
        weights = np.array([[surface.Weight(i, j) for j in range(1, count_v + 1)] for i in range(1, count_u + 1)])
    knots_u = np.repeat([surface.UKnot(i) for i in range(1, surface.NbUKnots() + 1)],
                        [surface.UMultiplicity(i) for i in range(1, surface.NbUKnots() + 1)])
    knots_v = np.repeat([surface.VKnot(i) for i in range(1, surface.NbVKnots() + 1)],
                        [surface.VMultiplicity(i) for i in range(1, surface.NbVKnots() + 1)])
    u0, u1, v0, v1 = BRepTools.UVBounds_s(kernel_face)
    outward = outward_flip(shape) * (-1 if is_reversed(kernel_face) else 1)
    return SplineSurface(poles, weights, surface.UDegree(), surface.VDegree(), knots_u, knots_v, outward,
                         ((u0, u1), (v0, v1)))


def _xyz(point: Any) -> tuple[float, float, float]:
    return point.X(), point.Y(), point.Z()
