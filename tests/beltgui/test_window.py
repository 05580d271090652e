"""The window with a simulated cell behind it: words, picture, run, cancel, refusal, and nothing left behind."""

import subprocess
import sys
from collections.abc import Callable, Iterator
from pathlib import Path
from shutil import which
from typing import Any

import numpy as np
import pytest
from PySide6.QtGui import QGuiApplication, QImage
from PySide6.QtWidgets import QLabel
from pytestqt.qtbot import QtBot

from beltgui.app import view3d
from beltgui.app.window import DEVICES, MainWindow
from beltgui.session import Session
from beltgui.steps.state import STEPS, TITLES

WAIT_MS = 120_000


@pytest.fixture
def window(qtbot: QtBot, tmp_path: Path) -> Iterator[Callable[..., MainWindow]]:
    """Opens windows on a coarse cell; in the end all are closed and none has left a thread."""
    opened: list[MainWindow] = []

    def open_one(**options: Any) -> MainWindow:
        window = MainWindow(out_dir=tmp_path, **{"resolution": "test", "grid": (25, 18), **options})
        opened.append(window)
        window.show()
        return window

    yield open_one
    for window in opened:
        window.close()
        assert all(worker.isFinished() for worker in window._workers)
    QGuiApplication.processEvents()


def idle(qtbot: QtBot, window: MainWindow) -> None:
    """Wait until every worker's last word has been shown."""
    qtbot.waitUntil(lambda: all(w.isFinished() for w in window._workers) and window.start_button.isEnabled(),
                    timeout=WAIT_MS)  # fmt: skip


def pixels(image: QImage) -> np.ndarray:
    image = image.convertToFormat(QImage.Format.Format_RGB888)
    rows = np.frombuffer(image.constBits(), np.uint8).reshape(image.height(), image.bytesPerLine())
    return rows[:, : 3 * image.width()].reshape(image.height(), image.width(), 3).astype(float)


def test_it_opens_with_six_steps_in_words_and_all_devices(qtbot: QtBot, window: Callable[..., MainWindow]) -> None:
    shown = window()
    assert [entry.text() for entry in shown.rail.entries.values()] == ["○  not started"] * 6
    titles = [label.text() for entry in shown.rail.entries.values() for label in entry.findChildren(QLabel)]
    for step in STEPS:
        assert any(TITLES[step] in text for text in titles)
    strip = shown.findChild(QLabel, "devices").text()
    assert all(f"{name}: simulated" in strip for name in DEVICES)
    assert shown.start_button.isEnabled() and not shown.cancel_button.isEnabled()
    assert not shown.report_button.isEnabled()
    assert "No real device moves" in shown.banner.text()


def test_the_blade_is_shown_without_opengl_too(
    qtbot: QtBot, window: Callable[..., MainWindow], monkeypatch: pytest.MonkeyPatch
) -> None:
    platforms = view3d.PLATFORMS_WITHOUT_GL | {QGuiApplication.platformName()}
    monkeypatch.setattr(view3d, "PLATFORMS_WITHOUT_GL", platforms)
    shown = window()
    assert isinstance(shown.view, view3d.PictureView)
    qtbot.waitUntil(lambda: not shown.view.pixmap().isNull(), timeout=WAIT_MS)
    picture = pixels(shown.view.pixmap().toImage())
    assert picture.std() > 5.0
    assert (np.abs(picture - picture[0, 0]).max(axis=2) > 20.0).mean() > 0.02  # the blade fills a part of the view
    shown.resize(900, 600)
    assert shown.view.pixmap().width() == shown.view.width()


