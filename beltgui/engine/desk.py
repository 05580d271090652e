"""The open session as the engine works on it: outcomes, results kept, and what the screen is shown of each step."""

from __future__ import annotations

import traceback
from collections.abc import Callable, Mapping
from dataclasses import dataclass, field, replace

from beltgui.engine.job import EngineJob
from beltgui.engine.messages import Crashed, Event, StepChanged
from beltgui.jobs import Cancelled, Job
from beltgui.session import Basis, Sample
from beltgui.steps import graph
from beltgui.steps.blocks import plain
from beltgui.steps.room import Bench, Outcome, Remembering, Room
from beltgui.steps.state import STEPS, TITLES, StepState
from beltgui.viewmodel.step import Action, ReasonView, StepContent, StepView
from core.errors import InputError

# Steps that are solved again after each sample, so that a person sees the result grow.
PROVISIONAL = ("ball", "base", "tool")


@dataclass(eq=False)
class _Shown:
    """What the screen was shown of a step last."""

    generation: int = 0
    view: StepView | None = None
    content: StepContent | None = None


@dataclass(eq=False)
class Desk:
    """Everything here runs in the thread that does the work.

    Attributes:
        bench: Session, plan, blade, outcomes.
        rooms: The steps.
        person: Who works.
        emit: Shows events.
        has_cell: Samples can be taken.
        generations: Of the steps; handed on from session to session, so that they always grow.
    """

    bench: Bench
    rooms: Mapping[str, Room]
    person: str
    emit: Callable[[Event], None]
    has_cell: bool
    generations: dict[str, int]
    _shown: dict[str, _Shown] = field(default_factory=lambda: {step: _Shown() for step in STEPS})
    _result_ids: dict[str, int] = field(default_factory=dict)
    _acquiring: str = ""

    @property
    def writable(self) -> bool:
        """The session may be changed."""
        return self.bench.session.writable

    def begin(self) -> None:
        """A new session: rooms take over what they remember from earlier ones."""
        for room in self.rooms.values():
            if isinstance(room, Remembering):
                room.begin(self.bench, self.person)

    def restore(self, job: EngineJob) -> None:
        """Solve every step that has samples again, in order, and show each."""
        for number, step in enumerate(STEPS):
            part = job.part(number / len(STEPS), (number + 1) / len(STEPS), f"{TITLES[step]}: ")
            part.report(0.0, "solving again")
            if not self.bench.session.samples(step):
                self._put(step, self._view(step, None))
                continue
            try:
                self.solve(step, job, part)
            except Cancelled:
                raise
            except Exception:  # a fault in one step must not keep the others from being opened
                self.emit(Crashed(traceback.format_exc()))
                self._put(step, self._view(step, None, "A fault of the program ended the solving."))

    def leave_unsolved(self) -> None:
        """After a restoring that was ended early: show the samples of the steps that were not reached."""
        for step in STEPS:
            if self._shown[step].content is None:
                self._put(step, self._view(step, None, "It was not solved again. Solve it."))

    def acquire(self, step: str, work: Callable[[Callable[[Sample], None]], None], job: EngineJob) -> None:
        """Take samples by `work` and solve from them; what was taken stays, however it ends."""
        before = self.bench.found.pop(step, None)
        samples = len(self.bench.session.samples(step))
        self._acquiring = step
        self.show()
        try:
            work(lambda sample: self._on_sample(step, job))
        except BaseException:
            self._acquiring = ""
            if before is not None and len(self.bench.session.samples(step)) == samples:
                self.bench.found[step] = before
            else:
                self._result_ids.pop(step, None)
                self._put_provisional(step, Job())
            self.show()
            raise
        self._acquiring = ""
        self.solve(step, job)

    def solve(self, step: str, job: EngineJob, part: Job | None = None) -> None:
        """Solve a step from its samples, keep the result and show the step and what depends on it.

        Args:
            step: Of the six.
            job: That this is done for.
            part: Of the job that this is; None: all of it.
        """
        bench, room = self.bench, self.rooms[step]
        bench.found.pop(step, None)
        self._result_ids.pop(step, None)
        basis = bench.session.basis(step)
        missing = [TITLES[need] for need in graph.NEEDS[step] if need not in bench.found]
        outcome: Outcome | None = None
        error = f"{TITLES[step]} needs {' and '.join(missing)}, which has no result yet." if missing else ""
        if not missing:
            try:
                outcome = room.solve(bench, part or job)
            except InputError as refusal:
                error = str(refusal)
            except Cancelled:
                if job.ending != "superseded":
                    self._put(step, self._view(step, None, "The solving was ended early. Solve again."))
                raise
        if outcome is not None:
            bench.found[step] = outcome
            self._result_ids[step] = self._keep(step, outcome, basis)
        self._put(step, self._view(step, outcome, error))

    def look_again(self, step: str) -> None:
        """A setting changed that only the picture depends on."""
        self._put(step, self._view(step, self.bench.found.get(step)))

    def why_not_accept(self, step: str) -> str:
        """A sentence if the result shown may not be accepted; else empty."""
        outcome = self.bench.found.get(step)
        if outcome is None or step not in self._result_ids:
            return f"{TITLES[step]} has no result to accept. Solve it first."
        if not outcome.verdict.ok:
            return f"{TITLES[step]} was rejected and cannot be accepted. {outcome.verdict.reasons[0].message}"
        latest, accepted = self.bench.session.result(step), self.bench.session.accepted_result(step)
        shown = self._result_ids[step]
        if accepted is not None and accepted.id == shown:
            return f"{TITLES[step]} is accepted already."
        if latest is None or latest.id != shown:
            return f"{TITLES[step]} was solved again meanwhile. Solve it once more and look at the result."
        return " ".join(graph.acceptance_lock(self.bench.session, step))

    def accept(self, step: str) -> None:
        """Accept the result shown; ask `why_not_accept` first."""
        self.bench.session.accept(step, self.person)
        room = self.rooms[step]
        if isinstance(room, Remembering):
            room.accepted(self.bench)
        self.show()

    def show(self) -> None:
        """Show every step whose state, actions or content changed."""
        standings = graph.standing(self.bench.session)
        locked = bool(graph.export_lock(self.bench.session))
        for step in STEPS:
            standing, shown = standings[step], self._shown[step]
            running = step == self._acquiring
            content = shown.content
            headline = content.headline if running and content is not None else standing.headline
            view = StepView(
                step, 0, StepState.RUNNING if running else standing.state, headline, standing.why,
                frozenset() if running else self._actions(step, standing, locked), content,
            )  # fmt: skip
            if shown.view is None or _key(shown.view) != _key(view):
                self.generations[step] = self.generations.get(step, 0) + 1
                shown.view = view
                self.emit(StepChanged(replace(view, generation=self.generations[step])))

    def _actions(self, step: str, standing: graph.Standing, locked: bool) -> frozenset[Action]:
        """What the session allows; while a job runs the screen offers less, and the engine refuses it anyway."""
        session, content = self.bench.session, self._shown[step].content
        found: set[Action] = set()
        if content is None:
            return frozenset()
        if step == "error_surface" and not locked and step in self.bench.found:
            found.add(Action.EXPORT)
        if not self.writable:
            return frozenset(found)
        there = bool(session.samples(step))
        if self.has_cell and standing.can_begin and not content.complete:
            found.add(Action.ACQUIRE)
        if there:
            found |= {Action.SOLVE, Action.START_OVER}
        if not self.why_not_accept(step):
            found.add(Action.ACCEPT)
        if session.can_undo(step):
            found.add(Action.UNDO)
        if session.can_redo(step):
            found.add(Action.REDO)
        return frozenset(found)

    def _keep(self, step: str, outcome: Outcome, basis: Basis) -> int:
        """Number of the stored result that says this; it is stored unless there is one of the very same data."""
        session, room, ok = self.bench.session, self.rooms[step], outcome.verdict.ok
        stands_on = {need: self._result_ids[need] for need in graph.NEEDS[step] if need in self._result_ids}
        for stored in (session.accepted_result(step), session.result(step)):
            if stored is not None and basis.fits(stored) and stored.stands_on == stands_on and stored.ok == ok:
                return stored.id
        if not self.writable:
            return 0
        return session.put_result(
            step, plain(room.record(outcome)), ok=ok, headline=room.headline(outcome), stands_on=stands_on,
            basis=basis, person=self.person,
        ).id  # fmt: skip

    def _on_sample(self, step: str, job: EngineJob) -> None:
        self._put_provisional(step, job.silent())

    def _put_provisional(self, step: str, job: Job) -> None:
        """What the samples so far say; that some are missing is no failure."""
        bench, room = self.bench, self.rooms[step]
        outcome, error = None, ""
        if step in PROVISIONAL and bench.session.samples(step):
            try:
                outcome = room.solve(bench, job)
            except InputError as missing:
                error = str(missing)
        self._put(step, replace(self._view(step, outcome, error), provisional=True))

    def _view(self, step: str, outcome: Outcome | None, error: str = "") -> StepContent:
        """What the room shows; a fault in a picture is told and does not end the work."""
        try:
            return self.rooms[step].view(self.bench, outcome, error)
        except Exception:
            self.emit(Crashed(traceback.format_exc()))
            return StepContent(reasons=(ReasonView("CRASHED", "A fault of the program: this step cannot be shown."),))

    def _put(self, step: str, content: StepContent) -> None:
        self._shown[step].content = content
        self.show()


def _key(view: StepView) -> tuple[object, ...]:
    return (view.state, view.headline, view.why, view.actions, id(view.content))
