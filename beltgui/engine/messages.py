"""What the screen asks of the engine (commands) and what the engine tells the screen (events); plain picklable data."""

from __future__ import annotations

from collections.abc import Hashable
from dataclasses import dataclass, field
from typing import Any

import numpy as np
from numpy.typing import NDArray

from beltgui.viewmodel.step import StepView

Array = NDArray[np.float64]


# ---- commands


@dataclass(frozen=True)
class NewSession:
    """Begin a session in a folder that holds none.

    Attributes:
        folder: For the session.
        person: Who works.
        blade_type: Name of the blade type.
        serial: Of the blade.
        cell_file: None takes the simulated cell's own.
        seed: Of the simulated cell.
        resolution: Of the simulated scanner.
        speed: How many times faster than real time the simulated cell runs; 0 is instantly.
        grid: Probing points in u and v; None takes the blade type's own.
    """

    folder: str
    person: str
    blade_type: str = "dr95"
    serial: str = ""
    cell_file: str | None = None
    seed: int = 0
    resolution: int | str = "demo"
    speed: float = 20.0
    grid: tuple[int, int] | None = None


@dataclass(frozen=True)
class OpenSession:
    """Go on with a session, or look at it."""

    folder: str
    person: str
    read_only: bool = False


@dataclass(frozen=True)
class Compare:
    """Compare the open session's results with another session's."""

    folder: str


@dataclass(frozen=True)
class Acquire:
    """Take the samples of a step that are missing."""

    step: str


@dataclass(frozen=True)
class Solve:
    """Solve a step again from its samples."""

    step: str


@dataclass(frozen=True)
class Accept:
    """Accept a step's result; refused unless its verdict is ok."""

    step: str


@dataclass(frozen=True)
class Include:
    """Tick or untick a sample; the step is solved again at once."""

    step: str
    sample_id: int
    on: bool


@dataclass(frozen=True)
class Delete:
    """Delete one sample (undo brings it back)."""

    step: str
    sample_id: int


@dataclass(frozen=True)
class StartOver:
    """Delete all samples of a step (undo brings them back)."""

    step: str


@dataclass(frozen=True)
class Undo:
    """Take back the last edit of a step."""

    step: str


@dataclass(frozen=True)
class Redo:
    """Do again what was taken back."""

    step: str


@dataclass(frozen=True)
class Choose:
    """Set a step's setting: `faces` (fine), `pairs` and `method` (rough), `grinder` (error surface).

    None takes the choice back. Settings that begin with `show_` only change the picture.
    """

    step: str
    key: str
    value: Any


@dataclass(frozen=True)
class Export:
    """Write the robot programs and the report to a folder; refused while anything is stale or not accepted."""

    folder: str


@dataclass(frozen=True)
class Answer:
    """What a person says to a `Question`.

    Attributes:
        question: Its number.
        yes: Done, or go.
        hold: The motion runs only while the button is held (`Hold`).
        for_series: The same answer for the following motions of this step.
    """

    question: int
    yes: bool
    hold: bool = False
    for_series: bool = False


@dataclass(frozen=True)
class Hold:
    """The hold-to-run button is down or has been let go.

    An `Answer` with `hold` says that it is down. Repeated while it is held (several times a second), it also shows that
    the screen is alive: once repeated, it counts as let go when nothing came for 0.6 s.
    """

    down: bool


@dataclass(frozen=True)
class Stop:
    """Stop every motion at once and end the work."""


@dataclass(frozen=True)
class Cancel:
    """End the work at its next report; a motion under way is stopped."""


@dataclass(frozen=True)
class SimulateFault:
    """Let something go wrong in the simulated cell (training): see `beltgui.engine.faults` for the names."""

    name: str


@dataclass(frozen=True)
class Shutdown:
    """Stop everything and end."""


Command = (
    NewSession | OpenSession | Compare | Acquire | Solve | Accept | Include | Delete | StartOver | Undo | Redo
    | Choose | Export | Answer | Hold | Stop | Cancel | SimulateFault | Shutdown
)  # fmt: skip


# ---- events


@dataclass(frozen=True)
class Ready:
    """The engine runs and takes commands."""

    software: str


@dataclass(frozen=True)
class SessionOpened:
    """A session is open; `info` is what it says of itself."""

    folder: str
    person: str
    read_only: bool
    info: dict[str, Any]


