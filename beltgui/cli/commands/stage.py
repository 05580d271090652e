"""`beltcal stage`: the scanner on its stage."""

from __future__ import annotations

import argparse
from typing import TYPE_CHECKING, Any

from beltgui.cli.arguments import Commands, add_command, add_limits
from core.errors import InputError

if TYPE_CHECKING:
    from beltgui.cli.fields import Field
    from beltgui.cli.job import Job
    from core.frames import Array

DESCRIPTION = """OBS.json:
  {"observations": [{"stage_mm": [x,y,z], "stage_deg": t, "ball_in_scanner_mm": [x,y,z], "sigma_mm": 0.01}, ...]}
The ball stands still, the stage moves the scanner. sigma_mm may be left out, in all observations."""


def add(commands: Commands) -> None:
    """Declare the command."""
    parser = add_command(commands, "stage", "axes of the scanner's stage from balls seen in several places",
                         DESCRIPTION, run)
    parser.add_argument("observations", metavar="OBS.json")
    add_limits(parser)


def run(args: argparse.Namespace, job: Job) -> dict[str, Any]:
    """Read, solve, judge."""
    import numpy as np

    from beltgui.cli.limits import read_limits
    from beltgui.steps.ball.record import stage_record
    from core.ball import StageLimits, StageObservations, judge_stage, solve_stage

    limits = read_limits(args.limits, "stage", StageLimits)
    root = job.json(args.observations)
    items = job.rows(root, "observations", ("stage_mm", "stage_deg", "ball_in_scanner_mm", "sigma_mm"))
    observations = StageObservations(
        stage_mm=np.array([item.key("stage_mm").vector(3) for item in items]),
        stage_rad=np.radians([item.key("stage_deg").number(at_most=3600.0) for item in items]),
        ball_in_scanner_mm=np.array([item.key("ball_in_scanner_mm").vector(3) for item in items]),
        sigma_mm=_sigma(items),
    )
    with job.about(args.observations):
        fit = solve_stage(observations)
        verdict = judge_stage(fit, limits)
    return stage_record(fit, verdict)


def _sigma(items: list[Field]) -> Array | None:
    import numpy as np

    given = [item.has("sigma_mm") for item in items]
    if not any(given):
        return None
    if not all(given):
        lacking = items[given.index(False)]
        raise InputError(f"{lacking.label} has no sigma_mm but others have; give it in all observations or in none.")
    return np.array([item.key("sigma_mm").number(above=0.0) for item in items])
