"""What the screen knows: everything the engine has said that still holds. No widgets."""

from __future__ import annotations

from dataclasses import dataclass, field

from beltgui.engine.messages import (
    CellMoved,
    DevicesChanged,
    DeviceState,
    Event,
    JobEnded,
    JobProgress,
    JobStarted,
    Question,
    QuestionGone,
    SessionOpened,
    StepChanged,
)
from beltgui.steps.state import STEPS, StepState
from beltgui.viewmodel.step import StepView


@dataclass(eq=False)
class Known:
    """The latest of each kind.

    Attributes:
        session: The open one.
        views: By step.
        job: What runs.
        progress: Of it.
        question: What a person is asked.
        devices: In the strip.
        cell: Where robot and stage are.
    """

    session: SessionOpened | None = None
    views: dict[str, StepView] = field(default_factory=dict)
    job: JobStarted | None = None
    progress: JobProgress | None = None
    question: Question | None = None
    devices: tuple[DeviceState, ...] = ()
    cell: CellMoved | None = None

    def note(self, event: Event) -> None:
        """Take in what an event changes."""
        match event:
            case SessionOpened():
                self.session, self.views = event, {}
            case StepChanged(view=view):
                known = self.views.get(view.step)
                if known is None or known.generation <= view.generation:
                    self.views[view.step] = view
            case JobStarted():
                self.job, self.progress = event, None
            case JobProgress():
                self.progress = event
            case JobEnded():
                self.job = self.progress = self.question = None
            case Question():
                self.question = event
            case QuestionGone(number=number):
                if self.question is not None and self.question.number == number:
                    self.question = None
            case DevicesChanged(devices=devices):
                self.devices = devices
            case CellMoved():
                self.cell = event
            case _:
                pass  # nothing that lasts

    def engine_gone(self) -> None:
        """Nothing runs any more, nobody is asked, and of the devices there is no news; what was shown stays."""
        self.job = self.progress = self.question = self.cell = None
        self.devices = tuple(DeviceState(device.name, "stale") for device in self.devices)

    @property
    def moving(self) -> bool:
        """Work is under way or the robot moves."""
        return self.job is not None or (self.cell is not None and self.cell.moving)

    @property
    def read_only(self) -> bool:
        """The open session is only looked at."""
        return self.session is not None and self.session.read_only

    def not_accepted(self) -> tuple[StepView | str, ...]:
        """Steps that lock the export, in their order: the view, or the name of a step nothing is known of."""
        return tuple(
            self.views.get(step, step)
            for step in STEPS
            if step not in self.views or self.views[step].state is not StepState.ACCEPTED
        )
