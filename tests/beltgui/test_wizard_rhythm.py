"""Which phase a step is in, what the one primary button does then, and what the banner says."""

from dataclasses import replace
from typing import Any

import pytest
from PySide6.QtWidgets import QApplication
from pytestqt.qtbot import QtBot

from beltgui.steps.state import STEPS, StepState
from beltgui.viewmodel.step import Action, StepView
from beltgui.widgets.banner import BannerKind
from beltgui.wizard.rhythm import Phase, Press, RhythmLine, phase_of, primary_of
from beltgui.wizard.texts import texts_of
from beltgui.wizard.verdict import verdict_of
from tests.beltgui.wizard_canned import CHECKS, REASON, content, empty, view

GO_ON = {Action.ACQUIRE, Action.SOLVE}
OPEN = {Action.SOLVE, Action.START_OVER}
CASES: list[tuple[str, StepView, Phase, Press, str, bool, BannerKind | None]] = [
    ("nothing yet", empty(), Phase.PREPARE, Press.ACQUIRE, "Mount and scan", True, None),
    ("cannot begin", StepView("base", 1, StepState.NOT_STARTED, "", ("Accept the ball step first.",), frozenset(),
                              content(0, numbers=(), ok=None)),
     Phase.PREPARE, Press.ACQUIRE, "Mount and scan", False, BannerKind.BLOCKED),
    ("being restored", StepView("ball", 1, StepState.NOT_STARTED, "", (), frozenset(), None),
     Phase.PREPARE, Press.WAIT, "Restoring the session …", False, BannerKind.INFO),
    ("some", view(count=7, ok=None, numbers=(), reasons=(REASON,), actions=GO_ON),
     Phase.ACQUIRE, Press.ACQUIRE, "Go on (7 of 20 scans)", True, BannerKind.MISSING),
    ("some, provisional", view(count=7, provisional=True, actions=GO_ON),
     Phase.ACQUIRE, Press.ACQUIRE, "Go on (7 of 20 scans)", True, BannerKind.PROVISIONAL),
    ("all, not solved", view(ok=None, numbers=(), actions=OPEN),
     Phase.RESULT, Press.SOLVE, "Solve", True, BannerKind.MISSING),
    ("pairs still to pick", StepView("rough", 1, StepState.RUNNING, "", (), frozenset(OPEN),
                                     replace(content(0, numbers=(), ok=None, reasons=(REASON,)), complete=True)),
     Phase.RESULT, Press.SOLVE, "Solve", True, BannerKind.MISSING),
    ("good", view(actions={Action.ACCEPT, *OPEN}), Phase.ACCEPT, Press.ACCEPT, "Accept", True, BannerKind.OK),
    ("bad", view(ok=False, reasons=(REASON,), actions=OPEN),
     Phase.RESULT, Press.ACCEPT, "Accept", False, BannerKind.REJECTED),
    ("check failed", view(ok=False, reasons=(REASON,), checks=CHECKS, actions=OPEN),
     Phase.CHECK, Press.ACCEPT, "Accept", False, BannerKind.REJECTED),
    ("failed", view(state=StepState.FAILED, ok=None, numbers=(), why=("The scanner is off.",), actions=OPEN),
     Phase.RESULT, Press.SOLVE, "Solve", True, BannerKind.FAILED),
    ("accepted", view(state=StepState.ACCEPTED, actions=OPEN),
     Phase.DONE, Press.NEXT, "Next step: Base", True, BannerKind.ACCEPTED),
    ("accepted, another result", view(state=StepState.ACCEPTED, actions={Action.ACCEPT, *OPEN}),
     Phase.ACCEPT, Press.ACCEPT, "Accept", True, BannerKind.OK),
    ("stale", view(state=StepState.STALE, why=("Base moved by 0.1 mm.",), actions=OPEN),
     Phase.ACCEPT, Press.SOLVE, "Solve again", True, BannerKind.STALE),
    ("stale, solved again", view(state=StepState.STALE, actions={Action.ACCEPT, *OPEN}),
     Phase.ACCEPT, Press.ACCEPT, "Accept", True, BannerKind.OK),
    ("last", view("error_surface", state=StepState.ACCEPTED, actions={Action.EXPORT}),
     Phase.DONE, Press.EXPORT, "Write robot programs …", True, BannerKind.ACCEPTED),
    ("last, locked", view("error_surface", state=StepState.ACCEPTED, actions=OPEN),
     Phase.DONE, Press.EXPORT, "Write robot programs …", False, BannerKind.ACCEPTED),
]  # fmt: skip


@pytest.mark.parametrize("case", CASES, ids=[case[0] for case in CASES])
def test_each_phase_has_its_primary_button_and_verdict(qapp: QApplication, case: Any) -> None:
    _, shown, phase, press, text, enabled, kind = case
    primary = primary_of(shown)
    assert phase_of(shown) is phase
    assert (primary.press, primary.text, primary.enabled) == (press, text, enabled)
    assert verdict_of(shown)[0] is kind


def test_while_work_is_under_way_nothing_else_can_be_begun(qapp: QApplication) -> None:
    assert not primary_of(view(), busy=True).enabled
    assert phase_of(empty(), acquiring=True) is Phase.ACQUIRE


def test_who_only_looks_can_only_go_to_the_next_step(qapp: QApplication) -> None:
    assert not primary_of(view(), read_only=True).enabled
    assert not primary_of(empty(), read_only=True).enabled
    assert primary_of(view(state=StepState.ACCEPTED, actions=OPEN), read_only=True).enabled


def test_the_verdict_says_why_and_what_to_do(qapp: QApplication) -> None:
    kind, headline, lines, more = verdict_of(view(ok=False, reasons=(REASON,), remarks=("Remark.",), actions=OPEN))
    assert kind is BannerKind.REJECTED
    assert headline == "RMS 0.021 mm over 20 scans"
    assert lines == (REASON.message,)
    assert more == ("Remark.",)  # for who wants to know: on demand
    _, headline, lines, _ = verdict_of(view(state=StepState.STALE, why=("Base moved by 0.1 mm.",), actions=OPEN))
    assert (headline, lines) == ("Stale because:", ("Base moved by 0.1 mm.",))
    _, headline, _, _ = verdict_of(view(provisional=True, ok=False, actions=GO_ON))
    assert headline.startswith("so far not good enough: ")


def test_the_line_marks_the_present_phase_by_shape(qtbot: QtBot) -> None:
    line = RhythmLine()
    qtbot.addWidget(line)
    line.show_phase(Phase.CHECK)
    assert "▶check" in line.text()
    assert line.text().count("✔") == 3
    assert line.accessibleName() == "Phase of the step: check"
    line.show_phase(Phase.DONE)
    assert line.text().count("✔") == 5


def test_every_step_has_its_texts(qapp: QApplication) -> None:
    for step in STEPS:
        texts = texts_of(step)
        assert texts.purpose
        assert texts.instruction
        assert texts.begin
