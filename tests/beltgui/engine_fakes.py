"""Rooms and devices of an engine under test: motions that last until the test lets them end."""

import threading
from collections.abc import Mapping
from dataclasses import dataclass, field, replace
from pathlib import Path
from typing import Any

import numpy as np

from beltgui.jobs import Job
from beltgui.steps.context import Context
from beltgui.steps.room import Bench
from beltgui.steps.state import STEPS
from beltgui.viewmodel.step import SampleRow, StepContent, Use
from core.errors import FitError, InputError
from core.verdict import Code, Reason, Verdict
from devices.cell_plan import read_plan
from devices.clock import InstantClock
from devices.interfaces import (
    Cell,
    GrinderReading,
    Limit,
    Lost,
    Mount,
    RobotPath,
    RobotReading,
    Scan,
    StagePosition,
    Stopped,
)

WAIT_S = 20.0
PLANNED = 3


class Axis:
    """What moves: each motion ends at once, or after `hold_next` when the test says `arrive`."""

    def __init__(self, name: str) -> None:
        self.name = name
        self.began = threading.Semaphore(0)
        self.stops = 0
        self.forget_stops = 0
        self.finished: list[Any] = []
        self._held = 0
        self._state = threading.Condition()
        self._stop = self._arrived = False

    def hold_next(self, motions: int = 1) -> None:
        """The next motions last until they are told to end."""
        self._held = motions

    def arrive(self) -> None:
        with self._state:
            self._arrived = True
            self._state.notify_all()

    def travel(self, target: Any) -> None:
        with self._state:
            self._stop = self._arrived = False  # as real drivers do: a stop that came just before is forgotten
        self.began.release()
        if self._held:
            self._held -= 1
            with self._state:
                assert self._state.wait_for(lambda: self._stop or self._arrived, WAIT_S)
                if self._stop:
                    raise Stopped(self.name, "stopped on the way.")
        self.finished.append(target)

    def stop(self) -> None:
        with self._state:
            self.stops += 1
            if self.stops > self.forget_stops:
                self._stop = True
                self._state.notify_all()


class Robot(Axis):
    def __init__(self) -> None:
        super().__init__("robot")
        self.pose = np.eye(4)

    @property
    def limits(self) -> tuple[Limit, ...]:
        return (Limit("speed", 0.0, 250.0, "mm/s"),)

    def read(self, *, deadline_s: float = 0.5) -> RobotReading:
        return RobotReading(0.0, self.pose, False)

    def preview(self, base_from_flange: Any, *, speed_mm_s: float = 100.0) -> RobotPath:
        length = float(np.linalg.norm(base_from_flange[:3, 3] - self.pose[:3, 3]))
        return RobotPath(np.array([self.pose, base_from_flange]), length / speed_mm_s, length)

    def move_to(self, base_from_flange: Any, *, speed_mm_s: float = 100.0, deadline_s: float = 120.0) -> RobotReading:
        self.travel(base_from_flange)
        self.pose = base_from_flange
        return self.read()


class FakeStage(Axis):
    limits = (Limit("x", -1, 1, "mm"),) * 4
    homed = True

    def __init__(self) -> None:
        super().__init__("stage")

    def home(self, *, deadline_s: float = 60.0) -> None:
        self.travel("home")

    def position(self, *, deadline_s: float = 1.0) -> StagePosition:
        return StagePosition(0.0, 0.0, 0.0)

    def move_to(self, target: StagePosition, *, deadline_s: float = 60.0) -> StagePosition:
        self.travel(target)
        return target


class FakeScanner:
    limits = ()

    def capture(self, *, deadline_s: float = 10.0) -> Scan:
        return Scan(np.zeros((1, 3), dtype=np.float32), 0.0)


class FakeGrinder:
    limits = ()

    def read(self, *, deadline_s: float = 0.1) -> GrinderReading:
        return GrinderReading(0.0, 0.0, 0.0)


class Hand:
    def __init__(self) -> None:
        self.done: list[Any] = []

    def perform(self, request: Any, *, deadline_s: float = 600.0) -> None:
        self.done.append(request)


