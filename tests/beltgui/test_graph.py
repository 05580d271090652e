"""Which result stands on which: states, reasons, the way back and the export's lock."""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from beltgui.session import Session
from beltgui.steps import graph
from beltgui.steps.graph import NEEDS, acceptance_lock, export_lock, standing, stands_on
from beltgui.steps.state import STEPS, StepState
from core.errors import InputError
from core.frames import Array, rigid, rotation_from_rotvec

SIGMA_MM = 0.001
PERSON = "Ada"


def pose(x_mm: float = 0.0, turn_deg: float = 0.0) -> dict[str, Any]:
    """A record's pose block, known to 0.001 mm and 1e-6 rad."""
    matrix: Array = rigid(rotation_from_rotvec([0.0, 0.0, np.radians(turn_deg)]), [x_mm, 0.0, 0.0])
    covariance = np.diag([1e-12] * 3 + [SIGMA_MM**2] * 3)
    return {"matrix": matrix.tolist(), "covariance": covariance.tolist(), "covariance_about_mm": [0.0, 0.0, 0.0]}


def record(step: str, x_mm: float = 0.0, turn_deg: float = 0.0, ok: bool = True) -> dict[str, Any]:
    block = pose(x_mm, turn_deg)
    verdict = {"ok": ok, "reasons": [] if ok else [{"code": "HIGH_RESIDUAL", "message": "Too far. Clean the ball."}]}
    body: dict[str, Any] = {
        "ball": {"stage": {"measure_from_scanner": block}},
        "base": {"base_from_measure": block, "ball_in_flange_mm": [1.0, 2.0, 3.0], "ball_sigma_mm": [0.01] * 3},
        "rough": {"measure_from_work": block},
        "fine": {"measure_from_work": block, "flange_from_work": {"matrix": block["matrix"]}},
        "tool": {
            "wheels": {"rough": {"base_from_tool": block}, "fine": {"base_from_tool": block}},
            "stylus": {"tip_in_flange_mm": [x_mm, 0.0, 0.0]},
        },
        "error_surface": {},
    }[step]
    return {**body, "verdict": verdict}


def solve(session: Session, step: str, x_mm: float = 0.0, turn_deg: float = 0.0, ok: bool = True) -> int:
    """Keep a result of the present samples; returns its number."""
    return session.put_result(
        step, record(step, x_mm, turn_deg, ok), ok=ok, headline=f"{step} 0.01 mm",
        stands_on=stands_on(session, step), person=PERSON,
    ).id  # fmt: skip


def run(session: Session, step: str, x_mm: float = 0.0, turn_deg: float = 0.0, samples: int = 3) -> int:
    for slot in range(samples):
        session.add_sample(step, "scan", {"slot": slot})
    solve(session, step, x_mm, turn_deg)
    return session.accept(step, PERSON).id


def states(session: Session) -> dict[str, str]:
    return {step: str(found.state) for step, found in standing(session).items()}


def stale(session: Session) -> list[str]:
    return [step for step, state in states(session).items() if state == StepState.STALE]


@pytest.fixture
def session(tmp_path: Path) -> Iterator[Session]:
    with Session.create(tmp_path, {}) as session:
        yield session


@pytest.fixture
def finished(session: Session) -> Session:
    """All six steps accepted."""
    for step in STEPS:
        run(session, step)
    return session


# ---- the ordinary way


def test_every_step_stands_on_earlier_ones() -> None:
    for step, needs in NEEDS.items():
        assert all(STEPS.index(need) < STEPS.index(step) for need in needs)


def test_a_fresh_session(session: Session) -> None:
    found = standing(session)
    assert list(found) == list(STEPS)
    assert set(states(session).values()) == {"not started"}
    assert [step for step in STEPS if found[step].can_begin] == ["ball", "tool"]
    assert found["base"].why == ("Base needs Ball, which is not accepted yet.",)
    assert found["ball"].why == () and found["ball"].result_id is None
    lock = export_lock(session)
    assert lock[0] == "Ball is not started." and lock[-1].startswith("To do: Ball (not done yet), then Base (not done")


def test_a_step_goes_from_samples_to_accepted(session: Session) -> None:
    session.add_sample("ball", "scan", {"slot": 0})
    assert (standing(session)["ball"].state, standing(session)["ball"].headline) == (StepState.RUNNING, "1 sample")
    assert acceptance_lock(session, "ball") == ("Ball has no result yet.",)
    number = solve(session, "ball")
    found = standing(session)["ball"]
    assert (found.state, found.headline, found.result_id) == (
        StepState.RUNNING, "ball 0.01 mm – ready to accept", number)  # fmt: skip
    assert acceptance_lock(session, "ball") == () and not standing(session)["base"].can_begin
    session.accept("ball", PERSON)
    found = standing(session)["ball"]
    assert (found.state, found.headline, found.why) == (StepState.ACCEPTED, "ball 0.01 mm", ())
    assert standing(session)["base"].can_begin