def test_a_run_is_cancelled_and_begun_again_elsewhere(
    qtbot: QtBot, window: Callable[..., MainWindow], tmp_path: Path
) -> None:
    shown = window()
    shown.start_button.click()
    assert not shown.start_button.isEnabled() and shown.cancel_button.isEnabled()
    qtbot.waitUntil(lambda: shown.progress.value() > 10, timeout=WAIT_MS)
    assert "running" in shown.rail.entries["ball"].text()
    assert "Ball: scan" in shown.progress_text.text()
    shown.cancel_button.click()
    idle(qtbot, shown)
    assert "Cancelled. What was kept stays kept." in shown.banner.text()
    assert shown.rail.entries["ball"].text() == "○  not started cancelled"
    with Session.open(tmp_path / "session") as session:
        assert len(session.samples("ball", "scan")) >= 1
    shown.start_button.click()  # the folder holds a session now: refused, and the sentence is shown
    idle(qtbot, shown)
    assert "✖ Refused:" in shown.banner.text() and "there is a session already" in shown.banner.text()


def test_an_input_that_cannot_be_used_is_refused_in_the_banner(
    qtbot: QtBot, window: Callable[..., MainWindow], tmp_path: Path
) -> None:
    cell = tmp_path / "cell.toml"
    cell.write_text("name = 'half a cell'")
    shown = window(config=cell)
    shown.start_button.click()
    idle(qtbot, shown)
    assert "✖ Refused:" in shown.banner.text() and "cell.toml" in shown.banner.text()


def test_closing_while_running_ends_the_work(qtbot: QtBot, window: Callable[..., MainWindow], tmp_path: Path) -> None:
    shown = window()
    shown.start_button.click()
    qtbot.waitUntil(lambda: shown.progress.value() > 10, timeout=WAIT_MS)
    assert shown.close()
    assert all(worker.isFinished() for worker in shown._workers)
    with Session.open(tmp_path / "session") as session:
        assert session.samples("ball", "scan") and list(session.steps_with_results()) == []


def test_closing_before_the_blade_is_loaded_is_quiet(qtbot: QtBot, window: Callable[..., MainWindow]) -> None:
    shown = window()
    assert shown.close()
    qtbot.wait(1)  # what the worker sent last arrives now


ON_A_SCREEN = """
import sys
import numpy as np
from PySide6.QtGui import QGuiApplication
from PySide6.QtWidgets import QApplication
from beltgui.app.view3d import InteractorView
from beltgui.app.window import MainWindow

application = QApplication(sys.argv[:1])
assert QGuiApplication.platformName() == "xcb"
window = MainWindow()
assert isinstance(window.view, InteractorView)
window.show()
(worker,) = window._workers


def look(mesh):
    picture = np.asarray(window.view.plotter.screenshot(return_img=True), dtype=float)
    different = np.abs(picture - picture[0, 0]).max(axis=2) > 20.0
    print("shown", picture.shape[0] > 100, different.mean() > 0.02)
    window.close()
    application.quit()


worker.done.connect(look)  # after the window's own slot, which draws the blade
application.exec()
assert worker.isFinished()
print("closed")
"""


def test_on_a_screen_the_view_can_be_turned_and_shows_the_blade(tmp_path: Path) -> None:
    """In a process of its own, because a process has one Qt platform."""
    assert which("xvfb-run"), "xvfb-run is missing; `make setup` installs it"
    words = ["xvfb-run", "-a", "-s", "-screen 0 1280x1024x24", "env", "QT_QPA_PLATFORM=xcb", sys.executable, "-c"]
    run = subprocess.run([*words, ON_A_SCREEN], capture_output=True, text=True, timeout=120, check=False)
    assert run.returncode == 0, run.stderr
    assert run.stdout.split("\n")[:2] == ["shown True True", "closed"], run.stdout + run.stderr


def test_a_whole_run_ends_with_the_verdict_and_the_report(
    qtbot: QtBot, window: Callable[..., MainWindow], tmp_path: Path
) -> None:
    opened = window(grid=(33, 20))
    opened.start()
    qtbot.waitUntil(lambda: opened.start_button.isEnabled(), timeout=WAIT_MS)
    assert opened.banner.text().startswith("✔ Accepted. Normal error left on the airfoil")
    for step in STEPS:
        assert "accepted" in opened.rail.entries[step].text()
    assert opened.report_button.isEnabled() and not opened.cancel_button.isEnabled()
    assert (tmp_path / "report.html").stat().st_size > 500_000
    with Session.open(tmp_path / "session") as session:
        assert list(session.steps_with_results()) == list(STEPS)
