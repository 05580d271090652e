"""A panel that takes the suggested pose in addition to the planned ones."""

from __future__ import annotations

from PySide6.QtWidgets import QPushButton, QVBoxLayout, QWidget

from beltgui.engine.messages import Acquire
from beltgui.viewmodel.step import Action
from beltgui.wizard.panel import StepPanel


class SuggestedPanel(StepPanel):
    """One button, visible while there is something to gain from a pose that is not planned.

    `extra["suggested"]` is the pose as the setting `extra` holds it, `extra["extra"]` what that setting holds now.
    """

    def __init__(self, step: str, parent: QWidget | None = None) -> None:
        super().__init__(step, parent)
        self.take_button = QPushButton(self)
        self.take_button.setObjectName("take_suggested")
        self.take_button.clicked.connect(self._take)
        layout = QVBoxLayout(self)
        layout.setContentsMargins(0, 0, 0, 0)
        layout.addWidget(self.take_button)

    def refresh(self) -> None:
        """Offer the button or not."""
        may = self.view is not None and (Action.ACQUIRE in self.view.actions or Action.SOLVE in self.view.actions)
        self.take_button.setVisible("suggested" in self.extra)
        self.take_button.setEnabled(self.editable and may)
        self.take_button.setText(self.tr("Take the suggested sample too"))
        self.take_button.setAccessibleName(self.take_button.text())
        self.take_button.setToolTip(self.tr("Adds the suggested pose to this step's plan and goes there"))

    def _take(self) -> None:
        self.choose("extra", [*self.extra.get("extra", ()), self.extra["suggested"]])
        self.command.emit(Acquire(self.step))
