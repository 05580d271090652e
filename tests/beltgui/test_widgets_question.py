"""What the person is asked: done or not now; a motion once, or while a button is held and not a moment longer."""

from collections.abc import Callable
from dataclasses import replace
from typing import Any

import pytest
from PySide6.QtCore import QEvent, QPoint, Qt
from PySide6.QtGui import QFocusEvent, QKeyEvent
from PySide6.QtWidgets import QApplication
from pytestqt.qtbot import QtBot

from beltgui.engine.messages import Answer, Hold
from beltgui.widgets.hold_button import HoldButton
from beltgui.widgets.question_panel import QuestionPanel
from tests.beltgui.wizard_canned import motion, mounting


@pytest.fixture(autouse=True)
def at_once(monkeypatch: pytest.MonkeyPatch) -> None:
    """A question can be answered as soon as it is asked."""
    monkeypatch.setattr("beltgui.widgets.question_panel.ARM_MS", 0)


@pytest.fixture
def panel(qtbot: QtBot) -> QuestionPanel:
    made = QuestionPanel()
    qtbot.addWidget(made)
    made.show()
    return made


@pytest.fixture
def said(panel: QuestionPanel) -> list[Any]:
    commands: list[Any] = []
    panel.command.connect(commands.append)
    return commands


@pytest.fixture
def button(qtbot: QtBot) -> HoldButton:
    made = HoldButton()
    qtbot.addWidget(made)
    made.resize(120, 50)
    made.show()
    return made


@pytest.fixture
def held(button: HoldButton) -> list[bool]:
    states: list[bool] = []
    button.held.connect(states.append)
    return states


def space(button: HoldButton, kind: QEvent.Type, repeat: bool = False) -> None:
    QApplication.sendEvent(button, QKeyEvent(kind, Qt.Key.Key_Space, Qt.KeyboardModifier.NoModifier, " ", repeat))


# ---- the button


def test_held_with_the_mouse(qtbot: QtBot, button: HoldButton, held: list[bool]) -> None:
    qtbot.mousePress(button, Qt.MouseButton.LeftButton)
    assert button.is_held
    qtbot.mouseRelease(button, Qt.MouseButton.LeftButton)
    assert held == [True, False]


def test_other_mouse_buttons_and_return_do_nothing(qtbot: QtBot, button: HoldButton, held: list[bool]) -> None:
    qtbot.mousePress(button, Qt.MouseButton.RightButton)
    qtbot.mouseRelease(button, Qt.MouseButton.RightButton)
    qtbot.keyClick(button, Qt.Key.Key_Return)
    assert held == []


def test_held_with_space_without_repetition(button: HoldButton, held: list[bool]) -> None:
    space(button, QEvent.Type.KeyPress)
    for _ in range(3):
        space(button, QEvent.Type.KeyRelease, repeat=True)
        space(button, QEvent.Type.KeyPress, repeat=True)
    assert held == [True]
    space(button, QEvent.Type.KeyRelease)
    assert held == [True, False]


def test_a_repetition_alone_never_presses(button: HoldButton, held: list[bool]) -> None:
    space(button, QEvent.Type.KeyPress, repeat=True)
    assert held == []


def test_leaving_lets_go_and_coming_back_does_not_press_again(
    qtbot: QtBot, button: HoldButton, held: list[bool]
) -> None:
    qtbot.mousePress(button, Qt.MouseButton.LeftButton)
    qtbot.mouseMove(button, QPoint(300, 300))
    assert held == [True, False]
    qtbot.mouseMove(button, QPoint(10, 10))
    assert held == [True, False]


LOSSES: dict[str, Callable[[HoldButton], Any]] = {
    "focus": lambda button: QApplication.sendEvent(button, QFocusEvent(QEvent.Type.FocusOut)),
    "disabled": lambda button: button.setEnabled(False),
    "hidden": lambda button: button.hide(),
    "leave": lambda button: QApplication.sendEvent(button, QEvent(QEvent.Type.Leave)),
}


@pytest.mark.parametrize("loss", LOSSES)
def test_whatever_happens_it_is_let_go(qtbot: QtBot, button: HoldButton, held: list[bool], loss: str) -> None:
    space(button, QEvent.Type.KeyPress)
    LOSSES[loss](button)
    assert held == [True, False]
    assert not button.isDown()


def test_a_window_that_is_not_active_any_more_lets_go(
    button: HoldButton, held: list[bool], monkeypatch: pytest.MonkeyPatch
) -> None:
    space(button, QEvent.Type.KeyPress)
    monkeypatch.setattr(button, "isActiveWindow", lambda: False)
    QApplication.sendEvent(button, QEvent(QEvent.Type.ActivationChange))
    assert held == [True, False]


# ---- the panel


