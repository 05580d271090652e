"""The samples: what each says, a tick box to leave it out, delete one, undo and redo."""

from __future__ import annotations

from PySide6.QtCore import QModelIndex, QPersistentModelIndex, QPoint, QRectF, Qt, Signal
from PySide6.QtGui import QAction, QColor, QKeyEvent, QKeySequence, QPainter, QShortcut
from PySide6.QtWidgets import (
    QAbstractItemView,
    QCheckBox,
    QHBoxLayout,
    QHeaderView,
    QMenu,
    QStyledItemDelegate,
    QStyleOptionViewItem,
    QTableView,
    QToolButton,
    QVBoxLayout,
    QWidget,
)

from beltgui.app.theme import colour, px, theme
from beltgui.viewmodel.scene import Role
from beltgui.viewmodel.step import Column, SampleRow
from beltgui.widgets.samples_model import SHARE_ROLE, SamplesModel

WIDEST_PX = 220
# The application's tick box is wider than the style's, which a column's own wish counts with.
TICK_PX = 10


class BarDelegate(QStyledItemDelegate):
    """Draws a bar along the lower edge of a residual's cell, as long as the residual is large."""

    def paint(
        self, painter: QPainter, option: QStyleOptionViewItem, index: QModelIndex | QPersistentModelIndex
    ) -> None:
        """The cell, then its bar."""
        super().paint(painter, option, index)
        share = index.data(SHARE_ROLE)
        if share is None:
            return
        cell = QRectF(option.rect).adjusted(4, 0, -4, 0)  # type: ignore[attr-defined]
        height = px(4)
        bar = QRectF(cell.left(), cell.bottom() - height - 1, abs(share) * cell.width(), height)
        painter.fillRect(bar, QColor(colour(Role.INLIER)))


class TicksView(QTableView):
    """A table whose Space key ticks and whose Delete key deletes the chosen sample, whatever column is current."""

    tick_pressed = Signal()
    delete_pressed = Signal()

    def keyPressEvent(self, event: QKeyEvent) -> None:  # noqa: N802  (Qt's name)
        """Space, Delete, and the table's own keys."""
        if event.key() == Qt.Key.Key_Space:
            self.tick_pressed.emit()
        elif event.key() in (Qt.Key.Key_Delete, Qt.Key.Key_Backspace):
            self.delete_pressed.emit()
        else:
            super().keyPressEvent(event)


