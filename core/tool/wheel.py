"""Contact wheel and floating-head axis, from touches of the wheel shaft at several head angles."""

from __future__ import annotations

from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import NDArray
from scipy.stats import t as student

from core.conditioning import Conditioning, analyse
from core.errors import FitError, InputError
from core.frames import PoseCovariance, rigid, skew
from core.tool.circle import Circle, Problem, minimise, starts
from core.tool.wheel_checks import MIN_TOUCHES, WheelTouches, checked_touches, different_touches
from core.verdict import Code

Array = NDArray[np.float64]

# Relative weight of touch and sensor when their noise is not given; its scale then comes from the residuals.
NOMINAL_SIGMA_MM = 0.05
NOMINAL_ANGLE_SIGMA_RAD = 1e-3
# Nobody touches better; keeps three touches that fit by chance from looking certain.
_BEST_SIGMA_MM = 0.01
# Less certain than this is no axis.
_HOPELESS_TILT_RAD = 0.05
_HOPELESS_POSITION_MM = 20.0
# Weighted squares per degree of freedom above which a slip of units is looked for, and what explaining it means.
_SUSPICIOUS = 25.0
_EXPLAINED = 0.05
_FIRST_STEPS = 10
_FINALISTS = 3
# Chance beyond three sigma on one side of a Gaussian.
_THREE_SIGMA = 1.35e-3


@dataclass(frozen=True)
class WheelFit:
    """Result of `solve_wheel`.

    Attributes:
        base_from_tool: (4, 4) of {H} at sensor angle 0, mm: origin in the wheel's mid-plane centre, z the head axis
            direction, x from the head axis to the wheel centre, y = z x x.
        covariance: of `base_from_tool`, in B, about the wheel centre.
        head_axis_point_mm: (3,) centre of the circle of touches, in B.
        head_axis_point_covariance_mm2: (3, 3) of that point, in B.
        head_axis_direction: (3,) unit, in B; a growing sensor angle turns right-handed about it.
        axis_tilt_sigma_rad: Standard deviation of the axis direction in its least certain sense.
        radius_mm: Head axis to wheel axis (Rg), given or fitted.
        radius_sigma_mm: Its standard deviation; 0 if given.
        angle_scale: True angle per sensor angle; 1 unless `fit_angle_scale`.
        angle_scale_sigma: Its standard deviation (as `free_angle_scale_sigma`); 0 if not fitted.
        free_radius_mm: What the data say about the radius when it is free: the check of a given one.
        free_radius_sigma_mm: Its standard deviation; inf if the data say nothing.
        free_angle_scale: What the data say about the sensor's scale when it is free.
        free_angle_scale_sigma: Its standard deviation; inf if the data say nothing. With estimated noise both of these
            are stretched by Student's t, so that three of them mean the same with few touches as with many.
        arc_rad: Head angle between the extreme touches.
        residuals_mm: (N, 3) in B: touch minus circle at the fitted head angle.
        angle_residuals_rad: (N,) sensor minus fitted sensor angle.
        rms_mm: RMS length of `residuals_mm`.
        leave_one_out_mm: (N,) distance of each touch from the circle of a fit that has not seen it; NaN if fewer than
            three different touches remain.
        leave_one_out_rad: (N,) that touch's place on that circle minus its sensor angle (as true angle); NaN likewise.
        worst: Index of the touch without which the others agree best.
        conditioning: of rotation, centre and, if free, radius.
        sigma_mm: Noise of a touch per axis, given or estimated.
        angle_sigma_rad: Noise of the sensor, given or estimated.
        different_touches: Number of touches at different places.
        used: (N,) all true; no touch is dropped silently.
        iterations: Levenberg-Marquardt steps of the best start.
        converged: Always true; a fit that does not settle raises.
    """

    base_from_tool: Array
    covariance: PoseCovariance
    head_axis_point_mm: Array
    head_axis_point_covariance_mm2: Array
    head_axis_direction: Array
    axis_tilt_sigma_rad: float
    radius_mm: float
    radius_sigma_mm: float
    angle_scale: float
    angle_scale_sigma: float
    free_radius_mm: float
    free_radius_sigma_mm: float
    free_angle_scale: float
    free_angle_scale_sigma: float
    arc_rad: float
    residuals_mm: Array
    angle_residuals_rad: Array
    rms_mm: float
    leave_one_out_mm: Array
    leave_one_out_rad: Array
    worst: int
    conditioning: Conditioning
    sigma_mm: float
    angle_sigma_rad: float
    different_touches: int
    used: NDArray[np.bool_]
    iterations: int
    converged: bool


