"""`beltcal stylus`: pivot calibration of the stylus tip."""

from __future__ import annotations

import argparse
from typing import TYPE_CHECKING, Any

from beltgui.cli.arguments import Commands, add_command, add_limits

if TYPE_CHECKING:
    from beltgui.cli.job import Job

DESCRIPTION = """OBS.json:
  {"observations": [{"base_from_flange": 4x4}, ...]}
The tip rests in a cone while the flange turns about it; tilt by 20 degrees and more about different axes."""


def add(commands: Commands) -> None:
    """Declare the command."""
    parser = add_command(commands, "stylus", "tip of the stylus in the flange, by pivoting", DESCRIPTION, run)
    parser.add_argument("observations", metavar="OBS.json")
    add_limits(parser)


def run(args: argparse.Namespace, job: Job) -> dict[str, Any]:
    """Read, solve, judge."""
    import numpy as np

    from beltgui.cli.limits import read_limits
    from beltgui.steps.tool.record import stylus_record
    from core.tool import StylusLimits, judge_stylus, solve_stylus

    limits = read_limits(args.limits, "stylus", StylusLimits)
    root = job.json(args.observations)
    items = job.rows(root, "observations", ("base_from_flange",))
    poses = np.array([item.key("base_from_flange").transform() for item in items])
    with job.about(args.observations):
        fit = solve_stylus(poses)
        verdict = judge_stylus(fit, limits)
    return stylus_record(fit, verdict)
