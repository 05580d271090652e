"""What is special in a step: the base of the steps' own panels."""

from __future__ import annotations

from typing import Any

from PySide6.QtCore import Signal
from PySide6.QtWidgets import QWidget

from beltgui.engine.messages import Choose
from beltgui.viewmodel.scene import Scene
from beltgui.viewmodel.step import StepContent, StepView


class StepPanel(QWidget):
    """A step's own controls on the right of the page; built from `StepContent.extra`.

    Signals:
        command: A command for the engine.
        export_wanted: The person wants to write robot programs.
        pick_mode_wanted: What a click in the 3D view picks: `none`, `point` or `face`.
        scene_changed: `scene_of` gives another picture than before.
    """

    command = Signal(object)
    export_wanted = Signal()
    pick_mode_wanted = Signal(str)
    scene_changed = Signal()

    def __init__(self, step: str, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.step = step
        self.setObjectName(f"panel_{step}")
        self.view: StepView | None = None
        self.editable = True
        # Further tables beside that of the samples; their accessible names are their tabs' titles.
        self.tables: tuple[QWidget, ...] = ()

    def show_view(self, view: StepView) -> None:
        """Show the step's own data."""
        self.view = view
        self.refresh()

    def set_editable(self, editable: bool) -> None:
        """Whether anything may be changed now."""
        if editable != self.editable:
            self.editable = editable
            self.refresh()

    def refresh(self) -> None:
        """Write all again, from `view` and `editable`."""

    def retranslate(self) -> None:
        """Write again in the present language."""
        self.refresh()

    def entered(self) -> None:
        """The panel has come on the page: ask for its pick mode."""
        self.pick_mode_wanted.emit(self.pick_mode())

    def pick_mode(self) -> str:
        """What a click in the 3D view picks now."""
        return "none"

    def scene_of(self, content: StepContent) -> Scene | None:
        """The picture to show of a content."""
        return content.scene

    def picked_point(self, item: str, xyz: Any, second: bool) -> None:
        """A point was clicked, mm in its scene's frame; `second`: in the scene on the right."""

    def picked_face(self, face: int) -> None:
        """A face was clicked."""

    @property
    def extra(self) -> dict[str, Any]:
        """The step's own data; empty before there are any."""
        content = self.view.content if self.view is not None else None
        return content.extra if content is not None else {}

    def choose(self, key: str, value: Any) -> None:
        """Ask for a setting."""
        self.command.emit(Choose(self.step, key, value))
