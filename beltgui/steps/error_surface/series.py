"""Which samples of the step belong together: one clamping of the blade, one probing of it, scans around it.

Everything is kept one after the other in the session, so numbers tell what was before what: a marker `clamping` begins
each clamping, a marker `series` each probing of it. A line belongs to the series that its sample names; a reading of
the head or a closing scan counts if it is on the right side of the lines.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from beltgui.session import Sample, Session
from beltgui.steps import head_rest
from beltgui.steps.scans import CLOSING, KIND
from core.path import CellFrames

Array = NDArray[np.float64]
STEP = "error_surface"
CLAMPING = "clamping"
SERIES = "series"
LINE = "line"
CHECK = "check"


@dataclass(frozen=True, eq=False)
class Series:
    """One probing of one clamping, as far as it went.

    Attributes:
        marker: The sample that began it.
        lines: Lines of the grid by slot; of two in one slot the later one.
        checks: Check lines by slot.
        rests: Readings of the head at its stop since the series began.
        rested_after: The last of them was taken after the last line.
        closing: Scans of the blade after the last line, by slot.
    """

    marker: Sample
    lines: dict[int, Sample]
    checks: dict[int, Sample]
    rests: tuple[Sample, ...]
    rested_after: bool
    closing: dict[int, Sample]

    @property
    def grinder(self) -> str:
        """Whose wheel was probed with."""
        return str(self.marker.data["grinder"])

    @property
    def frames(self) -> CellFrames:
        """The frames that the blade was presented by; the measured errors belong to them."""
        data = self.marker.data
        return CellFrames(
            np.array(data["base_from_tool"]), np.array(data["flange_from_work"]), data["wheel_radius_mm"],
            data["contact_side"],
        )  # fmt: skip

    @property
    def samples(self) -> tuple[Sample, ...]:
        """Lines of the grid, then check lines, each in order of their slots."""
        return tuple(self.lines[slot] for slot in sorted(self.lines)) + tuple(
            self.checks[slot] for slot in sorted(self.checks)
        )


@dataclass(frozen=True, eq=False)
class Clamping:
    """The blade as it was clamped last.

    Attributes:
        marker: The sample that began it.
        opening: Scans that its frame is computed from, by slot.
        series: The latest probing on each grinder.
        void: Lines of earlier clampings and series: they do not count any more.
    """

    marker: Sample
    opening: dict[int, Sample]
    series: dict[str, Series]
    void: tuple[Sample, ...]

    @property
    def why(self) -> str:
        """Why the blade was clamped once more; empty for the first time."""
        return str(self.marker.data.get("why", ""))


def current_clamping(session: Session) -> Clamping | None:
    """The latest clamping with what was done in it; None before the first."""
    samples = session.samples(STEP)
    markers = [sample for sample in samples if sample.kind == CLAMPING]
    if not markers:
        return None
    marker = markers[-1]
    since = [sample for sample in samples if sample.id > marker.id]
    opening = _by_slot([sample for sample in since if sample.kind == KIND])
    latest = {sample.data["grinder"]: sample for sample in since if sample.kind == SERIES}
    series = {name: _series(begun, since) for name, begun in latest.items()}
    counted = {sample.id for part in series.values() for sample in part.samples}
    void = tuple(sample for sample in samples if sample.kind in (LINE, CHECK) and sample.id not in counted)
    return Clamping(marker, opening, series, void)


def _series(marker: Sample, since: Sequence[Sample]) -> Series:
    own = [sample for sample in since if sample.data.get("series") == marker.id]
    lines = _by_slot([sample for sample in own if sample.kind == LINE])
    checks = _by_slot([sample for sample in own if sample.kind == CHECK])
    numbers = [sample.id for sample in (*lines.values(), *checks.values())]
    last = max(numbers) if numbers else np.inf
    rests = tuple(
        sample for sample in since
        if sample.kind == head_rest.KIND and sample.id > marker.id and sample.data["grinder"] == marker.data["grinder"]
    )  # fmt: skip
    return Series(
        marker, lines, checks, rests, any(sample.id > last for sample in rests),
        _by_slot([sample for sample in since if sample.kind == CLOSING and sample.id > last]),
    )  # fmt: skip


def _by_slot(samples: Sequence[Sample]) -> dict[int, Sample]:
    return {int(sample.data["slot"]): sample for sample in samples}
