"""What the help panel says of each step: what it is for, what to mount, what to watch, what to do if it is rejected."""

from __future__ import annotations

from dataclasses import dataclass

from PySide6.QtCore import QCoreApplication

# Every text stands as a literal in a call of `translate`, so that the translation tools find it.


@dataclass(frozen=True)
class StepHelp:
    """Help of one step; `remedies` are pairs of what the screen says and what to do."""

    purpose: str
    mount: str
    watch: str
    remedies: tuple[tuple[str, str], ...]


def help_of(step: str) -> StepHelp:
    """Help of a step in the language of the screen."""
    return {
        "ball": _ball,
        "base": _base,
        "rough": _rough,
        "fine": _fine,
        "tool": _tool,
        "error_surface": _error_surface,
    }[step]()


def reasons_help() -> tuple[tuple[str, str], ...]:
    """What the kinds of reasons of a verdict mean, and what to do: the same in all steps."""
    translate = QCoreApplication.translate
    return (
        (
            translate("Help", "The residual is too large"),
            translate(
                "Help",
                "The samples do not agree with each other. Untick the sample marked as worst. If the rest agrees, "
                "delete it and take it again; if not, check that everything is clamped and nothing moved.",
            ),
        ),
        (
            translate("Help", "The check on held-out data fails"),
            translate(
                "Help",
                "The result does not predict what it has not seen. Something moved between two samples, or one "
                "sample is wrong. A small residual does not help here: take the step's samples again.",
            ),
        ),
        (
            translate("Help", "The uncertainty is too large"),
            translate("Help", "The samples agree, but do not tell enough. Add the pose or touch that is suggested."),
        ),
        (
            translate("Help", "Too little variation, or ill-conditioned"),
            translate(
                "Help",
                "The samples are too much alike, so one direction is not held. Tilt further and about other axes, "
                "or scan from another side.",
            ),
        ),
        (
            translate("Help", "Too few points, or too little of the surface seen"),
            translate("Help", "Move the scanner closer or look from another side; clean what is measured."),
        ),
        (
            translate("Help", "Too many outliers"),
            translate(
                "Help", "Something strange is in the picture: dirt, a clamp, a reflection. Take it away and scan again."
            ),
        ),
        (
            translate("Help", "No redundancy"),
            translate(
                "Help", "A mistake could hide, because nothing checks a single sample. Tick samples again or take more."
            ),
        ),
        (
            translate("Help", "Outside the limits, or the wrong model"),
            translate(
                "Help",
                "The result agrees with itself but cannot be true, such as a wrong ball diameter or blade type. "
                "Check what is mounted against what was entered.",
            ),
        ),
    )


def _ball() -> StepHelp:
    translate = QCoreApplication.translate
    return StepHelp(
        translate(
            "Help",
            "Finds where the scanner sits on its stage, and how the stage's axes really run. Every later scan "
            "is placed by this result.",
        ),
        translate(
            "Help",
            "Mount the reference ball on the robot's flange and tighten it; wipe it clean. The robot brings it in "
            "front of the scanner and then stands still, while the stage moves the scanner about it.",
        ),
        translate(
            "Help",
            "The scanned ball in the 3D view: a wide cap should be seen in every scan. The last scan repeats "
            "the first one; if the ball has moved in between, the check says so.",
        ),
        (
            (
                translate("Help", "One scan stands out"),
                translate(
                    "Help",
                    "Untick it and look whether the check gets better. Delete it and press the main button to "
                    "take it again.",
                ),
            ),
            (
                translate("Help", "The ball's diameter does not fit"),
                translate(
                    "Help",
                    "Another ball is mounted than the one in the cell's file, or it is dirty. Clean it, or check "
                    "the certificate.",
                ),
            ),
            (
                translate("Help", "The closing scan is off"),
                translate("Help", "The ball or its holder has moved. Fasten it and start the step over."),
            ),
        ),
    )


def _base() -> StepHelp:
    translate = QCoreApplication.translate
    return StepHelp(
        translate(
            "Help",
            "Finds where the measuring frame is in the robot's base frame, so that what is scanned can be "
            "reached by the robot.",
        ),
        translate(
            "Help",
            "The reference ball stays on the robot's flange as it was in the ball step. Keep the robot's way in "
            "front of the scanner free: the robot moves to many poses in this step.",
        ),
        translate(
            "Help",
            "The poses should tilt the flange about different axes. The path of each motion is shown before it "
            "is asked for; look at it before you confirm.",
        ),
        (
            (
                translate("Help", "One pose stands out"),
                translate(
                    "Help",
                    "Untick it. If the others agree, take it again; a cable may have pulled or the ball was hidden "
                    "in part.",
                ),
            ),
            (
                translate("Help", "All poses are a little off"),
                translate(
                    "Help", "The ball on the flange is loose, or the robot was re-mastered. Tighten and take all again."
                ),
            ),
            (
                translate("Help", "Too little variation"),
                translate("Help", "Take the suggested pose: it tilts the flange where the result is weakest."),
            ),
        ),
    )


