"""Makes the CAD models of the blade types that come with the program: `python -m resources.make_blades [FOLDER]`."""

from __future__ import annotations

import re
import sys
from pathlib import Path
from typing import Any

import numpy as np

from resources.blade_design import DESIGNS, Array, BladeDesign, Plate, airfoil_poles

# The airfoil runs this far into edge plate and shroud, whose ring surfaces fall off to both sides.
OVERLAP_MM = 1.0
# The header carries no clock and no machine: the same design makes the same file.
HEADER = """HEADER;
FILE_DESCRIPTION(('Turbine blade {name}, simulated'),'2;1');
FILE_NAME('{file}','2026-01-01T00:00:00',(''),(''),'','','');
FILE_SCHEMA(('AUTOMOTIVE_DESIGN {{ 1 0 10303 214 1 1 1 1 }}'));
ENDSEC;"""


def _spline_surface(poles: Array, knots_u: Array, knots_v: Array) -> Any:
    """Bicubic kernel surface from poles (U, V, 3) and full knot vectors."""
    from OCP.collections import Array1_double, Array1_int, Array2_gp_Pnt
    from OCP.Geom import Geom_BSplineSurface
    from OCP.gp import gp_Pnt

    def reals(values: Array) -> Any:
        array = Array1_double(1, len(values))
        for i, value in enumerate(values, start=1):
            array.SetValue(i, float(value))
        return array

    def integers(values: Array) -> Any:
        array = Array1_int(1, len(values))
        for i, value in enumerate(values, start=1):
            array.SetValue(i, int(value))
        return array

    grid = Array2_gp_Pnt(1, poles.shape[0], 1, poles.shape[1])
    for i, row in enumerate(poles, start=1):
        for j, pole in enumerate(row, start=1):
            grid.SetValue(i, j, gp_Pnt(*(float(value) for value in pole)))
    u, count_u = np.unique(knots_u, return_counts=True)
    v, count_v = np.unique(knots_v, return_counts=True)
    return Geom_BSplineSurface(grid, reals(u), reals(v), integers(count_u), integers(count_v), 3, 3)


def _airfoil(design: BladeDesign) -> Any:
    """Solid of the airfoil: one wrapped face, a trailing-edge strip, a flat cap at each end."""
    from OCP.BRepBuilderAPI import BRepBuilderAPI_MakeEdge, BRepBuilderAPI_MakeFace, BRepBuilderAPI_MakeWire
    from OCP.GeomFill import GeomFill

    surface = _spline_surface(*airfoil_poles(design, OVERLAP_MM))
    pressure, suction = surface.UIso(0.0), surface.UIso(1.0)
    faces = [BRepBuilderAPI_MakeFace(surface, 1e-6).Face(),
             BRepBuilderAPI_MakeFace(GeomFill.Surface_s(pressure, suction), 1e-6).Face()]
    for v in (0.0, 1.0):
        profile = surface.VIso(v)
        wire = BRepBuilderAPI_MakeWire(
            BRepBuilderAPI_MakeEdge(profile).Edge(),
            BRepBuilderAPI_MakeEdge(profile.Value(1.0), profile.Value(0.0)).Edge()).Wire()
        faces.append(BRepBuilderAPI_MakeFace(wire, True).Face())
    return _solid(faces)


def _solid(faces: list[Any]) -> Any:
    """Sew faces to a closed solid, outward side out."""
    from OCP.BRepBuilderAPI import BRepBuilderAPI_MakeSolid, BRepBuilderAPI_Sewing
    from OCP.BRepLib import BRepLib
    from OCP.TopoDS import TopoDS

    sewing = BRepBuilderAPI_Sewing(1e-5)
    for face in faces:
        sewing.Add(face)
    sewing.Perform()
    solid = BRepBuilderAPI_MakeSolid(TopoDS.Shell(sewing.SewedShape())).Solid()
    BRepLib.OrientClosedSolid_s(solid)
    return solid


def _prism(outline: Array, along: Array) -> Any:
    """Solid of a closed polygon (N, 3) moved along a vector (3,)."""
    from OCP.BRepBuilderAPI import BRepBuilderAPI_MakeFace, BRepBuilderAPI_MakePolygon
    from OCP.BRepPrimAPI import BRepPrimAPI_MakePrism
    from OCP.gp import gp_Pnt, gp_Vec

    polygon = BRepBuilderAPI_MakePolygon()
    for point in outline:
        polygon.Add(gp_Pnt(*(float(value) for value in point)))
    polygon.Close()
    face = BRepBuilderAPI_MakeFace(polygon.Wire(), True).Face()
    return BRepPrimAPI_MakePrism(face, gp_Vec(*(float(value) for value in along))).Shape()


def _plate(plate: Plate, outer_radius: float, axis_z: float) -> Any:
    """Ring sector about the turbine's axis (along x at z = axis_z), its long sides cut by two skew planes."""
    from OCP.BRepAlgoAPI import BRepAlgoAPI_Common, BRepAlgoAPI_Cut
    from OCP.BRepPrimAPI import BRepPrimAPI_MakeCylinder
    from OCP.gp import gp_Ax2, gp_Dir, gp_Pnt

    half = plate.length_mm / 2
    # The seam of the full ring lies opposite to the blade.
    axes = gp_Ax2(gp_Pnt(-half, 0.0, axis_z), gp_Dir(1.0, 0.0, 0.0), gp_Dir(0.0, 0.0, -1.0))
    ring = BRepAlgoAPI_Cut(BRepPrimAPI_MakeCylinder(axes, outer_radius, plate.length_mm).Shape(),
                           BRepPrimAPI_MakeCylinder(axes, outer_radius - plate.thickness_mm, plate.length_mm).Shape())
    reach, shift = half + 5.0, np.tan(plate.skew_rad)
    crest = axis_z + outer_radius
    corners = [(x, plate.offset_y_mm - shift * x + side * plate.width_mm / 2, crest - 5.0 - plate.thickness_mm)
               for x, side in ((-reach, -1), (reach, -1), (reach, 1), (-reach, 1))]
    sides = _prism(np.array(corners), np.array([0.0, 0.0, plate.thickness_mm + 10.0]))
    return BRepAlgoAPI_Common(ring.Shape(), sides).Shape()


