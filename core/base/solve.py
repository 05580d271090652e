"""Measuring frame to robot base, from a ball on the flange seen in several poses."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike, NDArray
from scipy.optimize import brentq

from core.base.checks import check_start, check_variation, checked_observations
from core.base.start import global_start
from core.conditioning import Conditioning, analyse, direction_text
from core.errors import FitError, InputError
from core.flange_poses import pose_groups
from core.frames import PoseCovariance, perturbed, rigid, skew, transform_points
from core.held_out import held_out_residuals, odd_one_out
from core.verdict import Code

Array = NDArray[np.float64]

UNKNOWNS = 9
_ITERATIONS = 50
# Worse than this even noise of a micrometre becomes millimetres.
_MAX_CONDITION = 2000.0
# A pose less certain than this is no pose: refuse instead of letting a verdict reject it.
_HOPELESS_ROTATION_RAD = 0.05
_HOPELESS_POSITION_MM = 10.0
# Keeps the weights finite for data without any noise.
_SMALLEST_SIGMA_MM = 1e-9


@dataclass(frozen=True)
class BaseFit:
    """Result of `solve_base`.

    Attributes:
        base_from_measure: (4, 4), mm.
        ball_in_flange_mm: (3,) ball centre in the flange frame.
        covariance: of `base_from_measure`, expressed in B about the centroid of the ball centres.
        ball_covariance_mm2: (3, 3) of `ball_in_flange_mm`.
        joint_covariance: (9, 9) of (rx ry rz tx ty tz about the centroid, ball offset); rad and mm.
        residuals_mm: (N, 3) in B: ball carried by the flange minus ball carried by the measuring frame.
        rms_mm: RMS length of the residuals.
        leave_one_out_mm: (N,) how far each ball is missed by a fit that has not seen its pose, in the directions that
            the other poses can predict; NaN where they predict none.
        unchecked_directions: (N,) number of directions, 0 to 3, in which the other poses cannot predict that ball: a
            mistake there would not show.
        worst: Index of the observation without whose pose the others agree best.
        outlier: Index of the observation that the others contradict (F test of its deletion, 0.1 % per fit), or None.
        conditioning: of the nine unknowns, rotations scaled by `lever_arm_mm`.
        lever_arm_mm: RMS distance of the ball centres from their centroid.
        observation_covariance_mm2: (N, 3, 3) in B, noise assumed or estimated per residual.
        robot_sigma_mm: Robot repeatability per axis, given or estimated; 0 if not needed to explain the residuals.
        different_poses: Number of poses, repeats counted once.
        used: (N,) all true; no observation is dropped silently.
        iterations: Gauss-Newton steps.
        converged: Always true; a fit that does not converge raises.
    """

    base_from_measure: Array
    ball_in_flange_mm: Array
    covariance: PoseCovariance
    ball_covariance_mm2: Array
    joint_covariance: Array
    residuals_mm: Array
    rms_mm: float
    leave_one_out_mm: Array
    unchecked_directions: NDArray[np.int64]
    worst: int
    outlier: int | None
    conditioning: Conditioning
    lever_arm_mm: float
    observation_covariance_mm2: Array
    robot_sigma_mm: float
    different_poses: int
    used: NDArray[np.bool_]
    iterations: int
    converged: bool


def solve_base(
    base_from_flange: ArrayLike,
    ball_in_measure_mm: ArrayLike,
    *,
    ball_covariance_mm2: ArrayLike | None = None,
    robot_sigma_mm: float | None = None,
) -> BaseFit:
    """Solve `base_from_flange_i * ball = base_from_measure * C_i` for pose and ball offset together.

    Gauss-Newton on nine unknowns from a global start (`core.base.start`), each residual weighted by the inverse of
    `R C_i's covariance R^T + robot_sigma^2 I`. Any poses serve, no pure translations are needed.

    Noise: with `robot_sigma_mm` the covariance is the one of the noise given. Without it, an isotropic variance is
    estimated such that the weighted sum of squares equals its degrees of freedom (Paule & Mandel 1982); it covers
    the ball's noise too when no ball covariance is given.

    Args:
        base_from_flange: (N, 4, 4) rigid, mm, N >= 4 different poses.
        ball_in_measure_mm: (N, 3) ball centres in M.
        ball_covariance_mm2: (N, 3, 3) covariance of each ball centre, in M.
        robot_sigma_mm: Repeatability of the flange position per axis.

    Raises:
        InputError: unusable or mistaken input (shape, NaN, not rigid, metres, mirrored, inverted).
        FitError: too few poses, too little variation (names what stays free), no rigid answer, no convergence.
    """
    poses, balls = checked_observations(base_from_flange, ball_in_measure_mm)
    ball_covariance = _checked_covariance(ball_covariance_mm2, len(balls))
    if robot_sigma_mm is not None and not (np.isfinite(robot_sigma_mm) and robot_sigma_mm >= 0.0):
        raise InputError(f"robot_sigma_mm: expected a number of mm, zero or more, found {robot_sigma_mm}.")
    if robot_sigma_mm == 0.0 and ball_covariance_mm2 is None:
        raise InputError("robot_sigma_mm is 0 and no ball covariance is given: one of them must be above zero.")
    check_variation(poses, balls)
    start = global_start(poses, balls)
    check_start(start, poses, balls)
    problem = _Problem(poses, balls, ball_covariance)
    first = _State(rigid(start.rotation, start.translation_mm), start.ball_in_flange_mm, 0)
    _refuse_weak(problem, first)
    if robot_sigma_mm is None:
        sigma, state = _estimate_sigma(problem, first)
    else:
        sigma = robot_sigma_mm
        state = problem.solve(first, sigma)
    fit = _report(problem, state, sigma)
    _refuse_undetermined(fit)
    return fit


@dataclass(frozen=True)
class _State:
    base_from_measure: Array
    ball: Array
    iterations: int


@dataclass(frozen=True)
class _Problem:
    poses: Array
    balls: Array
    ball_covariance: Array

    @property
    def degrees_of_freedom(self) -> int:
        return 3 * len(self.balls) - UNKNOWNS

    def residuals(self, state: _State) -> Array:
        carried = self.poses[:, :3, :3] @ state.ball + self.poses[:, :3, 3]
        return np.asarray(carried - transform_points(state.base_from_measure, self.balls))

    def centre(self, state: _State) -> Array:
        return transform_points(state.base_from_measure, self.balls.mean(axis=0))

    def jacobian(self, state: _State) -> Array:
        """(N, 3, 9) by pose error about the centroid and by ball offset."""
        seen = transform_points(state.base_from_measure, self.balls) - self.centre(state)
        jacobian = np.empty((len(self.balls), 3, UNKNOWNS))
        jacobian[:, :, :3] = skew(seen)
        jacobian[:, :, 3:6] = -np.eye(3)
        jacobian[:, :, 6:] = self.poses[:, :3, :3]
        return jacobian

    def covariances(self, state: _State, sigma: float) -> Array:
        rotation = state.base_from_measure[:3, :3]
        variance = max(sigma, _SMALLEST_SIGMA_MM) ** 2
        return np.asarray(rotation @ self.ball_covariance @ rotation.T + variance * np.eye(3))

    def weighted_sum(self, state: _State, sigma: float) -> float:
        errors = self.residuals(state)
        return float(np.einsum("ni,nij,nj->", errors, np.linalg.inv(self.covariances(state, sigma)), errors))

    def solve(self, start: _State, sigma: float) -> _State:
        state = start
        for count in range(1, _ITERATIONS + 1):
            weights = np.asarray(np.linalg.inv(self.covariances(state, sigma)), dtype=float)
            jacobian = self.jacobian(state)
            normal, gradient = _normal(jacobian, weights, self.residuals(state))
            step = -np.linalg.solve(normal, gradient)
            pose = perturbed(state.base_from_measure, step[:6], self.centre(state))
            state = _State(pose, state.ball + step[6:], start.iterations + count)
            if np.abs(step[:3]).max() < 1e-11 and np.abs(step[3:]).max() < 1e-8:
                return state
        raise FitError(
            f"The base fit did not settle in {_ITERATIONS} steps (last change {np.abs(step[3:]).max():.2g} mm). "
            "Add poses tilted about other axes.",
            Code.NOT_CONVERGED,
        )


def _normal(jacobian: Array, weights: Array, residuals: Array) -> tuple[Array, Array]:
    weighted = np.swapaxes(jacobian, 1, 2) @ weights
    return (weighted @ jacobian).sum(axis=0), np.einsum("npk,nk->p", weighted, residuals)


def _estimate_sigma(problem: _Problem, start: _State) -> tuple[float, _State]:
    if not np.any(problem.ball_covariance):
        state = problem.solve(start, 1.0)
        return float(np.sqrt(problem.weighted_sum(state, 1.0) / problem.degrees_of_freedom)), state

    def excess(sigma: float) -> float:
        return problem.weighted_sum(problem.solve(start, sigma), sigma) - problem.degrees_of_freedom

    return _root_or_zero(excess, start, problem)


def _root_or_zero(excess: Callable[[float], float], start: _State, problem: _Problem) -> tuple[float, _State]:
    if excess(0.0) <= 0.0:
        return 0.0, problem.solve(start, 0.0)
    upper = 2.0 * float(np.sqrt(problem.weighted_sum(start, 1.0) / problem.degrees_of_freedom))
    while excess(upper) > 0.0:
        upper *= 2.0
    sigma = float(brentq(excess, 0.0, upper, rtol=1e-6))
    return sigma, problem.solve(start, sigma)


def _report(problem: _Problem, state: _State, sigma: float) -> BaseFit:
    covariances = problem.covariances(state, sigma)
    weights = np.asarray(np.linalg.inv(covariances), dtype=float)
    jacobian = problem.jacobian(state)
    residuals = problem.residuals(state)
    joint = np.asarray(np.linalg.inv(_normal(jacobian, weights, residuals)[0]), dtype=float)
    groups = pose_groups(problem.poses)
    held_out, unpredicted = held_out_residuals(jacobian, weights, joint, residuals, groups)
    # The weighted squares fall by e.W.r when a pose with residual r and held-out residual e is left out.
    drop = np.nan_to_num(np.einsum("ni,nij,nj->n", held_out, weights, residuals))
    alone = held_out_residuals(jacobian, weights, joint, residuals, np.arange(len(residuals), dtype=np.int64))[0]
    drops = np.nan_to_num(np.einsum("ni,nij,nj->n", alone, weights, residuals))
    squares = float(np.einsum("ni,nij,nj->", residuals, weights, residuals))
    return BaseFit(
        base_from_measure=state.base_from_measure,
        ball_in_flange_mm=state.ball,
        covariance=PoseCovariance(joint[:6, :6], problem.centre(state)),
        ball_covariance_mm2=joint[6:, 6:],
        joint_covariance=joint,
        residuals_mm=residuals,
        rms_mm=float(np.sqrt(np.mean(np.sum(residuals**2, axis=1)))),
        leave_one_out_mm=np.linalg.norm(held_out, axis=1),
        unchecked_directions=unpredicted,
        worst=int(np.argmax(drop)),
        outlier=odd_one_out(drops, squares, problem.degrees_of_freedom),
        conditioning=_conditioning(problem, state),
        lever_arm_mm=_lever_arm(problem.balls),
        observation_covariance_mm2=covariances,
        robot_sigma_mm=sigma,
        different_poses=len(np.unique(groups)),
        used=np.ones(len(residuals), dtype=bool),
        iterations=state.iterations,
        converged=True,
    )


def _refuse_weak(problem: _Problem, state: _State) -> None:
    conditioning = _conditioning(problem, state)
    if conditioning.condition > _MAX_CONDITION:
        raise FitError(
            f"The poses leave something nearly free: {conditioning.description} (condition "
            f"{conditioning.condition:.3g}, usable below {_MAX_CONDITION:.0f}). Add poses that move the ball by 50 mm "
            "or more and tilt the flange by 5 deg or more about different axes.",
            Code.NOT_ENOUGH_VARIATION,
        )


def _refuse_undetermined(fit: BaseFit) -> None:
    turn = float(np.sqrt(np.linalg.eigvalsh(fit.covariance.matrix[:3, :3])[-1]))
    shift = float(np.sqrt(np.linalg.eigvalsh(fit.covariance.matrix[3:, 3:])[-1]))
    if turn > _HOPELESS_ROTATION_RAD or shift > _HOPELESS_POSITION_MM:
        raise FitError(
            f"The poses do not determine the measuring frame: standard deviation {np.degrees(turn):.2g} deg and "
            f"{shift:.2g} mm with this noise. Weakest: {fit.conditioning.description}. Add poses that move the ball to "
            "the sides and tilt the flange more.",
            Code.NOT_ENOUGH_VARIATION,
        )


def _lever_arm(balls: Array) -> float:
    return float(np.sqrt(np.mean(np.sum((balls - balls.mean(axis=0)) ** 2, axis=1))))


def _conditioning(problem: _Problem, state: _State) -> Conditioning:
    jacobian = problem.jacobian(state)
    identity = np.tile(np.eye(3), (len(jacobian), 1, 1))
    information = _normal(jacobian, identity, problem.residuals(state))[0]
    scales = [1.0 / _lever_arm(problem.balls)] * 3 + [1.0] * 6
    result = analyse(information, scales, [""] * UNKNOWNS)
    weak = result.weakest_direction
    parts = [
        f"{what} {direction_text(part)}"
        for what, part in (
            ("rotation about", weak[:3]),
            ("translation of the measuring frame along base", weak[3:6]),
            ("ball offset along flange", weak[6:]),
        )
        if np.linalg.norm(part) >= 0.2
    ]
    return Conditioning(result.condition, weak, " with ".join(parts))


def _checked_covariance(covariance: ArrayLike | None, n: int) -> Array:
    if covariance is None:
        return np.zeros((n, 3, 3))
    matrices = np.asarray(covariance, dtype=float)
    if matrices.shape != (n, 3, 3):
        raise InputError(f"ball_covariance_mm2: expected {n} matrices 3x3, found shape {matrices.shape}.")
    if not np.all(np.isfinite(matrices)):
        raise InputError("ball_covariance_mm2: NaN or infinite number.")
    lowest = np.linalg.eigvalsh(0.5 * (matrices + np.swapaxes(matrices, 1, 2)))[:, 0]
    if np.any(lowest <= 0.0):
        raise InputError(
            f"ball_covariance_mm2[{int(np.argmin(lowest))}]: a covariance must be positive definite, its smallest "
            f"variance is {lowest.min():.3g} mm^2."
        )
    return matrices
