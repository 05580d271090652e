"""What a step's record says that another one may contradict: poses, points and held-out errors, with their chance."""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from typing import Any

import numpy as np

from core.frames import Array, PoseCovariance, rotvec_from_rotation

COVERAGE = 2.0
ROUNDING = 1e-9


@dataclass(frozen=True, eq=False)
class Pose:
    """A frame's pose (4, 4), mm, named `a_from_b`."""

    name: str
    matrix: Array
    covariance: PoseCovariance | None


@dataclass(frozen=True, eq=False)
class Point:
    """A point (3,) in mm with its covariance (3, 3) in mm^2."""

    name: str
    position_mm: Array
    covariance_mm2: Array | None


@dataclass(frozen=True)
class Figure:
    """One number with its standard deviation."""

    name: str
    value: float
    unit: str
    sigma: float | None = None


@dataclass(frozen=True)
class Movement:
    """How far a pose (or a point, without degrees) is from what it was.

    Attributes:
        name: Of the pose.
        mm: Of the origin of b, in a.
        deg: Angle of the turn between the two.
        chance_mm: What both uncertainties allow (k = 2: twice the root of the trace), None where one is not known.
        chance_deg: The same for the turn.
    """

    name: str
    mm: float
    deg: float | None
    chance_mm: float | None
    chance_deg: float | None

    def beyond_chance(self) -> bool:
        """True unless the uncertainties explain the whole movement."""
        return _beyond(self.mm, self.chance_mm) or _beyond(self.deg, self.chance_deg)


def poses(step: str, record: Mapping[str, Any]) -> Iterator[Pose]:
    """The poses in a step's record."""
    if step == "ball":
        yield from _pose("measure_from_scanner", _at(record, "stage", "measure_from_scanner"))
    elif step == "base":
        yield from _pose("base_from_measure", _at(record, "base_from_measure"))
    elif step in ("rough", "fine"):
        yield from _pose("measure_from_work", _at(record, "measure_from_work"))
        yield from _pose("flange_from_work", _at(record, "flange_from_work"))
    elif step == "tool":
        for grinder, wheel in (_at(record, "wheels") or {}).items():
            yield from _pose(f"base_from_tool ({grinder})", _at(wheel, "base_from_tool"))


def points(step: str, record: Mapping[str, Any]) -> Iterator[Point]:
    """The points in a step's record."""
    if step == "tool":
        position = _array(_at(record, "stylus", "tip_in_flange_mm"), (3,))
        if position is not None:
            yield Point("tip_in_flange", position, _array(_at(record, "stylus", "tip_covariance_mm2"), (3, 3)))
    elif step == "base":
        position, sigma = _array(_at(record, "ball_in_flange_mm"), (3,)), _array(_at(record, "ball_sigma_mm"), (3,))
        if position is not None:
            yield Point("ball_in_flange", position, None if sigma is None else np.diag(sigma**2))


def figures(step: str, record: Mapping[str, Any]) -> Iterator[Figure]:
    """Held-out errors, and sizes that belong to the cell."""
    yield from _figure("held-out RMS", _at(record, "held_out", "rms_mm"))
    if step == "fine":
        halves = _at(record, "half_split_mm")
        if halves:
            yield from _figure("held-out, two halves", max((v for v in halves if v is not None), default=None))
    elif step == "tool":
        yield from _figure("held-out RMS (cone)", _at(record, "cone_held_out", "rms_mm"))
        for grinder, block in (_at(record, "shafts_held_out") or {}).items():
            yield from _figure(f"held-out RMS ({grinder})", _at(block, "rms_mm"))
        for grinder, wheel in (_at(record, "wheels") or {}).items():
            sigma = _at(wheel, "radius_sigma_mm")
            yield from _figure(f"head radius ({grinder})", _at(wheel, "radius_mm"), sigma)
    elif step == "error_surface":
        yield from _figure("leave-one-out RMS", _at(record, "leave_one_out_rms_mm"))


def movements(step: str, old: Mapping[str, Any], new: Mapping[str, Any]) -> list[Movement]:
    """How far each pose and point is from what it was, where both records have it."""
    found: list[Movement] = []
    poses_before = {pose.name: pose for pose in poses(step, old)}
    for pose in poses(step, new):
        if pose.name in poses_before:
            found.append(pose_moved(poses_before[pose.name], pose))
    points_before = {point.name: point for point in points(step, old)}
    for point in points(step, new):
        if point.name in points_before:
            found.append(point_moved(points_before[point.name], point))
    return found


def pose_moved(old: Pose, new: Pose) -> Movement:
    """From one pose to the other."""
    origin, new_origin = old.matrix[:3, 3], new.matrix[:3, 3]
    turn_rad = rotvec_from_rotation(new.matrix[:3, :3] @ old.matrix[:3, :3].T)
    chance_mm = chance_deg = None
    if old.covariance is not None and new.covariance is not None:
        of_origins = old.covariance.of_point(origin) + new.covariance.of_point(new_origin)
        chance_mm = _chance(of_origins)
        chance_rad = _chance(old.covariance.matrix[:3, :3] + new.covariance.matrix[:3, :3])
        chance_deg = math.degrees(chance_rad)
    turn_deg = math.degrees(float(np.linalg.norm(turn_rad)))
    return Movement(new.name, float(np.linalg.norm(new_origin - origin)), turn_deg, chance_mm, chance_deg)


def point_moved(old: Point, new: Point) -> Movement:
    """From one point to the other."""
    chance_mm = None
    if old.covariance_mm2 is not None and new.covariance_mm2 is not None:
        chance_mm = _chance(old.covariance_mm2 + new.covariance_mm2)
    return Movement(new.name, float(np.linalg.norm(new.position_mm - old.position_mm)), None, chance_mm, None)


def _chance(covariance: Array) -> float:
    """Length that a vector of this covariance (3, 3) hardly exceeds, whatever the covariance's shape."""
    return COVERAGE * math.sqrt(max(float(np.trace(covariance)), 0.0))


def _beyond(moved: float | None, chance: float | None) -> bool:
    return moved is not None and moved > max(chance or 0.0, ROUNDING)


def _pose(name: str, block: Any) -> Iterator[Pose]:
    matrix = _array(_at(block, "matrix"), (4, 4))
    if matrix is None:
        return
    covariance = _array(_at(block, "covariance"), (6, 6))
    about = _array(_at(block, "covariance_about_mm"), (3,))
    known = None if covariance is None or about is None else PoseCovariance(covariance, about)
    yield Pose(name, matrix, known)


def _figure(name: str, value: Any, sigma: Any = None) -> Iterator[Figure]:
    if value is not None:
        yield Figure(name, float(value), "mm", None if sigma is None else float(sigma))


def _at(record: Any, *keys: str) -> Any:
    """What lies under nested keys; None where a record does not have it."""
    for key in keys:
        if not isinstance(record, Mapping):
            return None
        record = record.get(key)
    return record


def _array(value: Any, shape: tuple[int, ...]) -> Array | None:
    """Finite numbers of the shape, otherwise None (a record has null for what was not determined)."""
    if value is None:
        return None
    array = np.asarray(value, dtype=float)
    return array if array.shape == shape and np.isfinite(array).all() else None