def test_all_accepted_frees_the_export(finished: Session) -> None:
    assert set(states(finished).values()) == {"accepted"}
    assert export_lock(finished) == ()


def test_a_rejected_result_is_a_failure_with_its_reasons(session: Session) -> None:
    session.add_sample("ball", "scan", {"slot": 0})
    solve(session, "ball", ok=False)
    found = standing(session)["ball"]
    assert (found.state, found.why) == (StepState.FAILED, ("Too far. Clean the ball.",))
    assert acceptance_lock(session, "ball") == ("The result of Ball was rejected.",)
    assert "Ball failed. Too far. Clean the ball." in export_lock(session)
    session.add_sample("ball", "scan", {"slot": 1})  # no longer what it was solved from
    assert states(session)["ball"] == "running"


def test_nothing_begins_on_what_is_not_accepted(session: Session) -> None:
    with pytest.raises(InputError, match="Base needs Ball, which is not accepted yet"):
        stands_on(session, "base")
    ball = run(session, "ball")
    assert stands_on(session, "base") == {"ball": ball}


# ---- what makes stale


def test_a_sample_left_out_voids_all_that_stands_on_it_and_undo_brings_it_back(finished: Session) -> None:
    before = standing(finished)
    finished.include(1, False, PERSON)
    assert stale(finished) == ["ball", "base", "rough", "fine", "error_surface"]
    assert states(finished)["tool"] == "accepted"
    why = standing(finished)["ball"].why
    assert why[0] == "The samples changed since it was solved: 1 no longer used, 0 new."
    assert "Base is stale. Ball is stale." in export_lock(finished)
    finished.undo("ball", PERSON)
    assert standing(finished) == before and export_lock(finished) == ()


def test_undo_after_solving_again_needs_no_solving(finished: Session) -> None:
    before = standing(finished)
    finished.include(1, False, PERSON)
    solve(finished, "ball", x_mm=0.012, turn_deg=0.004)
    assert states(finished)["ball"] == "running"
    assert standing(finished)["base"].why[0] == (
        "Ball was solved again and waits to be accepted: measure_from_scanner moved by 0.012 mm and 0.004 deg."
    )
    finished.undo("ball", PERSON)
    assert standing(finished) == before
    solve(finished, "ball")  # the screen solves at once after each edit: the same result, not accepted
    assert standing(finished) == before
    finished.accept("ball", PERSON)
    assert standing(finished) == before


def test_the_way_back_names_what_moved_and_by_how_much(finished: Session) -> None:
    finished.include(1, False, PERSON)
    solve(finished, "ball", x_mm=0.012, turn_deg=0.004)
    new = finished.accept("ball", PERSON)
    moved = "Ball was accepted again: measure_from_scanner moved by 0.012 mm and 0.004 deg."
    again = "solve again, no new samples needed"
    found = standing(finished)
    assert (found["ball"].state, found["ball"].result_id) == (StepState.ACCEPTED, new.id)
    assert found["base"].why == (moved, f"Redo: Base ({again}).")
    assert found["base"].headline == again and found["base"].can_begin
    assert found["fine"].why == (
        moved, "Base is stale.", "Rough workpiece is stale.",
        f"Redo: Base ({again}), then Rough workpiece ({again}), then Fine workpiece ({again}).")  # fmt: skip
    assert not found["fine"].can_begin
    assert acceptance_lock(finished, "base") == (moved,)
    with pytest.raises(InputError, match="Fine workpiece needs Base, which is stale"):
        stands_on(finished, "fine")
    for step in ("base", "rough", "fine", "error_surface"):
        assert states(finished)[step] == "stale"
        solve(finished, step)
        assert states(finished)[step] == "running"
        finished.accept(step, PERSON)
    assert export_lock(finished) == ()


@pytest.mark.parametrize(("x_mm", "repair"), [(0.004, graph.Repair.SOLVE), (0.03, graph.Repair.ACQUIRE)])
def test_new_samples_are_wanted_where_something_really_moved(
    finished: Session, x_mm: float, repair: graph.Repair
) -> None:
    """Twice the root of the trace of both covariances is 0.0049 mm."""
    finished.start_over("ball", PERSON)
    run(finished, "ball", x_mm=x_mm)
    assert {standing(finished)[step].repair for step in ("base", "rough", "fine")} == {repair}


