"""Fine step: pose of the blade in the measurement frame from its CAD faces."""

from core.fine.assign import Assignment, assign_points
from core.fine.hold import Hold, analyse_faces
from core.fine.judge import FineLimits, half_split_limit_mm, judge_fine
from core.fine.outlines import box_outlines
from core.fine.result import FaceResult, FineFit
from core.fine.settings import FineSettings
from core.fine.solve import solve_fine

__all__ = ["Assignment", "FaceResult", "FineFit", "FineLimits", "FineSettings", "Hold", "analyse_faces",
           "assign_points", "box_outlines", "half_split_limit_mm", "judge_fine", "solve_fine"]