@dataclass(frozen=True)
class _Solution:
    state: Circle
    cost: float
    iterations: int


def solve_wheel(
    touches: WheelTouches,
    *,
    radius_mm: float | None = None,
    shaft_offset_mm: float = 0.0,
    fit_angle_scale: bool = False,
    sigma_mm: float | None = None,
    angle_sigma_rad: float | None = None,
) -> WheelFit:
    """Least squares of `p_i = O + Rg (cos(phi_i) x + sin(phi_i) y)` and `sensor_i = phi_i / scale` together.

    Unknown are the orientation of (x, y, axis), the centre O, Rg unless given, the sensor's scale if asked, and every
    true angle phi_i (errors in both variables). The sensor's zero cannot be fitted: it is what defines x. The sense of
    rotation defines the sign of the axis. With a large `angle_sigma_rad` this is the plain circle fit.

    Args:
        touches: At least three, anywhere on the arc; none needs to be at angle 0.
        radius_mm: Known Rg; fitted if None.
        shaft_offset_mm: Signed way along +z of {H} (`head_axis_direction`) from the touched side of the shaft to the
            wheel's mid-plane; negative if the mid-plane lies on the other side.
        fit_angle_scale: Fit the sensor's scale too (wants a long arc or a known Rg).
        sigma_mm: Noise of a touch per axis. If None, 0.05 mm and the angle noise are taken in proportion and scaled
            by the residuals, not below 0.01 mm.
        angle_sigma_rad: Noise of the sensor; 1 mrad if None.

    Raises:
        InputError: unusable input (shape, NaN, metres, degrees for radians).
        FitError: too few, coincident or collinear touches, an arc too short for this noise (says how long it must be),
            no convergence.
    """
    angles, points = checked_touches(touches)
    _check_options(radius_mm, shaft_offset_mm, sigma_mm, angle_sigma_rad)
    problem = Problem(
        angles,
        points,
        NOMINAL_SIGMA_MM if sigma_mm is None else sigma_mm,
        NOMINAL_ANGLE_SIGMA_RAD if angle_sigma_rad is None else angle_sigma_rad,
        free_radius=radius_mm is None,
        free_scale=fit_angle_scale,
    )
    solution = _best(problem, radius_mm)
    if solution is None:
        raise FitError(
            "The wheel fit did not settle from any start. Turn the head farther between touches and repeat them.",
            Code.NOT_CONVERGED,
        )
    _check_units(problem, solution, radius_mm)
    if sigma_mm is None:
        problem = _rescaled(problem, solution)
    fit = _report(problem, solution, shaft_offset_mm, estimated=sigma_mm is None)
    _refuse_undetermined(fit)
    return fit


def arc_needed_rad(fit: WheelFit, tilt_sigma_rad: float) -> float:
    """Arc over which touches like these would know the axis to `tilt_sigma_rad`; inf if no arc would do.

    The axis tilts about the chord by noise over sagitta, and the sagitta is Rg (1 - cos(arc / 2)).
    """
    wanted = (1.0 - np.cos(0.5 * fit.arc_rad)) * fit.axis_tilt_sigma_rad / tilt_sigma_rad
    return float(2.0 * np.arccos(1.0 - wanted)) if wanted <= 2.0 else float("inf")


def _check_options(
    radius_mm: float | None, shaft_offset_mm: float, sigma_mm: float | None, angle_sigma_rad: float | None
) -> None:
    positive = {"radius_mm": radius_mm, "sigma_mm": sigma_mm, "angle_sigma_rad": angle_sigma_rad}
    for name, value in positive.items():
        if value is not None and not (np.isfinite(value) and value > 0.0):
            raise InputError(f"{name}: expected a number above zero, found {value}.")
    if not np.isfinite(shaft_offset_mm):
        raise InputError(f"shaft_offset_mm: expected a number of mm, found {shaft_offset_mm}.")


def _best(problem: Problem, radius_mm: float | None) -> _Solution | None:
    """Every start a little way, the most promising ones to the end."""
    hopeful = []
    for start in starts(problem.angle_rad, problem.points_mm, radius_mm):
        begin = start if problem.free_scale else replace(start, inverse_scale=1.0)
        state, cost, _, _ = minimise(problem, begin, _FIRST_STEPS)
        if state.radius_mm > 0.0 and state.inverse_scale > 0.0:
            hopeful.append((cost, state))
    found = []
    for _, begin in sorted(hopeful, key=lambda pair: pair[0])[:_FINALISTS]:
        state, cost, iterations, settled = minimise(problem, begin)
        if settled and state.radius_mm > 0.0 and state.inverse_scale > 0.0:
            found.append(_Solution(state, cost, _FIRST_STEPS + iterations))
    return min(found, key=lambda solution: solution.cost) if found else None


