"""The blade's CAD model: faces, trims and airfoil of a STEP file, as plain arrays."""

from core.cad.model import CadFace, CadModel, FaceType, Mesh
from core.cad.surfaces import Cylinder, Plane, Surface

__all__ = ["CadFace", "CadModel", "Cylinder", "FaceType", "Mesh", "Plane", "Surface"]
