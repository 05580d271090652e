"""A bench on a simulated cell's session, copies of it to spoil, and what every step's content must keep to."""

import math
import re
import shutil
from collections.abc import Iterator
from dataclasses import fields, is_dataclass, replace
from pathlib import Path
from types import SimpleNamespace
from typing import Any

import numpy as np

from beltgui.jobs import Cancelled, Job
from beltgui.session import Sample, Session
from beltgui.steps.context import Context
from beltgui.steps.room import Bench, Room
from beltgui.steps.views.drawing import count_points
from beltgui.viewmodel.step import StepContent
from core.errors import InputError
from tests.beltgui.live import Live, blade_and_model

PERSON = "a person"
MOST_POINTS = 60_000


def bench_of(live: Live, **found: Any) -> Bench:
    """An empty bench on the session of a live cell; `found` are outcomes of earlier steps."""
    blade, model = blade_and_model()
    return Bench(live.session, live.sim.plan, blade, model, "2026-01-01", found=dict(found))


def with_stage(live: Live) -> Any:
    """A ball step's outcome, as far as others need it."""
    return SimpleNamespace(stage=live.stage_fit())


def copied(bench: Bench, folder: Path) -> Bench:
    """The same bench on a copy of its session, to edit and to go on with; what was found in the clouds is kept."""
    shutil.copytree(bench.session.folder, folder)
    (folder / "lock").unlink(missing_ok=True)
    session = Session.open(folder, write=True)
    return replace(bench, session=session, found=dict(bench.found), cache=dict(bench.cache))


def context_of(live: Live, bench: Bench, **changes: Any) -> Context:
    """The live cell's context, writing to the bench's session."""
    return replace(live.context, session=bench.session, plan=bench.plan, **changes)


def acquire(room: Room, live: Live, bench: Bench, **changes: Any) -> list[Sample]:
    """Acquire what is missing; gives the samples that were told."""
    told: list[Sample] = []
    room.acquire(bench, context_of(live, bench, on_sample=told.append, **changes))
    return told


def acquire_until(room: Room, live: Live, bench: Bench, message: str) -> None:
    """Acquire, and cancel when the progress says `message`."""
    job = Job(lambda fraction, text: job.cancel() if message in text else None)
    try:
        room.acquire(bench, context_of(live, bench, job=job))
    except Cancelled:
        return
    raise AssertionError(f"nothing was cancelled at '{message}'")


def solved(room: Room, bench: Bench) -> tuple[Any | None, StepContent]:
    """Outcome (None where the samples do not determine it) and checked content."""
    try:
        outcome = room.solve(bench, Job())
    except InputError as error:
        content = room.view(bench, None, str(error))
        assert [reason.message for reason in content.reasons] == [str(error)]
        assert content.ok is None and not content.numbers
        check(content)
        return None, content
    content = room.view(bench, outcome)
    assert content.ok is outcome.verdict.ok
    assert content.headline == room.headline(outcome)
    room.record(outcome)
    check(content)
    return outcome, content


def said(content: StepContent) -> str:
    """All reasons in one text."""
    return "\n".join(reason.message for reason in content.reasons)


def row(content: StepContent, name: str) -> Any:
    """The row of that name."""
    return next(row for row in content.rows if row.name == name)


def number(content: StepContent, label: str) -> Any:
    """The only number whose label begins so."""
    (found,) = [number for number in content.numbers if number.label.startswith(label)]
    return found


def check(content: StepContent) -> None:
    """What holds for any step at any time."""
    bad = [where for where, value in values(content, "content") if not math.isfinite(value)]
    assert bad == [], bad
    for entry in content.rows:
        assert len(entry.cells) == len(content.columns), entry
        assert entry.flag in ("", "worst", "outlier", "refused")
        assert all(isinstance(cell, str | float | None) for cell in entry.cells), entry
    for column in content.columns:
        assert column.decimals is None or column.unit, column
    for shown in content.numbers:
        assert shown.plus_minus is None or shown.plus_minus >= 0.0
        assert shown.unit or re.search("Condition|condition|Different|direction", shown.label), shown
    labels = [shown.label for shown in content.numbers]
    assert len(set(labels)) == len(labels)
    ids = {entry.id for entry in content.rows}
    for plot in content.plots:
        assert re.search(", (µm|mm|deg)$|^scan$|^touch$", plot.x_label), plot.x_label
        assert re.search(", (µm|mm|deg)$", plot.y_label), plot.y_label
        for series in plot.series:
            assert set(getattr(series, "sample_ids", ())) <= ids
    assert sum(entry.flag == "worst" for entry in content.rows) <= 1
    for scene in (content.scene, content.second_scene):
        if scene is not None:
            names = [item.name for item in scene.items]
            assert len(set(names)) == len(names)
            assert count_points(scene) <= MOST_POINTS
    for sentence in (said(content), *content.remarks, content.headline):
        assert "nan" not in sentence.lower().split()


def values(thing: Any, where: str) -> Iterator[tuple[str, float]]:
    """All floats in a content with their place; limits and pictures too."""
    if isinstance(thing, float):
        yield where, thing
    elif isinstance(thing, np.ndarray):
        if thing.dtype.kind == "f" and thing.size:
            yield where, float(np.sum(thing))
    elif is_dataclass(thing):
        for field in fields(thing):
            yield from values(getattr(thing, field.name), f"{where}.{field.name}")
    elif isinstance(thing, dict):
        for key, item in thing.items():
            yield from values(item, f"{where}[{key}]")
    elif isinstance(thing, tuple | list):
        for index, item in enumerate(thing):
            yield from values(item, f"{where}[{index}]")
