"""A table of things that can be ticked, without the samples' other actions: the faces of a model."""

from __future__ import annotations

from PySide6.QtCore import Signal
from PySide6.QtWidgets import QAbstractItemView, QVBoxLayout, QWidget

from beltgui.app.theme import px, theme
from beltgui.viewmodel.step import Column, SampleRow
from beltgui.widgets.samples_model import SamplesModel
from beltgui.widgets.samples_table import BarDelegate, TicksView


class TicksTable(QWidget):
    """Rows with a tick box each.

    Signals:
        include_wanted: (row's id, on).
    """

    include_wanted = Signal(int, bool)

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.model = SamplesModel(self)
        self.model.include_wanted.connect(self.include_wanted)
        self._columns: tuple[Column, ...] = ()
        self.view = TicksView(self)
        self.view.setModel(self.model)
        self.view.setItemDelegate(BarDelegate(self.view))
        self.view.setSelectionBehavior(QAbstractItemView.SelectionBehavior.SelectRows)
        self.view.setSelectionMode(QAbstractItemView.SelectionMode.SingleSelection)
        self.view.setTabKeyNavigation(False)
        self.view.setShowGrid(False)
        self.view.verticalHeader().setVisible(False)
        self.view.horizontalHeader().setStretchLastSection(True)
        self.view.tick_pressed.connect(self._toggle)
        layout = QVBoxLayout(self)
        layout.setContentsMargins(0, 0, 0, 0)
        layout.addWidget(self.view)
        theme().changed.connect(self._fit)

    def show_rows(self, columns: tuple[Column, ...], rows: tuple[SampleRow, ...]) -> None:
        """Show these."""
        self.model.show(columns, rows)
        self.view.setAccessibleName(self.accessibleName())
        if columns != self._columns:
            self._columns = columns
            self._fit()

    def set_editable(self, editable: bool) -> None:
        """Whether ticks can be changed."""
        self.model.set_editable(editable)

    def _fit(self) -> None:
        self.view.verticalHeader().setDefaultSectionSize(self.fontMetrics().height() + px(9))
        self.view.resizeColumnsToContents()

    def _toggle(self) -> None:
        rows = self.view.selectionModel().selectedRows()
        if rows and self.model.editable:
            row = self.model.sample(rows[0].row())
            if row.can_exclude:
                self.include_wanted.emit(row.id, not row.included)
