"""The description of a path that a person writes, checked key by key."""

from __future__ import annotations

import difflib
import json
from collections.abc import Mapping
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np

from core.error_surface import ErrorSurface, error_surface_from_json_dict
from core.errors import InputError
from core.flange_poses import METRES_BELOW_MM
from core.frames import Array, checked_rigid, inverse
from core.path.pattern import PatternSettings
from core.path.plan import CellFrames
from core.path.reach import Workspace
from core.path.urscript import ProgramSettings

CHAIN = ("base_from_flange_at_scan", "base_from_measure", "measure_from_work")
KEYS = (
    "cad", "airfoil", "error_surface", "base_from_tool", "flange_from_work", *CHAIN, "wheel_radius_mm", "contact_side",
    "span_along_shaft", "pattern", "count", "spacing_mm", "positions", "u_range", "v_range", "step_mm",
    "chord_tolerance_mm", "serpentine", "clip", "approach_mm", "speed_mm_s", "travel_mm_s", "acceleration_mm_s2",
    "blend_mm", "max_turn_deg_s", "program", "blade_type", "date", "workspace_least_mm", "workspace_greatest_mm",
    "max_reach_mm",
)  # fmt: skip


@dataclass(frozen=True)
class PathJob:
    """Everything `plan_path` and `write_urscript` need, except for the airfoil's geometry.

    Attributes:
        cad: STEP file.
        airfoil: Face number (1-based) or name in it.
        error_surface: None for the design path.
        cell: Frames and wheel.
        pattern: Lines and their sampling.
        program_settings: Speeds, blends and header.
        program: File to write; None to write none.
        approach_mm: Clearance before and after a stroke.
        clip: Leave out what was not measured.
        workspace: Limits of the flange.
        files: Every file that was read, for the list of inputs.
    """

    cad: Path
    airfoil: int | str
    error_surface: ErrorSurface | None
    cell: CellFrames
    pattern: PatternSettings
    program_settings: ProgramSettings
    program: Path | None
    approach_mm: float
    clip: bool
    workspace: Workspace
    files: tuple[Path, ...]


class _Reader:
    """Typed access to the keys of one job, with messages that name the key."""

    def __init__(self, data: Mapping[str, Any], base_dir: Path) -> None:
        self.data = data
        self.base_dir = base_dir
        self.files: list[Path] = []

    def required(self, key: str) -> Any:
        if key not in self.data:
            raise InputError(f"{key}: missing from the path job.")
        return self.data[key]

    def number(self, key: str, default: float | None = None) -> float:
        value = self.required(key) if default is None else self.data.get(key, default)
        if isinstance(value, bool) or not isinstance(value, int | float) or not np.isfinite(value):
            raise InputError(f"{key}: expected a number, found {value!r}.")
        return float(value)

    def optional_number(self, key: str) -> float | None:
        return self.number(key) if key in self.data else None

    def integer(self, key: str, default: int | None = None) -> int:
        value = self.required(key) if default is None else self.data.get(key, default)
        if isinstance(value, bool) or not isinstance(value, int):
            raise InputError(f"{key}: expected a whole number, found {value!r}.")
        return value

    def flag(self, key: str, default: bool) -> bool:
        value = self.data.get(key, default)
        if not isinstance(value, bool):
            raise InputError(f"{key}: expected true or false, found {value!r}.")
        return value

    def text(self, key: str, default: str | None = None) -> str:
        value = self.required(key) if default is None else self.data.get(key, default)
        if default is not None and not isinstance(value, str) and hasattr(value, "isoformat"):
            return str(value.isoformat())
        if not isinstance(value, str):
            raise InputError(f"{key}: expected text, found {value!r}.")
        return value

    def numbers(self, key: str, length: int | None = None) -> tuple[float, ...]:
        value = self.required(key)
        good = isinstance(value, list) and all(
            isinstance(item, int | float) and not isinstance(item, bool) and np.isfinite(item) for item in value
        )
        if not good or (length is not None and len(value) != length):
            raise InputError(f"{key}: expected a list of {length or 'some'} numbers, found {value!r}.")
        return tuple(float(item) for item in value)

    def path(self, key: str) -> Path:
        path = self.base_dir / self.text(key)
        if not path.is_file():
            raise InputError(f"{key}: there is no file {path}.")
        self.files.append(path)
        return path

    def document(self, key: str) -> Any:
        """Parsed JSON of the file that a key names; a result that was rejected is refused."""
        path = self.path(key)
        try:
            document = json.loads(path.read_text(encoding="utf-8"))
        except (UnicodeDecodeError, json.JSONDecodeError) as error:
            raise InputError(f"{key}: {path} is not JSON ({error}).") from error
        except (ValueError, RecursionError) as error:
            raise InputError(
                f"{key}: {path} has a number with too many digits or is nested too deeply, expected a result."
            ) from error
        except OSError as error:
            raise InputError(f"{key}: {path} cannot be read: {error.strerror}.") from error
        if isinstance(document, dict) and isinstance(document.get("verdict"), dict):
            if document["verdict"].get("ok") is not True:
                raise InputError(f"{key}: {path} holds a rejected result. Repeat that step before planning a path.")
        return document

    def transform(self, key: str) -> Array:
        """A 4x4 in place, or the file of a result: its field of that name, or its `matrix`."""
        value = self.required(key)
        if isinstance(value, list):
            return checked_rigid(value, key)
        document = self.document(key)
        if isinstance(document, dict):
            pose = document.get(key, document)
            document = pose.get("matrix") if isinstance(pose, dict) else pose
        if document is None:
            raise InputError(f"{key}: {self.files[-1]} has neither '{key}' nor 'matrix'.")
        return checked_rigid(document, key)


