"""The session's tables (format 2) and the JSON in their columns; imports SQLAlchemy, so only an open session does."""

from __future__ import annotations

import json
from datetime import UTC, datetime
from typing import Any

from sqlalchemy import Boolean, Column, Index, Integer, MetaData, Table, Text

metadata = MetaData()

info = Table(
    "info",
    metadata,
    Column("key", Text, primary_key=True),
    Column("value", Text, nullable=False),
)

sample = Table(
    "sample",
    metadata,
    Column("id", Integer, primary_key=True),
    Column("step", Text, nullable=False),
    Column("kind", Text, nullable=False),
    Column("created", Text, nullable=False),
    Column("data", Text, nullable=False),
    Column("cloud", Text),
    Column("included", Boolean, nullable=False),
    Column("deleted", Boolean, nullable=False),
    Index("sample_of_step", "step", "kind", "id"),
)

edit = Table(
    "edit",
    metadata,
    Column("id", Integer, primary_key=True),
    Column("step", Text, nullable=False),
    Column("time", Text, nullable=False),
    Column("person", Text, nullable=False),
    Column("what", Text, nullable=False),
    Column("changes", Text, nullable=False),
    Column("state", Text, nullable=False),
    Index("edit_of_step", "step", "id"),
)

setting = Table(
    "setting",
    metadata,
    Column("step", Text, primary_key=True),
    Column("key", Text, primary_key=True),
    Column("value", Text, nullable=False),
)

result = Table(
    "result",
    metadata,
    Column("id", Integer, primary_key=True),
    Column("step", Text, nullable=False),
    Column("created", Text, nullable=False),
    Column("ok", Boolean, nullable=False),
    Column("headline", Text, nullable=False),
    Column("record", Text, nullable=False),
    Column("samples", Text, nullable=False),
    Column("settings", Text, nullable=False),
    Column("stands_on", Text, nullable=False),
    Column("person", Text, nullable=False),
    Column("software", Text, nullable=False),
    Index("result_of_step", "step", "id"),
)

decision = Table(
    "decision",
    metadata,
    Column("id", Integer, primary_key=True),
    Column("time", Text, nullable=False),
    Column("person", Text, nullable=False),
    Column("step", Text, nullable=False),
    Column("what", Text, nullable=False),
    Column("result", Integer),
    Index("decision_of_step", "step", "id"),
)


def dump(value: Any) -> str:
    """Strict JSON.

    Raises:
        ValueError: NaN or infinity.
        TypeError: something that is no JSON.
    """
    return json.dumps(value, allow_nan=False)


def now() -> str:
    """UTC, ISO 8601, milliseconds."""
    return datetime.now(UTC).isoformat(timespec="milliseconds")
