"""Ball: the suggested pose can be taken in addition."""

from __future__ import annotations

from beltgui.wizard.suggested import SuggestedPanel


class BallPanel(SuggestedPanel):
    """Own controls of the ball step."""
