"""An engine on a test bed: fake rooms, fake devices, a real session."""

from pathlib import Path
from typing import Any, Self

from beltgui.engine import messages as m
from beltgui.steps.state import StepState
from tests.beltgui.engine_driver import Driver
from tests.beltgui.engine_fakes import FakeHost, fake_rooms


class Bed:
    """An engine with fake rooms and devices, and a session."""

    def __init__(self, folder: Path, **driver: Any) -> None:
        self.rooms = fake_rooms()
        self.hosts: list[FakeHost] = []
        self.folder = folder / "session"
        self.exports: list[Path] = []
        self.driver = Driver(
            rooms=self.rooms, build_host=self._host, read_model=lambda path: None, export=self._export, **driver
        )

    def _host(self, *words: Any) -> FakeHost:
        self.hosts.append(FakeHost(*words))
        return self.hosts[-1]

    def _export(self, bench: Any, outcome: Any, folder: Path, job: Any) -> tuple[Path, ...]:
        self.exports.append(folder)
        return (folder / "a.script",)

    def begin(self) -> None:
        assert self.driver.work(m.NewSession(str(self.folder), "A. Person")).how == "done"

    def accept(self, step: str) -> None:
        assert self.driver.work(m.Acquire(step)).how == "done"
        self.driver.send(m.Accept(step))
        self.driver.view(step, lambda view: view.state is StepState.ACCEPTED)

    def __enter__(self) -> Self:
        return self

    def __exit__(self, *exception: object) -> None:
        for room in self.rooms.values():
            room.gate.set()
        self.driver.close()

    @property
    def host(self) -> FakeHost:
        """Of the session that is open."""
        return self.hosts[-1]
