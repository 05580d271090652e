"""Hold to run: true while the button is held, and only then."""

from __future__ import annotations

from PySide6.QtCore import QEvent, Qt, Signal
from PySide6.QtGui import QFocusEvent, QHideEvent, QKeyEvent, QMouseEvent
from PySide6.QtWidgets import QPushButton, QWidget


class HoldButton(QPushButton):
    """Held with the left mouse button or the Space key.

    It is let go when either is released, and also when the pointer leaves it, the focus goes, the window is no longer
    the active one, or it is hidden or disabled. A key's automatic repetition neither presses nor releases it.

    Signals:
        held: True when pressed, False when let go, for whatever reason.
    """

    held = Signal(bool)

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self._held = False
        self.setAutoDefault(False)
        self.setFocusPolicy(Qt.FocusPolicy.StrongFocus)

    @property
    def is_held(self) -> bool:
        """Whether it is held now."""
        return self._held

    def let_go(self) -> None:
        """As if it had been released."""
        self._set(False)
        self.setDown(False)

    def mousePressEvent(self, event: QMouseEvent) -> None:  # noqa: N802
        """The left button presses."""
        if event.button() == Qt.MouseButton.LeftButton:
            self.setDown(True)
            self._set(True)
        event.accept()

    def mouseMoveEvent(self, event: QMouseEvent) -> None:  # noqa: N802
        """Leaving lets go, and coming back does not press again."""
        if not self.rect().contains(event.position().toPoint()):
            self.let_go()
        event.accept()

    def mouseReleaseEvent(self, event: QMouseEvent) -> None:  # noqa: N802
        """Let go."""
        if event.button() == Qt.MouseButton.LeftButton:
            self.let_go()
        event.accept()

    def keyPressEvent(self, event: QKeyEvent) -> None:  # noqa: N802
        """Space presses, once."""
        if event.key() == Qt.Key.Key_Space:
            if not event.isAutoRepeat() and not self._held:
                self.setDown(True)
                self._set(True)
            event.accept()
            return
        if event.key() in (Qt.Key.Key_Return, Qt.Key.Key_Enter, Qt.Key.Key_Select):
            event.accept()  # a click by key would not be a hold
            return
        super().keyPressEvent(event)

    def keyReleaseEvent(self, event: QKeyEvent) -> None:  # noqa: N802
        """Space releases, unless it only repeats."""
        if event.key() == Qt.Key.Key_Space:
            if not event.isAutoRepeat():
                self.let_go()
            event.accept()
            return
        super().keyReleaseEvent(event)

    def focusOutEvent(self, event: QFocusEvent) -> None:  # noqa: N802
        """Let go."""
        self.let_go()
        super().focusOutEvent(event)

    def hideEvent(self, event: QHideEvent) -> None:  # noqa: N802
        """Let go."""
        self.let_go()
        super().hideEvent(event)

    def leaveEvent(self, event: QEvent) -> None:  # noqa: N802
        """Let go."""
        self.let_go()
        super().leaveEvent(event)

    def changeEvent(self, event: QEvent) -> None:  # noqa: N802
        """Let go when disabled or when the window is no longer the active one."""
        super().changeEvent(event)
        off = event.type() == QEvent.Type.EnabledChange and not self.isEnabled()
        if off or (event.type() == QEvent.Type.ActivationChange and not self.isActiveWindow()):
            self.let_go()

    def _set(self, held: bool) -> None:
        if held != self._held:
            self._held = held
            self.held.emit(held)
