"""The person's part: mount or touch something, or let the robot move."""

from __future__ import annotations

from PySide6.QtCore import Qt, QTimer, Signal
from PySide6.QtWidgets import QCheckBox, QFrame, QHBoxLayout, QLabel, QPushButton, QSizePolicy, QVBoxLayout, QWidget

from beltgui.app.language import sentence
from beltgui.engine.messages import Answer, Hold, Question
from beltgui.widgets.figures import with_unit
from beltgui.widgets.hold_button import HoldButton
from beltgui.widgets.pictures import Picture

SPEED_LIMIT_MM_S = 250.0
# While the button is held this is said again and again: a screen that hangs lets the robot stop.
ALIVE_MS = 150
# A question comes where the button just pressed was: the second click of a double click must not answer it.
ARM_MS = 350


class QuestionPanel(QFrame):
    """Asks, and answers with commands.

    A motion is let go once (`Move once`) or while a button is held. After the first hold the panel stays until the
    motion's work is over or something else is asked, so that the button can be let go and held again.

    Signals:
        command: An `Answer` or a `Hold`.
        answerable: A question can be answered from now on.
        answered: It has been.
    """

    command = Signal(object)
    answerable = Signal()
    answered = Signal()

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.setObjectName("question_panel")
        self.setProperty("panel", "true")
        self._question: Question | None = None
        self._answered = False
        self._holding = False
        self._alive = QTimer(self)
        self._alive.setInterval(ALIVE_MS)
        self._alive.timeout.connect(lambda: self.command.emit(Hold(True)))
        self._arming = QTimer(self)
        self._arming.setSingleShot(True)
        self._arming.timeout.connect(self._arm)
        self._build()
        self.setVisible(False)
        self.retranslate()

    @property
    def question(self) -> Question | None:
        """What is asked, or being moved while held; None for nothing."""
        return self._question

    def ask(self, question: Question | None) -> None:
        """Ask; None when the question is gone. A motion that runs while held keeps its button until `end`."""
        if question is None:
            if self._holding:
                self._show_holding()
            else:
                self.end()
            return
        new = self._question is None or question.number != self._question.number
        if self._question is not None and new:
            self._drop_hold()
            self.series.setChecked(False)
        self._question, self._answered = question, False
        if new and ARM_MS:
            self._arming.start(ARM_MS)
        self._show()
        if not self._arming.isActive():
            self.answerable.emit()

    def take_focus(self) -> None:
        """To the button that answers; of a motion the one that moves only while it is held."""
        if self._question is not None:
            (self.hold_button if self._question.kind == "motion" else self.done_button).setFocus()

    def end(self) -> None:
        """The work is over: nothing is asked any more."""
        self._drop_hold()
        self._arming.stop()
        self._question, self._answered = None, False
        self.series.setChecked(False)
        self.setVisible(False)

    def let_go(self) -> None:
        """Let the hold button go, e.g. because Stop was pressed."""
        self.hold_button.let_go()

    def retranslate(self) -> None:
        """Write again in the present language."""
        self.setAccessibleName(self.tr("What you are asked to do"))
        self.done_button.setText(self.tr("&Done"))
        self.not_now_button.setText(self.tr("&Not now"))
        self.move_button.setText(self.tr("&Move once"))
        self.move_button.setToolTip(self.tr("The robot moves along the path shown, once, at reduced speed"))
        self.hold_button.setText(self.tr("Hold to move"))
        self.hold_button.setToolTip(self.tr("The robot moves only while you hold this button or the Space key"))
        self.series.setText(self.tr("the &whole series of this step"))
        self.series.setToolTip(self.tr("Do not ask again for the following motions of this step"))
        self.stop_hint.setText(self.tr("Stop: top right, or F12. It is no safety function."))
        for widget in (self.done_button, self.not_now_button, self.move_button, self.hold_button, self.series):
            widget.setAccessibleName(widget.text().replace("&", ""))
        if self._question is not None:
            self._show()

    def text(self) -> str:
        """All it says now."""
        labels = (self.title, self.instruction, self.motion, self.stop_hint)
        return "\n".join(label.text() for label in labels if not label.isHidden())

    def _build(self) -> None:
        self.title, self.instruction, self.motion, self.stop_hint = (QLabel(self) for _ in range(4))
        self.title.setProperty("title", "2")
        self.instruction.setObjectName("question_text")
        self.motion.setObjectName("question_motion")
        self.stop_hint.setProperty("tone", "muted")
        for label in (self.title, self.instruction, self.motion, self.stop_hint):
            label.setWordWrap(True)
        self.picture = Picture(self, height=84)
        self.picture.setObjectName("question_picture")
        self.series = QCheckBox(self)
        self.series.setObjectName("question_series")
        self.done_button = self._button("question_done", primary=True)
        self.move_button = self._button("question_move", primary=True)
        self.hold_button = HoldButton(self)
        self.hold_button.setObjectName("question_hold")
        self.hold_button.setProperty("primary", "true")
        self.not_now_button = self._button("question_not_now", primary=False)
        self.done_button.clicked.connect(lambda: self._answer(Answer(self._number(), yes=True)))
        self.not_now_button.clicked.connect(self._refuse)
        self.move_button.clicked.connect(self._move_once)
        self.hold_button.held.connect(self._held)
        buttons = QHBoxLayout()
        buttons.setSpacing(6)
        for button in (self.done_button, self.move_button, self.hold_button):
            button.setSizePolicy(QSizePolicy.Policy.Expanding, QSizePolicy.Policy.Fixed)
            buttons.addWidget(button)
        layout = QVBoxLayout(self)
        layout.setContentsMargins(8, 6, 8, 6)
        layout.setSpacing(4)
        for widget in (self.title, self.picture, self.instruction, self.motion, self.series):
            layout.addWidget(widget)
        layout.addLayout(buttons)
        last = QHBoxLayout()
        last.addWidget(self.stop_hint, 1)
        last.addWidget(self.not_now_button, 0, Qt.AlignmentFlag.AlignRight)
        layout.addLayout(last)
        self.setSizePolicy(QSizePolicy.Policy.Preferred, QSizePolicy.Policy.Maximum)

    def _button(self, name: str, *, primary: bool) -> QPushButton:
        button = QPushButton(self)
        button.setObjectName(name)
        button.setAutoDefault(primary)  # pressed by Enter too
        if primary:
            button.setProperty("primary", "true")
        return button

    def _show(self) -> None:
        question = self._question
        assert question is not None
        moves = question.kind == "motion"
        titles = {"motion": self.tr("The robot wants to move"), "touch": self.tr("Touch with the stylus")}
        title = titles.get(question.kind, self.tr("Please mount"))
        if question.planned:
            title += f"  {question.done + 1}/{question.planned}"
        self.title.setText(title)
        self.picture.show_picture(question.picture)
        self.instruction.setText(sentence(question.text))
        self.motion.setText(self._motion_text(question) if moves else "")
        for widget in (self.motion, self.series, self.move_button, self.hold_button, self.stop_hint):
            widget.setVisible(moves)
        self.done_button.setVisible(not moves)
        self.not_now_button.setVisible(True)
        too_fast = moves and question.speed_mm_s > SPEED_LIMIT_MM_S
        open_now = not self._answered and not self._arming.isActive()
        for widget in (self.done_button, self.move_button, self.not_now_button, self.series):
            widget.setEnabled(open_now and not (too_fast and widget is self.move_button))
        self.hold_button.setEnabled(moves and not too_fast and (self._holding or open_now))
        self.setVisible(True)

    def _arm(self) -> None:
        self._show()
        self.answerable.emit()

    def _show_holding(self) -> None:
        self.title.setText(self.tr("The robot moves while you hold"))
        self.motion.setVisible(False)
        self.series.setVisible(False)
        self.move_button.setVisible(False)
        self.not_now_button.setVisible(False)

    def _motion_text(self, question: Question) -> str:
        text = self.tr("Path {length}, {duration}, at most {speed} (limit {limit})").format(
            length=with_unit(question.length_mm, "mm", 0),
            duration=with_unit(question.duration_s, "s", 1),
            speed=with_unit(question.speed_mm_s, "mm/s", 0),
            limit=with_unit(SPEED_LIMIT_MM_S, "mm/s", 0),
        )
        if question.speed_mm_s > SPEED_LIMIT_MM_S:
            text += "\n" + self.tr("▲ Too fast: it cannot be allowed.")
        return text

    def _number(self) -> int:
        assert self._question is not None
        return self._question.number

    def _answer(self, answer: Answer) -> None:
        if self._answered:
            return
        self._answered = True
        if not answer.hold:
            self.answered.emit()
        self.command.emit(answer)
        if self._question is not None:
            self._show()

    def _refuse(self) -> None:
        self._answer(Answer(self._number(), yes=False))

    def _move_once(self) -> None:
        self._answer(Answer(self._number(), yes=True, for_series=self.series.isChecked()))

    def _held(self, held: bool) -> None:
        if self._question is None or not (self._holding or not self._answered):
            return
        if held and not self._answered:
            self._holding = True
            self._answer(Answer(self._number(), yes=True, hold=True, for_series=self.series.isChecked()))
        self.command.emit(Hold(held))
        if held:
            self._alive.start()
        else:
            self._alive.stop()

    def _drop_hold(self) -> None:
        self.hold_button.let_go()
        self._holding = False
