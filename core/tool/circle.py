"""The wheel's least-squares problem: centres on a circle about the head's axis, at angles that are data too."""

from __future__ import annotations

from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import NDArray

from core.frames import rotation_from_rotvec, skew

Array = NDArray[np.float64]

_ITERATIONS = 200
_STARTS_ABOUT_TANGENT = 8


@dataclass(frozen=True)
class Circle:
    """State of the fit.

    Attributes:
        rotation: (3, 3) columns x (axis to wheel centre at sensor angle 0), y, z (axis), in B.
        centre_mm: (3,) circle centre in B.
        radius_mm: Distance from head axis to wheel axis.
        inverse_scale: Sensor angle per true angle.
        phi_rad: (N,) true head angle at each touch.
    """

    rotation: Array
    centre_mm: Array
    radius_mm: float
    inverse_scale: float
    phi_rad: Array


@dataclass(frozen=True)
class Problem:
    """Data, noise and which of the optional unknowns are free.

    Attributes:
        angle_rad: (N,) sensor.
        points_mm: (N, 3) in B.
        sigma_mm: Touch noise per axis.
        angle_sigma_rad: Sensor noise.
        free_radius: Fit the radius.
        free_scale: Fit the sensor's scale.
    """

    angle_rad: Array
    points_mm: Array
    sigma_mm: float
    angle_sigma_rad: float
    free_radius: bool
    free_scale: bool

    @property
    def parameters(self) -> int:
        """Unknowns beside the N true angles: rotation 3, centre 3, then radius and scale if free."""
        return 6 + int(self.free_radius) + int(self.free_scale)

    @property
    def degrees_of_freedom(self) -> int:
        """Observations (3 coordinates and an angle per touch) minus unknowns."""
        return 3 * len(self.angle_rad) - self.parameters

    def point_residuals(self, state: Circle) -> Array:
        """(N, 3) in B, mm: touch minus point of the circle at the fitted head angle."""
        return np.asarray(self.points_mm - circle_points(state, state.phi_rad))

    def angle_residuals(self, state: Circle) -> Array:
        """(N,) rad: sensor minus fitted sensor angle."""
        return np.asarray(self.angle_rad - state.inverse_scale * state.phi_rad)

    def white_residuals(self, state: Circle) -> Array:
        """(4N,) residuals in units of their noise, points first."""
        points = self.point_residuals(state).ravel() / self.sigma_mm
        return np.concatenate([points, self.angle_residuals(state) / self.angle_sigma_rad])

    def white_jacobian(self, state: Circle) -> Array:
        """(4N, parameters + N) derivative of `white_residuals`."""
        n = len(self.angle_rad)
        x, y = state.rotation[:, 0], state.rotation[:, 1]
        cos, sin = np.cos(state.phi_rad)[:, None], np.sin(state.phi_rad)[:, None]
        outward, tangent = cos * x + sin * y, cos * y - sin * x
        jacobian = np.zeros((4 * n, self.parameters + n))
        points = jacobian[: 3 * n].reshape(n, 3, -1)
        points[:, :, :3] = skew(state.radius_mm * outward)
        points[:, :, 3:6] = -np.eye(3)
        if self.free_radius:
            points[:, :, 6] = -outward
        index = np.arange(n)
        points[index, :, self.parameters + index] = -state.radius_mm * tangent
        jacobian[: 3 * n] /= self.sigma_mm
        if self.free_scale:
            jacobian[3 * n :, self.parameters - 1] = -state.phi_rad / self.angle_sigma_rad
        jacobian[3 * n + index, self.parameters + index] = -state.inverse_scale / self.angle_sigma_rad
        return jacobian

    def stepped(self, state: Circle, step: Array) -> Circle:
        """`state` moved by a step in the unknowns."""
        return Circle(
            rotation=rotation_from_rotvec(step[:3]) @ state.rotation,
            centre_mm=state.centre_mm + step[3:6],
            radius_mm=state.radius_mm + (float(step[6]) if self.free_radius else 0.0),
            inverse_scale=state.inverse_scale + (float(step[self.parameters - 1]) if self.free_scale else 0.0),
            phi_rad=state.phi_rad + step[self.parameters :],
        )


def circle_points(state: Circle, phi_rad: Array) -> Array:
    """Points (N, 3) in B of the circle at true head angles (N,)."""
    plane = np.column_stack([np.cos(phi_rad), np.sin(phi_rad)]) @ state.rotation[:, :2].T
    return np.asarray(state.centre_mm + state.radius_mm * plane)


