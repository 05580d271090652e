"""What runs in the engine's process. Importing this imports nothing heavy: threads of libraries are limited first."""

from __future__ import annotations

import faulthandler
import logging
import os
import signal
import threading
import traceback
from multiprocessing.connection import Connection
from pathlib import Path
from typing import Any

NICE = 5  # the screen goes first where both want the processor
END_S = 3.0


def run_engine(connection: Connection, last_words: str) -> None:
    """Take commands until the screen says `Shutdown` or is gone; the robot is stopped in both cases.

    Args:
        connection: Commands come, events go.
        last_words: File for the trace of a crash of native code.
    """
    signal.signal(signal.SIGINT, signal.SIG_IGN)  # Ctrl-C is the parent's: it shuts the engine down in order
    cores = len(os.sched_getaffinity(0)) if hasattr(os, "sched_getaffinity") else os.cpu_count() or 1
    for name in ("OMP_NUM_THREADS", "OPENBLAS_NUM_THREADS", "MKL_NUM_THREADS"):
        os.environ.setdefault(name, str(max(1, cores - 1)))
    if hasattr(os, "nice"):
        os.nice(NICE)
    with open(last_words, "w", encoding="utf-8") as file:
        faulthandler.enable(file)
        ended = _serve(connection)
        faulthandler.disable()
    Path(last_words).unlink(missing_ok=True)  # nothing to say; the parent may not live to tidy up
    if not ended:
        os._exit(1)  # a thread is deep inside a library; everything that was kept is on disk


def _serve(connection: Connection) -> bool:
    """Whether all threads of the engine ended."""
    from beltgui.engine.engine import Engine
    from beltgui.engine.messages import Crashed, Shutdown
    from beltgui.engine.outbox import Outbox

    outbox = Outbox(connection)

    def crashed(text: str) -> None:
        outbox.put(Crashed(text))

    threading.excepthook = lambda args: crashed(
        "".join(traceback.format_exception(args.exc_type, args.exc_value, args.exc_traceback))
    )
    handler = _ToScreen(crashed)
    logging.getLogger().addHandler(handler)
    engine = Engine(outbox.put, warm_up=True)
    try:
        while True:
            try:
                command = connection.recv()
            except (EOFError, OSError):
                break  # the screen is gone, however it ended
            if isinstance(command, Shutdown):
                break
            try:
                engine.handle(command)
            except Exception:
                crashed(traceback.format_exc())
    finally:
        ended = engine.close(END_S)
        logging.getLogger().removeHandler(handler)
        outbox.close(END_S)
        connection.close()
    return ended


class _ToScreen(logging.Handler):
    """Errors in the log become events."""

    def __init__(self, tell: Any) -> None:
        super().__init__(logging.ERROR)
        self._tell = tell

    def emit(self, record: logging.LogRecord) -> None:
        """Tell the screen."""
        self._tell(self.format(record))
