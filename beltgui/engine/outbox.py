"""Events on their way to another process: whoever emits never waits for the reader."""

from __future__ import annotations

import threading
from collections.abc import Hashable
from multiprocessing.connection import Connection

from beltgui.engine.messages import Event, replaces


class Outbox:
    """Sends in a thread of its own; what a newer event replaces is not sent. Call `close` at the end."""

    def __init__(self, connection: Connection) -> None:
        self._connection = connection
        self._changed = threading.Condition()
        self._waiting: dict[Hashable, Event] = {}
        self._count = 0
        self._closed = False
        self._thread = threading.Thread(target=self._send, name="engine events", daemon=True)
        self._thread.start()

    def put(self, event: Event) -> None:
        """Hand over an event."""
        with self._changed:
            self._count += 1
            key = replaces(event)
            self._waiting.pop(key, None)
            self._waiting[self._count if key is None else key] = event
            self._changed.notify_all()

    def close(self, timeout_s: float) -> None:
        """Send what waits, and end."""
        with self._changed:
            self._closed = True
            self._changed.notify_all()
        self._thread.join(timeout_s)

    def _send(self) -> None:
        while True:
            with self._changed:
                self._changed.wait_for(lambda: self._waiting or self._closed)
                if not self._waiting:
                    return
                event = self._waiting.pop(next(iter(self._waiting)))
            try:
                self._connection.send(event)
            except OSError:
                return  # the screen has gone; the thread that reads commands notices it too and ends the engine
