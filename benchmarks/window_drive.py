"""Drives the real application in a benchmark: begins a session, says yes to every question, tells how far it is."""

from __future__ import annotations

import tempfile
from collections.abc import Callable
from pathlib import Path
from typing import Any

from beltgui.engine.messages import Answer, NewSession, Question

PERSON = "Ada Benchmark"


def with_own_settings(folder: Path) -> None:
    """Settings of a person who has seen the tour, so that nothing of this machine's is read or written."""
    from PySide6.QtCore import QSettings

    from beltgui.app import settings

    QSettings.setPath(QSettings.Format.IniFormat, QSettings.Scope.UserScope, str(folder))
    settings.keep("tour_seen", "yes")
    settings.keep("language", "en")


class Person:
    """Sits before the main window: begins a session and agrees to all it asks.

    Args:
        resolution: Of the simulated scanner.
        speed: Of the simulated cell; 0 is instantly.
        on_event: Told every event, after the window has shown it.
    """

    def __init__(self, folder: Path, *, resolution: str, speed: float, on_event: Callable[[Any], None]) -> None:
        self.window: Any = None
        self._folder, self._resolution, self._speed = folder, resolution, speed
        self._on_event = on_event

    def sit_down(self) -> bool:
        """Find the main window; False while there is none."""
        from PySide6.QtWidgets import QApplication

        from beltgui.app.window import MainWindow

        self.window = next((one for one in QApplication.topLevelWidgets() if isinstance(one, MainWindow)), None)
        if self.window is None:
            return False
        self.window.client.event.connect(self._hear)
        folder = str(self._folder / "session")
        self.send(NewSession(folder, PERSON, resolution=self._resolution, speed=self._speed))
        return True

    def send(self, command: Any) -> None:
        """A command for the engine, as the page sends it."""
        self.window.client.send(command)

    def _hear(self, event: Any) -> None:
        if isinstance(event, Question):
            self.send(Answer(event.number, yes=True, for_series=event.kind == "motion"))
        self._on_event(event)


def scratch() -> tempfile.TemporaryDirectory[str]:
    """For the session and the settings."""
    return tempfile.TemporaryDirectory(prefix="beltcal_benchmark_")
