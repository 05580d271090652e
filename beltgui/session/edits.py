"""What a person changes in a step's samples and settings: a log that is never shortened, with undo and redo.

An edit is a list of changes, each with the value before and after. Undo writes the values before, redo those after. A
new edit, or a new sample, of the same step drops what could have been done again.

Samples may have been taken between an edit and its undo. Where a deleted sample comes back, one that was taken in its
place goes; where all samples come back that were set aside by starting over, all taken since go. Both are written into
the edit, so that redo brings them back.
"""

from __future__ import annotations

import json
from typing import Any

from sqlalchemy import Connection, Row, Select, select

from beltgui.session import samples, schema
from beltgui.session.rows import Edit, Sample
from core.errors import InputError

_edit = schema.edit
DONE, UNDONE, DROPPED = "done", "undone", "dropped"
Change = dict[str, Any]


def include(connection: Connection, number: int, on: bool, person: str) -> None:
    """Tick or untick a sample.

    Raises:
        InputError: there is no such sample, or it was deleted.
    """
    sample = _existing(connection, number)
    if sample.deleted:
        raise InputError(f"Sample {number} was deleted. Undo the deletion first.")
    if sample.included != on:
        what = f"sample {number} used again" if on else f"sample {number} left out"
        _do(connection, sample.step, person, what, [_flag(number, "included", sample.included, on)])


def delete(connection: Connection, number: int, person: str) -> None:
    """Delete a sample; it stays in the database, unseen.

    Raises:
        InputError: there is no such sample.
    """
    sample = _existing(connection, number)
    if not sample.deleted:
        what = f"sample {number} deleted"
        _do(connection, sample.step, person, what, [_flag(number, "deleted", False, True)])


def start_over(connection: Connection, step: str, person: str) -> None:
    """Delete all samples of a step."""
    there = samples.of_step(connection, step)
    if there:
        count = "1 sample" if len(there) == 1 else f"{len(there)} samples"
        changes = [_flag(sample.id, "deleted", False, True) for sample in there]
        _do(connection, step, person, f"started over, {count} deleted", changes)


def choose(connection: Connection, step: str, key: str, value: Any, person: str) -> None:
    """Set a setting of a step; None takes it away, as if it had never been set.

    Raises:
        ValueError: it is no strict JSON.
    """
    after = {"unset": True} if value is None else {"value": json.loads(schema.dump(value))}
    there = samples.settings(connection, step)
    before = {"value": there[key]} if key in there else {"unset": True}
    if before != after:
        _do(connection, step, person, f"setting '{key}' changed", [{"setting": key, "before": before, "after": after}])


def undo(connection: Connection, step: str) -> str | None:
    """Take back the last edit that stands; returns what it was in words, None if there is none."""
    edit = to_undo(connection, step)
    if edit is None:
        return None
    changes = [*edit.changes, *_taken_since(connection, edit)]
    for change in reversed(changes):
        _set(connection, step, change, "before")
    _keep(connection, edit.id, UNDONE, changes)
    return edit.what


def redo(connection: Connection, step: str) -> str | None:
    """Do again what was taken back last; returns what it was in words, None if there is nothing."""
    edit = to_redo(connection, step)
    if edit is None:
        return None
    for change in edit.changes:
        _set(connection, step, change, "after")
    _keep(connection, edit.id, DONE, list(edit.changes))
    return edit.what


def to_undo(connection: Connection, step: str) -> Edit | None:
    """What undo would take back."""
    return _first(connection, _of(step, DONE).order_by(_edit.c.id.desc()))


def to_redo(connection: Connection, step: str) -> Edit | None:
    """What redo would do again."""
    return _first(connection, _of(step, UNDONE).order_by(_edit.c.id))


def drop_undone(connection: Connection, step: str) -> None:
    """Something new was done: what had been taken back cannot be done again."""
    undone = (_edit.c.step == step) & (_edit.c.state == UNDONE)
    connection.execute(_edit.update().where(undone).values(state=DROPPED))


def log(connection: Connection, step: str | None) -> list[Edit]:
    """All edits (of a step) in order of time."""
    wanted = select(_edit).order_by(_edit.c.id)
    if step is not None:
        wanted = wanted.where(_edit.c.step == step)
    return [_from_row(row) for row in connection.execute(wanted)]


def _do(connection: Connection, step: str, person: str, what: str, changes: list[Change]) -> None:
    drop_undone(connection, step)
    for change in changes:
        _set(connection, step, change, "after")
    row = {
        "step": step,
        "time": schema.now(),
        "person": person,
        "what": what,
        "changes": schema.dump(changes),
        "state": DONE,
    }
    connection.execute(_edit.insert().values(row))


def _taken_since(connection: Connection, edit: Edit) -> list[Change]:
    """Samples that have to go when the edit's deleted samples come back."""
    back = {change["sample"] for change in edit.changes if change.get("field") == "deleted" and change["after"]}
    if not back:
        return []
    everything = {sample.id: sample for sample in samples.of_step(connection, edit.step, deleted=True)}
    known = {change.get("sample") for change in edit.changes}
    living = [sample for sample in everything.values() if not sample.deleted and sample.id not in known]
    if not edit.what.startswith("started over"):
        places = {_place(everything[number]) for number in back}
        living = [sample for sample in living if _place(sample) in places and _place(sample) is not None]
    return [_flag(sample.id, "deleted", True, False) for sample in living]


def _place(sample: Sample) -> tuple[Any, ...] | None:
    """Which planned sample it is; None if it does not say."""
    slot = sample.data.get("slot")
    return None if slot is None else (sample.kind, sample.data.get("grinder"), slot)


def _set(connection: Connection, step: str, change: Change, side: str) -> None:
    if "sample" in change:
        samples.set_flag(connection, change["sample"], change["field"], change[side])
    else:
        samples.set_setting(connection, step, change["setting"], change[side])


def _keep(connection: Connection, number: int, state: str, changes: list[Change]) -> None:
    values = {"state": state, "changes": schema.dump(changes)}
    connection.execute(_edit.update().where(_edit.c.id == number).values(values))


def _flag(number: int, name: str, before: bool, after: bool) -> Change:
    return {"sample": number, "field": name, "before": before, "after": after}


def _existing(connection: Connection, number: int) -> Sample:
    sample = samples.one(connection, number)
    if sample is None:
        raise InputError(f"The session has no sample {number}.")
    return sample


def _of(step: str, state: str) -> Select[Any]:
    return select(_edit).where(_edit.c.step == step, _edit.c.state == state)


def _first(connection: Connection, wanted: Select[Any]) -> Edit | None:
    row = connection.execute(wanted.limit(1)).one_or_none()
    return None if row is None else _from_row(row)


def _from_row(row: Row[Any]) -> Edit:
    return Edit(row.id, row.step, row.time, row.person, row.what, row.state, tuple(json.loads(row.changes)))
