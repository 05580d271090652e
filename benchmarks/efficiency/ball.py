"""Ball step: sphere with free and fixed radius on caps, with outliers, and the stage model."""

from __future__ import annotations

import numpy as np
from scipy.spatial.transform import Rotation

from benchmarks.efficiency.common import Array, Case, Trial
from core.ball import StageObservations, fit_sphere, solve_stage

CENTER = np.array([-19.6, 3.458, 222.921])
RADIUS = 9.994
SIGMA = 0.035


def _cap(rng: np.random.Generator, count: int, half_angle_deg: float) -> Array:
    """Unit directions spread evenly over a cap that looks to the scanner at the origin."""
    cosine = rng.uniform(np.cos(np.radians(half_angle_deg)), 1.0, count)
    turn = rng.uniform(0.0, 2.0 * np.pi, count)
    sine = np.sqrt(1.0 - cosine**2)
    directions = np.column_stack([sine * np.cos(turn), sine * np.sin(turn), cosine])
    to_scanner = -CENTER / np.linalg.norm(CENTER)
    rotation, _ = Rotation.align_vectors(to_scanner[None], np.array([[0.0, 0.0, 1.0]]))
    return np.asarray(rotation.apply(directions))


def _sphere(half_angle_deg: float, fixed: bool, outliers: bool) -> Case:
    def run(rng: np.random.Generator) -> Trial:
        directions = _cap(rng, 800, half_angle_deg)
        points = CENTER + RADIUS * directions + rng.normal(0.0, SIGMA, (800, 3))
        if outliers:
            plane = np.column_stack([rng.uniform(-40, 40, (500, 2)), rng.normal(15.0, SIGMA, 500)]) + CENTER
            points = np.vstack([points, plane, CENTER + rng.uniform(-40, 40, (300, 3))])
        fit = fit_sphere(
            points, diameter_mm=2 * RADIUS if fixed else None, fix_diameter=fixed, sigma_mm=SIGMA,
            seed=int(rng.integers(2**31)),
        )  # fmt: skip
        # |p - c| - r, noise sigma along the radius: rows (n, 1) / sigma for centre and radius.
        rows = np.column_stack([directions, np.full(800, 0.5)]) / SIGMA
        if fixed:
            return Trial(fit.center_mm - CENTER, fit.covariance_mm2, np.linalg.inv(rows[:, :3].T @ rows[:, :3]))
        error = np.append(fit.center_mm - CENTER, fit.diameter_mm - 2 * RADIUS)
        return Trial(error, fit.center_diameter_covariance_mm2, np.linalg.inv(rows.T @ rows))

    radius = "fixed radius" if fixed else "free radius"
    clutter = ", 50 % outliers" if outliers else ""
    return Case(f"sphere, {radius}, cap {half_angle_deg:g}°{clutter}", 3 if fixed else 4, run)


# Unknowns in {M}: rotation of the scanner (3), A upper triangle (6), ball (3), rotary tilt (2), rotary point (2).
_TRUTH = np.array(
    [0.3, -0.5, 2.0, 1.0002, 0.001, 0.9997, -0.002, 0.003, 1.0004, 10.0, 20.0, 230.0, 0.02, -0.03, 30.0, -250.0]
)
_STAGE_SIGMA = 0.01
_AT_MM, _AT_RAD, _POINT = np.array([40.0, -30.0, 20.0]), 0.3, np.array([5.0, 8.0, 215.0])


def _parts(unknowns: Array) -> tuple[Array, Array, Array, Array, Array]:
    a = unknowns[3:9]
    axes = np.array([[a[0], a[1], a[3]], [0.0, a[2], a[4]], [0.0, 0.0, a[5]]])
    axis = np.array([unknowns[12], unknowns[13], 1.0])
    point = np.array([unknowns[14], unknowns[15], 0.0])
    return Rotation.from_rotvec(unknowns[:3]).as_matrix(), axes, unknowns[9:12], axis / np.linalg.norm(axis), point


def _balls(unknowns: Array, stage: Array, angle: Array) -> Array:
    rotation, axes, ball, axis, point = _parts(unknowns)
    turned = Rotation.from_rotvec(-angle[:, None] * axis).apply(ball - stage @ axes.T - point) + point
    return np.asarray(turned @ rotation)


def _carried(unknowns: Array) -> Array:
    rotation, axes, _, axis, point = _parts(unknowns)
    return np.asarray(axes @ _AT_MM + point + Rotation.from_rotvec(_AT_RAD * axis).apply(rotation @ _POINT - point))


def _turn(unknowns: Array) -> Array:
    return Rotation.from_matrix(_parts(unknowns)[0] @ _parts(_TRUTH)[0].T).as_rotvec()


def _numeric(function, unknowns: Array) -> Array:  # type: ignore[no-untyped-def]
    columns = []
    for index in range(len(unknowns)):
        step = np.zeros(len(unknowns))
        step[index] = 1e-6
        columns.append((function(unknowns + step) - function(unknowns - step)).ravel() / 2e-6)
    return np.column_stack(columns)


def _stage(what: str) -> Case:
    def run(rng: np.random.Generator) -> Trial:
        stage = rng.uniform(-80.0, 80.0, (16, 3))
        angle = rng.uniform(-0.6, 0.6, 16)
        sigma = _STAGE_SIGMA * rng.uniform(0.5, 2.0, 16)
        balls = _balls(_TRUTH, stage, angle) + rng.normal(size=(16, 3)) * sigma[:, None]
        fit = solve_stage(StageObservations(stage, angle, balls, sigma))
        rows = _numeric(lambda unknowns: _balls(unknowns, stage, angle) / sigma[:, None], _TRUTH)
        bound = np.linalg.inv(rows.T @ rows)
        if what == "carried point":
            pose = fit.measure_from_scanner_at(_AT_MM, _AT_RAD)
            error = pose[:3, :3] @ _POINT + pose[:3, 3] - _carried(_TRUTH)
            covariance = fit.point_covariance_at(_AT_MM, _AT_RAD, _POINT)
            part = _numeric(_carried, _TRUTH)
        elif what == "ball":
            error, covariance = fit.ball_in_measure_mm - _TRUTH[9:12], fit.ball_covariance_mm2()
            part = np.eye(16)[9:12]
        else:
            error = Rotation.from_matrix(fit.measure_from_scanner[:3, :3] @ _parts(_TRUTH)[0].T).as_rotvec()
            covariance, part = fit.covariance.matrix[:3, :3], _numeric(_turn, _TRUTH)
        return Trial(error, covariance, part @ bound @ part.T)

    return Case(f"stage, {what}", 3, run)


def cases() -> list[Case]:
    return [
        _sphere(70.0, False, False),
        _sphere(20.0, False, False),
        _sphere(70.0, False, True),
        _sphere(70.0, True, False),
        _sphere(15.0, True, False),
        _stage("rotation"),
        _stage("ball"),
        _stage("carried point"),
    ]
