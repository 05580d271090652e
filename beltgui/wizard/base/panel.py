"""Base: the suggested pose can be taken in addition."""

from __future__ import annotations

from beltgui.wizard.suggested import SuggestedPanel


class BasePanel(SuggestedPanel):
    """Own controls of the base step."""