class FakeHost:
    """A cell whose devices drop when the test says so."""

    simulated = True
    mounted: Mount | None = None

    def __init__(self, folder: Path, cell_file: Path, blade_step: Path, info: Mapping[str, Any]) -> None:
        self.plan = read_plan(cell_file)
        self.robot, self.stage, self.hand = Robot(), FakeStage(), Hand()
        self.cell = Cell(
            FakeScanner(), self.stage, self.robot, {name: FakeGrinder() for name in ("rough", "fine")}, self.hand,
            InstantClock(),
        )  # fmt: skip
        self.lost: set[str] = set()

    def heartbeat(self, device: str) -> None:
        if device in self.lost:
            raise Lost(device, "the connection is gone.")

    def simulate(self, fault: str) -> None:
        if not fault.endswith(" lost"):
            raise InputError(f"There is no fault '{fault}'.")
        self.lost.add(fault.removesuffix(" lost"))

    def remember(self) -> None:
        return


@dataclass(frozen=True, eq=False)
class FakeOutcome:
    verdict: Verdict
    samples: int


def pose(slot: int) -> Any:
    target = np.eye(4)
    target[0, 3] = 100.0 * (slot + 1)
    return target


@dataclass(eq=False)
class FakeRoom:
    """Three samples, each after a motion; solved from two or more, rejected where the setting `bad` is set.

    Attributes:
        solving: Set while `solve` waits for `gate`.
        series: One consent, then all motions, as in probing.
    """

    step: str
    gate: threading.Event = field(default_factory=threading.Event)
    solving: threading.Event = field(default_factory=threading.Event)
    series: bool = False
    broken: str = ""
    solved: int = 0

    def __post_init__(self) -> None:
        self.gate.set()

    def acquire(self, bench: Bench, context: Context) -> None:
        if self.broken == "acquire":
            raise RuntimeError("a bug in acquire")
        context.cell.operator.perform(Mount("ball"))
        there = {sample.data["slot"] for sample in bench.session.samples(self.step)}
        if self.series:
            assert context.consent(context.mover().preview(pose(0)), "to probe")
        for slot in range(PLANNED):
            if slot in there:
                continue
            context.job.report(slot / PLANNED, f"sample {slot + 1}")
            if self.series:
                context.mover().move_to(pose(slot), speed_mm_s=context.speed_mm_s)
            else:
                context.move(pose(slot), f"to pose {slot + 1}")
            context.cell.stage.move_to(StagePosition(float(slot), 0.0, 0.0))
            context.cell.scanner.capture()
            context.on_sample(bench.session.add_sample(self.step, "scan", {"slot": slot}))

    def solve(self, bench: Bench, job: Job) -> FakeOutcome:
        self.solved += 1
        if self.broken == "solve":
            raise RuntimeError("a bug in solve")
        self.solving.set()
        while not self.gate.wait(0.01):
            job.report(0.5, "solving")
        count = len(bench.session.kept(self.step, "scan"))
        if count < 2:
            raise FitError(f"{count} sample, expected 2 or more.", Code.NOT_ENOUGH_POINTS)
        bad = bench.session.setting(self.step, "bad", False) or count < PLANNED
        reasons = (Reason(Code.HIGH_RESIDUAL, "Too few, or set to be bad."),) if bad else ()
        return FakeOutcome(Verdict(reasons), count)

    def record(self, outcome: FakeOutcome) -> dict[str, Any]:
        return {"samples": outcome.samples, "verdict": {"ok": outcome.verdict.ok, "reasons": []}}

    def headline(self, outcome: FakeOutcome) -> str:
        return f"{outcome.samples} samples"

    def view(self, bench: Bench, outcome: FakeOutcome | None, error: str = "") -> StepContent:
        if self.broken == "view":
            raise RuntimeError("a bug in view")
        samples = bench.session.samples(self.step)
        rows = tuple(SampleRow(s.id, str(s.id), (), Use.FIT, s.included) for s in samples)
        content = StepContent(rows=rows, complete=len(samples) == PLANNED, progress=error,
                              headline=f"{len(samples)} of {PLANNED}")  # fmt: skip
        return content if outcome is None else replace(content, ok=outcome.verdict.ok)


def fake_rooms(**series: bool) -> dict[str, FakeRoom]:
    return {step: FakeRoom(step, series=series.get(step, False)) for step in STEPS}
