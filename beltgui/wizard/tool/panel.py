"""Stylus and tool: how many touches of each kind there are; the suggested touch can be added to the plan.

Object names: tool_kinds, take_suggested.
"""

from __future__ import annotations

from collections import Counter
from typing import Any

from PySide6.QtWidgets import QLabel, QWidget

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
        counts = self._counts()
        words = self.tr("Touches: {cone} in the cone, {shaft} on wheel shafts; {stop} readings at the heads' stops.")
        self.kinds.setText(words.format(cone=counts["cone"], shaft=counts["shaft"], stop=counts["stop"]))
        self.kinds.setVisible(bool(counts))

    def added(self, suggested: Any) -> tuple[str, Any]:
        """A touch of a shaft is a head angle of its grinder, one of the cone is a pose."""
        if "grinder" not in suggested:
            return "extra_cone", [*self.extra.get("extra_cone", ()), suggested]
        shafts = {name: list(angles) for name, angles in self.extra.get("extra_shafts", {}).items()}
        shafts.setdefault(suggested["grinder"], []).append(suggested["angle_deg"])
        return "extra_shafts", shafts

    def _counts(self) -> Counter[str]:
        content = self.view.content if self.view is not None else None
        keys = [column.key for column in content.columns] if content is not None else []
        if content is None or "kind" not in keys:
            return Counter()
        return Counter(str(row.cells[keys.index("kind")]) for row in content.rows)
