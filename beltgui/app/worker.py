"""Runs Qt-free work in a thread and brings progress, events and the end back to the window's thread as signals."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

from PySide6.QtCore import QThread, Signal

from beltgui.jobs import Cancelled, Job
from beltgui.steps.state import StepEvent
from core.errors import InputError
from devices.interfaces import DeviceError

Work = Callable[[Job, Callable[[StepEvent], None]], Any]


class Worker(QThread):
    """One piece of work. What a person can act on arrives as `refused`; a bug as `crashed`, and is raised there."""

    progressed = Signal(float, str)
    step_changed = Signal(object)
    done = Signal(object)
    refused = Signal(str)
    cancelled = Signal()
    crashed = Signal(object)

    def __init__(self, work: Work) -> None:
        super().__init__()
        self._work = work
        self._job = Job(self.progressed.emit)

    def cancel(self) -> None:
        """Ask the work to end at its next report."""
        self._job.cancel()

    def run(self) -> None:
        """Do the work (called by Qt in the new thread)."""
        try:
            result = self._work(self._job, self.step_changed.emit)
        except Cancelled:
            self.cancelled.emit()
        except (InputError, DeviceError) as error:
            self.refused.emit(str(error))
        except Exception as error:
            self.crashed.emit(error)
        else:
            self.done.emit(result)
