"""`beltcal path`: contacts, robot poses and the robot program."""

from __future__ import annotations

import argparse
import os
from pathlib import Path
from typing import TYPE_CHECKING, Any

from beltgui.cli.arguments import Commands, add_command
from core.errors import InputError

if TYPE_CHECKING:
    from beltgui.cli.job import Job
    from core.path import PathJob, PathPlan

DESCRIPTION = """JOB.toml names the STEP file, its airfoil face, the calibration results, the pattern and the program to
write (docs/steps/path.md lists the keys). Relative names start from the folder of JOB.toml."""

# What may be a result file of another command; each is read strictly before the planning looks for fields in it.
RESULT_KEYS = ("error_surface", "base_from_tool", "flange_from_work", "base_from_flange_at_scan", "base_from_measure",
               "measure_from_work")


def add(commands: Commands) -> None:
    """Declare the command."""
    parser = add_command(commands, "path", "compensated path and robot program", DESCRIPTION, run)
    parser.add_argument("--job", metavar="JOB.toml", required=True)


def run(args: argparse.Namespace, job: Job) -> dict[str, Any]:
    """Read, plan, write the program and read it back."""
    from beltgui.cli.fields import read_json, read_toml
    from beltgui.files import check_writable
    from beltgui.steps.error_surface.path_record import record
    from core.path import path_job_from_dict, plan_path

    root = read_toml(args.job)
    job.reads(args.job)
    for name in RESULT_KEYS:
        if isinstance(root.value.get(name), str):
            read_json(str(Path(args.job).parent / root.key(name).text()))
    with job.about(args.job):
        order = path_job_from_dict(root.value, Path(args.job).parent)
        if order.program is not None:
            check_writable(order.program)
            _check_program_name(order, args)
        for file in order.files:
            job.reads(str(file))
        model = job.step(str(order.cad))
        plan = plan_path(model.spline_surface(order.airfoil), order.cell, order.pattern, approach_mm=order.approach_mm,
                         error_surface=order.error_surface, clip=order.clip, workspace=order.workspace)
        if plan.trimmed_points:
            job.say(f"{args.job}: {plan.trimmed_points} points lie where the error surface was not measured "
                    "and were left out.")
        return record(plan, _write_program(order, plan))


def _check_program_name(order: PathJob, args: argparse.Namespace) -> None:
    assert order.program is not None
    taken = [Path(args.job), *order.files] + ([Path(args.out)] if args.out else [])
    if os.path.realpath(order.program) in [os.path.realpath(path) for path in taken]:
        raise InputError(f"program: {order.program} is also an input or the file of --out. Choose another name.")


def _write_program(order: PathJob, plan: PathPlan) -> dict[str, Any] | None:
    """Write the program and prove it by reading back what is on the disk."""
    if order.program is None:
        return None
    from beltgui.files import sha256_of, write_atomically
    from beltgui.steps.error_surface.path_record import program_block
    from core.path import verify_program, write_urscript

    text = write_urscript(plan, order.program_settings)
    verify_program(plan, text)
    write_atomically(order.program, text.encode())
    proof = verify_program(plan, order.program.read_text(encoding="utf-8"))
    return program_block(str(order.program), sha256_of(order.program), proof)
