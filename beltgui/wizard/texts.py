"""What each step is for and what the person prepares, in the language of the screen."""

from __future__ import annotations

from dataclasses import dataclass

from PySide6.QtCore import QCoreApplication


@dataclass(frozen=True)
class StepTexts:
    """Of one step.

    Attributes:
        purpose: What it finds, one line.
        instruction: What to prepare.
        picture: Key of the picture.
        begin: The primary button before the first sample.
        live: What of the cell is worth seeing: `robot`, `stage`, `head`, `force`.
    """

    purpose: str
    instruction: str
    picture: str
    begin: str
    live: tuple[str, ...]


def texts_of(step: str) -> StepTexts:
    """The texts of a step."""
    return _MAKERS[step]()


def _ball() -> StepTexts:
    translate = QCoreApplication.translate
    return StepTexts(
        translate("StepTexts", "Where the scanner sits on its stage, and how the stage's axes run."),
        translate("StepTexts", "Mount the ball. The stage moves the scanner about it; the robot brings the ball into "
                               "view and then stands still."),
        "mount ball",
        translate("StepTexts", "Mount and scan"),
        ("robot", "stage"),
    )  # fmt: skip


def _base() -> StepTexts:
    translate = QCoreApplication.translate
    return StepTexts(
        translate("StepTexts", "Where the measurement frame {M} lies in the robot's base {B}."),
        translate("StepTexts", "Leave the ball mounted. The robot shows it to the scanner in many poses; each motion "
                               "is shown first."),
        "motion",
        translate("StepTexts", "Mount and scan"),
        ("robot", "stage"),
    )  # fmt: skip


def _rough() -> StepTexts:
    translate = QCoreApplication.translate
    return StepTexts(
        translate("StepTexts", "Roughly where the blade is clamped, so that the fine step can begin."),
        translate("StepTexts", "Clamp the blade. It is found in its scan automatically, or by pairs of points that "
                               "you pick."),
        "mount blade",
        translate("StepTexts", "Clamp and scan"),
        ("robot", "stage"),
    )  # fmt: skip


def _fine() -> StepTexts:
    translate = QCoreApplication.translate
    return StepTexts(
        translate("StepTexts", "Exactly where the blade is, from the faces of its CAD model."),
        translate("StepTexts", "Leave the blade clamped. The faces chosen below are scanned from several poses."),
        "mount blade",
        translate("StepTexts", "Scan the faces"),
        ("robot", "stage"),
    )


def _tool() -> StepTexts:
    translate = QCoreApplication.translate
    return StepTexts(
        translate("StepTexts", "Where the stylus tip is, and with it the wheel of each grinder."),
        translate("StepTexts", "Mount the stylus. Guide it by hand: first into the cone, then to the wheel shaft of "
                               "each grinder."),
        "mount stylus",
        translate("StepTexts", "Mount and touch"),
        ("robot", "head"),
    )  # fmt: skip


def _error_surface() -> StepTexts:
    translate = QCoreApplication.translate
    return StepTexts(
        translate("StepTexts", "What error is left at the contact, and the paths that take it out."),
        translate("StepTexts", "Clamp the blade. It is brought to the wheel point by point; the contact force says "
                               "how far off the path is."),
        "mount blade",
        translate("StepTexts", "Clamp and probe"),
        ("robot", "head", "force"),
    )  # fmt: skip


_MAKERS = {
    "ball": _ball,
    "base": _base,
    "rough": _rough,
    "fine": _fine,
    "tool": _tool,
    "error_surface": _error_surface,
}
