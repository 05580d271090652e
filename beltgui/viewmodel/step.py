"""What the wizard shows of one step."""

from __future__ import annotations

from dataclasses import dataclass, field
from enum import StrEnum
from typing import Any

from beltgui.steps.state import StepState
from beltgui.viewmodel.plot import Plot
from beltgui.viewmodel.scene import Scene


class Use(StrEnum):
    """What a sample is used for."""

    FIT = "fit"
    HELD_OUT = "held out"
    CHECK = "check"
    EXCLUDED = "excluded"


class Action(StrEnum):
    """What a person may do with a step now; what is not offered is disabled."""

    ACQUIRE = "acquire"
    SOLVE = "solve"
    ACCEPT = "accept"
    UNDO = "undo"
    REDO = "redo"
    START_OVER = "start over"
    EXPORT = "export"


@dataclass(frozen=True)
class Column:
    """A column of the table of samples; `unit` is shown in its head; `decimals` None for text."""

    key: str
    title: str
    unit: str = ""
    decimals: int | None = 3


@dataclass(frozen=True)
class SampleRow:
    """One sample.

    Attributes:
        id: Of the sample in the session.
        name: As a person calls it.
        cells: One value for each of the step's columns; None is shown as a dash.
        use: What it is used for.
        included: The tick box.
        flag: Empty, or in one word why it stands out: `worst`, `outlier`, `refused`.
        note: One sentence for the tool tip, e.g. why it was refused.
        can_exclude: False where a sample cannot be left out alone.
    """

    id: int
    name: str
    cells: tuple[float | str | None, ...]
    use: Use
    included: bool = True
    flag: str = ""
    note: str = ""
    can_exclude: bool = True


@dataclass(frozen=True)
class Number:
    """A result's number.

    Attributes:
        label: What it is, with its frame where it has one.
        value: In `unit`; None is shown as a dash.
        unit: mm, deg, µm ... Empty only for counts and ratios.
        plus_minus: k = 2, in the same unit; None where it has none (a limit, a count, an RMS).
        decimals: Shown.
        limit: The largest allowed value, where there is one: drawn as a bar.
        main: One of the few numbers that matter.
    """

    label: str
    value: float | None
    unit: str
    plus_minus: float | None = None
    decimals: int = 3
    limit: float | None = None
    main: bool = False


@dataclass(frozen=True)
class ReasonView:
    """Why a verdict is what it is, and what to do."""

    code: str
    message: str


@dataclass(frozen=True)
class Check:
    """A check on data that the fit has not seen; `ok` None while it is not known yet."""

    what: str
    value: float | None
    unit: str
    limit: float | None
    count: int
    ok: bool | None


@dataclass(frozen=True)
class Suggestion:
    """The next best pose or touch: what to do, and what it would improve (from, to, unit)."""

    text: str
    improves: str = ""


@dataclass(frozen=True, eq=False)
class StepContent:
    """What a step's room says of itself.

    Attributes:
        columns: Of the table.
        rows: Samples in order of time.
        numbers: Of the result; empty before there is one.
        ok: Verdict; None before there is one.
        reasons: Of the verdict; while there is no result, why not (what is missing).
        remarks: Sentences worth knowing that do not reject.
        checks: On held-out data.
        suggestion: What to do next for a better result; None if there is nothing to gain.
        progress: Samples taken and planned, e.g. `12 of 20 scans`.
        complete: All planned samples are there.
        provisional: Solved from what is there so far, to be shown but not accepted.
        headline: One line with the number that matters.
        scene: The 3D picture.
        second_scene: The CAD side by side with the scan (rough step); None otherwise.
        plots: The tabs below.
        extra: Data of this step's own panel, see the step's view module.
    """

    columns: tuple[Column, ...] = ()
    rows: tuple[SampleRow, ...] = ()
    numbers: tuple[Number, ...] = ()
    ok: bool | None = None
    reasons: tuple[ReasonView, ...] = ()
    remarks: tuple[str, ...] = ()
    checks: tuple[Check, ...] = ()
    suggestion: Suggestion | None = None
    progress: str = ""
    complete: bool = False
    provisional: bool = False
    headline: str = ""
    scene: Scene | None = None
    second_scene: Scene | None = None
    plots: tuple[Plot, ...] = ()
    extra: dict[str, Any] = field(default_factory=dict)


@dataclass(frozen=True, eq=False)
class StepView:
    """A step as it is shown.

    Attributes:
        step: Its name.
        generation: Grows with every change of the step; a view with a smaller one is out of date and dropped.
        state: On the rail.
        headline: On the rail, one line.
        why: Why it is stale or failed or cannot begin: sentences.
        actions: What a person may do now.
        content: What the room says; None while the session is being restored.
    """

    step: str
    generation: int
    state: StepState
    headline: str
    why: tuple[str, ...]
    actions: frozenset[Action]
    content: StepContent | None
