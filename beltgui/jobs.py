"""Long work: reports progress and can be cancelled; no Qt here, so that screens, command line and tests share it."""

from __future__ import annotations

import threading
from collections.abc import Callable

ProgressListener = Callable[[float, str], None]


class Cancelled(Exception):  # noqa: N818  (a wish that was granted, not an error)
    """The job ended early because a person asked for it; nothing that was kept before is lost."""


class Job:
    """Progress and cancellation of one piece of work.

    Example:
        >>> job = Job(print)
        >>> job.report(0.5, "half of the poses scanned")
        0.5 half of the poses scanned
    """

    def __init__(self, on_progress: ProgressListener | None = None) -> None:
        self._on_progress = on_progress
        self._cancelled = threading.Event()

    def cancel(self) -> None:
        """Ask the work to end at its next report; may be called from any thread."""
        self._cancelled.set()

    def report(self, fraction: float, message: str) -> None:
        """Tell how far the work is (0 to 1).

        Raises:
            Cancelled: somebody asked the work to end.
        """
        if self._cancelled.is_set():
            raise Cancelled("The job was cancelled.")
        if self._on_progress is not None:
            self._on_progress(fraction, message)

    def part(self, start: float, end: float, prefix: str = "") -> Job:
        """A job for a part of this one: its 0 to 1 is `start` to `end` here; cancelling either ends the work."""
        return _Part(self, start, end, prefix)


class _Part(Job):
    def __init__(self, whole: Job, start: float, end: float, prefix: str) -> None:
        super().__init__()
        self._whole = whole
        self._start = start
        self._span = end - start
        self._prefix = prefix

    def cancel(self) -> None:
        self._whole.cancel()

    def report(self, fraction: float, message: str) -> None:
        self._whole.report(self._start + self._span * fraction, self._prefix + message)
