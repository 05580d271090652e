"""Stylus and tool: how far the touches are, part by part; a suggested touch can be taken in addition."""

from __future__ import annotations

from PySide6.QtWidgets import QLabel, QVBoxLayout, QWidget

from beltgui.app.language import sentence
from beltgui.wizard.panel import StepPanel


class ToolPanel(StepPanel):
    """One line for each part; `extra["parts"]` holds (name, touches taken, touches planned)."""

    def __init__(self, step: str, parent: QWidget | None = None) -> None:
        super().__init__(step, parent)
        self.parts = QLabel(self)
        self.parts.setObjectName("tool_parts")
        self.parts.setWordWrap(True)
        layout = QVBoxLayout(self)
        layout.setContentsMargins(0, 0, 0, 0)
        layout.addWidget(self.parts)

    def refresh(self) -> None:
        """Write all again."""
        lines = [
            self.tr("{sign} {part}: {taken} of {planned} touches").format(
                sign="✔" if taken >= planned else "▶" if taken else "○",
                part=sentence(name),
                taken=taken,
                planned=planned,
            )
            for name, taken, planned in self.extra.get("parts", ())
        ]
        self.parts.setText("\n".join(lines))
        self.parts.setVisible(bool(lines))
        self.parts.setAccessibleName("; ".join(lines))
