"""Motions: nothing moves that nobody wanted, and everything stops when it has to, whatever happens in which order."""

import threading
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from beltgui.engine import messages as m
from beltgui.engine.guard import MotionGuard
from beltgui.engine.motion import GuardedRobot, GuardedStage
from beltgui.engine.watch import Watch
from beltgui.jobs import Cancelled
from devices.interfaces import Lost, Refused, RobotMover, StagePosition, Stopped
from tests.beltgui.engine_bed import Bed
from tests.beltgui.engine_fakes import PLANNED, WAIT_S, FakeStage, Robot, fake_rooms, pose


@pytest.fixture
def bed(tmp_path: Path) -> Iterator[Bed]:
    with Bed(tmp_path) as bed:
        bed.begin()
        bed.host.stage.hold_next(0)
        yield bed


def moving(bed: Bed) -> None:
    """Begin to take samples; comes back while the robot is on its way to the first pose."""
    bed.host.robot.hold_next()
    bed.driver.send(m.Acquire("ball"))
    assert bed.host.robot.began.acquire(timeout=WAIT_S)


def ended(bed: Bed) -> m.JobEnded:
    found: m.JobEnded = bed.driver.wait_for(lambda event: isinstance(event, m.JobEnded))
    return found


# ---- stop, cancel, lost


def test_stop_during_a_motion(bed: Bed) -> None:
    moving(bed)
    bed.driver.send(m.Stop())
    end = ended(bed)
    assert end.how == "stopped" and "Check that the way is free" in end.message
    assert bed.host.robot.finished == [] and bed.host.stage.stops >= 1
    assert bed.driver.work(m.Acquire("ball")).how == "done"
    motions = [question for question in bed.driver.of(m.Question) if question.kind == "motion"]
    assert len(motions) == 1 + PLANNED, "after a stop nothing moves before a person says go again"


def test_stop_while_the_stage_moves(bed: Bed) -> None:
    bed.host.stage.hold_next()
    bed.driver.send(m.Acquire("ball"))
    assert bed.host.stage.began.acquire(timeout=WAIT_S)
    bed.driver.send(m.Stop())
    assert ended(bed).how == "stopped"
    assert len(bed.host.robot.finished) == 1


def test_cancel_stops_the_motion_under_way(bed: Bed) -> None:
    moving(bed)
    bed.driver.send(m.Cancel())
    assert ended(bed).how == "cancelled"
    assert bed.host.robot.finished == []


def test_stop_while_a_question_is_open(bed: Bed) -> None:
    bed.driver.answer = lambda question: None
    bed.driver.send(m.Acquire("ball"))
    number = bed.driver.wait_for(m.Question).number
    bed.driver.send(m.Stop())
    assert bed.driver.wait_for(m.QuestionGone).number == number
    assert ended(bed).how == "stopped"


def test_stop_without_work_reaches_the_devices(bed: Bed) -> None:
    stopped = threading.Event()
    bed.host.stage.stop = stopped.set  # type: ignore[method-assign]
    bed.driver.send(m.Stop())
    assert stopped.wait(WAIT_S)
    assert bed.driver.work(m.Acquire("ball")).how == "done"


@pytest.mark.parametrize("device", ["robot", "stage", "scanner", "grinder rough", "grinder fine"])
def test_a_device_that_drops_during_a_motion_stops_it_and_is_named(bed: Bed, device: str) -> None:
    moving(bed)
    bed.driver.send(m.SimulateFault(f"{device} lost"))
    end = ended(bed)
    assert end.how == "refused"
    assert end.message.startswith(f"{device}: the connection is gone.") and "motion was stopped" in end.message
    strip = bed.driver.somewhere(
        lambda event: isinstance(event, m.DevicesChanged) and any(d.state == "fault" for d in event.devices)
    )
    assert [state.name for state in strip.devices if state.state == "fault"] == [device]


