"""A panel that takes the suggested sample into the plan."""

from __future__ import annotations

from typing import Any

from PySide6.QtWidgets import QPushButton, QVBoxLayout, QWidget

from beltgui.wizard.panel import StepPanel


class SuggestedPanel(StepPanel):
    """One button, visible while there is something to gain from a sample that is not planned.

    `extra["suggested"]` is the sample as the setting `extra` holds it, `extra["extra"]` what that setting holds now.
    """

    def __init__(self, step: str, parent: QWidget | None = None) -> None:
        super().__init__(step, parent)
        self.take_button = QPushButton(self)
        self.take_button.setObjectName("take_suggested")
        self.take_button.clicked.connect(self._take)
        self.column = QVBoxLayout(self)
        self.column.setContentsMargins(0, 0, 0, 0)
        self.column.addWidget(self.take_button)

    def refresh(self) -> None:
        """Offer the button or not."""
        self.take_button.setVisible("suggested" in self.extra)
        self.take_button.setEnabled(self.editable)
        self.take_button.setText(self.tr("Add the suggested sample to the plan"))
        self.take_button.setAccessibleName(self.take_button.text())
        self.take_button.setToolTip(self.tr("It is then taken with the others that are missing"))

    def added(self, suggested: Any) -> tuple[str, Any]:
        """Setting and its new value with the suggested sample in it."""
        return "extra", [*self.extra.get("extra", ()), suggested]

    def _take(self) -> None:
        self.choose(*self.added(self.extra["suggested"]))
