"""The screen's end of the engine: order, what may be dropped, ends, starting again, an engine in its own process."""

import threading
from pathlib import Path

import pytest
from pytestqt.qtbot import QtBot

from beltgui.app.backends import LocalBackend, ProcessBackend
from beltgui.app.client import EngineClient, Inbox
from beltgui.engine.messages import Acquire, JobEnded, JobProgress, OpenSession, Ready, Refused, StepChanged, Stop
from beltgui.steps.state import StepState
from tests.beltgui.fake_engine import JOB, READY, FakeBackend, FakeEngine, moved, opened, view

WAIT_MS = 30_000


def drain(inbox: Inbox) -> list[object]:
    found = []
    while (event := inbox.take()) is not None:
        found.append(event)
    return found


def test_what_only_counts_once_is_kept_once_and_the_rest_in_order() -> None:
    inbox = Inbox()
    first, second, other = view("ball"), view("ball", generation=2), view("base")
    early, late = JobProgress(1, 0.1, ""), JobProgress(1, 0.2, "")
    views = [StepChanged(shown) for shown in (first, other, second)]
    said = [JOB, moved(1.0), early, views[0], moved(2.0), late, *views[1:], JobEnded(1, "done")]
    woken = [inbox.put(event) for event in said]
    assert woken == [True, True, True, True, False, False, True, False, True]
    assert inbox.urgent() and not inbox.empty()
    assert drain(inbox) == [JOB, said[4], late, *views[1:], said[-1]]
    assert inbox.empty() and not inbox.urgent()


def test_events_of_other_threads_arrive_on_this_one_in_order(qtbot: QtBot) -> None:
    engine = FakeEngine()
    seen: list[tuple[str, bool]] = []
    engine.client.event.connect(
        lambda event: seen.append((event.text, threading.current_thread() is threading.main_thread()))
    )
    speaker = threading.Thread(target=lambda: engine.say(*(Refused(str(number)) for number in range(200))))
    speaker.start()
    qtbot.waitUntil(lambda: len(seen) == 200)
    speaker.join()
    assert seen == [(str(number), True) for number in range(200)]
    engine.client.close()


def test_commands_reach_the_engine_while_it_runs(qtbot: QtBot) -> None:
    engine = FakeEngine()
    engine.client.send(Stop())
    engine.client.close()
    engine.client.send(Stop())
    assert engine.now.commands == [Stop()] and engine.now.closed


def test_nothing_arrives_after_close(qtbot: QtBot) -> None:
    engine = FakeEngine()
    seen: list[object] = []
    engine.client.event.connect(seen.append)
    engine.client.ended.connect(seen.append)
    engine.say(READY)
    engine.client.close()
    engine.say(READY)
    engine.now.die("late")
    qtbot.wait(1)
    assert seen == []


def test_what_an_engine_said_before_it_ended_comes_first(qtbot: QtBot) -> None:
    engine = FakeEngine()
    seen: list[object] = []
    engine.client.event.connect(seen.append)
    engine.client.ended.connect(seen.append)
    engine.say(Refused("last words"))
    with qtbot.waitSignal(engine.client.ended):
        engine.now.die("gone")
    assert seen == [Refused("last words"), "gone"] and not engine.client.running


def test_the_end_of_an_earlier_engine_is_not_that_of_this_one(qtbot: QtBot) -> None:
    engine = FakeEngine()
    first = engine.now
    engine.client.restart()
    first.die("late")
    with qtbot.waitSignal(engine.client.event):
        engine.say(READY)
    assert engine.client.running and first.closed


@pytest.mark.parametrize("read_only", [True, False])
def test_a_new_engine_opens_the_session_again(qtbot: QtBot, read_only: bool) -> None:
    engine = FakeEngine()
    with qtbot.waitSignal(engine.client.event, check_params_cb=lambda event: isinstance(event, Ready)):
        engine.say(opened("/data/s", read_only=read_only), READY)
    with qtbot.waitSignal(engine.client.ended):
        engine.now.die()
    engine.client.restart()
    with qtbot.waitSignal(engine.client.event):
        engine.say(READY)
    assert engine.now.commands == [OpenSession("/data/s", "Ada", read_only)]


def test_an_engine_that_never_had_a_session_opens_none(qtbot: QtBot) -> None:
    engine = FakeEngine()
    engine.client.restart()
    with qtbot.waitSignal(engine.client.event):
        engine.say(READY)
    assert engine.now.commands == []


def test_a_burst_is_shown_in_portions_and_whole(qtbot: QtBot) -> None:
    engine = FakeEngine()
    seen: list[object] = []
    engine.client.event.connect(seen.append)
    engine.say(*(StepChanged(view(f"step {number}", StepState.RUNNING)) for number in range(300)))
    qtbot.waitUntil(lambda: len(seen) == 300)
    assert [event.view.step for event in seen] == [f"step {number}" for number in range(300)]


@pytest.mark.parametrize("make", [LocalBackend, ProcessBackend])
def test_a_real_engine_answers_and_ends(qtbot: QtBot, make: type, tmp_path: Path) -> None:
    before = threading.active_count()
    client = EngineClient(make)
    with qtbot.waitSignal(client.event, timeout=WAIT_MS, check_params_cb=lambda event: isinstance(event, Ready)):
        client.start()
    with qtbot.waitSignal(client.event, timeout=WAIT_MS, check_params_cb=lambda event: isinstance(event, Refused)):
        client.send(Acquire("ball"))
    client.close()
    assert threading.active_count() == before


def test_an_engine_process_that_is_killed_says_so(qtbot: QtBot) -> None:
    backend = ProcessBackend()
    client = EngineClient(lambda: backend)
    with qtbot.waitSignal(client.event, timeout=WAIT_MS, check_params_cb=lambda event: isinstance(event, Ready)):
        client.start()
    with qtbot.waitSignal(client.ended, timeout=WAIT_MS) as ended:
        backend._engine._process.kill()
    assert "-9" in ended.args[0] and not client.running
    client.close()


def test_what_is_said_before_anybody_listens_is_kept(qtbot: QtBot) -> None:
    heard: list[object] = []
    backend = ProcessBackend()
    qtbot.waitUntil(lambda: bool(backend._early), timeout=WAIT_MS)
    backend.start(heard.append, heard.append)
    assert isinstance(heard[0], Ready)
    backend.close()


def test_fake_and_real_offer_the_same() -> None:
    for name in ("start", "send", "close"):
        assert all(callable(getattr(kind, name)) for kind in (FakeBackend, LocalBackend, ProcessBackend))
