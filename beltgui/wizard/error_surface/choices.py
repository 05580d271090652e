"""A setting with what may be chosen: a list of words, or a slider over a range with its value and unit beside it."""

from __future__ import annotations

from typing import Any

from PySide6.QtCore import Qt, QTimer, Signal
from PySide6.QtWidgets import QComboBox, QGridLayout, QLabel, QSlider, QWidget

from beltgui.app.language import sentence

STEPS = 200
# A slider that is being moved asks at most this often.
SETTLED_MS = 250


class ChoiceRow(QWidget):
    """One setting; object name `choice_<key>` on the list or the slider.

    Signals:
        chosen: (key, value).
    """

    chosen = Signal(str, object)

    def __init__(self, choice: dict[str, Any], parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self._choice = choice
        self._timer = QTimer(self)
        self._timer.setSingleShot(True)
        self._timer.setInterval(SETTLED_MS)
        self._timer.timeout.connect(self._settled)
        self.label, self.shown = QLabel(self), QLabel(self)
        self.shown.setAlignment(Qt.AlignmentFlag.AlignRight)
        self.list = QComboBox(self)
        self.slider = QSlider(Qt.Orientation.Horizontal, self)
        self.slider.setRange(0, STEPS)
        self.slider.setPageStep(STEPS // 10)
        (self.list if self.is_list else self.slider).setObjectName(f"choice_{choice['key']}")
        self.list.activated.connect(self._listed)
        self.slider.valueChanged.connect(self._moved)
        grid = QGridLayout(self)
        grid.setContentsMargins(0, 0, 0, 0)
        grid.setVerticalSpacing(0)
        grid.setColumnStretch(0, 1)
        grid.addWidget(self.label, 0, 0)
        grid.addWidget(self.list if self.is_list else self.shown, 0, 1)
        if not self.is_list:
            grid.addWidget(self.slider, 1, 0, 1, 2)
        self.list.setVisible(self.is_list)
        self.shown.setVisible(not self.is_list)
        self.slider.setVisible(not self.is_list)
        self.show_choice(choice)

    @property
    def is_list(self) -> bool:
        """A list of words, not a range."""
        return "options" in self._choice

    def show_choice(self, choice: dict[str, Any]) -> None:
        """Show a setting of the same key; one that the person is moving is left alone."""
        self._choice = choice
        title = sentence(choice["title"])
        self.label.setText(title)
        for widget in (self.list, self.slider):
            widget.setAccessibleName(title)
        if self.is_list:
            self.list.clear()
            for option in choice["options"]:
                self.list.addItem(sentence(option), option)
            self.list.setCurrentIndex(max(self.list.findData(choice["value"]), 0))
        elif not self._timer.isActive() and not self.slider.isSliderDown():
            self.slider.blockSignals(True)
            self.slider.setValue(self._place(choice["value"]))
            self.slider.blockSignals(False)
            self._write(choice["value"])

    def _place(self, value: float) -> int:
        low, high = self._choice["low"], self._choice["high"]
        return round(STEPS * (value - low) / (high - low)) if high > low else 0

    def _value(self) -> float:
        low, high = self._choice["low"], self._choice["high"]
        return float(low + (high - low) * self.slider.value() / STEPS)

    def _write(self, value: float) -> None:
        unit = self._choice.get("unit", "")
        decimals = 3 if self._choice["high"] - self._choice["low"] <= 10.0 else 0
        self.shown.setText(f"{value:.{decimals}f} {unit}".rstrip())

    def _listed(self) -> None:
        self.chosen.emit(self._choice["key"], self.list.currentData())

    def _moved(self) -> None:
        self._write(self._value())
        self._timer.start()

    def _settled(self) -> None:
        self.chosen.emit(self._choice["key"], self._value())
