"""Tool: the stylus tip on the flange, and the contact wheel touched with it."""

from core.tool.judge import StylusLimits, WheelLimits, judge_stylus, judge_wheel
from core.tool.stylus import StylusFit, solve_stylus
from core.tool.wheel import WheelFit, arc_needed_rad, solve_wheel
from core.tool.wheel_checks import WheelTouches

__all__ = [
    "StylusFit",
    "StylusLimits",
    "WheelFit",
    "WheelLimits",
    "WheelTouches",
    "arc_needed_rad",
    "judge_stylus",
    "judge_wheel",
    "solve_stylus",
    "solve_wheel",
]
