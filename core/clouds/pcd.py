"""PCD (point cloud library), ascii, binary and binary_compressed."""

from __future__ import annotations

import struct
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from core.clouds.header import columns_as_points, count_of
from core.clouds.lzf import decompress
from core.clouds.text import parse_rows
from core.errors import InputError

Array = NDArray[np.float64]

_KINDS = {"F": {4: "<f4", 8: "<f8"}, "I": {1: "<i1", 2: "<i2", 4: "<i4", 8: "<i8"},
          "U": {1: "<u1", 2: "<u2", 4: "<u4", 8: "<u8"}}
_KEYS = ("VERSION", "FIELDS", "SIZE", "TYPE", "COUNT", "WIDTH", "HEIGHT", "VIEWPOINT", "POINTS", "DATA")
_LONGEST_HEADER = 1 << 16
# One LZF copy of three bytes yields at most 264.
_LARGEST_EXPANSION = 88


@dataclass(frozen=True)
class _Header:
    fields: list[str]
    kinds: list[str]
    counts: list[int]
    points: int
    data: str
    lines: int
    start: int

    @property
    def row_bytes(self) -> int:
        return sum(np.dtype(kind).itemsize * count for kind, count in zip(self.kinds, self.counts, strict=True))


def recognises(data: bytes) -> bool:
    """True if the file begins with a PCD header."""
    head = data[:400].upper()
    if head.startswith(b"# .PCD"):
        return True
    return head.startswith((b"#", b"VERSION", b"FIELDS")) and b"\nFIELDS " in b"\n" + head and b"SIZE " in head


def read(data: bytes, path: str) -> tuple[Array, str]:
    """All points (N, 3) as the file holds them, and the name of the format.

    Raises:
        InputError: the header is wrong or the body does not agree with it.
    """
    header = _parse(data, path)
    if header.data == "ascii":
        return _ascii(data, header, path), "PCD ascii"
    if header.data == "binary":
        return _binary(data, header, path), "PCD binary"
    return _compressed(data, header, path), "PCD binary compressed"


def _parse(data: bytes, path: str) -> _Header:
    values: dict[str, list[str]] = {}
    position = lines = 0
    while "DATA" not in values:
        newline = data.find(b"\n", position, _LONGEST_HEADER)
        if newline < 0:
            raise InputError(f"{path}: the PCD header has no DATA line; the file is cut short or damaged.")
        words = data[position:newline].decode("ascii", "replace").split()
        position, lines = newline + 1, lines + 1
        if not words or words[0].startswith("#"):
            continue
        if words[0].upper() not in _KEYS:
            raise InputError(f"{path}: line {lines} of the PCD header begins with {words[0][:24]!r}, expected one of "
                             f"{' '.join(_KEYS)}.")
        values[words[0].upper()] = words[1:]
    return _checked(values, lines, position, path)


def _checked(values: dict[str, list[str]], lines: int, start: int, path: str) -> _Header:
    missing = [key for key in ("FIELDS", "SIZE", "TYPE", "WIDTH", "HEIGHT") if not values.get(key)]
    if missing:
        raise InputError(f"{path}: the PCD header lacks {' '.join(missing)}.")
    fields = values["FIELDS"]
    lacking = [axis for axis in "xyz" if fields.count(axis) != 1]
    if lacking:
        raise InputError(f"{path}: expected the fields x y z once each, found {' '.join(fields)[:80]}.")
    counts = [count_of(word, "COUNT", path) for word in values.get("COUNT", ["1"] * len(fields))]
    sizes = [count_of(word, "SIZE", path) for word in values["SIZE"]]
    types = [word.upper() for word in values["TYPE"]]
    if not len(fields) == len(sizes) == len(types) == len(counts):
        raise InputError(f"{path}: the PCD header names {len(fields)} fields, but {len(sizes)} SIZE, {len(types)} TYPE "
                         f"and {len(counts)} COUNT.")
    kinds = []
    for name, kind, size, count in zip(fields, types, sizes, counts, strict=True):
        if size not in _KINDS.get(kind, {}):
            raise InputError(f"{path}: the PCD field {name[:24]!r} has TYPE {kind[:8]} and SIZE {size}, "
                             "expected e.g. F and 4.")
        if name in ("x", "y", "z") and count != 1:
            raise InputError(f"{path}: the PCD field {name} has COUNT {count}, expected 1.")
        if count > 65536:
            raise InputError(f"{path}: the PCD field {name[:24]!r} has COUNT {count}, expected at most 65536.")
        kinds.append(_KINDS[kind][size])
    width = count_of(values["WIDTH"][0], "WIDTH", path)
    height = count_of(values["HEIGHT"][0], "HEIGHT", path)
    points = count_of((values.get("POINTS") or [str(width * height)])[0], "POINTS", path)
    if points != width * height:
        raise InputError(f"{path}: the PCD header says {points} points, but WIDTH {width} times HEIGHT {height} is "
                         f"{width * height}.")
    body = (values["DATA"] or ["nothing"])[0].lower()
    if body not in ("ascii", "binary", "binary_compressed"):
        raise InputError(f"{path}: the PCD header says DATA {body[:24]}, expected ascii, binary or binary_compressed.")
    return _Header(fields, kinds, counts, points, body, lines, start)


