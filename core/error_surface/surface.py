"""The error surface: what was fitted, where it is valid, how sure it is, and its plain-data form."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field
from functools import cached_property
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray
from scipy.interpolate import NdBSpline

from core.error_surface.banded import BandedFactor
from core.error_surface.basis import DEGREE, TensorBasis, collocation, energies
from core.error_surface.region import MeasuredRegion, grid_lines
from core.errors import InputError

Array = NDArray[np.float64]
Mask = NDArray[np.bool_]

# Rounding of a file; anything more and its spline is not the one that was fitted.
_OWN_SAMPLES_MM = 1e-4


@dataclass(frozen=True)
class ErrorSurface:
    """Normal error of one blade on one tool over the airfoil's own (u, v): a tensor-product cubic B-spline.

    Attributes:
        mode: "interpolate" (through every sample), "smooth" (penalised, smoothing chosen by REML) or "regression"
            (least squares with few knots).
        knots_u: (nu + 4,) clamped knots.
        knots_v: (nv + 4,) clamped knots.
        control_points: (nu, nv) mm.
        sample_u: (N,) all samples in the order given.
        sample_v: (N,).
        sample_error_mm: (N,) NaN where a sample is missing.
        used: (N,) False for missing and for rejected samples.
        leave_one_out_mm: (N,) sample minus its prediction from all the others; for a rejected sample minus the fit
            (it took no part); NaN for a missing one.
        residuals_mm: (N,) sample minus surface.
        sigma_mm: Noise of one sample, given or estimated; None if there is nothing to estimate it from.
        sigma_known: True if the caller stated the noise.
        penalty: Weights of the bending energies in u and v, in units of the noise variance; None when interpolating.
        effective_unknowns: Trace of the hat matrix.
        reach_steps: Largest gap that is bridged, see `MeasuredRegion`.
        info: Date, blade type, tool and the like, as text.
    """

    mode: str
    knots_u: Array
    knots_v: Array
    control_points: Array
    sample_u: Array
    sample_v: Array
    sample_error_mm: Array
    used: Mask
    leave_one_out_mm: Array
    residuals_mm: Array
    sigma_mm: float | None
    sigma_known: bool
    penalty: tuple[float, float] | None
    effective_unknowns: float
    reach_steps: float
    info: Mapping[str, str] = field(default_factory=dict)

    @property
    def degrees(self) -> tuple[int, int]:
        """Degree in u and v."""
        return DEGREE, DEGREE

    @property
    def missing(self) -> Mask:
        """(N,) samples without a number."""
        return np.asarray(~np.isfinite(self.sample_error_mm))

    @property
    def rejected(self) -> NDArray[np.int64]:
        """Indices of the samples that were found to be wrong (a bounce, a lost frame)."""
        return np.flatnonzero(~self.used & ~self.missing).astype(np.int64)

    @property
    def leave_one_out_rms_mm(self) -> float:
        """RMS of the leave-one-out errors of the samples used."""
        return float(np.sqrt(np.mean(self.leave_one_out_mm[self.used] ** 2)))

    @cached_property
    def region(self) -> MeasuredRegion:
        """The measured patch."""
        return MeasuredRegion(self.sample_u[self.used], self.sample_v[self.used], self.reach_steps)

    @cached_property
    def _spline(self) -> NdBSpline:
        return NdBSpline((self.knots_u, self.knots_v), self.control_points, DEGREE)

    def _value(self, u: ArrayLike, v: ArrayLike, order: tuple[int, int]) -> Array:
        shape, points, inside = self._flat(u, v)
        out = np.full(inside.shape, np.nan)
        if np.any(inside):
            out[inside] = self._spline(points[inside], nu=order)
        return out.reshape(shape)

    def _flat(self, u: ArrayLike, v: ArrayLike) -> tuple[tuple[int, ...], Array, Mask]:
        grid_u, grid_v = np.broadcast_arrays(np.asarray(u, dtype=float), np.asarray(v, dtype=float))
        flat_u, flat_v = grid_u.ravel(), grid_v.ravel()
        inside = np.isfinite(flat_u) & np.isfinite(flat_v)
        inside[inside] = self.region.contains(flat_u[inside], flat_v[inside])
        points = np.column_stack(
            [
                np.clip(flat_u, self.knots_u[0], self.knots_u[-1]),
                np.clip(flat_v, self.knots_v[0], self.knots_v[-1]),
            ]
        )
        return grid_u.shape, points, inside

    def evaluate(self, u: ArrayLike, v: ArrayLike) -> Array:
        """Normal error in mm at (u, v) (any shape, broadcast); NaN where the blade was not measured."""
        return self._value(u, v, (0, 0))

    def derivatives(self, u: ArrayLike, v: ArrayLike) -> tuple[Array, Array, Array]:
        """(e, de/du, de/dv), mm and mm per unit of u and v; NaN where the blade was not measured."""
        return self._value(u, v, (0, 0)), self._value(u, v, (1, 0)), self._value(u, v, (0, 1))

    def sigma_at(self, u: ArrayLike, v: ArrayLike) -> Array:
        """Standard deviation of `evaluate` in mm from the samples' noise; NaN outside the patch or if unknown.

        In smooth mode this is the Bayesian band of the penalised spline, which holds its expected bias as well.
        """
        shape, points, inside = self._flat(u, v)
        out = np.full(inside.shape, np.nan)
        if self.sigma_mm is not None and np.any(inside):
            at = points[inside]
            if self.penalty is None:
                variance = np.prod([np.sum(row**2, axis=1) for row in self._cardinal(at)], axis=0)
            else:
                variance = self._basis.quadratic_forms(self._inverse_band, at[:, 0], at[:, 1])
            out[inside] = self.sigma_mm * np.sqrt(variance)
        return out.reshape(shape)

    def covariance_at(self, u: ArrayLike, v: ArrayLike) -> Array:
        """(K, K) covariance in mm^2 of the errors at K points (K,), all inside the measured patch.

        Raises:
            InputError: a point lies outside the patch, or the noise is unknown.
        """
        _, points, inside = self._flat(u, v)
        if self.sigma_mm is None or not np.all(inside):
            raise InputError("Covariance of the error surface: the noise is unknown or a point was not measured.")
        if self.penalty is None:
            row_u, row_v = self._cardinal(points)
            return np.asarray(self.sigma_mm**2 * (row_u @ row_u.T) * (row_v @ row_v.T))
        design = self._basis.design(points[:, 0], points[:, 1]).toarray()
        return np.asarray(self.sigma_mm**2 * design @ self._factor.solve(design.T))

    @cached_property
    def _basis(self) -> TensorBasis:
        return TensorBasis(self.knots_u, self.knots_v)

    @cached_property
    def _factor(self) -> BandedFactor:
        assert self.penalty is not None
        design = self._basis.design(self.sample_u[self.used], self.sample_v[self.used])
        band = self._basis.gram_band(design, np.ones(int(self.used.sum())))
        return BandedFactor.of(band + penalty_band(self._basis, self.penalty))

    @cached_property
    def _inverse_band(self) -> Array:
        return self._factor.inverse_band()

    def _cardinal(self, points: Array) -> tuple[Array, Array]:
        """Weights of the grid lines' samples in the interpolated value, one row per point, for u and for v."""
        rows: list[Array] = []
        for knots, samples, at in (
            (self.knots_u, self.sample_u, points[:, 0]),
            (self.knots_v, self.sample_v, points[:, 1]),
        ):
            lines = grid_lines(samples)[0]
            weights = np.linalg.solve(collocation(knots, lines).T, collocation(knots, at).T)
            rows.append(np.asarray(weights.T, dtype=float))
        return rows[0], rows[1]

    def to_json_dict(self) -> dict[str, Any]:
        """Plain lists and numbers, lengths in mm; `error_surface_from_json_dict` reads it back."""
        return {
            "mode": self.mode,
            "degrees": list(self.degrees),
            "knots_u": self.knots_u.tolist(),
            "knots_v": self.knots_v.tolist(),
            "control_points_mm": self.control_points.tolist(),
            "samples": {
                "u": self.sample_u.tolist(),
                "v": self.sample_v.tolist(),
                "error_mm": _nullable(self.sample_error_mm),
                "used": self.used.tolist(),
                "leave_one_out_mm": _nullable(self.leave_one_out_mm),
                "residual_mm": _nullable(self.residuals_mm),
            },
            "sigma_mm": self.sigma_mm,
            "sigma_known": self.sigma_known,
            "penalty": None if self.penalty is None else list(self.penalty),
            "effective_unknowns": self.effective_unknowns,
            "reach_steps": self.reach_steps,
            "info": dict(self.info),
        }


