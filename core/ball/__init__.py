"""Step 1, ball: the scanner on its stage."""

from core.ball.judge import SphereLimits, StageLimits, judge_sphere, judge_stage
from core.ball.sphere import SphereFit, fit_sphere
from core.ball.stage import RotaryAxis, StageFit, paper_axes, solve_stage
from core.ball.stage_checks import StageObservations

__all__ = [
    "RotaryAxis",
    "SphereFit",
    "SphereLimits",
    "StageFit",
    "StageLimits",
    "StageObservations",
    "fit_sphere",
    "judge_sphere",
    "judge_stage",
    "paper_axes",
    "solve_stage",
]