def path_job_from_dict(data: Mapping[str, Any], base_dir: Path) -> PathJob:
    """Check a parsed job and read the calibration files that it names.

    Args:
        data: Keys as documented in docs/steps/path.md.
        base_dir: Folder that relative paths start from: the job's own.

    Raises:
        InputError: names the key, what was found and what was expected.
    """
    for key in data:
        if key not in KEYS:
            near = difflib.get_close_matches(key, KEYS, 1)
            raise InputError(f"{key}: unknown key in the path job." + (f" Is {near[0]} meant?" if near else ""))
    read = _Reader(data, Path(base_dir))
    program = read.data.get("program")
    return PathJob(
        cad=read.path("cad"),
        airfoil=_airfoil(read),
        error_surface=_error_surface(read) if "error_surface" in data else None,
        cell=_cell(read),
        pattern=_pattern(read),
        program_settings=_program(read),
        program=None if program is None else read.base_dir / read.text("program"),
        approach_mm=read.number("approach_mm", 20.0),
        clip=read.flag("clip", False),
        workspace=_workspace(read),
        files=tuple(read.files),
    )


def _airfoil(read: _Reader) -> int | str:
    value = read.required("airfoil")
    if isinstance(value, bool) or not isinstance(value, int | str):
        raise InputError(f"airfoil: expected the number or the name of a face, found {value!r}.")
    return value


def _error_surface(read: _Reader) -> ErrorSurface:
    document = read.document("error_surface")
    if isinstance(document, dict) and isinstance(document.get("surface"), dict):
        document = document["surface"]
    if not isinstance(document, dict):
        raise InputError("error_surface: the file does not hold an error surface.")
    return error_surface_from_json_dict(document)


def _cell(read: _Reader) -> CellFrames:
    chain = [key for key in CHAIN if key in read.data]
    if "flange_from_work" in read.data and chain:
        raise InputError(f"flange_from_work: give either this or {', '.join(CHAIN)}, not both.")
    if chain:
        at_scan, base, work = (read.transform(key) for key in CHAIN)
        _check_mm(at_scan, CHAIN[0], METRES_BELOW_MM)
        _check_mm(base, CHAIN[1], METRES_BELOW_MM)
        flange_from_work = inverse(at_scan) @ base @ work
    else:
        flange_from_work = read.transform("flange_from_work")
    base_from_tool = read.transform("base_from_tool")
    _check_mm(base_from_tool, "base_from_tool", METRES_BELOW_MM)
    # The blade may sit close to the flange, but not within a millimetre of it.
    if np.any(flange_from_work[:3, 3]):
        _check_mm(flange_from_work, "flange_from_work", 1.0)
    return CellFrames(
        base_from_tool=base_from_tool,
        flange_from_work=flange_from_work,
        wheel_radius_mm=read.number("wheel_radius_mm"),
        contact_side=read.integer("contact_side"),
        span_along_shaft=read.integer("span_along_shaft", 1),
    )


def _check_mm(transform: Array, key: str, nearest_mm: float) -> None:
    """Lengths in metres would make a program that runs the blade through the cell."""
    distance = float(np.linalg.norm(transform[:3, 3]))
    if distance < nearest_mm:
        raise InputError(
            f"{key}: the translation is only {distance:.3g} long, expected mm. It looks like metres: multiply by 1000."
        )


def _pattern(read: _Reader) -> PatternSettings:
    u0, u1 = read.numbers("u_range", 2)
    v0, v1 = read.numbers("v_range", 2)
    # Zero switches the chord rule off: TOML has no null.
    chord = read.number("chord_tolerance_mm", 0.01)
    return PatternSettings(
        kind=read.text("pattern"),
        u_range=(u0, u1),
        v_range=(v0, v1),
        count=read.integer("count") if "count" in read.data else None,
        spacing_mm=read.optional_number("spacing_mm"),
        positions=read.numbers("positions") if "positions" in read.data else None,
        step_mm=read.number("step_mm", 2.0),
        chord_tolerance_mm=None if chord == 0.0 else chord,
        serpentine=read.flag("serpentine", True),
    )


def _program(read: _Reader) -> ProgramSettings:
    standard = ProgramSettings()
    return ProgramSettings(
        speed_mm_s=read.number("speed_mm_s", standard.speed_mm_s),
        travel_mm_s=read.number("travel_mm_s", standard.travel_mm_s),
        acceleration_mm_s2=read.number("acceleration_mm_s2", standard.acceleration_mm_s2),
        blend_mm=read.number("blend_mm", standard.blend_mm),
        max_turn_rad_s=float(np.radians(read.number("max_turn_deg_s", float(np.degrees(standard.max_turn_rad_s))))),
        date=read.text("date", ""),
        blade_type=read.text("blade_type", ""),
    )


def _workspace(read: _Reader) -> Workspace:
    corners: list[tuple[float, float, float] | None] = []
    for key in ("workspace_least_mm", "workspace_greatest_mm"):
        if key in read.data:
            x, y, z = read.numbers(key, 3)
            corners.append((x, y, z))
        else:
            corners.append(None)
    return Workspace(corners[0], corners[1], read.optional_number("max_reach_mm"))
