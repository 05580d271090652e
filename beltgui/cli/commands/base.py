"""`beltcal base`: measurement frame to robot base."""

from __future__ import annotations

import argparse
from typing import TYPE_CHECKING, Any

from beltgui.cli.arguments import Commands, add_command, add_limits

if TYPE_CHECKING:
    from beltgui.cli.job import Job

EXAMPLE = """input:
  {"observations": [{"base_from_flange": [[1,0,0,-1246],[0,1,0,-1510],[0,0,1,965],[0,0,0,1]],
                     "ball_in_measure_mm": [20.006, 20.000, 19.994]}, ...]}
At least four flange poses with different orientations; five or more let a mistake show."""


def add(commands: Commands) -> None:
    """Declare the command."""
    parser = add_command(commands, "base", "measurement frame to robot base, from a ball on the flange", EXAMPLE, run)
    parser.add_argument("observations", metavar="OBS.json")
    add_limits(parser)


def run(args: argparse.Namespace, job: Job) -> dict[str, Any]:
    """Read, solve, judge."""
    import numpy as np

    from beltgui.cli.limits import read_limits
    from beltgui.steps.base.record import record
    from core.base import BaseLimits, judge_base, solve_base

    limits = read_limits(args.limits, "base", BaseLimits)
    root = job.json(args.observations)
    items = job.rows(root, "observations", ("base_from_flange", "ball_in_measure_mm"))
    poses = np.array([item.key("base_from_flange").transform() for item in items])
    balls = np.array([item.key("ball_in_measure_mm").vector(3) for item in items])
    with job.about(args.observations):
        fit = solve_base(poses, balls)
    return record(fit, judge_base(fit, limits))
