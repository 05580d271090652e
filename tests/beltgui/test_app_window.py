"""The window with an engine that does nothing: what it shows for each thing said, what it sends for each thing done."""

import re
import threading
from collections.abc import Iterator
from pathlib import Path

import pytest
from PySide6.QtCore import QEvent, QObject, QPoint, QSettings, Qt, QTimer
from PySide6.QtGui import QKeySequence
from PySide6.QtWidgets import QApplication, QDialog, QFileDialog, QLabel, QLineEdit, QPushButton, QTableWidget
from pytestqt.qtbot import QtBot

from beltgui.app import language, settings
from beltgui.app.dialogs import ExportDialog
from beltgui.app.help_texts import help_of
from beltgui.app.menus import faults
from beltgui.app.palette import PALETTES
from beltgui.app.theme import theme
from beltgui.app.window import MainWindow
from beltgui.engine.faults import FAULTS
from beltgui.engine.messages import (
    Acquire,
    Cancel,
    Compare,
    Compared,
    ComparedRow,
    Crashed,
    DevicesChanged,
    DeviceState,
    Export,
    Exported,
    Hold,
    JobEnded,
    JobProgress,
    NewSession,
    OpenSession,
    Question,
    QuestionGone,
    Refused,
    SimulateFault,
    StepChanged,
    Stop,
)
from beltgui.steps.state import STEPS, TITLES, StepState
from tests.beltgui.fake_engine import JOB, READY, FakeEngine, all_views, moved, opened, view
from tests.beltgui.fake_page import FakePage

DEVICES = ("scanner", "stage", "robot", "grinder rough", "grinder fine")


class Screen:
    """A window with its engine; `say` waits until everything said has been shown."""

    def __init__(self, qtbot: QtBot) -> None:
        self.qtbot = qtbot
        self.engine = FakeEngine()
        self.window = MainWindow(self.engine.client, make_page=FakePage, person="Ada")
        self.window.closed.connect(self.engine.client.close)
        self.window.show()
        qtbot.waitExposed(self.window)
        self.window.add_page()

    def end(self) -> None:
        self.engine.client.close()
        self.window.close()
        self.window.deleteLater()
        QApplication.sendPostedEvents(None, QEvent.Type.DeferredDelete)

    @property
    def page(self) -> FakePage:
        assert isinstance(self.window.page, FakePage)
        return self.window.page

    def say(self, *events: object) -> None:
        last = [events[-1]]
        with self.qtbot.waitSignal(self.engine.client.event, check_params_cb=lambda event: event is last[0]):
            self.engine.say(*events)

    def open(self, *, read_only: bool = False, **states: StepState) -> None:
        self.say(READY, opened(read_only=read_only), *all_views(**states))

    def press(self, key: Qt.Key, modifiers: Qt.KeyboardModifier = Qt.KeyboardModifier.NoModifier) -> None:
        self.qtbot.keyClick(self.window, key, modifiers)

    def button(self, name: str) -> QPushButton:
        found = self.window.findChild(QPushButton, name)
        assert found is not None, name
        return found

    def label(self, name: str) -> str:
        found = self.window.findChild(QLabel, name)
        assert found is not None, name
        return found.text()

    def rail(self, step: str) -> str:
        return self.window.rail.entries[step].text_shown()


@pytest.fixture
def screen(qtbot: QtBot, tmp_path: Path) -> Iterator[Screen]:
    QSettings.setPath(QSettings.Format.IniFormat, QSettings.Scope.UserScope, str(tmp_path / "settings"))
    settings.keep("tour_seen", "yes")
    theme().choose("light")
    shown = Screen(qtbot)
    yield shown
    shown.end()
    language.install(language.ENGLISH)


# ---- the start


def test_a_newcomer_begins_with_one_button(screen: Screen, tmp_path: Path) -> None:
    start = screen.window.start_page
    assert screen.window.stack.currentWidget() is start
    assert start.begin_button.isEnabled() and start.begin_button.text() == "&Begin on the simulated cell"
    assert start.serial.text() == "DR95-0001"
    start.folder.setText(str(tmp_path / "new"))
    screen.qtbot.mouseClick(start.begin_button, Qt.MouseButton.LeftButton)
    (command,) = screen.engine.now.told(NewSession)
    assert command == NewSession(str(tmp_path / "new"), "Ada", "dr95", "DR95-0001", None, speed=20.0)
    assert not start.begin_button.isEnabled() and screen.label("missing") == "Opening…"
    screen.open()
    assert screen.window.stack.currentWidget() is not start
    assert screen.label("session_blade") == "DR95  ·  DR95-0007  ·  Ada"
    assert settings.recent_sessions() == ["/data/s1"] and settings.text("person") == "Ada"


