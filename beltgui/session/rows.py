"""What a session gives out: samples, results, edits, decisions."""

from __future__ import annotations

from dataclasses import dataclass, field
from typing import Any

# Settings whose names begin so change a picture and never a result.
SHOWN_ONLY = "show_"
_UNSET = object()


@dataclass(frozen=True)
class Sample:
    """One observation as it was taken.

    Attributes:
        id: Number in the session, in order of time.
        step: `ball`, `base`, `rough`, `fine`, `tool` or `error_surface`.
        kind: What it is within the step, e.g. `scan`, `cone_touch`.
        created: UTC, ISO 8601.
        data: Plain numbers and text; mm, and rad or deg as the names say. `slot` says which planned sample it is.
        cloud: File name of the points, relative to the session's folder, if there are any.
        included: False if a person left it out.
        deleted: True if a person deleted it (it is kept, so that undo can bring it back).
    """

    id: int
    step: str
    kind: str
    created: str
    data: dict[str, Any]
    cloud: str | None
    included: bool = True
    deleted: bool = False


@dataclass(frozen=True)
class StoredResult:
    """A result as it was kept; results are shared, do not change their dicts.

    Attributes:
        id: Number in the session, in order of time.
        step: Of the six.
        created: UTC, ISO 8601.
        ok: Its verdict.
        headline: The number that matters, one line with its unit.
        record: JSON of the step; mm and deg.
        samples: Ids of the samples that it was solved from.
        settings: Of the step, as they were.
        stands_on: The result of each earlier step that it used, by step.
        person: Who worked.
        software: Version that solved it.
    """

    id: int
    step: str
    created: str
    ok: bool
    headline: str
    record: dict[str, Any]
    samples: tuple[int, ...]
    settings: dict[str, Any]
    stands_on: dict[str, int]
    person: str
    software: str

    def says_the_same(self, other: StoredResult) -> bool:
        """True if the other was solved from the same, by the same software, and found the same."""
        return all(
            getattr(self, name) == getattr(other, name)
            for name in ("ok", "record", "samples", "settings", "stands_on", "software")
        )


@dataclass(frozen=True)
class Basis:
    """What a result of a step is solved from, as the session stands.

    Attributes:
        samples: Ids of the included samples, ascending.
        settings: The step's settings.
    """

    samples: tuple[int, ...] = ()
    settings: dict[str, Any] = field(default_factory=dict)

    def changed_settings(self, result: StoredResult) -> list[str]:
        """Settings that are not what they were for a result; those that only change a picture do not count."""
        keys = self.settings.keys() | result.settings.keys()
        real = (key for key in keys if not key.startswith(SHOWN_ONLY))
        return sorted(key for key in real if self.settings.get(key, _UNSET) != result.settings.get(key, _UNSET))

    def fits(self, result: StoredResult) -> bool:
        """True if a result was solved from just this."""
        return self.samples == result.samples and not self.changed_settings(result)


@dataclass(frozen=True)
class Decision:
    """Something a person decided: `accepted`, an undo, a redo, an export; with the result it is about, if any."""

    time: str
    person: str
    step: str
    what: str
    result_id: int | None = None


@dataclass(frozen=True)
class Edit:
    """A change that a person made to a step's samples or settings.

    Attributes:
        id: Number in the session, in order of time.
        step: Of the six.
        time: UTC, ISO 8601.
        person: Who.
        what: In words.
        state: `done`, `undone` (redo does it again) or `dropped` (undone, then something else was done).
        changes: Each `{"sample": id, "field": "included" | "deleted", "before", "after"}` or
            `{"setting": key, "before", "after"}`, where a setting without a value is `{"unset": true}`, otherwise
            `{"value": ...}`.
    """

    id: int
    step: str
    time: str
    person: str
    what: str
    state: str
    changes: tuple[dict[str, Any], ...]


@dataclass(frozen=True)
class StepSnapshot:
    """A step as the session holds it at one moment.

    Attributes:
        basis: What a result would be solved from now.
        sample_count: Samples that are not deleted, included or not.
        latest: The latest result.
        accepted: The result that was accepted last.
    """

    basis: Basis = field(default_factory=Basis)
    sample_count: int = 0
    latest: StoredResult | None = None
    accepted: StoredResult | None = None


@dataclass(frozen=True)
class Snapshot:
    """The whole session at one moment.

    Attributes:
        steps: By step; a step without anything is missing.
        results: The results that those in `steps` stand on, by id.
    """

    steps: dict[str, StepSnapshot] = field(default_factory=dict)
    results: dict[int, StoredResult] = field(default_factory=dict)
