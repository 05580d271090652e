"""From the start page to the accepted ball step without a mouse:

    xvfb-run -a -s "-screen 0 1280x800x24" .venv/bin/python -m tests.on_screen.keyboard --out out/keyboard

Ends with exit code 0 when the step is accepted and every usable control was reached, and with the reason otherwise.
"""

from __future__ import annotations

import argparse
import sys
import traceback
from collections.abc import Callable
from pathlib import Path

from PySide6.QtCore import Qt
from PySide6.QtWidgets import QAbstractButton, QApplication, QTableView

from tests.on_screen.driver import Screen
from tests.on_screen.walk import STEP_S, at_the_window

CELL = {"resolution": "test", "speed": 0.0}
# More presses of Tab than the window has controls.
TABS = 120


def by_keyboard(screen: Screen, state: Callable[[str], str]) -> None:
    """All of it."""
    begin(screen)
    take_samples(screen)
    screen.wait("the keyboard is on Accept", lambda: screen.focus() == "primary_button", STEP_S)
    screen.shot("result")
    reach_everything(screen)
    screen.key("Return")
    screen.wait("the ball step is accepted", lambda: state("ball") == "accepted")
    screen.wait("the keyboard is on the next step's button", lambda: screen.focus() == "primary_button")
    screen.key("space")
    screen.wait("the next step is shown", lambda: screen.text("step_title") == "Base")
    screen.shot("next")


def begin(screen: Screen) -> None:
    """A name and Enter."""
    screen.wait("the keyboard is on the name", lambda: screen.focus() == "person")
    screen.key("ctrl+a")
    screen.type("Ada")
    screen.key("Return")
    screen.wait("the keyboard is on the first button", lambda: screen.focus() == "primary_button")


def take_samples(screen: Screen) -> None:
    """Mount by Enter; a motion never by a key pressed twice: hold, or go to `Move once` on purpose."""
    screen.key("Return", "Return", "Return")  # who leans on the key begins once and mounts nothing
    screen.wait("the keyboard is on Done", lambda: screen.focus() == "question_done")
    screen.shot("mount")
    screen.key("Return", "Return")
    screen.wait("the keyboard is on the button to hold", lambda: screen.focus() == "question_hold")
    screen.key("Return")
    assert screen.enabled("question_hold"), "Enter is no hold"
    screen.shot("motion")
    screen.key("alt+w")
    screen.wait("the keyboard is on the series", lambda: screen.focus() == "question_series")
    screen.key("Tab")
    screen.wait("the keyboard is on Move once", lambda: screen.focus() == "question_move")
    screen.key("Return")
    screen.wait("the answer is taken", lambda: not screen.visible("question_move"))


def reach_everything(screen: Screen) -> None:
    """Tab goes round through every usable control and comes back."""

    def usable() -> set[str]:
        kinds = (QAbstractButton, QTableView)
        return {
            widget.objectName()
            for widget in QApplication.allWidgets()
            if isinstance(widget, kinds) and widget.isVisible() and widget.isEnabled() and widget.objectName()
            and widget.focusPolicy() & Qt.FocusPolicy.TabFocus
        }  # fmt: skip

    wanted = screen.look(usable)
    assert "stop_button" in wanted and "samples_table" in wanted
    way: list[str] = []
    while len(way) < TABS and "primary_button" not in way:
        screen.key("Tab")
        way.append(screen.focus())
    assert way[-1] == "primary_button", f"Tab does not come round: {', '.join(way)}"
    assert wanted <= set(way), f"not reached with Tab: {', '.join(sorted(wanted - set(way)))}"


def main(words: list[str] | None = None) -> int:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--out", type=Path, required=True, help="folder for the pictures")
    args = parser.parse_args(words)
    problems = at_the_window(by_keyboard, args.out, cell=CELL)
    for problem in problems:
        traceback.print_exception(problem)
    return 1 if problems else 0


if __name__ == "__main__":
    sys.exit(main())
