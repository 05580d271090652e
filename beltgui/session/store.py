"""The session's folder: an SQLite database and, beside it, the clouds as NumPy files.

A sample is on disk when `add_sample` comes back; SQLite's transaction makes it whole or absent, whatever happens to
the process in between.
"""

from __future__ import annotations

import json
import os
import sqlite3
from collections.abc import Iterator, Mapping
from contextlib import closing
from dataclasses import dataclass
from datetime import UTC, datetime
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from core.errors import InputError

DATABASE = "session.db"
INPUTS = "inputs"
FORMAT = 1

SCHEMA = """
CREATE TABLE info (key TEXT PRIMARY KEY, value TEXT NOT NULL);
CREATE TABLE sample (
    id INTEGER PRIMARY KEY, step TEXT NOT NULL, kind TEXT NOT NULL, created TEXT NOT NULL,
    data TEXT NOT NULL, cloud TEXT
);
CREATE TABLE result (
    id INTEGER PRIMARY KEY, step TEXT NOT NULL, created TEXT NOT NULL, accepted INTEGER NOT NULL,
    record TEXT NOT NULL
);
CREATE INDEX sample_of_step ON sample (step, kind, id);
CREATE INDEX result_of_step ON result (step, id);
"""


@dataclass(frozen=True)
class Sample:
    """One observation as it was taken.

    Attributes:
        id: Number in the session, in order of time.
        step: `ball`, `base`, `rough`, `fine`, `tool` or `error_surface`.
        kind: What it is within the step, e.g. `scan`, `cone_touch`.
        data: Plain numbers and text; mm, and rad or deg as the names say.
        cloud: File name of the points, relative to the session's folder, if there are any.
    """

    id: int
    step: str
    kind: str
    data: dict[str, Any]
    cloud: str | None


@dataclass(frozen=True)
class StoredResult:
    """A result as it was kept."""

    step: str
    created: str
    accepted: bool
    record: dict[str, Any]


