"""What a commissioning engineer knows about a cell before it is calibrated: sizes, taught poses, nominal places.

A cell file is TOML; lengths in mm, angles in degrees, poses as translation and intrinsic ZYX angles.
"""

from __future__ import annotations

import math
import tomllib
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray
from scipy.spatial.transform import Rotation

from devices.interfaces.stage import StagePosition

Array = NDArray[np.float64]


@dataclass(frozen=True, eq=False)
class ScannerPlan:
    """The scanner's measuring volume; mm."""

    working_distance_mm: float
    field_mm: tuple[float, float]
    spacing_mm: float
    near_mm: float
    far_mm: float
    baseline_mm: tuple[float, float, float]


@dataclass(frozen=True)
class StagePlan:
    """Travel of the stage: (low, high) of each axis, and its speeds."""

    x_mm: tuple[float, float]
    y_mm: tuple[float, float]
    z_mm: tuple[float, float]
    theta_rad: tuple[float, float]
    speed_mm_s: float
    speed_rad_s: float


@dataclass(frozen=True, eq=False)
class RobotPlan:
    """The robot: where it stands at first, and its speeds."""

    home_rad: Array
    speed_mm_s: float
    joint_speed_rad_s: float


@dataclass(frozen=True, eq=False)
class BallPlan:
    """The certified ball and roughly where its centre is on the flange."""

    diameter_mm: float
    nominal_in_flange_mm: Array


@dataclass(frozen=True, eq=False)
class ScanPose:
    """One scan: where the flange and where the stage shall be.

    Attributes:
        name: What is seen from there.
        base_from_flange: (4, 4) taught pose.
        stage: Where the stage shall stand.
    """

    name: str
    base_from_flange: Array
    stage: StagePosition


@dataclass(frozen=True, eq=False)
class StylusPlan:
    """The fixed cone and the taught touching poses.

    Attributes:
        nominal_tip_in_flange_mm: (3,) roughly.
        cone_in_base_mm: (3,) roughly.
        touches: (4, 4) each, base_from_flange roughly.
    """

    nominal_tip_in_flange_mm: Array
    cone_in_base_mm: Array
    touches: tuple[Array, ...]


@dataclass(frozen=True, eq=False)
class GrinderPlan:
    """One belt grinder as its drawing shows it.

    {H}: origin in the wheel centre at head angle 0, z along the shaft and the head axis, x from the head axis to the
    wheel centre, y = z x x, the way of the wheel at a positive turn of the head.

    Attributes:
        name: `rough` or `fine`.
        base_from_tool: (4, 4) nominal.
        head_radius_mm: Rg, head axis to wheel axis.
        wheel_radius_mm: Largest radius of the contact wheel.
        crown_radius_mm: Radius of the wheel's cross-section (a torus).
        wheel_width_mm: Width of the belt on the wheel.
        shaft_side_offset_mm: The shaft's touched centre mark is at (0, 0, this) in {H}.
        contact_side: +1: the blade's outward normal at the contact is +y_H, -1: it is -y_H. The contact point is
            K0 - wheel_radius * normal.
        touch_angles_rad: Head angles at which the shaft is touched, 0 first.
        touch_from_flange: (4, 4) base_from_flange nominal for touching at head angle 0.
        travel_rad: (low, high) of the head.
    """

    name: str
    base_from_tool: Array
    head_radius_mm: float
    wheel_radius_mm: float
    crown_radius_mm: float
    wheel_width_mm: float
    shaft_side_offset_mm: float
    contact_side: int
    touch_angles_rad: tuple[float, ...]
    touch_from_flange: Array
    travel_rad: tuple[float, float]


@dataclass(frozen=True, eq=False)
class CellPlan:
    """Everything about a cell that is known before calibration.

    Attributes:
        name: Of the cell.
        base_from_measure: (4, 4) nominal place of the stage.
        flange_from_work: (4, 4) nominal clamping where the blade type's own file says nothing.
        stage_step: Ball fixed, stage moves; all have the same base_from_flange.
        base_step: Robot and stage move, the ball stays in view.
        fine_step: Blade scans, all have the same base_from_flange.
    """

    name: str
    scanner: ScannerPlan
    stage: StagePlan
    robot: RobotPlan
    ball: BallPlan
    stylus: StylusPlan
    grinders: Mapping[str, GrinderPlan]
    base_from_measure: Array
    flange_from_work: Array
    stage_step: tuple[ScanPose, ...]
    base_step: tuple[ScanPose, ...]
    fine_step: tuple[ScanPose, ...]


class CellFileError(ValueError):
    """A cell file cannot be used; the message names the file and the field."""


def read_cell_file(path: Path) -> dict[str, Any]:
    """The content of a cell file.

    Raises:
        CellFileError: not readable as TOML.
    """
    try:
        return tomllib.loads(path.read_text(encoding="utf-8"))
    except (OSError, UnicodeDecodeError, tomllib.TOMLDecodeError) as error:
        raise CellFileError(f"{path}: cannot be read as a cell file: {error}") from error


def read_plan(path: Path) -> CellPlan:
    """Read a cell file; see `resources/cells/simulated.toml` for one to copy.

    Raises:
        CellFileError: not readable, or a field is missing or of the wrong kind.
    """
    return plan_from(read_cell_file(path), str(path))


