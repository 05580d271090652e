"""Thousands of marks of one look: painted as dots in one go, many times faster than marks with a symbol each."""

from __future__ import annotations

from typing import Any

import numpy as np
import pyqtgraph as pg
from PySide6.QtCore import QPointF, QRectF, Qt, Signal
from PySide6.QtGui import QColor, QPainter, QPen
from PySide6.QtWidgets import QStyleOptionGraphicsItem, QWidget

DOT_PX = 4.0
# A click this near to a dot is a click on it.
REACH_PX = 8.0


class Dot:
    """One dot, as a click reports it."""

    def __init__(self, place: int) -> None:
        self._place = place

    def index(self) -> int:
        """Place among the dots."""
        return self._place


class DotsItem(pg.GraphicsObject):
    """Dots at (x, y).

    Signals:
        sigClicked: (item, [Dot], event), as pyqtgraph's own scatter plot says it.
    """

    sigClicked = Signal(object, object, object)  # noqa: N815  (as in pyqtgraph)

    def __init__(self) -> None:
        super().__init__()
        self._xy = np.zeros((0, 2))
        self._colour = QColor()
        self.sample_ids: np.ndarray | None = None

    def sample_id(self, place: int) -> int | None:
        """Of the dot at a place; None if dots stand for no samples."""
        return None if self.sample_ids is None else int(self.sample_ids[place])

    def show_dots(self, x: np.ndarray, y: np.ndarray, ink: QColor) -> None:
        """Show these; x and y (N,) finite."""
        self.prepareGeometryChange()
        self._xy, self._colour = np.column_stack([x, y]), ink
        self.informViewBoundsChanged()
        self.update()

    def count(self) -> int:
        """How many there are."""
        return len(self._xy)

    def boundingRect(self) -> QRectF:  # noqa: N802
        """Around all dots, in data coordinates."""
        if not len(self._xy):
            return QRectF()
        (left, low), (right, high) = self._xy.min(axis=0), self._xy.max(axis=0)
        wide, tall = (DOT_PX * length for length in self._pixel())
        return QRectF(left - wide, low - tall, right - left + 2 * wide, high - low + 2 * tall)

    def dataBounds(self, ax: int, frac: float = 1.0, orthoRange: Any = None) -> tuple[float, float] | None:  # noqa: N802, N803
        """Range along an axis, as pyqtgraph's view box asks for it."""
        if not len(self._xy):
            return None
        return float(self._xy[:, ax].min()), float(self._xy[:, ax].max())

    def pixelPadding(self) -> float:  # noqa: N802
        """Beyond the data."""
        return DOT_PX

    def paint(self, painter: QPainter, option: QStyleOptionGraphicsItem, widget: QWidget | None = None) -> None:
        """Dots on the same pixel are drawn once."""
        at = self._on_screen(painter)
        rounded = np.round(at).astype(np.int64)
        _, first = np.unique(rounded[:, 0] << 20 | rounded[:, 1] + 16, return_index=True)
        shown = rounded[first]
        painter.resetTransform()
        pen = QPen(self._colour, DOT_PX)
        pen.setCapStyle(Qt.PenCapStyle.RoundCap)
        painter.setPen(pen)
        painter.drawPoints(pg.functions.arrayToQPolygonF(shown[:, 0], shown[:, 1]))

    def mouseClickEvent(self, event: Any) -> None:  # noqa: N802
        """Report the nearest dot within reach."""
        if event.button() != Qt.MouseButton.LeftButton or not len(self._xy):
            event.ignore()
            return
        at = event.pos()
        away = (self._xy - (at.x(), at.y())) / self._pixel()
        distance = np.hypot(away[:, 0], away[:, 1])
        nearest = int(np.argmin(distance))
        if distance[nearest] > REACH_PX:
            event.ignore()
            return
        event.accept()
        self.sigClicked.emit(self, [Dot(nearest)], event)

    def _pixel(self) -> tuple[float, float]:
        """Size of a pixel in data coordinates; (1, 1) before it is on a screen."""
        wide, tall = self.pixelVectors()
        if wide is None or tall is None:
            return 1.0, 1.0
        return max(wide.manhattanLength(), 1e-300), max(tall.manhattanLength(), 1e-300)

    def _on_screen(self, painter: QPainter) -> np.ndarray:
        transform = painter.transform()
        origin = transform.map(QPointF(0.0, 0.0))
        right, up = transform.map(QPointF(1.0, 0.0)) - origin, transform.map(QPointF(0.0, 1.0)) - origin
        at = self._xy @ np.array([[right.x(), right.y()], [up.x(), up.y()]]) + (origin.x(), origin.y())
        device = painter.device()
        inside = ((at > -DOT_PX) & (at < (device.width() + DOT_PX, device.height() + DOT_PX))).all(axis=1)
        return at[inside]