@pytest.mark.parametrize(
    ("field", "text", "says"),
    [
        ("person", " ", "Enter your name"),
        ("serial", "DR96-0001", "expected for instance DR95-0001"),
        ("folder", "", "Choose a folder"),
    ],
)
def test_what_is_missing_is_said_and_begin_waits_for_it(screen: Screen, field: str, text: str, says: str) -> None:
    edit = screen.window.findChild(QLineEdit, field)
    edit.setText(text)
    assert says in screen.label("missing") and not screen.window.start_page.begin_button.isEnabled()
    screen.qtbot.keyClick(edit, Qt.Key.Key_Return)
    assert screen.engine.now.commands == []


def test_another_blade_type_brings_its_own_serial_and_folder(screen: Screen) -> None:
    start = screen.window.start_page
    screen.window.findChild(QObject, "blade_dr96").click()
    assert start.serial.text() == "DR96-0001" and start.folder.text().endswith("_DR96-0001")
    assert "span 216 mm" in screen.label("blade_description")
    start.serial.setFocus()
    start.serial.clear()
    screen.qtbot.keyClicks(start.serial, "DR96-0042")
    assert start.folder.text().endswith("_DR96-0042") and start.begin_button.isEnabled()


def test_a_refused_session_says_why_and_can_be_tried_again(screen: Screen) -> None:
    start = screen.window.start_page
    start.begin_button.click()
    screen.say(Refused("/data: there is a session already."))
    assert "there is a session already" in start.notice.text() and start.begin_button.isEnabled()


def test_recent_sessions_are_offered_while_they_exist(screen: Screen, tmp_path: Path) -> None:
    kept = tmp_path / "kept"
    kept.mkdir()
    (kept / "session.db").touch()
    settings.add_recent("/gone")
    settings.add_recent(str(kept))
    screen.window.new_session()
    assert screen.button("recent_0").text() == "kept"
    assert screen.window.start_page.findChild(QPushButton, "recent_1") is None
    screen.button("recent_0").click()
    assert screen.engine.now.told(OpenSession) == [OpenSession(str(kept), "Ada", False)]


# ---- the rail


def test_each_state_is_a_shape_and_a_word(screen: Screen) -> None:
    shapes = dict(zip(StepState, "○▶✔◆✖", strict=True))
    screen.open()
    for step, state in zip(STEPS, [*StepState, StepState.STALE], strict=True):
        screen.say(StepChanged(view(step, state, "RMS 18 µm", generation=2, why=("Base moved by 0.14 mm.",))))
        assert screen.rail(step) == f"{STEPS.index(step) + 1}  {TITLES[step]} {shapes[state]}  {state} RMS 18 µm"
        entry = screen.window.rail.entries[step]
        assert "Base moved by 0.14 mm." in entry.toolTip() and entry.accessibleName() == screen.rail(step)


def test_steps_are_looked_at_by_key_click_and_menu(screen: Screen) -> None:
    screen.open()
    for number, step in enumerate(STEPS):
        screen.press(Qt.Key(Qt.Key.Key_1 + number), Qt.KeyboardModifier.ControlModifier)
        assert screen.page.step == step and screen.window.rail.entries[step].isChecked()
        assert [entry.isChecked() for entry in screen.window.rail.entries.values()].count(True) == 1
    screen.window.rail.entries["base"].click()
    assert screen.page.step == "base"
    screen.press(Qt.Key.Key_PageDown, Qt.KeyboardModifier.ControlModifier)
    assert screen.page.step == "rough"
    screen.page.step_wanted.emit("tool")
    assert screen.page.step == "tool" and screen.window.menus.actions["step_tool"].isChecked()
    assert screen.engine.now.commands == []  # looking changes nothing


def test_a_session_opens_at_the_first_step_that_is_not_accepted(screen: Screen) -> None:
    screen.open(ball=StepState.ACCEPTED, base=StepState.ACCEPTED)
    assert screen.page.step == "rough"
    screen.say(StepChanged(view("rough", StepState.ACCEPTED, generation=2)))
    assert screen.page.step == "rough"  # nobody is moved on by himself


