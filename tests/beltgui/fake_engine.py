"""An engine that does nothing but note what it is told, and says what a test lets it say."""

from __future__ import annotations

from typing import Any

import numpy as np

from beltgui.app.client import Deliver, Ended, EngineClient
from beltgui.engine.messages import CellMoved, Command, Event, JobStarted, Ready, SessionOpened, StepChanged
from beltgui.steps.state import STEPS, StepState
from beltgui.viewmodel.step import Action, StepContent, StepView


class FakeBackend:
    """One engine; `say` and `die` may be called in any thread, as a real one would."""

    def __init__(self) -> None:
        self.commands: list[Command] = []
        self.closed = False

    def start(self, deliver: Deliver, ended: Ended) -> None:
        self._deliver, self._ended = deliver, ended

    def send(self, command: Command) -> None:
        self.commands.append(command)

    def close(self) -> None:
        self.closed = True

    def say(self, *events: Event) -> None:
        for event in events:
            self._deliver(event)

    def die(self, why: str = "") -> None:
        self._ended(why)

    def told(self, kind: type) -> list[Any]:
        """Commands of a kind, in order."""
        return [command for command in self.commands if isinstance(command, kind)]


class FakeEngine:
    """Client and backends; a new backend for each start."""

    def __init__(self) -> None:
        self.backends: list[FakeBackend] = []
        self.client = EngineClient(self._make)
        self.client.start()

    def _make(self) -> FakeBackend:
        self.backends.append(FakeBackend())
        return self.backends[-1]

    @property
    def now(self) -> FakeBackend:
        """The engine that runs."""
        return self.backends[-1]

    def say(self, *events: Event) -> None:
        self.now.say(*events)


def opened(folder: str = "/data/s1", *, read_only: bool = False) -> SessionOpened:
    return SessionOpened(folder, "Ada", read_only, {"blade_type": "dr95", "serial": "DR95-0007"})


def view(step: str, state: StepState = StepState.NOT_STARTED, headline: str = "", *, generation: int = 1,
         why: tuple[str, ...] = (), content: StepContent | None = None) -> StepView:  # fmt: skip
    return StepView(step, generation, state, headline, why, frozenset({Action.ACQUIRE}), content)


def all_views(state: StepState = StepState.NOT_STARTED, **others: StepState) -> list[StepChanged]:
    return [StepChanged(view(step, others.get(step, state))) for step in STEPS]


def moved(x_mm: float = 0.0, *, moving: bool = True) -> CellMoved:
    pose = np.eye(4)
    pose[0, 3] = x_mm
    return CellMoved(pose, (x_mm, 0.0, 0.0, 0.0), moving)


JOB = JobStarted(1, "Ball: take the samples", "ball", motion=True)
READY = Ready("0.1.0")
