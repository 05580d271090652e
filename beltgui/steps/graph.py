"""Which result stands on which: what is accepted, what is stale and why, what locks the export, the shortest way back.

A step's accepted result is valid while its included samples and its settings are those it was solved from, each step
that it stands on has the very result that it stood on, and that one is valid. Nothing is kept of this: it is worked out
from the session each time, so undo makes everything valid again.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, replace
from enum import StrEnum

from beltgui.session import Session, Snapshot, StepSnapshot, StoredResult
from beltgui.session.quantities import Movement, movements
from beltgui.steps.state import STEPS, TITLES, StepState
from core.errors import InputError

NEEDS: Mapping[str, tuple[str, ...]] = {
    "ball": (),
    "base": ("ball",),
    "rough": ("ball",),
    "fine": ("ball", "base", "rough"),
    "tool": (),
    "error_surface": ("ball", "base", "fine", "tool"),
}

READY = "ready to accept"


class Repair(StrEnum):
    """What brings a step back."""

    NOTHING = ""
    BEGIN = "not done yet"
    GO_ON = "finish it"
    ACCEPT = "accept"
    SOLVE = "solve again, no new samples needed"
    ACQUIRE = "take new samples"
    IMPROVE = "rejected, see the reasons there"


@dataclass(frozen=True)
class Standing:
    """Where a step stands.

    Attributes:
        state: On the rail.
        headline: The number that matters, or what there is to do.
        why: Why it is stale or failed, cannot begin or is not accepted; the last sentence of a stale one is the
            shortest way back.
        result_id: The result that the state speaks of; None if there is none.
        can_begin: All steps that it stands on are accepted and valid.
        repair: What brings it back, once the steps that it stands on are.
    """

    state: StepState
    headline: str
    why: tuple[str, ...]
    result_id: int | None
    can_begin: bool
    repair: Repair = Repair.NOTHING


def standing(session: Session) -> dict[str, Standing]:
    """Where each step stands."""
    return _Graph(session.snapshot()).standings()


def export_lock(session: Session) -> tuple[str, ...]:
    """Why nothing may be exported, the last sentence the shortest way to free it; empty if it may."""
    found = standing(session)
    locked = [step for step in STEPS if found[step].state is not StepState.ACCEPTED]
    if not locked:
        return ()
    return (*(_locks(step, found[step]) for step in locked), _way("To do", locked, found))


def acceptance_lock(session: Session, step: str) -> tuple[str, ...]:
    """Why the latest result of a step may not be accepted; empty if it may (or is accepted already)."""
    graph = _Graph(session.snapshot())
    latest = graph.of(step).latest
    if latest is None:
        return (f"{TITLES[step]} has no result yet.",)
    reasons = (*graph.changed(step, latest), *graph.moved(step, latest))
    return reasons if latest.ok else (_rejected(step), *reasons)


def stands_on(session: Session, step: str) -> dict[str, int]:
    """The results that the step stands on, as `put_result` wants them.

    Raises:
        InputError: one of them is not accepted, or stale.
    """
    graph = _Graph(session.snapshot())
    missing = graph.missing(step)
    if missing:
        raise InputError(" ".join(missing))
    return {need: accepted.id for need in NEEDS[step] if (accepted := graph.of(need).accepted)}


class _Graph:
    """Of one moment of a session."""

    def __init__(self, snapshot: Snapshot) -> None:
        self._snapshot = snapshot
        self._valid: dict[str, bool] = {}
        for step in STEPS:  # in an order in which each stands on earlier ones
            self._valid[step] = self._is_valid(step)

    def of(self, step: str) -> StepSnapshot:
        return self._snapshot.steps.get(step, StepSnapshot())

    def standings(self) -> dict[str, Standing]:
        found: dict[str, Standing] = {}
        for step in STEPS:
            found[step] = self._standing(step)
            if found[step].state is StepState.STALE:
                way = _way("Redo", _broken_ancestors(step, found), found)
                found[step] = replace(found[step], why=(*found[step].why, way))
        return found

    def missing(self, step: str) -> tuple[str, ...]:
        """Sentences on the steps that have to be accepted before this one can begin."""
        return tuple(
            f"{TITLES[step]} needs {TITLES[need]}, which is "
            f"{'stale' if self.of(need).accepted else 'not accepted yet'}."
            for need in NEEDS[step]
            if not self._valid[need]
        )

    def changed(self, step: str, result: StoredResult) -> tuple[str, ...]:
        """How the step's own samples and settings differ from those of a result."""
        basis = self.of(step).basis
        now, then = set(basis.samples), set(result.samples)
        sentences = []
        if now != then:
            sentences.append(
                f"The samples changed since it was solved: {len(then - now)} no longer used, {len(now - then)} new."
            )
        settings = (f"The setting '{key}' changed since it was solved." for key in basis.changed_settings(result))
        return (*sentences, *settings)

    def moved(self, step: str, result: StoredResult) -> tuple[str, ...]:
        """How the steps that a result stands on are not what they were."""
        return tuple(
            sentence
            for need in NEEDS[step]
            if not self._holds(need, result)
            for sentence in self._what_moved(need, result.stands_on.get(need))
        )

    # ---- one step

    def _standing(self, step: str) -> Standing:
        shown, missing = self.of(step), self.missing(step)
        begin = not missing
        accepted, latest = shown.accepted, shown.latest
        if accepted is not None and self._valid[step]:
            return Standing(StepState.ACCEPTED, accepted.headline, (), accepted.id, begin)
        if latest is not None and self._is_current(step, latest):
            if not latest.ok:
                reasons = _verdict(step, latest)
                return Standing(StepState.FAILED, latest.headline, reasons, latest.id, begin, Repair.IMPROVE)
            why = self._reasons(step, accepted) if accepted is not None else ()
            headline = f"{latest.headline} – {READY}" if latest.headline else READY
            return Standing(StepState.RUNNING, headline, why, latest.id, begin, Repair.ACCEPT)
        known = latest if latest is not None and shown.basis.fits(latest) else accepted or latest
        if not shown.sample_count and accepted is None:
            return Standing(StepState.NOT_STARTED, "", missing, None, begin, Repair.BEGIN)
        if known is None or set(shown.basis.samples) - set(known.samples):
            samples = "1 sample" if shown.sample_count == 1 else f"{shown.sample_count} samples"
            why = self._reasons(step, known) if known is not None else missing
            return Standing(StepState.RUNNING, samples, why, None, begin, Repair.GO_ON)
        repair = Repair.ACQUIRE if self._needs_samples(step, known) else Repair.SOLVE
        if accepted is None and not self.moved(step, known):
            return Standing(StepState.RUNNING, str(repair), self.changed(step, known), known.id, begin, repair)
        return Standing(StepState.STALE, str(repair), self._reasons(step, known), known.id, begin, repair)

    def _reasons(self, step: str, result: StoredResult) -> tuple[str, ...]:
        return (*self.changed(step, result), *self.moved(step, result))

    # ---- valid or not

    def _is_valid(self, step: str) -> bool:
        shown = self.of(step)
        accepted, latest = shown.accepted, shown.latest
        if accepted is None or not self._is_current(step, accepted):
            return False
        # The same data judged again and rejected: what was accepted earlier does not count any more.
        judged_again = latest is not None and latest.id > accepted.id and self._is_current(step, latest)
        return not (judged_again and latest is not None and not latest.ok)

    def _is_current(self, step: str, result: StoredResult) -> bool:
        return self.of(step).basis.fits(result) and all(self._holds(need, result) for need in NEEDS[step])

    def _holds(self, need: str, result: StoredResult) -> bool:
        accepted = self.of(need).accepted
        return self._valid[need] and accepted is not None and result.stands_on.get(need) == accepted.id

    # ---- what moved

    def _newer(self, need: str, old_id: int | None) -> StoredResult | None:
        """The result that takes the place of the one stood on: solved and waiting, or accepted."""
        shown = self.of(need)
        latest, accepted = shown.latest, shown.accepted
        if latest is not None and latest.ok and not self._valid[need] and self._is_current(need, latest):
            return latest if latest.id != old_id else None
        return accepted if accepted is not None and accepted.id != old_id else None

    def _what_moved(self, need: str, old_id: int | None) -> tuple[str, ...]:
        title, shown, newer = TITLES[need], self.of(need), self._newer(need, old_id)
        old = None if old_id is None else self._snapshot.results.get(old_id)
        latest = shown.latest
        if latest is not None and self._is_current(need, latest) and not self._valid[need]:
            if not latest.ok:
                return (f"{title} is rejected.",)
            if old is None or latest.id == old_id:
                return (f"{title} waits to be accepted.",)
        if newer is None:
            return (f"{title} is {'stale' if shown.accepted else 'not accepted'}.",)
        if old is None:
            return (f"{title} was accepted after this was solved.",)
        happened = f"{title} was solved again and waits to be accepted"
        if newer is shown.accepted:
            again = newer.id > old.id
            happened = f"{title} was accepted again" if again else f"{title} went back to its accepted result"
        moved = [_told(movement) for movement in movements(need, old.record, newer.record)]
        sentences = [f"{happened}: {'; '.join(moved)}." if moved else f"{happened}."]
        if newer is shown.accepted and not self._valid[need]:
            sentences.append(f"{title} is stale.")
        return tuple(sentences)

    def _needs_samples(self, step: str, result: StoredResult) -> bool:
        """False if solving again from the samples that are there will do.

        Samples no longer fit where something they depend on was measured anew after they were taken, and moved by more
        than its uncertainty.
        """
        own = self.of(step).basis.samples
        if not own:
            return True
        for need in NEEDS[step]:
            old_id = result.stands_on.get(need)
            newer = self._newer(need, old_id)
            old = None if old_id is None else self._snapshot.results.get(old_id)
            if newer is None or old is None:
                continue
            measured_since = any(number > own[0] for number in set(newer.samples) - set(old.samples))
            if measured_since and any(m.beyond_chance() for m in movements(need, old.record, newer.record)):
                return True
        return False


