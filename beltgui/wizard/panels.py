"""The steps' own panels by name."""

from __future__ import annotations

from beltgui.wizard.ball.panel import BallPanel
from beltgui.wizard.base.panel import BasePanel
from beltgui.wizard.error_surface.panel import ErrorSurfacePanel
from beltgui.wizard.fine.panel import FinePanel
from beltgui.wizard.panel import StepPanel
from beltgui.wizard.rough.panel import RoughPanel
from beltgui.wizard.tool.panel import ToolPanel


def make_panels() -> dict[str, StepPanel]:
    """A new panel for each step, in the order of the work."""
    panels: tuple[StepPanel, ...] = (
        BallPanel("ball"), BasePanel("base"), RoughPanel("rough"), FinePanel("fine"), ToolPanel("tool"),
        ErrorSurfacePanel("error_surface"),
    )  # fmt: skip
    return {panel.step: panel for panel in panels}
