"""Which stage position would sharpen the stage's calibration most (A-optimality at the scans it will be used for)."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace
from itertools import product

import numpy as np
from numpy.typing import NDArray

from core.ball import StageFit
from core.ball.stage_checks import AXIS_NAMES, STILL_MM, STILL_RAD
from devices.cell_plan import CellPlan, ScannerPlan, ScanPose
from devices.interfaces import StagePosition

Array = NDArray[np.float64]
# Positions tried along each axis.
LINEAR_STEPS, ROTARY_STEPS = 7, 7
# The ball stays clear of the volume's edge by this much.
MARGIN_MM = 15.0
# A smaller share is not worth a scan.
LEAST_GAIN = 0.05


@dataclass(frozen=True, eq=False)
class StageAdvice:
    """The position that would help most.

    Attributes:
        pose: Where to scan; one of the planned poses while some are missing.
        planned: True if it is one of those.
        opens: Names of axes that have not moved yet and would move there; empty if all have.
        before_mm: Standard deviation of a scanned point in {M}, worst planned scan and direction, now; NaN if unknown.
        after_mm: The same with one more scan there.
    """

    pose: ScanPose
    planned: bool
    opens: tuple[str, ...]
    before_mm: float
    after_mm: float


def advise(fit: StageFit, plan: CellPlan, missing: Sequence[ScanPose], sigma_mm: float) -> StageAdvice | None:
    """The missing planned pose that helps most, or, with all of them there, the best position within the travel.

    One more ball seen with Jacobian J and noise S turns the covariance C into `C - C J^T (S + J C J^T)^-1 J C`. The
    gain is the fall of the mean variance of a point in the middle of the scanner's volume, carried to {M} at the stage
    positions of the planned base and blade scans (Pukelsheim, Optimal Design of Experiments, ch. 6).

    Args:
        fit: So far.
        plan: Travel, scanner and scans.
        missing: Planned poses without a scan.
        sigma_mm: Noise of each coordinate of a ball's centre.

    Returns:
        None if the fit has no covariance, or no position within the travel gains enough.
    """
    for pose in missing:
        opens = _opened(fit, pose.stage)
        if opens:
            return StageAdvice(pose, True, opens, float("nan"), float("nan"))
    if fit.model_covariance is None:
        return None
    design = _Design(fit, fit.model_covariance, sigma_mm, _targets(fit, plan))
    if missing:
        positions = [pose.stage for pose in missing]
    else:
        positions = _in_view(fit, plan.scanner, _grid(fit, plan))
    if not positions:
        return None
    gains = design.gains(positions)
    best = int(np.argmax(gains))
    if not missing and gains[best] < LEAST_GAIN:
        return None
    pose = missing[best] if missing else ScanPose("", plan.stage_step[0].base_from_flange, positions[best])
    return StageAdvice(pose, bool(missing), (), design.worst_sigma(None), design.worst_sigma(positions[best]))


def worst_point_sigma(fit: StageFit, plan: CellPlan) -> float:
    """Standard deviation (mm) of a scanned point in {M}, worst planned scan and direction; NaN without covariance."""
    if fit.model_covariance is None:
        return float("nan")
    return _Design(fit, fit.model_covariance, 1.0, _targets(fit, plan)).worst_sigma(None)


def _opened(fit: StageFit, position: StagePosition) -> tuple[str, ...]:
    there = (position.x_mm, position.y_mm, position.z_mm)
    names = [
        name for name, moved, value in zip(AXIS_NAMES, fit.moved, there, strict=True)
        if not moved and abs(value) > STILL_MM
    ]  # fmt: skip
    if fit.rotary_axis is None and abs(position.theta_rad - fit.rotary_reference_rad) > STILL_RAD:
        names.append("rotary")
    return tuple(names)


def _targets(fit: StageFit, plan: CellPlan) -> list[tuple[StagePosition, Array]]:
    """Stage position and scanner point (3,) of the scans that will stand on the result."""
    middle = np.array([0.0, 0.0, plan.scanner.working_distance_mm])
    poses = [pose.stage for pose in (*plan.fine_step, *plan.base_step)]
    usable = [position for position in poses if "rotary" not in _opened(fit, position)]
    return [(position, middle) for position in usable or [plan.stage_step[0].stage]]


def _grid(fit: StageFit, plan: CellPlan) -> list[StagePosition]:
    ranges = (plan.stage.x_mm, plan.stage.y_mm, plan.stage.z_mm)
    linear = [
        np.linspace(*travel, LINEAR_STEPS) if moved else np.zeros(1)
        for travel, moved in zip(ranges, fit.moved, strict=True)
    ]
    turn = np.array([fit.rotary_reference_rad])
    if fit.rotary_axis is not None:
        turn = np.linspace(*plan.stage.theta_rad, ROTARY_STEPS)
    return [StagePosition(*(float(value) for value in values)) for values in product(*linear, turn)]


def _rows(fit: StageFit, positions: Sequence[StagePosition]) -> tuple[Array, Array]:
    stage = np.array([[p.x_mm, p.y_mm, p.z_mm] for p in positions])
    return stage[:, fit.moved], np.array([p.theta_rad for p in positions])


def _in_view(fit: StageFit, scanner: ScannerPlan, positions: Sequence[StagePosition]) -> list[StagePosition]:
    ball = fit.model.predicted(*_rows(fit, positions))
    half = 0.5 * np.array(scanner.field_mm) - MARGIN_MM
    inside = (np.abs(ball[:, :2]) <= half).all(axis=1)
    inside &= (ball[:, 2] >= scanner.near_mm + MARGIN_MM) & (ball[:, 2] <= scanner.far_mm - MARGIN_MM)
    return [positions[index] for index in np.flatnonzero(inside)]


class _Design:
    """The covariance of the model and how it carries over to points in {M}."""

    def __init__(
        self, fit: StageFit, covariance: Array, sigma_mm: float, targets: Sequence[tuple[StagePosition, Array]]
    ) -> None:
        self._fit = fit
        self._covariance = covariance
        self._noise = sigma_mm**2 * np.eye(3)
        self._carried = self._derivatives(targets)

    def _derivatives(self, targets: Sequence[tuple[StagePosition, Array]]) -> Array:
        """(T, 3, unknowns) derivative of each carried point by the model's unknowns, central differences."""
        steps = 0.1 * np.sqrt(np.maximum(np.diag(self._covariance), 1e-24))
        out = np.empty((len(targets), 3, len(steps)))
        for index, width in enumerate(steps):
            step = np.zeros(len(steps))
            step[index] = width
            ahead, behind = (replace(self._fit, model=self._fit.model.moved(sign * step)) for sign in (1.0, -1.0))
            for row, (position, point) in enumerate(targets):
                out[row, :, index] = (_carry(ahead, position, point) - _carry(behind, position, point)) / (2.0 * width)
        return out

    def _known(self, positions: Sequence[StagePosition]) -> tuple[Array, Array]:
        """(K, 3, unknowns) J C and (K, 3, 3) S + J C J^T of one more scan at each position."""
        jacobian = self._fit.model.jacobian(*_rows(self._fit, positions))
        known = jacobian @ self._covariance
        return known, self._noise + known @ np.swapaxes(jacobian, 1, 2)

    def gains(self, positions: Sequence[StagePosition]) -> Array:
        """(K,) share, 0 to 1, by which the mean variance of the carried points would fall."""
        known, innovation = self._known(positions)
        spread = np.einsum("tip,tiq->pq", self._carried, self._carried)
        less = np.einsum("kap,pq,kbq->kab", known, spread, known)
        fall = np.einsum("kab,kba->k", np.linalg.inv(innovation), less)
        return np.asarray(fall / float(np.sum(spread * self._covariance)))

    def worst_sigma(self, position: StagePosition | None) -> float:
        """Largest standard deviation of a carried point, with one more scan if a position is given."""
        covariance = self._covariance
        if position is not None:
            known, innovation = self._known([position])
            covariance = covariance - known[0].T @ np.linalg.solve(innovation[0], known[0])
        carried = self._carried @ covariance @ np.swapaxes(self._carried, 1, 2)
        return float(np.sqrt(max(np.linalg.eigvalsh(carried).max(), 0.0)))


def _carry(fit: StageFit, position: StagePosition, point: Array) -> Array:
    pose = fit.measure_from_scanner_at([position.x_mm, position.y_mm, position.z_mm], position.theta_rad)
    return np.asarray(pose[:3, :3] @ point + pose[:3, 3])
