"""Words for states and devices in the language of the screen, and the shape that goes with each state."""

from __future__ import annotations

from PySide6.QtCore import QCoreApplication

from beltgui.steps.state import StepState

SHAPES = {
    StepState.NOT_STARTED: "○",
    StepState.RUNNING: "▶",
    StepState.ACCEPTED: "✔",
    StepState.STALE: "◆",
    StepState.FAILED: "✖",
    "connected": "●",
    "simulated": "■",
    "waiting": "▲",
    "stale": "◆",
    "fault": "✖",
}


def state_word(state: StepState) -> str:
    """A step's state in one or two words."""
    return {
        StepState.NOT_STARTED: QCoreApplication.translate("Names", "not started"),
        StepState.RUNNING: QCoreApplication.translate("Names", "running"),
        StepState.ACCEPTED: QCoreApplication.translate("Names", "accepted"),
        StepState.STALE: QCoreApplication.translate("Names", "stale"),
        StepState.FAILED: QCoreApplication.translate("Names", "failed"),
    }[state]


def device_name(name: str) -> str:
    """A device as it is called on the screen."""
    return {
        "scanner": QCoreApplication.translate("Names", "Scanner"),
        "stage": QCoreApplication.translate("Names", "Stage"),
        "robot": QCoreApplication.translate("Names", "Robot"),
        "grinder rough": QCoreApplication.translate("Names", "Grinder rough"),
        "grinder fine": QCoreApplication.translate("Names", "Grinder fine"),
    }.get(name, name)


def device_state_word(state: str) -> str:
    """A device's state in one word."""
    return {
        "connected": QCoreApplication.translate("Names", "connected"),
        "simulated": QCoreApplication.translate("Names", "simulated"),
        "waiting": QCoreApplication.translate("Names", "waiting"),
        "stale": QCoreApplication.translate("Names", "no news"),
        "fault": QCoreApplication.translate("Names", "fault"),
    }.get(state, state)