def _check_units(problem: Problem, solution: _Solution, radius_mm: float | None) -> None:
    if solution.cost < _SUSPICIOUS * problem.degrees_of_freedom:
        return
    for factor, what in (
        (np.pi / 180.0, "look like degrees: times pi/180 they fit. Give rad."),
        (180.0 / np.pi, "look like rad given as degrees (converted twice): times 180/pi they fit."),
    ):
        if np.ptp(problem.angle_rad) * factor > 2.0 * np.pi:
            continue
        other = _best(replace(problem, angle_rad=problem.angle_rad * factor), radius_mm)
        if other is not None and other.cost < _EXPLAINED * solution.cost:
            raise InputError(f"angle_rad: the head angles {what}", Code.WRONG_MODEL)


def _rescaled(problem: Problem, solution: _Solution) -> Problem:
    scale = float(np.sqrt(solution.cost / problem.degrees_of_freedom))
    scale = max(scale, _BEST_SIGMA_MM / problem.sigma_mm)
    return replace(problem, sigma_mm=problem.sigma_mm * scale, angle_sigma_rad=problem.angle_sigma_rad * scale)


def _covariance(problem: Problem, state: Circle) -> Array:
    """(parameters, parameters) with the true angles eliminated."""
    jacobian = problem.white_jacobian(state)
    covariance = np.linalg.inv(jacobian.T @ jacobian)
    return np.asarray(covariance[: problem.parameters, : problem.parameters], dtype=float)


def _report(problem: Problem, solution: _Solution, shaft_offset_mm: float, *, estimated: bool) -> WheelFit:
    state = solution.state
    covariance = _covariance(problem, state)
    x, z = state.rotation[:, 0], state.rotation[:, 2]
    arm = state.radius_mm * x + shaft_offset_mm * z
    jacobian = np.zeros((6, problem.parameters))
    jacobian[:3, :3] = np.eye(3)
    jacobian[3:, :3] = -skew(arm)
    jacobian[3:, 3:6] = np.eye(3)
    if problem.free_radius:
        jacobian[3:, 6] = x
    across = state.rotation[:, :2]
    tilt = np.linalg.eigvalsh(across.T @ covariance[:3, :3] @ across)[-1]
    residuals = problem.point_residuals(state)
    held_mm, held_rad, worst = _leave_one_out(problem, state)
    free_radius, free_radius_sigma = _check_radius(problem, state, estimated)
    free_scale, free_scale_sigma = _check_scale(problem, state, estimated)
    return WheelFit(
        base_from_tool=rigid(state.rotation, state.centre_mm + arm),
        covariance=PoseCovariance(jacobian @ covariance @ jacobian.T, state.centre_mm + arm),
        head_axis_point_mm=state.centre_mm,
        head_axis_point_covariance_mm2=covariance[3:6, 3:6],
        head_axis_direction=z,
        axis_tilt_sigma_rad=float(np.sqrt(tilt)),
        radius_mm=state.radius_mm,
        radius_sigma_mm=float(np.sqrt(covariance[6, 6])) if problem.free_radius else 0.0,
        angle_scale=1.0 / state.inverse_scale,
        angle_scale_sigma=free_scale_sigma if problem.free_scale else 0.0,
        free_radius_mm=free_radius,
        free_radius_sigma_mm=free_radius_sigma,
        free_angle_scale=free_scale,
        free_angle_scale_sigma=free_scale_sigma,
        arc_rad=float(np.ptp(state.phi_rad)),
        residuals_mm=residuals,
        angle_residuals_rad=problem.angle_residuals(state),
        rms_mm=float(np.sqrt(np.mean(np.sum(residuals**2, axis=1)))),
        leave_one_out_mm=held_mm,
        leave_one_out_rad=held_rad,
        worst=worst,
        conditioning=_conditioning(problem, state, covariance),
        sigma_mm=problem.sigma_mm,
        angle_sigma_rad=problem.angle_sigma_rad,
        different_touches=different_touches(problem.points_mm),
        used=np.ones(len(problem.angle_rad), dtype=bool),
        iterations=solution.iterations,
        converged=True,
    )


