"""Refuses base observations that cannot give an answer, and says which habit or slip makes them so."""

from __future__ import annotations

import numpy as np
from numpy.typing import ArrayLike, NDArray

from core.base.start import Start, global_start
from core.conditioning import direction_text
from core.errors import FitError, InputError
from core.flange_poses import METRES_BELOW_MM, angles_between, checked_flange_poses, pose_groups
from core.frames import inverse
from core.verdict import Code

Array = NDArray[np.float64]

MIN_POSES = 4
_MIN_SPREAD_MM = 2.0
# RMS change of orientation below which the ball offset is not seen: 0.1 mm of robot error makes 50 mm of offset.
_MIN_TURN = 2e-3
_COLLINEAR = 1e-3
# Above this share of the spread of the balls, poses and balls do not belong together.
_WRONG_MODEL_SHARE = 0.05
# A slip explains the data if it leaves less than this share of the RMS.
_EXPLAINED = 0.2


def checked_observations(base_from_flange: ArrayLike, ball_in_measure_mm: ArrayLike) -> tuple[Array, Array]:
    """Validate shapes, numbers, rigid transforms and units.

    Returns:
        (N, 4, 4) and (N, 3) float64.

    Raises:
        InputError: with the observation's index (from 0) and what to do.
    """
    try:
        balls = np.asarray(ball_in_measure_mm, dtype=float)
    except (TypeError, ValueError) as error:
        raise InputError("ball_in_measure_mm: expected N points of three numbers.") from error
    if balls.ndim != 2 or balls.shape[1] != 3:
        raise InputError(f"ball_in_measure_mm: expected N points of three numbers, found shape {balls.shape}.")
    poses = checked_flange_poses(base_from_flange)
    if len(poses) != len(balls):
        raise InputError(
            f"{len(poses)} flange poses but {len(balls)} ball centres: each observation needs one of each."
        )
    bad = np.flatnonzero(~np.all(np.isfinite(balls), axis=1))
    if len(bad):
        raise InputError(
            f"observations[{bad[0]}].ball_in_measure_mm: NaN or infinite number. Scan the ball again in that pose."
        )
    different = len(np.unique(pose_groups(poses)))
    if different < MIN_POSES:
        repeats = f" ({len(poses)} observations, repeats count once)" if len(poses) >= MIN_POSES else ""
        if len(poses) >= MIN_POSES and different == 1:
            raise FitError(
                f"All {len(poses)} observations are at the same flange pose: the robot has not moved. "
                "Move the ball to at least 4 different places, two of them tilted.",
                Code.NOT_ENOUGH_VARIATION,
            )
        raise FitError(
            f"Found {different} different flange poses{repeats}, at least {MIN_POSES} are needed, 6 or more are "
            "better. Add poses with the flange tilted by 5 deg or more.",
            Code.NOT_ENOUGH_POINTS,
        )
    return poses, balls


def check_variation(poses: Array, balls: Array) -> None:
    """Refuse observations whose geometry leaves something free, in words.

    Args:
        poses: (N, 4, 4) base_from_flange.
        balls: (N, 3) in M, mm.

    Raises:
        InputError: the balls are in metres.
        FitError: NOT_ENOUGH_VARIATION, naming what is free.
    """
    spread = np.linalg.norm(np.ptp(balls, axis=0))
    moved = np.linalg.norm(np.ptp(poses[:, :3, 3], axis=0))
    if spread < _MIN_SPREAD_MM:
        if spread > 1e-4 * moved and spread > 0.01 and np.abs(balls).max() < METRES_BELOW_MM:
            raise InputError(
                f"ball_in_measure_mm: the balls are spread over only {spread:.3g} while the flange moved {moved:.4g} "
                "mm. That looks like metres; ball centres must be in mm."
            )
        raise FitError(
            f"The ball hardly moved in the measuring frame ({spread:.3g} mm in all): the rotation of that frame is "
            "free. Move the ball by 50 mm or more between poses.",
            Code.NOT_ENOUGH_VARIATION,
        )
    _check_turns(poses[:, :3, :3])
    values, directions = np.linalg.svd(balls - balls.mean(axis=0))[1:]
    if values[1] < _COLLINEAR * values[0]:
        raise FitError(
            f"The ball centres lie on one line, along {direction_text(directions[0])} in the measuring frame: the "
            "rotation about that line is free. Add poses to the side of it.",
            Code.NOT_ENOUGH_VARIATION,
        )