def _root(design: BladeDesign) -> Any:
    """Fir-tree root: its symmetric outline moved along x."""
    right = np.array(design.root_outline_mm)
    outline = np.vstack([right, right[::-1] * [-1.0, 1.0]])
    half = design.root_length_mm / 2
    return _prism(np.column_stack([np.full(len(outline), -half), outline]), np.array([2 * half, 0.0, 0.0]))


def build(design: BladeDesign) -> Any:
    """The whole blade as one kernel solid."""
    from OCP.BRepAlgoAPI import BRepAlgoAPI_Fuse
    from OCP.TopAbs import TopAbs_ShapeEnum
    from OCP.TopExp import TopExp_Explorer

    axis_z = -design.hub_radius_mm
    tip_radius = design.hub_radius_mm + design.span_mm + design.shroud.thickness_mm
    shape = _airfoil(design)
    for part in (_plate(design.platform, design.hub_radius_mm, axis_z), _plate(design.shroud, tip_radius, axis_z),
                 _root(design)):
        shape = BRepAlgoAPI_Fuse(shape, part).Shape()
    return TopExp_Explorer(shape, TopAbs_ShapeEnum.TopAbs_SOLID).Current()


def face_name(design: BladeDesign, face: Any) -> str:
    """S1 to S6, AIRFOIL, TE by where a kernel face lies; empty for the others."""
    from OCP.BRepAdaptor import BRepAdaptor_Surface
    from OCP.BRepGProp import BRepGProp
    from OCP.GeomAbs import GeomAbs_SurfaceType as Kind
    from OCP.GProp import GProp_GProps
    from OCP.TopAbs import TopAbs_Orientation

    surface, properties = BRepAdaptor_Surface(face), GProp_GProps()
    BRepGProp.SurfaceProperties_s(face, properties)
    z = properties.CentreOfMass().Z()
    kind = surface.GetType()
    if kind == Kind.GeomAbs_BSplineSurface:
        return "AIRFOIL" if surface.UDegree() == 3 and properties.Mass() > 10 * design.span_mm else "TE"
    if kind == Kind.GeomAbs_Cylinder:
        radius = surface.Cylinder().Radius()
        tip = design.hub_radius_mm + design.span_mm + design.shroud.thickness_mm
        return "S4" if abs(radius - tip) < 1e-6 else "S1" if abs(radius - design.hub_radius_mm) < 1e-6 else ""
    position = surface.Plane().Position()
    normal = position.XDirection().Crossed(position.YDirection())
    sign = -1.0 if face.Orientation() == TopAbs_Orientation.TopAbs_REVERSED else 1.0
    at_shroud, at_platform = z > design.span_mm, -design.platform.thickness_mm < z < 0.0
    if sign * normal.X() > 0.99 and (at_shroud or at_platform):
        return "S5" if at_shroud else "S3"
    if sign * normal.Y() > 0.8 and (at_shroud or at_platform):
        return "S6" if at_shroud else "S2"
    return ""


def write_step(design: BladeDesign, path: Path) -> None:
    """Write the blade with its face names as STEP AP214, mm."""
    from OCP.STEPConstruct import STEPConstruct
    from OCP.STEPControl import STEPControl_StepModelType, STEPControl_Writer
    from OCP.TCollection import TCollection_HAsciiString
    from OCP.TopAbs import TopAbs_ShapeEnum
    from OCP.TopExp import TopExp_Explorer
    from OCP.TopoDS import TopoDS

    from core.cad.kernel import quiet_kernel

    quiet_kernel()
    solid = build(design)
    writer = STEPControl_Writer()
    writer.Transfer(solid, STEPControl_StepModelType.STEPControl_AsIs)
    finder = writer.WS().TransferWriter().FinderProcess()
    explorer = TopExp_Explorer(solid, TopAbs_ShapeEnum.TopAbs_FACE)
    while explorer.More():
        name = face_name(design, TopoDS.Face(explorer.Current()))
        STEPConstruct.FindEntity_s(finder, explorer.Current()).SetName(TCollection_HAsciiString(name))
        explorer.Next()
    writer.Write(str(path))
    text = path.read_text(encoding="ascii")
    text = re.sub(r"HEADER;.*?ENDSEC;", HEADER.format(name=design.name, file=path.name), text, count=1, flags=re.S)
    product = rf"PRODUCT('{design.name}','{design.name}'"
    text = re.sub(r"PRODUCT\('[^']*',\s*'[^']*'", product, text, count=1)
    path.write_text(text, encoding="ascii", newline="\n")


def main(folder: Path) -> None:
    """Write `<type>.step` of every design into a folder."""
    for design in DESIGNS:
        write_step(design, folder / f"{design.name.lower()}.step")


if __name__ == "__main__":
    main(Path(sys.argv[1]) if len(sys.argv) > 1 else Path(__file__).parent / "blades")
