"""Checks on data that the fit has not seen."""

from __future__ import annotations

from PySide6.QtWidgets import QLabel, QVBoxLayout, QWidget

from beltgui.app.language import sentence
from beltgui.viewmodel.step import Check
from beltgui.widgets.figures import plain_number


class ChecksList(QWidget):
    """One line for each check: shape, what, value and limit with unit, how many data."""

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.setObjectName("checks")
        self._checks: tuple[Check, ...] = ()
        self.lines: list[QLabel] = []
        self._title = QLabel(self)
        self._title.setProperty("title", "2")
        self._layout = QVBoxLayout(self)
        self._layout.setContentsMargins(0, 0, 0, 0)
        self._layout.setSpacing(2)
        self._layout.addWidget(self._title)
        self.retranslate()

    def show_checks(self, checks: tuple[Check, ...]) -> None:
        """Show these."""
        self._checks = checks
        while len(self.lines) < len(checks):
            line = QLabel(self)
            line.setWordWrap(True)
            self.lines.append(line)
            self._layout.addWidget(line)
        for place, line in enumerate(self.lines):
            line.setVisible(place < len(checks))
            if place < len(checks):
                self._write(line, checks[place])
        self.setVisible(bool(checks))

    def retranslate(self) -> None:
        """Write again in the present language."""
        self._title.setText(self.tr("Check on held-out data"))
        self.setAccessibleName(self._title.text())
        self.show_checks(self._checks)

    def text(self) -> str:
        """All checks as text."""
        return "\n".join(line.text() for line in self.lines[: len(self._checks)])

    def _write(self, line: QLabel, check: Check) -> None:
        sign = {True: "✔", False: "✖", None: "○"}[check.ok]
        unit = f" {check.unit}" if check.unit else ""
        text = f"{sign} {sentence(check.what)}: {plain_number(check.value)}{unit}"
        if check.limit is not None:
            text += self.tr(", limit {limit}{unit}").format(limit=plain_number(check.limit), unit=unit)
        if check.ok is None:
            text += self.tr(" — not known yet")
        elif check.count:
            text += self.tr(" (n = {count})").format(count=check.count)
        tone = {True: "good", False: "bad", None: "muted"}[check.ok]
        if line.property("tone") != tone:
            line.setProperty("tone", tone)
            line.style().polish(line)
        line.setText(text)
        line.setAccessibleName(text)
