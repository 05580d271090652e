"""A blade type: its CAD model, the faces to register on, limits, the grid to probe and a rough starting pose."""

from __future__ import annotations

import re
import tomllib
from collections.abc import Mapping
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np

from core.errors import InputError
from core.frames import Array, rigid, rotation_from_euler_zyx


@dataclass(frozen=True)
class RegistrationLimits:
    """When a registration of this type is accepted.

    Attributes:
        rms_mm: Largest RMS of the fine registration.
        min_points_per_face: Fewest scan points on each registration face.
        rough_rms_mm: Largest RMS of the rough registration.
        contact_sigma_mm: Largest one-sigma of where a point of the airfoil lies.
    """

    rms_mm: float
    min_points_per_face: int
    rough_rms_mm: float
    contact_sigma_mm: float


@dataclass(frozen=True)
class ProbingGrid:
    """Airfoil parameters at which the error is measured, both ends included."""

    u_min: float
    u_max: float
    u_count: int
    v_min: float
    v_max: float
    v_count: int

    def u(self) -> Array:
        """(u_count,) parameters around the profile."""
        return np.linspace(self.u_min, self.u_max, self.u_count)

    def v(self) -> Array:
        """(v_count,) parameters along the span."""
        return np.linspace(self.v_min, self.v_max, self.v_count)


@dataclass(frozen=True, eq=False)
class BladeType:
    """What the cell knows about a blade type before it sees one.

    Attributes:
        name: Type name, e.g. `DR95`.
        step_path: CAD model, absolute.
        serial_pattern: Regular expression that a serial number of this type matches in full.
        description: For a person.
        registration_faces: Names or ids of the faces to register on.
        airfoil: Name or id of the airfoil's face.
        limits: When a registration is accepted.
        probing: Grid of the error surface.
        flange_from_work: (4, 4) how the blade sits on the flange, roughly.
        stock_mm: How far faces that are still to be ground may be from the CAD model; the rough step expects it.
        path: The type file.
    """

    name: str
    step_path: Path
    serial_pattern: str
    description: str
    registration_faces: tuple[int | str, ...]
    airfoil: int | str
    limits: RegistrationLimits
    probing: ProbingGrid
    flange_from_work: Array
    stock_mm: float
    path: Path

    def accepts_serial(self, serial: str) -> bool:
        """True where a serial number belongs to this type."""
        return re.fullmatch(self.serial_pattern, serial) is not None


class _Table:
    """A TOML table that names file and field in every complaint."""

    def __init__(self, path: Path, section: str, values: object) -> None:
        self.where, self.section = f"{path}: [{section}]", section
        if not isinstance(values, Mapping):
            raise InputError(f"{self.where} is missing; expected a table of that name.")
        self.values: dict[str, Any] = dict(values)

    def take(self, key: str) -> Any:
        if key not in self.values:
            raise InputError(f"{self.where} {key} is missing.")
        return self.values.pop(key)

    def text(self, key: str) -> str:
        value = self.take(key)
        if not isinstance(value, str) or not value.strip():
            raise InputError(f"{self.where} {key}: expected a text, found {value!r}.")
        return value

    def number(self, key: str, low: float, high: float = np.inf) -> float:
        value = self.take(key)
        if isinstance(value, bool) or not isinstance(value, int | float) or not low <= value <= high:
            limits = f"of at least {low:g}" if np.isinf(high) else f"in {low:g} .. {high:g}"
            raise InputError(f"{self.where} {key}: expected a number {limits}, found {value!r}.")
        return float(value)

    def count(self, key: str, low: int) -> int:
        value = self.take(key)
        if isinstance(value, bool) or not isinstance(value, int) or value < low:
            raise InputError(f"{self.where} {key}: expected a whole number of at least {low}, found {value!r}.")
        return value

    def face(self, key: str) -> int | str:
        return self._checked_face(key, self.take(key))

    def faces(self, key: str) -> tuple[int | str, ...]:
        value = self.take(key)
        if not isinstance(value, list) or not value:
            raise InputError(f"{self.where} {key}: expected a list of face names or ids, found {value!r}.")
        return tuple(self._checked_face(key, item) for item in value)

    def _checked_face(self, key: str, value: object) -> int | str:
        if isinstance(value, bool) or not isinstance(value, int | str) or value == "":
            raise InputError(f"{self.where} {key}: expected a face name or id, found {value!r}.")
        return value

    def triple(self, key: str) -> Array:
        value = self.take(key)
        good = isinstance(value, list) and len(value) == 3 and all(
            isinstance(item, int | float) and not isinstance(item, bool) and np.isfinite(item) for item in value)
        if not good:
            raise InputError(f"{self.where} {key}: expected three numbers, found {value!r}.")
        return np.array(value, dtype=float)

    def done(self) -> None:
        """Complain about what nobody asked for: a misspelt field would be ignored in silence."""
        if self.values:
            raise InputError(f"{self.where} {', '.join(sorted(self.values))}: unknown field.")


