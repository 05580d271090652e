"""A job of the engine: may be ended in several ways, and knows in which one it was."""

from __future__ import annotations

from beltgui.jobs import Cancelled, Job, ProgressListener


class EngineJob(Job):
    """Progress and end of one piece of the engine's work.

    Attributes:
        number: Of the job.
        ending: Empty while nobody wants its end; else `cancelled`, `stopped` or `superseded` (newer work of the same
            step follows).
    """

    def __init__(self, number: int, on_progress: ProgressListener) -> None:
        super().__init__(on_progress)
        self.number = number
        self.ending = ""

    def end(self, how: str) -> None:
        """Ask the work to end at its next report; a stop outweighs what was said before."""
        if not self.ending or how == "stopped":
            self.ending = how
        self.cancel()

    def tell(self, fraction: float, message: str) -> None:
        """Only the progress of a report, where the work cannot be ended half-way."""
        if self._on_progress is not None:
            self._on_progress(fraction, message)

    def check(self) -> None:
        """Only the cancel point of a report.

        Raises:
            Cancelled: somebody asked the work to end.
        """
        if self._cancelled.is_set():
            raise Cancelled("The job was cancelled.")

    def silent(self) -> Job:
        """A job that ends with this one and shows no progress, for work in between."""
        return _Silent(self)


class _Silent(Job):
    def __init__(self, whole: EngineJob) -> None:
        super().__init__()
        self._whole = whole

    def cancel(self) -> None:
        self._whole.cancel()

    def report(self, fraction: float, message: str) -> None:
        self._whole.check()
