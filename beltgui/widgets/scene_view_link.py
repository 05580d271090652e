"""Where pictures are drawn: in a process beside the screen's (usual), or within it (tests, scripts).

VTK keeps Python's lock while it renders, so a thread would not keep the window alive; a process does, and a driver that
crashes takes the picture with it but not the window.
"""

from __future__ import annotations

import multiprocessing
import threading
import time
from dataclasses import dataclass
from multiprocessing.connection import Connection
from multiprocessing.process import BaseProcess
from multiprocessing.shared_memory import SharedMemory
from queue import SimpleQueue

import numpy as np
from numpy.typing import NDArray
from PySide6.QtCore import QObject, QThread, QTimer, Signal

from beltgui.widgets.scene_draw import Request, Stage, serve

GOODBYE_S = 5.0


@dataclass(frozen=True, eq=False)
class Picture:
    """What was drawn: `pixels` (height, width, 4) in the order of Qt's RGB32, and the seconds it took.

    No pixels: it was drawn into the window itself.
    """

    pixels: NDArray[np.uint8] | None
    seconds: float


class ProcessDrawer(QThread):
    """Sends requests to a drawing process and brings back the pixels.

    One request at a time: the next one only after `drawn`.

    Signals:
        drawn: A `Picture`.
        lost: The process has ended without being asked to.
    """

    drawn = Signal(object)
    lost = Signal()

    def __init__(self, parent: QObject | None = None) -> None:
        super().__init__(parent)
        self._requests: SimpleQueue[Request | None] = SimpleQueue()
        self._lock = threading.Lock()
        self._stopping = False
        self._process: BaseProcess | None = None
        self._memory: SharedMemory | None = None
        self.start()

    @property
    def pid(self) -> int | None:
        """Of the drawing process."""
        return None if self._process is None else self._process.pid

    def submit(self, request: Request) -> None:
        """Draw this; returns at once."""
        self._requests.put(request)

    def stop(self) -> None:
        """End the process and the thread, and free the shared memory; returns when all are gone."""
        with self._lock:
            self._stopping = True
            if self._process is not None:
                self._process.terminate()  # it holds nothing that could be spoilt
        self._requests.put(None)
        self.wait()

    def run(self) -> None:
        """The thread: everything that waits for the process is in here."""
        connection: Connection | None = None
        try:
            connection = self._begin()
            if connection is not None:
                self._serve(connection)
        finally:
            if connection is not None:
                connection.close()
            self._end()
            if not self._stopping:
                self.lost.emit()

    def _begin(self) -> Connection | None:
        context = multiprocessing.get_context("spawn")
        here, there = context.Pipe()
        with self._lock, there:
            if self._stopping:
                here.close()
                return None
            process = context.Process(target=serve, args=(there,), name="beltcal 3D view", daemon=True)
            process.start()
            self._process = process
        return here

    def _serve(self, connection: Connection) -> None:
        while (request := self._requests.get()) is not None:
            shape = (request.height, request.width, 4)
            memory = self._room(int(np.prod(shape)))
            try:
                connection.send((request, memory.name))
                seconds = connection.recv()
            except (EOFError, BrokenPipeError, ConnectionResetError):
                return
            self.drawn.emit(Picture(np.array(np.ndarray(shape, dtype=np.uint8, buffer=memory.buf)), seconds))

    def _room(self, size: int) -> SharedMemory:
        if self._memory is None or self._memory.size < size:
            self._free()
            self._memory = SharedMemory(create=True, size=size)
        return self._memory

    def _free(self) -> None:
        if self._memory is not None:
            self._memory.close()
            self._memory.unlink()
            self._memory = None

    def _end(self) -> None:
        process = self._process
        if process is not None:
            process.terminate()
            process.join(GOODBYE_S)
            if process.is_alive():
                process.kill()
                process.join()
            process.close()
        with self._lock:
            self._process = None
        self._free()


class LocalDrawer(QObject):
    """Draws within this process, when the event loop comes round; the same words as `ProcessDrawer`."""

    drawn = Signal(object)
    lost = Signal()

    def __init__(self, parent: QObject | None = None) -> None:
        super().__init__(parent)
        self._stage: Stage | None = None
        self._stopped = False

    def submit(self, request: Request) -> None:
        """Draw this soon."""
        QTimer.singleShot(0, self, lambda: self._draw(request))

    def stop(self) -> None:
        """Free the OpenGL objects."""
        self._stopped = True
        if self._stage is not None:
            self._stage.close()
            self._stage = None

    def _draw(self, request: Request) -> None:
        if self._stopped:
            return
        if self._stage is None:
            self._stage = Stage()
        begun = time.monotonic()
        pixels = self._stage.draw(request)
        self.drawn.emit(Picture(pixels, time.monotonic() - begun))
