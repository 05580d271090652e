"""Rows of the tables `sample` and `setting`."""

from __future__ import annotations

import json
from collections.abc import Mapping
from typing import Any

from sqlalchemy import Connection, Row, func, select

from beltgui.session import schema
from beltgui.session.rows import Basis, Sample

_sample = schema.sample
_setting = schema.setting


def insert(connection: Connection, step: str, kind: str, data: str) -> int:
    """Keep a sample; `data` is JSON. Returns its number."""
    row = {
        "step": step,
        "kind": kind,
        "created": schema.now(),
        "data": data,
        "cloud": None,
        "included": True,
        "deleted": False,
    }
    return int(connection.execute(_sample.insert().values(row).returning(_sample.c.id)).scalar_one())


def set_cloud(connection: Connection, number: int, cloud: str) -> None:
    """Name the file of a sample's points."""
    connection.execute(_sample.update().where(_sample.c.id == number).values(cloud=cloud))


def next_number(connection: Connection) -> int:
    """The number that the next sample will have."""
    return int(connection.execute(select(func.coalesce(func.max(_sample.c.id), 0))).scalar_one()) + 1


def of_step(connection: Connection, step: str, kind: str | None = None, *, deleted: bool = False) -> list[Sample]:
    """Samples in order of time; with `deleted` the deleted ones too."""
    wanted = select(_sample).where(_sample.c.step == step).order_by(_sample.c.id)
    if kind is not None:
        wanted = wanted.where(_sample.c.kind == kind)
    if not deleted:
        wanted = wanted.where(_sample.c.deleted.is_(False))
    return [_from_row(row) for row in connection.execute(wanted)]


def one(connection: Connection, number: int) -> Sample | None:
    """A sample by its number."""
    row = connection.execute(select(_sample).where(_sample.c.id == number)).one_or_none()
    return None if row is None else _from_row(row)


def settings(connection: Connection, step: str) -> dict[str, Any]:
    """All settings of a step that were chosen."""
    rows = connection.execute(select(_setting.c.key, _setting.c.value).where(_setting.c.step == step))
    return {row.key: json.loads(row.value) for row in rows}


def basis(connection: Connection, step: str) -> Basis:
    """What a result of the step would be solved from now."""
    included = select(_sample.c.id).where(
        _sample.c.step == step, _sample.c.deleted.is_(False), _sample.c.included.is_(True)
    )
    return Basis(tuple(connection.scalars(included.order_by(_sample.c.id))), settings(connection, step))


def set_flag(connection: Connection, number: int, name: str, on: bool) -> None:
    """Set `included` or `deleted` of a sample."""
    connection.execute(_sample.update().where(_sample.c.id == number).values({name: on}))


def set_setting(connection: Connection, step: str, key: str, value: Mapping[str, Any]) -> None:
    """Set a setting to `{"value": ...}`, or take it away by `{"unset": True}`."""
    connection.execute(_setting.delete().where(_setting.c.step == step, _setting.c.key == key))
    if "value" in value:
        connection.execute(_setting.insert().values(step=step, key=key, value=schema.dump(value["value"])))


def count(connection: Connection, step: str) -> int:
    """Samples of a step that are not deleted."""
    wanted = select(func.count()).select_from(_sample).where(_sample.c.step == step, _sample.c.deleted.is_(False))
    return int(connection.execute(wanted).scalar_one())


def steps(connection: Connection) -> set[str]:
    """Steps that have a sample or a setting."""
    of_samples = connection.scalars(select(_sample.c.step).distinct())
    return set(of_samples) | set(connection.scalars(select(_setting.c.step).distinct()))


def _from_row(row: Row[Any]) -> Sample:
    return Sample(
        row.id, row.step, row.kind, row.created, json.loads(row.data), row.cloud, bool(row.included), bool(row.deleted)
    )