def test_nothing_begins_to_move_while_a_device_is_gone_but_after_its_return(bed: Bed) -> None:
    bed.driver.send(m.SimulateFault("scanner lost"))
    bed.driver.somewhere(
        lambda event: isinstance(event, m.DevicesChanged) and any(d.state == "fault" for d in event.devices)
    )
    end = bed.driver.work(m.Acquire("ball"))
    assert end.how == "refused" and end.message.startswith("scanner")
    assert bed.host.robot.finished == []
    bed.host.lost.clear()
    assert bed.driver.work(m.Acquire("ball")).how == "done"


def test_a_fault_that_does_not_exist_is_refused(bed: Bed) -> None:
    bed.driver.send(m.SimulateFault("ball eaten"))
    assert "no fault 'ball eaten'" in bed.driver.wait_for(m.Refused).text


# ---- hold to run


def test_letting_go_stops_and_the_motion_goes_on_after_a_new_go(bed: Bed) -> None:
    bed.driver.answer = lambda question: m.Answer(question.number, True, hold=question.kind == "motion")
    bed.host.robot.hold_next()
    bed.driver.send(m.Acquire("ball"))
    assert bed.host.robot.began.acquire(timeout=WAIT_S)
    bed.driver.answer = lambda question: None
    bed.driver.send(m.Hold(False))
    bed.driver.wait_for(lambda event: isinstance(event, m.Question) and event.kind == "motion")
    question = bed.driver.wait_for(lambda event: isinstance(event, m.Question) and event.kind == "motion")
    assert question.text == "The robot moves to go on to pose 1."
    assert np.array_equal(question.path[-1], pose(0))
    assert bed.host.robot.finished == []
    bed.driver.answer = lambda question: m.Answer(question.number, True)
    bed.driver.send(m.Answer(question.number, True))
    assert ended(bed).how == "done"
    assert len(bed.host.robot.finished) == PLANNED


def test_letting_go_in_a_probing_series_asks_before_it_goes_on(tmp_path: Path) -> None:
    with Bed(tmp_path) as bed:
        bed.rooms.update(fake_rooms(ball=True))
        bed.begin()
        bed.driver.answer = lambda question: m.Answer(question.number, True, hold=question.kind == "motion")
        bed.host.robot.hold_next()
        bed.driver.send(m.Acquire("ball"))
        assert bed.host.robot.began.acquire(timeout=WAIT_S)
        bed.driver.send(m.Hold(False))
        assert ended(bed).how == "done"
        texts = [question.text for question in bed.driver.of(m.Question) if question.kind == "motion"]
        assert texts == ["The robot moves to probe.", "The robot moves to go on to probe."]


# ---- the guard alone: orders of events that are hard to bring about from outside


class Desk:
    """Guard, robot and stage; every question is answered yes, after `before_answer`."""

    def __init__(self, *, hold: bool = False) -> None:
        self.asked: list[str] = []
        self.before_answer: Any = lambda: None
        self.guard = MotionGuard(self._ask)
        self.robot, self.stage = Robot(), FakeStage()
        self.guard.attach(self.robot, self.stage)
        self.guard.begin_job()
        self.hold = hold
        watch = Watch()
        self.guarded = GuardedRobot(self.robot, self.guard, watch, lambda: None)
        self.guarded_stage = GuardedStage(self.stage, self.guard, watch, lambda: None)  # type: ignore[arg-type]

    def _ask(self, path: Any, purpose: str) -> bool:
        self.asked.append(purpose)
        self.guard.answered(m.Answer(1, True, hold=self.hold))
        self.before_answer()
        return True


@pytest.fixture
def desk() -> Iterator[Desk]:
    desk = Desk()
    yield desk
    desk.robot.arrive()
    desk.guard.close()
    assert desk.guard.join(WAIT_S)


def test_the_guarded_robot_is_a_mover(desk: Desk) -> None:
    assert isinstance(desk.guarded, RobotMover)
    assert desk.guarded.limits == desk.robot.limits