class Session:
    """An open session; use `create` or `open`, and close it."""

    def __init__(self, folder: Path, connection: sqlite3.Connection) -> None:
        self.folder = folder
        self._connection = connection

    @classmethod
    def create(cls, folder: Path, info: Mapping[str, Any]) -> Session:
        """Begin a session in a folder that holds none yet.

        Raises:
            InputError: there is a session already; it is never overwritten.
        """
        database = folder / DATABASE
        if database.exists():
            raise InputError(f"{folder}: there is a session already. Choose another folder or open that one.")
        (folder / "clouds").mkdir(parents=True, exist_ok=True)
        connection = sqlite3.connect(database, isolation_level=None, check_same_thread=False)
        connection.execute("PRAGMA journal_mode=WAL")
        connection.execute("PRAGMA synchronous=FULL")
        rows = {"format": FORMAT, "created": _now(), **info}
        with connection:
            connection.executescript("BEGIN;" + SCHEMA + "COMMIT;")
            connection.executemany(
                "INSERT INTO info VALUES (?, ?)", [(key, json.dumps(value)) for key, value in rows.items()]
            )
        return cls(folder, connection)

    @classmethod
    def open(cls, folder: Path) -> Session:
        """Open a session read-only, for instance to replay it.

        Raises:
            InputError: no session, or one of a format that this version does not read.
        """
        database = folder / DATABASE
        if not database.is_file():
            raise InputError(f"{folder}: no session here, {DATABASE} is missing. Give the folder of a session.")
        connection = sqlite3.connect(f"{database.resolve().as_uri()}?mode=ro", uri=True, check_same_thread=False)
        session = cls(folder, connection)
        try:
            found = session.info().get("format")
        except (sqlite3.DatabaseError, json.JSONDecodeError) as error:
            connection.close()
            raise InputError(f"{database}: this is not a session's database ({error}).") from error
        if found != FORMAT:
            connection.close()
            raise InputError(f"{database}: format {found}, expected {FORMAT}. Use the version that wrote it.")
        return session

    def close(self) -> None:
        """Close the database; everything is on disk already."""
        self._connection.close()

    def __enter__(self) -> Session:
        return self

    def __exit__(self, *exception: object) -> None:
        self.close()

    def info(self) -> dict[str, Any]:
        """What was said of the session when it began: software, cell, blade type, serial."""
        rows = self._connection.execute("SELECT key, value FROM info").fetchall()
        return {key: json.loads(value) for key, value in rows}

    def add_sample(
        self, step: str, kind: str, data: Mapping[str, Any], points_mm: NDArray[np.float32] | None = None
    ) -> Sample:
        """Keep one observation; it is on disk when this comes back."""
        text = json.dumps(data, allow_nan=False)
        with closing(self._connection.cursor()) as cursor:
            cursor.execute("BEGIN IMMEDIATE")
            try:
                cursor.execute(
                    "INSERT INTO sample (step, kind, created, data) VALUES (?, ?, ?, ?)", (step, kind, _now(), text)
                )
                number = int(cursor.lastrowid or 0)
                cloud = None
                if points_mm is not None:
                    cloud = f"clouds/{number:05d}_{step}.npy"
                    _save_whole(self.folder / cloud, points_mm)
                    cursor.execute("UPDATE sample SET cloud = ? WHERE id = ?", (cloud, number))
            except BaseException:
                cursor.execute("ROLLBACK")
                raise
            cursor.execute("COMMIT")
        return Sample(number, step, kind, json.loads(text), cloud)

    def samples(self, step: str, kind: str | None = None) -> list[Sample]:
        """All samples of a step (of one kind) in order of time."""
        rows = self._connection.execute(
            "SELECT id, step, kind, data, cloud FROM sample WHERE step = ? AND (? IS NULL OR kind = ?) ORDER BY id",
            (step, kind, kind),
        ).fetchall()
        return [Sample(number, of, sort, json.loads(data), cloud) for number, of, sort, data, cloud in rows]

    def kept(self, step: str, kind: str) -> list[Sample]:
        """The same, for a step that cannot do without them.

        Raises:
            InputError: there are none.
        """
        samples = self.samples(step, kind)
        if not samples:
            raise InputError(
                f"{self.folder}: the session has no sample '{kind}' of the step '{step}'; it is not whole. Take the "
                "session from where it was copied, or run the step again."
            )
        return samples

    def points(self, sample: Sample) -> NDArray[np.float64]:
        """The points (N, 3) in mm of a sample that has a cloud, float64, only finite ones.

        Raises:
            InputError: the file is gone or damaged.
        """
        path = self.folder / str(sample.cloud)
        try:
            stored = np.load(path, allow_pickle=False)
        except (OSError, ValueError, EOFError) as error:
            raise InputError(f"{path}: the cloud of sample {sample.id} cannot be read ({error}).") from error
        flat = stored.reshape(-1, 3)
        return np.asarray(flat[np.isfinite(flat).all(axis=1)], dtype=np.float64)

    def put_result(self, step: str, record: Mapping[str, Any], *, accepted: bool) -> None:
        """Keep a result; earlier ones stay."""
        self._connection.execute(
            "INSERT INTO result (step, created, accepted, record) VALUES (?, ?, ?, ?)",
            (step, _now(), int(accepted), json.dumps(record, allow_nan=False)),
        )

    def result(self, step: str) -> StoredResult | None:
        """The latest result of a step, or None."""
        row = self._connection.execute(
            "SELECT step, created, accepted, record FROM result WHERE step = ? ORDER BY id DESC LIMIT 1", (step,)
        ).fetchone()
        return None if row is None else StoredResult(row[0], row[1], bool(row[2]), json.loads(row[3]))

    def steps_with_results(self) -> Iterator[str]:
        """Names of the steps that have a result, in order of their latest one."""
        rows = self._connection.execute("SELECT step, MAX(id) FROM result GROUP BY step ORDER BY 2").fetchall()
        return (row[0] for row in rows)


def _save_whole(path: Path, points_mm: NDArray[np.float32]) -> None:
    """On the disk, not only in its cache, before the sample becomes visible."""
    with path.open("wb") as file:
        np.save(file, points_mm)
        file.flush()
        os.fsync(file.fileno())


def _now() -> str:
    return datetime.now(UTC).isoformat(timespec="milliseconds")
