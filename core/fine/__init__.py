"""Fine step: pose of the blade in the measurement frame from its CAD faces."""

from core.fine.result import FaceResult, FineFit
from core.fine.settings import FineSettings
from core.fine.solve import solve_fine

__all__ = ["FaceResult", "FineFit", "FineSettings", "solve_fine"]
