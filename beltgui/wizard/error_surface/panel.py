"""Error surface: whose it is, how it is shown, rejected points, robot programs.

Object names: choice_<key> for each setting (choice_grinder, choice_show_path, choice_show_exaggeration,
choice_show_section), export_button, export_lock, table_<key> (table_rejected, table_programs).
"""

from __future__ import annotations

from PySide6.QtWidgets import QLabel, QPushButton, QVBoxLayout, QWidget

from beltgui.app.language import sentence
from beltgui.viewmodel.step import Action
from beltgui.widgets.plain_table import PlainTable
from beltgui.wizard.error_surface.choices import ChoiceRow
from beltgui.wizard.panel import StepPanel

# Keys of the tables that the step has.
TABLES = ("rejected", "programs")


class ErrorSurfacePanel(StepPanel):
    """Settings, and the way to the robot programs, which is closed while anything is stale or not accepted."""

    def __init__(self, step: str, parent: QWidget | None = None) -> None:
        super().__init__(step, parent)
        self._lock: tuple[str, ...] = ()
        self._rows: dict[str, ChoiceRow] = {}
        self._plain = {key: PlainTable() for key in TABLES}
        for key, table in self._plain.items():
            table.setObjectName(f"table_{key}")
        self.tables = tuple(self._plain.values())
        self.export_button = QPushButton(self)
        self.export_button.setObjectName("export_button")
        self.export_button.clicked.connect(self.export_wanted)
        self.lock_label = QLabel(self)
        self.lock_label.setObjectName("export_lock")
        self.lock_label.setProperty("tone", "warn")
        self.lock_label.setWordWrap(True)
        self._choices = QVBoxLayout()
        self._choices.setSpacing(4)
        layout = QVBoxLayout(self)
        layout.setContentsMargins(0, 0, 0, 0)
        layout.setSpacing(4)
        layout.addLayout(self._choices)
        layout.addWidget(self.export_button)
        layout.addWidget(self.lock_label)

    def set_export_lock(self, why: tuple[str, ...]) -> None:
        """Why export is locked; empty frees it."""
        self._lock = why
        self.refresh()

    def refresh(self) -> None:
        """Write all again."""
        for choice in self.extra.get("choices", ()):
            row = self._rows.get(choice["key"])
            if row is None:
                row = self._rows[choice["key"]] = ChoiceRow(choice, self)
                row.chosen.connect(self.choose)
                self._choices.addWidget(row)
            row.show_choice(choice)
        for row in self._rows.values():
            row.setEnabled(self.editable)
            row.setVisible(bool(self.extra))
        titles = {"rejected": self.tr("Rejected points"), "programs": self.tr("Robot programs")}
        shown = {table["key"]: table for table in self.extra.get("tables", ())}
        for key, table in self._plain.items():
            found = shown.get(key)
            table.show_rows(titles[key], found["columns"] if found else (), found["rows"] if found else ())
        self._write_export()

    def _write_export(self) -> None:
        may = self.view is not None and Action.EXPORT in self.view.actions
        self.export_button.setText(self.tr("Write robot programs …"))
        self.export_button.setAccessibleName(self.export_button.text())
        self.export_button.setEnabled(may and self.editable and not self._lock)
        reasons = "\n".join(f"■ {sentence(text)}" for text in self._lock)
        self.lock_label.setText(self.tr("Export is locked:") + "\n" + reasons)
        self.lock_label.setVisible(bool(self._lock))