@dataclass(frozen=True, eq=False)
class StepChanged:
    """A step as it is now."""

    view: StepView


@dataclass(frozen=True)
class JobStarted:
    """Work has begun; one at a time. `motion` tells that the robot may move in it."""

    job: int
    title: str
    step: str
    motion: bool


@dataclass(frozen=True)
class JobProgress:
    """How far the work is (0 to 1)."""

    job: int
    fraction: float
    text: str


@dataclass(frozen=True)
class JobEnded:
    """The work is over.

    Attributes:
        job: Its number.
        how: `done`, `cancelled`, `stopped`, `refused` (something a person can act on) or `crashed` (a fault of the
            program).
        message: A sentence; for `crashed` with the traceback.
    """

    job: int
    how: str
    message: str = ""


@dataclass(frozen=True, eq=False)
class Question:
    """The work waits for a person.

    Attributes:
        number: Of the question.
        kind: `mount`, `touch` or `motion`.
        picture: Key of the picture: `mount ball`, `mount blade`, `mount stylus`, `mount nothing`, `touch cone`,
            `touch shaft`, `motion`.
        text: The instruction.
        path: (n, 4, 4) base_from_flange of the motion; None without one.
        length_mm: Of the motion.
        duration_s: Of the motion.
        speed_mm_s: The largest of the motion.
        done: How many of the kind have been answered in this job.
        planned: How many are planned; 0 if not known.
    """

    number: int
    kind: str
    picture: str
    text: str
    path: Array | None = None
    length_mm: float = 0.0
    duration_s: float = 0.0
    speed_mm_s: float = 0.0
    done: int = 0
    planned: int = 0


@dataclass(frozen=True)
class QuestionGone:
    """The question has been answered or is void."""

    number: int


@dataclass(frozen=True)
class DeviceState:
    """One device in the strip.

    Attributes:
        name: `scanner`, `stage`, `robot`, `grinder rough`, `grinder fine`.
        state: `connected`, `simulated`, `waiting`, `stale`, `fault`.
        detail: E.g. since when, or the error's sentence.
    """

    name: str
    state: str
    detail: str = ""


@dataclass(frozen=True)
class DevicesChanged:
    """The strip of devices."""

    devices: tuple[DeviceState, ...]


@dataclass(frozen=True, eq=False)
class CellMoved:
    """Where robot and stage are now; several times a second while something moves.

    Attributes:
        base_from_flange: (4, 4).
        stage: x, y, z in mm, theta in deg.
        moving: The robot is on its way.
        speed_mm_s: Of the flange.
        head_deg: By grinder.
        force_n: By grinder.
    """

    base_from_flange: Array
    stage: tuple[float, float, float, float]
    moving: bool
    speed_mm_s: float = 0.0
    head_deg: dict[str, float] = field(default_factory=dict)
    force_n: dict[str, float] = field(default_factory=dict)


@dataclass(frozen=True)
class Refused:
    """A command was not carried out; a sentence."""

    text: str


@dataclass(frozen=True)
class Exported:
    """What was written."""

    files: tuple[str, ...]


@dataclass(frozen=True)
class ComparedRow:
    """One number in two sessions; `moved` in `unit`, with the chance k = 2 of both where known."""

    step: str
    what: str
    here: float | None
    there: float | None
    moved: float | None
    unit: str
    chance: float | None = None


@dataclass(frozen=True)
class Compared:
    """Two sessions side by side."""

    folder: str
    rows: tuple[ComparedRow, ...]


@dataclass(frozen=True)
class Crashed:
    """A fault of the program outside a job, with its traceback; or the engine's end."""

    text: str


Event = (
    Ready | SessionOpened | StepChanged | JobStarted | JobProgress | JobEnded | Question | QuestionGone
    | DevicesChanged | CellMoved | Refused | Exported | Compared | Crashed
)  # fmt: skip


def replaces(event: Event) -> Hashable | None:
    """Key of an event that only its newest kind matters of while it waits to be told; None is told in any case."""
    match event:
        case CellMoved():
            return "cell moved"
        case JobProgress():
            return ("progress", event.job)
        case StepChanged():
            return ("step", event.view.step)
        case _:
            return None
