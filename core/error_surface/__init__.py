"""Error surface: normal error of the blade against the wheel over the airfoil's (u, v)."""

from core.error_surface.fit import fit_error_surface
from core.error_surface.judge import ErrorSurfaceLimits, judge_error_surface, judge_mismatch
from core.error_surface.normal import angle_for_error, normal_error
from core.error_surface.region import MeasuredRegion
from core.error_surface.several import SurfaceAverage, SurfaceMismatch, average_surfaces, surface_mismatch
from core.error_surface.surface import ErrorSurface, error_surface_from_json_dict

__all__ = [
    "ErrorSurface",
    "ErrorSurfaceLimits",
    "MeasuredRegion",
    "SurfaceAverage",
    "SurfaceMismatch",
    "angle_for_error",
    "average_surfaces",
    "error_surface_from_json_dict",
    "fit_error_surface",
    "judge_error_surface",
    "judge_mismatch",
    "normal_error",
    "surface_mismatch",
]
