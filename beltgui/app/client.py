"""The screen's end of the engine: sends commands, brings events to the GUI's thread, notices when the engine ends."""

from __future__ import annotations

import threading
import time
from collections.abc import Callable
from typing import Protocol

from PySide6.QtCore import QObject, Qt, QTimer, Signal

from beltgui.engine.messages import (
    CellMoved,
    Command,
    Event,
    JobProgress,
    OpenSession,
    Ready,
    SessionOpened,
    replaces,
)

# What only the latest of counts is shown at most this often; longer bursts of events are shown in portions.
FRAME_MS = 33
PORTION_S = 0.02

Deliver = Callable[[Event], None]
Ended = Callable[[str], None]


class Backend(Protocol):
    """An engine somewhere. `deliver` and `ended` may be called from any thread, `ended` at most once."""

    def start(self, deliver: Deliver, ended: Ended) -> None:
        """Begin; comes back at once."""
        ...

    def send(self, command: Command) -> None:
        """Hand over a command; does not wait for it."""
        ...

    def close(self) -> None:
        """End the engine and whatever was started for it; nothing is delivered afterwards."""
        ...


class EngineClient(QObject):
    """One engine after another, seen from the GUI's thread.

    Signals:
        event: Every event, in order; of `CellMoved`, of a job's progress and of a step's views only the latest.
        ended: The engine has ended by itself, with a sentence why; `restart` begins a new one.
        restarted: A new engine is being started.

    Args:
        make_backend: Makes a new engine.
    """

    event = Signal(object)
    ended = Signal(str)
    restarted = Signal()
    _woken = Signal()
    _end_noticed = Signal(int, str)

    def __init__(self, make_backend: Callable[[], Backend], parent: QObject | None = None) -> None:
        super().__init__(parent)
        self._make_backend = make_backend
        self._backend: Backend | None = None
        self._number = 0
        self._inbox = Inbox()
        self._session: SessionOpened | None = None
        self._reopen = False
        self.running = False
        self._timer = QTimer(self)
        self._timer.setSingleShot(True)
        self._timer.timeout.connect(self._show_portion)
        self._woken.connect(self._wake, Qt.ConnectionType.QueuedConnection)
        self._end_noticed.connect(self._on_end, Qt.ConnectionType.QueuedConnection)

    def start(self) -> None:
        """Start an engine; its `Ready` follows."""
        self._number += 1
        number = self._number
        self._inbox = inbox = Inbox()
        self._backend = self._make_backend()
        self.running = True

        def deliver(event: Event) -> None:
            if inbox.put(event):
                self._woken.emit()

        self._backend.start(deliver, lambda text: self._end_noticed.emit(number, text))

    def restart(self) -> None:
        """Start a new engine in place of one that has ended, and open the session again that it had open."""
        self._close_backend()
        self._reopen = True
        self.restarted.emit()
        self.start()

    def send(self, command: Command) -> None:
        """Hand over a command; while no engine runs it is dropped (the screen says that none runs)."""
        if self._backend is not None and self.running:
            self._backend.send(command)

    def close(self) -> None:
        """End the engine; no event comes afterwards."""
        self.running = False
        self._timer.stop()
        self._close_backend()

    def _close_backend(self) -> None:
        backend, self._backend = self._backend, None
        self.running = False
        self._inbox = Inbox()
        if backend is not None:
            backend.close()

    def _wake(self) -> None:
        if self._inbox.urgent():
            self._show_portion()
        elif not self._timer.isActive():
            self._timer.start(FRAME_MS)

    def _show_portion(self) -> None:
        until = time.monotonic() + PORTION_S
        while self.running and (event := self._inbox.take()) is not None:
            self._note(event)
            self.event.emit(event)
            if time.monotonic() > until:
                break
        if self.running and not self._inbox.empty():
            self._timer.start(0)

    def _note(self, event: Event) -> None:
        if isinstance(event, SessionOpened):
            self._session = event
        elif isinstance(event, Ready) and self._reopen:
            self._reopen = False
            if self._session is not None:
                self.send(OpenSession(self._session.folder, self._session.person, self._session.read_only))

    def _on_end(self, number: int, text: str) -> None:
        if number != self._number or not self.running:
            return
        while (event := self._inbox.take()) is not None:  # what it said before it ended
            self._note(event)
            self.event.emit(event)
        self.running = False
        self.ended.emit(text)


class Inbox:
    """Events between the thread that receives them and the GUI's; of some only the latest is kept."""

    def __init__(self) -> None:
        self._lock = threading.Lock()
        self._events: dict[object, Event] = {}
        self._count = 0

    def put(self, event: Event) -> bool:
        """Keep an event; whether the GUI has to be woken for it."""
        with self._lock:
            kind = replaces(event)
            self._count += 1
            waiting = kind is not None and self._events.pop(kind, None) is not None
            self._events[self._count if kind is None else kind] = event
            return not waiting

    def take(self) -> Event | None:
        """The oldest event, or None."""
        with self._lock:
            if not self._events:
                return None
            return self._events.pop(next(iter(self._events)))

    def empty(self) -> bool:
        """Nothing waits."""
        with self._lock:
            return not self._events

    def urgent(self) -> bool:
        """Something waits that has to be shown at once."""
        with self._lock:
            return any(not isinstance(event, CellMoved | JobProgress) for event in self._events.values())
