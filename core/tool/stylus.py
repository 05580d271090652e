"""Stylus tip in the flange frame, from pivoting the tip in a fixed cone."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike, NDArray
from scipy.stats import f as fisher

from core.conditioning import Conditioning, analyse, direction_text
from core.errors import FitError, InputError
from core.flange_poses import angles_between, checked_flange_poses, pose_groups
from core.held_out import FALSE_ALARM, held_out_residuals, odd_one_out
from core.verdict import Code

Array = NDArray[np.float64]

MIN_POSES = 3
UNKNOWNS = 6
# RMS change of orientation about the weakest axis; below it 0.05 mm of touch noise is 2 mm of tip after six touches.
_MIN_TURN = 0.01
_LARGEST_REJECTED_SHARE = 0.25
# No stylus is longer, and no cone is nearer to the base than to the flange.
_LONGEST_STYLUS_MM = 600.0
# A tip less certain than this is no tip.
_HOPELESS_TIP_MM = 5.0
# With a given noise a touch has that noise, however few touches there are.
_MANY = 10**6


@dataclass(frozen=True)
class StylusFit:
    """Result of `solve_stylus`.

    Attributes:
        tip_in_flange_mm: (3,) stylus tip in F.
        pivot_in_base_mm: (3,) the cone in B.
        tip_covariance_mm2: (3, 3) of the tip, in F.
        pivot_covariance_mm2: (3, 3) of the pivot, in B.
        residuals_mm: (N, 3) in B: tip carried by the flange minus pivot, rejected touches too.
        rms_mm: RMS length of the residuals used.
        leave_one_out_mm: (N,) how far each touch misses a fit that has not seen its pose, in the directions that the
            others can predict; NaN where they predict none.
        unchecked_directions: (N,) number of directions, 0 to 3, in which the other poses cannot predict that touch.
        worst: Index of the touch used whose absence would lower the sum of squares most.
        outlier: Index of the touch used that the others contradict (F test of its deletion, 0.1 % per fit), or None.
        conditioning: of tip and pivot together.
        turn_rad: Largest angle between two flange orientations used.
        weakest_turn_rad: RMS change of orientation seen along the least determined direction of the tip.
        sigma_mm: Noise of a touch per axis, given or estimated.
        different_poses: Number of poses used, repeats counted once.
        used: (N,) false for touches that the robust fit rejected.
        iterations: Number of linear solves.
        converged: Always true: the problem is linear.
    """

    tip_in_flange_mm: Array
    pivot_in_base_mm: Array
    tip_covariance_mm2: Array
    pivot_covariance_mm2: Array
    residuals_mm: Array
    rms_mm: float
    leave_one_out_mm: Array
    unchecked_directions: NDArray[np.int64]
    worst: int
    outlier: int | None
    conditioning: Conditioning
    turn_rad: float
    weakest_turn_rad: float
    sigma_mm: float
    different_poses: int
    used: NDArray[np.bool_]
    iterations: int
    converged: bool


def solve_stylus(base_from_flange: ArrayLike, *, sigma_mm: float | None = None, robust: bool = False) -> StylusFit:
    """Pivot calibration: least squares of `R_i tip + t_i = pivot` in tip and pivot.

    Linear in the six unknowns, so there is one answer and no start. Repeats of one pose count once for redundancy.

    Args:
        base_from_flange: (N, 4, 4) rigid, mm, with the tip resting in the cone; N >= 3 different poses.
        sigma_mm: Noise of one touch per axis (robot repeatability and seat). Without it the scale of the covariance
            comes from the residuals.
        robust: Reject touches one after the other, at most a quarter, while the worst one's deletion residual is above
            its 0.1 % F quantile (Bonferroni over the touches; Cook & Weisberg 1982, sec. 2.2.2).

    Raises:
        InputError: unusable input (shape, not rigid, NaN, metres, inverted poses).
        FitError: too few poses, or orientations that leave a component of the tip free (names it).
    """
    if sigma_mm is not None and not (np.isfinite(sigma_mm) and sigma_mm > 0.0):
        raise InputError(f"sigma_mm: expected a number of mm above zero, found {sigma_mm}.")
    poses = checked_flange_poses(base_from_flange)
    used = np.ones(len(poses), dtype=bool)
    _check_variation(poses)
    linear = _solve(poses, used)
    solves = 1
    while robust and np.count_nonzero(~used) < int(_LARGEST_REJECTED_SHARE * len(poses)):
        if not _is_outlier(linear, used, sigma_mm):
            break
        used[linear.worst] = False
        _check_variation(poses[used])
        linear = _solve(poses, used)
        solves += 1
    fit = _report(poses, used, linear, sigma_mm, solves)
    _refuse_undetermined(fit)
    _check_inverted(linear)
    return fit


def _check_variation(poses: Array) -> None:
    different = len(np.unique(pose_groups(poses)))
    if different == 1 and len(poses) >= MIN_POSES:
        raise FitError(
            f"All {len(poses)} touches are at the same flange pose. Keep the tip in the cone and tilt the flange by 20 "
            "deg or more about different axes.",
            Code.NOT_ENOUGH_VARIATION,
        )
    if different < MIN_POSES:
        raise FitError(
            f"Found {different} different flange poses, at least {MIN_POSES} are needed, 6 or more are better. Keep "
            "the tip in the cone and tilt the flange further.",
            Code.NOT_ENOUGH_POINTS,
        )
    values, directions = _turn_spectrum(poses)
    largest = np.degrees(_largest_turn(poses))
    if values[1] < _MIN_TURN:
        raise FitError(
            f"The flange orientation changes by only {largest:.2g} deg: the tip cannot be told from the pivot. Tilt "
            "the flange by 20 deg or more about different axes.",
            Code.NOT_ENOUGH_VARIATION,
        )
    if values[2] < _MIN_TURN:
        in_flange = direction_text(directions[2])
        in_base = direction_text(poses[:, :3, :3].mean(axis=0) @ directions[2])
        raise FitError(
            f"The flange turns about one axis only, {in_flange} in the flange frame (by up to {largest:.3g} deg): "
            f"the tip's component along it, and the pivot's along {in_base} in the "
            "base frame, stay free. Add touches tilted by 20 deg or more about another axis.",
            Code.NOT_ENOUGH_VARIATION,
        )


def _turn_spectrum(poses: Array) -> tuple[Array, Array]:
    """Singular values of the centred orientations, as RMS turn in rad, and their directions in F (rows)."""
    centred = (poses[:, :3, :3] - poses[:, :3, :3].mean(axis=0)).reshape(-1, 3)
    _, values, directions = np.linalg.svd(centred)
    return np.asarray(values / np.sqrt(len(poses))), np.asarray(directions)


def _largest_turn(poses: Array) -> float:
    return max(float(angles_between(poses[:, :3, :3], turn).max()) for turn in poses[:, :3, :3])


@dataclass(frozen=True)
class _Linear:
    tip: Array
    pivot: Array
    jacobian: Array
    cofactor: Array
    residuals: Array
    squares: float
    drop: Array

    @property
    def worst(self) -> int:
        return int(np.argmax(self.drop))


def _solve(poses: Array, used: NDArray[np.bool_]) -> _Linear:
    jacobian = np.concatenate([poses[:, :3, :3], np.tile(-np.eye(3), (len(poses), 1, 1))], axis=2)
    # Taking the mean off keeps the digits: the base is far from the cone.
    origin = poses[used, :3, 3].mean(axis=0)
    target = origin - poses[:, :3, 3]
    rows = jacobian[used].reshape(-1, UNKNOWNS)
    unknowns = np.linalg.lstsq(rows, target[used].ravel(), rcond=None)[0]
    residuals = np.einsum("nij,j->ni", jacobian, unknowns) - target
    cofactor = np.asarray(np.linalg.inv(rows.T @ rows), dtype=float)
    squares = float(np.sum(residuals[used] ** 2))
    alone = np.arange(len(rows) // 3, dtype=np.int64)
    errors = held_out_residuals(jacobian[used], _identities(len(alone)), cofactor, residuals[used], alone)[0]
    # The sum of squares falls by e.r when a touch with residual r and held-out residual e is left out.
    drop = np.zeros(len(poses))
    drop[used] = np.nan_to_num(np.sum(errors * residuals[used], axis=1))
    return _Linear(unknowns[:3], unknowns[3:] + origin, jacobian, cofactor, residuals, squares, drop)


def _identities(n: int) -> Array:
    return np.tile(np.eye(3), (n, 1, 1))


def _is_outlier(linear: _Linear, used: NDArray[np.bool_], sigma_mm: float | None) -> bool:
    touches = int(np.count_nonzero(used))
    left = 3 * (touches - 1) - UNKNOWNS
    if left <= 0:
        return False
    drop = float(linear.drop[linear.worst])
    variance = sigma_mm**2 if sigma_mm is not None else (linear.squares - drop) / left
    quantile = fisher.isf(FALSE_ALARM / touches, 3, _MANY if sigma_mm is not None else left)
    return bool(drop > 3.0 * quantile * variance)


def _report(poses: Array, used: NDArray[np.bool_], linear: _Linear, sigma_mm: float | None, solves: int) -> StylusFit:
    n = int(np.count_nonzero(used))
    sigma = sigma_mm if sigma_mm is not None else float(np.sqrt(linear.squares / (3 * n - UNKNOWNS)))
    held_out = linear.residuals.copy()
    groups = pose_groups(poses[used])
    held_out[used], unpredicted = held_out_residuals(
        linear.jacobian[used], _identities(n), linear.cofactor, linear.residuals[used], groups
    )
    unchecked = np.zeros(len(poses), dtype=np.int64)
    unchecked[used] = unpredicted
    information = np.linalg.inv(linear.cofactor)
    names = [f"tip {a} in flange" for a in "xyz"] + [f"pivot {a} in base" for a in "xyz"]
    return StylusFit(
        tip_in_flange_mm=linear.tip,
        pivot_in_base_mm=linear.pivot,
        tip_covariance_mm2=sigma**2 * linear.cofactor[:3, :3],
        pivot_covariance_mm2=sigma**2 * linear.cofactor[3:, 3:],
        residuals_mm=linear.residuals,
        rms_mm=float(np.sqrt(linear.squares / n)),
        leave_one_out_mm=np.linalg.norm(held_out, axis=1),
        unchecked_directions=unchecked,
        worst=linear.worst,
        outlier=odd_one_out(linear.drop, linear.squares, 3 * n - UNKNOWNS),
        conditioning=analyse(information, [1.0] * UNKNOWNS, names),
        turn_rad=_largest_turn(poses[used]),
        weakest_turn_rad=float(_turn_spectrum(poses[used])[0][2]),
        sigma_mm=sigma,
        different_poses=len(np.unique(groups)),
        used=used,
        iterations=solves,
        converged=True,
    )


def _check_inverted(linear: _Linear) -> None:
    """Inverted poses satisfy the same equation with tip and pivot swapped; only their lengths tell."""
    tip, pivot = float(np.linalg.norm(linear.tip)), float(np.linalg.norm(linear.pivot))
    if tip > max(_LONGEST_STYLUS_MM, pivot):
        raise InputError(
            f"The flange poses look inverted (flange_from_base): the tip comes out {tip:.0f} mm from the flange and "
            f"the pivot {pivot:.0f} mm from the base. Give base_from_flange.",
            Code.WRONG_MODEL,
        )


def _refuse_undetermined(fit: StylusFit) -> None:
    variances, directions = np.linalg.eigh(fit.tip_covariance_mm2)
    sigma = float(np.sqrt(variances[-1]))
    if sigma > _HOPELESS_TIP_MM:
        raise FitError(
            f"The touches do not determine the tip along {direction_text(directions[:, -1])} in the flange frame: "
            f"standard deviation {sigma:.3g} mm. Tilt the flange further about the axes across it, and check touch "
            f"{fit.worst} (counted from 0) first.",
            Code.NOT_ENOUGH_VARIATION,
        )
