"""Pairs of points that a person picked on scan and CAD model: the setting `pairs`, read and edited.

Rows of the table that stand for pairs have negative ids: the first pair is -1, the second -2, and so on. Ticking or
deleting such a row changes the setting, and is undone like any other choice.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace
from typing import Any

import numpy as np
from numpy.typing import NDArray

from beltgui.session import Session
from beltgui.steps.room import Bench
from core.errors import InputError

Array = NDArray[np.float64]
STEP = "rough"
METHOD, PAIRS = "method", "pairs"
AUTOMATIC, BY_PAIRS = "automatic", "pairs"
LEAST_PAIRS = 3
# With one pair to spare a wrong one is named by the others.
CHECKED_PAIRS = 4


@dataclass(frozen=True)
class Pair:
    """One pair.

    Attributes:
        name: As a person calls it.
        scan_mm: Picked on the scan, {M}; None as long as it is missing.
        cad_mm: Picked on the CAD model, {W}; None as long as it is missing.
        included: The tick box.
    """

    name: str
    scan_mm: tuple[float, float, float] | None
    cad_mm: tuple[float, float, float] | None
    included: bool = True

    @property
    def whole(self) -> bool:
        """True if both points are picked."""
        return self.scan_mm is not None and self.cad_mm is not None

    @property
    def used(self) -> bool:
        """True if it takes part."""
        return self.whole and self.included

    def plain(self) -> dict[str, Any]:
        """As the setting holds it."""
        return {
            "name": self.name,
            "scan_mm": None if self.scan_mm is None else list(self.scan_mm),
            "cad_mm": None if self.cad_mm is None else list(self.cad_mm),
            "included": self.included,
        }


def method_of(bench: Bench) -> str:
    """How the blade is found: `automatic` or `pairs`.

    Raises:
        InputError: neither.
    """
    method = bench.session.setting(STEP, METHOD, AUTOMATIC)
    if method not in (AUTOMATIC, BY_PAIRS):
        raise InputError(f"The rough step knows the methods '{AUTOMATIC}' and '{BY_PAIRS}', found {method!r}.")
    return str(method)


def pairs_of(bench: Bench) -> tuple[Pair, ...]:
    """The pairs as they are chosen now.

    Raises:
        InputError: the setting does not hold pairs.
    """
    return read_pairs(bench.session.setting(STEP, PAIRS, []))


def read_pairs(setting: Any) -> tuple[Pair, ...]:
    """Pairs from the setting.

    Raises:
        InputError: something else.
    """
    if not isinstance(setting, list):
        raise InputError("The pairs are no list. Pick them anew.")
    pairs = []
    for number, entry in enumerate(setting, start=1):
        if not isinstance(entry, Mapping):
            raise InputError(f"Pair {number} has no name and points. Pick it anew.")
        name = str(entry.get("name") or f"pair {number}")
        scan, cad = (_point(entry.get(key), name) for key in ("scan_mm", "cad_mm"))
        pairs.append(Pair(name, scan, cad, bool(entry.get("included", True))))
    names = [pair.name for pair in pairs]
    twice = next((name for name in names if names.count(name) > 1), None)
    if twice is not None:
        raise InputError(f"Two pairs are called '{twice}'. Rename one of them.")
    return tuple(pairs)


def row_id(index: int) -> int:
    """Id of the row of a pair, by its place from 0."""
    return -1 - index


def with_included(pairs: Sequence[Pair], row: int, on: bool) -> list[dict[str, Any]]:
    """The setting with one pair ticked or not; `row` is its row's id.

    Raises:
        InputError: there is no such pair.
    """
    index = _index(pairs, row)
    return [replace(pair, included=on).plain() if k == index else pair.plain() for k, pair in enumerate(pairs)]


def without(pairs: Sequence[Pair], row: int) -> list[dict[str, Any]]:
    """The setting less one pair; `row` is its row's id.

    Raises:
        InputError: there is no such pair.
    """
    index = _index(pairs, row)
    return [pair.plain() for k, pair in enumerate(pairs) if k != index]


def include_pair(session: Session, row: int, on: bool, person: str) -> None:
    """Tick or untick the pair of a row.

    Raises:
        InputError: there is no such pair, or the session cannot be changed.
    """
    session.choose(STEP, PAIRS, with_included(read_pairs(session.setting(STEP, PAIRS, [])), row, on), person)


def delete_pair(session: Session, row: int, person: str) -> None:
    """Take the pair of a row away.

    Raises:
        InputError: there is no such pair, or the session cannot be changed.
    """
    session.choose(STEP, PAIRS, without(read_pairs(session.setting(STEP, PAIRS, [])), row), person)


def next_name(pairs: Sequence[Pair]) -> str:
    """A name that no pair has yet."""
    names = {pair.name for pair in pairs}
    return next(name for k in range(1, len(pairs) + 2) if (name := f"pair {k}") not in names)


def _index(pairs: Sequence[Pair], row: int) -> int:
    index = -1 - row
    if not 0 <= index < len(pairs):
        raise InputError("There is no such pair any more.")
    return index


def _point(value: Any, name: str) -> tuple[float, float, float] | None:
    if value is None:
        return None
    try:
        point = np.asarray(value, dtype=float)
    except (TypeError, ValueError) as error:
        raise InputError(f"A point of '{name}' is not three numbers in mm. Pick it anew.") from error
    if point.shape != (3,) or not np.isfinite(point).all():
        raise InputError(f"A point of '{name}' is not three numbers in mm. Pick it anew.")
    x, y, z = point.tolist()
    return (x, y, z)
