"""The engine in a process of its own; this is the screen's end and imports nothing heavy."""

from __future__ import annotations

import contextlib
import multiprocessing
import os
import sys
import tempfile
import threading
import types
from collections.abc import Callable, Iterator
from multiprocessing.connection import Connection
from multiprocessing.process import BaseProcess
from pathlib import Path

from beltgui.engine.child import run_engine
from beltgui.engine.messages import Command, Event, Shutdown
from beltgui.leftovers import prefix, sweep

OnEvent = Callable[[Event], None]
OnEnd = Callable[[str], None]
CLOSE_S = 8.0


class EngineHandle:
    """A running engine; make it with `start_engine` and `close` it."""

    def __init__(
        self, process: BaseProcess, connection: Connection, last_words: Path, on_event: OnEvent, on_end: OnEnd
    ) -> None:
        self._process, self._connection, self._last_words = process, connection, last_words
        self._on_event, self._on_end = on_event, on_end
        self._sending = threading.Lock()
        self._closing = False
        self._reader = threading.Thread(target=self._read, name="engine reader", daemon=True)
        self._reader.start()

    @property
    def alive(self) -> bool:
        """The process runs."""
        return self._process.is_alive()

    @property
    def pid(self) -> int:
        """Of the process."""
        return self._process.pid or 0

    def send(self, command: Command) -> bool:
        """Hand over a command; False if the engine is gone (`on_end` says why)."""
        with self._sending:
            try:
                self._connection.send(command)
            except (OSError, ValueError):
                return False
        return True

    def close(self, timeout_s: float = CLOSE_S) -> None:
        """Shut the engine down; after `timeout_s` it is killed. No event comes afterwards."""
        self._closing = True
        self.send(Shutdown())
        self._process.join(timeout_s)
        self.kill()

    def kill(self) -> None:
        """End the process at once, if it still runs; what was kept is on disk."""
        self._closing = True
        if self._process.is_alive():
            self._process.kill()
        self._process.join()
        if threading.current_thread() is not self._reader:
            self._reader.join()
        self._connection.close()
        self._last_words.unlink(missing_ok=True)

    def _read(self) -> None:
        while True:
            try:
                event = self._connection.recv()
            except (EOFError, OSError):
                break
            if not self._closing:
                self._on_event(event)
        self._process.join()
        if not self._closing:
            self._on_end(self._why())

    def _why(self) -> str:
        with contextlib.suppress(OSError):
            words = self._last_words.read_text(encoding="utf-8").strip()
            if words:
                return f"The engine has crashed (exit code {self._process.exitcode}).\n{words}"
        return f"The engine has ended by itself (exit code {self._process.exitcode})."


def start_engine(on_event: OnEvent, on_end: OnEnd) -> EngineHandle:
    """Start an engine; comes back at once, its `Ready` follows.

    Args:
        on_event: Takes every event, in a thread of the handle.
        on_end: Told why if the engine ends without having been asked to, in the same thread, after the last event.
    """
    context = multiprocessing.get_context("spawn")
    ours, its = context.Pipe()
    sweep()
    handle, name = tempfile.mkstemp(prefix=prefix("engine"), suffix=".txt")
    os.close(handle)
    process = context.Process(target=run_engine, args=(its, name), name="beltcal engine", daemon=True)
    with _without_main():
        process.start()
    its.close()
    return EngineHandle(process, ours, Path(name), on_event, on_end)


@contextlib.contextmanager
def _without_main() -> Iterator[None]:
    """Spawn would run the parent's main module again in the child, which needs nothing of it and may not bear it."""
    main = sys.modules["__main__"]
    sys.modules["__main__"] = types.ModuleType("__main__")
    try:
        yield
    finally:
        sys.modules["__main__"] = main
