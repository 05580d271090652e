"""A scroll area that scrolls up and down only: what is in it is never wider than what is seen of it."""

from __future__ import annotations

from PySide6.QtCore import QEvent, QObject, Qt
from PySide6.QtGui import QResizeEvent
from PySide6.QtWidgets import QFrame, QScrollArea, QWidget


class TallScroll(QScrollArea):
    """Keeps its content as wide as the viewport, also where the content would like to be wider."""

    def __init__(self, body: QWidget, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.setWidgetResizable(True)
        self.setFrameShape(QFrame.Shape.NoFrame)
        self.setHorizontalScrollBarPolicy(Qt.ScrollBarPolicy.ScrollBarAlwaysOff)
        self.setWidget(body)
        self.viewport().installEventFilter(self)

    def resizeEvent(self, event: QResizeEvent) -> None:  # noqa: N802
        """Another width."""
        super().resizeEvent(event)
        self._narrow()

    def eventFilter(self, watched: QObject, event: QEvent) -> bool:  # noqa: N802
        """The viewport narrows when the scroll bar comes."""
        if watched is self.viewport() and event.type() == QEvent.Type.Resize:
            self._narrow()
        return super().eventFilter(watched, event)

    def scrollContentsBy(self, dx: int, dy: int) -> None:  # noqa: N802
        """Never sideways, not even to show what has the focus."""
        super().scrollContentsBy(0, dy)

    def _narrow(self) -> None:
        self.widget().setMaximumWidth(max(self.viewport().width(), 1))
