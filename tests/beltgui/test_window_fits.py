"""On the smallest screen nothing is cut off and nothing makes the window larger: every step, phase, language, theme."""

from collections.abc import Iterator
from dataclasses import replace
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from PySide6.QtCore import QEvent, QPoint, QSettings, Qt
from PySide6.QtWidgets import QAbstractButton, QApplication, QLabel, QWidget
from pytestqt.qtbot import QtBot

from beltgui.app import language, settings
from beltgui.app.elided import ElidedLabel
from beltgui.app.theme import theme
from beltgui.app.window import MainWindow
from beltgui.engine.messages import (
    CellMoved,
    DevicesChanged,
    DeviceState,
    JobEnded,
    JobProgress,
    JobStarted,
    Question,
    QuestionGone,
    StepChanged,
)
from beltgui.steps.state import STEPS, StepState
from beltgui.viewmodel.step import Action, StepView
from beltgui.wizard.page import StepPage
from tests.beltgui.fake_engine import READY, FakeEngine, opened
from tests.beltgui.test_wizard_panels import CHOICES, FACES_TABLE, TABLES
from tests.beltgui.wizard_canned import CHECKS, REASON, FakeScene, content, empty, motion, mounting, view

WIDTH, HEIGHT = 1280, 800
# Of the screen, what the desktop itself may need.
DESKTOP_PX = 40
REMARK = "Stylus, least certain together: +0.70 tip z in flange, -0.69 pivot z in base."
EXTRAS: dict[str, dict[str, Any]] = {
    "ball": {"suggested": [1.0, 2.0, 3.0, 4.0], "extra": []},
    "base": {"suggested": {}, "extra": []},
    "rough": {"method": "pairs", "pairs": (), "message": "Now click the same point on the CAD model."},
    "fine": {"chosen_faces": (1, 2), "default_faces": (1, 2, 3), "faces_table": FACES_TABLE, "scenes": {}},
    "tool": {"suggested": {"grinder": "fine", "angle_deg": 30.0}, "parts": (
        {"grinder": "", "done": 12, "planned": 12},
        {"grinder": "rough", "done": 2, "planned": 6, "rest": False},
        {"grinder": "fine", "done": 6, "planned": 6, "rest": True},
    )},
    "error_surface": {"choices": CHOICES, "tables": TABLES},
}  # fmt: skip
DEVICES = tuple(
    DeviceState(name, "simulated", "") for name in ("scanner", "stage", "robot", "grinder rough", "grinder fine")
)


class Desk:
    """A window of the smallest size with an engine that says what a step could say."""

    def __init__(self, qtbot: QtBot) -> None:
        self.qtbot = qtbot
        self.engine = FakeEngine()
        self.generation = 10
        self.number = 0
        self.window = MainWindow(self.engine.client, make_page=lambda parent: StepPage(FakeScene(), parent))
        self.window.closed.connect(self.engine.client.close)
        self.window.resize(WIDTH, HEIGHT)
        self.window.show()
        qtbot.waitExposed(self.window)
        self.window.add_page()
        pose = np.eye(4)
        pose[:3, 3] = -1234.56, -1234.56, -1234.56
        moved = CellMoved(pose, (-123.4, -12.3, 123.4, -12.3), True, 249.0,
                          {"rough": -12.3, "fine": 12.3}, {"rough": 12.3, "fine": 3.2})  # fmt: skip
        self.say(READY, opened(), *(StepChanged(empty(step)) for step in STEPS), DevicesChanged(DEVICES), moved)

    def say(self, *events: Any) -> None:
        last = events[-1]
        with self.qtbot.waitSignal(self.engine.client.event, check_params_cb=lambda event: event is last):
            self.engine.say(*events)

    def show(self, shown: StepView) -> None:
        self.generation += 1
        self.say(StepChanged(replace(shown, generation=self.generation)))

    def ask(self, step: str, question: Question) -> None:
        self.number += 1
        job = JobStarted(self.number, "Taking samples", step, motion=True)
        self.say(job, JobProgress(self.number, 0.5, "grinder fine: shaft at -25 degrees"),
                 replace(question, number=self.number))  # fmt: skip

    def end_job(self) -> None:
        self.say(QuestionGone(self.number), JobEnded(self.number, "done"))

    def end(self) -> None:
        self.engine.client.close()
        self.window.close()
        self.window.deleteLater()
        QApplication.sendPostedEvents(None, QEvent.Type.DeferredDelete)


