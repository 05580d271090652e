"""At the window with the engine in a process of its own: killed and restarted, looked at, closed without a trace."""

import gc
import multiprocessing
import os
import signal
import threading
import weakref
from collections.abc import Callable
from pathlib import Path
from typing import Any

import pytest
import shiboken6
from PySide6.QtCore import QEvent, QTimer
from PySide6.QtWidgets import QApplication
from pytestqt.qtbot import QtBot

from beltgui.app.backends import LocalBackend, ProcessBackend
from beltgui.app.client import Backend
from beltgui.viewmodel.step import Action
from tests.beltgui.walk_person import AtTheWindow, forget_all

ENGINE = "beltcal engine"


def engines() -> list[Any]:
    return [child for child in multiprocessing.active_children() if child.name == ENGINE]


@pytest.fixture(autouse=True)
def home(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr("beltgui.widgets.question_panel.ARM_MS", 0)
    forget_all(tmp_path / "settings")


def test_an_engine_killed_in_the_middle_is_started_again_where_it_stood(qtbot: QtBot, tmp_path: Path) -> None:
    at = AtTheWindow(qtbot, backend=ProcessBackend, own_process=True)
    try:
        at.begin(tmp_path / "session")
        at.start()
        at.answer_all(lambda: at.rows() >= 4)
        (engine,) = engines()
        os.kill(engine.pid, signal.SIGKILL)
        at.wait("the notice", lambda: "The engine has ended" in at.window.engine_notice.text())
        assert "Everything that was taken is kept" in at.window.engine_notice.text()
        assert not at.busy() and not at.asked() and not at.usable("primary_button")
        assert "no news" in at.window.device_strip.text()
        there = at.rows()
        assert there >= 4
        at.during(lambda: at.click("engine_notice_button"))
        at.wait("the step is shown again", lambda: at.rows() >= there)
        assert not at.seen("engine_notice")
        kept = at.rows()
        assert at.words("primary_button") == f"Go on ({kept} of 20 scans)"
        assert at.take().how == "done"
        assert at.rows() == 20 and at.banner().startswith("Good — can be accepted")
        at.accept()
        read_only(at, tmp_path / "session")
    finally:
        at.close()
    assert multiprocessing.active_children() == []


def read_only(at: AtTheWindow, folder: Path) -> None:
    """The same session, only looked at: everything is there, nothing can be changed."""
    at.open(folder, "open_read_only")
    assert "Read-only" in at.window.read_only_notice.text()
    assert "nothing can be changed" in at.window.read_only_notice.text()
    at.look_at("ball")
    assert at.rows() == 20 and at.rail("ball").startswith("1  Ball ✔  accepted")
    assert at.view("ball").actions <= {Action.EXPORT}
    at.choose_row(3)
    for name in ("undo_button", "redo_button", "delete_button", "solve_button", "start_over_button"):
        assert not at.usable(name), name
    model = at.page.samples.model
    assert not model.editable
    assert at.words("primary_button").startswith("Next step")  # looking goes on
    at.click("primary_button")
    assert at.page.step == "base" and not at.usable("primary_button")
    for name, action in at.window.menus.actions.items():
        if name.startswith("fault_") or name == "export":
            assert not action.isEnabled(), name


def there() -> dict[str, set[int]]:
    """What could be left behind."""
    from vtkmodules.vtkRenderingCore import vtkRenderWindow

    QApplication.sendPostedEvents(None, QEvent.Type.DeferredDelete)
    gc.collect()
    things = gc.get_objects()
    return {
        "threads": {thread.ident or 0 for thread in threading.enumerate()},
        "top-level widgets": {id(widget) for widget in QApplication.topLevelWidgets()},
        "render windows": {id(thing) for thing in things if isinstance(thing, vtkRenderWindow)},
        "timers": {id(thing) for thing in things if isinstance(thing, QTimer) and shiboken6.isValid(thing)},
        "child processes": {child.pid or 0 for child in multiprocessing.active_children()},
    }


def test_nothing_is_left_when_the_window_is_closed_in_the_middle_of_the_work(qtbot: QtBot, tmp_path: Path) -> None:
    def round_(name: str, backend: Callable[[], Backend], own_process: bool) -> list[weakref.ref[Any]]:
        at = AtTheWindow(qtbot, backend=backend, own_process=own_process)
        at.begin(tmp_path / name)
        at.start()
        at.answer_all(lambda: at.rows() >= 2)
        at.wait("a picture", lambda: bool(at.page.scene.canvas.panes))
        gone = [weakref.ref(thing) for thing in (at.window, at.page, at.page.scene, at.page.plots)]
        at.close()
        assert not shiboken6.isValid(at.client)
        return gone

    round_("first", LocalBackend, False)  # what is made once for all stays
    before = there()
    gone = [*round_("second", LocalBackend, False), *round_("third", ProcessBackend, True)]
    after = there()
    assert {what: things - before[what] for what, things in after.items() if things - before[what]} == {}
    assert [ref for ref in gone if ref() is not None] == []
