"""Drives a screen in a process of its own, keeps what it announced, and kills its engine or both."""

from __future__ import annotations

import json
import os
import select
import signal
import subprocess
import sys
import threading
import time
from collections.abc import Callable
from pathlib import Path
from typing import Any

ROOT = Path(__file__).parents[2]
Line = dict[str, Any]
WAIT_S = 300.0


class MissedError(Exception):
    """The run did not do what it has to; says what."""


class Announced:
    """What a person has been shown so far, over all screens of a session."""

    def __init__(self) -> None:
        self.samples: dict[int, str] = {}
        self.accepted: set[str] = set()
        self.steps: dict[str, Line] = {}

    def take(self, line: Line) -> None:
        if line["what"] == "step":
            self.steps[line["step"]] = line
            self.samples.update({number: line["step"] for number, _ in line["rows"] if number > 0})
            if line["state"] == "accepted":
                self.accepted.add(line["step"])

    def states(self) -> dict[str, str]:
        return {step: line["state"] for step, line in self.steps.items()}

    def rows(self, step: str) -> list[int]:
        """Samples shown of a step."""
        return [number for number, _ in self.steps[step]["rows"]] if step in self.steps else []

    def can(self, step: str, action: str) -> bool:
        return step in self.steps and action in self.steps[step]["actions"]


class Pilot:
    """One screen, its engine, and the lines that came; `forget` before what a wait is for."""

    def __init__(self, announced: Announced, temporary: Path) -> None:
        self.announced = announced
        self._environment = {**os.environ, "TMPDIR": str(temporary), "BELTCAL_HOME": str(temporary.parent / "home")}
        self._lines: list[Line] = []
        self._changed = threading.Condition()
        self._screen: subprocess.Popen[str] | None = None
        self._reader: threading.Thread | None = None
        self._engine = 0

    def start(self) -> float:
        """Start an engine, and a screen if there is none; seconds until it takes commands."""
        begun = time.monotonic()
        if self._screen is None:
            self._screen = subprocess.Popen(
                [sys.executable, "-m", "benchmarks.kill_and_reopen.screen"], stdin=subprocess.PIPE,
                stdout=subprocess.PIPE, text=True, cwd=ROOT, start_new_session=True, env=self._environment,
            )  # fmt: skip
            self._reader = threading.Thread(target=self._read, args=(self._screen,))
            self._reader.start()
        self.forget()
        self.send("start")
        self._engine = self.wait(lambda line: line["what"] == "engine")["pid"]
        self.wait(lambda line: line["what"] == "Ready")
        return time.monotonic() - begun

    def send(self, name: str, **words: Any) -> None:
        """A command."""
        assert self._screen is not None and self._screen.stdin is not None
        self._screen.stdin.write(json.dumps([name, words]) + "\n")
        self._screen.stdin.flush()

    def forget(self) -> None:
        """Only what comes from now on is waited for."""
        with self._changed:
            self._lines.clear()

    def wait(self, fits: Callable[[Line], bool], timeout_s: float = WAIT_S, *, late: bool = False) -> Line:
        """The first line that fits; with `late` an empty one if none came in time."""
        found: list[Line] = []

        def there() -> bool:
            found[:] = [line for line in self._lines if fits(line)][:1]
            wrong = [line for line in self._lines if line["what"] in ("Crashed", "gone", "eof")]
            if wrong and not found:
                raise MissedError(str(wrong[0])[-600:])
            return bool(found)

        with self._changed:
            if self._changed.wait_for(there, timeout_s):
                return found[0]
        if late:
            return {}
        raise MissedError(f"waited in vain; the last: {str(self._lines[-3:])[:600]}")

    def until(self, there: Callable[[], bool], timeout_s: float = WAIT_S) -> None:
        """Wait until what has been announced is as wanted."""
        with self._changed:
            if not self._changed.wait_for(there, timeout_s):
                raise MissedError(f"waited in vain; on the rail: {self.announced.states()}")

    def work(self, name: str, **words: Any) -> Line:
        """A command that is a job, to its end."""
        self.forget()
        self.send(name, **words)
        return self.done()

    def done(self) -> Line:
        """The end of a job."""
        ended = self.wait(lambda line: line["what"] in ("ended", "Refused"))
        if ended.get("how") != "done":
            raise MissedError(f"{ended}")
        return ended

    def ended_jobs(self) -> int:
        """Since `forget`."""
        with self._changed:
            return sum(line["what"] == "ended" for line in self._lines)

    def kill(self, *, parent: bool) -> None:
        """`kill -9` for the engine, or for the screen's whole process group; comes back when they are gone."""
        assert self._screen is not None and self._reader is not None
        engine = os.pidfd_open(self._engine)  # it is not a child of this process
        try:
            if parent:
                os.killpg(self._screen.pid, signal.SIGKILL)
                self.close()
            else:
                os.kill(self._engine, signal.SIGKILL)
                self.wait(lambda line: line["what"] == "gone")
            ended = select.poll()
            ended.register(engine, select.POLLIN)
            if not ended.poll(10_000):
                raise MissedError("the engine lives on")
        finally:
            os.close(engine)

    def close(self) -> None:
        """Let the screen end."""
        if self._screen is not None and self._reader is not None and self._screen.stdin is not None:
            self._screen.stdin.close()
            self._screen.wait()
            self._reader.join()
            self._screen = None

    def _read(self, screen: subprocess.Popen[str]) -> None:
        assert screen.stdout is not None
        for text in screen.stdout:
            if text.endswith("\n"):
                line = json.loads(text)
                with self._changed:
                    self.announced.take(line)
                    self._lines.append(line)
                    self._changed.notify_all()
        screen.stdout.close()
        with self._changed:
            self._lines.append({"what": "eof"})
            self._changed.notify_all()


