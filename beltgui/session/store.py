"""The session's folder: an SQLite database and, beside it, the clouds as NumPy files.

A sample is on disk when `add_sample` comes back; whatever happens to the process or to the power, it is whole or
absent. Several threads may use one session; one process at a time writes it, others may read it meanwhile. SQLAlchemy
is imported when a session is opened: this module is light.
"""

from __future__ import annotations

import json
from collections.abc import Callable, Iterator, Mapping
from pathlib import Path
from typing import TYPE_CHECKING, Any

from beltgui.files import sync_folder
from beltgui.session import clouds
from beltgui.session.lock import WriterLock
from beltgui.session.rows import Basis, Decision, Edit, Sample, Snapshot, StepSnapshot, StoredResult
from core.errors import InputError

if TYPE_CHECKING:
    import numpy as np
    from numpy.typing import NDArray

    from beltgui.session.database import Database

DATABASE = "session.db"
INPUTS = "inputs"
FORMAT = 2


class Session:
    """An open session; use `create` or `open`, and close it.

    Attributes:
        folder: Where it is.
        writable: False if it was opened to look at.
    """

    def __init__(self, folder: Path, database: Database, lock: WriterLock | None) -> None:
        from beltgui.session import edits, results, samples

        self.folder = folder
        self.writable = lock is not None
        self._database = database
        self._lock = lock
        self._samples, self._edits, self._results = samples, edits, results
        self._stored = results.ResultTable()

    @classmethod
    def create(cls, folder: Path, info: Mapping[str, Any], *, fill: Callable[[], None] = lambda: None) -> Session:
        """Begin a session in a folder that holds none yet.

        Args:
            folder: For it.
            info: What is said of it.
            fill: Puts into the folder what belongs to a whole session; there is none before that is done.

        Raises:
            InputError: there is a session already (it is never overwritten), or the folder cannot be written.
        """
        from beltgui.session import schema
        from beltgui.session.database import Database

        try:
            (folder / clouds.CLOUDS).mkdir(parents=True, exist_ok=True)
        except OSError as error:
            raise InputError(
                f"{folder}: no session can be begun here ({error.strerror}). Choose another folder."
            ) from error
        if (folder / DATABASE).exists():
            raise InputError(f"{folder}: there is a session already. Choose another folder or open that one.")
        lock = WriterLock(folder)
        try:
            if (folder / DATABASE).exists():  # another process was faster
                raise InputError(f"{folder}: there is a session already. Choose another folder or open that one.")
            clouds.tidy(folder, 1)
            fill()
            database = Database.create(folder / DATABASE, {"format": FORMAT, "created": schema.now(), **info})
            sync_folder(folder.resolve().parent)
        except BaseException:
            lock.release()
            raise
        return cls(folder, database, lock)

    @classmethod
    def open(cls, folder: Path, *, write: bool = False) -> Session:
        """Open a session: to look at (also while another process writes it, also in a read-only folder) or to go on.

        Raises:
            InputError: no session, one of a format that this version does not read, or, to go on with it, somebody else
                is writing it.
        """
        from beltgui.session.database import Database

        path = folder / DATABASE
        if not path.is_file():
            raise InputError(f"{folder}: no session here, {DATABASE} is missing. Give the folder of a session.")
        _check_format(path)
        lock = WriterLock(folder) if write else None
        try:
            session = cls(folder, Database.open(path, write=write), lock)
        except BaseException:
            if lock is not None:
                lock.release()
            raise
        if write:
            session._tidy()
        return session

    def _tidy(self) -> None:
        try:
            with self._database.reading() as connection:
                clouds.tidy(self.folder, self._samples.next_number(connection))
        except OSError as error:
            self.close()
            raise InputError(
                f"{self.folder}: the folder of the clouds cannot be written ({error.strerror})."
            ) from error

    def close(self) -> None:
        """Close it and let others write; everything is on disk already. Closing twice does nothing."""
        self._database.close()
        if self._lock is not None:
            self._lock.release()
            self._lock = None

    def __enter__(self) -> Session:
        return self

    def __exit__(self, *exception: object) -> None:
        self.close()

    def info(self) -> dict[str, Any]:
        """What was said of the session when it began: software, cell, blade type, serial."""
        with self._database.reading() as connection:
            return _info(connection)

    # ---- samples

    def add_sample(
        self, step: str, kind: str, data: Mapping[str, Any], points_mm: NDArray[np.float32] | None = None
    ) -> Sample:
        """Keep one observation; it is on disk when this comes back.

        Raises:
            ValueError: `data` holds NaN or infinity.
            InputError: the disk is full, or the session is read-only.
        """
        text = json.dumps(dict(data), allow_nan=False)
        # The long part, before the transaction: others can read and write meanwhile.
        unfinished = None if points_mm is None else clouds.write_unfinished(self.folder, points_mm)
        try:
            with self._database.changing() as connection:
                self._edits.drop_undone(connection, step)
                number = self._samples.insert(connection, step, kind, text)
                if unfinished is not None:
                    cloud = clouds.finish(self.folder, unfinished, number, step)
                    self._samples.set_cloud(connection, number, cloud)
                kept = self._samples.one(connection, number)
        finally:
            if unfinished is not None:
                unfinished.unlink(missing_ok=True)
        assert kept is not None
        return kept

    def samples(self, step: str, kind: str | None = None, *, deleted: bool = False) -> list[Sample]:
        """Samples of a step (of one kind) in order of time; with `deleted` also those that a person deleted."""
        with self._database.reading() as connection:
            return self._samples.of_step(connection, step, kind, deleted=deleted)

    def kept(self, step: str, kind: str) -> list[Sample]:
        """The included ones, for a step that cannot do without them.

        Raises:
            InputError: there are none.
        """
        there = self.samples(step, kind)
        included = [sample for sample in there if sample.included]
        if included:
            return included
        if there:
            raise InputError(f"All samples '{kind}' of the step '{step}' are left out. Tick at least some of them.")
        raise InputError(
            f"{self.folder}: the session has no sample '{kind}' of the step '{step}'; it is not whole. Take the "
            "session from where it was copied, or run the step again."
        )

    def points(self, sample: Sample) -> NDArray[np.float64]:
        """The points (N, 3) in mm of a sample that has a cloud, float64, only finite ones.

        Raises:
            InputError: the file is gone or damaged.
        """
        return clouds.read(self.folder / str(sample.cloud), sample.id)

    def setting(self, step: str, key: str, default: Any = None) -> Any:
        """A setting of a step as it was chosen, or `default`."""
        with self._database.reading() as connection:
            return self._samples.settings(connection, step).get(key, default)

    def basis(self, step: str) -> Basis:
        """The included samples and the settings: take it before solving and hand it to `put_result`."""
        with self._database.reading() as connection:
            return self._samples.basis(connection, step)

    # ---- edits: each is on disk when it comes back, and undo takes it back

    def include(self, sample_id: int, on: bool, person: str) -> None:
        """Tick or untick a sample.

        Raises:
            InputError: there is no such sample, or it was deleted.
        """
        with self._database.changing() as connection:
            self._edits.include(connection, sample_id, on, person)

    def delete(self, sample_id: int, person: str) -> None:
        """Delete one sample.

        Raises:
            InputError: there is no such sample.
        """
        with self._database.changing() as connection:
            self._edits.delete(connection, sample_id, person)

    def start_over(self, step: str, person: str) -> None:
        """Delete all samples of a step."""
        with self._database.changing() as connection:
            self._edits.start_over(connection, step, person)

    def choose(self, step: str, key: str, value: Any, person: str) -> None:
        """Set a setting of a step (strict JSON); None takes it away."""
        with self._database.changing() as connection:
            self._edits.choose(connection, step, key, value, person)

    def undo(self, step: str, person: str) -> str | None:
        """Take back the last edit of a step; says what it was, None if there is none."""
        with self._database.changing() as connection:
            what = self._edits.undo(connection, step)
            if what is not None:
                self._results.decide(connection, step, person, f"undone: {what}", None)
            return what

    def redo(self, step: str, person: str) -> str | None:
        """Do again what was taken back last; says what it was, None if there is nothing."""
        with self._database.changing() as connection:
            what = self._edits.redo(connection, step)
            if what is not None:
                self._results.decide(connection, step, person, f"done again: {what}", None)
            return what

    def can_undo(self, step: str) -> bool:
        """There is an edit to take back."""
        with self._database.reading() as connection:
            return self._edits.to_undo(connection, step) is not None

    def can_redo(self, step: str) -> bool:
        """There is something to do again."""
        with self._database.reading() as connection:
            return self._edits.to_redo(connection, step) is not None

    def edits(self, step: str | None = None) -> list[Edit]:
        """The log of all edits (of a step), also of those taken back."""
        with self._database.reading() as connection:
            return self._edits.log(connection, step)

    # ---- results and decisions

    def put_result(
        self,
        step: str,
        record: Mapping[str, Any],
        *,
        ok: bool,
        headline: str = "",
        stands_on: Mapping[str, int] | None = None,
        basis: Basis | None = None,
        person: str = "",
    ) -> StoredResult:
        """Keep a result; earlier ones stay.

        Args:
            step: Of the six.
            record: Strict JSON.
            ok: Its verdict.
            headline: The number that matters, with its unit.
            stands_on: Number of the result of each earlier step that it used.
            basis: What it was solved from; None takes the samples and settings as they are now.
            person: Who works.

        Raises:
            ValueError: the record holds NaN or infinity.
        """
        text = json.dumps(dict(record), allow_nan=False)
        with self._database.changing() as connection:
            number = self._results.insert(
                connection,
                step,
                text,
                basis or self._samples.basis(connection, step),
                ok=ok,
                headline=headline,
                stands_on=stands_on or {},
                person=person,
            )
        stored = self.stored(number)
        assert stored is not None
        return stored

    def result(self, step: str) -> StoredResult | None:
        """The latest result of a step, accepted or not."""
        with self._database.reading() as connection:
            return self._stored.latest(connection, step)

    def stored(self, result_id: int) -> StoredResult | None:
        """A result by its number."""
        with self._database.reading() as connection:
            return self._stored.by_number(connection, result_id)

    def accept(self, step: str, person: str) -> StoredResult:
        """Accept the latest result of a step.

        Returns:
            The accepted one: an earlier one that says the same, if that was accepted last.

        Raises:
            InputError: there is none, its verdict is not ok, or its samples or settings have changed since.
        """
        with self._database.changing() as connection:
            latest = self._stored.latest(connection, step)
            result = self._results.check_acceptable(connection, step, latest)
            accepted = self._stored.accepted(connection, step)
            if accepted is not None and accepted.says_the_same(result):
                return accepted  # what stands on it need not be solved again
            self._results.decide(connection, step, person, self._results.ACCEPTED, result.id)
            return result

    def accepted_result(self, step: str) -> StoredResult | None:
        """The result of a step that was accepted last; whether it is still valid, `beltgui.steps.graph` tells."""
        with self._database.reading() as connection:
            return self._stored.accepted(connection, step)

    def decide(self, step: str, person: str, what: str) -> None:
        """Write down another decision, for instance an export."""
        with self._database.changing() as connection:
            self._results.decide(connection, step, person, what, None)

    def decisions(self) -> list[Decision]:
        """All decisions in order of time."""
        with self._database.reading() as connection:
            return self._results.decisions(connection)

    def steps_with_results(self) -> Iterator[str]:
        """Names of the steps that have a result, in order of their latest one."""
        with self._database.reading() as connection:
            return iter(self._results.steps(connection))

    def snapshot(self) -> Snapshot:
        """All steps at one moment, with the results that their results stand on."""
        steps: dict[str, StepSnapshot] = {}
        results: dict[int, StoredResult] = {}
        with self._database.reading() as connection:
            for step in sorted(self._samples.steps(connection) | set(self._results.steps(connection))):
                latest = self._stored.latest(connection, step)
                accepted = self._stored.accepted(connection, step)
                basis = self._samples.basis(connection, step)
                steps[step] = StepSnapshot(basis, self._samples.count(connection, step), latest, accepted)
            for shown in steps.values():
                for result in (shown.latest, shown.accepted):
                    for number in result.stands_on.values() if result else ():
                        found = self._stored.by_number(connection, number)
                        if found is not None:
                            results[number] = found
        return Snapshot(steps, results)


def _info(connection: Any) -> dict[str, Any]:
    from sqlalchemy import select

    from beltgui.session import schema

    return {row.key: json.loads(row.value) for row in connection.execute(select(schema.info))}


def _check_format(path: Path) -> None:
    """Refuse what this version does not read, before anything is changed.

    Raises:
        InputError: another format, or no session's database.
    """
    from beltgui.session.database import Database

    database = Database.open(path, write=False)
    try:
        with database.reading() as connection:
            info = _info(connection)
    except json.JSONDecodeError as error:
        raise InputError(f"{path}: this is not a session's database ({error}).") from error
    finally:
        database.close()
    found = info.get("format")
    if found != FORMAT:
        wrote = f"beltcal {info['software']}" if "software" in info else "the version that wrote it"
        raise InputError(f"{path}: format {found}, expected {FORMAT}. Use {wrote} to open it.")
