"""A piece of the engine's work, and how its end is told."""

from __future__ import annotations

import sqlite3
import traceback
from collections.abc import Callable
from dataclasses import dataclass

from beltgui.engine.job import EngineJob
from beltgui.engine.messages import Crashed, Event, JobEnded, JobStarted, Refused
from beltgui.jobs import Cancelled
from core.errors import InputError
from devices.interfaces import DeviceError, Stopped


def _nothing() -> str:
    return ""


@dataclass(eq=False)
class Task:
    """One piece of work.

    Attributes:
        title: What it is, for a person.
        step: That it is for.
        work: Does it.
        kind: `open`, `acquire`, `solve`, `edit`, `accept`, `export`, `compare`, `fault`.
        why_not: Asked before it begins: a sentence where it is refused.
        motion: The robot may move in it.
        quiet: It takes no time, its beginning and end are not told.
        job: Its number, progress and end; set when it is taken on.
    """

    title: str
    step: str
    work: Callable[[EngineJob], None]
    kind: str
    why_not: Callable[[], str] = _nothing
    motion: bool = False
    quiet: bool = False
    job: EngineJob | None = None

    def end(self, how: str) -> None:
        """Ask it to end."""
        if self.job is not None:
            self.job.end(how)


def run_task(task: Task, emit: Callable[[Event], None], finished: Callable[[], None]) -> None:
    """Do it; `finished` is called before its end is told, so that the next command is taken."""
    job = task.job
    assert job is not None
    refusal = ""
    try:
        refusal = task.why_not()
        if not refusal and not task.quiet:
            emit(JobStarted(job.number, task.title, task.step, task.motion))
        how, message = ("", "") if refusal else _carry_out(task, job)
    except Exception:
        finished()
        emit(Crashed(traceback.format_exc()))
        return
    finished()
    if refusal or (task.quiet and how == "refused"):
        emit(Refused(refusal or message))
    elif task.quiet and how == "crashed":
        emit(Crashed(message))
    elif not task.quiet:
        emit(JobEnded(job.number, how, message))


def _carry_out(task: Task, job: EngineJob) -> tuple[str, str]:
    """How it ended, and in words."""
    try:
        task.work(job)
    except Cancelled:
        return ("stopped" if job.ending == "stopped" else "cancelled"), ""
    except Stopped as stopped:
        return ("cancelled" if job.ending == "cancelled" else "stopped"), str(stopped)
    except (InputError, DeviceError) as error:
        return "refused", str(error)
    except (OSError, sqlite3.OperationalError) as error:
        return "refused", f"Something outside the program failed: {error}. What was kept before is whole."
    except Exception:
        return "crashed", traceback.format_exc()
    return "done", ""
