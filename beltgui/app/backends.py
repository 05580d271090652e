"""Where an engine runs: in a process of its own, as the application has it, or in this one, as tests do."""

from __future__ import annotations

import threading
from typing import TYPE_CHECKING

from beltgui.engine.messages import Command, Event
from beltgui.engine.process import start_engine

if TYPE_CHECKING:
    from beltgui.app.client import Deliver, Ended
    from beltgui.engine.engine import Engine

# A robot that is asked to stop needs this long; then the process is ended, and with it all that it asks for.
PATIENCE_S = 3.0


class ProcessBackend:
    """An engine in a process of its own. It is started here and now; what it says is kept until somebody listens."""

    def __init__(self) -> None:
        self._lock = threading.Lock()
        self._early: list[Event] = []
        self._end: str | None = None
        self._deliver: Deliver | None = None
        self._ended: Ended | None = None
        self._engine = start_engine(self._on_event, self._on_end)

    def start(self, deliver: Deliver, ended: Ended) -> None:
        """Listen; what has been said already comes first."""
        with self._lock:
            self._deliver, self._ended = deliver, ended
            for event in self._early:
                deliver(event)
            self._early = []
            if self._end is not None:
                ended(self._end)

    def send(self, command: Command) -> None:
        """Hand over a command. If nobody takes it any more, the end is told apart from this."""
        self._engine.send(command)

    def close(self) -> None:
        """End the process and the thread that reads from it."""
        self._engine.close(PATIENCE_S)

    def _on_event(self, event: Event) -> None:
        with self._lock:
            if self._deliver is None:
                self._early.append(event)
            else:
                self._deliver(event)

    def _on_end(self, why: str) -> None:
        with self._lock:
            self._end = why
            if self._ended is not None:
                self._ended(why)


class LocalBackend:
    """An engine in this process, for tests."""

    def __init__(self) -> None:
        self._engine: Engine | None = None

    def start(self, deliver: Deliver, ended: Ended) -> None:
        """Begin; an engine in this process does not end by itself."""
        from beltgui.engine.engine import Engine

        self._engine = Engine(deliver)

    def send(self, command: Command) -> None:
        """Hand over a command."""
        if self._engine is not None:
            self._engine.handle(command)

    def close(self) -> None:
        """End the engine."""
        if self._engine is not None:
            self._engine.close(PATIENCE_S)
