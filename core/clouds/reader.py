"""Find out what kind of cloud file it is, by its content first and its ending second."""

from __future__ import annotations

import os
import stat
from pathlib import Path

from core.clouds import pcd, ply, stl, text
from core.clouds.cloud import Cloud, measured_only
from core.errors import InputError

TEXT_ENDINGS = (".xyz", ".csv", ".txt", ".asc", ".pts")
SUPPORTED_ENDINGS = (".ply", ".pcd", *TEXT_ENDINGS, ".stl")

# Above this the points alone would not fit into the memory of a cell's computer.
LARGEST_FILE_BYTES = 4_000_000_000


def read_cloud(path: str | os.PathLike[str]) -> Cloud:
    """Read every measured point of a cloud file.

    PLY (ascii, binary of both byte orders), PCD (ascii, binary, binary_compressed), text (spaces, commas or semicolons;
    header line and comments allowed) and STL (its distinct vertices). The content decides; a PLY file named `.xyz` is
    read as PLY.

    Args:
        path: File; lengths inside are taken as mm.

    Returns:
        Cloud with (N, 3) points in mm, N >= 1.

    Raises:
        InputError: the file is missing, not a file, empty, cut short, contradicts its own header, is of an unknown
            kind, or holds no measured point.
    """
    name = os.fspath(path)
    data = _bytes_of(name)
    ending = Path(name).suffix.lower()
    kind = _kind(data, ending, name)
    points, label = {"ply": ply.read, "pcd": pcd.read, "stl": stl.read, "text": text.read}[kind](data, name)
    return measured_only(points, name, label)


def _bytes_of(name: str) -> bytes:
    try:
        status = os.stat(name)
        if stat.S_ISDIR(status.st_mode):
            raise InputError(f"{name}: this is a folder, expected a point cloud file.")
        if not stat.S_ISREG(status.st_mode):
            raise InputError(f"{name}: this is not an ordinary file, expected a point cloud file.")
        if status.st_size > LARGEST_FILE_BYTES:
            raise InputError(f"{name}: the file has {status.st_size / 1e9:.1f} GB, at most "
                             f"{LARGEST_FILE_BYTES / 1e9:.0f} GB can be read. Thin the cloud.")
        data = Path(name).read_bytes()
    except (OSError, ValueError) as error:
        if isinstance(error, InputError):
            raise
        raise InputError(f"{name}: the file cannot be read: {getattr(error, 'strerror', None) or error}.") from error
    if not data:
        raise InputError(f"{name}: the file is empty, expected a point cloud.")
    return data


def _kind(data: bytes, ending: str, name: str) -> str:
    if ply.recognises(data):
        return "ply"
    if pcd.recognises(data):
        return "pcd"
    if stl.recognises(data):
        return "stl"
    if ending in TEXT_ENDINGS:
        return "text"
    if ending == ".ply":
        raise InputError(f"{name}: a PLY file must begin with a line \"ply\", found {_begin(data)}.")
    if ending == ".pcd":
        raise InputError(f"{name}: a PCD file must begin with header lines VERSION and FIELDS, found {_begin(data)}.")
    if ending == ".stl":
        raise InputError(f"{name}: {stl.why_not(data)}")
    raise InputError(f"{name}: the ending {ending or '(none)'} is not a point cloud; supported are "
                     f"{' '.join(SUPPORTED_ENDINGS)}.")


def _begin(data: bytes) -> str:
    return repr(data[:12].decode("ascii", "replace"))
