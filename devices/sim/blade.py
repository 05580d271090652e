"""The true blade: a STEP solid whose datum faces are exact and whose airfoil carries its manufacturing error."""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property, lru_cache
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from devices.sim.airfoil import SplinePoles, TrueAirfoil
from devices.sim.contact import ContactSolver
from devices.sim.geometry import Array
from devices.sim.rays import AirfoilSurface, CylinderSurface, PlaneSurface, RayScene, Solid, Surface

_CHORD_MM = 0.05  # planes and cylinders are refined exactly: the mesh only has to find the face
_FINE_CHORD_MM = 0.002
_MESH_STEP_U, _MESH_STEP_V = 2, 4  # divide the airfoil's grid evenly

_FaceMesh = tuple[Array, NDArray[np.intp], Surface | None]


class BladeFileError(ValueError):
    """A STEP file does not hold a blade that can be simulated; the message names the file."""


@dataclass(frozen=True, eq=False)
class Blade:
    """One blade type with its error; never changes, so worlds may share one.

    Attributes:
        solid: For ray casting, frame {W}.
        airfoil: The true airfoil.
    """

    solid: Solid
    airfoil: TrueAirfoil

    @cached_property
    def scene(self) -> RayScene:
        """The solid, ready for rays in {W}; made on first use."""
        return RayScene(self.solid)

    @cached_property
    def contacts(self) -> ContactSolver:
        """Finds where a wheel touches the airfoil; made on first use."""
        return ContactSolver(self.airfoil)


@lru_cache(maxsize=4)
def load_blade(step: Path, shape_error_mm: float, airfoil_shift_mm: tuple[float, float, float]) -> Blade:
    """Read a blade; its airfoil is the face named AIRFOIL, or else the largest B-spline face.

    A blade that was read before with the same error is returned again.

    Args:
        step: STEP file in mm.
        shape_error_mm: Amplitude of the error cos(4 pi v) along the outward normal, v from 0 to 1 up the span.
        airfoil_shift_mm: (3,) shift of the airfoil against the datum faces, frame {W}.

    Raises:
        BladeFileError: not a STEP file, or no airfoil in it.
    """
    faces = _read_faces(step)
    candidates = [i for i, (_, name, _) in enumerate(faces) if name == "AIRFOIL"] or [
        i for i, (_, _, poles) in enumerate(faces) if poles is not None
    ]
    if not candidates:
        raise BladeFileError(f"{step}: no B-spline face found that could be the airfoil.")
    chosen = max(candidates, key=lambda i: _pole_count(faces[i][2]))
    poles = faces[chosen][2]
    if poles is None:
        raise BladeFileError(f"{step}: the face AIRFOIL is not a non-rational B-spline surface.")
    airfoil = TrueAirfoil(poles, lambda v: shape_error_mm * np.cos(4.0 * np.pi * v), np.array(airfoil_shift_mm))

    vertices, triangles, face_of, surfaces = [], [], [], []
    used = 0
    for index, (face, name, _) in enumerate(faces):
        points, corners, surface = (
            _airfoil_mesh(airfoil, used) if index == chosen
            else _trailing_edge_mesh(airfoil) if name == "TE"
            else _face_mesh(face)
        )  # fmt: skip
        vertices.append(points)
        triangles.append(corners + used)
        face_of.append(np.full(len(corners), index, dtype=np.intp))
        surfaces.append(surface)
        used += len(points)
    solid = Solid(
        np.concatenate(vertices), np.concatenate(triangles), np.concatenate(face_of), tuple(surfaces),
        tuple(name for _, name, _ in faces),
    )  # fmt: skip
    return Blade(solid, airfoil)


def _read_faces(step: Path) -> list[tuple[Any, str, SplinePoles | None]]:
    from OCP.IFSelect import IFSelect_ReturnStatus
    from OCP.Message import Message
    from OCP.STEPControl import STEPControl_Reader
    from OCP.TopAbs import TopAbs_ShapeEnum
    from OCP.TopExp import TopExp_Explorer
    from OCP.TopoDS import TopoDS

    messenger = Message.DefaultMessenger_s()
    for printer in list(messenger.Printers()):
        messenger.RemovePrinter(printer)  # stdout belongs to the caller's results
    reader = STEPControl_Reader()
    if not step.is_file() or reader.ReadFile(str(step)) != IFSelect_ReturnStatus.IFSelect_RetDone:
        raise BladeFileError(f"{step}: not a readable STEP file.")
    reader.TransferRoots()
    faces: list[tuple[Any, str, SplinePoles | None]] = []
    explorer = TopExp_Explorer(reader.OneShape(), TopAbs_ShapeEnum.TopAbs_FACE)
    while explorer.More():
        face = TopoDS.Face(explorer.Current())
        entity = reader.WS().TransferReader().EntityFromShapeResult(face, 1)
        name = entity.Name() if hasattr(entity, "Name") else None
        faces.append((face, name.ToCString() if name is not None else "", _poles(face)))
        explorer.Next()
    if not faces:
        raise BladeFileError(f"{step}: the file holds no faces.")
    return faces


