"""Reading JSON and TOML that people wrote: every complaint names the file and the field."""

from __future__ import annotations

import json
import math
import tomllib
from collections.abc import Iterator
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from beltgui.files import read_input
from core.errors import InputError

Array = NDArray[np.float64]

# A kilometre: nothing in a cell is that far or that large.
LARGEST_NUMBER = 1e6
MOST_ITEMS = 100_000
# The largest error surface takes a tenth; parsed, a file takes twenty times its size.
LARGEST_JSON_BYTES = 40_000_000


@dataclass(frozen=True)
class Field:
    """A value of a JSON or TOML file together with where it stands.

    Attributes:
        value: As the parser gave it.
        where: E.g. `observations[3].ball_in_measure_mm`; empty for the whole file.
        file: Path of the file.
    """

    value: Any
    where: str
    file: str

    @property
    def label(self) -> str:
        """File and field, for the beginning of a message."""
        return f"{self.file}: {self.where}" if self.where else f"{self.file}: the file"

    def error(self, expected: str) -> InputError:
        """The complaint that this value is not what was expected."""
        return InputError(f"{self.label} is {describe(self.value)}, expected {expected}.")

    def has(self, name: str) -> bool:
        """True if this is an object with a key that is not null."""
        return isinstance(self.value, dict) and self.value.get(name) is not None

    def key(self, name: str) -> Field:
        """The value under a key that must be there."""
        if not isinstance(self.value, dict):
            raise self.error(f"an object with the key \"{name}\"")
        if name not in self.value:
            found = ", ".join(str(key)[:30] for key in list(self.value)[:8]) or "none"
            raise InputError(f"{self.label} has no key \"{name}\"; its keys are: {found}.")
        return Field(self.value[name], f"{self.where}.{name}" if self.where else name, self.file)

    def get(self, name: str) -> Field | None:
        """The value under a key, None if the key is missing or null."""
        return self.key(name) if self.has(name) else None

    def items(self, what: str) -> Iterator[Field]:
        """The elements of a list that must not be empty."""
        if not isinstance(self.value, list):
            raise self.error(f"a list of {what}")
        if not self.value:
            raise InputError(f"{self.label} is an empty list, expected {what}.")
        if len(self.value) > MOST_ITEMS:
            raise InputError(f"{self.label} has {len(self.value)} {what}, expected at most {MOST_ITEMS}.")
        return (Field(item, f"{self.where}[{i}]", self.file) for i, item in enumerate(self.value))

    def number(self, *, above: float | None = None, at_most: float = LARGEST_NUMBER) -> float:
        """A finite number of sensible size; text and true/false are no numbers."""
        if isinstance(self.value, bool) or not isinstance(self.value, int | float):
            raise self.error("a number")
        if not -at_most <= self.value <= at_most:  # also false for NaN
            raise self.error(f"a number within ±{at_most:g}")
        if above is not None and self.value <= above:
            raise self.error(f"a number above {above:g}")
        return float(self.value)

    def radius_mm(self) -> float:
        """Radius of a grinder's head; what is outside of this range has another unit."""
        value = self.number()
        if not 5.0 <= value <= 5000.0:
            raise self.error("5 to 5000 mm; check the unit")
        return value

    def vector(self, length: int) -> Array:
        """(length,) finite numbers."""
        if not isinstance(self.value, list) or len(self.value) != length:
            raise self.error(f"a list of {length} numbers")
        return np.array([item.number() for item in self.items("numbers")])

    def direction(self) -> Array:
        """(3,) unit vector."""
        vector = self.vector(3)
        length = float(np.linalg.norm(vector))
        if abs(length - 1.0) > 1e-2:
            raise InputError(f"{self.label} has the length {length:.4g}, expected a unit vector.")
        return np.asarray(vector / length)

    def transform(self) -> Array:
        """(4, 4) rigid transform with its translation in mm."""
        from core.frames import checked_rigid  # brings half a second of scipy, which the window does without

        if not isinstance(self.value, list) or len(self.value) != 4:
            raise self.error("a 4x4 matrix, row by row")
        return checked_rigid([row.vector(4) for row in self.items("rows")], self.label)

    def text(self) -> str:
        """Text that is not empty and stays on one line."""
        if not isinstance(self.value, str) or not self.value.strip() or not self.value.isprintable():
            raise self.error("a text")
        return self.value

    def unknown_keys(self, *known: str) -> list[str]:
        """Keys of this object that nobody reads; likely misspelt."""
        if not isinstance(self.value, dict):
            return []
        return [f"{self.where}.{key}" if self.where else str(key) for key in self.value if key not in known]


def describe(value: Any) -> str:
    """A value in few words for a message."""
    if value is None:
        return "null"
    if isinstance(value, bool):
        return "true" if value else "false"
    if isinstance(value, int | float):
        return _number_text(value)
    if isinstance(value, str):
        return f"the text {value[:30]!r}"
    if isinstance(value, list):
        return f"a list of {len(value)} elements"
    if isinstance(value, dict):
        return "an object with the keys " + (", ".join(repr(str(key)[:20]) for key in list(value)[:5]) or "(none)")
    return f"a {type(value).__name__}"


def _number_text(value: int | float) -> str:
    if isinstance(value, int):
        return str(value) if abs(value) < 10**15 else "a number with too many digits"
    return "NaN" if math.isnan(value) else f"{value:g}"


def read_json(path: str) -> Field:
    """Parse a JSON file whose top is an object.

    Raises:
        InputError: unreadable, not UTF-8, not JSON (with line and column), a key given twice, or no object.
    """
    text = _utf8(read_input(path, LARGEST_JSON_BYTES), path)

    def unique(pairs: list[tuple[str, Any]]) -> dict[str, Any]:
        result: dict[str, Any] = {}
        for key, value in pairs:
            if key in result:
                raise InputError(f"{path}: the key \"{key[:40]}\" stands twice in one object, expected once.")
            result[key] = value
        return result

    try:
        value = json.loads(text, object_pairs_hook=unique)
    except json.JSONDecodeError as error:
        raise InputError(f"{path}: line {error.lineno} column {error.colno} is not JSON: {error.msg}.") from error
    except InputError:
        raise
    except (ValueError, RecursionError) as error:
        raise InputError(f"{path}: a number has too many digits or lists are nested too deeply, "
                         "expected a table of numbers.") from error
    if not isinstance(value, dict):
        raise InputError(f"{path}: the file is {describe(value)}, expected a JSON object {{...}}.")
    return Field(value, "", path)


def read_toml(path: str) -> Field:
    """Parse a TOML file.

    Raises:
        InputError: unreadable, not UTF-8 or not TOML (with line and column).
    """
    text = _utf8(read_input(path, 1_000_000), path)
    try:
        return Field(tomllib.loads(text), "", path)
    except RecursionError as error:
        raise InputError(f"{path}: this is not TOML: its lists are nested too deeply.") from error
    except ValueError as error:
        reason = str(error).split("\n")[0][:120].rstrip(".")
        raise InputError(f"{path}: this is not TOML: {reason}.") from error


def _utf8(data: bytes, path: str) -> str:
    if data[:2] in (b"\xff\xfe", b"\xfe\xff"):
        raise InputError(f"{path}: the text is UTF-16, expected UTF-8.")
    try:
        return data.decode("utf-8-sig")
    except UnicodeDecodeError as error:
        line = data.count(b"\n", 0, error.start) + 1
        raise InputError(f"{path}: line {line} is not UTF-8 text (byte {data[error.start]:#04x}).") from error
