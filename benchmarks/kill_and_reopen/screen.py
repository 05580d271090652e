"""A stand-in for the window: hands commands on to its engine, says yes to each question, prints what it is told.

Commands come as JSON, one in a line: `["NewSession", {"folder": ...}]`, or `["start", {}]` for another engine. What is
printed is what a person was shown, as JSON, one event in a line: whoever kills this has it until the last whole line.
"""

from __future__ import annotations

import json
import os
import sys
import threading
from typing import Any

from beltgui.engine import messages as m
from beltgui.engine.process import EngineHandle, start_engine

_printing = threading.Lock()


def tell(what: str, **words: Any) -> None:
    """Print one event."""
    with _printing:
        sys.stdout.write(json.dumps({"what": what, **words}) + "\n")
        sys.stdout.flush()


class Screen:
    """The engine's other end."""

    def __init__(self) -> None:
        self._engine: EngineHandle | None = None

    def start(self) -> None:
        """Another engine in place of one that is gone."""
        if self._engine is not None:
            self._engine.kill()
        self._engine = start_engine(self._take, lambda why: tell("gone", why=why))
        tell("engine", pid=self._engine.pid, screen=os.getpid())

    def send(self, name: str, words: dict[str, Any]) -> None:
        """A command of the engine by its name."""
        assert self._engine is not None
        self._engine.send(getattr(m, name)(**words))

    def close(self) -> None:
        """Shut the engine down."""
        if self._engine is not None:
            self._engine.close()

    def _take(self, event: m.Event) -> None:
        match event:
            case m.Question():
                self.send("Answer", {"question": event.number, "yes": True})
            case m.StepChanged():
                view = event.view
                content = view.content
                tell(
                    "step", step=view.step, state=str(view.state), actions=sorted(view.actions),
                    rows=[[row.id, row.included] for row in content.rows] if content is not None else [],
                    complete=content is not None and content.complete, restored=content is not None,
                    reasons=[reason.message for reason in content.reasons] if content is not None else [],
                )  # fmt: skip
            case m.JobStarted():
                tell("begun", job=event.job, title=event.title)
            case m.JobEnded():
                tell("ended", job=event.job, how=event.how, message=event.message)
            case m.Ready() | m.SessionOpened():
                tell(type(event).__name__)
            case m.Exported():
                tell("exported", files=event.files)
            case m.Refused() | m.Crashed():
                tell(type(event).__name__, text=event.text)


def main() -> None:
    """Until the input ends."""
    screen = Screen()
    try:
        for line in sys.stdin:
            name, words = json.loads(line)
            if name == "start":
                screen.start()
            else:
                screen.send(name, words)
    finally:
        screen.close()


if __name__ == "__main__":
    main()