def test_a_view_that_is_out_of_date_is_dropped(screen: Screen) -> None:
    screen.open()
    screen.say(StepChanged(view("ball", StepState.ACCEPTED, generation=7)))
    screen.say(StepChanged(view("ball", StepState.RUNNING, generation=6)))
    assert "accepted" in screen.rail("ball")


def test_a_stale_step_locks_the_export_and_says_why(screen: Screen) -> None:
    screen.open(**dict.fromkeys(STEPS, StepState.ACCEPTED))
    assert screen.page.lock == ()
    screen.say(StepChanged(view("fine", StepState.STALE, generation=2, why=("Base has moved by 0.14 mm.",))))
    assert screen.page.lock == ("Fine workpiece: stale. Base has moved by 0.14 mm.",)
    screen.page.export_wanted.emit()
    assert "Export is locked:" in screen.window.message.text()
    assert "Base has moved by 0.14 mm." in screen.window.message.text()
    assert screen.window.findChild(QFileDialog) is None


# ---- work


def test_work_shows_its_progress_and_can_be_cancelled(screen: Screen) -> None:
    screen.open()
    screen.page.command.emit(Acquire("ball"))
    assert screen.engine.now.told(Acquire) == [Acquire("ball")]
    screen.say(JOB, JobProgress(1, 0.4, "scan 9 of 20"))
    bar = screen.window.top_bar
    assert bar.job_title.text() == "Ball: take the samples – scan 9 of 20" and bar.job_bar.value() == 400
    assert not screen.window.menus.actions["new"].isEnabled()
    screen.button("job_cancel").click()
    assert screen.engine.now.told(Cancel) == [Cancel()]
    screen.say(JobEnded(1, "cancelled"))
    assert "What was taken is kept" in screen.window.message.text()
    assert not bar.job_bar.isVisible() and screen.page.job == (None, None)


def test_a_question_turns_to_its_step_and_goes_when_answered(screen: Screen) -> None:
    screen.open()
    screen.window.look_at("tool")
    question = Question(3, "mount", "mount ball", "Mount the ball.")
    screen.say(JOB, question)
    assert screen.page.question is question and screen.page.step == "ball"
    screen.say(QuestionGone(2))
    assert screen.page.question is question
    screen.say(QuestionGone(3))
    assert screen.page.question is None


@pytest.mark.parametrize("situation", ["start", "open", "read only", "working", "asked", "fault", "engine gone"])
def test_stop_is_enabled_whatever_happens(screen: Screen, situation: str) -> None:
    if situation != "start":
        screen.open(read_only=situation == "read only")
    if situation in ("working", "asked"):
        screen.say(JOB)
    if situation == "asked":
        screen.say(Question(3, "motion", "motion", "May the robot move?"))
    if situation == "fault":
        screen.say(Crashed("Traceback"))
    if situation == "engine gone":
        screen.engine.now.die("exit code 9")
        screen.qtbot.waitUntil(lambda: not screen.engine.client.running)
    stop = screen.button("stop_button")
    assert stop.isEnabled() and stop.isVisible() and stop.property("stop")
    screen.qtbot.mousePress(stop, Qt.MouseButton.LeftButton)  # pressed is enough
    screen.press(Qt.Key.Key_F12)
    screen.press(Qt.Key.Key_Escape)
    expected = [] if situation == "engine gone" else [Stop()] * 3
    assert screen.engine.now.told(Stop) == expected and screen.page.calls.count("stop") == 3
    assert "top" in screen.window.message.text() or "no motion is asked for" in screen.window.message.text()
    screen.qtbot.mouseRelease(stop, Qt.MouseButton.LeftButton)


def test_stop_works_from_a_window_beside_and_esc_closes_that_one(screen: Screen) -> None:
    screen.open()
    screen.window.show_keyboard()
    dialog = screen.window.findChild(QDialog, "keyboard_dialog")
    screen.qtbot.waitExposed(dialog)
    dialog.activateWindow()
    screen.qtbot.waitUntil(lambda: QApplication.activeWindow() is dialog)
    screen.qtbot.keyClick(dialog, Qt.Key.Key_F12)
    assert screen.engine.now.told(Stop) == [Stop()]
    screen.qtbot.keyClick(dialog, Qt.Key.Key_Escape)
    assert screen.engine.now.told(Stop) == [Stop()] and not dialog.isVisible()


