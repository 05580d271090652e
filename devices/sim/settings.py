"""How imperfect the simulated cell is: the `[truth]` part of a cell file, which no calibration step may read."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, fields
from typing import Any

from devices.cell_plan import CellFileError


@dataclass(frozen=True)
class MeasureTruth:
    """How far the stage stands from its nominal place."""

    shift_mm: float
    tilt_deg: float


@dataclass(frozen=True)
class StageTruth:
    """Errors of the stage's axes and of the scanner's mounting on it.

    `rotary_point_mm` is a point of the rotary axis in {M}, nominally along y.
    """

    squareness_deg: float
    scale: float
    rotary_point_mm: tuple[float, float, float]
    rotary_tilt_deg: float
    scanner_tilt_deg: float
    repeatability_mm: float
    repeatability_deg: float


@dataclass(frozen=True)
class RobotTruth:
    """Absolute error (RMS of the flange origin over the workspace), repeatability per axis, settling."""

    absolute_rms_mm: float
    repeatability_mm: float
    repeatability_deg: float
    settle_s: float


@dataclass(frozen=True)
class ScannerTruth:
    """Noise along the ray and what a structured-light scanner does at edges, at grazing angles and on glare."""

    noise_mm: float
    noise_growth: float
    random_dropout: float
    dropout_start_deg: float
    dropout_end_deg: float
    patches: float
    patch_mm: float
    ghost_share: float
    ghost_jump_mm: float
    capture_s: float


@dataclass(frozen=True)
class MountTruth:
    """How far ball, stylus tip and cone are from their nominal places."""

    ball_shift_mm: float
    stylus_shift_mm: float
    cone_shift_mm: float


@dataclass(frozen=True)
class BladeTruth:
    """Clamping errors, drawn anew for each clamping, and the error of the airfoil against the datum faces, frame W."""

    clamp_shift_mm: float
    clamp_tilt_deg: float
    shape_error_mm: float
    airfoil_shift_mm: tuple[float, float, float]


@dataclass(frozen=True)
class GrinderTruth:
    """Place of the grinders against their drawing; sensors; bounced and lost samples."""

    shift_mm: float
    tilt_deg: float
    angle_bits: int
    angle_noise_deg: float
    force_rest_n: float
    force_n_per_rad: float
    force_noise_n: float
    bounce_share: float
    bounce_low_mm: float
    bounce_high_mm: float
    lost_share: float


@dataclass(frozen=True)
class OperatorTruth:
    """How well a person touches and turns."""

    touch_mm: float
    hand_tilt_deg: float
    head_angle_deg: float
    action_s: float


@dataclass(frozen=True)
class TruthSettings:
    """All magnitudes of imperfection of the simulated cell."""

    measure: MeasureTruth
    stage: StageTruth
    robot: RobotTruth
    scanner: ScannerTruth
    mount: MountTruth
    blade: BladeTruth
    grinder: GrinderTruth
    operator: OperatorTruth


_PARTS: dict[str, type] = {
    "measure": MeasureTruth,
    "stage": StageTruth,
    "robot": RobotTruth,
    "scanner": ScannerTruth,
    "mount": MountTruth,
    "blade": BladeTruth,
    "grinder": GrinderTruth,
    "operator": OperatorTruth,
}


def truth_settings(data: Mapping[str, Any], source: str, overrides: Mapping[str, Any]) -> TruthSettings:
    """Read the `[truth]` part of a cell file.

    Args:
        data: The whole content of the cell file.
        source: Its name, for messages.
        overrides: Values to use instead, by dotted name: `{"scanner.noise_mm": 0.0}`.

    Raises:
        CellFileError: a field is missing or unknown, or an override names nothing.
    """
    parts: dict[str, Any] = {}
    unused = dict(overrides)
    for name, kind in _PARTS.items():
        section = dict(data.get("truth", {}).get(name, {}))
        for field in fields(kind):
            if f"{name}.{field.name}" in unused:
                section[field.name] = unused.pop(f"{name}.{field.name}")
        expected = {field.name for field in fields(kind)}
        if set(section) != expected:
            wrong = ", ".join(sorted(set(section) ^ expected))
            raise CellFileError(f"{source}: [truth.{name}] lacks or does not know: {wrong}.")
        values = {key: tuple(value) if isinstance(value, list) else value for key, value in section.items()}
        parts[name] = kind(**values)
    if unused:
        raise CellFileError(f"{source}: no such truth setting: {', '.join(sorted(unused))}.")
    return TruthSettings(**parts)


def perfect() -> dict[str, Any]:
    """Overrides that switch every random disturbance off; the unknown places and the airfoil's error stay."""
    return {
        "stage.repeatability_mm": 0.0,
        "stage.repeatability_deg": 0.0,
        "robot.repeatability_mm": 0.0,
        "robot.repeatability_deg": 0.0,
        "scanner.noise_mm": 0.0,
        "scanner.random_dropout": 0.0,
        "scanner.patches": 0.0,
        "scanner.ghost_share": 0.0,
        "grinder.angle_noise_deg": 0.0,
        "grinder.force_noise_n": 0.0,
        "grinder.bounce_share": 0.0,
        "grinder.lost_share": 0.0,
        "operator.touch_mm": 0.0,
        "operator.head_angle_deg": 0.0,
    }
