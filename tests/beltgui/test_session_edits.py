"""Edits of a step's samples and settings, undo and redo, across closing and opening."""

from __future__ import annotations

import shutil
import tempfile
from collections.abc import Callable, Iterator
from pathlib import Path
from typing import Any

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from beltgui.session import Session
from core.errors import InputError


@pytest.fixture
def session(tmp_path: Path) -> Iterator[Session]:
    with Session.create(tmp_path, {}) as session:
        yield session


def add(session: Session, *slots: int, **more: Any) -> list[int]:
    return [session.add_sample("tool", "shaft_touch", {"slot": slot, **more}).id for slot in slots]


def living(session: Session) -> list[int]:
    return [sample.id for sample in session.samples("tool")]


def test_each_edit_is_undone_and_done_again_in_words(session: Session) -> None:
    one, two = add(session, 0, 1)
    session.include(one, False, "Ada")
    session.delete(two, "Ada")
    session.choose("tool", "grinder", "fine", "Ada")
    assert (living(session), session.setting("tool", "grinder"), session.basis("tool").samples) == ([one], "fine", ())
    assert session.undo("tool", "Bob") == "setting 'grinder' changed"
    assert session.setting("tool", "grinder") is None and session.basis("tool").settings == {}
    assert session.undo("tool", "Bob") == "sample 2 deleted"
    assert session.undo("tool", "Bob") == "sample 1 left out"
    assert session.undo("tool", "Bob") is None and not session.can_undo("tool")
    assert session.basis("tool").samples == (one, two)
    assert [session.redo("tool", "Bob") for _ in range(4)] == [
        "sample 1 left out", "sample 2 deleted", "setting 'grinder' changed", None]  # fmt: skip
    assert (living(session), session.setting("tool", "grinder")) == ([one], "fine")
    assert [(edit.person, edit.state) for edit in session.edits()] == [("Ada", "done")] * 3
    assert [decision.what for decision in session.decisions()][-1] == "done again: setting 'grinder' changed"
    assert {decision.person for decision in session.decisions()} == {"Bob"}


def test_a_new_edit_drops_what_was_undone_but_the_log_keeps_it(session: Session) -> None:
    one, two = add(session, 0, 1)
    session.include(one, False, "Ada")
    session.undo("tool", "Ada")
    session.include(two, False, "Ada")
    assert not session.can_redo("tool") and session.redo("tool", "Ada") is None
    assert [edit.state for edit in session.edits("tool")] == ["dropped", "done"]


def test_steps_are_undone_apart(session: Session) -> None:
    session.choose("rough", "method", "pairs", "Ada")
    session.choose("fine", "faces", [1, 2], "Ada")
    assert session.undo("rough", "Ada") == "setting 'method' changed"
    assert not session.can_undo("rough") and session.can_undo("fine") and not session.can_undo("ball")
    assert session.setting("fine", "faces") == [1, 2]


def test_what_changes_nothing_is_no_edit(session: Session) -> None:
    (one,) = add(session, 0)
    session.include(one, True, "Ada")
    session.start_over("ball", "Ada")
    session.choose("tool", "grinder", None, "Ada")  # it was never set
    session.choose("tool", "grinder", "fine", "Ada")
    session.choose("tool", "grinder", "fine", "Ada")
    session.delete(one, "Ada")
    session.delete(one, "Ada")
    assert [edit.what for edit in session.edits()] == ["setting 'grinder' changed", f"sample {one} deleted"]


def test_a_setting_that_is_taken_back_is_as_if_it_had_never_been(session: Session) -> None:
    before = session.basis("fine")
    session.choose("fine", "faces", [1, 2], "Ada")
    session.choose("fine", "faces", None, "Ada")
    assert session.setting("fine", "faces") is None and session.basis("fine") == before
    session.undo("fine", "Ada")
    assert session.setting("fine", "faces") == [1, 2]


def test_what_cannot_be_edited_is_named(session: Session) -> None:
    (one,) = add(session, 0)
    session.delete(one, "Ada")
    with pytest.raises(InputError, match="Sample 1 was deleted"):
        session.include(one, False, "Ada")
    with pytest.raises(InputError, match="no sample 99"):
        session.delete(99, "Ada")
    assert [(sample.id, sample.deleted) for sample in session.samples("tool", deleted=True)] == [(one, True)]


