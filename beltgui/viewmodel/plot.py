"""A 2D plot as data; axis labels carry the unit."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from beltgui.viewmodel.scene import Role, Scale

Array = NDArray[np.float64]


@dataclass(frozen=True, eq=False)
class Marks:
    """Single points (N,); `sample_ids` (N) links them to rows of the table, a click chooses the row."""

    x: Array
    y: Array
    role: Role
    name: str
    sample_ids: tuple[int, ...] = ()


@dataclass(frozen=True, eq=False)
class Curve:
    """A line through points (N,); NaN interrupts it. `dashed` for what is not a result, e.g. a limit or a bound."""

    x: Array
    y: Array
    role: Role
    name: str
    dashed: bool = False


@dataclass(frozen=True, eq=False)
class Bars:
    """Bars of height (N,) at x (N,); `labels` replace the ticks if given; a histogram's bars touch (width 1)."""

    x: Array
    height: Array
    role: Role
    name: str
    labels: tuple[str, ...] = ()
    width: float = 0.8


@dataclass(frozen=True, eq=False)
class Band:
    """The area between `low` and `high` (N,) over x (N,)."""

    x: Array
    low: Array
    high: Array
    role: Role
    name: str


@dataclass(frozen=True, eq=False)
class Map:
    """Values (rows along y, columns along x), NaN left empty, over the given ranges."""

    values: Array
    x_range: tuple[float, float]
    y_range: tuple[float, float]
    scale: Scale


@dataclass(frozen=True)
class LimitLine:
    """A horizontal line at a limit."""

    y: float
    name: str


Series = Marks | Curve | Bars | Band | Map


@dataclass(frozen=True, eq=False)
class Plot:
    """One plot.

    Attributes:
        key: Unique in the step; plots of the same key replace each other and keep their zoom.
        title: Short, on its tab.
        x_label: With unit.
        y_label: With unit.
        series: What to draw.
        limits: Horizontal lines.
    """

    key: str
    title: str
    x_label: str
    y_label: str
    series: tuple[Series, ...]
    limits: tuple[LimitLine, ...] = ()
