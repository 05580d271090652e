"""Progress of long work on stderr."""

from __future__ import annotations

from beltgui.cli.job import Job
from beltgui.jobs import Job as Work


def told_on_stderr(job: Job) -> Work:
    """Work whose progress is told once per message, so that a log stays readable."""
    last = ""

    def tell(fraction: float, message: str) -> None:
        nonlocal last
        if message != last:
            last = message
            job.say(f"{100 * fraction:3.0f} % {message}")

    return Work(tell)
