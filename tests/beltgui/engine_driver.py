"""Runs an engine, in this process or in one of its own, answers its questions and waits for its events."""

import threading
import time
from collections.abc import Callable
from typing import Any, Self

from beltgui.engine.engine import Engine
from beltgui.engine.messages import (
    Answer,
    CellMoved,
    Command,
    Crashed,
    Event,
    JobEnded,
    JobStarted,
    Question,
    Ready,
    StepChanged,
)
from beltgui.engine.process import EngineHandle, start_engine
from beltgui.viewmodel.step import StepView

Predicate = Callable[[Event], bool]
YES = lambda question: Answer(question.number, True)  # noqa: E731


class Driver:
    """One engine; leave it as a context.

    Attributes:
        events: All so far.
        views: What was shown of each step last.
    """

    def __init__(
        self, *, process: bool = False, answer: Callable[[Question], Answer | None] = YES, **engine: Any
    ) -> None:
        self.answer = answer
        self.events: list[Event] = []
        self.views: dict[str, StepView] = {}
        self.end = ""
        self._seen = 0
        self._changed = threading.Condition()
        self.handle: EngineHandle | None = start_engine(self._take, self._ended) if process else None
        self.engine = None if process else Engine(self._take, **engine)
        self.wait_for(lambda event: isinstance(event, Ready))

    def __enter__(self) -> Self:
        return self

    def __exit__(self, *exception: object) -> None:
        self.close()

    def send(self, command: Command) -> None:
        if self.engine is not None:
            self.engine.handle(command)
        else:
            assert self.handle is not None
            assert self.handle.send(command)

    def wait_for(self, wanted: type | Predicate, timeout_s: float = 60.0) -> Any:
        """The first event after the last one waited for that fits; a crash on the way is an error unless wanted."""
        fits = (lambda event: isinstance(event, wanted)) if isinstance(wanted, type) else wanted
        until = time.monotonic() + timeout_s
        with self._changed:
            while True:
                while self._seen < len(self.events):
                    event = self.events[self._seen]
                    self._seen += 1
                    if fits(event):
                        return event
                    assert not isinstance(event, Crashed), event.text
                    assert not (isinstance(event, JobEnded) and event.how == "crashed"), event.message
                left = until - time.monotonic()
                if left <= 0 or self.end:
                    raise TimeoutError(self._late())
                self._changed.wait(left)

    def somewhere(self, wanted: Predicate, timeout_s: float = 60.0) -> Any:
        """An event that fits, whether it has come already or is still to come."""
        with self._changed:
            found: list[Event] = []

            def there() -> bool:
                found[:] = [event for event in self.events if wanted(event)][:1]
                return bool(found)

            if not self._changed.wait_for(there, timeout_s):
                raise TimeoutError(self._late())
            return found[0]

    def work(self, command: Command, timeout_s: float = 60.0) -> JobEnded:
        """Send a command that is a job and wait for its end."""
        self.send(command)
        job = self.wait_for(JobStarted, timeout_s).job
        return self.wait_for(lambda event: isinstance(event, JobEnded) and event.job == job, timeout_s)

    def view(self, step: str, wanted: Callable[[StepView], bool], timeout_s: float = 60.0) -> StepView:
        """Wait until a step is shown as wanted."""
        until = time.monotonic() + timeout_s
        with self._changed:
            while not (step in self.views and wanted(self.views[step])):
                left = until - time.monotonic()
                if left <= 0 or self.end:
                    raise TimeoutError(f"{step}: {self._late()}")
                self._changed.wait(left)
            return self.views[step]

    def of(self, kind: type) -> list[Any]:
        """All events of a kind so far."""
        with self._changed:
            return [event for event in self.events if isinstance(event, kind)]

    def close(self) -> None:
        if self.engine is not None:
            assert self.engine.close(20.0), "a thread of the engine has not ended"
        elif self.handle is not None:
            self.handle.close()

    def _late(self) -> str:
        """What came last, in short: views hold pictures."""
        last = [type(e).__name__ if isinstance(e, StepChanged | CellMoved) else str(e)[:300] for e in self.events[-12:]]
        return f"no such event. {self.end} The last ones: {last}"

    def _take(self, event: Event) -> None:
        with self._changed:
            self.events.append(event)
            if isinstance(event, StepChanged):
                self.views[event.view.step] = event.view
            self._changed.notify_all()
        if isinstance(event, Question):
            said = self.answer(event)
            if said is not None:
                self.send(said)

    def _ended(self, text: str) -> None:
        with self._changed:
            self.end = text
            self._changed.notify_all()
