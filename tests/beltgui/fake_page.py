"""Stands in for the page of the steps: notes what the window asks of it."""

from __future__ import annotations

from typing import Any

from PySide6.QtCore import Signal
from PySide6.QtWidgets import QWidget

from beltgui.engine.messages import CellMoved, JobProgress, JobStarted, Question
from beltgui.viewmodel.step import StepView


class FakePage(QWidget):
    """The methods and signals of `StepPage`."""

    command = Signal(object)
    step_wanted = Signal(str)
    export_wanted = Signal()

    def __init__(self, parent: QWidget) -> None:
        super().__init__(parent)
        self.setObjectName("step_page")
        self.calls: list[str] = []
        self.step = ""
        self.views: dict[str, StepView] = {}
        self.job: tuple[Any, Any] = (None, None)
        self.question: Question | None = None
        self.lock: tuple[str, ...] = ()
        self.read_only = False
        self.cells: list[CellMoved] = []

    def set_step(self, step: str) -> None:
        self.step = step

    def show_step(self, view: StepView) -> None:
        self.views[view.step] = view

    def forget(self) -> None:
        self.views = {}

    def show_question(self, question: Question | None) -> None:
        self.question = question

    def show_job(self, job: JobStarted | None, progress: JobProgress | None = None) -> None:
        self.job = (job, progress)

    def show_cell(self, cell: CellMoved) -> None:
        self.cells.append(cell)

    def take_focus(self) -> None:
        self.calls.append("focus")

    def stop_pressed(self) -> None:
        self.calls.append("stop")

    def set_export_lock(self, why: tuple[str, ...]) -> None:
        self.lock = why

    def set_read_only(self, read_only: bool) -> None:
        self.read_only = read_only

    def shut_down(self) -> None:
        self.calls.append("shut down")