class SamplesTable(QWidget):
    """The table with its buttons.

    Signals:
        include_wanted: (sample id, on).
        delete_wanted: (sample id).
        undo_wanted: Take back the last edit.
        redo_wanted: Do it again.
        chosen: Sample id of the chosen row; None for none.
    """

    include_wanted = Signal(int, bool)
    delete_wanted = Signal(int)
    undo_wanted = Signal()
    redo_wanted = Signal()
    chosen = Signal(object)

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.model = SamplesModel(self)
        self.model.include_wanted.connect(self.include_wanted)
        self._editable = True
        self._undo, self._redo = False, False
        self._fitted: tuple[Column, ...] = ()
        self._sorted: tuple[int, Qt.SortOrder] | None = None
        self._build()
        self.retranslate()
        self._set_buttons()
        theme().changed.connect(self._rethemed)

    def show_samples(
        self, columns: tuple[Column, ...], rows: tuple[SampleRow, ...], *, undo: bool = False, redo: bool = False
    ) -> None:
        """Show these rows and whether there is something to take back."""
        self._undo, self._redo = undo, redo
        had = self.chosen_id()
        grows = len(rows) > self.model.rowCount() > 0
        self.model.show(columns, rows)
        if self._fitted != columns and rows:
            self._fitted = columns
            self._sorted = None
            self.view.horizontalHeader().setSortIndicatorShown(False)
            self._fit_columns()
        self._widen_columns()
        if had is not None and self.chosen_id() != had:
            self.choose(had)
        if grows and had is None and not self.flagged_only.isChecked():
            self.view.scrollToBottom()
        self._set_buttons()

    def choose(self, sample_id: int | None) -> None:
        """Choose a sample's row; None or one that is not there chooses none."""
        row = -1 if sample_id is None else self.model.row_of(sample_id)
        if row < 0:
            self.view.clearSelection()
            self.view.setCurrentIndex(QModelIndex())
            return
        if row != self.view.currentIndex().row() or not self.view.selectionModel().hasSelection():
            self.view.selectRow(row)
        self.view.scrollTo(self.model.index(row, 0))

    def chosen_id(self) -> int | None:
        """Id of the chosen sample; None for none."""
        rows = self.view.selectionModel().selectedRows()
        return self.model.sample(rows[0].row()).id if rows else None

    def set_editable(self, editable: bool) -> None:
        """Whether samples may be left out and deleted now."""
        self._editable = editable
        self.model.set_editable(editable)
        self._set_buttons()

    def retranslate(self) -> None:
        """Write again in the present language."""
        self.view.setAccessibleName(self.tr("Table of samples"))
        self.undo_button.setText(self.tr("↶ &Undo"))
        self.undo_button.setToolTip(self.tr("Take back the last edit of this step (Ctrl+Z)"))
        self.undo_button.setAccessibleName(self.tr("Undo"))
        self.redo_button.setText(self.tr("↷ &Redo"))
        self.redo_button.setToolTip(self.tr("Do again what was taken back (Ctrl+Shift+Z)"))
        self.redo_button.setAccessibleName(self.tr("Redo"))
        self.delete_button.setText(self.tr("&Delete"))
        self.delete_button.setToolTip(self.tr("Delete the chosen sample (Del); undo brings it back"))
        self.delete_button.setAccessibleName(self.tr("Delete the chosen sample"))
        self.flagged_only.setText(self.tr("Only flagged"))
        self.flagged_only.setToolTip(self.tr("Show only samples that are left out or have a remark"))
        self.flagged_only.setAccessibleName(self.flagged_only.text())
        self.model.refresh()
        self._fit_columns()

    def _build(self) -> None:
        self.view = TicksView(self)
        self.view.setObjectName("samples_table")
        self.view.setModel(self.model)
        self.view.setItemDelegate(BarDelegate(self.view))
        self.view.setSelectionBehavior(QAbstractItemView.SelectionBehavior.SelectRows)
        self.view.setSelectionMode(QAbstractItemView.SelectionMode.SingleSelection)
        self.view.setEditTriggers(QAbstractItemView.EditTrigger.NoEditTriggers)
        self.view.setVerticalScrollMode(QAbstractItemView.ScrollMode.ScrollPerItem)
        self.view.setHorizontalScrollMode(QAbstractItemView.ScrollMode.ScrollPerPixel)
        self.view.setTabKeyNavigation(False)
        self.view.setWordWrap(False)
        self.view.setShowGrid(False)
        self.view.setContextMenuPolicy(Qt.ContextMenuPolicy.CustomContextMenu)
        self.view.customContextMenuRequested.connect(self._show_menu)
        self.view.tick_pressed.connect(self._toggle)
        self.view.delete_pressed.connect(self._delete)
        self.view.selectionModel().selectionChanged.connect(self._selected)
        rows = self.view.verticalHeader()
        rows.setVisible(False)
        rows.setSectionResizeMode(QHeaderView.ResizeMode.Fixed)
        columns = self.view.horizontalHeader()
        columns.setSectionsClickable(True)
        columns.setResizeContentsPrecision(40)
        columns.setStretchLastSection(True)
        columns.setHighlightSections(False)
        columns.sectionClicked.connect(self._sort)
        columns.setDefaultAlignment(Qt.AlignmentFlag.AlignCenter)
        columns.setMinimumSectionSize(px(36))
        self.undo_button, self.redo_button, self.delete_button = (QToolButton(self) for _ in range(3))
        for name, button in (
            ("undo_button", self.undo_button), ("redo_button", self.redo_button),
            ("delete_button", self.delete_button),
        ):  # fmt: skip
            button.setObjectName(name)
        self.undo_button.clicked.connect(self.undo_wanted)
        self.redo_button.clicked.connect(self.redo_wanted)
        self.delete_button.clicked.connect(self._delete)
        # Not the buttons' own shortcuts: those become Alt and the underlined letter with every text that is set.
        for keys, button in (("Ctrl+Z", self.undo_button), ("Ctrl+Shift+Z", self.redo_button)):
            QShortcut(QKeySequence(keys), self).activated.connect(button.click)
        self.flagged_only = QCheckBox(self)
        self.flagged_only.setObjectName("samples_flagged")
        self.flagged_only.toggled.connect(self.model.show_only_flagged)
        buttons = QHBoxLayout()
        buttons.setContentsMargins(0, 0, 6, 0)
        buttons.setSpacing(4)
        for widget in (self.undo_button, self.redo_button, self.delete_button):
            buttons.addWidget(widget)
        buttons.addStretch(1)
        buttons.addWidget(self.flagged_only)
        layout = QVBoxLayout(self)
        layout.setContentsMargins(0, 0, 0, 0)
        layout.setSpacing(4)
        layout.addWidget(self.view, 1)
        layout.addLayout(buttons)
        self._rethemed()

    def _rethemed(self) -> None:
        self.view.verticalHeader().setDefaultSectionSize(self.fontMetrics().height() + px(9))
        self.model.refresh()
        self._fit_columns()

    def _fit_columns(self) -> None:
        self.view.resizeColumnsToContents()
        for column in range(self.model.columnCount()):
            wanted = self.view.columnWidth(column) + (px(TICK_PX) if column == 0 else 0)
            self.view.setColumnWidth(column, min(wanted, px(WIDEST_PX)))

    def _widen_columns(self) -> None:
        """A longer text has come; columns never become narrower by themselves."""
        for column in range(self.model.columnCount() - 1):
            wanted = self.view.sizeHintForColumn(column) + (px(TICK_PX) if column == 0 else 2)
            wanted = min(wanted, px(WIDEST_PX))
            if wanted > self.view.columnWidth(column):
                self.view.setColumnWidth(column, wanted)

    def _set_buttons(self) -> None:
        self.undo_button.setEnabled(self._undo and self._editable)
        self.redo_button.setEnabled(self._redo and self._editable)
        self.delete_button.setEnabled(self._editable and self.chosen_id() is not None)

    def _sort(self, column: int) -> None:
        """Largest last, then largest first, then the order of time again."""
        up, down = Qt.SortOrder.AscendingOrder, Qt.SortOrder.DescendingOrder
        self._sorted = {(column, up): (column, down), (column, down): None}.get(self._sorted, (column, up))
        head = self.view.horizontalHeader()
        head.setSortIndicatorShown(self._sorted is not None)
        if self._sorted is not None:
            head.setSortIndicator(*self._sorted)
        self.model.sort(*(self._sorted or (-1, up)))

    def _selected(self) -> None:
        self._set_buttons()
        self.chosen.emit(self.chosen_id())

    def _toggle(self) -> None:
        sample_id = self.chosen_id()
        if sample_id is None or not self._editable:
            return
        row = self.model.sample(self.model.row_of(sample_id))
        if row.can_exclude:
            self.include_wanted.emit(sample_id, not row.included)

    def _delete(self) -> None:
        sample_id = self.chosen_id()
        if self._editable and sample_id is not None:
            self.delete_wanted.emit(sample_id)

    def _show_menu(self, at: QPoint) -> None:
        index = self.view.indexAt(at)
        if not index.isValid():
            return
        self.view.selectRow(index.row())
        menu = self.menu()
        menu.setAttribute(Qt.WidgetAttribute.WA_DeleteOnClose)
        menu.popup(self.view.viewport().mapToGlobal(at))

    def menu(self) -> QMenu:
        """The menu of the chosen sample; there must be one."""
        row = self.model.sample(self.view.currentIndex().row())
        menu = QMenu(self)
        tick = QAction(self.tr("Leave out of the fit") if row.included else self.tr("Take into the fit"), menu)
        tick.setEnabled(self._editable and row.can_exclude)
        tick.triggered.connect(self._toggle)
        delete = QAction(self.tr("Delete"), menu)
        delete.setEnabled(self._editable)
        delete.triggered.connect(self._delete)
        menu.addActions([tick, delete])
        return menu
