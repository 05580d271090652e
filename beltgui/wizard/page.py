"""The page of a step: 3D view, plots and samples, and on the right what to do and how good it is.

One page serves all six steps (there is one 3D view in a window): it keeps the newest view of every step and shows the
one chosen with `set_step`.

Object names that a driver finds:
    step_page, step_title, step_purpose, rhythm, scene_view, right_panel, banner, banner_copy, numbers, checks,
    suggestion, live_values, step_progress, cancel_button, primary_button, solve_button, start_over_button, undo_button,
    redo_button, samples_table, samples_flagged, delete_button, plots, plot_tabs, plot_whole, question_panel,
    question_text, question_picture, question_done, question_not_now, question_move, question_hold, question_series,
    panel_<step>.
"""

from __future__ import annotations

from typing import Any

from PySide6.QtCore import Signal
from PySide6.QtWidgets import QWidget

from beltgui.engine import messages
from beltgui.viewmodel.step import StepView


class StepPage(QWidget):
    """Shows one step at a time; says with signals what the person wants.

    Args:
        scene_view: The 3D view; None makes the one of `beltgui.widgets.scene_view`.
        parent: Of the widget.

    Signals:
        command: A command of `beltgui.engine.messages` for the engine.
        step_wanted: Name of the step that the person wants to go to (`Next step: Base`).
        export_wanted: The person wants to write robot programs (a folder has to be asked for).
    """

    command = Signal(object)
    step_wanted = Signal(str)
    export_wanted = Signal()

    def __init__(self, scene_view: QWidget | None = None, parent: QWidget | None = None) -> None:
        super().__init__(parent)

    def set_step(self, step: str) -> None:
        """Show this step (one of `STEPS`)."""

    def show_step(self, view: StepView) -> None:
        """Keep and, if it is the step on the page, show a view; one with a smaller generation is dropped."""

    def forget(self) -> None:
        """Another session: drop all views."""

    def show_question(self, question: messages.Question | None) -> None:
        """Ask the person, or take the question away."""

    def show_job(
        self,
        job: messages.JobStarted | None,
        progress: messages.JobProgress | None = None,
    ) -> None:
        """Work has begun, goes on, or (None) has ended."""

    def show_cell(self, cell: messages.CellMoved) -> None:
        """Where robot and stage are."""

    def set_export_lock(self, why: tuple[str, ...]) -> None:
        """Why export is locked (sentences); empty frees it."""

    def set_read_only(self, read_only: bool) -> None:
        """Only look: nothing can be edited or started."""

    def set_theme_changed(self) -> None:
        """Draw again in the theme's present colours."""

    def set_language_changed(self) -> None:
        """Write again in the present language."""

    def shut_down(self) -> None:
        """Free the 3D view; must be called before the widget goes."""
