"""Limits of a verdict from a TOML file, over the defaults of the core."""

from __future__ import annotations

import dataclasses
import math
from typing import Any, TypeVar

from beltgui.cli.fields import Field, read_toml
from core.errors import InputError

LimitsT = TypeVar("LimitsT")


def read_limits(path: str | None, step: str, kind: type[LimitsT]) -> LimitsT:
    """The default limits, replaced where the file says so.

    Args:
        path: TOML file, or None for the defaults. Keys stand at the top, or in a section named after the command, so
            that one file can serve all commands.
        step: Name of that section.
        kind: Frozen dataclass with a default for each limit.

    Raises:
        InputError: an unknown key, or a value that is no number of the right kind.
    """
    if path is None:
        return kind()
    root = read_toml(path)
    section = root.key(step) if isinstance(root.value.get(step), dict) else root
    # Angles are typed in degrees.
    fields = {field.name.replace("_rad", "_deg"): field.name for field in dataclasses.fields(kind)}  # type: ignore
    changes: dict[str, Any] = {}
    for name, value in section.value.items():
        if section is root and isinstance(value, dict):
            continue  # the section of another command
        entry = section.key(name)
        if name not in fields:
            raise InputError(f"{entry.label} is not a limit of {step}; the limits are {', '.join(fields)}.")
        limit = fields[name]
        value = _value(entry, getattr(kind(), limit), direction=limit == "expected_axis_in_base")
        changes[limit] = math.radians(value) if limit != name else value
    return dataclasses.replace(kind(), **changes)  # type: ignore[type-var]


def _value(entry: Field, default: object, *, direction: bool = False) -> Any:
    if direction:
        return tuple(float(value) for value in entry.direction())
    if isinstance(default, bool):
        if not isinstance(entry.value, bool):
            raise entry.error("true or false")
        return entry.value
    number = entry.number(at_most=1e12)
    if number < 0.0:
        raise entry.error("a number of at least 0")
    if isinstance(default, int):
        if number != int(number):
            raise entry.error("a whole number")
        return int(number)
    return number
