"""Refuses stage observations that cannot give the axes, in words."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from core.errors import FitError, InputError
from core.verdict import Code

Array = NDArray[np.float64]
Mask = NDArray[np.bool_]

AXIS_NAMES = ("x", "y", "z")
# Less travel than this, or less rotation, is a stage standing still.
STILL_MM = 1e-3
STILL_RAD = 1e-4
# Moved axes whose positions follow each other closer than this (singular-value ratio) are not told apart.
LEAST_INDEPENDENCE = 1e-3
# No 3D scanner sees a ball that near; distances in metres have such numbers.
NEAREST_BALL_MM = 10.0


@dataclass(frozen=True)
class StageObservations:
    """Ball centres seen from several stage positions.

    Attributes:
        stage_mm: (N, 3) positions of the linear axes x, y, z in mm.
        stage_rad: (N,) position of the rotary axis in rad.
        ball_in_scanner_mm: (N, 3) ball centre in the scanner's frame.
        sigma_mm: (N,) standard deviation of each coordinate of a centre, None if unknown.
    """

    stage_mm: Array
    stage_rad: Array
    ball_in_scanner_mm: Array
    sigma_mm: Array | None = None


def checked_observations(observations: StageObservations) -> tuple[Array, Array, Array, Array | None]:
    """Stage (N, 3) mm, angle (N,) rad, balls (N, 3) mm and sigma (N,) mm if given.

    Raises:
        InputError: shapes, NaN, degrees, metres.
    """
    stage = np.asarray(observations.stage_mm, dtype=float)
    angle = np.asarray(observations.stage_rad, dtype=float)
    balls = np.asarray(observations.ball_in_scanner_mm, dtype=float)
    count = len(stage) if stage.ndim else 0
    if stage.shape != (count, 3) or angle.shape != (count,) or balls.shape != (count, 3):
        raise InputError(
            f"Stage observations: expected positions (N, 3), angles (N,) and balls (N, 3), found {stage.shape}, "
            f"{angle.shape} and {balls.shape}."
        )
    if count == 0:
        raise InputError("Stage observations: there are none.", Code.NOT_ENOUGH_POINTS)
    sigma = None if observations.sigma_mm is None else np.asarray(observations.sigma_mm, dtype=float)
    bad = ~(np.isfinite(stage).all(axis=1) & np.isfinite(angle) & np.isfinite(balls).all(axis=1))
    if bad.any():
        raise InputError(f"Stage observation {int(np.argmax(bad))}: contains NaN or infinite numbers.")
    if sigma is not None and (sigma.shape != (count,) or not (np.isfinite(sigma) & (sigma > 0.0)).all()):
        raise InputError("Stage observations: expected one positive sigma in mm for each observation.")
    if np.abs(angle).max() > 4.0 * np.pi:
        worst = int(np.argmax(np.abs(angle)))
        raise InputError(
            f"Stage observation {worst}: the rotary angle is {angle[worst]:.4g} where rad are expected (more than two "
            "turns). It looks like degrees."
        )
    farthest = float(np.abs(balls).max())
    if farthest < NEAREST_BALL_MM:
        raise InputError(
            f"ball_in_scanner_mm: no ball has a coordinate above {farthest:.3g}, expected a working distance in mm. "
            "The ball centres look like metres."
        )
    travel, seen = float(np.linalg.norm(np.ptp(stage, axis=0))), float(np.linalg.norm(np.ptp(balls, axis=0)))
    still = np.ptp(angle) <= STILL_RAD
    if travel > STILL_MM and still and max(travel, seen) > 100.0 * min(travel, seen) and seen > 0.0:
        which = "ball centres" if seen < travel else "stage positions"
        raise InputError(
            f"Stage observations: the stage moved over {travel:.4g} and the ball centres over {seen:.4g}, both "
            f"expected in mm and about equal. The {which} look like metres."
        )
    return stage, angle, balls, sigma


def moved_names(moved: Mask, turns: bool) -> str:
    """The axes that were moved, for a message."""
    names = [name for name, is_moved in zip(AXIS_NAMES, moved, strict=True) if is_moved]
    return ", ".join([*names, "rotary"] if turns else names)


def check_needed_axes(moved: Mask, turns: bool) -> None:
    """Axes x and y must have moved.

    Raises:
        FitError: names the axis.
    """
    if not moved.any() and not turns:
        raise FitError(
            "Stage: it stood still in all observations. Move axes x and y (and z) between the scans of the ball.",
            Code.NOT_ENOUGH_VARIATION,
        )
    for axis in (0, 1):
        if not moved[axis]:
            raise FitError(
                f"Stage: axis {AXIS_NAMES[axis]} was not moved, its direction is unknown. Add a scan of the ball with "
                f"axis {AXIS_NAMES[axis]} moved.",
                Code.NOT_ENOUGH_VARIATION,
            )


def check_independent(stage: Array, moved: Mask) -> None:
    """The axes that moved must not have moved together only.

    Raises:
        FitError: names the axes.
    """
    travel = stage[:, moved] - stage[:, moved].mean(axis=0)
    travel /= np.linalg.norm(travel, axis=0)
    values = np.linalg.svd(travel, compute_uv=False)
    if len(stage) <= travel.shape[1] or values[-1] < LEAST_INDEPENDENCE * values[0]:
        raise FitError(
            f"Stage: the axes {moved_names(moved, False)} were only moved together (their positions lie on one line "
            "or plane), so that their directions cannot be told apart. Add positions where each moves alone.",
            Code.NOT_ENOUGH_VARIATION,
        )
