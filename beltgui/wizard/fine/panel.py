"""Fine workpiece: which faces are measured on, and how the scan is coloured.

Object names: fine_hold, fine_reset, fine_colours, faces_table.
"""

from __future__ import annotations

from PySide6.QtWidgets import QComboBox, QLabel, QPushButton, QVBoxLayout, QWidget

from beltgui.app.language import sentence
from beltgui.viewmodel.scene import Scene
from beltgui.viewmodel.step import StepContent
from beltgui.widgets.ticks_table import TicksTable
from beltgui.wizard.panel import StepPanel


class FinePanel(StepPanel):
    """A click on a face, or its tick box in the table of faces, chooses it or takes it off."""

    def __init__(self, step: str, parent: QWidget | None = None) -> None:
        super().__init__(step, parent)
        self._mode = "none"
        self._picture = ""
        self.hint, self.hold = QLabel(self), QLabel(self)
        self.hold.setObjectName("fine_hold")
        self.hold.setProperty("tone", "bad")
        for label in (self.hint, self.hold):
            label.setWordWrap(True)
        self.reset_button = QPushButton(self)
        self.reset_button.setObjectName("fine_reset")
        self.reset_button.clicked.connect(lambda: self.choose("faces", None))
        self.colours = QComboBox(self)
        self.colours.setObjectName("fine_colours")
        self.colours.activated.connect(self._colour)
        self.faces = TicksTable(self)
        self.faces.view.setObjectName("faces_table")
        self.faces.include_wanted.connect(lambda face, on: self._set(face, on))
        self.tables = (self.faces,)
        layout = QVBoxLayout(self)
        layout.setContentsMargins(0, 0, 0, 0)
        layout.setSpacing(4)
        for widget in (self.hint, self.hold, self.reset_button, self.colours):
            layout.addWidget(widget)

    def refresh(self) -> None:
        """Write all again."""
        chosen = self.extra.get("chosen_faces", ())
        self.hint.setText(
            self.tr("Faces chosen: {count}. Click a face of the CAD model to choose it or to take it off.").format(
                count=len(chosen)
            )
        )
        hold = self.extra.get("hold", "")
        self.hold.setText(f"▲ {sentence(hold)}")
        self.hold.setVisible(bool(hold))
        self.reset_button.setText(self.tr("Reset to the blade type's faces"))
        self.reset_button.setAccessibleName(self.reset_button.text())
        changed = tuple(chosen) != tuple(self.extra.get("default_faces", chosen))
        self.reset_button.setEnabled(self.editable and changed)
        self.faces.setAccessibleName(self.tr("Faces"))
        columns, rows = self.extra.get("faces_table", ((), ()))
        self.faces.show_rows(columns, rows)
        self.faces.set_editable(self.editable)
        self._offer_pictures()
        if self.pick_mode() != self._mode:
            self._mode = self.pick_mode()
            if self.isVisible():
                self.pick_mode_wanted.emit(self._mode)

    def pick_mode(self) -> str:
        """Faces, while they may be chosen."""
        return "face" if self.editable and "chosen_faces" in self.extra else "none"

    def scene_of(self, content: StepContent) -> Scene | None:
        """Coloured by face, or one of the other pictures."""
        return content.extra.get("scenes", {}).get(self._picture, content.scene)

    def picked_face(self, face: int) -> None:
        """Choose it, or take it off; a face that cannot be measured on is not in the table."""
        _, rows = self.extra.get("faces_table", ((), ()))
        if self.pick_mode() == "face" and any(row.id == face for row in rows):
            self._set(face, face not in self.extra["chosen_faces"])

    def _set(self, face: int, on: bool) -> None:
        chosen = set(self.extra.get("chosen_faces", ()))
        wanted = chosen | {face} if on else chosen - {face}
        # the type's own faces are no choice: what was solved from them holds again
        self.choose("faces", None if wanted == set(self.extra.get("default_faces", ())) else sorted(wanted))

    def _offer_pictures(self) -> None:
        names = list(self.extra.get("scenes", {}))
        if self._picture not in names:
            self._picture = ""
        self.colours.setAccessibleName(self.tr("Colours of the scan"))
        self.colours.clear()
        self.colours.addItem(self.tr("Colour: face by face"), "")
        for name in names:
            self.colours.addItem(self.tr("Colour: {what}").format(what=sentence(name)), name)
        self.colours.setCurrentIndex(max(self.colours.findData(self._picture), 0))
        self.colours.setVisible(bool(names))

    def _colour(self) -> None:
        self._picture = self.colours.currentData()
        self.scene_changed.emit()