def test_leaving_the_window_lets_a_held_motion_go(screen: Screen) -> None:
    screen.open()
    screen.say(JOB)
    screen.window.isActiveWindow = lambda: False  # type: ignore[method-assign]
    QApplication.sendEvent(screen.window, QEvent(QEvent.Type.ActivationChange))
    assert screen.engine.now.told(Hold) == [Hold(False)]


def test_devices_say_state_and_since_when(screen: Screen) -> None:
    screen.say(DevicesChanged(tuple(DeviceState(name, "simulated") for name in DEVICES)))
    screen.window.device_strip.resize(2000, 30)
    assert re.search(r"■ Grinder fine: simulated \d\d:\d\d", screen.window.device_strip.text())
    screen.window.device_strip.resize(500, 30)  # no room for the times
    assert re.search(r"■ Grinder fine: simulated(?! \d)", screen.window.device_strip.text())
    screen.window.device_strip.resize(2000, 30)
    screen.say(DevicesChanged((DeviceState("robot", "fault", "The robot does not answer."),)))
    label = screen.window.findChild(QLabel, "device_robot")
    assert label.text().startswith("✖ Robot: fault ") and "fault since " in label.toolTip()
    assert "The robot does not answer." in label.toolTip()
    screen.open()
    assert "Ada works on blade type DR95, serial DR95-0007" in screen.window.device_strip.text()


def test_only_the_last_of_many_positions_is_shown(screen: Screen) -> None:
    screen.open()
    screen.say(*(moved(float(x)) for x in range(500)))
    assert len(screen.page.cells) < 20 and screen.page.cells[-1].stage[0] == 499.0


# ---- ends and faults


def test_an_engine_that_has_ended_is_started_again_with_its_session(screen: Screen) -> None:
    screen.open()
    screen.say(DevicesChanged((DeviceState("robot", "simulated"),)), JOB)
    screen.engine.now.die("The engine has ended by itself (exit code -9).")
    screen.qtbot.waitUntil(lambda: "The engine has ended" in screen.window.engine_notice.text())
    assert screen.page.job == (None, None) and screen.page.read_only
    assert "◆ Robot: no news" in screen.window.device_strip.text()
    screen.button("engine_notice_details").click()
    assert "exit code -9" in screen.window.findChild(QObject, "fault_text").toPlainText()
    screen.button("engine_notice_button").click()
    assert len(screen.engine.backends) == 2 and screen.engine.backends[0].closed
    screen.say(READY)
    assert screen.window.engine_notice.text() == ""
    assert screen.engine.now.commands == [OpenSession("/data/s1", "Ada", False)]
    screen.say(opened(), *all_views())
    assert not screen.page.read_only


def test_a_fault_of_the_program_can_be_copied(screen: Screen) -> None:
    screen.open()
    screen.say(JOB, JobEnded(1, "crashed", "Traceback: all of it"))
    assert "What was taken is kept" in screen.window.message.text()
    screen.button("message_details").click()
    screen.button("fault_dialog_copy").click()
    assert QApplication.clipboard().text() == "Traceback: all of it"


def test_a_refusal_is_shown_where_the_person_works(screen: Screen) -> None:
    screen.open()
    screen.say(Refused("The ball step has no result yet."))
    assert screen.window.message.text() == "◆  The ball step has no result yet."


def test_closing_waits_until_all_has_stopped(screen: Screen) -> None:
    screen.open()
    screen.say(JOB, moved())
    assert not screen.window.close() and screen.window.isVisible()
    assert screen.engine.now.told(Stop) == [Stop()]
    assert "nothing needs saving" in screen.window.message.text()
    assert screen.button("stop_button").isEnabled()
    assert not screen.window.close()  # asking twice does not hurry it
    screen.engine.say(JobEnded(1, "stopped"))
    screen.qtbot.waitUntil(lambda: not screen.window.isVisible())
    assert screen.engine.now.closed and screen.page.calls == ["focus", "shut down"]


def test_closing_does_not_wait_for_an_engine_that_is_silent_or_gone(screen: Screen) -> None:
    screen.open()
    screen.say(JOB)
    assert not screen.window.close()
    screen.engine.now.die("killed")
    screen.qtbot.waitUntil(lambda: not screen.window.isVisible())


def test_closing_leaves_nothing_behind(screen: Screen, qapp: QApplication) -> None:
    screen.open()
    screen.window.begin_tour()
    screen.window.show_keyboard()
    threads = threading.active_count()
    assert screen.window.close()
    assert screen.engine.now.closed and threading.active_count() == threads
    assert all(not timer.isActive() for timer in screen.window.findChildren(QTimer))
    qapp.sendPostedEvents(None, QEvent.Type.DeferredDelete)
    assert [widget.objectName() for widget in qapp.topLevelWidgets() if widget.isVisible()] == []


