"""The CAD kernel (OpenCASCADE) at arm's length; it is imported inside functions, for it takes about a second."""

from __future__ import annotations

from typing import Any

AREA_ACCURACY = 1e-6


def quiet_kernel() -> None:
    """Take away the kernel's own message printers: stdout belongs to the caller's JSON."""
    from OCP.Message import Message

    messenger = Message.DefaultMessenger_s()
    for printer in list(messenger.Printers()):
        messenger.RemovePrinter(printer)


def faces_of(shape: Any) -> list[Any]:
    """Kernel faces of a shape in the file's order, each placed face once, with its orientation in the solid."""
    from OCP.collections import IndexedMap_TopoDS_Shape_TopTools_ShapeMapHasher as ShapeMap
    from OCP.TopAbs import TopAbs_ShapeEnum
    from OCP.TopExp import TopExp
    from OCP.TopoDS import TopoDS

    found = ShapeMap()
    TopExp.MapShapes_s(shape, TopAbs_ShapeEnum.TopAbs_FACE, found)
    return [TopoDS.Face(found.FindKey(i)) for i in range(1, found.Extent() + 1)]


def is_reversed(shape: Any) -> bool:
    """True where a kernel shape is used against its own direction."""
    from OCP.TopAbs import TopAbs_Orientation

    return bool(shape.Orientation() == TopAbs_Orientation.TopAbs_REVERSED)


def is_closed_solid(shape: Any) -> bool:
    """True where every face belongs to a closed shell of a solid."""
    from OCP.BRep import BRep_Tool
    from OCP.collections import IndexedMap_TopoDS_Shape_TopTools_ShapeMapHasher as ShapeMap
    from OCP.TopAbs import TopAbs_ShapeEnum
    from OCP.TopExp import TopExp

    solids, in_solids = ShapeMap(), ShapeMap()
    TopExp.MapShapes_s(shape, TopAbs_ShapeEnum.TopAbs_SOLID, solids)
    for i in range(1, solids.Extent() + 1):
        shells = ShapeMap()
        TopExp.MapShapes_s(solids.FindKey(i), TopAbs_ShapeEnum.TopAbs_SHELL, shells)
        if not all(BRep_Tool.IsClosed_s(shells.FindKey(j)) for j in range(1, shells.Extent() + 1)):
            return False
        TopExp.MapShapes_s(solids.FindKey(i), TopAbs_ShapeEnum.TopAbs_FACE, in_solids)
    return bool(in_solids.Extent() == len(faces_of(shape)))


def outward_flip(shape: Any) -> int:
    """-1 where a closed solid came inside out (its volume is negative), else +1."""
    from OCP.BRepGProp import BRepGProp
    from OCP.GProp import GProp_GProps

    if not is_closed_solid(shape):
        return 1
    properties = GProp_GProps()
    BRepGProp.VolumeProperties_s(shape, properties)
    return -1 if properties.Mass() < 0.0 else 1


def area_of(face: Any) -> float:
    """True area of a kernel face in mm^2; adaptive, for the plain integration is 0.3 % off where a spline bounds it."""
    from OCP.BRepGProp import BRepGProp
    from OCP.GProp import GProp_GProps

    properties = GProp_GProps()
    BRepGProp.SurfaceProperties_s(face, properties, AREA_ACCURACY)
    return abs(float(properties.Mass()))


def bounding_box(shape: Any) -> tuple[tuple[float, float, float], tuple[float, float, float]]:
    """Lower and upper corner in mm of a shape, by its exact geometry."""
    from OCP.Bnd import Bnd_Box
    from OCP.BRepBndLib import BRepBndLib

    box = Bnd_Box()
    BRepBndLib.AddOptimal_s(shape, box, False, False)
    low, high = box.CornerMin(), box.CornerMax()
    return (low.X(), low.Y(), low.Z()), (high.X(), high.Y(), high.Z())