def _check_turns(turns: Array) -> None:
    largest = float(angles_between(turns, turns[0]).max())
    centred = (turns - turns.mean(axis=0)).reshape(-1, 3)
    values, directions = np.linalg.svd(centred)[1:]
    values = values / np.sqrt(len(turns))
    if values[1] < _MIN_TURN:
        raise FitError(
            f"The flange orientation never changes (largest difference {np.degrees(largest):.2g} deg): the ball's "
            "offset on the flange and the translation of the measuring frame cannot be told apart. Add at least two "
            "poses tilted by 5 deg or more, about different axes.",
            Code.NOT_ENOUGH_VARIATION,
        )
    if values[2] < _MIN_TURN:
        in_flange, in_base = direction_text(directions[2]), direction_text(turns.mean(axis=0) @ directions[2])
        raise FitError(
            f"The flange turns about one axis only, {in_flange} in the flange frame: the ball's offset along it and "
            f"the translation of the measuring frame along {in_base} in the base frame cannot "
            "be told apart. Add poses tilted by 5 deg or more about another axis.",
            Code.NOT_ENOUGH_VARIATION,
        )


def check_start(start: Start, poses: Array, balls: Array) -> None:
    """Refuse data that no rigid answer explains, and name the usual slip if one does.

    Raises:
        InputError: mirrored ball coordinates, inverted or transposed flange poses.
        FitError: WRONG_MODEL or NOT_ENOUGH_VARIATION (two different answers fit equally well).
    """
    spread = float(np.sqrt(np.mean(np.sum((balls - balls.mean(axis=0)) ** 2, axis=1))))
    if start.rms_mm > 0.01 * spread:
        _name_the_slip(start.rms_mm, spread, poses, balls)
    if start.rms_mm > _WRONG_MODEL_SHARE * spread:
        raise FitError(
            f"The flange poses and the ball centres do not belong together: the best fit leaves {start.rms_mm:.3g} mm "
            f"RMS on balls spread over {spread:.4g} mm.{_worst(start.rms_mm, poses, balls)} Check their order and that "
            "the ball did not shift on the flange.",
            Code.WRONG_MODEL,
        )
    if start.rival_rms_mm < 2.0 * start.rms_mm + 1e-6 * spread:
        raise FitError(
            f"Two different answers fit these {len(poses)} poses about equally well ({start.rms_mm:.3g} and "
            f"{start.rival_rms_mm:.3g} mm RMS). Add poses tilted by 5 deg or more about other axes.",
            Code.NOT_ENOUGH_VARIATION,
        )


def _name_the_slip(rms: float, spread: float, poses: Array, balls: Array) -> None:
    transposed = poses.copy()
    transposed[:, :3, :3] = np.swapaxes(poses[:, :3, :3], 1, 2)
    slips = [
        (
            "The ball coordinates look mirrored (left-handed): with one axis reversed they fit. Check the signs of the "
            "scanner's and the stage's axes.",
            poses,
            -balls,
        ),
        (
            "The flange poses look inverted (flange_from_base): their inverses fit. Give base_from_flange.",
            inverse(poses),
            balls,
        ),
        (
            "The rotations of the flange poses look transposed: their transposes fit. Check the order of the matrix.",
            transposed,
            balls,
        ),
    ]
    rests = [global_start(p, b).rms_mm for _, p, b in slips]
    best = int(np.argmin(rests))
    if rests[best] < min(_EXPLAINED * rms, 0.01 * spread):
        raise InputError(f"{slips[best][0]} As given, the best fit leaves {rms:.3g} mm RMS.", Code.WRONG_MODEL)


def _worst(rms: float, poses: Array, balls: Array) -> str:
    if len(poses) <= MIN_POSES:
        return ""
    rest = [global_start(np.delete(poses, i, axis=0), np.delete(balls, i, axis=0)).rms_mm for i in range(len(poses))]
    worst = int(np.argmin(rest))
    if rest[worst] > _EXPLAINED * rms:
        return ""
    return f" Without observation {worst} (counted from 0) it would be {rest[worst]:.3g} mm: look at that one first."