def test_a_sample_that_comes_back_takes_its_place_again(session: Session) -> None:
    one, two = add(session, 0, 1, grinder="fine")
    session.delete(two, "Ada")
    again, other, elsewhere = (*add(session, 1, 2, grinder="fine"), *add(session, 1, grinder="rough"))
    session.undo("tool", "Ada")
    assert living(session) == [one, two, other, elsewhere]
    session.redo("tool", "Ada")
    assert living(session) == [one, again, other, elsewhere]


def test_starting_over_is_undone_as_a_whole(session: Session) -> None:
    before = add(session, 0, 1, 2)
    session.delete(before[2], "Ada")
    session.start_over("tool", "Ada")
    assert living(session) == []
    after = add(session, 0, 1, 2, 3)
    session.include(after[0], False, "Ada")
    assert session.undo("tool", "Ada") == f"sample {after[0]} left out"
    assert session.undo("tool", "Ada") == "started over, 2 samples deleted"
    assert living(session) == before[:2]
    assert session.undo("tool", "Ada") == f"sample {before[2]} deleted"
    assert living(session) == before
    for _ in range(3):
        session.redo("tool", "Ada")
    assert living(session) == after and session.basis("tool").samples == tuple(after[1:])


# ---- any edits, in any order

State = tuple[dict[int, tuple[bool, bool]], dict[str, Any]]
EDITS = st.lists(
    st.one_of(
        st.tuples(st.just("include"), st.integers(0, 5), st.booleans()),
        st.tuples(st.just("delete"), st.integers(0, 5), st.none()),
        st.tuples(st.just("choose"), st.sampled_from("ab"), st.integers(0, 2)),
        st.tuples(st.sampled_from(["start over", "add", "undo", "redo", "reopen"]), st.integers(0, 2), st.none()),
    ),
    max_size=14,
)


def state(session: Session) -> State:
    there = session.samples("tool", deleted=True)
    return {s.id: (s.included, s.deleted) for s in there}, session.basis("tool").settings


def of_known(found: State, known: State) -> State:
    """Only the samples that were there then."""
    return {number: flags for number, flags in found[0].items() if number in known[0]}, found[1]


@settings(derandomize=True, deadline=None, max_examples=40)
@given(EDITS)
def test_undo_and_redo_lead_back_and_forth_whatever_was_done(edits: list[tuple[str, Any, Any]]) -> None:
    folder = Path(tempfile.mkdtemp())
    session = Session.create(folder / "s", {})
    try:
        add(session, 0, 1)
        done: list[State] = []  # before each edit that can be undone
        undone: list[State] = []  # before each undo that can be redone
        for what, which, value in edits:
            before, count = state(session), len(session.edits())
            numbers = [number for number, (_, deleted) in before[0].items() if not deleted] or [None]
            number = numbers[which % len(numbers)] if isinstance(which, int) else None
            if what == "reopen":
                session.close()
                session = Session.open(folder / "s", write=True)
                assert state(session) == before
            elif what == "undo":
                assert (session.undo("tool", "Ada") is None) == (not done)
                if done:
                    assert of_known(state(session), done[-1]) == done.pop()
                    undone.append(before)
            elif what == "redo":
                assert (session.redo("tool", "Ada") is None) == (not undone)
                if undone:
                    assert state(session) == undone.pop()
                    done.append(before)
            elif what == "add":
                add(session, which)
                undone.clear()
            else:
                perform(session, what, number, which, value)
                if len(session.edits()) > count:
                    done.append(before)
                    undone.clear()
                else:
                    assert state(session) == before
            assert (session.can_undo("tool"), session.can_redo("tool")) == (bool(done), bool(undone))
        while done:
            session.undo("tool", "Ada")
            expected = done.pop()
            assert of_known(state(session), expected) == expected
    finally:
        session.close()
        shutil.rmtree(folder)


def perform(session: Session, what: str, number: int | None, key: Any, value: Any) -> None:
    acts: dict[str, Callable[[], None]] = {
        "include": lambda: session.include(number or 0, value, "Ada"),
        "delete": lambda: session.delete(number or 0, "Ada"),
        "choose": lambda: session.choose("tool", key, value, "Ada"),
        "start over": lambda: session.start_over("tool", "Ada"),
    }
    if what in ("choose", "start over") or number is not None:
        acts[what]()
