"""PLY, ascii and binary; of all elements only the vertices' x, y, z are read."""

from __future__ import annotations

from dataclasses import dataclass, field

import numpy as np
from numpy.typing import NDArray

from core.clouds.header import columns_as_points, count_of
from core.clouds.text import parse_rows
from core.errors import InputError

Array = NDArray[np.float64]

_TYPES = {
    "char": "i1", "int8": "i1", "uchar": "u1", "uint8": "u1", "short": "i2", "int16": "i2", "ushort": "u2",
    "uint16": "u2", "int": "i4", "int32": "i4", "uint": "u4", "uint32": "u4", "float": "f4", "float32": "f4",
    "double": "f8", "float64": "f8",
}
_FORMATS = {"ascii": ("PLY ascii", ""), "binary_little_endian": ("PLY binary little-endian", "<"),
            "binary_big_endian": ("PLY binary big-endian", ">")}
_LONGEST_HEADER = 1 << 20


@dataclass
class _Element:
    name: str
    count: int
    properties: list[tuple[str, str]] = field(default_factory=list)  # (name, numpy type without byte order)
    lists: list[str] = field(default_factory=list)


@dataclass
class _Header:
    format: str
    elements: list[_Element]
    lines: int


def recognises(data: bytes) -> bool:
    """True if the first line is `ply`."""
    return data[:4] in (b"ply\n", b"ply\r", b"ply ")


def read(data: bytes, path: str) -> tuple[Array, str]:
    """All vertices (N, 3) as the file holds them, and the name of the format.

    Raises:
        InputError: the header is wrong or the body does not agree with it.
    """
    header_text, body_start = _split(data, path)
    header = _parse(header_text, path)
    index = _vertex_index(header, path)
    label, order = _FORMATS[header.format]
    if order:
        return _binary(data, body_start, header, index, order, path), label
    return _ascii(data[body_start:], header, index, path), label


def _split(data: bytes, path: str) -> tuple[list[str], int]:
    end = data.find(b"end_header", 0, _LONGEST_HEADER)
    newline = data.find(b"\n", end) if end >= 0 else -1
    if newline < 0:
        raise InputError(f"{path}: the PLY header has no end_header line; the file is cut short or damaged.")
    return data[:end].decode("ascii", "replace").splitlines(), newline + 1


def _parse(lines: list[str], path: str) -> _Header:
    header = _Header("", [], len(lines) + 1)
    for number, line in enumerate(lines, start=1):
        words = line.split()
        if number == 1 or not words or words[0] in ("comment", "obj_info"):
            continue
        where = f"{path}: line {number} of the PLY header"
        if words[0] == "format" and len(words) >= 2:
            if words[1] not in _FORMATS:
                raise InputError(f"{where} names the format {words[1]!r}, expected one of {', '.join(_FORMATS)}.")
            header.format = words[1]
        elif words[0] == "element" and len(words) == 3:
            count = count_of(words[2], f"the number of elements {words[1]!r}", path)
            header.elements.append(_Element(words[1], count))
        elif words[0] == "property" and header.elements:
            _add_property(header.elements[-1], words, where)
        else:
            raise InputError(f"{where} is {line.strip()[:40]!r}, expected format, element, property or comment.")
    if not header.format:
        raise InputError(f"{path}: the PLY header has no format line, expected e.g. \"format ascii 1.0\".")
    return header


def _add_property(element: _Element, words: list[str], where: str) -> None:
    if len(words) == 5 and words[1] == "list":
        element.lists.append(words[4])
        return
    if len(words) != 3 or words[1] not in _TYPES:
        raise InputError(f"{where} is {' '.join(words)[:40]!r}, expected \"property TYPE NAME\" with TYPE such as "
                         "float or double.")
    if words[2] in [name for name, _ in element.properties]:
        raise InputError(f"{where} names the property {words[2][:24]!r} a second time.")
    element.properties.append((words[2], _TYPES[words[1]]))


def _vertex_index(header: _Header, path: str) -> int:
    names = [element.name for element in header.elements]
    if names.count("vertex") != 1:
        raise InputError(f"{path}: expected one element \"vertex\" in the PLY header, found "
                         f"{', '.join(names)[:60] or 'no element'}.")
    index = names.index("vertex")
    vertex = header.elements[index]
    found = [name for name, _ in vertex.properties]
    missing = [axis for axis in "xyz" if axis not in found]
    if missing:
        raise InputError(f"{path}: the vertices lack {' '.join(missing)}; their properties are "
                         f"{' '.join(found)[:80] or 'none'}.")
    if vertex.lists:
        raise InputError(f"{path}: the vertices have a list property {vertex.lists[0][:24]!r}, which is not supported.")
    return index


def _binary(data: bytes, start: int, header: _Header, index: int, order: str, path: str) -> Array:
    for element in header.elements[:index]:
        if element.lists and element.count:
            raise InputError(f"{path}: the list element {element.name[:24]!r} stands before the vertices, "
                             "which is not supported. Write the vertices first.")
        start += element.count * _row_bytes(element)
    vertex = header.elements[index]
    later = header.elements[index + 1:]
    dtype = np.dtype([(name, order + kind) for name, kind in vertex.properties])
    needed = vertex.count * dtype.itemsize
    available = max(len(data) - start, 0)
    if available < needed:
        raise InputError(f"{path}: the header says {vertex.count} vertices of {dtype.itemsize} bytes, the file holds "
                         f"{available // dtype.itemsize}. The file is cut short or its header is wrong.")
    rest = available - needed
    exact = not any(element.lists and element.count for element in later)
    expected_rest = sum(element.count * _row_bytes(element) for element in later)
    if exact and rest != expected_rest:
        raise InputError(f"{path}: after the {vertex.count} vertices of the header {rest} bytes are left, "
                         f"expected {expected_rest}. The header does not describe this file.")
    return columns_as_points(np.frombuffer(data, dtype, vertex.count, start))


def _row_bytes(element: _Element) -> int:
    return sum(np.dtype(kind).itemsize for _, kind in element.properties)


def _ascii(body: bytes, header: _Header, index: int, path: str) -> Array:
    lines = body.decode("ascii", "replace").splitlines()
    while lines and not lines[-1].strip():
        lines.pop()
    skip = sum(element.count for element in header.elements[:index])
    vertex = header.elements[index]
    later = sum(element.count for element in header.elements[index + 1:])
    rows = lines[skip:skip + vertex.count]
    if len(rows) < vertex.count:
        raise InputError(f"{path}: the header says {vertex.count} vertices, the file holds {len(rows)}. "
                         "The file is cut short or its header is wrong.")
    found = len(lines) - skip - vertex.count
    if found > later:
        raise InputError(f"{path}: the header says {vertex.count} vertices and {later} other elements, the file has "
                         f"{found - later} more lines. The header does not describe this file.")
    names = [name for name, _ in vertex.properties]
    columns = (names.index("x"), names.index("y"), names.index("z"))
    first = header.lines + skip + 1
    return parse_rows(rows, range(first, first + len(rows)), columns, path, width=len(names))