# ---- sessions


def test_a_read_only_session_says_so_and_offers_no_change(screen: Screen) -> None:
    screen.open(read_only=True)
    assert screen.window.read_only_notice.text().startswith("●  Read-only") and screen.page.read_only
    for name in ("export", "fault_ball moved"):
        assert not screen.window.menus.actions[name].isEnabled()
    assert screen.window.menus.actions["compare"].isEnabled()
    screen.open()
    assert screen.window.read_only_notice.text() == "" and not screen.page.read_only


def test_a_window_for_the_picture_says_why_it_cannot_be_had_on_this_screen(screen: Screen) -> None:
    screen.open()
    action = screen.window.menus.actions["scene_window"]
    assert action.shortcut() == QKeySequence("F11") and not action.isEnabled()
    assert "OpenGL" in action.toolTip() and "offscreen" in action.toolTip()


@pytest.mark.parametrize(
    ("action", "command"),
    [
        ("open", OpenSession("FOLDER", "Ada", False)),
        ("open_read_only", OpenSession("FOLDER", "Ada", True)),
        ("compare", Compare("FOLDER")),
    ],
)
def test_folders_are_asked_for_without_blocking(
    screen: Screen, action: str, command: object, tmp_path: Path
) -> None:
    screen.open(**dict.fromkeys(STEPS, StepState.ACCEPTED))
    screen.window.menus.actions[action].trigger()
    dialog = screen.window.findChild(QFileDialog, "folder_dialog")
    assert dialog.isVisible() and not dialog.isModal() and screen.button("stop_button").isEnabled()
    dialog.fileSelected.emit("FOLDER")
    assert screen.engine.now.commands == [command]
    dialog.close()


def test_a_folder_for_the_programs_is_proposed_and_enter_takes_it(screen: Screen) -> None:
    screen.open(**dict.fromkeys(STEPS, StepState.ACCEPTED))
    screen.window.menus.actions["export"].trigger()
    dialog = screen.window.findChild(ExportDialog)
    assert dialog.isVisible() and not dialog.isModal()
    assert Path(dialog.folder.text()) == Path(str(opened().folder)) / "programs"
    screen.qtbot.keyClick(dialog.folder, Qt.Key.Key_Return)
    assert screen.engine.now.commands == [Export(str(Path(opened().folder) / "programs"))]
    assert not dialog.isVisible()


def test_another_folder_for_the_programs_can_be_chosen(screen: Screen) -> None:
    screen.open(**dict.fromkeys(STEPS, StepState.ACCEPTED))
    screen.window.menus.actions["export"].trigger()
    dialog = screen.window.findChild(ExportDialog)
    dialog.folder.setText("  ")
    assert not dialog.write_button.isEnabled()
    dialog.findChild(QPushButton, "export_choose").click()
    dialog.findChild(QFileDialog, "folder_dialog").fileSelected.emit("FOLDER")
    dialog.write_button.click()
    assert screen.engine.now.commands == [Export("FOLDER")]


def test_a_comparison_tells_changed_from_the_same(screen: Screen) -> None:
    screen.open()
    rows = (
        ComparedRow("ball", "x", 1.0, 1.2, -0.2, "mm", 0.1),
        ComparedRow("base", "rx", 1.0, 1.01, -0.01, "deg", 0.1),
        ComparedRow("tool", "z", 1.0, None, None, "mm"),
    )
    screen.say(Compared("/data/s0", rows))
    table = screen.window.findChild(QTableWidget, "compare_table")
    assert [table.item(row, 6).text() for row in range(3)] == ["◆ changed", "✔ the same", ""]
    assert [table.item(0, column).text() for column in range(6)] == ["Ball", "x", "1 mm", "1.2 mm", "-0.2 mm", "0.1 mm"]
    table.window().close()


def test_what_was_exported_is_listed(screen: Screen) -> None:
    screen.open()
    screen.say(Exported(("/data/out/rough.script", "/data/out/report.html")))
    files = screen.window.findChild(QObject, "exported_files")
    assert [files.item(row).text() for row in range(files.count())] == ["rough.script", "report.html"]
    files.window().close()


