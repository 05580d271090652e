"""The six steps in one go, samples in, calibrated cell and robot programs out; live and replayed alike."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, field
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

from beltgui.jobs import Cancelled, Job
from beltgui.steps.room import Bench, Room
from beltgui.steps.rooms import ROOMS
from beltgui.steps.scans import read_scans
from beltgui.steps.state import STEPS, TITLES, StepEvent, StepState
from core.verdict import Verdict

if TYPE_CHECKING:
    from beltgui.steps.ball.step import BallOutcome
    from beltgui.steps.base.step import BaseOutcome
    from beltgui.steps.error_surface.step import ErrorSurfaceOutcome, Program
    from beltgui.steps.fine.step import FineOutcome
    from beltgui.steps.rough.step import RoughOutcome
    from beltgui.steps.tool.step import ToolOutcome

Acquire = Callable[[Room, Job], None]
Keep = Callable[[str, Mapping[str, Any], str, bool], None]
Listener = Callable[[StepEvent], None]
# Share of the whole time, roughly, at which each step begins.
BEGINS = {"ball": 0.0, "base": 0.15, "rough": 0.3, "fine": 0.45, "tool": 0.52, "error_surface": 0.55}
ENDS = dict(zip(BEGINS, [*list(BEGINS.values())[1:], 1.0], strict=True))


@dataclass(frozen=True, eq=False)
class Commissioning:
    """What has been found on a bench so far; a step that was not reached is None."""

    bench: Bench

    @property
    def ball(self) -> BallOutcome | None:
        """Scanner on its stage."""
        return self.bench.found.get("ball")

    @property
    def base(self) -> BaseOutcome | None:
        """Measuring frame in the robot's base."""
        return self.bench.found.get("base")

    @property
    def rough(self) -> RoughOutcome | None:
        """First pose of the blade."""
        return self.bench.found.get("rough")

    @property
    def fine(self) -> FineOutcome | None:
        """The blade's frame."""
        return self.bench.found.get("fine")

    @property
    def tool(self) -> ToolOutcome | None:
        """Stylus and wheels."""
        return self.bench.found.get("tool")

    @property
    def error_surface(self) -> ErrorSurfaceOutcome | None:
        """Normal error over the airfoil, with the programs."""
        return self.bench.found.get("error_surface")

    @property
    def programs(self) -> Mapping[str, Program]:
        """Robot programs by name; none unless the error surface was accepted."""
        return self.error_surface.programs if self.error_surface is not None else {}

    def scan_points(self) -> NDArray[np.float64]:
        """(N, 3) scans of the fine step in {M}, mm; read from the session.

        Raises:
            InputError: a cloud is gone or damaged.
        """
        from beltgui.steps.fine.step import in_measure

        assert self.ball is not None
        return np.concatenate(in_measure(read_scans(self.bench.session, "fine"), self.ball.stage))

    @property
    def verdicts(self) -> dict[str, Verdict]:
        """The verdict of each step that was reached."""
        return {step: self.bench.found[step].verdict for step in STEPS if step in self.bench.found}

    @property
    def accepted(self) -> bool:
        """True if all six steps were reached and accepted."""
        return len(self.verdicts) == len(STEPS) and all(verdict.ok for verdict in self.verdicts.values())


@dataclass(frozen=True, eq=False)
class Commissioner:
    """Runs the steps; a rejected step ends the run, because everything after it would stand on it.

    Attributes:
        bench: The session and what is known; outcomes are put there step by step.
        acquire: Takes a step's samples; None where the session has them already.
        job: Progress and cancel.
        keep: Called with each step's name, record, headline and whether it was accepted.
        on_step: Called when a step changes its state.
        rooms: The steps.
    """

    bench: Bench
    acquire: Acquire | None
    job: Job
    keep: Keep
    on_step: Listener
    rooms: Mapping[str, Room] = field(default_factory=lambda: ROOMS)

    def run(self, only: Sequence[str] = STEPS) -> Commissioning:
        """All steps, until one is rejected.

        Args:
            only: Names of the first steps, to end early.

        Raises:
            InputError: the samples of a step do not determine its result.
            DeviceError: a device failed or refused.
            Cancelled: the job was cancelled.
        """
        found = Commissioning(self.bench)
        for step, room in self.rooms.items():
            if step not in only:
                return found
            self.on_step(StepEvent(step, StepState.RUNNING))
            self.job.report(BEGINS[step], TITLES[step])
            try:
                verdict, headline = self._run_step(room)
            except Cancelled:
                self.on_step(StepEvent(step, StepState.NOT_STARTED, "cancelled"))
                raise
            except Exception as error:
                self.on_step(StepEvent(step, StepState.FAILED, str(error)))
                raise
            if not verdict.ok:
                self.on_step(StepEvent(step, StepState.FAILED, verdict.reasons[0].message))
                return found
            self.on_step(StepEvent(step, StepState.ACCEPTED, headline))
        self.job.report(1.0, "done")
        return found

    def _run_step(self, room: Room) -> tuple[Verdict, str]:
        work = self.job.part(BEGINS[room.step], ENDS[room.step], f"{TITLES[room.step]}: ")
        if self.acquire is not None:
            self.acquire(room, work.part(0.0, 0.9))
        outcome = room.solve(self.bench, work.part(0.9, 1.0))
        self.bench.found[room.step] = outcome
        headline = room.headline(outcome)
        self.keep(room.step, room.record(outcome), headline, outcome.verdict.ok)
        return outcome.verdict, headline
