"""The whole commissioning in a real window with mouse and keyboard, a picture of every stage:

    xvfb-run -a -s "-screen 0 1280x800x24" .venv/bin/python -m tests.on_screen.walk --out out/walk

Ends with exit code 0 when the robot programs are written, and with the reason otherwise.
"""

from __future__ import annotations

import argparse
import sys
import tempfile
from collections.abc import Callable
from pathlib import Path

from tests.on_screen.driver import Screen, run_beside

STEPS = ("ball", "base", "rough", "fine", "tool", "error_surface")
STEP_S = 400.0
Extra = Callable[[str], None]


class Walk:
    """What a person does, from the first page to the robot programs.

    Args:
        screen: Mouse, keyboard and eyes.
        state: Gives a step's state as the rail says it.
        pictures: Take pictures on the way.
    """

    def __init__(self, screen: Screen, state: Callable[[str], str], pictures: bool = True) -> None:
        self.screen = screen
        self.state = state
        self.pictures = pictures
        self.questions_seen: set[str] = set()

    def shot(self, name: str) -> None:
        if self.pictures:
            self.screen.shot(name)

    def begin(self, person: str) -> None:
        """The start page: a name, then the button."""
        screen = self.screen
        screen.wait("the start page", lambda: screen.visible("begin"))
        screen.click("person")
        screen.key("ctrl+a")
        screen.type(person)
        self.shot("start")
        screen.click("begin")
        screen.wait("the first step", lambda: screen.enabled("primary_button"))

    def step(self, step: str) -> None:
        """One step: acquire, look, accept."""
        screen = self.screen
        screen.wait(f"{step} can begin", lambda: screen.enabled("primary_button"))
        self.shot(f"{step}_prepare")
        screen.click("primary_button")
        screen.wait(f"{step} has begun", self.busy)
        self.answer_until_idle(step)
        screen.wait(f"{step} has a result", lambda: screen.enabled("primary_button"))
        self.shot(f"{step}_result")
        screen.click("primary_button")
        screen.wait(f"{step} is accepted", lambda: self.state(step) == "accepted")
        self.shot(f"{step}_accepted")

    def next(self) -> None:
        """To the step that follows."""
        self.screen.click("primary_button")

    def busy(self) -> bool:
        """True while work is under way."""
        return self.screen.visible("job_cancel")

    def answer_until_idle(self, step: str) -> None:
        """Do what the window asks for until the work is over."""
        screen = self.screen

        def something_to_do() -> bool:
            return not self.busy() or screen.enabled("question_done") or screen.enabled("question_move")

        halfway = False
        while True:
            screen.wait(f"{step}: a question or the end", something_to_do, STEP_S)
            if screen.enabled("question_done"):
                self.answer(step, "question_done")
            elif screen.enabled("question_move"):
                self.answer(step, "question_move")
            elif not self.busy():
                return
            if not halfway and self.pictures:
                halfway = True

    def answer(self, step: str, button: str) -> None:
        """Say yes, for the whole series where that is offered."""
        screen = self.screen
        text = screen.text("question_text")
        kind = f"{step}_{button}"
        if kind not in self.questions_seen:
            self.questions_seen.add(kind)
            self.shot(f"{step}_{button.removeprefix('question_')}")
        if screen.enabled("question_series") and not screen.look(lambda: screen.widgets("question_series")[0].isChecked()):
            screen.click("question_series")
        screen.click(button)
        screen.wait(
            "the answer is taken",
            lambda: not screen.visible("question_panel") or screen.text("question_text") != text,
        )


def main(words: list[str] | None = None) -> int:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--out", type=Path, required=True)
    parser.add_argument("--theme", choices=("light", "dark"), default="light")
    parser.add_argument("--language", choices=("en", "zh_CN"), default="en")
    parser.add_argument("--resolution", default="test")
    parser.add_argument("--speed", type=float, default=0.0)
    parser.add_argument("--grid", type=int, nargs=2, default=(33, 20))
    args = parser.parse_args(words)
    raise SystemExit(walk(args))


if __name__ == "__main__":
    sys.exit(main())
