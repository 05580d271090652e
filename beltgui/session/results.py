"""Rows of the tables `result` and `decision`: results are followed, never overwritten."""

from __future__ import annotations

import json
from collections import OrderedDict
from collections.abc import Mapping

from sqlalchemy import Connection, func, select

from beltgui import __version__
from beltgui.session import samples, schema
from beltgui.session.rows import Basis, Decision, StoredResult
from core.errors import InputError

_result = schema.result
_decision = schema.decision
ACCEPTED = "accepted"
_REMEMBERED = 64


class ResultTable:
    """Results by number; they never change, so those read last are remembered."""

    def __init__(self) -> None:
        self._read: OrderedDict[int, StoredResult] = OrderedDict()

    def by_number(self, connection: Connection, number: int | None) -> StoredResult | None:
        """A result; None if there is none of that number."""
        if number is None:
            return None
        known = self._read.get(number)
        if known is not None:
            return known
        row = connection.execute(select(_result).where(_result.c.id == number)).one_or_none()
        if row is None:
            return None
        found = StoredResult(
            id=row.id,
            step=row.step,
            created=row.created,
            ok=bool(row.ok),
            headline=row.headline,
            record=json.loads(row.record),
            samples=tuple(json.loads(row.samples)),
            settings=json.loads(row.settings),
            stands_on=json.loads(row.stands_on),
            person=row.person,
            software=row.software,
        )
        self._read[number] = found
        while len(self._read) > _REMEMBERED:
            self._read.popitem(last=False)
        return found

    def latest(self, connection: Connection, step: str) -> StoredResult | None:
        """The newest result of a step."""
        newest = select(func.max(_result.c.id)).where(_result.c.step == step)
        return self.by_number(connection, connection.execute(newest).scalar_one())

    def accepted(self, connection: Connection, step: str) -> StoredResult | None:
        """The result of a step that was accepted last."""
        newest = (
            select(_decision.c.result)
            .where(_decision.c.step == step, _decision.c.what == ACCEPTED)
            .order_by(_decision.c.id.desc())
            .limit(1)
        )
        return self.by_number(connection, connection.execute(newest).scalar_one_or_none())


def insert(
    connection: Connection,
    step: str,
    record: str,
    basis: Basis,
    *,
    ok: bool,
    headline: str,
    stands_on: Mapping[str, int],
    person: str,
) -> int:
    """Keep a result; `record` is JSON. Returns its number."""
    row = {
        "step": step,
        "created": schema.now(),
        "ok": ok,
        "headline": headline,
        "record": record,
        "samples": schema.dump(list(basis.samples)),
        "settings": schema.dump(basis.settings),
        "stands_on": schema.dump(dict(stands_on)),
        "person": person,
        "software": __version__,
    }
    return int(connection.execute(_result.insert().values(row).returning(_result.c.id)).scalar_one())


def check_acceptable(connection: Connection, step: str, latest: StoredResult | None) -> StoredResult:
    """The result, if it may be accepted.

    Raises:
        InputError: there is none, it was rejected, or its samples or settings are no longer those of the step.
    """
    if latest is None:
        raise InputError(f"The step '{step}' has no result yet. Solve it first.")
    if not latest.ok:
        raise InputError(f"The latest result of the step '{step}' is not good enough to accept: {latest.headline}")
    if not samples.basis(connection, step).fits(latest):
        raise InputError(f"The samples or settings of the step '{step}' changed since it was solved. Solve it again.")
    return latest


def decide(connection: Connection, step: str, person: str, what: str, number: int | None) -> None:
    """Write down a decision."""
    row = {"time": schema.now(), "person": person, "step": step, "what": what, "result": number}
    connection.execute(_decision.insert().values(row))


def decisions(connection: Connection) -> list[Decision]:
    """All decisions in order of time."""
    rows = connection.execute(select(_decision).order_by(_decision.c.id))
    return [Decision(row.time, row.person, row.step, row.what, row.result) for row in rows]


def steps(connection: Connection) -> list[str]:
    """Steps that have a result, in order of their latest one."""
    newest = func.max(_result.c.id)
    return list(connection.scalars(select(_result.c.step).group_by(_result.c.step).order_by(newest)))
