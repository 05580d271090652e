"""A line under the top bar that says something that matters, with a button for what can be done about it."""

from __future__ import annotations

from collections.abc import Callable

from PySide6.QtCore import Qt
from PySide6.QtWidgets import QFrame, QHBoxLayout, QLabel, QPushButton, QWidget

from beltgui.app.dialogs import FaultDialog

SHAPES = {"good": "✔", "bad": "✖", "warn": "◆", "info": "●"}


class Notice(QFrame):
    """Hidden until it has something to say. Tone is `good`, `bad`, `warn` or `info`."""

    def __init__(self, name: str, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.setObjectName(name)
        self._label = QLabel(self)
        self._label.setObjectName(f"{name}_text")
        self._label.setWordWrap(True)
        self._label.setTextFormat(Qt.TextFormat.PlainText)
        self._label.setTextInteractionFlags(Qt.TextInteractionFlag.TextSelectableByMouse)
        self.button = QPushButton(self)
        self.button.setObjectName(f"{name}_button")
        self.button.clicked.connect(self._press)
        self.close_button = QPushButton("✕", self)
        self.close_button.setObjectName(f"{name}_close")
        self.close_button.setProperty("quiet", True)
        self.close_button.clicked.connect(self.hide)
        self.details_button = QPushButton(self)
        self.details_button.setObjectName(f"{name}_details")
        self.details_button.clicked.connect(self._show_details)
        self._action: Callable[[], None] | None = None
        self._details = ""
        layout = QHBoxLayout(self)
        layout.setContentsMargins(8, 2, 2, 2)
        layout.addWidget(self._label, 1)
        layout.addWidget(self.details_button)
        layout.addWidget(self.button)
        layout.addWidget(self.close_button)
        self.hide()

    def say(
        self,
        tone: str,
        text: str,
        button: str = "",
        action: Callable[[], None] | None = None,
        *,
        details: str = "",
        stays: bool = False,
    ) -> None:
        """Show a text; `details` can be read in a window beside; one that `stays` has no close button."""
        self.setProperty("banner", tone)
        self.style().unpolish(self)
        self.style().polish(self)
        self._label.setText(f"{SHAPES[tone]}  {text}")
        self._label.setAccessibleName(text)
        self._action, self._details = action, details
        self.details_button.setText(self.tr("Detai&ls…"))
        self.details_button.setVisible(bool(details))
        self.button.setText(button)
        self.button.setVisible(bool(button))
        self.close_button.setVisible(not stays)
        self.close_button.setAccessibleName(self.tr("Close this message"))
        self.show()

    def text(self) -> str:
        """What it says; empty while hidden."""
        return "" if self.isHidden() else self._label.text()

    def _show_details(self) -> None:
        FaultDialog(self._details, self).show()

    def _press(self) -> None:
        if self._action is not None:
            self._action()
