"""The whole commissioning in a real window with mouse and keyboard, a picture of every stage:

    xvfb-run -a -s "-screen 0 1280x800x24" .venv/bin/python -m tests.on_screen.walk --out out/walk

Ends with exit code 0 when the robot programs are written, and with the reason otherwise.
"""

from __future__ import annotations

import argparse
import os
import sys
import tempfile
import traceback
from collections.abc import Callable
from dataclasses import replace
from pathlib import Path
from typing import Any

from tests.on_screen.driver import Screen, run_beside

STEPS = ("ball", "base", "rough", "fine", "tool", "error_surface")
STEP_S = 400.0


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
        screen.wait("the tour is offered", lambda: screen.enabled("message_button"))
        self.shot("tour_offered")
        screen.click("message_button")
        screen.wait("the tour", lambda: screen.enabled("tour_skip"))
        self.shot("tour")
        screen.click("tour_skip")
        screen.wait("the tour has ended", lambda: not screen.visible("tour_card"))

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

    def export(self) -> None:
        """Write the robot programs: the button, then Enter in the dialog of the folder."""
        screen = self.screen
        screen.click("primary_button")
        screen.wait("the dialog of the folder", lambda: screen.visible("export_dialog"))
        self.shot("export_folder")
        screen.key("Return")
        screen.wait("the programs are written", lambda: screen.visible("exported_dialog"), STEP_S)
        self.shot("exported")
        screen.key("Escape")

    def busy(self) -> bool:
        """True while work is under way."""
        return self.screen.visible("job_cancel")

    def answer_until_idle(self, step: str) -> None:
        """Do what the window asks for until the work is over."""
        screen = self.screen

        def something_to_do() -> bool:
            return not self.busy() or screen.enabled("question_done") or screen.enabled("question_move")

        while True:
            screen.wait(f"{step}: a question or the end", something_to_do, STEP_S)
            if screen.enabled("question_done"):
                self.answer(step, "question_done")
            elif screen.enabled("question_move"):
                self.answer(step, "question_move")
            elif not self.busy():
                return

    def answer(self, step: str, button: str) -> None:
        """Say yes, for the whole series where that is offered."""
        screen = self.screen
        text = screen.text("question_text")
        kind = f"{step}_{button}"
        if kind not in self.questions_seen:
            self.questions_seen.add(kind)
            self.shot(f"{step}_{button.removeprefix('question_')}")
        if screen.enabled("question_series") and not screen.look(self.series_is_ticked):
            screen.click("question_series")
        screen.click(button)
        screen.wait(
            "the answer is taken",
            lambda: not screen.visible("question_panel") or screen.text("question_text") != text,
        )

    def series_is_ticked(self) -> bool:
        """True if the answer will hold for the whole series."""
        box: Any = self.screen.widgets("question_series")[0]
        return bool(box.isChecked())


def main(words: list[str] | None = None) -> int:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--out", type=Path, required=True, help="folder for the pictures")
    parser.add_argument("--theme", choices=("light", "dark"), default="light")
    parser.add_argument("--language", choices=("en", "zh_CN"), default="en")
    parser.add_argument("--resolution", default="test", help="of the simulated scanner")
    parser.add_argument("--speed", type=float, default=0.0, help="times real time; 0 is instantly")
    parser.add_argument("--grid", type=int, nargs=2, default=(33, 20), help="probed points in u and v")
    args = parser.parse_args(words)
    problems = walk(args.out, theme=args.theme, language=args.language,
                    cell={"resolution": args.resolution, "speed": args.speed, "grid": tuple(args.grid)})  # fmt: skip
    for problem in problems:
        traceback.print_exception(problem)
    return 1 if problems else 0


def walk(out: Path, *, theme: str, language: str, cell: dict[str, Any]) -> list[BaseException]:
    """The application and the person before it; see `at_the_window`."""

    def work(screen: Screen, state: Callable[[str], str]) -> None:
        person = Walk(screen, state)
        person.begin("Ada")
        for step in STEPS:
            person.step(step)
            if step != STEPS[-1]:
                person.next()
        person.export()

    return at_the_window(work, out, theme=theme, language=language, cell=cell)


def at_the_window(
    work: Callable[[Screen, Callable[[str], str]], None],
    out: Path,
    *,
    theme: str = "light",
    language: str = "en",
    cell: dict[str, Any],
) -> list[BaseException]:
    """The application as on a computer where it was never used, and someone at it.

    Args:
        work: What is done there; gets the screen, and what gives a step's state. The application is closed after it.
        out: Folder for the pictures.
        theme: `light` or `dark`.
        language: `en` or `zh_CN`.
        cell: Fields of `NewSession` that the start page does not ask for.

    Returns:
        What went wrong.
    """
    from PySide6.QtWidgets import QApplication

    from beltgui.app import main as application
    from beltgui.app.client import EngineClient
    from beltgui.app.window import MainWindow
    from beltgui.engine.messages import NewSession

    send = EngineClient.send

    def with_cell(client: EngineClient, command: Any) -> None:
        send(client, replace(command, **cell) if isinstance(command, NewSession) else command)

    EngineClient.send = with_cell  # type: ignore[method-assign]
    _application = QApplication(sys.argv[:1])
    screen = Screen(out)

    def window() -> MainWindow:
        return next(widget for widget in QApplication.topLevelWidgets() if isinstance(widget, MainWindow))

    def state(step: str) -> str:
        views = screen.look(lambda: window().known.views)
        return str(views[step].state) if step in views else ""

    def work_and_close() -> None:
        work(screen, state)
        screen.key("ctrl+q")

    with tempfile.TemporaryDirectory() as home:
        for name in ("HOME", "XDG_CONFIG_HOME", "XDG_DATA_HOME", "BELTCAL_HOME"):
            os.environ[name] = home
        return run_beside(lambda: application.run(sim=True, theme=theme, language=language), work_and_close)


if __name__ == "__main__":
    sys.exit(main())
