"""Small solids with known faces, written as STEP files by the kernel itself; nothing of core is used."""

from pathlib import Path


def box(size=(10.0, 20.0, 30.0), corner=(0.0, 0.0, 0.0)):
    from OCP.BRepPrimAPI import BRepPrimAPI_MakeBox
    from OCP.gp import gp_Pnt

    return BRepPrimAPI_MakeBox(gp_Pnt(*corner), *size).Shape()


def cylinder(radius, height, *, at=(0.0, 0.0, 0.0), axis=(0.0, 0.0, 1.0), x_axis=None, angle=None):
    from OCP.BRepPrimAPI import BRepPrimAPI_MakeCylinder
    from OCP.gp import gp_Ax2, gp_Dir, gp_Pnt

    axes = gp_Ax2(gp_Pnt(*at), gp_Dir(*axis), gp_Dir(*x_axis)) if x_axis else gp_Ax2(gp_Pnt(*at), gp_Dir(*axis))
    arguments = (axes, radius, height) if angle is None else (axes, radius, height, angle)
    return BRepPrimAPI_MakeCylinder(*arguments).Shape()


def cut(first, second):
    from OCP.BRepAlgoAPI import BRepAlgoAPI_Cut

    return BRepAlgoAPI_Cut(first, second).Shape()


def fuse(first, second):
    from OCP.BRepAlgoAPI import BRepAlgoAPI_Fuse

    return BRepAlgoAPI_Fuse(first, second).Shape()


def compound(*shapes):
    from OCP.BRep import BRep_Builder
    from OCP.TopoDS import TopoDS_Compound

    result = TopoDS_Compound()
    builder = BRep_Builder()
    builder.MakeCompound(result)
    for shape in shapes:
        builder.Add(result, shape)
    return result


def moved(shape, matrix):
    """The shape placed by a 4x4 rigid matrix; its own coordinates stay as they are."""
    from OCP.gp import gp_Trsf
    from OCP.TopLoc import TopLoc_Location

    trsf = gp_Trsf()
    trsf.SetValues(*(float(value) for value in matrix[:3].ravel()))
    return shape.Moved(TopLoc_Location(trsf))


def faces(shape):
    from OCP.TopAbs import TopAbs_ShapeEnum
    from OCP.TopExp import TopExp_Explorer
    from OCP.TopoDS import TopoDS

    explorer, found = TopExp_Explorer(shape, TopAbs_ShapeEnum.TopAbs_FACE), []
    while explorer.More():
        found.append(TopoDS.Face(explorer.Current()))
        explorer.Next()
    return found


def write(shape, path: Path, names=None, unit="MM") -> Path:
    """Write a shape; `names` maps the place of a face (from 0) to its name."""
    from OCP.Interface import Interface_Static
    from OCP.Message import Message
    from OCP.STEPConstruct import STEPConstruct
    from OCP.STEPControl import STEPControl_StepModelType, STEPControl_Writer
    from OCP.TCollection import TCollection_HAsciiString

    for printer in list(Message.DefaultMessenger_s().Printers()):
        Message.DefaultMessenger_s().RemovePrinter(printer)
    writer = STEPControl_Writer()
    Interface_Static.SetCVal_s("write.step.unit", unit)
    try:
        writer.Transfer(shape, STEPControl_StepModelType.STEPControl_AsIs)
    finally:
        Interface_Static.SetCVal_s("write.step.unit", "MM")
    finder = writer.WS().TransferWriter().FinderProcess()
    for place, face in enumerate(faces(shape)):
        if names and place in names:
            STEPConstruct.FindEntity_s(finder, face).SetName(TCollection_HAsciiString(names[place]))
    writer.Write(str(path))
    return path