def _rough() -> StepHelp:
    translate = QCoreApplication.translate
    return StepHelp(
        translate(
            "Help",
            "Finds roughly where the blade is clamped, so that the fine step can begin. A few millimetres are "
            "good enough here.",
        ),
        translate(
            "Help",
            "Clamp the blade by its root in the gripper on the flange. Check that type and serial number are "
            "those at the top of this window.",
        ),
        translate(
            "Help",
            "Scan and CAD model lie on each other in the 3D view. If the blade looks mirrored or turned by half "
            "a turn, do not accept.",
        ),
        (
            (
                translate("Help", "No place was found automatically"),
                translate(
                    "Help",
                    "Choose picking by hand and click at least four corners that you see in both pictures, far "
                    "from each other and not in one line.",
                ),
            ),
            (
                translate("Help", "One pair of picks stands out"),
                translate("Help", "Delete this pair and pick it again; zoom in before you click."),
            ),
            (
                translate("Help", "The blade is found the wrong way round"),
                translate("Help", "Check the blade type. Then pick by hand."),
            ),
        ),
    )


def _fine() -> StepHelp:
    translate = QCoreApplication.translate
    return StepHelp(
        translate(
            "Help",
            "Finds exactly where the blade is, from the faces of its root and shroud. This pose places every "
            "contact of the belt.",
        ),
        translate(
            "Help",
            "Leave the blade as it was clamped for the rough step. If it was touched or clamped again, repeat "
            "the rough step.",
        ),
        translate(
            "Help",
            "The deviation of each chosen face, in µm with its sign. A face that is off by itself is dirty, "
            "damaged or badly seen.",
        ),
        (
            (
                translate("Help", "One face is off"),
                translate(
                    "Help",
                    "Clean it and scan again, or take it off the list if the other faces hold the blade in every "
                    "direction.",
                ),
            ),
            (
                translate("Help", "A face has too few points"),
                translate("Help", "It is hidden or seen too flat. Scan from another side, or take it off the list."),
            ),
            (
                translate("Help", "The closing scan is off"),
                translate("Help", "The blade has slipped in its clamp. Clamp it again and repeat from the rough step."),
            ),
        ),
    )


def _tool() -> StepHelp:
    translate = QCoreApplication.translate
    return StepHelp(
        translate(
            "Help",
            "Finds the tip of the stylus, and with it the contact wheel of each grinder in the robot's base frame.",
        ),
        translate(
            "Help",
            "Mount the stylus on the flange. Belts stand still and are locked out: you work at the wheel by "
            "hand. Set the tip into the cone first, then to the centre mark of each wheel's shaft.",
        ),
        translate(
            "Help",
            "In the cone: tilt the flange widely and about different axes, the tip must not lift. At the wheel: "
            "turn the floating head between touches; a longer arc gives a better axis.",
        ),
        (
            (
                translate("Help", "One touch stands out"),
                translate("Help", "The tip was not seated. Delete this touch and take it again."),
            ),
            (
                translate("Help", "The arc is too short"),
                translate("Help", "Turn the head further, as far as the reason says, and add touches there."),
            ),
            (
                translate("Help", "Radius or sensor scale does not fit"),
                translate(
                    "Help",
                    "The wheel is worn or another one, or the sensor is set wrongly. Check both before going on.",
                ),
            ),
        ),
    )


def _error_surface() -> StepHelp:
    translate = QCoreApplication.translate
    return StepHelp(
        translate(
            "Help",
            "Touches the airfoil with the standing wheel of each grinder, maps what is left of all errors along "
            "the surface normal, and corrects the grinding path by it.",
        ),
        translate(
            "Help",
            "The blade is clamped as in the fine step. Belts stand still, nothing touches the floating heads "
            "before the robot does.",
        ),
        translate(
            "Help",
            "The map should be smooth. The band shows how sure it is; where nothing was touched, nothing is "
            "corrected. The prediction compares the blade with and without correction.",
        ),
        (
            (
                translate("Help", "Held-out touches are predicted badly"),
                translate(
                    "Help", "The head sticks, or the blade slips under the touch. Check both, then start the step over."
                ),
            ),
            (
                translate("Help", "Too little of the airfoil was touched"),
                translate("Help", "Some places were out of reach. Look at the map and free the robot's way."),
            ),
            (
                translate("Help", "The head no longer rests where it did"),
                translate("Help", "The zero of its angle sensor has shifted. Repeat the step Stylus and tool."),
            ),
        ),
    )