def test_mounting_is_done_or_not(panel: QuestionPanel, said: list[Any]) -> None:
    panel.ask(mounting(3))
    assert panel.picture.name == "mount ball"
    assert "Mount the ball on the flange" in panel.text()
    assert panel.move_button.isHidden()
    assert panel.series.isHidden()
    panel.done_button.click()
    panel.done_button.click()
    panel.not_now_button.click()
    assert said == [Answer(3, yes=True)]
    panel.ask(None)
    assert panel.isHidden()
    panel.ask(mounting(4))
    panel.not_now_button.click()
    assert said[1:] == [Answer(4, yes=False)]


def test_how_many_are_done(panel: QuestionPanel) -> None:
    panel.ask(replace(mounting(1), kind="touch", picture="touch cone", done=2, planned=8))
    assert panel.title.text().endswith("3/8")


def test_a_motion_says_its_path_before_it_is_let_go(panel: QuestionPanel, said: list[Any]) -> None:
    panel.ask(motion(5))
    assert "312 mm" in panel.text()
    assert "3.4 s" in panel.text()
    assert "120 mm/s" in panel.text()
    assert "250 mm/s" in panel.text()
    assert panel.done_button.isHidden()
    assert said == []
    panel.move_button.click()
    assert said == [Answer(5, yes=True)]


def test_the_whole_series_is_asked_for_each_time_anew(panel: QuestionPanel, said: list[Any]) -> None:
    panel.ask(motion(5))
    panel.series.setChecked(True)
    panel.move_button.click()
    assert said == [Answer(5, yes=True, for_series=True)]
    panel.ask(motion(6))
    assert not panel.series.isChecked()


def test_no_key_starts_a_motion_by_accident(qtbot: QtBot, panel: QuestionPanel, said: list[Any]) -> None:
    panel.ask(motion(5))
    qtbot.keyClick(panel, Qt.Key.Key_Return)
    qtbot.keyClick(panel.hold_button, Qt.Key.Key_Return)
    assert said == []


def test_holding_moves_and_letting_go_stops(qtbot: QtBot, panel: QuestionPanel, said: list[Any]) -> None:
    panel.ask(motion(5))
    qtbot.mousePress(panel.hold_button, Qt.MouseButton.LeftButton)
    assert said == [Answer(5, yes=True, hold=True), Hold(True)]
    panel.ask(None)
    assert not panel.isHidden()
    assert panel.hold_button.is_held
    qtbot.mouseRelease(panel.hold_button, Qt.MouseButton.LeftButton)
    assert said[-1] == Hold(False)


def test_while_held_it_is_said_again_and_again(qtbot: QtBot, panel: QuestionPanel, said: list[Any]) -> None:
    panel.ask(motion(5))
    qtbot.mousePress(panel.hold_button, Qt.MouseButton.LeftButton)
    qtbot.waitUntil(lambda: said.count(Hold(True)) >= 3)
    qtbot.mouseRelease(panel.hold_button, Qt.MouseButton.LeftButton)
    assert said[-1] == Hold(False)
    assert not panel._alive.isActive()


def test_the_next_motion_wants_a_new_press(qtbot: QtBot, panel: QuestionPanel, said: list[Any]) -> None:
    panel.ask(motion(5))
    qtbot.mousePress(panel.hold_button, Qt.MouseButton.LeftButton)
    panel.ask(None)
    panel.ask(motion(6))
    assert said[-1] == Hold(False)
    assert not panel.hold_button.is_held
    qtbot.mouseRelease(panel.hold_button, Qt.MouseButton.LeftButton)
    qtbot.mousePress(panel.hold_button, Qt.MouseButton.LeftButton)
    assert said[-2:] == [Answer(6, yes=True, hold=True), Hold(True)]


@pytest.mark.parametrize("how", ["end", "let_go", "hide"])
def test_the_hold_ends_with_the_work_stop_or_the_panel(
    qtbot: QtBot, panel: QuestionPanel, said: list[Any], how: str
) -> None:
    panel.ask(motion(5))
    qtbot.mousePress(panel.hold_button, Qt.MouseButton.LeftButton)
    getattr(panel, how)()
    assert said[-1] == Hold(False)


def test_too_fast_a_motion_cannot_be_let_go(qtbot: QtBot, panel: QuestionPanel, said: list[Any]) -> None:
    panel.ask(replace(motion(5), speed_mm_s=251.0))
    assert "▲ Too fast" in panel.text()
    panel.move_button.click()
    qtbot.mousePress(panel.hold_button, Qt.MouseButton.LeftButton)
    assert said == []
    panel.not_now_button.click()
    assert said == [Answer(5, yes=False)]


def test_words_again_in_another_language(panel: QuestionPanel) -> None:
    panel.ask(motion(5))
    panel.retranslate()
    assert panel.hold_button.accessibleName() == "Hold to move"
    assert "312 mm" in panel.text()
