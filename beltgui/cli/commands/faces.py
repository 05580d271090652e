"""`beltcal faces`: what a STEP file consists of."""

from __future__ import annotations

import argparse
from typing import TYPE_CHECKING, Any

from beltgui.cli.arguments import Commands, add_command

if TYPE_CHECKING:
    from beltgui.cli.job import Job

DESCRIPTION = "Lists the faces of a STEP file: number, name, kind, area, and whether registration can use them."


def add(commands: Commands) -> None:
    """Declare the command."""
    parser = add_command(commands, "faces", "faces of a STEP file", DESCRIPTION, run)
    parser.add_argument("step", metavar="STEP")


def run(args: argparse.Namespace, job: Job) -> dict[str, Any]:
    """Read and list."""
    model = job.step(args.step)
    from beltgui.steps.fine.faces_record import judge_faces, record

    return record(model, judge_faces(model))
