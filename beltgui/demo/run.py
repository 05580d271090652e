"""Commissions the simulated cell from nothing, compares with its truth and writes the report."""

from __future__ import annotations

import shutil
from collections.abc import Callable, Mapping
from dataclasses import dataclass, replace
from datetime import UTC, datetime
from pathlib import Path
from typing import Any

from beltgui import __version__
from beltgui.commissioning import Commissioner, Commissioning
from beltgui.demo.proof import Proof, prove
from beltgui.demo.truth_table import Row, TruthTable
from beltgui.files import write_atomically
from beltgui.jobs import Job
from beltgui.session import INPUTS, Session
from beltgui.steps.blocks import plain
from beltgui.steps.context import Context
from beltgui.steps.graph import stands_on
from beltgui.steps.room import Bench, Room
from beltgui.steps.state import StepEvent, StepState
from core.cad import read_step
from core.cad.blade_type import BladeType, read_blade_type
from core.errors import InputError
from devices.cell_plan import CellFileError
from resources import blade_type_path, resource_path

GRINDER = "fine"
PERSON = "demonstration"
SESSION = "session"
REPORT = "report.html"
# Goals of the demonstration: what is left on the airfoil after compensation.
LARGEST_LEFT_RMS_MM = 0.02


@dataclass(frozen=True, eq=False)
class DemoResult:
    """How the demonstration ended.

    Attributes:
        report: The HTML file.
        session: Folder of the session.
        programs: Robot programs written.
        found: Outcome of every step.
        rows: Truth against estimate.
        proof: Normal error left along the paths; None if no program was made.
        accepted: All steps accepted and little enough error left.
        headline: One sentence.
    """

    report: Path
    session: Path
    programs: tuple[Path, ...]
    found: Commissioning
    rows: tuple[Row, ...]
    proof: Proof | None
    accepted: bool
    headline: str


def run_demo(
    out_dir: Path,
    *,
    blade_type: str = "dr95",
    seed: int = 0,
    config: Path | None = None,
    resolution: int | str = "demo",
    grid: tuple[int, int] | None = None,
    faults: Callable[[str, Any], None] | None = None,
    job: Job | None = None,
    on_step: Callable[[StepEvent], None] | None = None,
) -> DemoResult:
    """Build a simulated cell, commission it, and write session, programs and report to a folder.

    Args:
        out_dir: Folder for the results; it may exist, but must not hold a session.
        blade_type: Name of a blade type that comes with the program.
        seed: Everything left to chance follows from it.
        config: Cell file; None takes the simulated cell's own.
        resolution: Of the simulated scanner, see `build_simulated_cell`.
        grid: Probing points in u and v; None takes the blade type's own.
        faults: Called with a step's name and the world's faults when the step begins.
        job: Progress and cancel.
        on_step: Told when a step changes its state.

    Raises:
        InputError: the folder holds a session, an input cannot be used, or a step's samples determine nothing.
        DeviceError: a simulated device failed or refused.
        Cancelled: the job was cancelled.
    """
    from devices.sim import build_simulated_cell
    from devices.sim.blade import BladeFileError

    work = job or Job()
    blade = read_blade_type(blade_type_path(blade_type))
    if grid is not None:
        blade = replace(blade, probing=replace(blade.probing, u_count=grid[0], v_count=grid[1]))
    cell_file = config or resource_path("cells", "simulated.toml")
    model = read_step(blade.step_path)
    try:
        simulated = build_simulated_cell(cell_file, blade.step_path, seed=seed, resolution=resolution)
    except (CellFileError, BladeFileError) as error:
        raise InputError(str(error)) from error
    table = TruthTable(simulated.truth, simulated.plan, model, GRINDER)
    date = datetime.now(UTC).date().isoformat()
    serial = f"{blade.name}-0001"
    folder = out_dir / SESSION
    info = {"software": __version__, "blade": blade.path.name, "cell": cell_file.name, "serial": serial,
            "grinder": GRINDER, "date": date, "simulated": True, "seed": seed,
            "probing_grid": [blade.probing.u_count, blade.probing.v_count]}  # fmt: skip
    with Session.create(folder, info, fill=lambda: _keep_inputs(folder / INPUTS, cell_file, blade)) as session:
        bench = Bench(session, simulated.plan, blade, model, date)
        found = Commissioning(bench)

        def announce(event: StepEvent) -> None:
            if event.state is StepState.RUNNING and faults is not None:
                faults(event.step, simulated.world.faults)
            if event.state is not StepState.RUNNING and event.step in found.verdicts:
                table.step_done(event.step, found)
            if on_step is not None:
                on_step(event)

        def keep(step: str, record: Mapping[str, Any], headline: str, ok: bool) -> None:
            session.put_result(step, plain(record), ok=ok, headline=headline, stands_on=stands_on(session, step))
            if ok:
                session.accept(step, PERSON)

        context = Context(simulated.cell, simulated.plan, blade, serial, session, lambda path, purpose: True)

        def acquire(room: Room, part: Job) -> None:
            room.acquire(bench, replace(context, job=part))

        Commissioner(bench, acquire, work.part(0.0, 0.9), keep, announce).run()
        programs = tuple(_write_programs(out_dir, found))
        proof = prove(simulated.world, GRINDER, found.programs, work.part(0.9, 0.96)) if found.programs else None
        headline, accepted = _judge(found, proof)
        report = _write_report(out_dir, found, table.rows, proof, info, accepted, headline, work)
    return DemoResult(report, folder, programs, found, tuple(table.rows), proof, accepted, headline)


def _keep_inputs(folder: Path, cell_file: Path, blade: BladeType) -> None:
    """A session must be replayable when the files it was made from have changed."""
    folder.mkdir(exist_ok=True)  # of a start that was killed
    for source in (cell_file, blade.path, blade.step_path):
        shutil.copyfile(source, folder / source.name)


def _write_programs(out_dir: Path, found: Commissioning) -> list[Path]:
    paths = []
    for name, program in found.programs.items():
        path = out_dir / f"{name}.script"
        write_atomically(path, program.text.encode())
        paths.append(path)
    return paths


def _judge(found: Commissioning, proof: Proof | None) -> tuple[str, bool]:
    rejected = [name for name, verdict in found.verdicts.items() if not verdict.ok]
    if rejected:
        return found.verdicts[rejected[0]].reasons[0].message, False
    assert proof is not None
    left = (
        f"Normal error left on the airfoil {proof.compensated_rms_mm:.4f} mm RMS along the compensated path, "
        f"{proof.nominal_rms_mm:.3f} mm RMS along the nominal one."
    )
    return left, proof.compensated_rms_mm <= LARGEST_LEFT_RMS_MM


def _write_report(
    out_dir: Path,
    found: Commissioning,
    rows: list[Row],
    proof: Proof | None,
    info: dict[str, Any],
    accepted: bool,
    headline: str,
    job: Job,
) -> Path:
    from beltgui.report.commissioning import commissioning_page
    from beltgui.report.page import render

    job.report(0.97, "writing the report")
    page = commissioning_page(found, info, accepted=accepted, headline=headline, rows=rows, proof=proof)
    path = out_dir / REPORT
    write_atomically(path, render(page).encode())
    job.report(1.0, "done")
    return path