def test_samples_left_out_never_ask_for_new_ones(finished: Session) -> None:
    finished.include(1, False, PERSON)
    solve(finished, "ball", x_mm=5.0)
    finished.accept("ball", PERSON)
    assert standing(finished)["base"].repair is graph.Repair.SOLVE


def test_starting_over_goes_by_running_to_accepted(finished: Session) -> None:
    finished.start_over("fine", PERSON)
    found = standing(finished)["fine"]
    assert (found.state, found.headline) == (StepState.STALE, "take new samples")
    finished.add_sample("fine", "scan", {"slot": 0})
    assert (standing(finished)["fine"].state, standing(finished)["fine"].headline) == (StepState.RUNNING, "1 sample")
    assert stale(finished) == ["error_surface"]
    solve(finished, "fine", x_mm=2.0)
    finished.accept("fine", PERSON)
    assert standing(finished)["error_surface"].why == (
        "Fine workpiece was accepted again: measure_from_work moved by 2.000 mm and 0.000 deg; "
        "flange_from_work moved by 2.000 mm and 0.000 deg.",
        "Redo: Error surface (take new samples).",
    )


def test_a_wheel_that_moved_is_named_by_its_grinder(finished: Session) -> None:
    finished.include(finished.samples("tool")[0].id, False, PERSON)
    solve(finished, "tool", x_mm=0.5)
    finished.accept("tool", PERSON)
    assert stale(finished) == ["error_surface"]
    assert standing(finished)["error_surface"].why[0] == (
        "Stylus and tool was accepted again: base_from_tool (rough) moved by 0.500 mm and 0.000 deg; base_from_tool "
        "(fine) moved by 0.500 mm and 0.000 deg; tip_in_flange moved by 0.500 mm."
    )


def test_a_setting_voids_unless_it_only_changes_a_picture(finished: Session) -> None:
    finished.choose("error_surface", "show_exaggeration", 300, PERSON)
    assert export_lock(finished) == ()
    finished.choose("fine", "faces", [3, 4], PERSON)
    assert stale(finished) == ["fine", "error_surface"]
    assert standing(finished)["fine"].why[0] == "The setting 'faces' changed since it was solved."
    finished.undo("fine", PERSON)
    assert export_lock(finished) == ()


def test_the_same_data_rejected_later_lock_the_export(finished: Session) -> None:
    solve(finished, "ball", ok=False)
    assert states(finished)["ball"] == "failed"
    assert "Ball is rejected." in standing(finished)["base"].why
    solve(finished, "ball")
    assert export_lock(finished) == ()


def test_a_result_that_does_not_say_what_it_stands_on_is_not_valid(session: Session) -> None:
    run(session, "ball")
    session.add_sample("base", "scan", {"slot": 0})
    session.put_result("base", record("base"), ok=True)
    session.accept("base", PERSON)
    assert standing(session)["base"].why[0] == "Ball was accepted after this was solved."
    assert states(session)["base"] == "stale"


def test_a_step_may_be_solved_on_what_waits_to_be_accepted(finished: Session) -> None:
    """The screen solves ahead; it counts once what it stands on is accepted."""
    finished.include(1, False, PERSON)
    waiting = solve(finished, "ball", x_mm=0.012)
    finished.put_result("base", record("base"), ok=True, stands_on={"ball": waiting})
    assert standing(finished)["base"].why[0] == "Ball waits to be accepted."
    assert acceptance_lock(finished, "base") == ("Ball waits to be accepted.",)
    finished.undo("ball", PERSON)
    assert export_lock(finished) == ()  # what was accepted stands as before
    assert acceptance_lock(finished, "base") == (
        "Ball went back to its accepted result: measure_from_scanner moved by 0.012 mm and 0.000 deg.",
    )
    finished.redo("ball", PERSON)
    finished.accept("ball", PERSON)
    assert (states(finished)["base"], acceptance_lock(finished, "base")) == ("running", ())
    finished.accept("base", PERSON)
    assert states(finished)["base"] == "accepted"


def test_what_was_never_accepted_goes_stale_too(session: Session) -> None:
    run(session, "ball")
    session.add_sample("base", "scan", {"slot": 0})
    solve(session, "base")
    session.include(1, False, PERSON)
    assert (states(session)["base"], standing(session)["base"].why[0]) == ("stale", "Ball is stale.")


def test_all_of_it_stands_the_same_after_opening_again(finished: Session) -> None:
    finished.include(1, False, PERSON)
    solve(finished, "ball", x_mm=0.012)
    before, lock = standing(finished), export_lock(finished)
    finished.close()
    with Session.open(finished.folder) as session:
        assert standing(session) == before and export_lock(session) == lock
    with Session.open(finished.folder, write=True) as session:
        session.undo("ball", PERSON)
        assert export_lock(session) == ()