def penalty_band(basis: TensorBasis, penalty: tuple[float, float]) -> Array:
    """Lower band of `penalty_u * int (d2e/du2)^2 + penalty_v * int (d2e/dv2)^2`."""
    mass_u, _, bend_u = energies(basis.knots_u)
    mass_v, _, bend_v = energies(basis.knots_v)
    return penalty[0] * basis.product_band(bend_u, mass_v) + penalty[1] * basis.product_band(mass_u, bend_v)


def error_surface_from_json_dict(data: Mapping[str, Any]) -> ErrorSurface:
    """Rebuild a surface from `ErrorSurface.to_json_dict`.

    Raises:
        InputError: a field is missing or does not fit the others.
    """
    info = data.get("info") or {}
    if not isinstance(info, Mapping):
        raise InputError(f"Error surface: info is {str(info)[:40]!r}, expected an object. Write the file again.")
    try:
        samples = data["samples"]
        surface = ErrorSurface(
            mode=str(data["mode"]),
            knots_u=np.asarray(data["knots_u"], dtype=float),
            knots_v=np.asarray(data["knots_v"], dtype=float),
            control_points=np.asarray(data["control_points_mm"], dtype=float),
            sample_u=np.asarray(samples["u"], dtype=float),
            sample_v=np.asarray(samples["v"], dtype=float),
            sample_error_mm=np.asarray(samples["error_mm"], dtype=float),
            used=np.asarray(samples["used"], dtype=bool),
            leave_one_out_mm=np.asarray(samples["leave_one_out_mm"], dtype=float),
            residuals_mm=np.asarray(samples["residual_mm"], dtype=float),
            sigma_mm=None if data["sigma_mm"] is None else float(data["sigma_mm"]),
            sigma_known=bool(data["sigma_known"]),
            penalty=None if data["penalty"] is None else (float(data["penalty"][0]), float(data["penalty"][1])),
            effective_unknowns=float(data["effective_unknowns"]),
            reach_steps=float(data["reach_steps"]),
            info={str(key): str(value) for key, value in info.items()},
        )
    except KeyError as error:
        raise InputError(f"Error surface: the field {error} is missing. Write the file again.") from error
    except (TypeError, ValueError, IndexError) as error:
        raise InputError(f"Error surface: a field cannot be read ({error}).") from error
    _check_consistent(surface, data)
    return surface


