"""The rail: the six steps with their state as shape, word and number."""

from __future__ import annotations

from PySide6.QtCore import Qt
from PySide6.QtWidgets import QFrame, QLabel, QVBoxLayout, QWidget

from beltgui.steps.state import STEPS, TITLES, StepEvent, StepState

SHAPES = {
    StepState.NOT_STARTED: "○",
    StepState.RUNNING: "▶",
    StepState.ACCEPTED: "✔",
    StepState.STALE: "◆",
    StepState.FAILED: "✖",
}
COLOURS = {
    StepState.NOT_STARTED: "#6c757d",
    StepState.RUNNING: "#0b5ed7",
    StepState.ACCEPTED: "#146c43",
    StepState.STALE: "#997404",
    StepState.FAILED: "#b02a37",
}


class StepEntry(QFrame):
    """One step in the rail."""

    def __init__(self, number: int, step: str, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.setFrameShape(QFrame.Shape.StyledPanel)
        self._title = QLabel(f"<b>{number}&nbsp; {TITLES[step]}</b>", self)
        self._state = QLabel(self)
        self._headline = QLabel(self)
        self._headline.setWordWrap(True)
        self._headline.setTextFormat(Qt.TextFormat.PlainText)
        layout = QVBoxLayout(self)
        layout.setSpacing(2)
        for label in (self._title, self._state, self._headline):
            layout.addWidget(label)
        self.show_event(StepEvent(step, StepState.NOT_STARTED))

    def show_event(self, event: StepEvent) -> None:
        """Show a state with its shape, word and headline."""
        self._state.setText(f"{SHAPES[event.state]}  {event.state}")
        self._state.setStyleSheet(f"color: {COLOURS[event.state]}; font-weight: 600;")
        self._headline.setText(event.headline)
        self._headline.setVisible(bool(event.headline))

    def text(self) -> str:
        """What the entry says, for tests and screen readers."""
        return f"{self._state.text()} {self._headline.text()}".strip()


class StepRail(QWidget):
    """All six steps."""

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.setFixedWidth(260)
        layout = QVBoxLayout(self)
        layout.setContentsMargins(8, 8, 8, 8)
        self.entries = {step: StepEntry(number, step, self) for number, step in enumerate(STEPS, start=1)}
        for entry in self.entries.values():
            layout.addWidget(entry)
        layout.addStretch(1)

    def show_event(self, event: StepEvent) -> None:
        """Show a step's new state."""
        self.entries[event.step].show_event(event)

    def reset(self) -> None:
        """All steps back to not started."""
        for step in STEPS:
            self.show_event(StepEvent(step, StepState.NOT_STARTED))
