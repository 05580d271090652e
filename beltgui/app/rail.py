"""The rail: the six steps with their state as shape, word and colour; a click or Ctrl+1 to 6 looks at a step."""

from __future__ import annotations

from PySide6.QtCore import QEvent, QSize, Qt, Signal
from PySide6.QtWidgets import QLabel, QPushButton, QVBoxLayout, QWidget

from beltgui.app.elided import ElidedLabel
from beltgui.app.language import sentence
from beltgui.app.names import SHAPES, state_word
from beltgui.app.theme import colour, px, theme
from beltgui.steps.state import STEPS, StepState
from beltgui.viewmodel.step import Action, StepView
from beltgui.widgets.words import step_word

WIDTH_PX = 186


class StepEntry(QPushButton):
    """One step in the rail."""

    def __init__(self, number: int, step: str, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.setObjectName(f"rail_{step}")
        self.setCheckable(True)
        self._number, self._step = number, step
        self._view: StepView | None = None
        self._title = QLabel(self)
        self._state = QLabel(self)
        self._headline = ElidedLabel(2, self)
        layout = QVBoxLayout(self)
        for label in (self._title, self._state, self._headline):
            label.setAttribute(Qt.WidgetAttribute.WA_TransparentForMouseEvents)
            layout.addWidget(label)
        self.dress()
        self.write()

    def show_view(self, view: StepView | None) -> None:
        """Show how the step stands; None before anything is known."""
        self._view = view
        self.write()

    @property
    def state(self) -> StepState:
        """The state that is shown."""
        return StepState.NOT_STARTED if self._view is None else self._view.state

    @property
    def ready(self) -> bool:
        """Its result waits to be accepted."""
        return self._view is not None and self._view.content is not None and Action.ACCEPT in self._view.actions

    def write(self) -> None:
        """Write in the present language and colours."""
        self._title.setText(f"{self._number}  {step_word(self._step)}")
        word = self.tr("ready to accept") if self.ready else state_word(self.state)
        self._state.setText(f"{SHAPES[self.state]}  {word}")
        self._state.setStyleSheet(f"color: {colour(self.state)}; font-weight: 600;")
        self._headline.setText(self._found())
        self._headline.setVisible(bool(self._headline.text()))
        why = "" if self._view is None else "\n".join(sentence(line) for line in self._view.why)
        self.setAccessibleName(self.text_shown())
        self.setAccessibleDescription(why)
        self.setToolTip("\n".join(filter(None, (self._headline.text(), why, f"Ctrl+{self._number}"))))
        self.updateGeometry()

    def _found(self) -> str:
        """The number that matters, or how far it is."""
        if self._view is None:
            return ""
        content = self._view.content
        # That it is ready is said by the line of the state already.
        return sentence(content.headline if self.ready and content is not None else self._view.headline)

    def dress(self) -> None:
        """Take the theme's colours and sizes."""
        layout = self.layout()
        layout.setContentsMargins(px(10), px(7), px(6), px(7))
        layout.setSpacing(px(2))
        self.setStyleSheet(
            f"StepEntry {{ text-align: left; border: 1px solid {colour('line')};"
            f" border-left: {px(5)}px solid transparent;"
            f" padding: 0; min-height: 0; background: {colour('background')}; border-radius: 0; }}"
            f"StepEntry:hover {{ background: {colour('hover')}; }}"
            f"StepEntry:checked {{ background: {colour('panel')}; border-left-color: {colour('accent')}; }}"
            f"StepEntry:focus {{ border-color: {colour('accent')}; }}"
        )
        self._title.setStyleSheet(f"font-weight: 600; font-size: {px(14)}px;")
        self._headline.setStyleSheet(f"font-size: {px(12)}px; color: {colour('muted')};")

    def text_shown(self) -> str:
        """What the entry says, for screen readers."""
        return " ".join(filter(None, (self._title.text(), self._state.text(), self._headline.text())))

    def sizeHint(self) -> QSize:  # noqa: N802  (Qt's name)
        """As high as its labels need at the rail's width."""
        width = px(WIDTH_PX)
        layout = self.layout()
        # A layout without its wrapped headline has no height for a width.
        height = layout.totalHeightForWidth(width) if layout.hasHeightForWidth() else layout.sizeHint().height()
        return QSize(width, height)

    def minimumSizeHint(self) -> QSize:  # noqa: N802  (Qt's name)
        """The same: nothing is cut off."""
        return self.sizeHint()


class StepRail(QWidget):
    """All six steps.

    Signals:
        chosen: The person wants to look at this step.
    """

    chosen = Signal(str)

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.setObjectName("rail")
        self._layout = QVBoxLayout(self)
        self._heading = QLabel(self)
        self._heading.setProperty("tone", "muted")
        self._layout.addWidget(self._heading)
        self.entries = {step: StepEntry(number, step, self) for number, step in enumerate(STEPS, start=1)}
        for step, entry in self.entries.items():
            entry.clicked.connect(lambda _=False, of=step: self.chosen.emit(of))
            self._layout.addWidget(entry)
        self._layout.addStretch(1)
        theme().changed.connect(self._dress)
        self._dress()
        self._write()

    def show_view(self, view: StepView) -> None:
        """Show a step's new state."""
        self.entries[view.step].show_view(view)

    def mark(self, step: str) -> None:
        """Mark the step that is looked at."""
        for name, entry in self.entries.items():
            entry.setChecked(name == step)

    def reset(self) -> None:
        """Nothing is known of any step."""
        for entry in self.entries.values():
            entry.show_view(None)

    def changeEvent(self, event: QEvent) -> None:  # noqa: N802  (Qt's name)
        """Follow the language."""
        super().changeEvent(event)
        if event.type() == QEvent.Type.LanguageChange:
            self._write()

    def _write(self) -> None:
        self.setAccessibleName(self.tr("Steps"))
        self._heading.setText(self.tr("Steps"))
        for entry in self.entries.values():
            entry.write()

    def _dress(self) -> None:
        self.setFixedWidth(px(WIDTH_PX))
        self._layout.setContentsMargins(0, px(6), 0, 0)
        self._layout.setSpacing(px(3))
        self._heading.setIndent(px(10))
        for entry in self.entries.values():
            entry.dress()
            entry.write()
