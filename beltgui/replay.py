"""Computes a recorded session again from its samples and says where the results differ from those it kept."""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping
from dataclasses import dataclass, replace
from pathlib import Path
from typing import Any

from beltgui.commissioning import Commissioner, Commissioning
from beltgui.jobs import Job
from beltgui.session import INPUTS, Session
from beltgui.steps.blocks import plain
from beltgui.steps.room import Bench
from beltgui.steps.state import STEPS
from core.cad import read_step
from core.cad.blade_type import BladeType, read_blade_type
from core.errors import InputError
from devices.cell_plan import CellFileError, read_plan

# Other processors add in another order; what differs by more is another result.
ABSOLUTE, RELATIVE = 1e-6, 1e-6
MOST_DIFFERENCES = 20


@dataclass(frozen=True)
class Difference:
    """One field that came out differently."""

    field: str
    recorded: Any
    now: Any


@dataclass(frozen=True)
class ReplayedStep:
    """One step computed again.

    Attributes:
        step: Its name.
        accepted: Verdict now.
        differences: At most 20 fields that differ from what was kept.
        differing_fields: How many differ in all.
    """

    step: str
    accepted: bool
    differences: tuple[Difference, ...]
    differing_fields: int

    @property
    def same(self) -> bool:
        """True if every number came out again."""
        return self.differing_fields == 0


@dataclass(frozen=True, eq=False)
class Replay:
    """A session computed again.

    Attributes:
        info: What the session says of itself.
        steps: In the order of the work, as far as the session goes.
        found: The outcomes.
        inputs: Files that were read.
    """

    info: Mapping[str, Any]
    steps: tuple[ReplayedStep, ...]
    found: Commissioning
    inputs: tuple[Path, ...]

    @property
    def same(self) -> bool:
        """True if all results came out again."""
        return all(step.same for step in self.steps)


def replay_session(folder: Path, job: Job | None = None) -> Replay:
    """Compute all steps of a session again.

    Args:
        folder: Of the session.
        job: Progress and cancel.

    Raises:
        InputError: no session, an input is missing, no step was finished, or a sample cannot be read.
    """
    with Session.open(folder) as session:
        info = session.info()
        kept = {step: stored for step in STEPS if (stored := session.result(step)) is not None}
        if not kept:
            raise InputError(f"{folder}: the session has no finished step, there is nothing to compare with.")
        inputs = folder / INPUTS
        blade_file, cell_file = inputs / _text(info, "blade", folder), inputs / _text(info, "cell", folder)
        blade = _as_probed(read_blade_type(blade_file), info)
        try:
            plan = read_plan(cell_file)
        except CellFileError as error:
            raise InputError(str(error)) from error
        steps: list[ReplayedStep] = []

        def compare(step: str, record: Mapping[str, Any], headline: str, accepted: bool) -> None:
            found = list(_differences(kept[step].record, plain(record), ""))
            steps.append(ReplayedStep(step, accepted, tuple(found[:MOST_DIFFERENCES]), len(found)))

        bench = Bench(session, plan, blade, read_step(blade.step_path), _text(info, "date", folder))
        outcomes = Commissioner(bench, None, job or Job(), compare, lambda event: None).run(only=tuple(kept))
    return Replay(info, tuple(steps), outcomes, (folder / "session.db", blade_file, cell_file, blade.step_path))


def _as_probed(blade: BladeType, info: Mapping[str, Any]) -> BladeType:
    """The type with the grid that was probed: the programs' strokes lie on its lines."""
    if "probing_grid" not in info:
        return blade
    u_count, v_count = info["probing_grid"]
    return replace(blade, probing=replace(blade.probing, u_count=u_count, v_count=v_count))


def _text(info: Mapping[str, Any], key: str, folder: Path) -> str:
    value = info.get(key)
    if not isinstance(value, str):
        raise InputError(f"{folder}: the session does not say its {key}. It was not written by a commissioning.")
    return value


def _differences(recorded: Any, now: Any, field: str) -> Iterator[Difference]:
    if isinstance(recorded, dict) and isinstance(now, dict):
        for key in sorted(recorded.keys() | now.keys()):
            yield from _differences(recorded.get(key), now.get(key), f"{field}.{key}" if field else key)
    elif isinstance(recorded, list) and isinstance(now, list) and len(recorded) == len(now):
        for index, (before, after) in enumerate(zip(recorded, now, strict=True)):
            yield from _differences(before, after, f"{field}[{index}]")
    elif not _same(recorded, now):
        yield Difference(field, recorded, now)


def _same(recorded: Any, now: Any) -> bool:
    numbers = [isinstance(value, int | float) and not isinstance(value, bool) for value in (recorded, now)]
    if all(numbers):
        return math.isclose(recorded, now, rel_tol=RELATIVE, abs_tol=ABSOLUTE)
    return bool(recorded == now)
