"""The engine with fake rooms: every command and refusal, questions, results and what the screen is shown."""

from collections.abc import Iterator
from pathlib import Path
from typing import Any

import pytest

from beltgui.engine import messages as m
from beltgui.session import Session
from beltgui.steps.state import STEPS, StepState
from beltgui.viewmodel.step import Action
from tests.beltgui.engine_bed import Bed
from tests.beltgui.engine_driver import Driver
from tests.beltgui.engine_fakes import PLANNED, FakeHost


@pytest.fixture
def bed(tmp_path: Path) -> Iterator[Bed]:
    with Bed(tmp_path) as bed:
        yield bed


@pytest.fixture
def begun(bed: Bed) -> Bed:
    bed.begin()
    return bed


def refused(bed: Bed, command: m.Command) -> str:
    bed.driver.send(command)
    return str(bed.driver.wait_for(m.Refused).text)


# ---- sessions


def test_a_new_session_is_shown_at_once_and_then_with_its_content(bed: Bed) -> None:
    bed.begin()
    opened = bed.driver.of(m.SessionOpened)[0]
    assert (opened.person, opened.read_only) == ("A. Person", False)
    assert {"software", "blade", "cell", "serial", "grinder", "date", "simulated", "seed", "probing_grid", "resolution",
            "speed", "person"} <= opened.info.keys()  # fmt: skip
    assert {path.name for path in (bed.folder / "inputs").iterdir()} == {"simulated.toml", "dr95.toml", "dr95.step"}
    shown = [event.view for event in bed.driver.of(m.StepChanged)]
    assert [view.step for view in shown[:6]] == list(STEPS)
    assert all(view.content is None and view.state is StepState.NOT_STARTED for view in shown[:6])
    ball, base = bed.driver.views["ball"], bed.driver.views["base"]
    assert ball.actions == {Action.ACQUIRE}
    assert base.actions == frozenset() and base.why


@pytest.mark.parametrize(
    ("wrong", "says"),
    [
        ({"blade_type": "dr1"}, "no blade type"),
        ({"person": "  "}, "Nobody is named"),
        ({"serial": "???"}, "no serial number"),
        ({"cell_file": "/nowhere.toml"}, "nowhere.toml"),
        ({"folder": "/proc/nowhere"}, "/proc/nowhere"),
    ],
)
def test_a_session_that_cannot_be_begun_is_refused(bed: Bed, wrong: dict[str, Any], says: str) -> None:
    ended = bed.driver.work(m.NewSession(**{"folder": str(bed.folder), "person": "A. Person", **wrong}))
    assert ended.how == "refused"
    assert says in ended.message
    assert not (bed.folder / "session.db").exists()


def test_without_a_session_everything_is_refused(bed: Bed) -> None:
    commands = (m.Acquire("ball"), m.Solve("ball"), m.Accept("ball"), m.Undo("ball"), m.Export("x"), m.Compare("x"))
    for command in commands:
        assert "No session is open" in refused(bed, command)
    assert "no simulated cell" in refused(bed, m.SimulateFault("robot lost"))
    assert "no step 'ground'" in refused(bed, m.Solve("ground"))


def test_a_reopened_session_stands_where_it_stood(begun: Bed, tmp_path: Path) -> None:
    begun.accept("ball")
    before = begun.driver.views["ball"]
    begun.driver.close()
    with Driver(rooms=begun.rooms, build_host=FakeHost, read_model=lambda path: None) as again:
        assert again.work(m.OpenSession(str(begun.folder), "B. Person")).how == "done"
        first = next(event.view for event in again.of(m.StepChanged) if event.view.step == "ball")
        assert first.state is StepState.ACCEPTED and first.content is None
        ball = again.views["ball"]
        assert (ball.state, ball.headline, ball.actions) == (before.state, before.headline, before.actions)
        assert ball.content is not None and ball.content.ok
        assert again.views["base"].actions == {Action.ACQUIRE}
    with Session.open(begun.folder) as session:
        assert session.result("ball") == session.accepted_result("ball")


