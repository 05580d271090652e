"""The page: what is pressed becomes a command, old views are dropped, selection is shared, questions and work."""

from collections.abc import Iterator
from dataclasses import replace
from typing import Any

import numpy as np
import pytest
from PySide6.QtCore import QEvent, QPoint, Qt
from PySide6.QtWidgets import QApplication, QLabel, QPushButton, QWidget
from pytestqt.qtbot import QtBot

from beltgui.app.theme import theme
from beltgui.engine.messages import (
    Accept,
    Acquire,
    Answer,
    CellMoved,
    Delete,
    Hold,
    Include,
    JobProgress,
    JobStarted,
    Redo,
    Solve,
    StartOver,
    Undo,
)
from beltgui.steps.state import STEPS, StepState
from beltgui.viewmodel.step import Action
from beltgui.wizard.page import StepPage
from tests.beltgui.wizard_canned import REASON, FakeScene, empty, motion, mounting, rows, view

SCAN = JobStarted(1, "Scanning the ball", "ball", motion=True)
SOLVE = JobStarted(2, "Solving", "ball", motion=False)
NAMES = (
    "step_page", "right_panel", "step_title", "step_purpose", "rhythm", "scene_view", "banner", "banner_copy",
    "numbers",
    "checks", "suggestion", "live_values", "step_progress", "banner_more", "primary_button", "solve_button",
    "start_over_button", "samples_table", "undo_button", "redo_button", "delete_button", "plots", "plot_tabs",
    "question_panel", "question_done", "question_not_now", "question_move", "question_hold", "question_series",
    *(f"panel_{step}" for step in STEPS),
)  # fmt: skip


@pytest.fixture(autouse=True)
def at_once(monkeypatch: pytest.MonkeyPatch) -> None:
    """A question can be answered as soon as it is asked."""
    monkeypatch.setattr("beltgui.widgets.question_panel.ARM_MS", 0)


@pytest.fixture
def page(qtbot: QtBot) -> Iterator[StepPage]:
    made = StepPage(FakeScene())
    qtbot.addWidget(made)
    made.resize(1086, 710)
    made.show()
    yield made
    made.shut_down()
    assert made.scene.told["closed"]


@pytest.fixture
def said(page: StepPage) -> list[Any]:
    commands: list[Any] = []
    page.command.connect(commands.append)
    return commands


def button(page: StepPage, name: str) -> QPushButton:
    return page.findChild(QPushButton, name)


def test_everything_is_found_by_its_name_and_has_one_to_be_read(page: StepPage) -> None:
    for name in NAMES:
        found = [page] if name == "step_page" else page.findChildren(QWidget, name)
        assert len(found) == 1, name
    for child in page.findChildren(QPushButton):
        if child.isVisible():
            assert child.accessibleName(), child.objectName()


@pytest.mark.parametrize("step", STEPS)
def test_every_step_is_shown_and_has_its_title(page: StepPage, step: str) -> None:
    page.set_step(step)
    page.show_step(view(step))
    assert page.findChild(QLabel, "step_title").text()
    assert page.findChild(QWidget, f"panel_{step}").isVisibleTo(page.side) or step in ("ball", "base", "tool")
    assert not page.grab().isNull()
    with pytest.raises(ValueError, match="expected one of"):
        page.set_step("nose")


def test_the_primary_button_goes_through_the_rhythm(page: StepPage, said: list[Any], qtbot: QtBot) -> None:
    primary = button(page, "primary_button")
    page.show_step(empty())
    assert primary.text() == "Mount and scan"
    primary.click()
    page.show_step(view(generation=2, count=7, ok=None, numbers=(), actions={Action.ACQUIRE}))
    assert primary.text() == "Go on (7 of 20 scans)"
    primary.click()
    page.show_step(view(generation=3, actions={Action.ACCEPT, Action.SOLVE}))
    assert primary.text() == "Accept"
    primary.click()
    assert said == [Acquire("ball"), Acquire("ball"), Accept("ball")]
    page.show_step(view(generation=4, state=StepState.ACCEPTED, actions={Action.SOLVE}))
    with qtbot.waitSignal(page.step_wanted) as wanted:
        primary.click()
    assert wanted.args == ["base"]


