"""Base: the measuring frame in the robot's base frame, from a ball on the flange."""

from core.base.judge import BaseLimits, judge_base
from core.base.solve import BaseFit, solve_base
from core.base.suggest import PoseGain, suggest_next_pose

__all__ = ["BaseFit", "BaseLimits", "PoseGain", "judge_base", "solve_base", "suggest_next_pose"]
