"""Tool: the stylus tip on the flange, and the contact wheel touched with it."""

from core.tool.judge import StylusLimits, judge_stylus
from core.tool.stylus import StylusFit, solve_stylus

__all__ = ["StylusFit", "StylusLimits", "judge_stylus", "solve_stylus"]
