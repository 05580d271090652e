"""At the window while the robot moves: cancel, stop, let go, close, lose a device, decline; nothing taken is lost."""

from collections.abc import Callable, Iterator
from pathlib import Path

import numpy as np
import pytest
from PySide6.QtCore import QPoint, Qt
from PySide6.QtTest import QTest
from pytestqt.qtbot import QtBot

from beltgui.engine.messages import CellMoved, JobEnded, Question
from beltgui.session import Session
from beltgui.widgets.hold_button import HoldButton
from tests.beltgui.walk_person import LEFT, AtTheWindow, forget_all

# Times real time: a motion of the robot then takes about a second, long enough to be stopped in.
SLOW = 5.0
Opened = Callable[[float], AtTheWindow]


@pytest.fixture
def opened(qtbot: QtBot, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Iterator[Opened]:
    """A window with a new session on a cell of this speed."""
    monkeypatch.setattr("beltgui.widgets.question_panel.ARM_MS", 0)
    forget_all(tmp_path / "settings")
    windows: list[AtTheWindow] = []

    def begin(speed: float) -> AtTheWindow:
        at = AtTheWindow(qtbot, speed=speed)
        windows.append(at)
        at.begin(tmp_path / "session")
        return at

    yield begin
    for at in windows:
        if not at.closed:
            at.close()


def until_the_robot_is_asked(at: AtTheWindow) -> None:
    """The ball is mounted, and the robot wants to move."""
    at.start()
    at.until_asked("Mount the ball on the flange")
    at.click("question_done")
    at.until_asked("The robot wants to move")


def place(at: AtTheWindow) -> np.ndarray:
    """Where the flange was reported last."""
    return np.asarray(at.of(CellMoved)[-1].base_from_flange)


def moving(at: AtTheWindow) -> bool:
    cell = at.window.known.cell
    return cell is not None and cell.moving


def until_it_stands(at: AtTheWindow) -> np.ndarray:
    at.wait("the robot stands", lambda: not moving(at))
    return place(at)


def end_of(at: AtTheWindow, ended: int) -> JobEnded:
    at.wait("the work is over", lambda: len(at.of(JobEnded)) > ended and not at.busy())
    return at.of(JobEnded)[-1]


def test_the_robot_moves_only_while_the_button_is_held(opened: Opened) -> None:
    at = opened(SLOW)
    until_the_robot_is_asked(at)
    first = at.of(Question)[-1]
    said = at.question()
    assert f"Path {first.length_mm:.0f} mm" in said and "at most 250 mm/s (limit 250 mm/s)" in said
    assert first.speed_mm_s <= 250.0 and first.path is not None and len(first.path) > 10
    hold = at.find(HoldButton, "question_hold")
    before = place(at)
    QTest.mousePress(hold, LEFT)
    at.wait("the robot moves", lambda: moving(at) and np.abs(place(at) - before)[:3, 3].max() > 5.0)
    assert "The robot moves while you hold" in at.question()
    QTest.mouseRelease(hold, LEFT)
    stood = until_it_stands(at)
    at.until_asked("to go on")
    again = at.of(Question)[-1]
    assert again.number != first.number and again.length_mm < first.length_mm
    np.testing.assert_allclose(place(at)[:3, 3], stood[:3, 3], atol=1e-6)
    np.testing.assert_allclose(again.path[0][:3, 3], stood[:3, 3], atol=0.5)
    QTest.keyPress(hold, Qt.Key.Key_Space)
    at.wait("the robot moves on", lambda: np.abs(place(at) - stood)[:3, 3].max() > 5.0)
    QTest.mouseMove(hold, QPoint(5, 5))
    QTest.keyRelease(hold, Qt.Key.Key_Space)
    until_it_stands(at)


def test_stop_ends_the_work_at_once_and_nothing_moves_until_asked_again(opened: Opened) -> None:
    at = opened(SLOW)
    until_the_robot_is_asked(at)
    target = at.of(Question)[-1].path[-1]
    ended = len(at.of(JobEnded))
    at.click("question_move")
    at.wait("the robot moves", lambda: moving(at))
    QTest.mousePress(at.find(type(at.window.top_bar.stop_button), "stop_button"), LEFT)
    assert end_of(at, ended).how == "stopped"
    QTest.mouseRelease(at.window.top_bar.stop_button, LEFT)
    assert "Stopped. What was taken is kept" in at.message()
    stood = until_it_stands(at)
    assert np.linalg.norm(stood[:3, 3] - target[:3, 3]) > 1.0, "it was stopped on its way"
    assert not at.asked() and at.usable("primary_button")
    at.start()
    at.until_asked("The robot wants to move")  # the ball is mounted still
    np.testing.assert_allclose(place(at)[:3, 3], stood[:3, 3], atol=1e-6)


@pytest.mark.parametrize("key", [Qt.Key.Key_Escape, Qt.Key.Key_F12])
def test_keys_stop_too(opened: Opened, key: Qt.Key) -> None:
    at = opened(SLOW)
    until_the_robot_is_asked(at)
    ended = len(at.of(JobEnded))
    at.click("question_move")
    at.wait("the robot moves", lambda: moving(at))
    at.key(key)
    assert end_of(at, ended).how == "stopped"
    until_it_stands(at)


def test_a_device_lost_while_the_robot_moves_stops_it_and_is_named(opened: Opened) -> None:
    at = opened(SLOW)
    until_the_robot_is_asked(at)
    target = at.of(Question)[-1].path[-1]
    ended = len(at.of(JobEnded))
    at.click("question_move")
    at.wait("the robot moves", lambda: moving(at))
    at.menu("fault_scanner lost")
    end = end_of(at, ended)
    assert end.how == "refused"
    assert "scanner: the connection is gone. Check its cable and power" in at.message()
    assert "The motion was stopped." in at.message()
    at.wait("the strip says it", lambda: "Scanner: fault" in at.window.device_strip.text())
    assert np.linalg.norm(until_it_stands(at)[:3, 3] - target[:3, 3]) > 1.0
    at.menu("fault_restore all")
    at.wait("the strip says it", lambda: "Scanner: simulated" in at.window.device_strip.text())
    at.start()
    at.until_asked("The robot wants to move")


def test_closing_the_window_while_the_robot_moves_stops_it_first(opened: Opened) -> None:
    at = opened(SLOW)
    until_the_robot_is_asked(at)
    at.click("question_move")
    at.wait("the robot moves", lambda: moving(at))
    at.window.close()
    assert at.window.isVisible() and "Stopping, then closing" in at.message()
    at.wait("it is closed", lambda: not at.window.isVisible())
    assert at.of(JobEnded)[-1].how == "stopped"
    folder = Path(at.window.known.session.folder)
    at.close()
    with Session.open(folder) as session:
        assert session.samples("ball") == []


def test_a_declined_mount_and_a_declined_motion_are_told_and_can_be_begun_again(opened: Opened) -> None:
    at = opened(0.0)
    ended = len(at.of(JobEnded))
    at.start()
    at.until_asked("Mount the ball")
    at.click("question_not_now")
    assert end_of(at, ended).how == "refused"
    assert "it was declined: Mount the ball on the flange" in at.message() and "Begin again" in at.message()
    assert at.rail("ball").startswith("1  Ball ○  not started")
    until_the_robot_is_asked(at)
    before = place(at)
    ended = len(at.of(JobEnded))
    at.click("question_not_now")
    assert end_of(at, ended).how == "refused"
    assert "the motion was not wanted" in at.message() and "Nothing has moved" in at.message()
    np.testing.assert_array_equal(place(at), before)
    at.start()
    at.until_asked("The robot wants to move")  # the ball is mounted


def test_a_step_that_stands_on_others_says_so(opened: Opened) -> None:
    at = opened(0.0)
    at.look_at("fine")
    assert at.banner().startswith("Cannot begin yet")
    for need in ("Ball", "Base", "Rough workpiece"):
        assert f"Fine workpiece needs {need}, which is not accepted yet." in at.banner()
    assert not at.usable("primary_button")
