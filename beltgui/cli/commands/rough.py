"""`beltcal rough`: a first pose of the blade, from picked pairs or from the scan alone."""

from __future__ import annotations

import argparse
from typing import TYPE_CHECKING, Any

from beltgui.cli.arguments import Commands, add_command, add_limits, length_mm, whole_number
from core.errors import InputError

if TYPE_CHECKING:
    from beltgui.cli.job import Job

DESCRIPTION = """PAIRS.json:
  {"pairs": [{"name": "corner 1", "scan_mm": [x,y,z], "cad_mm": [x,y,z]}, ...]}
At least three pairs that are not on a line; five let a bad pick be named. Or without picks:
  beltcal rough --auto --cad BLADE.step --scan CLOUD"""


def add(commands: Commands) -> None:
    """Declare the command."""
    parser = add_command(commands, "rough", "first pose of the blade from picked pairs or automatically", DESCRIPTION,
                         run)
    parser.add_argument("pairs", metavar="PAIRS.json", nargs="?")
    parser.add_argument("--auto", action="store_true", help="register the scan to the CAD model without picks")
    parser.add_argument("--cad", metavar="STEP")
    parser.add_argument("--scan", metavar="CLOUD", help="scan in the measurement frame")
    parser.add_argument("--stock", metavar="MM", type=length_mm, default=0.0,
                        help="how far faces that are still to be ground may be from the model, with --auto (default 0)")
    parser.add_argument("--seed", type=whole_number, default=0, help="of the random search with --auto")
    add_limits(parser)


def run(args: argparse.Namespace, job: Job) -> dict[str, Any]:
    """One of the two ways."""
    if args.auto:
        if args.pairs or not (args.cad and args.scan):
            raise InputError("rough --auto needs --cad STEP and --scan CLOUD, and no pairs file.")
        return _automatic(args, job)
    if args.cad or args.scan:
        raise InputError("rough: --cad and --scan belong to --auto. Give either --auto or a pairs file.")
    if not args.pairs:
        raise InputError("rough: give PAIRS.json, or --auto --cad STEP --scan CLOUD.")
    return _from_pairs(args, job)


def _from_pairs(args: argparse.Namespace, job: Job) -> dict[str, Any]:
    import numpy as np

    from beltgui.cli.limits import read_limits
    from beltgui.steps.rough.record import record
    from core.rough import PairsLimits, judge_pairs, solve_pairs

    limits = read_limits(args.limits, "rough", PairsLimits)
    root = job.json(args.pairs)
    items = job.rows(root, "pairs", ("scan_mm", "cad_mm"))
    names = [item.key("name").text() if item.has("name") else f"pair {i}" for i, item in enumerate(items, start=1)]
    for i, name in enumerate(names):
        if name in names[:i]:
            raise InputError(f"{args.pairs}: pairs[{i}].name is {name[:40]!r} again, expected each name once.")
    scan = np.array([item.key("scan_mm").vector(3) for item in items])
    cad = np.array([item.key("cad_mm").vector(3) for item in items])
    with job.about(args.pairs):
        fit = solve_pairs(scan, cad, names=names)
    for remark in fit.remarks:
        job.say(f"{args.pairs}: {remark}")
    return record(fit, judge_pairs(fit, limits))


def _automatic(args: argparse.Namespace, job: Job) -> dict[str, Any]:
    from beltgui.cli.limits import read_limits
    from beltgui.steps.rough.record import automatic_record
    from core.fine import FineLimits, judge_fine, solve_fine
    from core.rough import GlobalSettings, register_globally

    limits = read_limits(args.limits, "fine", FineLimits)
    cloud = job.cloud(args.scan)
    model = job.step(args.cad)
    job.say("searching for the blade in the scan.")
    with job.about(args.scan):
        settings = GlobalSettings(surface_mm=max(GlobalSettings.surface_mm, args.stock))
        fit = register_globally(model, cloud.points_mm, confirm=solve_fine, seed=args.seed, settings=settings)
        verdict = judge_fine(fit.fine, limits)
    return automatic_record(fit, verdict)
