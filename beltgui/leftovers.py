"""What a killed process leaves behind: whose a temporary file is, whether that process still runs, and its removal."""

from __future__ import annotations

import contextlib
import os
import re
import tempfile
from pathlib import Path

_OWNED = re.compile(r"beltcal_[a-z]+_(\d+)_")


def is_running(pid: int) -> bool:
    """A process of this number runs on this machine; True too where that cannot be found out."""
    if os.name == "nt":  # there, asking by a signal would end it
        return True
    try:
        os.kill(pid, 0)
    except ProcessLookupError:
        return False
    except (PermissionError, OverflowError):
        return True
    return True


def prefix(kind: str) -> str:
    """Beginning of the names of temporary files of this process; `kind` in lower-case letters."""
    return f"beltcal_{kind}_{os.getpid()}_"


def sweep() -> None:
    """Remove temporary files whose process is gone from the machine's temporary folder."""
    for path in Path(tempfile.gettempdir()).glob("beltcal_*"):
        owner = _OWNED.match(path.name)
        if owner is not None and path.is_file() and not is_running(int(owner[1])):
            with contextlib.suppress(OSError):  # another user's, or another start was faster: neither matters here
                path.unlink()
