"""Closing the window while something moves: stop first, then close, and never block."""

from __future__ import annotations

from collections.abc import Callable

from PySide6.QtCore import QObject, QTimer

from beltgui.app.client import EngineClient
from beltgui.engine.messages import Hold, Stop

# How long the engine may take to stop everything before the window closes without its word.
PATIENCE_MS = 3000


class Closing(QObject):
    """Decides whether the window may close now.

    Args:
        client: The engine.
        close: Closes the window.
        parent: Of the object.
    """

    def __init__(self, client: EngineClient, close: Callable[[], object], parent: QObject) -> None:
        super().__init__(parent)
        self._client, self._close = client, close
        self._asked = False
        self._timer = QTimer(self)
        self._timer.setSingleShot(True)
        self._timer.timeout.connect(self.all_stopped)

    def may_close(self, moving: bool) -> bool:
        """True if nothing moves or it has been waited for; otherwise everything is asked to stop."""
        if not moving or not self._client.running:
            return True
        if not self._asked:
            self._asked = True
            self._client.send(Hold(False))
            self._client.send(Stop())
            self._timer.start(PATIENCE_MS)
        return not self._timer.isActive()

    def all_stopped(self) -> None:
        """Nothing moves any more, or nobody says so: close if that is wanted."""
        if self._asked:
            self._timer.stop()
            self._close()
