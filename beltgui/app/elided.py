"""A label of at most so many lines; what does not fit ends in an ellipsis and is whole in the tool tip."""

from __future__ import annotations

from PySide6.QtCore import QSize, Qt
from PySide6.QtGui import QPainter, QPaintEvent, QTextLayout
from PySide6.QtWidgets import QLabel, QSizePolicy, QWidget


class ElidedLabel(QLabel):
    """Plain text, wrapped, cut after `lines` lines; the text itself stays whole for readers and tests."""

    def __init__(self, lines: int = 1, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self._lines = lines
        self.setTextFormat(Qt.TextFormat.PlainText)
        self.setWordWrap(lines > 1)
        self.setSizePolicy(QSizePolicy.Policy.Ignored if lines > 1 else QSizePolicy.Policy.Preferred,
                           QSizePolicy.Policy.Preferred)  # fmt: skip

    def setText(self, text: str) -> None:  # noqa: N802  (Qt's name)
        """Show a text; the whole of it is in the tool tip."""
        super().setText(text)
        self.setToolTip(text)

    def minimumSizeHint(self) -> QSize:  # noqa: N802  (Qt's name)
        """One word wide."""
        return QSize(self.fontMetrics().averageCharWidth() * 6, self._height(1))

    def hasHeightForWidth(self) -> bool:  # noqa: N802  (Qt's name)
        """The number of lines follows from the width."""
        return self._lines > 1

    def heightForWidth(self, width: int) -> int:  # noqa: N802  (Qt's name)
        """Of the lines that are shown."""
        return self._height(len(self._broken(width)))

    def sizeHint(self) -> QSize:  # noqa: N802  (Qt's name)
        """Of the whole text where it is one line."""
        width = self.fontMetrics().horizontalAdvance(self.text()) + 2
        return QSize(width, self._height(1))

    def paintEvent(self, event: QPaintEvent) -> None:  # noqa: N802  (Qt's name)
        """Draw the lines."""
        painter = QPainter(self)
        painter.setPen(self.palette().color(self.foregroundRole()))
        step = self.fontMetrics().lineSpacing()
        lines = self._broken(self.width())
        top = max(0, (self.height() - self._height(len(lines))) // 2)
        for place, line in enumerate(lines):
            painter.drawText(0, top + place * step + self.fontMetrics().ascent(), line)
        painter.end()

    def _height(self, lines: int) -> int:
        return max(lines, 1) * self.fontMetrics().lineSpacing()

    def _broken(self, width: int) -> list[str]:
        text, metrics = self.text(), self.fontMetrics()
        if self._lines == 1:
            return [metrics.elidedText(text, Qt.TextElideMode.ElideRight, width)]
        layout = QTextLayout(text, self.font())
        layout.beginLayout()
        starts = []
        while (line := layout.createLine()).isValid():
            line.setLineWidth(max(width, 1))
            starts.append(line.textStart())
        layout.endLayout()
        shown = [text[a:b] for a, b in zip(starts, [*starts[1:], len(text)], strict=True)][: self._lines]
        if len(starts) > self._lines:
            rest = text[starts[self._lines - 1] :]
            shown[-1] = metrics.elidedText(rest, Qt.TextElideMode.ElideRight, width)
        return shown
