"""One kernel face as a CadFace: kind, parameters, outward side and trim."""

from __future__ import annotations

from typing import Any

import numpy as np

from core.cad.kernel import area_of, is_reversed
from core.cad.model import CadFace, FaceType, Parameter
from core.cad.recognise import recognise
from core.cad.surfaces import Array, Cylinder, Plane, Surface
from core.cad.trims import CHORD_ERROR_MM, TrimError, cylinder_trim, plane_trim, recentred

# Share by which the trim's area may differ from the kernel's before the loops count as misread.
AREA_TOLERANCE = 2e-3

WHY_NOT: dict[FaceType, str] = {
    "cone": "Registration measures on planes and cylinders; this face is a cone.",
    "sphere": "Registration measures on planes and cylinders; this face is a sphere.",
    "torus": "Registration measures on planes and cylinders; this face is a torus.",
    "bspline": "Registration measures on planes and cylinders; this face is a free-form (B-spline) surface.",
    "other": "Registration measures on planes and cylinders; this face is a swept or offset surface.",
}


def read_face(face: Any, number: int, name: str | None, flip: int) -> CadFace:
    """Describe one kernel face.

    Args:
        face: Kernel face with its orientation in the solid.
        number: Its id, from 1.
        name: Its name in the file.
        flip: -1 where the solid came inside out.
    """
    from OCP.BRepAdaptor import BRepAdaptor_Surface

    adaptor = BRepAdaptor_Surface(face)
    kind = face_type(adaptor)
    outward = flip * (-1 if is_reversed(face) else 1)
    area = area_of(face)
    surface = _surface(adaptor, kind, outward)
    if surface is None:
        return CadFace(number, name, kind, area, _other_parameters(adaptor, kind), None, None, False, WHY_NOT[kind])
    extra: dict[str, Parameter] = {} if kind in ("plane", "cylinder") else {"stored_as": kind}
    kind = "plane" if isinstance(surface, Plane) else "cylinder"
    try:
        trim = plane_trim(face, surface) if isinstance(surface, Plane) else cylinder_trim(face, surface)
        if abs(trim.area - area) > AREA_TOLERANCE * area + CHORD_ERROR_MM * trim.length:
            raise TrimError(f"its boundary encloses {trim.area:.4g} mm², but its area is {area:.4g} mm²")
    except TrimError as error:
        why_not = f"The boundary of this face can't be used: {error}."
        return CadFace(number, name, kind, area, _parameters(surface) | extra, surface, None, False, why_not)
    surface, trim = recentred(surface, trim)
    return CadFace(number, name, kind, area, _parameters(surface) | extra, surface, trim, True, None)


def _surface(adaptor: Any, kind: FaceType, outward: int) -> Surface | None:
    """Plane or cylinder of a face, also one that is stored as another kind."""
    if kind == "plane":
        return _plane(adaptor, outward)
    if kind == "cylinder":
        return _cylinder(adaptor, outward)
    return recognise(adaptor, outward) if kind in ("bspline", "other") else None


def face_type(adaptor: Any) -> FaceType:
    """Kind of surface of a kernel surface adaptor."""
    from OCP.GeomAbs import GeomAbs_SurfaceType as Kind

    kinds: dict[Any, FaceType] = {
        Kind.GeomAbs_Plane: "plane", Kind.GeomAbs_Cylinder: "cylinder", Kind.GeomAbs_Cone: "cone",
        Kind.GeomAbs_Sphere: "sphere", Kind.GeomAbs_Torus: "torus", Kind.GeomAbs_BSplineSurface: "bspline",
        Kind.GeomAbs_BezierSurface: "bspline"}
    return kinds.get(adaptor.GetType(), "other")


def _vector(value: Any) -> Array:
    """(3,) of a kernel point or direction."""
    return np.array([value.X(), value.Y(), value.Z()])


def _plane(adaptor: Any, outward: int) -> Plane:
    """Plane with its normal away from the material."""
    position = adaptor.Plane().Position()
    x_axis, y_axis = _vector(position.XDirection()), outward * _vector(position.YDirection())
    return Plane(_vector(position.Location()), np.cross(x_axis, y_axis), x_axis, y_axis)


def _cylinder(adaptor: Any, outward: int) -> Cylinder:
    """Cylinder; a left-handed placement turns the outward side."""
    cylinder = adaptor.Cylinder()
    position = cylinder.Position()
    side = outward if position.Direct() else -outward
    return Cylinder(_vector(position.Location()), _vector(position.Direction()), _vector(position.XDirection()),
                    float(cylinder.Radius()), side)


def _tuple(vector: Array) -> tuple[float, ...]:
    return tuple(float(value) for value in vector)


def _parameters(surface: Surface) -> dict[str, Parameter]:
    """Parameters of a plane or cylinder for lists and files."""
    if isinstance(surface, Plane):
        return {"origin_mm": _tuple(surface.origin), "normal": _tuple(surface.normal)}
    return {"origin_mm": _tuple(surface.origin), "axis": _tuple(surface.axis), "radius_mm": surface.radius_mm,
            "side": "convex" if surface.outward > 0 else "concave"}


def _other_parameters(adaptor: Any, kind: FaceType) -> dict[str, Parameter]:
    """Parameters of the kinds that are only listed."""
    if kind == "cone":
        cone = adaptor.Cone()
        return {"apex_mm": _tuple(_vector(cone.Apex())), "axis": _tuple(_vector(cone.Axis().Direction())),
                "half_angle_rad": abs(float(cone.SemiAngle()))}
    if kind == "sphere":
        sphere = adaptor.Sphere()
        return {"center_mm": _tuple(_vector(sphere.Location())), "radius_mm": float(sphere.Radius())}
    if kind == "torus":
        torus = adaptor.Torus()
        return {"center_mm": _tuple(_vector(torus.Location())), "axis": _tuple(_vector(torus.Axis().Direction())),
                "major_radius_mm": float(torus.MajorRadius()), "minor_radius_mm": float(torus.MinorRadius())}
    if kind == "bspline":
        return {"degree_u": int(adaptor.UDegree()), "degree_v": int(adaptor.VDegree()),
                "poles_u": int(adaptor.NbUPoles()), "poles_v": int(adaptor.NbVPoles())}
    return {}
