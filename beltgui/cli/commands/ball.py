"""`beltcal ball`: the ball's centre in one scan."""

from __future__ import annotations

import argparse
from typing import TYPE_CHECKING, Any

from beltgui.cli.arguments import Commands, add_command, add_limits, positive_mm, whole_number
from core.errors import InputError

if TYPE_CHECKING:
    from beltgui.cli.job import Job

DESCRIPTION = """Finds the calibration ball in a scan that may hold fixture and background as well. Certified diameters
help: with --fix-diameter the centre of a small cap is far less biased along the line of sight."""


def add(commands: Commands) -> None:
    """Declare the command."""
    parser = add_command(commands, "ball", "centre and diameter of the ball in a scan", DESCRIPTION, run)
    parser.add_argument("cloud", metavar="CLOUD", help="PLY, PCD, XYZ/CSV text or STL, in mm")
    parser.add_argument("--diameter", type=positive_mm, metavar="D", help="certified diameter in mm")
    parser.add_argument("--fix-diameter", action="store_true", help="keep that diameter instead of fitting it")
    parser.add_argument("--seed", type=whole_number, default=0, help="of the random search (default 0)")
    add_limits(parser)


def run(args: argparse.Namespace, job: Job) -> dict[str, Any]:
    """Read, fit, judge."""
    if args.fix_diameter and args.diameter is None:
        raise InputError("ball --fix-diameter needs --diameter D, the certified diameter in mm.")
    from beltgui.cli.limits import read_limits
    from beltgui.steps.ball.record import sphere_record
    from core.ball import SphereLimits, fit_sphere, judge_sphere

    limits = read_limits(args.limits, "ball", SphereLimits)
    cloud = job.cloud(args.cloud)
    with job.about(args.cloud):
        fit = fit_sphere(cloud.points_mm, diameter_mm=args.diameter, fix_diameter=args.fix_diameter, seed=args.seed)
    return sphere_record(fit, judge_sphere(fit, limits), dropped=cloud.dropped)
