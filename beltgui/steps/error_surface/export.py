"""Export with proof: what was written to the disk is read back from there and its contact points are recomputed."""

from __future__ import annotations

import json
from pathlib import Path
from typing import Any

from beltgui import __version__
from beltgui.files import sha256_of, write_atomically
from beltgui.jobs import Job
from beltgui.steps.blocks import degrees, plain
from beltgui.steps.error_surface.record import record as surface_record
from beltgui.steps.error_surface.step import ErrorSurfaceOutcome, Program
from beltgui.steps.room import Bench
from core.errors import InputError
from core.path import ProgramProof, verify_program

SURFACE = "error_surface.json"
PROOF = "programs.proof.json"
REPORT = "report.html"


def export(bench: Bench, outcome: ErrorSurfaceOutcome, folder: Path, job: Job) -> tuple[Path, ...]:
    """Write robot programs, their proof, the error surface and the report; files of these names are replaced.

    Args:
        bench: Samples and outcomes of all steps.
        outcome: Of this step, accepted.
        folder: Where to; made if it does not exist.
        job: Progress and cancel.

    Returns:
        What was written.

    Raises:
        InputError: the result is not accepted, a file cannot be written, or what was read back is not what was planned.
        Cancelled: the job was cancelled; files written before stay.
    """
    if not outcome.verdict.ok or not outcome.programs:
        why = outcome.verdict.reasons[0].message if outcome.verdict.reasons else "There are no programs."
        raise InputError(f"The error surface is not accepted, so nothing is exported: {why}")
    try:
        folder.mkdir(parents=True, exist_ok=True)
    except OSError as error:
        raise InputError(f"{folder}: the folder cannot be made ({error.strerror}).") from error
    written, proofs = [], []
    for number, program in enumerate(outcome.programs.values()):
        job.report(0.1 * number, f"writing the program {program.name}")
        path = folder / f"{program.name}.script"
        write_atomically(path, program.text.encode())
        proofs.append(_proof_block(path, program, check_written(path, program)))
        written.append(path)
    job.report(0.3, "writing the error surface")
    written.append(_write_json(folder / SURFACE, surface_record(outcome.surface, outcome.verdict)))
    written.append(_write_json(folder / PROOF, {"software": __version__, "programs": proofs}))
    job.report(0.4, "writing the report")
    written.append(_write_report(bench, outcome, folder / REPORT))
    job.report(1.0, "exported")
    return tuple(written)


def check_written(path: Path, program: Program) -> ProgramProof:
    """Read a program file and recompute where the wheel touches the blade.

    Raises:
        InputError: the file cannot be read, or does not say what was planned.
    """
    try:
        text = path.read_text(encoding="utf-8")
    except (OSError, UnicodeDecodeError) as error:
        raise InputError(f"{path}: the program cannot be read back ({error}).") from error
    try:
        proof = verify_program(program.plan, text)
    except InputError as error:
        raise InputError(f"{path}: {error}", error.code) from error
    if text != program.text:
        raise InputError(f"{path}: the file is not what was written. Export again, and see who else writes there.")
    return proof


def _proof_block(path: Path, program: Program, proof: ProgramProof) -> dict[str, Any]:
    return {
        "path": path.name,
        "sha256": sha256_of(path),
        "strokes": len(program.plan.strokes),
        "contacts": program.plan.points,
        "poses": proof.poses,
        "max_position_mm": proof.max_position_mm,
        "max_rotation_deg": degrees(proof.max_rotation_rad),
        "max_contact_mm": proof.max_contact_mm,
        "length_mm": program.length_mm,
        "duration_s": program.duration_s,
        "largest_speed_mm_s": program.largest_speed_mm_s,
    }


def _write_json(path: Path, content: dict[str, Any]) -> Path:
    write_atomically(path, json.dumps(plain(content), allow_nan=False, indent=1).encode())
    return path


def _write_report(bench: Bench, outcome: ErrorSurfaceOutcome, path: Path) -> Path:
    # The report draws its pictures with heavy libraries, which only an export needs.
    from beltgui.commissioning import Commissioning
    from beltgui.report.commissioning import commissioning_page
    from beltgui.report.page import render

    found = Commissioning(bench)
    info = {"serial": "", "cell": bench.plan.name, "software": __version__, **bench.session.info(),
            "grinder": outcome.presenting.grinder, "date": bench.date}  # fmt: skip
    left = f"Normal error at points that the fit has not seen {outcome.held_out.rms_mm:.3f} mm RMS."
    page = commissioning_page(found, info, accepted=found.accepted, headline=left)
    write_atomically(path, render(page).encode())
    return path
