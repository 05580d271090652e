"""Two sessions side by side: how far is each pose, point and held-out error from where it was?"""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from typing import Any

from beltgui.engine.messages import ComparedRow
from beltgui.session import quantities
from beltgui.session.quantities import COVERAGE, Figure, Movement
from beltgui.session.store import Session
from beltgui.steps.state import STEPS


def compare(here: Session, there: Session) -> tuple[ComparedRow, ...]:
    """The latest results of two sessions; what only one of them has is listed without a difference.

    A pose has a row for the distance of the origins in mm and one for the angle between in deg; both are at least
    zero. A number has `moved` = here less there. `chance` (k = 2) holds both uncertainties.
    """
    rows: list[ComparedRow] = []
    for step in STEPS:
        of_here, of_there = here.result(step), there.result(step)
        rows += _compare(step, of_here.record if of_here else {}, of_there.record if of_there else {})
    return tuple(rows)


def _compare(step: str, here: Mapping[str, Any], there: Mapping[str, Any]) -> Iterator[ComparedRow]:
    moved = {movement.name: movement for movement in quantities.movements(step, there, here)}
    turning = _names(quantities.poses(step, here), quantities.poses(step, there))
    for name in turning:
        yield _distance(step, name, moved.get(name))
        yield _turn(step, name, moved.get(name))
    for name in _names(quantities.points(step, here), quantities.points(step, there)):
        yield _distance(step, name, moved.get(name))
    figures_here = {figure.name: figure for figure in quantities.figures(step, here)}
    figures_there = {figure.name: figure for figure in quantities.figures(step, there)}
    for name in {**figures_here, **figures_there}:
        yield _number(step, figures_here.get(name), figures_there.get(name))


def _names(here: Iterator[Any], there: Iterator[Any]) -> list[str]:
    return list(dict.fromkeys(quantity.name for found in (here, there) for quantity in found))


def _distance(step: str, name: str, moved: Movement | None) -> ComparedRow:
    if moved is None:
        return ComparedRow(step, name, None, None, None, "mm")
    return ComparedRow(step, name, None, None, moved.mm, "mm", moved.chance_mm)


def _turn(step: str, name: str, moved: Movement | None) -> ComparedRow:
    if moved is None:
        return ComparedRow(step, name, None, None, None, "deg")
    return ComparedRow(step, name, None, None, moved.deg, "deg", moved.chance_deg)


def _number(step: str, here: Figure | None, there: Figure | None) -> ComparedRow:
    known = here or there
    assert known is not None
    if here is None or there is None:
        value_here, value_there = (None if figure is None else figure.value for figure in (here, there))
        return ComparedRow(step, known.name, value_here, value_there, None, known.unit)
    chance = None
    if here.sigma is not None and there.sigma is not None:
        chance = COVERAGE * (here.sigma**2 + there.sigma**2) ** 0.5
    return ComparedRow(step, here.name, here.value, there.value, here.value - there.value, here.unit, chance)
