"""`beltcal tool`: the contact wheel of one grinder."""

from __future__ import annotations

import argparse
from typing import TYPE_CHECKING, Any

from beltgui.cli.arguments import Commands, add_command, add_limits

if TYPE_CHECKING:
    from beltgui.cli.job import Job

DESCRIPTION = """OBS.json:
  {"radius_mm": Rg, "shaft_offset_mm": h, "touches": [{"angle_deg": a, "point_in_base_mm": [x,y,z]}, ...]}
The stylus touches the centre of the wheel shaft's side at four or more head angles; three are computed, but rejected
because a mistake would not show. Without radius_mm (head axis to wheel axis) it is fitted. shaft_offset_mm is the
way along the shaft from the touched side to the wheel's mid-plane, positive along the head axis direction; else 0."""


def add(commands: Commands) -> None:
    """Declare the command."""
    parser = add_command(commands, "tool", "frame of the contact wheel and axis of its head", DESCRIPTION, run)
    parser.add_argument("observations", metavar="OBS.json")
    add_limits(parser)


def run(args: argparse.Namespace, job: Job) -> dict[str, Any]:
    """Read, solve, judge."""
    import numpy as np

    from beltgui.cli.limits import read_limits
    from beltgui.steps.tool.record import wheel_record
    from core.tool import WheelLimits, WheelTouches, judge_wheel, solve_wheel

    limits = read_limits(args.limits, "tool", WheelLimits)
    root = job.json(args.observations)
    items = job.rows(root, "touches", ("angle_deg", "point_in_base_mm"), ("radius_mm", "shaft_offset_mm"))
    radius = root.get("radius_mm")
    offset = root.get("shaft_offset_mm")
    touches = WheelTouches(
        angle_rad=np.radians([item.key("angle_deg").number(at_most=3600.0) for item in items]),
        point_in_base_mm=np.array([item.key("point_in_base_mm").vector(3) for item in items]),
    )
    with job.about(args.observations):
        fit = solve_wheel(touches, radius_mm=radius.radius_mm() if radius else None,
                          shaft_offset_mm=offset.number() if offset else 0.0)
        verdict = judge_wheel(fit, limits)
    return wheel_record(fit, verdict)