# ---- sentences


def _told(movement: Movement) -> str:
    turn = "" if movement.deg is None else f" and {movement.deg:.3f} deg"
    return f"{movement.name} moved by {movement.mm:.3f} mm{turn}"


def _verdict(step: str, result: StoredResult) -> tuple[str, ...]:
    reasons = result.record.get("verdict", {}).get("reasons", [])
    return tuple(str(reason["message"]) for reason in reasons) or (_rejected(step),)


def _rejected(step: str) -> str:
    return f"The result of {TITLES[step]} was rejected."


def _locks(step: str, found: Standing) -> str:
    title = TITLES[step]
    if found.state is StepState.STALE:
        return f"{title} is stale. {found.why[0]}"
    if found.state is StepState.FAILED:
        return f"{title} failed. {found.why[0]}"
    return f"{title} is not started." if found.state is StepState.NOT_STARTED else f"{title} is not accepted yet."


def _broken_ancestors(step: str, found: Mapping[str, Standing]) -> list[str]:
    """The step and all it stands on, near and far, that are not accepted and valid; in their order."""
    wanted, todo = {step}, [step]
    while todo:
        new = [need for need in NEEDS[todo.pop()] if need not in wanted]
        wanted.update(new)
        todo += new
    return [name for name in STEPS if name in wanted and found[name].state is not StepState.ACCEPTED]


def _way(what: str, steps: list[str], found: Mapping[str, Standing]) -> str:
    return f"{what}: {', then '.join(f'{TITLES[step]} ({found[step].repair})' for step in steps)}."
