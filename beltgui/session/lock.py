"""One writer for each session's folder; the operating system frees the lock when the process ends, however it ends."""

from __future__ import annotations

import os
import socket
import sys
from pathlib import Path

from core.errors import InputError

LOCK = "session.lock"

# Windows forbids others to read a locked byte; this one lies behind the text.
_LOCKED_BYTE = 1 << 20


class WriterLock:
    """Held from construction to `release`."""

    def __init__(self, folder: Path) -> None:
        """Take the lock.

        Raises:
            InputError: somebody else writes this session, or the folder cannot be written.
        """
        path = folder / LOCK
        try:
            self._handle = os.open(path, os.O_RDWR | os.O_CREAT, 0o666)
        except OSError as error:
            raise InputError(
                f"{folder}: the session cannot be written here ({error.strerror}). Open it read-only, or copy the "
                "folder to where you may write."
            ) from error
        try:
            _lock(self._handle)
        except OSError as error:
            holder = os.pread(self._handle, 200, 0) if hasattr(os, "pread") else os.read(self._handle, 200)
            os.close(self._handle)
            by = holder.decode("utf-8", "replace").strip() or "another program"
            raise InputError(
                f"{folder}: the session is being written by {by}. Close it there first, or open it read-only."
            ) from error
        os.ftruncate(self._handle, 0)
        os.write(self._handle, f"process {os.getpid()} on {socket.gethostname()}\n".encode())

    def release(self) -> None:
        """Let others write. The file stays: removing it would let two of them in."""
        os.ftruncate(self._handle, 0)
        os.close(self._handle)


if sys.platform == "win32":
    import msvcrt

    def _lock(handle: int) -> None:
        os.lseek(handle, _LOCKED_BYTE, os.SEEK_SET)
        try:
            msvcrt.locking(handle, msvcrt.LK_NBLCK, 1)
        finally:
            os.lseek(handle, 0, os.SEEK_SET)

else:
    import fcntl

    def _lock(handle: int) -> None:
        fcntl.flock(handle, fcntl.LOCK_EX | fcntl.LOCK_NB)
