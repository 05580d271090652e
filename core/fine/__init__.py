"""Fine step: pose of the blade in the measurement frame from its CAD faces."""

from core.fine.assign import Assignment, assign_points
from core.fine.judge import FineLimits, judge_fine
from core.fine.result import FaceResult, FineFit
from core.fine.settings import FineSettings
from core.fine.solve import solve_fine

__all__ = ["Assignment", "FaceResult", "FineFit", "FineLimits", "FineSettings", "assign_points", "judge_fine",
           "solve_fine"]
