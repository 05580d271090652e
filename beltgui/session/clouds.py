"""Clouds as NumPy files beside the database: under its name a file is whole or absent."""

from __future__ import annotations

import os
import re
from pathlib import Path
from typing import TYPE_CHECKING

from beltgui.files import sync_folder
from core.errors import InputError

if TYPE_CHECKING:
    import numpy as np
    from numpy.typing import NDArray

CLOUDS = "clouds"
_UNFINISHED = re.compile(r"\.\d+-\d+\.part$")
_counter = iter(range(1 << 62))


def write_unfinished(folder: Path, points_mm: NDArray[np.float32]) -> Path:
    """Points (..., 3) in mm on the disk under a temporary name in the session's `folder`.

    Raises:
        InputError: the disk is full, the folder is gone, or the like.
    """
    import numpy as np

    path = folder / CLOUDS / f".{os.getpid()}-{next(_counter)}.part"
    try:
        with path.open("xb") as file:
            np.save(file, points_mm, allow_pickle=False)
            file.flush()
            os.fsync(file.fileno())
    except BaseException as error:
        path.unlink(missing_ok=True)
        if isinstance(error, OSError):
            raise InputError(
                f"{path}: the cloud cannot be written: {error.strerror}. The sample was not kept."
            ) from error
        raise
    return path


def finish(folder: Path, unfinished: Path, number: int, step: str) -> str:
    """Give a file its name and force the name to the disk; returns it relative to the session's `folder`."""
    name = f"{CLOUDS}/{number:05d}_{step}.npy"
    os.replace(unfinished, folder / name)
    sync_folder(folder / CLOUDS)
    return name


def tidy(folder: Path, next_number: int) -> None:
    """Remove what a killed writer left: files under temporary names, and one that had its name but no sample yet.

    Only for who holds the writer's lock: nobody else writes here then.
    """
    for path in folder.glob(".*.part"):
        path.unlink(missing_ok=True)
    clouds = folder / CLOUDS
    clouds.mkdir(exist_ok=True)
    for path in clouds.iterdir():
        if _UNFINISHED.search(path.name):
            path.unlink(missing_ok=True)
    for path in clouds.glob(f"{next_number:05d}_*.npy"):
        path.unlink(missing_ok=True)


def read(path: Path, number: int) -> NDArray[np.float64]:
    """The finite points (N, 3) in mm of sample `number`, float64.

    Raises:
        InputError: the file is gone or damaged.
    """
    import numpy as np

    try:
        stored = np.load(path, allow_pickle=False)
        flat = stored.reshape(-1, 3)
    except (OSError, ValueError, EOFError) as error:
        raise InputError(f"{path}: the cloud of sample {number} cannot be read ({error}).") from error
    return np.asarray(flat[np.isfinite(flat).all(axis=1)], dtype=np.float64)
