"""The session's SQLite database: durable, safe for several threads, readable while another process writes."""

from __future__ import annotations

import contextlib
import os
import shutil
import sqlite3
import tempfile
import threading
from collections.abc import Iterator
from pathlib import Path
from typing import Any

from sqlalchemy import Connection, Engine, create_engine, event, select
from sqlalchemy.exc import DBAPIError, OperationalError
from sqlalchemy.pool import QueuePool

from beltgui.files import sync_folder
from beltgui.session import schema
from core.errors import InputError

BUSY_MS = 10_000
_MODES = {"create": "rwc", "write": "rw", "read": "ro"}


class Database:
    """Short transactions on pooled connections: any thread may read or write."""

    def __init__(self, path: Path, engine: Engine, *, writable: bool, copy: Path | None = None) -> None:
        self.path = path
        self.writable = writable
        self._engine = engine
        self._copy = copy
        self._writing = threading.RLock()
        self._closed = False

    @classmethod
    def create(cls, path: Path, info: dict[str, Any]) -> Database:
        """A new database, whole from the moment it has its name.

        Raises:
            InputError: the disk is full, or the like.
        """
        unfinished = path.with_name(f".{path.name}.part")
        for suffix in ("", "-journal", "-wal", "-shm"):  # of a process that was killed here
            unfinished.with_name(unfinished.name + suffix).unlink(missing_ok=True)
        engine = _engine(unfinished, "create")
        try:
            with engine.begin() as connection:
                schema.metadata.create_all(connection)
                rows = [{"key": key, "value": schema.dump(value)} for key, value in info.items()]
                connection.execute(schema.info.insert(), rows)
            with engine.connect().execution_options(outside=True) as connection:
                connection.exec_driver_sql("PRAGMA journal_mode=WAL")  # stays in the file
            engine.dispose()
            os.replace(unfinished, path)
            sync_folder(path.parent)
        except (DBAPIError, OSError) as error:
            raise InputError(f"{path}: no session can be begun here ({_reason(error)}). Check the disk.") from error
        finally:
            engine.dispose()
        return cls.open(path, write=True)

    @classmethod
    def open(cls, path: Path, *, write: bool) -> Database:
        """The database of an existing session.

        Raises:
            InputError: it is no database.
        """
        database = cls(path, _engine(path, "write" if write else "read"), writable=write)
        try:
            try:
                database._probe()
            except OperationalError:
                # A write-ahead log needs a file of its own beside the database, even to read; a read-only folder has
                # no room for it.
                if write:
                    raise
                database._engine.dispose()
                database = cls._of_copy(path)
                database._probe()
        except (DBAPIError, OSError) as error:
            database.close()
            raise InputError(f"{path}: this is not a session's database ({_reason(error)}).") from error
        return database

    @classmethod
    def _of_copy(cls, path: Path) -> Database:
        """The database with its log, copied to where it can be read."""
        folder = Path(tempfile.mkdtemp(prefix="beltcal-session-"))
        try:
            for suffix in ("", "-wal"):
                source = path.with_name(path.name + suffix)
                if source.is_file():
                    shutil.copyfile(source, folder / source.name)
        except BaseException:
            shutil.rmtree(folder, ignore_errors=True)
            raise
        return cls(path, _engine(folder / path.name, "read"), writable=False, copy=folder)

    def _probe(self) -> None:
        with self._engine.connect() as connection:
            connection.execute(select(schema.info.c.key).limit(1))

    @contextlib.contextmanager
    def reading(self) -> Iterator[Connection]:
        """One consistent view of the database.

        Raises:
            InputError: the session is closed.
        """
        self._check_open()
        with self._engine.connect() as connection:
            yield connection

    @contextlib.contextmanager
    def changing(self) -> Iterator[Connection]:
        """A transaction that is on the disk when it ends, and undone if anything is raised in it.

        Raises:
            InputError: opened to read only, closed, or the disk is full or gone.
        """
        if not self.writable:
            raise InputError(f"{self.path.parent}: the session was opened read-only. Open it for writing to change it.")
        with self._writing:
            self._check_open()
            try:
                with self._engine.connect().execution_options(immediate=True) as connection, connection.begin():
                    yield connection
            except OperationalError as error:
                raise InputError(
                    f"{self.path}: nothing was changed, the database cannot be written ({_reason(error)}). Check the "
                    "disk."
                ) from error

    def close(self) -> None:
        """Close all connections; everything is on disk already."""
        with self._writing:
            self._closed = True
            self._engine.dispose()
            if self._copy is not None:
                shutil.rmtree(self._copy, ignore_errors=True)

    def _check_open(self) -> None:
        if self._closed:
            raise InputError(f"{self.path.parent}: the session has been closed. Open it again.")


def _engine(path: Path, mode: str) -> Engine:
    address = f"{path.resolve().as_uri()}?mode={_MODES[mode]}"

    def connect() -> sqlite3.Connection:
        # Transactions are begun below, not by the module's own guesses.
        connection = sqlite3.connect(
            address, uri=True, isolation_level=None, check_same_thread=False, timeout=BUSY_MS / 1000
        )
        connection.execute("PRAGMA synchronous=FULL")
        return connection

    engine = create_engine("sqlite://", creator=connect, poolclass=QueuePool)

    @event.listens_for(engine, "begin")
    def begin(connection: Connection) -> None:
        # A transaction that will write says so at once, otherwise it could fail half-way where another one wrote.
        options = connection.get_execution_options()
        if not options.get("outside", False):
            connection.exec_driver_sql("BEGIN IMMEDIATE" if options.get("immediate", False) else "BEGIN")

    return engine


def _reason(error: Exception) -> object:
    return error.orig if isinstance(error, DBAPIError) else error
