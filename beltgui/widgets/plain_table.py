"""A table that is only read: rejected points, programs that were written."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

from PySide6.QtCore import QAbstractTableModel, QModelIndex, QObject, QPersistentModelIndex, Qt
from PySide6.QtWidgets import QAbstractItemView, QTableView, QWidget

from beltgui.app.language import sentence
from beltgui.app.theme import px, theme
from beltgui.viewmodel.step import Column
from beltgui.widgets.figures import number

Index = QModelIndex | QPersistentModelIndex
Row = Sequence[float | str | None]
_ROOT = QModelIndex()


class PlainModel(QAbstractTableModel):
    """Columns with units, and rows of values."""

    def __init__(self, parent: QObject | None = None) -> None:
        super().__init__(parent)
        self._columns: tuple[Column, ...] = ()
        self._rows: Sequence[Row] = ()

    def show(self, columns: tuple[Column, ...], rows: Sequence[Row]) -> None:
        """Show these."""
        self.beginResetModel()
        self._columns, self._rows = columns, rows
        self.endResetModel()

    def rowCount(self, parent: Index = _ROOT) -> int:  # noqa: N802
        """Rows."""
        return 0 if parent.isValid() else len(self._rows)

    def columnCount(self, parent: Index = _ROOT) -> int:  # noqa: N802
        """Columns."""
        return 0 if parent.isValid() else len(self._columns)

    def headerData(self, section: int, orientation: Qt.Orientation, role: int = 0) -> Any:  # noqa: N802
        """Titles with unit."""
        if role != Qt.ItemDataRole.DisplayRole or orientation != Qt.Orientation.Horizontal:
            return None
        column = self._columns[section]
        return f"{sentence(column.title)}\n{column.unit}" if column.unit else sentence(column.title)

    def data(self, index: Index, role: int = 0) -> Any:
        """Text and alignment."""
        column = self._columns[index.column()]
        if role == Qt.ItemDataRole.DisplayRole:
            value = self._rows[index.row()][index.column()]
            return sentence(value) if isinstance(value, str) else number(value, column.decimals or 0)
        if role == Qt.ItemDataRole.TextAlignmentRole and column.decimals is not None:
            return int(Qt.AlignmentFlag.AlignRight | Qt.AlignmentFlag.AlignVCenter)
        return None


class PlainTable(QTableView):
    """The view of it."""

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.rows = PlainModel(self)
        self.setModel(self.rows)
        self.setSelectionBehavior(QAbstractItemView.SelectionBehavior.SelectRows)
        self.setTabKeyNavigation(False)
        self.setShowGrid(False)
        self.setWordWrap(False)
        self.verticalHeader().setVisible(False)
        self.horizontalHeader().setStretchLastSection(True)
        self.horizontalHeader().setResizeContentsPrecision(40)
        theme().changed.connect(self._fit)

    def show_rows(self, title: str, columns: tuple[Column, ...], rows: Sequence[Row]) -> None:
        """Show these under a title."""
        self.setAccessibleName(title)
        self.rows.show(columns, rows)
        self._fit()

    def _fit(self) -> None:
        self.verticalHeader().setDefaultSectionSize(self.fontMetrics().height() + px(9))
        self.resizeColumnsToContents()
