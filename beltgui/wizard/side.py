"""The right panel of a step's page: what to do, how good it is, and the one primary button."""

from __future__ import annotations

from PySide6.QtCore import Signal
from PySide6.QtGui import QKeySequence, QShortcut
from PySide6.QtWidgets import QApplication, QHBoxLayout, QLabel, QPushButton, QVBoxLayout, QWidget

from beltgui.app.theme import px
from beltgui.viewmodel.step import StepView
from beltgui.widgets.banner import Banner
from beltgui.widgets.checks_list import ChecksList
from beltgui.widgets.numbers_panel import NumbersPanel
from beltgui.widgets.pictures import Picture
from beltgui.widgets.progress_line import ProgressLine
from beltgui.widgets.question_panel import QuestionPanel
from beltgui.widgets.suggestion_box import SuggestionBox
from beltgui.widgets.tall_scroll import TallScroll
from beltgui.widgets.words import step_word
from beltgui.wizard.live import LiveValues
from beltgui.wizard.panel import StepPanel
from beltgui.wizard.rhythm import Phase, Press, Primary, RhythmLine
from beltgui.wizard.texts import texts_of

WIDTH_PX = 344


class SidePanel(QWidget):
    """All of the right panel; the page decides what it says.

    Signals:
        pressed: What the primary button does (`Press`).
        solve_wanted: Solve again.
        start_over_wanted: Delete all samples of the step.
    """

    pressed = Signal(object)
    solve_wanted = Signal()
    start_over_wanted = Signal()

    def __init__(self, panels: dict[str, StepPanel], parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.setObjectName("right_panel")
        self.panels = panels
        self._primary = Primary(Press.WAIT, "", enabled=False)
        self._step = ""
        self._lost_focus = False
        self._build()
        self.retranslate()

    def show_step(self, step: str) -> None:
        """Another step: its title, purpose, instruction and own panel."""
        if step != self._step:
            self._step = step
            for panel in self.panels.values():
                panel.setVisible(panel is self.panels[step])
            self.scroll.verticalScrollBar().setValue(0)
        texts = texts_of(step)
        self.title.setText(step_word(step))
        self.purpose.setText(texts.purpose)
        self.instruction.setText(texts.instruction)
        self.picture.show_picture(texts.picture)
        self.live.show_only(texts.live)

    def show_view(self, view: StepView, phase: Phase, *, asked: bool) -> None:
        """Numbers, checks and suggestion of a step in a phase; a question takes the place of the rest."""
        content = view.content
        self.rhythm.show_phase(phase)
        self.picture.setVisible(phase is Phase.PREPARE and not asked)
        self.instruction.setVisible(phase is Phase.PREPARE and not asked)
        self.live.set_wanted(asked or phase in (Phase.PREPARE, Phase.ACQUIRE))
        self.purpose.setVisible(not asked)
        for button in (self.solve_button, self.start_over_button):
            button.setVisible(not asked)
        self.numbers.show_numbers(content.numbers if content is not None else ())
        self.checks.show_checks(content.checks if content is not None else ())
        self.suggestion.show_suggestion(content.suggestion if content is not None and not asked else None)

    def show_primary(self, primary: Primary, *, asked: bool) -> None:
        """The primary button; while a question is asked its own buttons are the primary ones."""
        self._primary = primary
        usable = primary.enabled and not asked
        if self.primary_button.hasFocus() and not usable:
            self._park_focus()
        self.primary_button.setText(primary.text.replace("&", "&&"))
        self.primary_button.setAccessibleName(primary.text)
        self.primary_button.setEnabled(primary.enabled)
        self.primary_button.setVisible(not asked)
        if self._lost_focus and usable and self._focus_is_ours():
            self._lost_focus = False
            self.primary_button.setFocus()

    def await_focus(self) -> None:
        """Who works with the keyboard gets the next thing to do as soon as there is one, be it button or question."""
        self._park_focus()
        if self.primary_button.isEnabled() and not self.primary_button.isHidden():
            self._lost_focus = False
            self.primary_button.setFocus()

    def _park_focus(self) -> None:
        """Not on to whatever control comes next: Enter would press that one."""
        self._lost_focus = True
        self.scroll.setFocus()

    def focus_question(self) -> None:
        """A question can be answered now: by the keyboard at once, if the keyboard was here."""
        if self._focus_is_ours():
            self._lost_focus = True
            self.question.take_focus()

    def _focus_is_ours(self) -> bool:
        focus = QApplication.focusWidget()
        return focus is None or self.isAncestorOf(focus)

    def retranslate(self) -> None:
        """Write again in the present language."""
        self.setAccessibleName(self.tr("What to do and how good it is"))
        self.solve_button.setText(self.tr("Solve a&gain"))
        self.solve_button.setToolTip(self.tr("Solve from the samples that are ticked"))
        self.start_over_button.setText(self.tr("S&tart over"))
        self.start_over_button.setToolTip(self.tr("Delete all samples of this step; undo brings them back"))
        for button in (self.solve_button, self.start_over_button):
            button.setAccessibleName(button.text().replace("&", ""))
        self.primary_button.setToolTip(self.tr("The next thing to do (Ctrl+Return)"))
        for widget in (
            self.rhythm, self.live, self.question, self.suggestion, self.numbers, self.checks, self.banner,
            self.progress, *self.panels.values(),
        ):  # fmt: skip
            widget.retranslate()
        if self._step:
            self.show_step(self._step)

    def _build(self) -> None:
        self.title, self.purpose, self.instruction = (QLabel(self) for _ in range(3))
        self.title.setObjectName("step_title")
        self.title.setProperty("title", "1")
        self.purpose.setObjectName("step_purpose")
        self.purpose.setProperty("tone", "muted")
        self.instruction.setObjectName("step_instruction")
        for label in (self.title, self.purpose, self.instruction):
            label.setWordWrap(True)
        self.rhythm = RhythmLine(self)
        self.picture = Picture(self, height=130)
        self.live = LiveValues(self)
        self.question = QuestionPanel(self)
        self.suggestion = SuggestionBox(self)
        self.numbers = NumbersPanel(self)
        self.checks = ChecksList(self)
        self.banner = Banner(self)
        self.progress = ProgressLine(self)
        self.question.answerable.connect(self.focus_question)
        self.question.answered.connect(self.await_focus)
        for panel in self.panels.values():
            panel.setParent(self)
            panel.setVisible(False)
        self._build_buttons()
        layout = QVBoxLayout(self)
        layout.setContentsMargins(8, 6, 8, 8)
        layout.setSpacing(6)
        for widget in (self.title, self.purpose, self.rhythm):
            layout.addWidget(widget)
        layout.addWidget(self._scroll_area(), 1)
        # The question takes the place of the primary button, so that the eye stays where it is.
        for widget in (self.banner, self.progress, self.question, self.primary_button):
            layout.addWidget(widget)
        layout.addLayout(self._secondary)

    def _scroll_area(self) -> TallScroll:
        body = QWidget(self)
        inside = QVBoxLayout(body)
        inside.setContentsMargins(0, 2, 6, 2)
        inside.setSpacing(8)
        widgets = (
            self.picture, self.instruction, self.live, self.suggestion, *self.panels.values(), self.numbers,
            self.checks,
        )  # fmt: skip
        for widget in widgets:
            inside.addWidget(widget)
        inside.addStretch(1)
        self.scroll = TallScroll(body, self)
        self.scroll.setObjectName("side_scroll")
        self.scroll.setMinimumHeight(px(40))
        return self.scroll

    def _build_buttons(self) -> None:
        self.primary_button = QPushButton(self)
        self.primary_button.setObjectName("primary_button")
        self.primary_button.setProperty("primary", "true")
        self.primary_button.setAutoDefault(True)  # pressed by Enter too
        self.primary_button.clicked.connect(self._press)
        shortcut = QShortcut(QKeySequence("Ctrl+Return"), self)
        shortcut.activated.connect(self.primary_button.click)
        self.solve_button, self.start_over_button = QPushButton(self), QPushButton(self)
        self.solve_button.setObjectName("solve_button")
        self.start_over_button.setObjectName("start_over_button")
        self.solve_button.clicked.connect(self.solve_wanted)
        self.start_over_button.clicked.connect(self.start_over_wanted)
        self._secondary = QHBoxLayout()
        self._secondary.setSpacing(6)
        for button in (self.solve_button, self.start_over_button):
            button.setAutoDefault(False)
            self._secondary.addWidget(button, 1)

    def _press(self) -> None:
        self.pressed.emit(self._primary.press)
