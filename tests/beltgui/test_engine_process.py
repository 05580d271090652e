"""The engine in a process of its own: starts anywhere, survives nothing it must not survive, loses nothing."""

import os
import select
import signal
import subprocess
import sys
from pathlib import Path

import pytest

from beltgui.engine import messages as m
from beltgui.session import Session
from beltgui.viewmodel.step import StepView
from tests.beltgui.engine_driver import Driver

END_MS = 20_000
ROOT = Path(__file__).parents[2]


def watched(pid: int) -> select.poll:
    """Says when a process has ended, also one that is not a child."""
    poll = select.poll()
    poll.register(os.pidfd_open(pid), select.POLLIN)
    return poll


def rows(view: StepView) -> int:
    """Samples shown."""
    return len(view.content.rows) if view.content is not None else 0


def begin(driver: Driver, folder: Path, speed: float = 0.0) -> None:
    command = m.NewSession(str(folder), "A. Person", resolution="test", speed=speed)
    assert driver.work(command, 120.0).how == "done"


def test_the_engine_runs_beside_and_ends_when_it_is_told(tmp_path: Path) -> None:
    with Driver(process=True) as driver:
        assert driver.handle is not None and driver.handle.pid != os.getpid()
        driver.send(m.Acquire("ball"))
        assert "No session is open" in driver.wait_for(m.Refused).text
        assert os.getpriority(os.PRIO_PROCESS, driver.handle.pid) >= os.getpriority(os.PRIO_PROCESS, 0)
        os.kill(driver.handle.pid, signal.SIGINT)  # Ctrl-C in the parent's terminal reaches the child too
        driver.send(m.Acquire("ball"))
        driver.wait_for(m.Refused)
        ended = watched(driver.handle.pid)
    assert ended.poll(END_MS)
    assert not driver.handle.alive
    assert driver.handle.send(m.Stop()) is False
    assert driver.end == "", "it was asked to end"


def test_what_was_taken_is_there_after_the_engine_was_killed(tmp_path: Path) -> None:
    folder = tmp_path / "session"
    with Driver(process=True) as driver:
        begin(driver, folder)
        driver.send(m.Acquire("ball"))
        driver.view("ball", lambda view: rows(view) >= 2, 120.0)
        assert driver.handle is not None
        os.kill(driver.handle.pid, signal.SIGKILL)
        with pytest.raises(TimeoutError, match="has ended by itself"):
            driver.wait_for(m.Exported)
    with Driver(process=True) as again:
        assert again.work(m.OpenSession(str(folder), "A. Person"), 120.0).how == "done"
        there = rows(again.views["ball"])
        assert there >= 2
        again.send(m.Acquire("ball"))
        again.view("ball", lambda view: rows(view) > there, 120.0)
        again.send(m.Cancel())
        assert again.wait_for(m.JobEnded).how == "cancelled"
        assert again.of(m.Question) == [], "the ball is mounted and the robot is there"
    with Session.open(folder) as session:
        slots = [sample.data["slot"] for sample in session.samples("ball", "scan")]
        assert len(slots) > there and slots == list(range(len(slots)))


def test_a_crash_of_native_code_is_told_with_its_trace() -> None:
    with Driver(process=True) as driver:
        assert driver.handle is not None
        os.kill(driver.handle.pid, signal.SIGABRT)
        with pytest.raises(TimeoutError):
            driver.wait_for(m.Exported)
        assert "Fatal Python error: Aborted" in driver.end and "serve" in driver.end


@pytest.mark.parametrize("end", ["killed", "closed"])
def test_the_engine_ends_with_its_parent(end: str) -> None:
    environment = {**os.environ, "PYTHONPATH": str(ROOT)}
    with subprocess.Popen(
        [sys.executable, str(Path(__file__).with_name("engine_parent.py"))],
        stdin=subprocess.PIPE, stdout=subprocess.PIPE, text=True, env=environment,
    ) as parent:  # fmt: skip
        assert parent.stdin is not None and parent.stdout is not None
        ended = watched(int(parent.stdout.readline()))
        if end == "killed":
            parent.kill()
        else:
            parent.stdin.close()
        assert ended.poll(END_MS), "the engine lives on without a screen"
