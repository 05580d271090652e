"""A result's numbers: value, unit, ± (k = 2), and a bar against the limit where there is one."""

from __future__ import annotations

import math

from PySide6.QtCore import QRectF, QSize, Qt
from PySide6.QtGui import QColor, QPainter, QPaintEvent, QPen
from PySide6.QtWidgets import QGridLayout, QLabel, QSizePolicy, QToolButton, QVBoxLayout, QWidget

from beltgui.app.language import sentence
from beltgui.app.theme import colour, px, theme
from beltgui.viewmodel.scene import Role
from beltgui.viewmodel.step import Number
from beltgui.widgets.figures import decimals_for, with_unit

# Where on the bar the limit is drawn, so that going beyond it is seen.
LIMIT_AT = 0.75
# So many numbers are read at a glance; the others are there on demand.
FEW = 8


class LimitBar(QWidget):
    """How much of the allowed range a value takes: a bar, with a line at the limit."""

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self._share: float | None = None
        self.setSizePolicy(QSizePolicy.Policy.Expanding, QSizePolicy.Policy.Fixed)
        theme().changed.connect(self._resized)

    @property
    def share(self) -> float | None:
        """Value over limit; None if not known."""
        return self._share

    def show_share(self, value: float | None, limit: float) -> None:
        """Show |value| against a limit above zero."""
        known = value is not None and math.isfinite(value) and limit > 0.0
        self._share = abs(value) / limit if known and value is not None else None
        self.update()

    def sizeHint(self) -> QSize:  # noqa: N802
        """As high as half a line."""
        return QSize(px(80), px(10))

    def paintEvent(self, event: QPaintEvent) -> None:  # noqa: N802
        """Track, bar, limit."""
        painter = QPainter(self)
        line = QColor(colour("line"))
        area = QRectF(self.rect()).adjusted(0.5, 2.5, -0.5, -2.5)
        painter.setPen(QPen(line, 1.0))
        painter.setBrush(QColor(colour("background")))
        painter.drawRect(area)
        if self._share is not None:
            length = min(self._share * LIMIT_AT, 1.0) * area.width()
            painter.fillRect(
                QRectF(area.left(), area.top(), length, area.height()),
                QColor(colour(Role.ATTENTION if self._share > 1.0 else "muted")),
            )
        at = area.left() + LIMIT_AT * area.width()
        painter.setPen(QPen(QColor(colour("text")), 2.0))
        painter.drawLine(round(at), 0, round(at), self.height())

    def _resized(self) -> None:
        self.updateGeometry()
        self.update()


class NumberRow(QWidget):
    """One number."""

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.label = QLabel(self)
        self.label.setWordWrap(True)
        self.label.setProperty("tone", "muted")
        self.value = QLabel(self)
        self.value.setAlignment(Qt.AlignmentFlag.AlignRight | Qt.AlignmentFlag.AlignBottom)
        self.value.setTextInteractionFlags(Qt.TextInteractionFlag.TextSelectableByMouse)
        self.spread = QLabel(self)
        self.spread.setProperty("tone", "muted")
        self.spread.setAlignment(Qt.AlignmentFlag.AlignRight)
        self.limit = QLabel(self)
        self.limit.setAlignment(Qt.AlignmentFlag.AlignRight)
        self.bar = LimitBar(self)
        grid = QGridLayout(self)
        grid.setContentsMargins(0, 0, 0, 2)
        grid.setHorizontalSpacing(8)
        grid.setVerticalSpacing(0)
        grid.setColumnStretch(0, 1)
        grid.addWidget(self.label, 0, 0)
        grid.addWidget(self.value, 0, 1)
        grid.addWidget(self.spread, 1, 0, 1, 2)
        grid.addWidget(self.bar, 2, 0)
        grid.addWidget(self.limit, 2, 1)

    def show_number(self, item: Number) -> None:
        """Show a number; a main one larger, one with a limit with its bar."""
        _look(self.value, "title", "2" if item.main else "")
        self.bar.setVisible(item.limit is not None)
        self.limit.setVisible(item.limit is not None)
        self.label.setText(sentence(item.label))
        decimals = decimals_for(item.plus_minus, item.decimals)
        self.value.setText(with_unit(item.value, item.unit, decimals))
        self.spread.setVisible(item.plus_minus is not None)
        if item.plus_minus is not None:
            self.spread.setText(
                self.tr("± {spread} (k = 2)").format(spread=with_unit(item.plus_minus, item.unit, decimals))
            )
        if item.limit is not None:
            self.bar.show_share(item.value, item.limit)
            over = self.bar.share is not None and self.bar.share > 1.0
            words = self.tr("▲ limit {limit}") if over else self.tr("limit {limit}")
            self.limit.setText(words.format(limit=with_unit(item.limit, item.unit, item.decimals)))
            _look(self.limit, "tone", "bad" if over else "muted")
        self.setAccessibleName(self.text())

    def text(self) -> str:
        """All it says, for a screen reader."""
        parts = [self.label, self.value, self.spread, self.limit]
        return " ".join(part.text() for part in parts if not part.isHidden())


def _look(label: QLabel, key: str, value: str) -> None:
    """Give a label another look of the stylesheet."""
    if (label.property(key) or "") != value:
        label.setProperty(key, value)
        label.style().polish(label)


class NumbersPanel(QWidget):
    """All numbers of a result, the main ones first."""

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.setObjectName("numbers")
        self._numbers: tuple[Number, ...] = ()
        self.rows: list[NumberRow] = []
        self.all_button = QToolButton(self)
        self.all_button.setObjectName("numbers_all")
        self.all_button.setCheckable(True)
        self.all_button.toggled.connect(self.retranslate)
        self._layout = QVBoxLayout(self)
        self._layout.setContentsMargins(0, 0, 0, 0)
        self._layout.setSpacing(4)
        self._layout.addWidget(self.all_button)
        self._make_rows(FEW)
        self.setVisible(False)
        self.retranslate()

    def show_numbers(self, numbers: tuple[Number, ...]) -> None:
        """Show the main ones, and the rest if it is wanted or there are few."""
        self._numbers = numbers
        ordered = sorted(numbers, key=lambda item: (not item.main, item.limit is None))
        shown = ordered if self.all_button.isChecked() else ordered[: self._few(ordered)]
        self._make_rows(len(shown))
        for row, item in zip(self.rows, shown, strict=False):
            row.show_number(item)
        for place, row in enumerate(self.rows):
            row.setVisible(place < len(shown))
        self.all_button.setVisible(len(ordered) > self._few(ordered))
        words = self.tr("Fewer numbers") if self.all_button.isChecked() else self.tr("All {count} numbers")
        self.all_button.setText(words.format(count=len(ordered)))
        self.all_button.setAccessibleName(self.all_button.text())
        self.setVisible(bool(numbers))

    def retranslate(self) -> None:
        """Write again in the present language."""
        self.setAccessibleName(self.tr("Numbers of the result"))
        self.show_numbers(self._numbers)

    def _make_rows(self, count: int) -> None:
        while len(self.rows) < count:
            self.rows.append(NumberRow(self))
            self._layout.insertWidget(len(self.rows) - 1, self.rows[-1])

    @staticmethod
    def _few(ordered: list[Number]) -> int:
        """How many are shown first: the main ones, and up to `FEW` in all."""
        return max(sum(item.main for item in ordered), FEW)

    def text(self) -> str:
        """All numbers as text."""
        return "\n".join(row.text() for row in self.rows if not row.isHidden())
