"""Files that are whole or absent, and their fingerprints."""

from __future__ import annotations

import glob
import hashlib
import os
import re
import secrets
import stat
from pathlib import Path

from beltgui.leftovers import is_running
from core.errors import InputError

_CHUNK = 1 << 20
_UNFINISHED = re.compile(r"\..+\.(\d+)\.[0-9a-f]{8}\.part")


def sha256_of(path: str | os.PathLike[str]) -> str:
    """Hexadecimal SHA-256 of a file's bytes.

    Raises:
        InputError: the file cannot be read.
    """
    digest = hashlib.sha256()
    try:
        with open(path, "rb") as file:
            while chunk := file.read(_CHUNK):
                digest.update(chunk)
    except OSError as error:
        raise InputError(f"{os.fspath(path)}: the file cannot be read: {error.strerror}.") from error
    return digest.hexdigest()


def check_input(path: str | os.PathLike[str], largest_bytes: int = 200_000_000) -> None:
    """Make sure that a name given by a person is an ordinary file of sensible size.

    Raises:
        InputError: it is missing, a folder, a device, empty, or larger than `largest_bytes`.
    """
    name = os.fspath(path)
    if not name:
        raise InputError("The name of an input file is empty.")
    try:
        status = os.stat(name)
    except (OSError, ValueError) as error:
        reason = getattr(error, "strerror", None) or error
        raise InputError(f"{name}: the file cannot be read: {reason}.") from error
    if stat.S_ISDIR(status.st_mode):
        raise InputError(f"{name}: this is a folder, expected a file.")
    if not stat.S_ISREG(status.st_mode):
        raise InputError(f"{name}: this is not an ordinary file.")
    if status.st_size == 0:
        raise InputError(f"{name}: the file is empty.")
    if status.st_size > largest_bytes:
        raise InputError(f"{name}: the file has {status.st_size / 1e6:.0f} MB, expected at most "
                         f"{largest_bytes / 1e6:.0f} MB.")


def read_input(path: str | os.PathLike[str], largest_bytes: int = 200_000_000) -> bytes:
    """All bytes of an ordinary file that a person named.

    Raises:
        InputError: as `check_input`, or it cannot be read.
    """
    check_input(path, largest_bytes)
    try:
        return Path(path).read_bytes()
    except OSError as error:
        raise InputError(f"{os.fspath(path)}: the file cannot be read: {error.strerror}.") from error


def check_writable(path: str | os.PathLike[str]) -> None:
    """Find out before a long computation whether `write_atomically` can work here.

    Raises:
        InputError: the folder is missing or not writable, or the name belongs to something that is no file.
    """
    target = Path(path)
    if "\0" in str(target):
        raise InputError("The name of the file to write holds a null character, expected a file name.")
    folder = Path(os.path.realpath(target)).parent
    if not folder.is_dir():
        raise InputError(f"{target}: the folder {folder} does not exist. Create it first.")
    if target.is_dir():
        raise InputError(f"{target}: this is a folder, expected the name of a file to write.")
    if target.exists() and not target.is_file():
        raise InputError(f"{target}: this is not an ordinary file and cannot be replaced.")
    if not os.access(folder, os.W_OK | os.X_OK):
        raise InputError(f"{target}: the folder {folder} is not writable.")


def write_atomically(path: str | os.PathLike[str], data: bytes) -> None:
    """Write a file so that under its name there is the old content or the new, never half of it.

    The data go to a temporary file in the same folder, are forced to the disk, and take over the name. On failure the
    temporary file is removed and an earlier file stays as it was. Temporary files of killed processes go too.

    Raises:
        InputError: the disk is full, the folder is gone, or the like.
    """
    target = Path(os.path.realpath(path))
    # A number at random: another process, perhaps of another machine, may have the same process number.
    temporary = target.with_name(f".{target.name[:200]}.{os.getpid()}.{secrets.token_hex(4)}.part")
    try:
        _remove_unfinished(target)
        with open(temporary, "xb") as file:
            file.write(data)
            file.flush()
            os.fsync(file.fileno())
        os.replace(temporary, target)
    except OSError as error:
        temporary.unlink(missing_ok=True)
        raise InputError(f"{os.fspath(path)}: the file cannot be written: {error.strerror}.") from error
    except BaseException:
        temporary.unlink(missing_ok=True)
        raise
    sync_folder(target.parent)


def _remove_unfinished(target: Path) -> None:
    """Remove the temporary files of a file whose writer is gone."""
    for path in target.parent.glob(f".{glob.escape(target.name[:200])}.*.part"):
        of = _UNFINISHED.fullmatch(path.name)
        if of is not None and not is_running(int(of[1])):
            path.unlink(missing_ok=True)


def sync_folder(folder: Path) -> None:
    """Force the names in a folder to the disk."""
    if os.name == "nt":  # Windows has no handle on folders to sync.
        return
    handle = os.open(folder, os.O_RDONLY)
    try:
        os.fsync(handle)
    finally:
        os.close(handle)
