"""The engine: takes commands, does one job at a time, tells what happens as events."""

from __future__ import annotations

import importlib
import threading
import traceback
from collections import deque
from collections.abc import Callable, Mapping
from pathlib import Path
from typing import Any

from beltgui import __version__
from beltgui.engine import messages as m
from beltgui.engine.guard import MotionGuard
from beltgui.engine.job import EngineJob
from beltgui.engine.person import Person
from beltgui.engine.tasks import Task, run_task
from beltgui.engine.workplace import BuildHost, Export, ReadModel, Workplace
from beltgui.steps.room import Room
from beltgui.steps.state import STEPS

Emit = Callable[[m.Event], None]
EDITS = (m.Include, m.Delete, m.StartOver, m.Undo, m.Redo, m.Choose)
JOIN_S = 5.0
WARM = "warm"
# What takes long to import, in portions of about a second.
HEAVY = ("beltgui.session.database", "devices.sim", "OCP.STEPControl", "open3d", "beltgui.steps.rooms")


class Engine:
    """One session, one cell, one job at a time.

    Commands may come from any thread, but one after another. Events are emitted from several threads, in order for
    each of them.

    Args:
        emit: Takes events; must not block for long.
        rooms: The steps; None takes the real ones (they are imported when a session is opened).
        build_host: Makes the cell of a session; None takes the simulation.
        read_model: Reads the CAD model; None takes the real reader.
        export: Writes programs and report; None takes the error surface's.
        warm_up: Import what a session needs before the first one is asked for; a command does not wait for all of it.

    Example:
        >>> engine = Engine(events.put)
        >>> engine.handle(NewSession("/tmp/session", "A. Person"))
        >>> engine.close()
    """

    def __init__(
        self,
        emit: Emit,
        *,
        rooms: Mapping[str, Room] | None = None,
        build_host: BuildHost | None = None,
        read_model: ReadModel | None = None,
        export: Export | None = None,
        warm_up: bool = False,
    ) -> None:
        self._emit = emit
        self._changed = threading.Condition()
        self._queue: deque[Task] = deque()
        self._current: Task | None = None
        self._number = 0
        self._closing = False
        self._guard = MotionGuard(lambda path, purpose: self._person.ask_motion(path, purpose))
        self._person = Person(emit, self._guard.answered)
        self._place = Workplace(
            emit, self._guard, self._person, rooms=rooms, build_host=build_host, read_model=read_model, export=export
        )
        self._worker = threading.Thread(target=self._work, name="engine work", daemon=True)
        self._worker.start()
        emit(m.Ready(__version__))
        for module in HEAVY if warm_up else ():
            self._submit(Task("Warming up", "", lambda job, module=module: _import(module), WARM, quiet=True))

    def handle(self, command: m.Command) -> None:
        """Carry out a command, or begin to; comes back at once."""
        match command:
            case m.Answer():
                self._person.answer(command)
            case m.Hold():
                self._guard.hold(command.down)
            case m.Stop():
                self._end_job("stopped")
            case m.Cancel():
                self._end_job("cancelled")
            case m.Shutdown():
                self._shut_down()
            case m.SimulateFault():
                self._simulate(command.name)
            case _:
                self._submit(self._task(command))

    def close(self, timeout_s: float = JOIN_S) -> bool:
        """Shut down and wait; whether all threads have ended in time."""
        self._shut_down()
        self._worker.join(timeout_s)
        return not self._worker.is_alive() and self._guard.join(timeout_s) and self._place.join(timeout_s)

    # ---- commands

    def _task(self, command: Any) -> Task:
        step = getattr(command, "step", "")
        place = self._place
        match command:
            case m.NewSession() | m.OpenSession():
                return Task("Opening the session", "", lambda job: place.open(command, job), "open")
            case m.Compare():
                return Task("Comparing", "", lambda job: place.compare(Path(command.folder)), "compare", place.unopened)
            case m.Export():
                return Task("Exporting", "error_surface", lambda job: place.export(Path(command.folder), job), "export",
                            place.why_not_export)  # fmt: skip
        if step not in STEPS:
            return Task("", step, lambda job: None, "", lambda: f"There is no step '{step}'.")
        match command:
            case m.Acquire():
                return Task("Taking samples", step, lambda job: place.acquire(step, job), "acquire",
                            lambda: place.why_not_acquire(step), motion=True)  # fmt: skip
            case m.Accept():
                return Task("Accepting", step, lambda job: place.accept(step), "accept",
                            lambda: place.why_not_accept(step), quiet=True)  # fmt: skip
            case m.Solve():
                return Task("Solving", step, lambda job: place.solve(step, job), "solve",
                            lambda: place.why_not_solve(step))  # fmt: skip
            case _:
                return Task("Solving", step, lambda job: place.edit(command, job), "edit", place.read_only)

    def _submit(self, task: Task) -> None:
        with self._changed:
            others = [*([self._current] if self._current else []), *self._queue]
            if task.kind != WARM:
                self._queue = deque(other for other in self._queue if other.kind != WARM)
            others = [other for other in others if not other.quiet]  # those are over before anybody notices
            in_the_way = [other for other in others if not _makes_way(other, task)]
            if not (in_the_way or self._closing):
                for other in others:
                    other.end("superseded")
                if not others:
                    self._guard.begin_job()
                    self._person.begin_job()
                self._number += 1
                task.job = EngineJob(self._number, self._progress(self._number))
                self._queue.append(task)
                self._changed.notify_all()
                return
        if in_the_way:
            title = in_the_way[0].title
            self._emit(m.Refused(f"'{title}' is under way. Wait for its end, or cancel it first."))

    def _simulate(self, fault: str) -> None:
        refusal = self._place.simulate(fault)
        if refusal:
            self._emit(m.Refused(refusal))
            return
        with self._changed:
            idle = self._current is None and not self._queue
        if idle:  # a job under way keeps the cell's state at its end
            self._submit(Task("Keeping the cell's state", "", lambda job: self._place.remember(), "fault", quiet=True))

    def _end_job(self, how: str) -> None:
        with self._changed:
            tasks = [*([self._current] if self._current else []), *self._queue]
        for task in tasks:
            task.end(how)
        if how == "stopped":
            self._guard.stop()
        else:
            self._guard.cancel()
        self._person.interrupt(how)

    def _shut_down(self) -> None:
        with self._changed:
            self._closing = True
            self._queue.clear()
            self._changed.notify_all()
        self._end_job("stopped")
        self._guard.close()

    # ---- work

    def _progress(self, number: int) -> Callable[[float, str], None]:
        return lambda fraction, text: self._emit(m.JobProgress(number, fraction, text))

    def _work(self) -> None:
        while (task := self._next()) is not None:
            run_task(task, self._emit, self._finished)
        try:
            self._place.close()
        except Exception:
            self._emit(m.Crashed(traceback.format_exc()))

    def _next(self) -> Task | None:
        with self._changed:
            self._changed.wait_for(lambda: self._queue or self._closing)
            self._current = None if self._closing else self._queue.popleft()
            return self._current

    def _finished(self) -> None:
        with self._changed:
            self._current = None


def _import(module: str) -> None:
    importlib.import_module(module)


def _makes_way(under_way: Task, task: Task) -> bool:
    """An edit ends the solving of the same step: it is solved again with the edit."""
    return task.kind == "edit" and under_way.kind in ("edit", "solve") and under_way.step == task.step