def test_a_session_to_look_at_cannot_be_changed(begun: Bed) -> None:
    begun.accept("ball")
    begun.driver.close()
    with Driver(rooms=begun.rooms, build_host=FakeHost, read_model=lambda path: None) as reader:
        assert reader.work(m.OpenSession(str(begun.folder), "B. Person", read_only=True)).how == "done"
        assert reader.views["ball"].content is not None
        assert all(not view.actions for view in reader.views.values())
        for command in (m.Acquire("ball"), m.Accept("ball"), m.Include("ball", 1, False), m.StartOver("ball")):
            reader.send(command)
            assert "to look at only" in reader.wait_for(m.Refused).text


def test_a_fault_in_one_step_does_not_keep_the_session_closed(begun: Bed) -> None:
    begun.accept("ball")
    begun.rooms["ball"].broken = "solve"
    begun.driver.send(m.OpenSession(str(begun.folder), "A. Person"))
    assert "a bug in solve" in begun.driver.wait_for(m.Crashed).text
    assert begun.driver.wait_for(m.JobEnded).how == "done"
    assert begun.driver.views["ball"].content is not None


def test_restoring_can_be_cancelled(begun: Bed) -> None:
    begun.accept("ball")
    begun.rooms["ball"].gate.clear()
    begun.rooms["ball"].solving.clear()
    begun.driver.send(m.OpenSession(str(begun.folder), "A. Person"))
    assert begun.rooms["ball"].solving.wait(20.0)
    begun.driver.send(m.Cancel())
    assert begun.driver.wait_for(m.JobEnded).how == "cancelled"
    begun.rooms["ball"].gate.set()
    assert begun.driver.work(m.Solve("ball")).how == "done"
    assert begun.driver.views["ball"].state is StepState.ACCEPTED


# ---- the rhythm of a step


def test_a_step_is_acquired_solved_and_accepted(begun: Bed) -> None:
    assert begun.driver.work(m.Acquire("ball")).how == "done"
    shown = [event.view for event in begun.driver.of(m.StepChanged) if event.view.step == "ball"]
    growing = [view for view in shown if view.state is StepState.RUNNING and view.content and view.content.provisional]
    assert [len(view.content.rows) for view in growing if view.content] == [1, 2, 3]
    assert "expected 2 or more" in growing[0].content.progress  # type: ignore[union-attr]
    assert all(not view.actions for view in growing)
    assert [view.generation for view in shown] == sorted({view.generation for view in shown})
    ball = begun.driver.views["ball"]
    assert ball.actions == {Action.SOLVE, Action.START_OVER, Action.ACCEPT}
    begun.driver.send(m.Accept("ball"))
    begun.driver.view("ball", lambda view: view.state is StepState.ACCEPTED)
    begun.driver.view("base", lambda view: view.actions == {Action.ACQUIRE})
    assert "accepted already" in refused(begun, m.Accept("ball"))


def test_a_step_that_stands_on_others_cannot_begin_before_them(begun: Bed) -> None:
    assert "Base needs Ball" in refused(begun, m.Acquire("base"))
    assert "no samples" in refused(begun, m.Solve("ball"))
    assert "no result to accept" in refused(begun, m.Accept("ball"))


def test_a_rejected_result_cannot_be_accepted(begun: Bed) -> None:
    begun.driver.work(m.Acquire("ball"))
    assert begun.driver.work(m.Choose("ball", "bad", True)).how == "done"
    assert begun.driver.views["ball"].state is StepState.FAILED
    assert Action.ACCEPT not in begun.driver.views["ball"].actions
    assert "rejected" in refused(begun, m.Accept("ball"))


def test_edits_are_solved_again_and_undone(begun: Bed) -> None:
    begun.accept("ball")
    row = begun.driver.views["ball"].content.rows[0]  # type: ignore[union-attr]
    assert begun.driver.work(m.Include("ball", row.id, False)).how == "done"
    ball = begun.driver.views["ball"]
    assert ball.content is not None and not ball.content.ok and Action.UNDO in ball.actions
    assert begun.driver.views["base"].why
    assert begun.driver.work(m.Undo("ball")).how == "done"
    assert begun.driver.views["ball"].state is StepState.ACCEPTED
    assert begun.driver.work(m.Redo("ball")).how == "done"
    assert begun.driver.work(m.Undo("ball")).how == "done"
    assert begun.driver.work(m.Delete("ball", row.id)).how == "done"
    assert len(begun.driver.views["ball"].content.rows) == PLANNED - 1  # type: ignore[union-attr]
    assert begun.driver.work(m.StartOver("ball")).how == "done"
    assert begun.driver.views["ball"].content.rows == ()  # type: ignore[union-attr]
    assert Action.ACQUIRE in begun.driver.views["ball"].actions
    assert begun.driver.work(m.Include("ball", 999, True)).how == "refused"


