"""The small buttons in the corner of a 3D view: from where to look, and whatever else belongs there."""

from __future__ import annotations

from PySide6.QtCore import QCoreApplication, QEvent, Qt, Signal
from PySide6.QtWidgets import QHBoxLayout, QToolButton, QWidget

DIRECTIONS = ("fit", "front", "side", "top", "oblique")


class ViewButtons(QWidget):
    """One button for each direction; more with `add`.

    Args:
        prefix: Of the buttons' object names.
        parent: Of the widget.

    Signals:
        look_wanted: One of `DIRECTIONS`.
    """

    look_wanted = Signal(str)

    def __init__(self, prefix: str, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self._row = QHBoxLayout(self)
        self._row.setContentsMargins(0, 0, 0, 0)
        self._row.setSpacing(4)
        self._prefix = prefix
        self._looks = {name: self.add(name) for name in DIRECTIONS}
        for name, button in self._looks.items():
            button.clicked.connect(lambda _=False, name=name: self.look_wanted.emit(name))
        self._write()

    def add(self, name: str) -> QToolButton:
        """One more button, to the right of the others; its text is the caller's."""
        button = QToolButton(self)
        button.setObjectName(f"{self._prefix}_{name}")
        button.setFocusPolicy(Qt.FocusPolicy.TabFocus)
        self._row.addWidget(button)
        return button

    def _write(self) -> None:
        translate = QCoreApplication.translate  # by this name lupdate finds the texts
        texts = {
            "fit": (translate("SceneView", "Fit"),
                    translate("SceneView", "Everything into the picture (F, or a double click)")),
            "front": (translate("SceneView", "Front"), translate("SceneView", "Along +y: x to the right, z up (1)")),
            "side": (translate("SceneView", "Side"), translate("SceneView", "Along −x: y to the right, z up (2)")),
            "top": (translate("SceneView", "Top"), translate("SceneView", "Along −z: x to the right, y up (3)")),
            "oblique": (translate("SceneView", "Oblique"),
                        translate("SceneView", "From the front, right and above (4)")),
        }  # fmt: skip
        for name, (text, tip) in texts.items():
            self._looks[name].setText(text)
            self._looks[name].setToolTip(tip)
            self._looks[name].setAccessibleName(text)

    def changeEvent(self, event: QEvent) -> None:  # noqa: N802  (Qt's name)
        """Write again in another language."""
        if event.type() == QEvent.Type.LanguageChange:
            self._write()
        super().changeEvent(event)
