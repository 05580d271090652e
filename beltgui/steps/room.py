"""What every step's room offers to those who run the steps: engine, demonstration, replay."""

from __future__ import annotations

from dataclasses import dataclass, field
from typing import Any, Protocol, runtime_checkable

from beltgui.jobs import Job
from beltgui.session import Session
from beltgui.steps.context import Context
from beltgui.viewmodel.step import StepContent
from core.cad import CadModel
from core.cad.blade_type import BladeType
from core.verdict import Verdict
from devices.cell_plan import CellPlan


class Outcome(Protocol):
    """What a step found."""

    @property
    def verdict(self) -> Verdict:
        """Of all of it."""
        ...


@dataclass(eq=False)
class Bench:
    """What the steps stand on: the session with its samples, and what has been found so far.

    Attributes:
        session: Samples, settings, results.
        plan: What is known about the cell.
        blade: The blade's type.
        model: Its CAD model.
        date: For the programs' headers.
        found: Outcome of each solved step.
        cache: Costly values that depend on one sample alone, e.g. `("sphere", sample id)`; a room may put here what
            it likes under keys that begin with its own name.
    """

    session: Session
    plan: CellPlan
    blade: BladeType
    model: CadModel
    date: str
    found: dict[str, Any] = field(default_factory=dict)
    cache: dict[tuple[Any, ...], Any] = field(default_factory=dict)


class Room(Protocol):
    """One step.

    Settings of a step are read with `session.setting(step, key, default)`.
    """

    step: str

    def acquire(self, bench: Bench, context: Context) -> None:
        """Take the samples that are missing (none are taken twice) and keep each at once.

        Raises:
            DeviceError: a device failed or refused; what was taken before stays.
            Cancelled: the job was cancelled.
        """
        ...

    def solve(self, bench: Bench, job: Job) -> Outcome:
        """Solve from the samples that are there and included; the outcomes of earlier steps are in `bench.found`.

        Raises:
            InputError: the samples do not determine the result.
            Cancelled: the job was cancelled.
        """
        ...

    def record(self, outcome: Any) -> dict[str, Any]:
        """For the session, the report and replay."""
        ...

    def headline(self, outcome: Any) -> str:
        """The number that matters, one line with its unit."""
        ...

    def view(self, bench: Bench, outcome: Any | None, error: str = "") -> StepContent:
        """What the screen shows.

        Args:
            bench: Samples and earlier outcomes.
            outcome: Of this step; None before there is one.
            error: Why there is none, if solving was tried.
        """
        ...


@runtime_checkable
class Remembering(Protocol):
    """A room that remembers a choice beyond the session, e.g. the faces of a blade type."""

    def begin(self, bench: Bench, person: str) -> None:
        """A new session begins: take over what was remembered."""
        ...

    def accepted(self, bench: Bench) -> None:
        """The step's result was accepted: remember what it was made with."""
        ...
