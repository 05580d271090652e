"""Mouse and keyboard: finds a widget by its object name, and then acts with real X events through xdotool only.

The driver runs in a thread beside the window's own; it looks at widgets through calls that the window's thread
executes, and never calls anything on them that changes something.
"""

from __future__ import annotations

import subprocess
import threading
import time
from collections.abc import Callable
from pathlib import Path
from typing import Any, TypeVar

from PySide6.QtCore import QObject, QPoint, Qt, QThread, Signal, Slot
from PySide6.QtGui import QGuiApplication, QImage
from PySide6.QtWidgets import QApplication, QWidget

T = TypeVar("T")
LOOK_EVERY_S = 0.05
# A picture stands still if it is the same so often.
STILL_EVERY_S, STILL_LOOKS, MOST_LOOKS = 0.1, 3, 25


class TooLongError(AssertionError):
    """What was waited for did not come; the picture says what was there instead."""


class _Caller(QObject):
    """Executes a look in the window's thread."""

    asked = Signal(object)

    def __init__(self, home: QThread) -> None:
        super().__init__()
        self.moveToThread(home)
        self.asked.connect(self._execute, Qt.ConnectionType.BlockingQueuedConnection)

    @Slot(object)
    def _execute(self, box: dict[str, Any]) -> None:
        try:
            box["value"] = box["look"]()
        except BaseException as error:
            box["error"] = error


class Screen:
    """The window as a person uses it.

    Args:
        out: Folder for the screenshots.
    """

    def __init__(self, out: Path) -> None:
        self.out = out
        self.out.mkdir(parents=True, exist_ok=True)
        self._caller = _Caller(QThread.currentThread())
        self._pause = threading.Event()
        self.shots: list[Path] = []

    # ---- looking

    def look(self, what: Callable[[], T]) -> T:
        """Call in the window's thread."""
        box: dict[str, Any] = {"look": what}
        self._caller.asked.emit(box)
        if "error" in box:
            raise box["error"]
        return box["value"]

    def widgets(self, name: str) -> list[QWidget]:
        """Visible widgets of that object name."""
        return [widget for widget in QApplication.allWidgets() if widget.objectName() == name and widget.isVisible()]

    def visible(self, name: str) -> bool:
        """True if such a widget can be seen."""
        return self.look(lambda: bool(self.widgets(name)))

    def enabled(self, name: str) -> bool:
        """True if such a widget can be seen and used."""
        return self.look(lambda: any(widget.isEnabled() for widget in self.widgets(name)))

    def text(self, name: str) -> str:
        """What it says."""

        def read() -> str:
            widget: Any = self.widgets(name)[0]
            return str(widget.text()) if hasattr(widget, "text") else str(widget.toPlainText())

        return self.look(read)

    def focus(self) -> str:
        """Object name of the widget that the keyboard is on; empty for none."""

        def read() -> str:
            widget = QApplication.focusWidget()
            return "" if widget is None else widget.objectName() or type(widget).__name__

        return self.look(read)

    def wait(self, what: str, condition: Callable[[], bool], timeout_s: float = 60.0) -> None:
        """Look again and again until it is so (the condition is called in this thread)."""
        end = time.monotonic() + timeout_s
        while not condition():
            if time.monotonic() > end:
                self.shot("took_too_long")
                raise TooLongError(
                    f"{what}: not within {timeout_s:g} s; the keyboard is on '{self.focus()}'; see {self.shots[-1]}"
                )
            self._pause.wait(LOOK_EVERY_S)

    # ---- acting

    def place(self, name: str) -> tuple[int, int]:
        """Middle of the widget on the screen, px."""

        def find() -> tuple[int, int]:
            found = [widget for widget in self.widgets(name) if widget.isEnabled()]
            assert found, f"there is no usable '{name}' on the screen"
            widget = found[0]
            seen = widget.visibleRegion().boundingRect()
            assert not seen.isEmpty(), f"'{name}' is covered or scrolled away"
            middle = widget.mapToGlobal(seen.center())
            return middle.x(), middle.y()

        return self.look(find)

    def click(self, name: str, timeout_s: float = 30.0) -> None:
        """Move the mouse there and click."""
        self.wait(f"'{name}' can be clicked", lambda: self.enabled(name), timeout_s)
        self.click_at(*self.place(name))

    def click_at(self, x: int, y: int) -> None:
        """Click at a place of the screen."""
        xdotool("mousemove", str(x), str(y), "click", "1")

    def click_in(self, name: str, across: float, down: float) -> None:
        """Click in a widget, at a share of its width and height."""

        def find() -> tuple[int, int]:
            widget = self.widgets(name)[0]
            point = widget.mapToGlobal(QPoint(round(across * widget.width()), round(down * widget.height())))
            return point.x(), point.y()

        self.click_at(*self.look(find))

    def press(self, name: str) -> None:
        """Mouse button down on it."""
        x, y = self.place(name)
        xdotool("mousemove", str(x), str(y), "mousedown", "1")

    def release(self) -> None:
        """Mouse button up."""
        xdotool("mouseup", "1")

    def type(self, words: str) -> None:
        """Type on the keyboard."""
        xdotool("type", "--delay", "15", words)

    def key(self, *names: str) -> None:
        """Press keys one after another, e.g. `ctrl+1`, `Tab`."""
        xdotool("key", "--delay", "30", *names)

    def shot(self, name: str) -> Path:
        """Keep a picture of the whole screen once it stands still, or after a while as it is then."""
        path = self.out / f"{len(self.shots) + 1:02d}_{name}.png"
        picture, still = self._grab(), 0
        for _ in range(MOST_LOOKS):
            if still == STILL_LOOKS:
                break
            self._pause.wait(STILL_EVERY_S)
            again = self._grab()
            still = still + 1 if again == picture else 0
            picture = again
        assert picture.save(str(path))
        self.shots.append(path)
        return path

    def _grab(self) -> QImage:
        return self.look(lambda: QGuiApplication.primaryScreen().grabWindow(0).toImage())


def xdotool(*words: str) -> None:
    """Real X events."""
    subprocess.run(["xdotool", *words], check=True, timeout=30)


def run_beside(run: Callable[[], int], work: Callable[[], None]) -> list[BaseException]:
    """Run an application here and a driver's work in a thread beside it.

    Args:
        run: Comes back when the application has ended.
        work: Called in the thread; has to close the application at its end.

    Returns:
        What went wrong in either.
    """
    problems: list[BaseException] = []

    def drive() -> None:
        try:
            work()
        except BaseException as error:
            problems.append(error)
            xdotool("key", "ctrl+q")

    thread = threading.Thread(target=drive, name="driver")
    thread.start()
    code = run()
    thread.join()
    if code:
        problems.append(AssertionError(f"the application ended with exit code {code}"))
    return problems
