"""`beltcal demo`: a simulated cell is commissioned and held against its truth."""

from __future__ import annotations

import argparse
from dataclasses import asdict
from pathlib import Path
from typing import TYPE_CHECKING, Any

from beltgui.cli.arguments import Commands, add_command, whole_number

if TYPE_CHECKING:
    from beltgui.cli.job import Job

DESCRIPTION = """Commissions the simulated cell from nothing and writes session, robot programs and a report (HTML) to a
folder; the JSON holds truth against estimate per step."""


def add(commands: Commands) -> None:
    """Declare the command."""
    parser = add_command(commands, "demo", "the whole commissioning in the simulated cell", DESCRIPTION, run,
                         writes_file=False)
    parser.set_defaults(as_table=as_table)
    parser.add_argument("--seed", type=whole_number, default=0, help="everything left to chance follows from it")
    parser.add_argument("--out", metavar="DIR", dest="folder", default="beltcal_demo",
                        help="folder for the results (default beltcal_demo)")


def run(args: argparse.Namespace, job: Job) -> dict[str, Any]:
    """Run, report progress, sum up."""
    from beltgui.cli.progress import told_on_stderr
    from beltgui.demo import run_demo
    from beltgui.steps.blocks import plain
    from core.errors import InputError
    from devices.interfaces.errors import DeviceError

    if not args.folder:
        raise InputError("argument --out: the name is empty, expected a folder.")
    folder = Path(args.folder)
    if folder.exists() and not folder.is_dir():
        raise InputError(f"{folder}: this is a file, expected a folder for the results.")
    try:
        with job.about(args.folder):
            result = run_demo(folder, seed=args.seed, job=told_on_stderr(job))
    except DeviceError as error:
        raise InputError(f"{args.folder}: {error}") from error
    reasons = [] if result.accepted else [{"code": "OUTSIDE_LIMITS", "message": result.headline}]
    proof = result.proof
    return {
        "verdict": {"ok": result.accepted, "reasons": reasons},
        "seed": args.seed,
        "headline": result.headline,
        "session": str(result.session),
        "report": str(result.report),
        "programs": [str(path) for path in result.programs],
        "steps": [{"step": step, "ok": verdict.ok} for step, verdict in result.found.verdicts.items()],
        "truth_against_estimate": [asdict(row) for row in result.rows],
        "left_on_airfoil": proof and {"nominal_rms_mm": plain(proof.nominal_rms_mm),
                                      "compensated_rms_mm": plain(proof.compensated_rms_mm),
                                      "compensated_worst_mm": plain(proof.compensated_worst_mm)},
    }


def as_table(record: dict[str, Any]) -> str:
    """Six steps with truth, estimate, error and verdict, then what came of it and where it is."""
    from beltgui.demo.truth_table import Row, as_text

    verdicts = {step["step"]: "accepted" if step["ok"] else "rejected" for step in record["steps"]}
    table = as_text([Row(**row) for row in record["truth_against_estimate"]], verdicts)
    word = "ACCEPTED" if record["verdict"]["ok"] else "REJECTED"
    programs = "".join(f"program  {path}\n" for path in record["programs"])
    return (f"{table}\n\n{word}: {record['headline']}\n\nsession  {record['session']}\n{programs}"
            f"report   {record['report']}\n")
