"""Start of the application."""

from __future__ import annotations

import os
import sys
from pathlib import Path

from core.errors import InputError


def run(*, sim: bool, config: Path | None = None) -> int:
    """Open the main window and stay until it is closed.

    Args:
        sim: Work on the simulated cell. The only cell there is so far.
        config: Cell file (TOML); None takes the simulated cell's own.

    Returns:
        The exit code of the application.

    Raises:
        InputError: real devices were asked for, or there is no screen.
    """
    if not sim:
        raise InputError("gui: there are no drivers for real devices yet. Start it with --sim.")
    _check_screen()
    from PySide6.QtWidgets import QApplication

    from beltgui.app.window import MainWindow

    application = QApplication.instance() or QApplication(sys.argv[:1])
    window = MainWindow(config=config)
    window.show()
    return int(application.exec())


def _check_screen() -> None:
    """Without a screen Qt would end the process with a core dump."""
    wanted = ("DISPLAY", "WAYLAND_DISPLAY", "QT_QPA_PLATFORM")
    if sys.platform.startswith("linux") and not any(os.environ.get(name) for name in wanted):
        raise InputError(
            "gui: there is no screen (neither DISPLAY nor WAYLAND_DISPLAY is set). Start it in a desktop "
            "session, or for a try without one: xvfb-run -a beltcal gui --sim."
        )
