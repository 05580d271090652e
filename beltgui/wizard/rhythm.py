"""The rhythm that all steps share, which phase a step is in, and what the one primary button does then."""

from __future__ import annotations

from dataclasses import dataclass
from enum import Enum

from PySide6.QtCore import QCoreApplication, Qt
from PySide6.QtWidgets import QLabel, QWidget

from beltgui.app.language import sentence
from beltgui.app.theme import colour, px, theme
from beltgui.steps.state import STEPS, StepState
from beltgui.viewmodel.step import Action, StepView
from beltgui.widgets.words import step_word
from beltgui.wizard.texts import texts_of


class Phase(Enum):
    """Phases of a step, in order."""

    PREPARE = 0
    ACQUIRE = 1
    RESULT = 2
    CHECK = 3
    ACCEPT = 4
    DONE = 5


class Press(Enum):
    """What the primary button does."""

    ACQUIRE = "acquire"
    SOLVE = "solve"
    ACCEPT = "accept"
    NEXT = "next"
    EXPORT = "export"
    WAIT = "wait"


@dataclass(frozen=True)
class Primary:
    """The primary button: what it says, what it does, whether it can be pressed."""

    press: Press
    text: str
    enabled: bool = True


def phase_of(view: StepView, acquiring: bool = False) -> Phase:
    """The phase that a step is in; `acquiring` while its samples are being taken."""
    content = view.content
    if acquiring:
        return Phase.ACQUIRE
    if content is None:
        return Phase.PREPARE
    if view.state is StepState.ACCEPTED and Action.ACCEPT not in view.actions:
        return Phase.DONE
    if not content.rows and not content.complete:
        return Phase.PREPARE
    if content.provisional or not content.complete:
        return Phase.ACQUIRE
    if content.ok:
        return Phase.ACCEPT
    return Phase.CHECK if any(check.ok is False for check in content.checks) else Phase.RESULT


def primary_of(view: StepView, *, busy: bool = False, read_only: bool = False) -> Primary:
    """The one thing to do next.

    Args:
        view: The step.
        busy: Work is under way.
        read_only: Nothing may be changed.
    """
    translate = QCoreApplication.translate
    if busy:
        return Primary(Press.WAIT, translate("Primary", "Working …"), enabled=False)
    content, actions = view.content, view.actions
    if content is None:
        return Primary(Press.WAIT, translate("Primary", "Restoring the session …"), enabled=False)
    if Action.ACCEPT in actions and content.ok and not content.provisional:
        return Primary(Press.ACCEPT, translate("Primary", "Accept"), not read_only)
    if view.state is StepState.ACCEPTED:
        return _after(view, read_only)
    if content.complete:  # also where the rows are what a person still has to pick
        return _complete(view, read_only)
    if not content.rows:
        return Primary(Press.ACQUIRE, texts_of(view.step).begin, Action.ACQUIRE in actions and not read_only)
    text = translate("Primary", "Go on ({progress})").format(progress=sentence(content.progress))
    return Primary(Press.ACQUIRE, text, Action.ACQUIRE in actions and not read_only)


def _complete(view: StepView, read_only: bool) -> Primary:
    translate = QCoreApplication.translate
    content = view.content
    assert content is not None
    unsolved = content.ok is None or view.state is StepState.STALE
    if unsolved and Action.SOLVE in view.actions:
        again = content.ok is not None
        text = translate("Primary", "Solve again") if again else translate("Primary", "Solve")
        return Primary(Press.SOLVE, text, not read_only)
    if Action.ACQUIRE in view.actions and content.ok is not True:
        return Primary(Press.ACQUIRE, translate("Primary", "Take more samples"), not read_only)
    return Primary(Press.ACCEPT, translate("Primary", "Accept"), enabled=False)


def _after(view: StepView, read_only: bool) -> Primary:
    translate = QCoreApplication.translate
    place = STEPS.index(view.step) + 1
    if place < len(STEPS):
        text = translate("Primary", "Next step: {step}").format(step=step_word(STEPS[place]))
        return Primary(Press.NEXT, text)
    return Primary(
        Press.EXPORT, translate("Primary", "Write robot programs …"), Action.EXPORT in view.actions and not read_only
    )


def phase_word(phase: Phase) -> str:
    """A phase's word on the rhythm line."""
    translate = QCoreApplication.translate
    return {
        Phase.PREPARE: translate("Rhythm", "prepare"),
        Phase.ACQUIRE: translate("Rhythm", "acquire"),
        Phase.RESULT: translate("Rhythm", "result"),
        Phase.CHECK: translate("Rhythm", "check"),
        Phase.ACCEPT: translate("Rhythm", "accept"),
        Phase.DONE: translate("Rhythm", "done"),
    }[phase]


class RhythmLine(QLabel):
    """`✔ prepare › ▶ acquire › ○ result › ○ check › ○ accept`."""

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.setObjectName("rhythm")
        self.setTextFormat(Qt.TextFormat.RichText)
        self.setWordWrap(True)
        self._phase = Phase.PREPARE
        theme().changed.connect(self.retranslate)
        self.retranslate()

    @property
    def phase(self) -> Phase:
        """The present one."""
        return self._phase

    def show_phase(self, phase: Phase) -> None:
        """Mark the present phase."""
        if phase is not self._phase:
            self._phase = phase
            self.retranslate()

    def retranslate(self) -> None:
        """Write again in the present language and colours."""
        parts = []
        for phase in list(Phase)[:-1]:
            word = phase_word(phase).replace(" ", "&nbsp;")
            if phase.value < self._phase.value:
                parts.append(f'<span style="color:{colour("good")}">✔{word}</span>')
            elif phase is self._phase:
                parts.append(f'<b style="color:{colour("accent")}">▶{word}</b>')
            else:
                parts.append(f'<span style="color:{colour("muted")}">{word}</span>')
        self.setText(f'<span style="font-size:{px(12)}px">' + "&#8202;›&#8202; ".join(parts) + "</span>")
        self.setAccessibleName(self.tr("Phase of the step: {phase}").format(phase=phase_word(self._phase)))