def test_undo_without_an_edit_is_refused(begun: Bed) -> None:
    assert begun.driver.work(m.Undo("ball")).message == "There is nothing to undo."
    assert begun.driver.work(m.Redo("ball")).message == "There is nothing to do again."


def test_a_setting_of_the_picture_is_not_solved_again(begun: Bed) -> None:
    begun.accept("ball")
    solved = begun.rooms["ball"].solved
    assert begun.driver.work(m.Choose("ball", "show_exaggeration", 50)).how == "done"
    assert begun.rooms["ball"].solved == solved
    assert begun.driver.views["ball"].state is StepState.ACCEPTED


def test_a_second_job_is_refused_but_an_edit_takes_the_place_of_the_solving(begun: Bed) -> None:
    begun.driver.work(m.Acquire("ball"))
    room = begun.rooms["ball"]
    row = begun.driver.views["ball"].content.rows[0]  # type: ignore[union-attr]
    room.gate.clear()
    room.solving.clear()
    begun.driver.send(m.Solve("ball"))
    assert room.solving.wait(20.0)
    assert "'Solving' is under way" in refused(begun, m.Acquire("tool"))
    assert "'Solving' is under way" in refused(begun, m.Solve("ball"))
    begun.driver.send(m.Include("ball", row.id, False))
    begun.driver.send(m.Choose("ball", "bad", True))
    assert begun.driver.wait_for(m.JobEnded).how == "cancelled"
    assert begun.driver.wait_for(m.JobEnded).how == "cancelled"
    room.gate.set()
    assert begun.driver.wait_for(m.JobEnded).how == "done"
    shown = begun.driver.views["ball"].content
    assert shown is not None and [row.included for row in shown.rows] == [False, True, True]
    with Session.open(begun.folder) as session:
        assert session.setting("ball", "bad") is True


def test_an_edit_of_a_step_that_is_being_acquired_is_refused(begun: Bed) -> None:
    begun.driver.work(m.Acquire("tool"))
    begun.driver.answer = lambda question: None
    begun.driver.send(m.Acquire("ball"))
    begun.driver.wait_for(m.Question)
    assert "'Taking samples' is under way" in refused(begun, m.StartOver("ball"))
    assert "'Taking samples' is under way" in refused(begun, m.Undo("tool"))


def test_a_solving_that_is_cancelled_says_so(begun: Bed) -> None:
    begun.driver.work(m.Acquire("ball"))
    room = begun.rooms["ball"]
    room.gate.clear()
    room.solving.clear()
    begun.driver.send(m.Solve("ball"))
    assert room.solving.wait(20.0)
    begun.driver.send(m.Cancel())
    assert begun.driver.wait_for(m.JobEnded).how == "cancelled"
    begun.driver.view("ball", lambda view: "ended early" in view.content.progress)  # type: ignore[union-attr]
    assert "no result to accept" in refused(begun, m.Accept("ball"))


def test_a_fault_of_the_program_is_told_with_its_traceback_and_keeps_the_engine_going(begun: Bed) -> None:
    begun.rooms["ball"].broken = "acquire"
    begun.driver.send(m.Acquire("ball"))
    ended = begun.driver.wait_for(lambda event: isinstance(event, m.JobEnded))
    assert ended.how == "crashed" and "a bug in acquire" in ended.message
    begun.rooms["ball"].broken = "view"
    begun.driver.send(m.Acquire("ball"))
    assert "a bug in view" in begun.driver.wait_for(m.Crashed).text
    while isinstance(event := begun.driver.wait_for(lambda e: isinstance(e, m.Crashed | m.JobEnded)), m.Crashed):
        assert "a bug in view" in event.text
    assert event.how == "done"
    with Session.open(begun.folder) as session:
        assert len(session.samples("ball")) == PLANNED