@pytest.mark.parametrize("speed", [250.1, 1e9, -1.0, float("nan")])
def test_more_than_250_mm_s_is_refused(desk: Desk, speed: float) -> None:
    for call in (desk.guarded.preview, desk.guarded.move_to):
        with pytest.raises(Refused, match="speed"):
            call(pose(0), speed_mm_s=speed)  # type: ignore[operator]
    assert desk.robot.finished == [] and desk.asked == []


def test_a_motion_that_nobody_was_asked_about_is_asked_for(desk: Desk) -> None:
    desk.guarded.move_to(pose(0))
    assert desk.asked == ["to go on"]


def test_a_stop_between_go_and_motion_is_not_lost(desk: Desk) -> None:
    desk.before_answer = desk.guard.stop
    with pytest.raises(Stopped):
        desk.guarded.move_to(pose(0))
    assert desk.robot.finished == []


def test_a_stop_that_the_driver_forgets_is_repeated(desk: Desk) -> None:
    desk.robot.forget_stops = 3
    desk.robot.hold_next()
    thread = threading.Thread(target=lambda: (desk.robot.began.acquire(timeout=WAIT_S), desk.guard.stop()))
    thread.start()
    with pytest.raises(Stopped):
        desk.guarded.move_to(pose(0))
    thread.join()
    assert desk.robot.stops > 3


def test_after_a_stop_nothing_moves_until_new_work_begins(desk: Desk) -> None:
    desk.guard.stop()
    for motion in (lambda: desk.guarded.move_to(pose(0)), lambda: desk.guarded_stage.move_to(StagePosition(0, 0, 0)),
                   desk.guarded_stage.home):  # fmt: skip
        with pytest.raises(Stopped):
            motion()
    assert desk.asked == []
    desk.guard.begin_job()
    desk.guarded.move_to(pose(0))
    assert desk.asked == ["to go on"]


def test_a_button_let_go_before_the_motion_began_asks_again(desk: Desk) -> None:
    desk.hold = True
    releases = iter([True, False])
    desk.before_answer = lambda: next(releases) and desk.guard.hold(False)
    desk.guarded.move_to(pose(0))
    assert len(desk.asked) == 2 and len(desk.robot.finished) == 1


def test_a_screen_that_does_not_repeat_its_hold_any_more_counts_as_let_go(desk: Desk) -> None:
    desk.hold = True
    desk.before_answer = lambda: desk.guard.hold(True) if len(desk.asked) == 1 else None
    desk.robot.hold_next()
    desk.guarded.move_to(pose(0))
    assert len(desk.asked) == 2 and desk.robot.stops >= 1


def test_a_stop_of_the_robot_by_its_own_panel_ends_the_motion(desk: Desk) -> None:
    desk.robot.hold_next()
    thread = threading.Thread(target=lambda: (desk.robot.began.acquire(timeout=WAIT_S), desk.robot.stop()))
    thread.start()
    with pytest.raises(Stopped, match="on the way"):
        desk.guarded.move_to(pose(0))
    thread.join()


def test_a_cancel_ends_the_motion_as_cancelled(desk: Desk) -> None:
    desk.before_answer = desk.guard.cancel
    with pytest.raises(Cancelled):
        desk.guarded.move_to(pose(0))


def test_a_lost_robot_that_cannot_be_stopped_ends_the_motion_with_its_own_error(desk: Desk) -> None:
    def lost() -> None:
        raise Lost("robot", "the connection is gone.")

    desk.robot.stop = lost  # type: ignore[method-assign]
    desk.robot.hold_next()

    def fail() -> None:
        desk.robot.began.acquire(timeout=WAIT_S)
        desk.guard.device_failed(Lost("robot", "the connection is gone."))
        desk.robot.arrive()

    thread = threading.Thread(target=fail)
    thread.start()
    with pytest.raises(Lost, match="motion was stopped"):
        desk.guarded.move_to(pose(0))
    thread.join()