def test_faults_for_training_are_those_that_the_engine_knows(screen: Screen) -> None:
    assert faults().keys() == FAULTS.keys()
    screen.open()
    screen.window.menus.actions["fault_ball moved"].trigger()
    assert screen.engine.now.told(SimulateFault) == [SimulateFault("ball moved")]


def test_the_chosen_speed_is_that_of_the_next_session(screen: Screen) -> None:
    screen.window.menus.actions["speed_100"].trigger()
    screen.window.start_page.begin_button.click()
    assert screen.engine.now.told(NewSession)[0].speed == 100.0


# ---- looks


def test_the_theme_changes_everything_at_once(screen: Screen) -> None:
    screen.open(ball=StepState.ACCEPTED)
    screen.window.menus.actions["theme_dark"].trigger()
    dark = PALETTES["dark"]
    assert screen.window.grab().toImage().pixelColor(2, screen.window.height() // 2).name() != "#eceef0"
    assert dark[StepState.ACCEPTED] in screen.window.rail.entries["ball"]._state.styleSheet()
    assert settings.text("theme") == "dark"
    screen.window.menus.actions["theme_light"].trigger()
    assert PALETTES["light"][StepState.ACCEPTED] in screen.window.rail.entries["ball"]._state.styleSheet()


@pytest.mark.parametrize("step", STEPS)
def test_every_step_has_its_help(screen: Screen, step: str) -> None:
    screen.open()
    screen.press(Qt.Key.Key_F1)
    assert screen.window.help_panel.isVisible()
    screen.window.look_at(step)
    shown = screen.window.help_panel.browser.toPlainText()
    words = help_of(step)
    remedies = [part for pair in words.remedies for part in pair]
    for text in (TITLES[step], words.purpose, words.mount, words.watch, *remedies):
        assert text in shown
    assert len(words.remedies) >= 3 and "What the reasons mean" in shown
    screen.press(Qt.Key.Key_F1)
    assert not screen.window.help_panel.isVisible()


def test_the_window_is_small_enough_for_the_smallest_screen(screen: Screen) -> None:
    screen.open()
    screen.window.resize(1280, 800)
    least = screen.window.minimumSizeHint()
    assert least.width() <= 1280 and least.height() <= 800
    assert screen.window.rail.width() <= 190
    stop = screen.button("stop_button")
    corner = stop.mapTo(screen.window, QPoint(stop.width(), 0))
    assert 1280 - corner.x() <= 12 and corner.y() < 60 and stop.height() >= 44


# ---- the tour


def test_the_tour_goes_on_and_back_by_key_and_is_remembered(screen: Screen) -> None:
    settings.keep("tour_seen", "")
    screen.open()
    assert screen.window.tour is None  # offered, and never in the way by itself
    screen.button("message_button").click()
    assert screen.window.message.text() == ""
    tour = screen.window.tour
    assert tour is not None and 8 <= len(tour.stops) <= 10
    shown = []
    for number in range(len(tour.stops)):
        assert tour.place == number and tour.card.isVisible()
        shown.append(screen.label("tour_text"))
        screen.qtbot.keyClick(tour.card.next_button, Qt.Key.Key_Right)
    assert screen.window.tour is None and len(set(shown)) == len(shown)
    assert settings.text("tour_seen") == "yes"
    screen.open()
    assert screen.window.tour is None and screen.window.message.text() == ""  # offered once
    screen.window.menus.actions["tour"].trigger()
    assert screen.window.tour is not None
    screen.qtbot.keyClick(screen.window.tour.card.next_button, Qt.Key.Key_Right)
    screen.qtbot.keyClick(screen.window.tour.card.next_button, Qt.Key.Key_Left)
    assert screen.window.tour.place == 0
    screen.button("tour_skip").click()
    assert screen.window.tour is None


def test_the_tour_blocks_nothing_and_frames_what_it_speaks_of(screen: Screen) -> None:
    screen.open()
    screen.window.begin_tour()
    tour = screen.window.tour
    names = [stop.widget for stop in tour.stops]
    tour.go(names.index("stop_button"))
    stop = screen.button("stop_button")
    inside = stop.mapTo(screen.window, stop.rect().center())
    left, right = (bar.geometry() for bar in tour._bars[2:])
    assert left.left() < inside.x() < right.right() and left.top() < inside.y() < left.bottom()
    assert not tour.card.geometry().contains(inside)
    screen.qtbot.mouseClick(stop, Qt.MouseButton.LeftButton)
    assert screen.engine.now.told(Stop) == [Stop()]