# ---- whole sessions


def test_everything_accepted_is_exported_and_compared(begun: Bed, tmp_path: Path) -> None:
    assert "is not started" in refused(begun, m.Export(str(tmp_path)))
    for step in STEPS:
        begun.accept(step)
    begun.driver.view("error_surface", lambda view: Action.EXPORT in view.actions)
    assert begun.driver.work(m.Export(str(tmp_path / "out"))).how == "done"
    assert begun.driver.of(m.Exported)[0].files == (str(tmp_path / "out" / "a.script"),)
    assert begun.driver.work(m.Compare(str(begun.folder))).how == "done"
    assert begun.driver.of(m.Compared)[0].folder == str(begun.folder)
    assert begun.driver.work(m.Compare(str(tmp_path / "nothing"))).how == "refused"
    begun.driver.work(m.Choose("ball", "bad", True))
    begun.driver.view("base", lambda view: view.state is StepState.STALE)
    assert "stale" in refused(begun, m.Export(str(tmp_path)))


# ---- questions


def test_a_declined_mount_ends_the_job_in_words(begun: Bed) -> None:
    begun.driver.answer = lambda question: m.Answer(question.number, False)
    ended = begun.driver.work(m.Acquire("ball"))
    assert ended.how == "refused" and "declined" in ended.message
    assert begun.hosts[0].hand.done == []
    assert begun.driver.of(m.QuestionGone)


def test_a_declined_motion_keeps_what_was_taken_and_goes_on_later(begun: Bed) -> None:
    begun.driver.answer = lambda question: m.Answer(question.number, "pose 3" not in question.text)
    ended = begun.driver.work(m.Acquire("ball"))
    assert ended.how == "refused" and "not wanted" in ended.message
    assert len(begun.driver.views["ball"].content.rows) == 2  # type: ignore[union-attr]
    begun.driver.answer = lambda question: m.Answer(question.number, True)
    begun.driver.work(m.Acquire("ball"))
    questions = begun.driver.of(m.Question)
    assert [question.kind for question in questions] == ["mount", "motion", "motion", "motion", "motion"]
    assert len(begun.hosts[0].hand.done) == 1, "the ball is there, nobody is asked for it again"
    assert len(begun.driver.views["ball"].content.rows) == PLANNED  # type: ignore[union-attr]
    motion = questions[1]
    assert motion.text == "The robot moves to pose 1." and motion.picture == "motion"
    assert motion.length_mm == pytest.approx(100.0) and motion.path is not None and motion.speed_mm_s == 250.0


def test_one_answer_for_a_series(begun: Bed) -> None:
    begun.driver.answer = lambda question: m.Answer(question.number, True, for_series=True)
    begun.driver.work(m.Acquire("ball"))
    assert [question.kind for question in begun.driver.of(m.Question)] == ["mount", "motion"]
    begun.driver.work(m.Acquire("tool"))
    assert [question.kind for question in begun.driver.of(m.Question)] == ["mount", "motion", "motion"]


def test_a_second_click_changes_nothing(begun: Bed) -> None:
    begun.driver.answer = lambda question: None
    begun.driver.send(m.Acquire("ball"))
    number = begun.driver.wait_for(m.Question).number
    begun.driver.send(m.Answer(number + 7, False))
    begun.driver.send(m.Answer(number, True))
    begun.driver.send(m.Answer(number, False))
    assert begun.driver.wait_for(m.Question).kind == "motion"
    begun.driver.send(m.Answer(number, False))
    begun.driver.send(m.Cancel())
    assert begun.driver.wait_for(m.JobEnded).how == "cancelled"


# ---- the end


def test_shutting_down_ends_a_waiting_job_and_all_threads(begun: Bed) -> None:
    begun.driver.answer = lambda question: None
    begun.driver.send(m.Acquire("ball"))
    begun.driver.wait_for(m.Question)
    begun.driver.close()
    with Session.open(begun.folder, write=True) as session:
        assert session.writable
