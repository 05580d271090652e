"""CSV tables with named columns; complaints name the file, the line and the column."""

from __future__ import annotations

import csv
import math
from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from beltgui.cli.fields import LARGEST_NUMBER
from beltgui.files import read_input
from core.errors import InputError

Array = NDArray[np.float64]

MOST_ROWS = 1_000_000


@dataclass(frozen=True)
class Table:
    """Columns of numbers.

    Attributes:
        columns: Name to (N,) values.
        lines: (N,) line numbers in the file.
        path: The file.
    """

    columns: dict[str, Array]
    lines: tuple[int, ...]
    path: str


def read_csv(path: str, layouts: Sequence[Sequence[str]], may_be_empty: Sequence[str] = ()) -> Table:
    """Read the first of several sets of named columns that the header line has.

    Separated by commas or semicolons; empty lines and lines beginning with # are skipped; further columns are ignored.
    Empty cells of the columns in `may_be_empty` become NaN.

    Raises:
        InputError: no such columns, a cell that is no finite number, a row too short or too long, no rows.
    """
    data = read_input(path)
    try:
        text = data.decode("utf-8-sig")
    except UnicodeDecodeError as error:
        bad_line = data.count(b"\n", 0, error.start) + 1
        raise InputError(f"{path}: line {bad_line} is not UTF-8 text.") from error
    lines = [(i, line) for i, line in enumerate(text.splitlines(), 1) if line.strip() and not line.startswith("#")]
    if not lines:
        raise InputError(f"{path}: the file holds no lines, expected a header {_list(layouts)}.")
    separator = ";" if ";" in lines[0][1] else ","
    header = [name.strip() for name in _split(lines[0][1], separator)]
    layout = next((names for names in layouts if set(names) <= set(header)), None)
    if layout is None:
        raise InputError(f"{path}: line {lines[0][0]} is {lines[0][1].strip()[:60]!r}, expected a header with the "
                         f"columns {_list(layouts)}.")
    twice = [name for name in layout if header.count(name) > 1]
    if twice:
        raise InputError(f"{path}: line {lines[0][0]} names the column {twice[0]} more than once.")
    if len(lines) == 1:
        raise InputError(f"{path}: the file has a header but no rows.")
    if len(lines) > MOST_ROWS:
        raise InputError(f"{path}: the file has {len(lines)} lines, expected at most {MOST_ROWS}.")
    places = [header.index(name) for name in layout]
    values = np.empty((len(lines) - 1, len(layout)))
    for row, (number, line) in enumerate(lines[1:]):
        cells = _split(line, separator)
        if len(cells) != len(header):
            raise InputError(f"{path}: line {number} has {len(cells)} columns, the header has {len(header)}.")
        for place, name, column in zip(places, layout, range(len(layout)), strict=True):
            empty = name in may_be_empty and not cells[place].strip()
            where = f"{path}: line {number}, column {name}"
            values[row, column] = math.nan if empty else _number(cells[place], separator, where)
    return Table({name: values[:, i].copy() for i, name in enumerate(layout)}, tuple(n for n, _ in lines[1:]), path)


def _split(line: str, separator: str) -> list[str]:
    """Cells of one line, quotes taken off."""
    try:
        return next(csv.reader([line], delimiter=separator, strict=True), [])
    except csv.Error:
        # A quote that is never closed, or a cell beyond 128 kB: what stands there is no number, and will be named.
        return line.split(separator)


def _number(cell: str, separator: str, where: str) -> float:
    text = cell.strip().replace(",", ".") if separator == ";" else cell.strip()
    try:
        value = float(text)
    except ValueError as error:
        raise InputError(f"{where} is {text[:30]!r}, expected a number.") from error
    if not abs(value) <= LARGEST_NUMBER:  # also true for NaN
        raise InputError(f"{where} is {text[:30]}, expected a number within ±{LARGEST_NUMBER:g}.")
    return value


def _list(layouts: Sequence[Sequence[str]]) -> str:
    return " or ".join(",".join(names) for names in layouts)
