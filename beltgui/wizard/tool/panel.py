"""Stylus and tool: how far the touches of each kind are; the suggested touch can be added to the plan.

Object names: tool_kinds, take_suggested.
"""

from __future__ import annotations

from typing import Any

from PySide6.QtWidgets import QLabel, QWidget

from beltgui.app.language import sentence
from beltgui.wizard.suggested import SuggestedPanel


class ToolPanel(SuggestedPanel):
    """Own controls of the tool step."""

    def __init__(self, step: str, parent: QWidget | None = None) -> None:
        super().__init__(step, parent)
        self.kinds = QLabel(self)
        self.kinds.setObjectName("tool_kinds")
        self.kinds.setWordWrap(True)
        self.column.insertWidget(0, self.kinds)

    def refresh(self) -> None:
        """Write all again."""
        super().refresh()
        lines = [self._line(part) for part in self.extra.get("parts", ())]
        self.kinds.setText("\n".join(lines))
        self.kinds.setAccessibleName("; ".join(lines))
        self.kinds.setVisible(bool(lines))

    def added(self, suggested: Any) -> tuple[str, Any]:
        """A touch of a shaft is a head angle of its grinder, one of the cone is a pose."""
        if "grinder" not in suggested:
            return "extra_cone", [*self.extra.get("extra_cone", ()), suggested]
        shafts = {name: list(angles) for name, angles in self.extra.get("extra_shafts", {}).items()}
        shafts.setdefault(suggested["grinder"], []).append(suggested["angle_deg"])
        return "extra_shafts", shafts

    def _line(self, part: dict[str, Any]) -> str:
        """How far one part is, e.g. `✔ Grinder fine: 6 of 6 touches`."""
        read = part.get("rest", True)
        whole = part["done"] >= part["planned"] and read
        words = self.tr("Grinder {grinder}: {done} of {planned} touches") if part["grinder"] else (
            self.tr("Cone: {done} of {planned} touches")
        )  # fmt: skip
        told = words.format(grinder=sentence(part["grinder"]), done=part["done"], planned=part["planned"])
        if not read:
            told += self.tr(", head's stop not read yet")
        return f"{'✔' if whole else '○'} {told}"
