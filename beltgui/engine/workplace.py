"""What the engine's work is done with: the open session, its cell behind guards, its monitor."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import replace
from pathlib import Path
from typing import Any

from beltgui.engine import messages as m
from beltgui.engine.desk import Desk
from beltgui.engine.guard import MotionGuard
from beltgui.engine.hosts import Host
from beltgui.engine.job import EngineJob
from beltgui.engine.monitor import Monitor
from beltgui.engine.motion import GuardedRobot, GuardedStage, WatchedRobot
from beltgui.engine.person import AskedOperator, Person
from beltgui.engine.watch import Watch, WatchedGrinder, WatchedScanner
from beltgui.jobs import Cancelled, Job
from beltgui.session import Sample
from beltgui.steps.context import Context
from beltgui.steps.room import Bench, Room
from beltgui.steps.state import TITLES
from beltgui.viewmodel.step import StepView
from core.errors import InputError
from devices.interfaces import Cell, RobotMover

BuildHost = Callable[[Path, Path, Path, Mapping[str, Any]], Host]
ReadModel = Callable[[Path], Any]
Export = Callable[[Bench, Any, Path, Job], tuple[Path, ...]]
Emit = Callable[[m.Event], None]
NO_SESSION = "No session is open. Begin one or open one first."


class Workplace:
    """Except where it is said, everything here runs in the thread that does the work."""

    def __init__(
        self,
        emit: Emit,
        guard: MotionGuard,
        person: Person,
        *,
        rooms: Mapping[str, Room] | None,
        build_host: BuildHost | None,
        read_model: ReadModel | None,
        export: Export | None,
    ) -> None:
        self._emit, self._guard, self._person = emit, guard, person
        self._rooms, self._build_host, self._read_model, self._write = rooms, build_host, read_model, export
        self._desk: Desk | None = None
        self._context: Context | None = None
        self._host: Host | None = None
        self._monitor: Monitor | None = None
        self._generations: dict[str, int] = {}

    # ---- sessions

    def open(self, command: m.NewSession | m.OpenSession, job: EngineJob) -> None:
        """Begin or open a session in place of the one that is open; show it at once, then solve it again."""
        from beltgui.engine import opening

        job.report(0.0, "reading the session")
        if self._desk is not None and self._desk.bench.session.folder.resolve() == Path(command.folder).resolve():
            self._leave()
        if isinstance(command, m.NewSession):
            opened = opening.begin(command)
        else:
            opened = opening.go_on(command)
        self._leave()
        session = opened.session
        try:
            self._emit(m.SessionOpened(
                str(session.folder), command.person, not session.writable, dict(opened.info)
            ))  # fmt: skip
            self._show_standing(session)
            job.tell(0.05, "reading the CAD model")
            model = (self._read_model or _read_step)(opened.blade.step_path)
            job.tell(0.15, "connecting the devices")
            host = (self._build_host or _simulated)(
                session.folder, opened.cell_file, opened.blade.step_path, opened.info
            )
            if session.writable:
                self._connect(host, opened, command.person)
            bench = Bench(session, host.plan, opened.blade, model, opened.date)
            self._desk = Desk(bench, self._rooms or _real_rooms(), command.person, self._emit,
                              has_cell=session.writable, generations=self._generations)  # fmt: skip
        except BaseException:
            self._leave()
            session.close()
            raise
        if isinstance(command, m.NewSession):
            self._desk.begin()
        try:
            self._desk.restore(job)
        except Cancelled:
            self._desk.leave_unsolved()
            raise

    def _show_standing(self, session: Any) -> None:
        """The rail, before anything is solved again."""
        from beltgui.steps import graph

        for step, standing in graph.standing(session).items():
            self._generations[step] = self._generations.get(step, 0) + 1
            self._emit(m.StepChanged(StepView(
                step, self._generations[step], standing.state, standing.headline, standing.why, frozenset(), None
            )))  # fmt: skip

    def _connect(self, host: Host, opened: Any, person: str) -> None:
        watch, cell = Watch(), host.cell
        monitor = Monitor(host, watch, self._guard, self._emit)
        mover = cell.robot if isinstance(cell.robot, RobotMover) else None
        self._guard.attach(mover, cell.stage)
        guarded = Cell(
            scanner=WatchedScanner(cell.scanner, watch),
            stage=GuardedStage(cell.stage, self._guard, watch, monitor.check),
            robot=GuardedRobot(mover, self._guard, watch, monitor.check) if mover else WatchedRobot(cell.robot, watch),
            grinders={name: WatchedGrinder(sensors, name, watch) for name, sensors in cell.grinders.items()},
            operator=AskedOperator(self._person, cell.operator if host.simulated else None, host.mounted),
            clock=cell.clock,
        )
        self._context = Context(
            guarded, host.plan, opened.blade, opened.info["serial"], opened.session, self._guard.consent
        )
        self._host, self._monitor = host, monitor
        monitor.start()

    def _leave(self) -> None:
        if self._monitor is not None:
            self._monitor.close()
            self._monitor.join(2.0)
        if self._host is not None:
            self._guard.attach(None, None)
            self._host.remember()
        if self._desk is not None:
            self._desk.bench.session.close()
        self._desk = self._context = self._host = self._monitor = None

    def close(self) -> None:
        """Leave the session; nothing can be done afterwards."""
        monitor = self._monitor
        self._leave()
        self._monitor = monitor

    def join(self, timeout_s: float) -> bool:
        """Whether the monitor has ended (any thread, after `close`)."""
        return self._monitor is None or self._monitor.join(timeout_s)

    # ---- why not

    def unopened(self) -> str:
        """A sentence without a session."""
        return "" if self._desk is not None else NO_SESSION

    def read_only(self) -> str:
        """A sentence where nothing may be changed."""
        if self._desk is None:
            return NO_SESSION
        return "" if self._desk.writable else "The session is open to look at only. Open it to go on with it."

    def why_not_acquire(self, step: str) -> str:
        """A sentence where samples cannot be taken."""
        from beltgui.steps import graph

        refusal = self.read_only()
        if refusal or self._desk is None:
            return refusal
        if self._context is None:
            return "No cell is connected, so no samples can be taken."
        standing = graph.standing(self._desk.bench.session)[step]
        if standing.can_begin:
            return ""
        return " ".join(standing.why) or f"{TITLES[step]} stands on steps that are not accepted. Accept them first."

    def why_not_solve(self, step: str) -> str:
        """A sentence where there is nothing to solve from."""
        if self._desk is None:
            return NO_SESSION
        there = self._desk.bench.session.samples(step)
        return "" if there else f"{TITLES[step]} has no samples yet. Take them first."

    def why_not_accept(self, step: str) -> str:
        """A sentence where a result may not be accepted."""
        return self.read_only() or (self._desk.why_not_accept(step) if self._desk else "")

    def why_not_export(self) -> str:
        """A sentence while the export is locked."""
        from beltgui.steps import graph

        if self._desk is None:
            return NO_SESSION
        lock = graph.export_lock(self._desk.bench.session)
        if not lock and "error_surface" not in self._desk.bench.found:
            return "The error surface has to be solved again first."
        return " ".join(lock)

    # ---- work

    def acquire(self, step: str, job: EngineJob) -> None:
        """Take the missing samples of a step and solve it."""
        desk, context, host = self._desk, self._context, self._host
        assert desk is not None and context is not None and host is not None

        def work(on_sample: Callable[[Sample], None]) -> None:
            def kept(sample: Sample) -> None:
                host.remember()
                on_sample(sample)

            desk.rooms[step].acquire(desk.bench, replace(context, job=job.part(0.0, 0.95), on_sample=kept))

        try:
            desk.acquire(step, work, job)
        finally:
            host.remember()

    def solve(self, step: str, job: EngineJob) -> None:
        """Solve a step again."""
        assert self._desk is not None
        self._desk.solve(step, job)

    def accept(self, step: str) -> None:
        """Accept what is shown."""
        assert self._desk is not None
        self._desk.accept(step)

    def edit(self, command: Any, job: EngineJob) -> None:
        """Change samples or settings, and solve again; the change is kept also when the solving is ended early."""
        from beltgui.session.rows import SHOWN_ONLY

        assert self._desk is not None
        self._change(command)
        if isinstance(command, m.Choose) and command.key.startswith(SHOWN_ONLY):
            self._desk.look_again(command.step)
        else:
            self._desk.solve(command.step, job)

    def _change(self, command: Any) -> None:
        assert self._desk is not None
        session, person = self._desk.bench.session, self._desk.person
        match command:
            case m.Include() | m.Delete() if command.sample_id < 0:
                self._change_pair(command)
            case m.Include():
                session.include(command.sample_id, command.on, person)
            case m.Delete():
                session.delete(command.sample_id, person)
            case m.StartOver():
                session.start_over(command.step, person)
            case m.Choose():
                session.choose(command.step, command.key, command.value, person)
            case m.Undo():
                if session.undo(command.step, person) is None:
                    raise InputError("There is nothing to undo.")
            case m.Redo():
                if session.redo(command.step, person) is None:
                    raise InputError("There is nothing to do again.")
            case _:
                raise TypeError(f"{type(command).__name__} is no command")

    def _change_pair(self, command: m.Include | m.Delete) -> None:
        """Rows with negative ids are picked pairs; they live in a setting."""
        from beltgui.steps.rough.picks import delete_pair, include_pair

        assert self._desk is not None
        session, person = self._desk.bench.session, self._desk.person
        if isinstance(command, m.Include):
            include_pair(session, command.sample_id, command.on, person)
        else:
            delete_pair(session, command.sample_id, person)

    def compare(self, folder: Path) -> None:
        """Compare with another session."""
        from beltgui.session import Session
        from beltgui.session.compare import compare

        assert self._desk is not None
        with Session.open(folder) as other:
            rows = compare(self._desk.bench.session, other)
        self._emit(m.Compared(str(folder), rows))

    def export(self, folder: Path, job: EngineJob) -> None:
        """Write programs and report."""
        desk = self._desk
        assert desk is not None
        files = (self._write or _write)(desk.bench, desk.bench.found["error_surface"], folder, job)
        if desk.writable:
            desk.bench.session.decide("error_surface", desk.person, f"exported to {folder}")
        self._emit(m.Exported(tuple(str(file) for file in files)))

    def remember(self) -> None:
        """Keep how the cell stands."""
        if self._host is not None:
            self._host.remember()

    # ---- faults (from the thread that takes commands)

    def simulate(self, fault: str) -> str:
        """Let something go wrong in the simulated cell; a sentence where that is not possible."""
        host, monitor = self._host, self._monitor
        if host is None or monitor is None or not host.simulated:
            return "There is no simulated cell to let something go wrong in."
        try:
            host.simulate(fault)
        except InputError as error:
            return str(error)
        monitor.look_now()
        return ""


def _read_step(path: Path) -> Any:
    from core.cad import read_step

    return read_step(path)


def _real_rooms() -> Mapping[str, Room]:
    from beltgui.steps.rooms import ROOMS

    return ROOMS


def _simulated(folder: Path, cell_file: Path, blade_step: Path, info: Mapping[str, Any]) -> Host:
    from beltgui.engine.hosts import SimulatedHost

    return SimulatedHost(folder, cell_file, blade_step, info)


def _write(bench: Bench, outcome: Any, folder: Path, job: Job) -> tuple[Path, ...]:
    from beltgui.steps.error_surface.export import export

    return export(bench, outcome, folder, job)
