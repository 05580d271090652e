"""Live values of the cell: where the robot and the stage are, the head's angle, the force."""

from __future__ import annotations

import numpy as np
from PySide6.QtWidgets import QLabel, QWidget

from beltgui.app.language import sentence
from beltgui.engine.messages import CellMoved
from beltgui.widgets.figures import with_unit


class LiveValues(QLabel):
    """A few lines of text, written when the cell reports."""

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.setObjectName("live_values")
        self.setWordWrap(True)
        self._cell: CellMoved | None = None
        self._keys: tuple[str, ...] = ()
        self._wanted = False
        self.setVisible(False)

    def show_only(self, wanted: tuple[str, ...]) -> None:
        """Which values matter now: `robot`, `stage`, `head`, `force`."""
        self._keys = wanted
        self.retranslate()

    def set_wanted(self, wanted: bool) -> None:
        """Whether live values matter at all now."""
        if wanted != self._wanted:
            self._wanted = wanted
            self.retranslate()

    def show_cell(self, cell: CellMoved) -> None:
        """The cell has moved."""
        self._cell = cell
        self.retranslate()

    def retranslate(self) -> None:
        """Write again."""
        lines = [] if self._cell is None else [line for key in self._keys for line in self._lines(key, self._cell)]
        self.setVisible(self._wanted and bool(lines))
        self.setText("\n".join(lines))
        self.setAccessibleName(self.tr("Live values: {values}").format(values="; ".join(lines)))

    def _lines(self, key: str, cell: CellMoved) -> list[str]:
        if key == "robot":
            x, y, z = np.asarray(cell.base_from_flange)[:3, 3]
            state = (
                self.tr("▶ moves, {speed}").format(speed=with_unit(cell.speed_mm_s, "mm/s", 0))
                if cell.moving
                else self.tr("■ stands still")
            )
            place = self.tr("Flange in {B}: ") + f"{x:.1f}, {y:.1f}, {z:.1f} mm"
            return [self.tr("Robot: ") + state, place]
        if key == "stage":
            x, y, z, theta = cell.stage
            return [self.tr("Stage: ") + f"{x:.2f}, {y:.2f}, {z:.2f} mm, {theta:.2f}°"]
        if key == "head":
            return [
                self.tr("Head, grinder {name}: {value}").format(name=sentence(name), value=with_unit(value, "deg", 2))
                for name, value in cell.head_deg.items()
            ]
        return [
            self.tr("Force, grinder {name}: {value}").format(name=sentence(name), value=with_unit(value, "N", 1))
            for name, value in cell.force_n.items()
        ]