def read_blade_type(path: str | Path) -> BladeType:
    """Read a blade type from a TOML file; its STEP file is named relative to it.

    Raises:
        InputError: the file is missing, no TOML, or a field is missing, unknown or out of range; the message names it.
    """
    path = Path(path)
    try:
        data = tomllib.loads(path.read_text(encoding="utf-8"))
    except OSError as error:
        raise InputError(f"{path}: the blade type can't be opened ({error.strerror}).") from error
    except (UnicodeDecodeError, tomllib.TOMLDecodeError) as error:
        raise InputError(f"{path}: not a valid TOML file ({error}).") from error
    known = ("blade", "faces", "limits", "probing", "rough_start")
    if unknown := sorted(set(data) - set(known)):
        raise InputError(f"{path}: unknown table [{unknown[0]}]; expected {', '.join(known)}.")
    blade, faces, limits, probing, start = (_Table(path, name, data.get(name)) for name in known)
    result = BladeType(
        name=blade.text("type"), step_path=_step_path(path, blade.text("step")),
        serial_pattern=_pattern(blade), description=blade.text("description"),
        registration_faces=faces.faces("registration"), airfoil=faces.face("airfoil"),
        limits=RegistrationLimits(limits.number("rms_mm", 1e-6), limits.count("min_points_per_face", 3),
                                  limits.number("rough_rms_mm", 1e-6), limits.number("contact_sigma_mm", 1e-6)),
        probing=_probing(probing),
        flange_from_work=rigid(rotation_from_euler_zyx(*np.radians(start.triple("euler_zyx_deg"))),
                               start.triple("translation_mm")),
        stock_mm=start.number("stock_mm", 0.0, 10.0),
        path=path)
    for table in (blade, faces, limits, probing, start):
        table.done()
    return result


def _step_path(path: Path, step: str) -> Path:
    found = (path.parent / step).resolve()
    if not found.is_file():
        raise InputError(f"{path}: [blade] step: there is no file {step!r} beside the type file.")
    return found


def _pattern(blade: _Table) -> str:
    pattern = blade.text("serial_pattern")
    try:
        re.compile(pattern)
    except re.error as error:
        raise InputError(f"{blade.where} serial_pattern: {pattern!r} is no regular expression ({error}).") from error
    return pattern


def _probing(table: _Table) -> ProbingGrid:
    ranges = []
    for axis in "uv":
        low = table.number(f"{axis}_min", 0.0, 1.0)
        high = table.number(f"{axis}_max", 0.0, 1.0)
        if high <= low:
            raise InputError(f"{table.where} {axis}_max: must be greater than {axis}_min = {low:g}, found {high:g}.")
        ranges.append((low, high, table.count(f"{axis}_count", 4)))
    return ProbingGrid(*ranges[0], *ranges[1])
