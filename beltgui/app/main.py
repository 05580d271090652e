"""Start of the application."""

from __future__ import annotations

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
        InputError: real devices were asked for, or the cell file cannot be used.
    """
    if not sim:
        raise InputError("beltcal gui: there are no drivers for real devices yet. Start it with --sim.")
    from PySide6.QtWidgets import QApplication

    from beltgui.app.window import MainWindow

    application = QApplication.instance() or QApplication(sys.argv[:1])
    window = MainWindow(config=config)
    window.show()
    return int(application.exec())