@pytest.fixture(params=["light", "dark"])
def desk(request: pytest.FixtureRequest, qtbot: QtBot, tmp_path: Path) -> Iterator[Desk]:
    QSettings.setPath(QSettings.Format.IniFormat, QSettings.Scope.UserScope, str(tmp_path / "settings"))
    settings.keep("tour_seen", "yes")
    theme().choose(request.param)
    at = Desk(qtbot)
    yield at
    at.end()
    theme().choose("light")
    language.install(language.ENGLISH)


def cut_off(window: QWidget) -> list[str]:
    """What is seen but not whole."""
    found = []
    for label in window.findChildren(QLabel):
        if not label.isVisible() or not label.text() or isinstance(label, ElidedLabel):
            continue
        if label.wordWrap():
            whole = label.height() >= label.heightForWidth(label.width()) - 1
        else:
            whole = label.width() >= label.sizeHint().width() - 1 and label.height() >= label.sizeHint().height() - 1
        if not whole:
            found.append(f"{label.objectName()} '{label.text()}' has {label.size()}, needs {label.sizeHint()}")
    for button in window.findChildren(QAbstractButton):
        if button.isVisible() and button.text() and button.width() < button.minimumSizeHint().width():
            found.append(f"button '{button.text()}' has {button.size()}, needs {button.minimumSizeHint()}")
    return found


def check(desk: Desk, where: str) -> None:
    """Nothing is cut off, wider than its place, or outside the screen."""
    for _ in range(4):  # a layout within a layout asks for its own turn
        QApplication.sendPostedEvents(None, QEvent.Type.LayoutRequest)
        QApplication.processEvents()
    window = desk.window
    least = window.minimumSizeHint()
    assert least.width() <= WIDTH and least.height() <= HEIGHT - DESKTOP_PX, (where, least)
    assert (window.width(), window.height()) == (WIDTH, HEIGHT), where
    assert cut_off(window) == [], where
    page = window.page
    assert isinstance(page, StepPage)
    scroll = page.side.scroll
    assert scroll.widget().width() <= scroll.viewport().width(), where
    assert scroll.horizontalScrollBar().maximum() == 0, where
    side = page.side
    for widget in (side.banner, side.progress, page.question, side.primary_button, side.solve_button):
        if widget.isVisible():
            end = widget.mapTo(side, QPoint(widget.width(), widget.height()))
            assert end.x() <= side.width() and end.y() <= side.height(), (where, widget.objectName())


@pytest.mark.parametrize("tongue", ["en", "zh_CN"])
@pytest.mark.parametrize("step", STEPS)
def test_every_phase_of_a_step_fits_on_the_smallest_screen(desk: Desk, step: str, tongue: str) -> None:
    language.install(tongue)
    desk.window.look_at(step)
    desk.show(empty(step))
    check(desk, "prepare")
    desk.ask(step, mounting())
    check(desk, "mount")
    desk.end_job()
    part = content(12, extra=EXTRAS[step], complete=False, provisional=True, checks=CHECKS, reasons=(REASON,))
    desk.show(view(step, made=part, actions={Action.ACQUIRE}))
    desk.ask(step, motion())
    check(desk, "motion")
    desk.end_job()
    check(desk, "provisional")
    desk.show(view(step, made=content(extra=EXTRAS[step], checks=CHECKS, remarks=(REMARK,) * 3)))
    check(desk, "good")
    page = desk.window.page
    assert isinstance(page, StepPage)
    page.side.banner.more_button.click()
    page.side.numbers.all_button.setChecked(True)
    check(desk, "all is shown")
    bad = content(extra=EXTRAS[step], ok=False, checks=CHECKS, reasons=(REASON,) * 5, remarks=(REMARK,) * 3)
    desk.show(view(step, made=bad, state=StepState.FAILED, actions={Action.ACQUIRE, Action.SOLVE}))
    check(desk, "rejected")
    desk.show(view(step, made=bad, state=StepState.STALE, why=(REASON.message,) * 4, actions={Action.SOLVE}))
    check(desk, "stale")
    desk.show(view(step, state=StepState.ACCEPTED, made=content(extra=EXTRAS[step]), actions={Action.EXPORT}))
    check(desk, "accepted")


def test_what_has_the_focus_never_moves_the_right_panel_sideways(desk: Desk) -> None:
    desk.window.look_at("error_surface")
    desk.show(view("error_surface", made=content(extra=EXTRAS["error_surface"])))
    page = desk.window.page
    assert isinstance(page, StepPage)
    for _ in range(30):
        desk.qtbot.keyClick(QApplication.focusWidget() or desk.window, Qt.Key.Key_Tab)
        assert page.side.scroll.widget().x() == 0
