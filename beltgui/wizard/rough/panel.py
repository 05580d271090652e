"""Rough workpiece: how the blade is found, and the pairs of points that a person picks.

Object names: rough_automatic, rough_pairs, rough_message, rough_again.
"""

from __future__ import annotations

from typing import Any

import numpy as np
from PySide6.QtWidgets import QButtonGroup, QLabel, QPushButton, QRadioButton, QVBoxLayout, QWidget

from beltgui.app.language import sentence
from beltgui.wizard.panel import StepPanel

AUTOMATIC, PAIRS = "automatic", "pairs"
SCAN, CAD = "scan_mm", "cad_mm"


class RoughPanel(StepPanel):
    """Method and picking; the pairs themselves are the rows of the table.

    A click on the scan and a click on the CAD model make a pair, in either order; each click is kept at once.
    """

    def __init__(self, step: str, parent: QWidget | None = None) -> None:
        super().__init__(step, parent)
        self._mode = "none"
        self.automatic, self.by_pairs = QRadioButton(self), QRadioButton(self)
        self.automatic.setObjectName("rough_automatic")
        self.by_pairs.setObjectName("rough_pairs")
        self._methods = QButtonGroup(self)
        self._methods.addButton(self.automatic)
        self._methods.addButton(self.by_pairs)
        self.automatic.clicked.connect(lambda: self.choose("method", AUTOMATIC))
        self.by_pairs.clicked.connect(lambda: self.choose("method", PAIRS))
        self.hint, self.message = QLabel(self), QLabel(self)
        self.message.setObjectName("rough_message")
        self.message.setProperty("tone", "accent")
        for label in (self.hint, self.message):
            label.setWordWrap(True)
        self.again = QPushButton(self)
        self.again.setObjectName("rough_again")
        self.again.clicked.connect(self._drop_half)
        layout = QVBoxLayout(self)
        layout.setContentsMargins(0, 0, 0, 0)
        layout.setSpacing(4)
        for widget in (self.automatic, self.by_pairs, self.hint, self.message, self.again):
            layout.addWidget(widget)

    def refresh(self) -> None:
        """Write all again."""
        by_pairs = self.extra.get("method") == PAIRS
        self.automatic.setText(self.tr("Find the blade automatically"))
        self.by_pairs.setText(self.tr("Pick pairs of points"))
        for button, on in ((self.automatic, not by_pairs), (self.by_pairs, by_pairs)):
            button.setChecked(on)
            button.setEnabled(self.editable and bool(self.extra))
            button.setAccessibleName(button.text())
        self.hint.setText(self.tr("Click a point on the scan, then the same point on the CAD model."))
        self.hint.setVisible(by_pairs)
        self.message.setText(sentence(self.extra.get("message", "")))
        self.message.setVisible(by_pairs and bool(self.message.text()))
        self.again.setText(self.tr("Forget the half picked pair"))
        self.again.setAccessibleName(self.again.text())
        self.again.setVisible(by_pairs and self._half() is not None)
        self.again.setEnabled(self.editable)
        if self.pick_mode() != self._mode:
            self._mode = self.pick_mode()
            if self.isVisible():
                self.pick_mode_wanted.emit(self._mode)

    def pick_mode(self) -> str:
        """Points, while pairs are picked."""
        return "point" if self.editable and self.extra.get("method") == PAIRS else "none"

    def picked_point(self, item: str, xyz: Any, second: bool) -> None:
        """Add to the half picked pair, or begin a new one."""
        if self.pick_mode() != "point":
            return
        key = CAD if second else SCAN
        at = [float(value) for value in np.asarray(xyz, float)]
        pairs = self._pairs()
        half = self._half()
        if half is None:
            pairs.append({"name": self._next_name(), SCAN: None, CAD: None, "included": True, key: at})
        else:
            pairs[half][key] = at
        self.choose(PAIRS, pairs)

    def _pairs(self) -> list[dict[str, Any]]:
        keys = ("name", SCAN, CAD, "included")
        return [{key: pair[key] for key in keys} for pair in self.extra.get("pairs", ())]

    def _half(self) -> int | None:
        """Place of the pair of which one point is missing."""
        places = [k for k, pair in enumerate(self.extra.get("pairs", ())) if None in (pair[SCAN], pair[CAD])]
        return places[0] if places else None

    def _next_name(self) -> str:
        return str(self.extra.get("next_name", f"pair {len(self._pairs()) + 1}"))

    def _drop_half(self) -> None:
        half = self._half()
        if half is not None:
            self.choose(PAIRS, [pair for k, pair in enumerate(self._pairs()) if k != half])
