"""`beltcal error-surface`: normal errors over the airfoil's (u, v)."""

from __future__ import annotations

import argparse
from typing import TYPE_CHECKING, Any

from beltgui.cli.arguments import Commands, add_command, add_limits

if TYPE_CHECKING:
    from beltgui.cli.csv_table import Table
    from beltgui.cli.job import Job
    from core.frames import Array

# Normals printed with two digits still pass.
UNIT_TOLERANCE = 1e-2

DESCRIPTION = """SAMPLES.csv has a header u,v,error_mm, or u,v,angle_deg,nx,ny,nz (head angle against the nominal
contact, outward normal in the tool frame), which needs --tool. An empty error_mm or
angle_deg is a missing sample (--smooth)."""


def add(commands: Commands) -> None:
    """Declare the command."""
    parser = add_command(commands, "error-surface", "spline of the normal errors on the airfoil", DESCRIPTION, run)
    parser.add_argument("samples", metavar="SAMPLES.csv")
    parser.add_argument("--tool", metavar="TOOL.json", help="output of `beltcal tool`, for its radius_mm")
    parser.add_argument("--smooth", action="store_true", help="smoothing spline that rejects wrong samples")
    parser.add_argument("--evaluate", metavar="POINTS.csv", help="also give error_mm at these u,v")
    add_limits(parser)


def run(args: argparse.Namespace, job: Job) -> dict[str, Any]:
    """Read, fit, judge, evaluate."""
    from beltgui.cli.csv_table import read_csv
    from beltgui.cli.limits import read_limits
    from beltgui.steps.error_surface.record import evaluation, record
    from core.error_surface import ErrorSurfaceLimits, fit_error_surface, judge_error_surface

    limits = read_limits(args.limits, "error-surface", ErrorSurfaceLimits)
    table = read_csv(args.samples, [("u", "v", "error_mm"), ("u", "v", "angle_deg", "nx", "ny", "nz")],
                     may_be_empty=("error_mm", "angle_deg"))
    job.reads(args.samples)
    points = None
    if args.evaluate:
        points = read_csv(args.evaluate, [("u", "v")])
        job.reads(args.evaluate)
    error_mm = _errors(table, args, job)
    with job.about(args.samples):
        surface = fit_error_surface(table.columns["u"], table.columns["v"], error_mm,
                                    mode="smooth" if args.smooth else "interpolate")
    result = record(surface, judge_error_surface(surface, limits))
    for entry in result["rejected"]:
        entry["line"] = table.lines[entry["index"]]
    if points is not None:
        result["evaluated"] = evaluation(surface, points.columns["u"], points.columns["v"])
        result["error_mm"] = result["evaluated"]["error_mm"]
    return result


def _errors(table: Table, args: argparse.Namespace, job: Job) -> Array:
    import numpy as np

    from core.error_surface import normal_error
    from core.errors import InputError

    if "error_mm" in table.columns:
        if args.tool:
            job.say(f"{args.tool}: not used, {args.samples} already gives error_mm.")
        return table.columns["error_mm"]
    if not args.tool:
        raise InputError(f"{args.samples}: the samples are head angles, which need the tool's radius. Give "
                         "--tool TOOL.json, the output of `beltcal tool`.")
    tool = job.json(args.tool)
    radius_mm = tool.key("radius_mm").radius_mm()
    job.refuse_if_rejected(tool)
    normals = np.column_stack([table.columns[name] for name in ("nx", "ny", "nz")])
    length = np.linalg.norm(normals, axis=1)
    odd = np.flatnonzero(np.abs(length - 1.0) > UNIT_TOLERANCE)
    if odd.size:
        raise InputError(f"{args.samples}: line {table.lines[odd[0]]}, columns nx, ny, nz have the length "
                         f"{length[odd[0]]:.4g}, expected a unit vector.")
    angle_rad = np.radians(table.columns["angle_deg"])
    present = np.isfinite(angle_rad)
    error_mm = np.full(len(angle_rad), np.nan)
    with job.about(args.samples):
        error_mm[present] = normal_error(angle_rad[present], normals[present], radius_mm)
    return error_mm