def minimise(problem: Problem, start: Circle, iterations: int = _ITERATIONS) -> tuple[Circle, float, int, bool]:
    """Levenberg-Marquardt; returns state, weighted sum of squares, iterations and whether it settled."""
    state, damping = start, 1e-4
    errors = problem.white_residuals(state)
    cost = float(errors @ errors)
    for count in range(1, iterations + 1):
        jacobian = problem.white_jacobian(state)
        normal = jacobian.T @ jacobian
        gradient = jacobian.T @ errors
        settled = False
        while damping < 1e12:
            step = -np.asarray(np.linalg.solve(normal + damping * np.diag(np.diag(normal)), gradient), dtype=float)
            trial = problem.stepped(state, step)
            trial_errors = problem.white_residuals(trial)
            trial_cost = float(trial_errors @ trial_errors)
            # Smaller than this the step is rounding, whether or not the cost still falls.
            settled = float(-gradient @ step) <= 1e-10 * cost + 1e-14
            if trial_cost <= cost or settled:
                break
            damping *= 10.0
        if trial_cost <= cost:
            state, errors, cost = trial, trial_errors, trial_cost
        if settled or damping >= 1e12:
            return state, cost, count, settled
        damping = max(damping * 0.1, 1e-12)
    return state, cost, iterations, False


def starts(angle_rad: Array, points_mm: Array, radius_mm: float | None) -> list[Circle]:
    """Starts of which one lies in the right valley.

    `p = c + a cos(theta) + b sin(theta)` is linear in c, a, b. On a short arc only the chord along it is sure, and
    with the angles it also gives the radius; the plane may then turn about that chord, so it is tried all round. The
    circle through the points alone serves when the angles carry little (a wrong scale, a poor sensor).
    """
    middle = 0.5 * (angle_rad.min() + angle_rad.max())
    turned = angle_rad - middle
    basis = np.column_stack([np.ones_like(turned), np.sin(turned), np.cos(turned)])
    slope = np.linalg.lstsq(basis[:, :2], points_mm, rcond=None)[0][1]
    full = np.linalg.lstsq(basis, points_mm, rcond=None)[0]
    tangent = slope / np.linalg.norm(slope)
    radius = float(np.linalg.norm(slope)) if radius_mm is None else radius_mm
    across = np.linalg.svd(tangent[None, :])[2][1:]
    outwards = [_perpendicular(full[2], tangent)]
    outwards += [
        np.cos(turn) * across[0] + np.sin(turn) * across[1]
        for turn in np.linspace(0.0, 2.0 * np.pi, _STARTS_ABOUT_TANGENT, endpoint=False)
    ]
    found = []
    for outward in outwards:
        middle_frame = np.column_stack([outward, tangent, np.cross(outward, tangent)])
        frame = middle_frame @ _about_z(-middle)
        directions = np.column_stack([np.cos(angle_rad), np.sin(angle_rad)]) @ frame[:, :2].T
        found.append(Circle(frame, (points_mm - radius * directions).mean(axis=0), radius, 1.0, angle_rad.copy()))
    return [*found, *_from_points_alone(angle_rad, points_mm, radius_mm)]


def _perpendicular(vector: Array, direction: Array) -> Array:
    rest = vector - direction * (vector @ direction)
    length = float(np.linalg.norm(rest))
    if length < 1e-12:
        return np.asarray(np.linalg.svd(direction[None, :])[2][1])
    return np.asarray(rest / length)


def _about_z(angle: float) -> Array:
    return rotation_from_rotvec([0.0, 0.0, angle])


def _from_points_alone(angle_rad: Array, points_mm: Array, radius_mm: float | None) -> list[Circle]:
    """Plane by SVD and algebraic circle in it (Kasa), in both senses of rotation."""
    middle = points_mm.mean(axis=0)
    axes = np.linalg.svd(points_mm - middle)[2]
    found = []
    for normal in (axes[2], -axes[2]):
        frame = np.column_stack([axes[0], np.cross(normal, axes[0]), normal])
        flat = (points_mm - middle) @ frame[:, :2]
        rows = np.column_stack([2.0 * flat, np.ones(len(flat))])
        x, y, rest = np.linalg.lstsq(rows, np.sum(flat**2, axis=1), rcond=None)[0]
        radius = float(np.sqrt(max(rest + x**2 + y**2, 1e-12)))
        polar = np.unwrap(np.arctan2(flat[:, 1] - y, flat[:, 0] - x)[np.argsort(angle_rad)])
        seen = np.empty(len(polar))
        seen[np.argsort(angle_rad)] = polar
        slope, phase = np.polyfit(angle_rad, seen, 1)
        if slope <= 0.0:
            continue
        centre = middle + frame[:, :2] @ np.array([x, y])
        start = Circle(frame @ _about_z(float(phase)), centre, radius, float(1.0 / slope), seen - phase)
        found.append(start if radius_mm is None else replace(start, radius_mm=radius_mm))
    return found