def _poles(face: Any) -> SplinePoles | None:
    from OCP.BRepAdaptor import BRepAdaptor_Surface
    from OCP.GeomAbs import GeomAbs_SurfaceType
    from OCP.TopAbs import TopAbs_Orientation

    surface = BRepAdaptor_Surface(face)
    if surface.GetType() != GeomAbs_SurfaceType.GeomAbs_BSplineSurface:
        return None
    spline = surface.BSpline()
    if spline.IsURational() or spline.IsVRational() or spline.IsUPeriodic() or spline.IsVPeriodic():
        return None
    rows, columns = range(1, spline.NbUPoles() + 1), range(1, spline.NbVPoles() + 1)
    poles = np.array([[_xyz(spline.Pole(i, j)) for j in columns] for i in rows])
    knots_u = [spline.UKnot(i) for i in range(1, spline.NbUKnots() + 1) for _ in range(spline.UMultiplicity(i))]
    knots_v = [spline.VKnot(i) for i in range(1, spline.NbVKnots() + 1) for _ in range(spline.VMultiplicity(i))]
    outward = -1 if face.Orientation() == TopAbs_Orientation.TopAbs_REVERSED else 1
    return SplinePoles(poles, np.array(knots_u), np.array(knots_v), spline.UDegree(), spline.VDegree(), outward)


def _pole_count(poles: SplinePoles | None) -> int:
    return 0 if poles is None else poles.poles.size


def _airfoil_mesh(airfoil: TrueAirfoil, first: int) -> _FaceMesh:
    u, v = airfoil.u[::_MESH_STEP_U], airfoil.v[::_MESH_STEP_V]
    points = airfoil.points[::_MESH_STEP_U, ::_MESH_STEP_V].reshape(-1, 3)
    index = np.arange(len(u) * len(v)).reshape(len(u), len(v))
    a, b, c, d = index[:-1, :-1].ravel(), index[1:, :-1].ravel(), index[1:, 1:].ravel(), index[:-1, 1:].ravel()
    corners = np.concatenate([np.stack([a, b, c], 1), np.stack([a, c, d], 1)])
    if airfoil.design.outward < 0:
        corners = corners[:, ::-1]
    grid_u, grid_v = np.meshgrid(u, v, indexing="ij")
    # indices of triangles count over the whole solid: parameters of earlier vertices are never looked up
    uv = np.full((first + len(points), 2), np.nan)
    uv[first:] = np.stack([grid_u.ravel(), grid_v.ravel()], axis=1)
    return points, corners, AirfoilSurface(airfoil, uv)


def _trailing_edge_mesh(airfoil: TrueAirfoil) -> _FaceMesh:
    """The blunt trailing edge, ruled between the ends of the true airfoil so that no gap opens."""
    points = np.concatenate([airfoil.points[0], airfoil.points[-1]])
    count = airfoil.points.shape[1]
    a = np.arange(count - 1)
    corners = np.concatenate([np.stack([a, a + 1, a + count], 1), np.stack([a + 1, a + count + 1, a + count], 1)])
    first, second, third = points[corners[count // 2]]
    if np.cross(second - first, third - first) @ (first - airfoil.points.mean(axis=(0, 1))) < 0.0:
        corners = corners[:, ::-1]
    return points, corners, None


def _face_mesh(face: Any) -> _FaceMesh:
    from OCP.BRep import BRep_Tool
    from OCP.BRepMesh import BRepMesh_IncrementalMesh
    from OCP.TopAbs import TopAbs_Orientation
    from OCP.TopLoc import TopLoc_Location

    surface = _exact_surface(face)
    BRepMesh_IncrementalMesh(face, _FINE_CHORD_MM if surface is None else _CHORD_MM, False, 0.3, False)
    location = TopLoc_Location()
    mesh = BRep_Tool.Triangulation_s(face, location)
    move = location.Transformation()
    points = np.array([_xyz(mesh.Node(i).Transformed(move)) for i in range(1, mesh.NbNodes() + 1)])
    corners = np.array([mesh.Triangle(i).Get() for i in range(1, mesh.NbTriangles() + 1)], dtype=np.intp) - 1
    if face.Orientation() == TopAbs_Orientation.TopAbs_REVERSED:
        corners = corners[:, ::-1]
    return points, corners, surface


def _exact_surface(face: Any) -> Surface | None:
    from OCP.BRepAdaptor import BRepAdaptor_Surface
    from OCP.GeomAbs import GeomAbs_SurfaceType
    from OCP.TopAbs import TopAbs_Orientation

    surface = BRepAdaptor_Surface(face)
    sign = -1 if face.Orientation() == TopAbs_Orientation.TopAbs_REVERSED else 1
    if surface.GetType() == GeomAbs_SurfaceType.GeomAbs_Plane:
        position = surface.Plane().Position()
        normal = sign * np.cross(_xyz(position.XDirection()), _xyz(position.YDirection()))
        return PlaneSurface(normal, float(normal @ _xyz(position.Location())))
    if surface.GetType() == GeomAbs_SurfaceType.GeomAbs_Cylinder:
        cylinder = surface.Cylinder()
        position = cylinder.Position()
        handed = 1 if position.Direct() else -1
        return CylinderSurface(
            _xyz(position.Location()), _xyz(position.Direction()), float(cylinder.Radius()), sign * handed
        )
    return None


def _xyz(item: Any) -> Array:
    return np.array([item.X(), item.Y(), item.Z()])
