"""Start of the application: the engine's process first, then the window, then the picture."""

from __future__ import annotations

import importlib
import os
import sys
import threading
from pathlib import Path
from typing import TYPE_CHECKING

from core.errors import InputError

if TYPE_CHECKING:
    from PySide6.QtWidgets import QWidget

    from beltgui.wizard.page import StepPage


def run(
    *,
    sim: bool,
    config: Path | None = None,
    session: Path | None = None,
    person: str = "",
    theme: str = "",
    language: str = "",
) -> int:
    """Open the main window and stay until it is closed.

    Args:
        sim: Work on the simulated cell. The only cell there is so far.
        config: Cell file (TOML) for new sessions; None takes the simulated cell's own.
        session: Open this session at once.
        person: Who works; empty takes the one who worked last.
        theme: `system`, `light` or `dark`; empty takes what was chosen last.
        language: `en` or `zh_CN`; empty takes what was chosen last, or the computer's.

    Returns:
        The exit code of the application.

    Raises:
        InputError: real devices were asked for, or there is no screen.
    """
    if not sim:
        raise InputError("gui: there are no drivers for real devices yet. Start it with --sim.")
    _check_screen()
    from beltgui.app.backends import ProcessBackend

    first = [ProcessBackend()]  # imports its heavy packages while Qt is imported here
    from PySide6.QtCore import QObject, Qt, QTimer, Signal
    from PySide6.QtWidgets import QApplication

    application = QApplication.instance() or QApplication(sys.argv[:1])
    _dress(application, theme, language)
    from beltgui.app.client import EngineClient
    from beltgui.app.window import MainWindow

    class Loader(QObject):
        """Imports what the page of the steps needs, while the window is already there."""

        loaded = Signal()

    client = EngineClient(lambda: first.pop() if first else ProcessBackend())
    window = MainWindow(client, make_page=_make_page, config=config, person=person)
    window.closed.connect(client.close)
    window.show()
    window.activateWindow()  # the keyboard works at once, also where no window manager gives it to the window
    client.start()
    if session is not None:
        window.doors.open(str(session))
    loader = Loader()
    loader.loaded.connect(window.add_page, Qt.ConnectionType.QueuedConnection)

    def load() -> None:
        for name in ("beltgui.wizard.page", "beltgui.widgets.scene_view", "numpy.ma"):  # the last one: np.unique
            importlib.import_module(name)
        loader.loaded.emit()

    reader = threading.Thread(target=load, name="imports")
    QTimer.singleShot(0, reader.start)
    code = int(application.exec())
    client.close()
    reader.join()
    return code


def _dress(application: object, theme_name: str, language_name: str) -> None:
    """Theme, size and language before anything is shown."""
    from PySide6.QtWidgets import QApplication

    from beltgui.app import language, settings
    from beltgui.app.theme import theme

    assert isinstance(application, QApplication)
    application.setApplicationName("beltcal")
    application.setStyle("Fusion")  # looks the same everywhere, and can be dark
    if theme_name:
        theme().choose(theme_name)
    else:
        theme().apply()
    if language_name:
        settings.keep("language", language_name)
    wanted = settings.text("language") or language.suggested()
    language.install(wanted if wanted in language.LANGUAGES else language.ENGLISH)


def _make_page(parent: QWidget) -> StepPage:
    from beltgui.wizard.page import StepPage

    page = StepPage(None, parent)
    page.scene.prepare()  # what draws the picture starts while the person still reads the start page
    return page


def _check_screen() -> None:
    """Without a screen Qt would end the process with a core dump."""
    wanted = ("DISPLAY", "WAYLAND_DISPLAY", "QT_QPA_PLATFORM")
    if sys.platform.startswith("linux") and not any(os.environ.get(name) for name in wanted):
        raise InputError(
            "gui: there is no screen (neither DISPLAY nor WAYLAND_DISPLAY is set). Start it in a desktop "
            "session, or for a try without one: xvfb-run -a beltcal gui --sim."
        )
