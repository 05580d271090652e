"""Text tables with x, y, z in columns, as scanners and spreadsheets write them."""

from __future__ import annotations

import re
from collections.abc import Sequence

import numpy as np
from numpy.typing import NDArray

from core.errors import InputError

Array = NDArray[np.float64]

# A row of numbers is a few hundred characters long.
_LONGEST_LINE = 20_000
_COMMENTS = ("#", "//", "%", "!")
_NUMBER = re.compile(r"[+-]?([0-9]+\.?[0-9]*|\.[0-9]+)(e[+-]?[0-9]+)?|[+-]?(nan|inf|infinity)", re.IGNORECASE)
# Control characters that no text editor writes: the file is binary.
_BINARY = re.compile(rb"[\x00-\x08\x0e-\x1a\x1c-\x1f]")


def read(data: bytes, path: str) -> tuple[Array, str]:
    """Points (N, 3) of a text file, and the name of the format.

    Separated by spaces, commas or semicolons (with semicolons a decimal comma is understood). Comment lines, one header
    line and a leading line with the number of points are allowed. Columns named x, y, z in the header are used wherever
    they stand, otherwise the first three; more than three columns under other names are refused.

    Raises:
        InputError: a line is not three numbers, or the file is no text.
    """
    numbers, rows = _data_lines(_decoded(data, path))
    if not rows:
        raise InputError(f"{path}: the file holds no lines with numbers, expected x y z per line.")
    longest = max(range(len(rows)), key=lambda index: len(rows[index]))
    if len(rows[longest]) > _LONGEST_LINE:
        raise InputError(f"{path}: line {numbers[longest]} has {len(rows[longest])} characters, expected x y z.")
    announced = _announced_count(rows)
    if announced is not None:
        numbers, rows = numbers[1:], rows[1:]
        if announced != len(rows):
            raise InputError(f"{path}: the first line says {announced} points, the file holds {len(rows)}. "
                             "The file is cut short or its first line is wrong.")
    separator = _separator(rows[min(1, len(rows) - 1)])
    if separator == ";":
        rows = [row.replace(",", ".") for row in rows]
    columns = (0, 1, 2)
    header = _header_names(rows[0], separator)
    if header is not None:
        named = _named_columns(header)
        if named is None and len(header) > 3:
            # Three of many columns taken by their place could be anything: time, index, intensity.
            raise InputError(f"{path}: line {numbers[0]} names {len(header)} columns but not x, y and z once each: "
                             f"{rows[0].strip()[:60]!r}. Name the three columns x, y, z.")
        columns = named or columns
        numbers, rows = numbers[1:], rows[1:]
        if not rows:
            raise InputError(f"{path}: the file has a header line but no points.")
    return parse_rows(rows, numbers, columns, path, separator=separator), "text"


def parse_rows(rows: Sequence[str], numbers: Sequence[int], columns: tuple[int, int, int], path: str, *,
               separator: str | None = None, width: int = 3) -> Array:
    """Three columns of a table of numbers.

    Args:
        rows: Lines of text.
        numbers: Line number of each row in the file.
        columns: Which columns hold x, y, z.
        path: For messages.
        separator: A character, or None for any white space.
        width: How many columns each row must have at least.

    Returns:
        (N, 3), NaN where the file says nan.

    Raises:
        InputError: names the first line that is not as expected.
    """
    if not rows or not all(row.strip() for row in rows):
        return _line_by_line(rows, numbers, columns, path, separator, width)
    # Asking for the last column makes numpy notice rows that are too short.
    wanted = columns if width - 1 in columns or width <= 3 else (*columns, width - 1)
    try:
        return np.loadtxt(rows, delimiter=separator, comments=None, usecols=wanted, ndmin=2)[:, :3]
    except ValueError:
        # numpy's reader is fast, but cannot name the line of the file; this one can.
        return _line_by_line(rows, numbers, columns, path, separator, width)


def _line_by_line(rows: Sequence[str], numbers: Sequence[int], columns: tuple[int, int, int], path: str,
                  separator: str | None, width: int) -> Array:
    points = np.empty((len(rows), 3))
    for index, row in enumerate(rows):
        words = [word.strip() for word in row.split(separator)]
        chosen = [words[column] for column in columns if column < len(words)]
        if len(chosen) < 3 or len(words) < width or not all(_NUMBER.fullmatch(word) for word in chosen):
            raise InputError(f"{path}: line {numbers[index]} is {row.strip()[:60]!r}, expected {width} numbers"
                             f"{' x y z' if width == 3 else ''}.")
        points[index] = [float(word) for word in chosen]
    return points


def _decoded(data: bytes, path: str) -> list[str]:
    if data[:2] in (b"\xff\xfe", b"\xfe\xff"):
        raise InputError(f"{path}: the text is UTF-16; save it as UTF-8.")
    found = _BINARY.search(data)
    if found:
        raise InputError(f"{path}: byte {found.start() + 1} is {found.group()[0]:#04x}; the file is binary, expected "
                         "text with x y z per line.")
    return data.decode("utf-8-sig", "replace").splitlines()


def _data_lines(lines: list[str]) -> tuple[list[int], list[str]]:
    kept = [(number, line) for number, line in enumerate(lines, start=1)
            if line.strip() and not line.lstrip().startswith(_COMMENTS)]
    return [number for number, _ in kept], [line for _, line in kept]


def _announced_count(rows: list[str]) -> int | None:
    word = rows[0].strip()
    if len(rows) > 1 and word.isascii() and word.isdigit() and len(word) <= 12:
        return int(word)
    return None


def _separator(row: str) -> str | None:
    return next((character for character in ";," if character in row), None)


def _header_names(row: str, separator: str | None) -> list[str] | None:
    """The names in a header line; None if a cell is or begins like a number, which makes it a line of data."""
    words = [word.strip().strip('"').lower() for word in row.split(separator)]
    return None if any(_NUMBER.match(word) for word in words) else words


def _named_columns(names: list[str]) -> tuple[int, int, int] | None:
    """Columns of x, y, z when each is named once, with or without a unit such as `x_mm` or `x [mm]`."""
    bare = [re.split(r"[^a-z0-9]", name.lstrip("/"), maxsplit=1)[0] for name in names]
    if any(bare.count(axis) != 1 for axis in "xyz"):
        return None
    return bare.index("x"), bare.index("y"), bare.index("z")