def test_the_primary_button_is_large_and_pressed_by_ctrl_return(qtbot: QtBot, page: StepPage, said: list[Any]) -> None:
    page.show_step(empty())
    qtbot.waitActive(page)
    qtbot.keyClick(page, Qt.Key.Key_Return, Qt.KeyboardModifier.ControlModifier)
    assert said == [Acquire("ball")]


def test_a_view_out_of_date_is_dropped(page: StepPage) -> None:
    page.show_step(view(generation=5))
    page.show_step(view(generation=4, count=3))
    assert page.samples.model.rowCount() == 20
    page.show_step(view(generation=5, count=4))
    assert page.samples.model.rowCount() == 4
    page.forget()
    assert page.samples.model.rowCount() == 0
    page.show_step(view(generation=1, count=2))
    assert page.samples.model.rowCount() == 2


def test_views_of_other_steps_are_kept_and_not_shown(page: StepPage) -> None:
    page.show_step(view("ball", count=3))
    page.show_step(view("base", count=9))
    assert page.samples.model.rowCount() == 3
    page.set_step("base")
    assert page.samples.model.rowCount() == 9


def test_edits_are_commands_of_the_step(page: StepPage, said: list[Any], qtbot: QtBot) -> None:
    page.set_step("base")
    page.show_step(view("base"))
    page.samples.choose(4)
    qtbot.keyClick(page.samples.view, Qt.Key.Key_Space)
    qtbot.keyClick(page.samples.view, Qt.Key.Key_Delete)
    for name in ("undo_button", "redo_button", "solve_button", "start_over_button"):
        page.findChild(QWidget, name).click()
    assert said == [
        Include("base", 4, on=False), Delete("base", 4), Undo("base"), Redo("base"), Solve("base"), StartOver("base"),
    ]  # fmt: skip


def test_what_is_not_offered_is_disabled(page: StepPage) -> None:
    page.show_step(view(actions=()))
    for name in ("undo_button", "redo_button", "solve_button", "start_over_button", "primary_button"):
        assert not page.findChild(QWidget, name).isEnabled()


def test_who_only_looks_changes_nothing(page: StepPage, said: list[Any], qtbot: QtBot) -> None:
    page.set_read_only(True)
    page.show_step(view())
    page.samples.choose(4)
    qtbot.keyClick(page.samples.view, Qt.Key.Key_Space)
    for name in ("undo_button", "redo_button", "solve_button", "start_over_button", "primary_button", "delete_button"):
        page.findChild(QWidget, name).click()
    assert said == []


def test_a_row_and_its_mark_are_chosen_together(page: StepPage) -> None:
    page.show_step(view())
    page.samples.choose(4)
    canvas = page.plots.canvas("residuals")
    assert len(canvas._ring.getData()[0]) == 1
    page.plots.chosen.emit(9)
    assert page.samples.chosen_id() == 9
    page.show_step(view(generation=2, rows=tuple(replace(row, flag="") for row in rows())))
    assert page.samples.chosen_id() == 9
    assert len(canvas._ring.getData()[0]) == 1


def test_work_shows_its_progress(page: StepPage) -> None:
    page.show_step(empty())
    page.show_job(SCAN, JobProgress(1, 0.35, "scan 7 of 20"))
    progress = page.side.progress
    assert progress.isVisible()
    assert progress.bar.value() == 350
    assert progress.text_label.text() == "Scanning the ball: scan 7 of 20"
    assert not button(page, "primary_button").isEnabled()
    assert page.side.rhythm.accessibleName().endswith("acquire")
    page.show_job(None)
    assert progress.isHidden()
    assert button(page, "primary_button").isEnabled()


def test_samples_can_be_edited_while_it_solves_but_not_while_it_moves(page: StepPage) -> None:
    page.show_step(view())
    page.samples.choose(4)
    page.show_job(SOLVE)
    assert page.samples.delete_button.isEnabled()
    assert page.samples.undo_button.isEnabled()
    assert not button(page, "solve_button").isEnabled()
    page.show_job(SCAN)
    assert not page.samples.delete_button.isEnabled()
    assert not page.samples.undo_button.isEnabled()


