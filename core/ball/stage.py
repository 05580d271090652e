"""The scanner on its stage: axes, squareness, rotary axis and `measure_from_scanner` from ball observations."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike, NDArray

from core.ball.stage_checks import (
    AXIS_NAMES,
    STILL_MM,
    STILL_RAD,
    StageObservations,
    check_independent,
    check_needed_axes,
    checked_observations,
    moved_names,
)
from core.ball.stage_model import StageModel, solve_model
from core.conditioning import Conditioning, analyse
from core.errors import FitError, InputError
from core.frames import PoseCovariance, rigid, rotation_from_rotvec, rotvec_from_rotation
from core.held_out import odd_one_out
from core.verdict import Code

Array = NDArray[np.float64]
Mask = NDArray[np.bool_]

# Smallest singular-value ratio of the column-scaled Jacobian that still determines every unknown.
LEAST_RATIO = 1e-6


@dataclass(frozen=True)
class RotaryAxis:
    """Rotary axis in {M} with all linear axes at zero.

    Attributes:
        direction: (3,) unit; a positive angle turns right-handed about it.
        point_mm: (3,) its point nearest to the origin of {M}.
    """

    direction: Array
    point_mm: Array


@dataclass(frozen=True)
class StageFit:
    """Geometry of the stage; mm, rad; {M}: origin in the scanner's at zero, x along axis x, y in the plane of x and y.

    Attributes:
        measure_from_scanner: (4, 4) at the stage's zero position.
        covariance: Of `measure_from_scanner` about its origin; None without redundancy and known noise.
        axes: (3, 3) columns are the unit directions of axes x, y, z in {M}.
        scale: (3,) mm moved per mm commanded.
        assumed: Names of axes that were not moved; direction z = x cross y and scale 1 are assumed then.
        squareness_rad: (3,) angle between the axes less 90 degrees, for xy, yz, zx.
        squareness_sigma_rad: (3,) standard deviations, None as for `covariance`.
        rotary_axis: None if it was not moved.
        rotary_reference_rad: Angle at which the rotary axis stood if it was not moved, else 0.
        scanner_axis_angles_rad: (3,) angle between each linear axis and the scanner's own z axis.
        ball_in_measure_mm: (3,) the ball.
        residuals_mm: (N, 3) observed less predicted ball in the scanner's frame.
        rms_mm: RMS length of the residuals.
        leave_one_out_mm: (N,) distance between an observation and its prediction from all others; NaN where the others
            do not determine it.
        outlier: Index of the observation that the others contradict (F test of its deletion, 0.1 % per fit), or None.
        sigma_mm: Noise per coordinate estimated from the residuals, None without redundancy.
        redundancy: Number of equations beyond the number of unknowns.
        conditioning: Of all unknowns, scaled to equal effect on the data.
        iterations: Of the least squares.
        converged: False if it was still moving.
        model: The unknowns in the scanner's frame.
        model_covariance: Their covariance, order of `StageModel.moved`; None as for `covariance`.
        moved: (3,) bool, which linear axes were moved.
    """

    measure_from_scanner: Array
    covariance: PoseCovariance | None
    axes: Array
    scale: Array
    assumed: tuple[str, ...]
    squareness_rad: Array
    squareness_sigma_rad: Array | None
    rotary_axis: RotaryAxis | None
    rotary_reference_rad: float
    scanner_axis_angles_rad: Array
    ball_in_measure_mm: Array
    residuals_mm: Array
    rms_mm: float
    leave_one_out_mm: Array
    outlier: int | None
    sigma_mm: float | None
    redundancy: int
    conditioning: Conditioning
    iterations: int
    converged: bool
    model: StageModel
    model_covariance: Array | None
    moved: Mask

    def measure_from_scanner_at(self, stage_mm: ArrayLike, stage_rad: float = 0.0) -> Array:
        """(4, 4) measure_from_scanner with the stage at (3,) mm and an angle in rad.

        Raises:
            InputError: the rotary axis was not calibrated and stands elsewhere than it did.
        """
        position = _checked_position(stage_mm, stage_rad, self)
        return _pose_at(self.model, self.moved, position, float(stage_rad))

    def ball_covariance_mm2(self) -> Array:
        """(3, 3) covariance of `ball_in_measure_mm`; it was seen from the positions, so it may beat any other point.

        Raises:
            InputError: the fit has no covariance.
        """
        return propagated(
            self.model, self._known_covariance(), lambda model: _gauge(model, self.moved)[0] @ model.ball
        )

    def _known_covariance(self) -> Array:
        if self.model_covariance is None:
            raise InputError(
                "The stage fit has no covariance: give the noise of the ball centres or add observations.",
                Code.NO_REDUNDANCY,
            )
        return self.model_covariance

    def point_covariance_at(self, stage_mm: ArrayLike, stage_rad: float, point_in_scanner_mm: ArrayLike) -> Array:
        """(3, 3) covariance in mm^2 of a scanner point (3,) carried to {M}, from the calibration alone.

        Raises:
            InputError: as `measure_from_scanner_at`, or the fit has no covariance.
        """
        position = _checked_position(stage_mm, stage_rad, self)
        covariance = self._known_covariance()
        point = np.asarray(point_in_scanner_mm, dtype=float)

        def carried(model: StageModel) -> Array:
            pose = _pose_at(model, self.moved, position, float(stage_rad))
            return np.asarray(pose[:3, :3] @ point + pose[:3, 3])

        return propagated(self.model, covariance, carried)


def solve_stage(observations: StageObservations) -> StageFit:
    """One least squares over all ball observations (docs/steps/ball.md).

    The ball stands still in {M}: `ball = A q + c + Rot(axis, theta) (R0 p - c)`.

    Raises:
        InputError: shapes, NaN, units.
        FitError: too few or dependent positions, an axis not moved that is needed, unknowns not determined.
    """
    stage, angle, balls, sigma = checked_observations(observations)
    moved = np.ptp(stage, axis=0) > STILL_MM
    turns = bool(np.ptp(angle) > STILL_RAD)
    check_needed_axes(moved, turns)
    unknowns = 3 + 3 * int(moved.sum()) + (4 if turns else 0)
    needed = -(-unknowns // 3)
    if len(stage) < needed:
        raise FitError(
            f"Stage: found {len(stage)} ball observations, at least {needed} are needed for the axes that were moved "
            f"({moved_names(moved, turns)}). Add positions.",
            Code.NOT_ENOUGH_POINTS,
        )
    check_independent(stage, moved)
    weights = np.ones(len(stage)) if sigma is None else 1.0 / sigma
    model, iterations, converged = solve_model(stage[:, moved], angle, balls, weights, rotary=turns)
    jacobian = (model.jacobian(stage[:, moved], angle) * weights[:, None, None]).reshape(-1, unknowns)
    conditioning = _check_determined(jacobian, moved, turns)
    residuals = balls - model.predicted(stage[:, moved], angle)
    redundancy = 3 * len(stage) - unknowns
    whitened = (residuals * weights[:, None]).ravel()
    estimated = float(np.sqrt(whitened @ whitened / redundancy)) if redundancy else None
    factor = 1.0 if sigma is not None else None if estimated is None else estimated**2
    inverse: Array = np.asarray(np.linalg.pinv(jacobian, rcond=1e-12), dtype=float)
    covariance = None if factor is None else factor * inverse @ inverse.T
    raw_sigma = float(np.sqrt(np.sum(residuals**2) / redundancy)) if redundancy else None
    leave_one_out, drops = _leave_one_out(jacobian, inverse, residuals, weights)
    reference = 0.0 if turns else float(np.mean(angle))
    return _described(
        model, covariance, moved, reference,
        residuals=residuals,
        leave_one_out=leave_one_out, outlier=odd_one_out(drops, float(whitened @ whitened), redundancy),
        sigma=raw_sigma, redundancy=redundancy, conditioning=conditioning, iterations=iterations, converged=converged,
    )  # fmt: skip


def _check_determined(jacobian: Array, moved: Mask, turns: bool) -> Conditioning:
    names = ["ball x", "ball y", "ball z"]
    for axis in np.flatnonzero(moved):
        names += [f"axis {AXIS_NAMES[axis]} along scanner {side}" for side in AXIS_NAMES]
    names += ["rotary tilt 1", "rotary tilt 2", "rotary shift 1", "rotary shift 2"] if turns else []
    size = np.linalg.norm(jacobian, axis=0)
    if (size > 0.0).all():
        values = np.linalg.svd(jacobian / size, compute_uv=False)
        if values[-1] > LEAST_RATIO * values[0]:
            return analyse(jacobian.T @ jacobian, 1.0 / size, names)
    advice = " The rotary axis needs at least three angles, or two with a linear move at each." if turns else ""
    raise FitError(
        f"Stage: the positions do not determine the axes {moved_names(moved, turns)}.{advice} Add positions.",
        Code.NOT_ENOUGH_VARIATION,
    )


def _leave_one_out(jacobian: Array, inverse: Array, residuals: Array, weights: Array) -> tuple[Array, Array]:
    """Residual of each observation against the fit of the others, (I - H_ii)^-1 r_i with the hat matrix H, as a length.

    Also by how much the weighted squares fall without it; NaN and 0 where the others do not determine it.
    """
    count = len(residuals)
    out, drops = np.full(count, np.nan), np.zeros(count)
    for i in range(count):
        rows = slice(3 * i, 3 * i + 3)
        left = np.eye(3) - jacobian[rows] @ inverse[:, rows]
        if np.linalg.eigvalsh(0.5 * (left + left.T))[0] > 1e-6:
            white = residuals[i] * weights[i]
            missed = np.linalg.solve(left, white)
            out[i], drops[i] = np.linalg.norm(missed) / weights[i], missed @ white
    return out, drops


def _gauge(model: StageModel, moved: Mask) -> tuple[Array, Array]:
    """(R0 = rotation of M from S0, A in M with an assumed third column if z was not moved)."""
    axes = model.axes
    x = axes[:, 0] / np.linalg.norm(axes[:, 0])
    z = np.cross(x, axes[:, 1])
    z /= np.linalg.norm(z)
    rotation = np.array([x, np.cross(z, x), z])
    full = np.eye(3)
    full[:, moved] = rotation @ axes
    return rotation, full


def _pose_at(model: StageModel, moved: Mask, position: Array, angle: float) -> Array:
    rotation, full = _gauge(model, moved)
    if model.rotary is None or model.point is None:
        return rigid(rotation, full @ position)
    turn = rotation_from_rotvec(angle * (rotation @ model.rotary))
    center = rotation @ model.point
    return rigid(turn @ rotation, full @ position + center - turn @ center)


def _checked_position(stage_mm: ArrayLike, stage_rad: float, fit: StageFit) -> Array:
    position = np.asarray(stage_mm, dtype=float)
    if position.shape != (3,) or not np.isfinite(position).all() or not np.isfinite(stage_rad):
        raise InputError("Stage position: expected three finite numbers in mm and an angle in rad.")
    if fit.rotary_axis is None and abs(stage_rad - fit.rotary_reference_rad) > STILL_RAD:
        raise InputError(
            f"The rotary axis stands at {stage_rad:.5g} rad but was calibrated at {fit.rotary_reference_rad:.5g} rad "
            "only. Turn it back, or calibrate with the rotary axis moved."
        )
    return position


def propagated(model: StageModel, covariance: Array, function: Callable[[StageModel], Array]) -> Array:
    """Covariance of a smooth function of the model by central differences, a tenth of a sigma wide."""
    steps = 0.1 * np.sqrt(np.maximum(np.diag(covariance), 1e-24))
    columns = []
    for index, width in enumerate(steps):
        step = np.zeros(len(steps))
        step[index] = width
        columns.append((function(model.moved(step)) - function(model.moved(-step))) / (2.0 * width))
    jacobian = np.column_stack(columns)
    return np.asarray(jacobian @ covariance @ jacobian.T)


def _squareness(model: StageModel, moved: Mask) -> Array:
    _, full = _gauge(model, moved)
    unit = full / np.linalg.norm(full, axis=0)
    pairs = ((0, 1), (1, 2), (2, 0))
    return np.array([np.arccos(np.clip(unit[:, i] @ unit[:, j], -1.0, 1.0)) - 0.5 * np.pi for i, j in pairs])


def _described(
    model: StageModel,
    covariance: Array | None,
    moved: Mask,
    reference: float,
    *,
    residuals: Array,
    leave_one_out: Array,
    outlier: int | None,
    sigma: float | None,
    redundancy: int,
    conditioning: Conditioning,
    iterations: int,
    converged: bool,
) -> StageFit:
    rotation, full = _gauge(model, moved)
    scale = np.linalg.norm(full, axis=0)
    axes = full / scale
    pose_covariance, squareness_sigma = None, None
    if covariance is not None:

        def turned(other: StageModel) -> Array:
            return np.concatenate([rotvec_from_rotation(_gauge(other, moved)[0] @ rotation.T), np.zeros(3)])

        pose_covariance = PoseCovariance(propagated(model, covariance, turned), np.zeros(3))
        of_squareness = propagated(model, covariance, lambda other: _squareness(other, moved))
        squareness_sigma = np.sqrt(np.diag(of_squareness))
    rotary = None
    if model.rotary is not None and model.point is not None:
        rotary = RotaryAxis(rotation @ model.rotary, rotation @ model.point)
    return StageFit(
        measure_from_scanner=rigid(rotation, np.zeros(3)),
        covariance=pose_covariance,
        axes=axes,
        scale=scale,
        assumed=tuple(name for name, is_moved in zip(AXIS_NAMES, moved, strict=True) if not is_moved),
        squareness_rad=_squareness(model, moved),
        squareness_sigma_rad=squareness_sigma,
        rotary_axis=rotary,
        rotary_reference_rad=reference,
        scanner_axis_angles_rad=np.arccos(np.clip(rotation[:, 2] @ axes, -1.0, 1.0)),
        ball_in_measure_mm=rotation @ model.ball,
        residuals_mm=residuals,
        rms_mm=float(np.sqrt(np.mean(np.sum(residuals**2, axis=1)))),
        leave_one_out_mm=leave_one_out,
        outlier=outlier,
        sigma_mm=sigma,
        redundancy=redundancy,
        conditioning=conditioning,
        iterations=iterations,
        converged=converged,
        model=model,
        model_covariance=covariance,
        moved=moved,
    )


def paper_axes(ball_in_scanner_mm: ArrayLike) -> Array:
    """The simple version from three balls: at the start, after a positive move of x, after one of y instead.

    x is the unit move, y the second one made orthogonal to it, z = x cross y; errors of the first axis are favoured and
    squareness is not seen. For comparison only.

    Args:
        ball_in_scanner_mm: (3, 3) ball centres, row by row.

    Returns:
        (3, 3) rotation part of measure_from_scanner.
    """
    start, after_x, after_y = np.asarray(ball_in_scanner_mm, dtype=float)
    x = (start - after_x) / np.linalg.norm(start - after_x)
    move = start - after_y
    y = move - x * (x @ move)
    y /= np.linalg.norm(y)
    return np.array([x, y, np.cross(x, y)])
