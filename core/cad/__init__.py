"""The blade's CAD model: faces, trims and airfoil of a STEP file, as plain arrays."""

from core.cad.blade_type import BladeType, read_blade_type
from core.cad.model import CadFace, CadModel, FaceType, Mesh
from core.cad.patches import Patch, merge_patches
from core.cad.spline_surface import ClosestPoints, SplineSurface
from core.cad.step_file import read_step
from core.cad.surfaces import Cylinder, Plane, Surface

__all__ = ["BladeType", "CadFace", "CadModel", "ClosestPoints", "Cylinder", "FaceType", "Mesh", "Patch", "Plane",
           "SplineSurface", "Surface", "merge_patches", "read_blade_type", "read_step"]