def _check_consistent(surface: ErrorSurface, data: Mapping[str, Any]) -> None:
    if data.get("degrees") != list(surface.degrees):
        raise InputError(f"Error surface: degrees {data.get('degrees')}, expected {list(surface.degrees)}.")
    expected = (surface.knots_u.size - DEGREE - 1, surface.knots_v.size - DEGREE - 1)
    if surface.control_points.shape != expected:
        raise InputError(f"Error surface: {surface.control_points.shape} control points, the knots ask for {expected}.")
    if not np.all(np.isfinite(surface.control_points)):
        raise InputError("Error surface: a control point is not a number.")
    for knots in (surface.knots_u, surface.knots_v):
        if not np.all(np.isfinite(knots)) or np.any(np.diff(knots) < 0.0) or knots[0] == knots[-1]:
            raise InputError("Error surface: the knots must be finite and must not fall.")
    count = surface.sample_u.shape
    columns = (surface.sample_v, surface.sample_error_mm, surface.used, surface.leave_one_out_mm, surface.residuals_mm)
    for values in columns:
        if values.shape != count:
            raise InputError("Error surface: the sample columns differ in length.")
    if int(surface.used.sum()) < 4:
        raise InputError("Error surface: fewer than four samples are marked as used.")
    if not (np.isfinite(surface.reach_steps) and surface.reach_steps > 0.0):
        raise InputError(f"Error surface: reach_steps is {surface.reach_steps:g}, expected a number above 0.")
    _check_own_samples(surface)


def _check_own_samples(surface: ErrorSurface) -> None:
    """A robot follows the control points: they must give the errors that the file says were measured."""
    used = surface.used
    points = np.column_stack([surface.sample_u, surface.sample_v])[used]
    lowest, highest = (surface.knots_u[0], surface.knots_v[0]), (surface.knots_u[-1], surface.knots_v[-1])
    spline = NdBSpline((surface.knots_u, surface.knots_v), surface.control_points, DEGREE)
    stated = (surface.sample_error_mm - surface.residuals_mm)[used]
    off = np.abs(spline(np.clip(points, lowest, highest)) - stated)
    if not np.all(off <= _OWN_SAMPLES_MM):
        worst = int(np.argmax(np.where(np.isfinite(off), off, np.inf)))
        raise InputError(
            f"Error surface: its control points do not give its own sample at u {points[worst, 0]:.5g}, v "
            f"{points[worst, 1]:.5g} (off by {off[worst]:.3g} mm). The file was changed: write it again."
        )


def _nullable(values: Array) -> list[float | None]:
    return [float(value) if np.isfinite(value) else None for value in values]
