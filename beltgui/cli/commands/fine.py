"""`beltcal fine`: the blade's pose from its machined faces."""

from __future__ import annotations

import argparse
from typing import TYPE_CHECKING, Any

from beltgui.cli.arguments import Commands, add_command, add_limits
from core.errors import InputError

if TYPE_CHECKING:
    from beltgui.cli.fields import Field
    from beltgui.cli.job import Job
    from core.frames import Array

DESCRIPTION = """Scans are in the measurement frame; --scan may be given several times. POSE.json is {"matrix": 4x4},
the measure_from_work to start from, or the output of `beltcal rough`. Faces are ids or names from `beltcal faces`;
without --faces all planes and cylinders that have points are used."""


def add(commands: Commands) -> None:
    """Declare the command."""
    parser = add_command(commands, "fine", "pose of the blade from the faces of its STEP model", DESCRIPTION, run)
    parser.add_argument("--cad", metavar="STEP", required=True)
    parser.add_argument("--scan", metavar="CLOUD", required=True, action="append")
    parser.add_argument("--start", metavar="POSE.json", required=True)
    parser.add_argument("--faces", metavar="ID,..", help="ids or names, separated by commas")
    add_limits(parser)


def run(args: argparse.Namespace, job: Job) -> dict[str, Any]:
    """Read, solve, judge."""
    faces = _faces(args.faces)
    for i, path in enumerate(args.scan):
        if path in args.scan[:i]:
            raise InputError(f"{path}: this scan is given twice, expected each scan once.")
    from beltgui.cli.limits import read_limits
    from beltgui.steps.fine.record import record
    from core.fine import FineLimits, judge_fine, solve_fine

    limits = read_limits(args.limits, "fine", FineLimits)
    start = _start(job.json(args.start), job)
    clouds = [job.cloud(path) for path in args.scan]
    model = job.step(args.cad)
    with job.about(args.cad):
        selected = None if faces is None else [face.id for face in model.select(faces)]
    with job.about(", ".join(args.scan)):
        fit = solve_fine(model, [cloud.points_mm for cloud in clouds], start, face_ids=selected)
        verdict = judge_fine(fit, limits)
    return {**record(fit, verdict), "dropped": sum(cloud.dropped for cloud in clouds)}


def _faces(text: str | None) -> list[str] | None:
    if text is None:
        return None
    names = [name.strip() for name in text.split(",")]
    if not all(names):
        raise InputError(f"argument --faces: found {text[:40]!r}, expected ids or names separated by commas.")
    return names


def _start(root: Field, job: Job) -> Array:
    """The pose in `{"matrix"}` or in a result that has `measure_from_work`."""
    if root.has("matrix"):
        return root.key("matrix").transform()
    if root.has("measure_from_work"):
        job.warn_if_rejected(root)
        return root.key("measure_from_work").key("matrix").transform()
    raise InputError(f"{root.file}: the file has neither a \"matrix\" nor a \"measure_from_work\"; expected "
                     "{\"matrix\": 4x4}.")
