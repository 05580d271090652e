"""The help beside the work: what the chosen step is for, what to mount, what to watch, what to do if it is rejected."""

from __future__ import annotations

from html import escape

from PySide6.QtCore import QEvent, Qt
from PySide6.QtWidgets import QDockWidget, QTextBrowser, QWidget

from beltgui.app.help_texts import help_of, reasons_help
from beltgui.app.names import SHAPES, state_word
from beltgui.app.theme import colour, px, theme
from beltgui.steps.state import STEPS, StepState
from beltgui.widgets.words import step_word


class HelpPanel(QDockWidget):
    """Follows the step that is looked at."""

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.setObjectName("help_panel")
        self.setAllowedAreas(Qt.DockWidgetArea.LeftDockWidgetArea | Qt.DockWidgetArea.RightDockWidgetArea)
        self._step = STEPS[0]
        self.browser = QTextBrowser(self)
        self.browser.setObjectName("help_text")
        self.setWidget(self.browser)
        theme().changed.connect(self._write)
        self._write()

    def set_step(self, step: str) -> None:
        """Show the help of this step."""
        if step != self._step:
            self._step = step
            self._write()

    def changeEvent(self, event: QEvent) -> None:  # noqa: N802  (Qt's name)
        """Follow the language."""
        super().changeEvent(event)
        if event.type() == QEvent.Type.LanguageChange:
            self._write()

    def _write(self) -> None:
        self.setWindowTitle(self.tr("Help"))
        self.browser.setAccessibleName(self.tr("Help of this step"))
        self.browser.setMinimumWidth(px(250))
        words = help_of(self._step)
        parts = [f"<h2>{escape(step_word(self._step))}</h2>"]
        for heading, text in (
            (self.tr("What it is for"), words.purpose),
            (self.tr("What to mount"), words.mount),
            (self.tr("What to watch"), words.watch),
        ):
            parts.append(f"<h3>{escape(heading)}</h3><p>{escape(text)}</p>")
        parts.append(f"<h3>{escape(self.tr('If it is rejected in this step'))}</h3>" + _pairs(words.remedies))
        parts.append(f"<h3>{escape(self.tr('What the reasons mean'))}</h3>" + _pairs(reasons_help()))
        parts.append(f"<h3>{escape(self.tr('States of a step'))}</h3>" + _pairs(self._states()))
        parts.append(f"<h3>{escape(self.tr('Words'))}</h3>" + _pairs(self._words()))
        style = f"h2, h3 {{ color: {colour('text')}; }} h3 {{ margin-bottom: 2px; }} p {{ margin-top: 2px; }}"
        self.browser.setHtml(f"<style>{style}</style>" + "".join(parts))

    def _states(self) -> tuple[tuple[str, str], ...]:
        meaning = {
            StepState.NOT_STARTED: self.tr("Nothing has been taken yet."),
            StepState.RUNNING: self.tr("Samples are being taken, or a result waits to be accepted."),
            StepState.ACCEPTED: self.tr("Checked on held-out data and accepted by a person."),
            StepState.STALE: self.tr("Something it stands on has changed. Solve or take it again; export is locked."),
            StepState.FAILED: self.tr("Rejected; the banner says why and what to do."),
        }
        return tuple((f"{SHAPES[state]} {state_word(state)}", text) for state, text in meaning.items())

    def _words(self) -> tuple[tuple[str, str], ...]:
        return (
            (self.tr("± (k = 2)"), self.tr("Twice the standard uncertainty: 95 times of 100 the true value is in it.")),
            (self.tr("Residual"), self.tr("How far a sample is from the result that was fitted to it. Small residuals "
                                          "alone prove nothing.")),
            (self.tr("Held-out"), self.tr("Kept out of the fit and used to check how well the result predicts.")),
            (self.tr("Frames"), self.tr("{B} robot base, {F} flange, {M} measuring stage, {S} scanner, {W} blade in "
                                        "CAD, {H} contact wheel. Lengths in mm, angles in degrees.")),
        )  # fmt: skip


def _pairs(pairs: tuple[tuple[str, str], ...]) -> str:
    return "".join(f"<p><b>{escape(what)}</b><br>{escape(text)}</p>" for what, text in pairs)