def plan_from(data: Mapping[str, Any], source: str) -> CellPlan:
    """The plan in a cell file's content; `source` names it in messages."""
    try:
        return _plan(data)
    except KeyError as error:
        raise CellFileError(f"{source}: the field {error} is missing.") from error
    except (TypeError, ValueError) as error:
        raise CellFileError(f"{source}: {error}") from error


def _plan(data: Mapping[str, Any]) -> CellPlan:
    nominal = data["nominal"]
    stage_pose = _pose(data["stage_step"])
    fine_pose = _pose(data["fine_step"])
    return CellPlan(
        name=str(data["name"]),
        scanner=_scanner(data["scanner"]),
        stage=_stage(data["stage"]),
        robot=RobotPlan(
            np.deg2rad(_vector(data["robot"], "home_deg", 6)),
            float(data["robot"]["speed_mm_s"]),
            math.radians(data["robot"]["joint_speed_deg_s"]),
        ),
        ball=BallPlan(float(data["ball"]["diameter_mm"]), _vector(data["ball"], "nominal_in_flange_mm", 3)),
        stylus=StylusPlan(
            _vector(data["stylus"], "nominal_tip_in_flange_mm", 3),
            _vector(data["stylus"], "cone_in_base_mm", 3),
            tuple(_pose(entry) for entry in data["stylus"]["touches"]),
        ),
        grinders={str(entry["name"]): _grinder(entry) for entry in data["grinders"]},
        base_from_measure=_pose(nominal["base_from_measure"]),
        flange_from_work=_pose(nominal["flange_from_work"]),
        stage_step=tuple(
            ScanPose(f"stage {index}", stage_pose, _stage_position(row))
            for index, row in enumerate(data["stage_step"]["stage"], start=1)
        ),
        base_step=tuple(
            ScanPose(f"pose {index}", _pose(entry), _stage_position(entry["stage"]))
            for index, entry in enumerate(data["base_step"]["poses"], start=1)
        ),
        fine_step=tuple(
            ScanPose(str(entry["name"]), fine_pose, _stage_position(entry["stage"]))
            for entry in data["fine_step"]["scans"]
        ),
    )


def _scanner(entry: Mapping[str, Any]) -> ScannerPlan:
    width, height = _vector(entry, "field_mm", 2)
    x, y, z = _vector(entry, "baseline_mm", 3)
    return ScannerPlan(
        float(entry["working_distance_mm"]), (width, height), float(entry["spacing_mm"]),
        float(entry["near_mm"]), float(entry["far_mm"]), (x, y, z),
    )  # fmt: skip


def _stage(entry: Mapping[str, Any]) -> StagePlan:
    return StagePlan(
        _pair(entry, "x_mm"), _pair(entry, "y_mm"), _pair(entry, "z_mm"), _pair(entry, "theta_deg", math.pi / 180.0),
        float(entry["speed_mm_s"]), math.radians(entry["speed_deg_s"]),
    )  # fmt: skip


def _grinder(entry: Mapping[str, Any]) -> GrinderPlan:
    side = int(entry["contact_side"])
    if side not in (-1, 1):
        raise ValueError(f"grinder {entry['name']}: contact_side must be 1 or -1, found {side}.")
    return GrinderPlan(
        name=str(entry["name"]),
        base_from_tool=_pose(entry["base_from_tool"]),
        head_radius_mm=float(entry["head_radius_mm"]),
        wheel_radius_mm=float(entry["wheel_radius_mm"]),
        crown_radius_mm=float(entry["crown_radius_mm"]),
        wheel_width_mm=float(entry["wheel_width_mm"]),
        shaft_side_offset_mm=float(entry["shaft_side_offset_mm"]),
        contact_side=side,
        touch_angles_rad=tuple(math.radians(angle) for angle in entry["touch_angles_deg"]),
        touch_from_flange=_pose(entry["touch_base_from_flange"]),
        travel_rad=_pair(entry, "travel_deg", math.pi / 180.0),
    )


def _pose(entry: Mapping[str, Any]) -> Array:
    matrix = np.eye(4)
    matrix[:3, :3] = Rotation.from_euler("ZYX", _vector(entry, "euler_zyx_deg", 3), degrees=True).as_matrix()
    matrix[:3, 3] = _vector(entry, "translation_mm", 3)
    return matrix


def _stage_position(row: Sequence[float]) -> StagePosition:
    x, y, z, theta_deg = (float(value) for value in row)
    return StagePosition(x, y, z, math.radians(theta_deg))


def _vector(entry: Mapping[str, Any], key: str, size: int) -> Array:
    values = np.asarray(entry[key], dtype=float)
    if values.shape != (size,) or not np.isfinite(values).all():
        raise ValueError(f"{key}: expected {size} numbers, found {entry[key]}.")
    return values


def _pair(entry: Mapping[str, Any], key: str, factor: float = 1.0) -> tuple[float, float]:
    low, high = _vector(entry, key, 2)
    if not low < high:
        raise ValueError(f"{key}: the low end must be below the high end, found {entry[key]}.")
    return low * factor, high * factor
