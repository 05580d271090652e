"""STL, ascii and binary; a mesh serves as a cloud of its distinct vertices."""

from __future__ import annotations

import struct

import numpy as np
from numpy.typing import NDArray

from core.clouds.text import parse_rows
from core.errors import InputError

Array = NDArray[np.float64]

_TRIANGLE = np.dtype([("normal", "<f4", (3,)), ("corners", "<f4", (3, 3)), ("attribute", "<u2")])
_HEADER_BYTES = 84


def recognises(data: bytes) -> bool:
    """True for an ascii `solid` or a binary file whose size agrees with its triangle count."""
    return _is_ascii(data) or _is_binary(data)


def why_not(data: bytes) -> str:
    """The sentence for a file named .stl that is none."""
    if len(data) < _HEADER_BYTES:
        return f"an STL file has at least {_HEADER_BYTES} bytes, found {len(data)}. The file is cut short."
    count = struct.unpack_from("<I", data, 80)[0]
    return (f"the header says {count} triangles, that is {_HEADER_BYTES + count * _TRIANGLE.itemsize} bytes, the file "
            f"has {len(data)}. The file is cut short or no STL.")


def read(data: bytes, path: str) -> tuple[Array, str]:
    """Distinct vertices (N, 3) and the name of the format.

    Raises:
        InputError: the text is no STL or is cut short.
    """
    if _is_binary(data):
        count = struct.unpack_from("<I", data, 80)[0]
        corners = np.frombuffer(data, _TRIANGLE, count, _HEADER_BYTES)["corners"].reshape(-1, 3)
        # np.unique needs an order, which NaN lacks; a NaN corner is no vertex.
        good = corners[np.isfinite(corners).all(axis=1)]
        return np.unique(good, axis=0).astype(float), "STL binary"
    return _ascii(data, path), "STL ascii"


def _is_ascii(data: bytes) -> bool:
    head = data[:2000].lstrip()
    return head.startswith(b"solid") and (b"facet" in head or b"endsolid" in head)


def _is_binary(data: bytes) -> bool:
    if len(data) < _HEADER_BYTES:
        return False
    count = struct.unpack_from("<I", data, 80)[0]
    return count > 0 and bool(len(data) == _HEADER_BYTES + count * _TRIANGLE.itemsize)


def _ascii(data: bytes, path: str) -> Array:
    lines = data.decode("ascii", "replace").splitlines()
    rows = [(number, line) for number, line in enumerate(lines, start=1) if line.split()[:1] == ["vertex"]]
    facets = sum(line.split()[:1] == ["facet"] for line in lines)
    closed = any(line.split()[:1] == ["endsolid"] for line in lines)
    if not closed or len(rows) != 3 * facets:
        raise InputError(f"{path}: {facets} facets need {3 * facets} vertices and an endsolid line, found {len(rows)} "
                         f"vertices and {'an' if closed else 'no'} endsolid line. The file is cut short or damaged.")
    if not rows:
        raise InputError(f"{path}: the STL file holds no facets.")
    points = parse_rows([line for _, line in rows], [number for number, _ in rows], (1, 2, 3), path, width=4)
    return np.unique(points[np.isfinite(points).all(axis=1)], axis=0)