def _conditioning(problem: Problem, state: Circle, covariance: Array) -> Conditioning:
    """In the tool's own axes, so that the weak direction reads the same for every cell."""
    turn = np.eye(problem.parameters)
    turn[:3, :3] = turn[3:6, 3:6] = state.rotation.T
    information = np.linalg.inv(turn @ covariance @ turn.T)
    scales = [1.0 / state.radius_mm] * 3 + [1.0] * 3
    names = [f"rotation about tool {a}" for a in "xyz"] + [f"axis point along tool {a}" for a in "xyz"]
    if problem.free_radius:
        scales.append(1.0)
        names.append("radius")
    if problem.free_scale:
        scales.append(1.0)
        names.append("angle scale")
    return analyse(information, scales, names)


def _leave_one_out(problem: Problem, state: Circle) -> tuple[Array, Array, int]:
    n = len(problem.angle_rad)
    distance, turn = np.full(n, np.nan), np.full(n, np.nan)
    whites = problem.white_residuals(state)
    share = np.sum(whites[: 3 * n].reshape(n, 3) ** 2, axis=1) + whites[3 * n :] ** 2
    # The squares that a touch accounts for; its own residual is the least of it.
    drop = share.copy()
    for i in range(n):
        keep = np.arange(n) != i
        if different_touches(problem.points_mm[keep]) < MIN_TOUCHES:
            continue
        rest = replace(problem, angle_rad=problem.angle_rad[keep], points_mm=problem.points_mm[keep])
        other, cost, _, settled = minimise(rest, replace(state, phi_rad=state.phi_rad[keep]))
        if not settled:
            continue
        drop[i] = share.sum() - cost
        x, y, z = other.rotation.T @ (problem.points_mm[i] - other.centre_mm)
        distance[i] = np.hypot(np.hypot(x, y) - other.radius_mm, z)
        turn[i] = _wrapped(np.arctan2(y, x) - problem.angle_rad[i] / other.inverse_scale)
    return distance, turn, int(np.argmax(drop))


def _wrapped(angle: float) -> float:
    return float((angle + np.pi) % (2.0 * np.pi) - np.pi)


def _free_check(problem: Problem, state: Circle, estimated: bool) -> tuple[Circle, Array] | None:
    """State and standard deviations of the same fit with more set free, started from the fit at hand.

    If the noise was estimated, it is estimated again from these residuals: a wrong radius or scale has swollen it.
    Three standard deviations then stand for the same chance as with many touches (Student's t).
    """
    freed, cost, _, settled = minimise(problem, state)
    if not settled or freed.radius_mm <= 0.0 or freed.inverse_scale <= 0.0:
        return None
    sigmas = np.sqrt(np.diag(_covariance(problem, freed)))
    if estimated:
        freedom = problem.degrees_of_freedom
        scale = max(float(np.sqrt(cost / freedom)), _BEST_SIGMA_MM / problem.sigma_mm)
        sigmas = sigmas * scale * float(student.isf(_THREE_SIGMA, freedom)) / 3.0
    return freed, sigmas


def _check_radius(problem: Problem, state: Circle, estimated: bool) -> tuple[float, float]:
    checked = _free_check(replace(problem, free_radius=True), state, estimated)
    if checked is None:
        return state.radius_mm, float("inf")
    return checked[0].radius_mm, float(checked[1][6])


def _check_scale(problem: Problem, state: Circle, estimated: bool) -> tuple[float, float]:
    checked = _free_check(replace(problem, free_scale=True), state, estimated)
    if checked is None:
        return 1.0 / state.inverse_scale, float("inf")
    inverse_scale = checked[0].inverse_scale
    return 1.0 / inverse_scale, float(checked[1][-1]) / inverse_scale**2


def _refuse_undetermined(fit: WheelFit) -> None:
    position = float(np.sqrt(np.linalg.eigvalsh(fit.head_axis_point_covariance_mm2)[-1]))
    tilt = fit.axis_tilt_sigma_rad
    if tilt <= _HOPELESS_TILT_RAD and position <= _HOPELESS_POSITION_MM:
        return
    raise FitError(
        f"The touches do not determine the head's axis: over an arc of {np.degrees(fit.arc_rad):.3g} deg its direction "
        f"is known to {np.degrees(tilt):.2g} deg and its place to {position:.2g} mm (one standard deviation) with "
        f"{fit.sigma_mm:.2g} mm of touch noise. {_longer_arc(fit)}",
        Code.NOT_ENOUGH_VARIATION,
    )


def _longer_arc(fit: WheelFit) -> str:
    needed = arc_needed_rad(fit, 0.2 * _HOPELESS_TILT_RAD)
    if not np.isfinite(needed):
        return "No arc would do with this noise: touch more carefully."
    return f"Turn the head over {max(np.degrees(needed), np.degrees(fit.arc_rad)):.0f} deg or more."