def test_the_keyboard_comes_back_to_the_primary_button(qtbot: QtBot, page: StepPage) -> None:
    page.show_step(view())
    qtbot.waitActive(page)
    primary = button(page, "primary_button")
    primary.setFocus()
    page.show_job(SOLVE)
    assert not primary.hasFocus()
    page.show_job(None)
    assert primary.hasFocus()


def test_a_question_takes_the_place_of_the_primary_button(page: StepPage, said: list[Any]) -> None:
    page.show_step(empty())
    page.show_job(SCAN)
    page.show_question(mounting(1))
    assert button(page, "primary_button").isHidden()
    assert page.side.banner.isHidden()
    button(page, "question_done").click()
    assert said == [Answer(1, yes=True)]
    page.show_question(None)
    assert not button(page, "primary_button").isHidden()


def test_a_motion_is_drawn_before_it_is_let_go(page: StepPage, said: list[Any], qtbot: QtBot) -> None:
    page.show_step(empty())
    page.show_job(SCAN)
    question = motion(7)
    page.show_question(question)
    assert page.scene.told["motion"] is question.path
    qtbot.mousePress(page.question.hold_button, Qt.MouseButton.LeftButton)
    page.show_question(None)
    assert page.scene.told["motion"] is None
    page.stop_pressed()
    assert said == [Answer(7, yes=True, hold=True), Hold(True), Hold(False)]
    page.show_job(None)
    assert page.question.isHidden()


def test_the_end_of_the_work_lets_go(page: StepPage, said: list[Any], qtbot: QtBot) -> None:
    page.show_job(SCAN)
    page.show_question(motion(7))
    qtbot.mousePress(page.question.hold_button, Qt.MouseButton.LeftButton)
    page.show_job(None)
    assert said[-1] == Hold(False)


def test_live_values_have_units(page: StepPage) -> None:
    page.show_step(empty())
    pose = np.eye(4)
    pose[:3, 3] = 100.0, -20.5, 300.25
    page.show_cell(CellMoved(pose, (1.0, 2.0, 3.0, 4.0), True, 120.0, {"fine": 12.5}, {"fine": 3.25}))
    text = page.side.live.text()
    assert "100.0, -20.5, 300.2 mm" in text
    assert "120 mm/s" in text
    assert "3.00 mm, 4.00°" in text
    assert page.scene.told["robot"] is not None
    page.set_step("error_surface")
    page.show_step(empty("error_surface"))
    assert "12.50 deg" in page.side.live.text()
    assert "3.2 N" in page.side.live.text()


def test_the_instruction_and_its_picture_are_there_before_the_first_sample(page: StepPage) -> None:
    page.show_step(empty())
    assert page.side.picture.isVisible()
    assert page.side.instruction.isVisible()
    page.show_step(view(generation=2))
    assert page.side.picture.isHidden()


def test_nothing_is_cut_off_at_the_smallest_size(page: StepPage, qtbot: QtBot) -> None:
    page.show_step(view(ok=False, reasons=(REASON,) * 4))
    page.show_job(SCAN, JobProgress(1, 0.5, "scan"))
    page.show_question(motion(1))
    assert page.minimumSizeHint().width() <= 1086
    assert page.minimumSizeHint().height() <= 710
    last = page.question.not_now_button
    assert page.rect().contains(last.mapTo(page, QPoint(last.width() - 1, last.height() - 1)))


def test_the_bottom_is_low_on_a_small_screen_and_stays_where_it_is_put(page: StepPage) -> None:
    page.show_step(view())
    assert 180 <= page.bottom.height() <= 260
    page.left.setSizes([200, 500])
    page.left.splitterMoved.emit(200, 1)
    page.resize(1090, 720)
    assert page.bottom.height() > 300


def test_it_follows_theme_and_language(page: StepPage) -> None:
    page.show_step(view())
    theme().changed.emit()
    QApplication.sendEvent(page, QEvent(QEvent.Type.LanguageChange))
    assert button(page, "primary_button").text() == "Accept"
    assert page.tables.tabText(0) == "Samples"


def test_the_3d_view_is_prepared_when_it_is_seen(page: StepPage) -> None:
    assert page.scene.told["prepared"]
    shown = view()
    page.show_step(shown)
    assert shown.content is not None
    assert page.scene.told["scene"] == (shown.content.scene, None)