def _ascii(data: bytes, header: _Header, path: str) -> Array:
    lines = data[header.start:].decode("ascii", "replace").splitlines()
    while lines and not lines[-1].strip():
        lines.pop()
    if len(lines) != header.points:
        raise _wrong_count(header.points, len(lines), path)
    first = [sum(header.counts[:header.fields.index(axis)]) for axis in "xyz"]
    columns = (first[0], first[1], first[2])
    numbers = range(header.lines + 1, header.lines + 1 + len(lines))
    return parse_rows(lines, numbers, columns, path, width=sum(header.counts))


def _binary(data: bytes, header: _Header, path: str) -> Array:
    available = len(data) - header.start
    if available != header.points * header.row_bytes:
        raise _wrong_count(header.points, available // max(header.row_bytes, 1), path,
                           f" ({available} bytes where {header.points * header.row_bytes} are expected)")
    # Numbered names: padding fields are all called "_".
    names = [name if name in ("x", "y", "z") else f"field{i}" for i, name in enumerate(header.fields)]
    dtype = np.dtype([(name, kind, (count,)) if count != 1 else (name, kind)
                      for name, kind, count in zip(names, header.kinds, header.counts, strict=True)])
    return columns_as_points(np.frombuffer(data, dtype, header.points, header.start))


def _compressed(data: bytes, header: _Header, path: str) -> Array:
    size = header.points * header.row_bytes
    if len(data) < header.start + 8:
        raise InputError(f"{path}: the compressed body is missing; the file is cut short.")
    packed, unpacked = struct.unpack_from("<II", data, header.start)
    if unpacked != size:
        raise InputError(f"{path}: the compressed body announces {unpacked} bytes, the header {header.points} points "
                         f"of {header.row_bytes} bytes, that is {size}.")
    body = data[header.start + 8:header.start + 8 + packed]
    if len(body) != packed or size > _LARGEST_EXPANSION * packed:
        raise InputError(f"{path}: the compressed body should have {packed} bytes and hold {size}, the file has "
                         f"{len(body)}. The file is cut short or damaged.")
    try:
        raw = decompress(body, size)
    except ValueError as error:
        raise InputError(f"{path}: the compressed body is damaged: {error}, expected {size} bytes.") from error
    points = np.empty((header.points, 3))
    offset = 0
    # Compressed bodies hold one field after the other.
    for name, kind, count in zip(header.fields, header.kinds, header.counts, strict=True):
        if name in ("x", "y", "z"):
            with np.errstate(invalid="ignore"):
                points[:, "xyz".index(name)] = np.frombuffer(raw, kind, header.points, offset)
        offset += np.dtype(kind).itemsize * count * header.points
    return points


def _wrong_count(expected: int, found: int, path: str, detail: str = "") -> InputError:
    return InputError(f"{path}: the header says {expected} points, the file holds {found}{detail}. "
                      "The file is cut short or its header is wrong.")
