"""The table of samples as a Qt model: in place updates, sorting, tick boxes; thousands of rows stay fast."""

from __future__ import annotations

import math
from typing import Any

from PySide6.QtCore import (
    QAbstractTableModel,
    QCoreApplication,
    QModelIndex,
    QObject,
    QPersistentModelIndex,
    Qt,
    Signal,
)
from PySide6.QtGui import QColor

from beltgui.app.language import sentence
from beltgui.app.theme import colour
from beltgui.viewmodel.scene import Role
from beltgui.viewmodel.step import Column, SampleRow, Use
from beltgui.widgets.figures import DASH, number
from beltgui.widgets.words import flag_word, use_word

Index = QModelIndex | QPersistentModelIndex
SHARE_ROLE = Qt.ItemDataRole.UserRole + 1
_RESIDUALS = ("residual", "distance", "deviation", "error", "leave", "held")
_ROOT = QModelIndex()


class SamplesModel(QAbstractTableModel):
    """Rows are samples; columns are name with tick box, the step's own columns, use and flag.

    Signals:
        include_wanted: (sample id, on) a tick box was clicked. The model changes when the engine says so.
    """

    include_wanted = Signal(int, bool)

    def __init__(self, parent: QObject | None = None) -> None:
        super().__init__(parent)
        self._columns: tuple[Column, ...] = ()
        self._all: tuple[SampleRow, ...] = ()
        self._rows: list[SampleRow] = []
        self._place: dict[int, int] = {}
        self._largest: dict[int, float] = {}
        self._sorted: tuple[int, Qt.SortOrder] | None = None
        self._only_flagged = False
        self._editable = True

    def show(self, columns: tuple[Column, ...], rows: tuple[SampleRow, ...]) -> None:
        """Show these; rows that stay the same ones are updated in place, so that the selection stays."""
        self._all = rows
        if columns != self._columns:
            self.beginResetModel()
            self._columns = columns
            self._sorted = None
            self._take(self._arranged())
            self.endResetModel()
            return
        self._arrange()

    def show_only_flagged(self, only: bool) -> None:
        """Only what stands out or is left out, or all."""
        self._only_flagged = only
        self._arrange()

    def set_editable(self, editable: bool) -> None:
        """Whether tick boxes can be clicked."""
        self._editable = editable
        if self._rows:
            self.dataChanged.emit(self.index(0, 0), self.index(len(self._rows) - 1, 0))

    @property
    def editable(self) -> bool:
        """Whether tick boxes can be clicked."""
        return self._editable

    def refresh(self) -> None:
        """Words or colours have changed."""
        self.headerDataChanged.emit(Qt.Orientation.Horizontal, 0, self.columnCount() - 1)
        if self._rows:
            self.dataChanged.emit(self.index(0, 0), self.index(len(self._rows) - 1, self.columnCount() - 1))

    def row_of(self, sample_id: int) -> int:
        """Where a sample is; -1 if it is not shown."""
        return self._place.get(sample_id, -1)

    def sample(self, row: int) -> SampleRow:
        """The sample in a row."""
        return self._rows[row]

    def is_residual(self, column: int) -> bool:
        """Whether a column is drawn with a bar."""
        return column in self._largest

    def rowCount(self, parent: Index = _ROOT) -> int:  # noqa: N802
        """Samples shown."""
        return 0 if parent.isValid() else len(self._rows)

    def columnCount(self, parent: Index = _ROOT) -> int:  # noqa: N802
        """Name, own columns, use, flag."""
        return 0 if parent.isValid() else len(self._columns) + 3

    def headerData(self, section: int, orientation: Qt.Orientation, role: int = 0) -> Any:  # noqa: N802
        """Titles with unit."""
        if role != Qt.ItemDataRole.DisplayRole or orientation != Qt.Orientation.Horizontal:
            return None
        own = section - 1
        if own < 0:
            return QCoreApplication.translate("SamplesModel", "Sample")
        if own < len(self._columns):
            column = self._columns[own]
            return f"{sentence(column.title)}\n{column.unit}" if column.unit else sentence(column.title)
        if own == len(self._columns):
            return QCoreApplication.translate("SamplesModel", "Use")
        return QCoreApplication.translate("SamplesModel", "Remark")

    def data(self, index: Index, role: int = 0) -> Any:
        """Text, tick, colour, tool tip and (`SHARE_ROLE`) the length of the bar of a cell, -1 to 1."""
        row = self._rows[index.row()]
        section = index.column()
        if role == Qt.ItemDataRole.DisplayRole:
            return self._text(row, section)
        if role == Qt.ItemDataRole.CheckStateRole and section == 0:
            return Qt.CheckState.Checked if row.included else Qt.CheckState.Unchecked
        if role == Qt.ItemDataRole.ForegroundRole:
            return self._ink(row, section)
        if role == SHARE_ROLE:
            return self._share(row, section)
        if role == Qt.ItemDataRole.TextAlignmentRole and 0 < section <= len(self._columns):
            if self._columns[section - 1].decimals is not None:
                return int(Qt.AlignmentFlag.AlignRight | Qt.AlignmentFlag.AlignVCenter)
        if role == Qt.ItemDataRole.ToolTipRole:
            return sentence(row.note) if row.note else None
        return None

    def setData(self, index: Index, value: Any, role: int = 0) -> bool:  # noqa: N802
        """A click on a tick box: ask for it."""
        if role != Qt.ItemDataRole.CheckStateRole or index.column() != 0:
            return False
        row = self._rows[index.row()]
        if not (self._editable and row.can_exclude):
            return False
        self.include_wanted.emit(row.id, Qt.CheckState(value) == Qt.CheckState.Checked)
        return True

    def flags(self, index: Index) -> Qt.ItemFlag:
        """Names have a tick box."""
        flags = Qt.ItemFlag.ItemIsEnabled | Qt.ItemFlag.ItemIsSelectable
        if index.column() == 0 and self._editable and self._rows[index.row()].can_exclude:
            flags |= Qt.ItemFlag.ItemIsUserCheckable
        return flags

    def sort(self, column: int, order: Qt.SortOrder = Qt.SortOrder.AscendingOrder) -> None:
        """Sort by a column; -1 is the order of time. What is not known comes last."""
        self._sorted = None if column < 0 else (column, order)
        self._arrange()

    def _text(self, row: SampleRow, section: int) -> str:
        own = section - 1
        if own < 0:
            return f"▲ {sentence(row.name)}" if row.flag else sentence(row.name)
        if own < len(self._columns):
            value = row.cells[own] if own < len(row.cells) else None
            if isinstance(value, str):
                return sentence(value)
            decimals = self._columns[own].decimals
            return number(value, 0 if decimals is None else decimals)
        if own == len(self._columns):
            return use_word(row.use) if row.included else use_word(Use.EXCLUDED)
        return flag_word(row.flag)

    def _ink(self, row: SampleRow, section: int) -> QColor | None:
        if row.flag and section in (0, len(self._columns) + 2):
            return QColor(colour(Role.ATTENTION))
        if not row.included:
            return QColor(colour("muted"))
        return None

    def _share(self, row: SampleRow, section: int) -> float | None:
        largest = self._largest.get(section, 0.0)
        value = _numeric(row, section - 1)
        if not largest or value is None:
            return None
        return max(-1.0, min(1.0, value / largest))

    def _arranged(self) -> list[SampleRow]:
        rows = list(self._all)
        if self._only_flagged:
            rows = [row for row in rows if row.flag or not row.included]
        if self._sorted is not None:
            section, order = self._sorted
            known = [row for row in rows if self._text(row, section) != DASH]
            unknown = [row for row in rows if self._text(row, section) == DASH]
            known.sort(key=lambda row: self._sort_key(row, section), reverse=order == Qt.SortOrder.DescendingOrder)
            rows = known + unknown
        return rows

    def _sort_key(self, row: SampleRow, section: int) -> tuple[int, float, str]:
        if section == 0:
            return 0, 0.0, f"{not row.included}{row.id:09d}"
        value = _numeric(row, section - 1)
        if value is not None and section <= len(self._columns):
            return 0, value, ""
        return 1, 0.0, self._text(row, section)

    def _arrange(self) -> None:
        rows = self._arranged()
        old_ids = [row.id for row in self._rows]
        new_ids = [row.id for row in rows]
        if new_ids == old_ids:
            changed = [place for place, row in enumerate(rows) if row != self._rows[place]]
            bars = dict(self._largest)
            self._take(rows)
            if bars != self._largest and rows:
                self.dataChanged.emit(self.index(0, 0), self.index(len(rows) - 1, self.columnCount() - 1))
            elif changed:
                self.dataChanged.emit(self.index(changed[0], 0), self.index(changed[-1], self.columnCount() - 1))
        elif new_ids[: len(old_ids)] == old_ids:
            self.beginInsertRows(QModelIndex(), len(old_ids), len(new_ids) - 1)
            self._take(rows)
            self.endInsertRows()
            if old_ids:
                self.dataChanged.emit(self.index(0, 0), self.index(len(old_ids) - 1, self.columnCount() - 1))
        elif set(new_ids) == set(old_ids):
            self._rearrange(rows, new_ids)
        elif (gone := _one_gone(old_ids, new_ids)) is not None:
            self.beginRemoveRows(QModelIndex(), gone, gone)
            self._take(rows)
            self.endRemoveRows()
            if rows:
                self.dataChanged.emit(self.index(0, 0), self.index(len(rows) - 1, self.columnCount() - 1))
        else:
            self.beginResetModel()
            self._take(rows)
            self.endResetModel()

    def _rearrange(self, rows: list[SampleRow], new_ids: list[int]) -> None:
        self.layoutAboutToBeChanged.emit()
        before = self.persistentIndexList()
        ids = [self._rows[index.row()].id for index in before]
        self._take(rows)
        places = {sample_id: place for place, sample_id in enumerate(new_ids)}
        after = [self.index(places[sample_id], index.column()) for sample_id, index in zip(ids, before, strict=True)]
        self.changePersistentIndexList(before, after)
        self.layoutChanged.emit()

    def _take(self, rows: list[SampleRow]) -> None:
        self._rows = rows
        self._place = {row.id: place for place, row in enumerate(rows)}
        self._largest = {}
        for own, column in enumerate(self._columns):
            if column.decimals is None or not any(word in column.key for word in _RESIDUALS):
                continue
            values = [value for row in self._all if row.included and (value := _numeric(row, own)) is not None]
            self._largest[own + 1] = max((abs(value) for value in values), default=0.0)


def _one_gone(old: list[int], new: list[int]) -> int | None:
    """Place of the one id that is no longer there; None if anything else has changed."""
    if len(old) != len(new) + 1:
        return None
    place = next((place for place, (one, other) in enumerate(zip(old, new, strict=False)) if one != other), len(new))
    return place if old[:place] + old[place + 1 :] == new else None


def _numeric(row: SampleRow, own: int) -> float | None:
    """A finite number of a cell, else None."""
    if not 0 <= own < len(row.cells):
        return None
    value = row.cells[own]
    if value is None or isinstance(value, str) or not math.isfinite(value):
        return None
    return float(value)
