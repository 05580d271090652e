"""Blades that are in no project and noisy scans of them, made without the estimators, straight from the kernel."""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray
from scipy.spatial.transform import Rotation

from core.cad.kernel import quiet_kernel

Array = NDArray[np.float64]

SIGMA_MM = 0.035


@dataclass(frozen=True)
class Scene:
    """A simulated scan in M with its truth.

    Attributes:
        points: (N, 3) mm in M, shuffled.
        measure_from_work: Truth.
        start: measure_from_work, off by the asked amounts.
        crb: (6, 6) bound of the pose error about the M point `about`, from all true points on planes and cylinders.
        about: (3,) mm.
        ends: (3, 3) root, mid and tip in W.
        true_share: Share of the points that lie on the blade.
    """

    points: Array
    measure_from_work: Array
    start: Array
    crb: Array
    about: Array
    ends: Array
    true_share: float

    def bound_mm(self) -> Array:
        """(3,) Cramér–Rao bound of the position at root, mid and tip: root of the trace."""
        out = []
        for point in self.ends:
            arm = self.measure_from_work[:3, :3] @ point + self.measure_from_work[:3, 3] - self.about
            rows = np.hstack([-_cross(arm), np.eye(3)])
            out.append(np.sqrt(np.trace(rows @ self.crb @ rows.T)))
        return np.array(out)

    def error_mm(self, estimate: Array) -> Array:
        """(3,) position error at root, mid and tip."""
        homogeneous = np.column_stack([self.ends, np.ones(3)])
        return np.asarray(np.linalg.norm((homogeneous @ (estimate - self.measure_from_work).T)[:, :3], axis=1))


def _cross(a: Array) -> Array:
    return np.array([[0, -a[2], a[1]], [a[2], 0, -a[0]], [-a[1], a[0], 0.0]])


def write_blade(rng: np.random.Generator, path: Path) -> None:
    """A random blade as STEP: root with grooves and a drilled hole, platform, twisted airfoil, shroud or bare tip."""
    from OCP.BRepAlgoAPI import BRepAlgoAPI_Cut, BRepAlgoAPI_Fuse
    from OCP.STEPControl import STEPControl_StepModelType, STEPControl_Writer

    quiet_kernel()
    length = rng.uniform(120.0, 300.0)
    root = (rng.uniform(40, 70), rng.uniform(24, 36), rng.uniform(25, 45))
    plate = (root[0] + rng.uniform(4, 20), root[1] + rng.uniform(6, 16), rng.uniform(7, 12))
    shape = _box(root, (0.0, 0.0, -plate[2] - root[2]))
    for side in (-1, 1):
        groove = _box((root[0] * 2, rng.uniform(8, 14), rng.uniform(6, 12)), (0, 0, -rng.uniform(3, 5)),
                      tilt=(rng.uniform(-35, 35), 0, 0))
        groove = _moved(groove, (0.0, side * root[1] / 2, -plate[2] - root[2] * rng.uniform(0.4, 0.6)))
        shape = BRepAlgoAPI_Cut(shape, groove).Shape()
    shape = BRepAlgoAPI_Fuse(shape, _box(plate, (0, 0, -plate[2]), skew_deg=rng.uniform(-15, 15))).Shape()
    shape = BRepAlgoAPI_Fuse(shape, _airfoil(rng, length, root[0] * 0.8)).Shape()
    if rng.random() < 0.8:
        shroud = (rng.uniform(35, 60), rng.uniform(24, 40), rng.uniform(8, 13))
        shape = BRepAlgoAPI_Fuse(shape, _box(shroud, (0, 0, length - 1.0), skew_deg=rng.uniform(-25, 25),
                                             tilt=(rng.uniform(-8, 8), rng.uniform(-8, 8), 0))).Shape()
        shape = BRepAlgoAPI_Fuse(shape, _cylinder(rng.uniform(5, 9), rng.uniform(6, 12),
                                                  (rng.uniform(-6, 6), rng.uniform(-4, 4), length + 6), (0, 0,
                                                  1))).Shape()
    shape = BRepAlgoAPI_Cut(shape, _cylinder(rng.uniform(3, 6), 100.0, (rng.uniform(-12, 12), -50.0,
                                             -plate[2] - root[2] * 0.8), (0, 1, 0))).Shape()
    if rng.random() < 0.5:
        # A pad flush with the platform's end: the fused face stays split.
        shape = BRepAlgoAPI_Fuse(shape, _moved(_box((plate[0] / 3, 10.0, plate[2]), (0, 0, 0)),
                                               (0.0, plate[1] / 2, -plate[2]))).Shape()
    writer = STEPControl_Writer()
    writer.Transfer(shape, STEPControl_StepModelType.STEPControl_AsIs)
    writer.Write(str(path))


def _box(size: tuple[float, float, float], foot: tuple[float, float, float], *, skew_deg: float = 0.0,
         tilt: tuple[float, float, float] = (0.0, 0.0, 0.0)) -> Any:
    """Prism over a parallelogram centred on `foot`, height upward."""
    from OCP.BRepBuilderAPI import BRepBuilderAPI_MakeFace, BRepBuilderAPI_MakePolygon
    from OCP.BRepPrimAPI import BRepPrimAPI_MakePrism
    from OCP.gp import gp_Pnt, gp_Vec

    turn = Rotation.from_euler("xyz", tilt, degrees=True).as_matrix()
    shift = np.tan(np.radians(skew_deg)) * size[1] / 2
    polygon = BRepBuilderAPI_MakePolygon()
    for x, y in ((-1, -1), (1, -1), (1, 1), (-1, 1)):
        corner = turn @ [x * size[0] / 2 + y * shift, y * size[1] / 2, 0.0] + foot
        polygon.Add(gp_Pnt(*map(float, corner)))
    polygon.Close()
    up = turn @ [0.0, 0.0, size[2]]
    return BRepPrimAPI_MakePrism(BRepBuilderAPI_MakeFace(polygon.Wire(), True).Face(), gp_Vec(*map(float, up))).Shape()


def _cylinder(radius: float, height: float, foot: tuple[float, float, float], axis: tuple[float, float, float]) -> Any:
    from OCP.BRepPrimAPI import BRepPrimAPI_MakeCylinder
    from OCP.gp import gp_Ax2, gp_Dir, gp_Pnt

    place = gp_Ax2(gp_Pnt(*map(float, foot)), gp_Dir(*map(float, axis)))
    return BRepPrimAPI_MakeCylinder(place, radius, height).Shape()


def _moved(shape: Any, by: tuple[float, float, float]) -> Any:
    from OCP.BRepBuilderAPI import BRepBuilderAPI_Transform
    from OCP.gp import gp_Trsf, gp_Vec

    move = gp_Trsf()
    move.SetTranslation(gp_Vec(*map(float, by)))
    return BRepBuilderAPI_Transform(shape, move, True).Shape()


def _airfoil(rng: np.random.Generator, length: float, chord: float) -> Any:
    """Twisted loft through cambered lens-shaped sections."""
    from OCP.BRepBuilderAPI import BRepBuilderAPI_MakeEdge, BRepBuilderAPI_MakeWire
    from OCP.BRepLib import BRepLib
    from OCP.BRepOffsetAPI import BRepOffsetAPI_ThruSections
    from OCP.collections import Array1_gp_Pnt
    from OCP.GeomAPI import GeomAPI_PointsToBSpline
    from OCP.gp import gp_Pnt
    from OCP.TopoDS import TopoDS

    twist, camber = np.radians(rng.uniform(15, 45)), rng.uniform(0.06, 0.14)
    loft = BRepOffsetAPI_ThruSections(True, False)
    for height in np.linspace(0.0, 1.0, 5):
        x = np.linspace(-0.5, 0.5, 15) * chord * (1.0 - 0.2 * height)
        arc = camber * chord * (1.0 - (2 * x / chord) ** 2)
        half = 0.06 * chord * (1.0 - (2 * x / (chord * 1.1)) ** 2)
        c, s = np.cos(twist * height), np.sin(twist * height)
        curves = []
        for sign in (1, -1):
            y = arc + sign * half - camber * chord * 0.6
            array = Array1_gp_Pnt(1, len(x))
            for i, (px, py) in enumerate(zip(x, y, strict=True), start=1):
                array.SetValue(i, gp_Pnt(float(c * px - s * py), float(s * px + c * py), float(height * length - 0.5)))
            curves.append(GeomAPI_PointsToBSpline(array).Curve())
        upper, lower = curves
        wire = BRepBuilderAPI_MakeWire(
            BRepBuilderAPI_MakeEdge(upper).Edge(),
            BRepBuilderAPI_MakeEdge(upper.Value(upper.LastParameter()), lower.Value(lower.LastParameter())).Edge(),
            BRepBuilderAPI_MakeEdge(lower).Edge(),
            BRepBuilderAPI_MakeEdge(lower.Value(lower.FirstParameter()), upper.Value(upper.FirstParameter())).Edge())
        loft.AddWire(wire.Wire())
    solid = TopoDS.Solid(loft.Shape())
    BRepLib.OrientClosedSolid_s(solid)
    return solid


@dataclass(frozen=True)
class Sampler:
    """Triangles of a STEP file with what is needed to draw exact points from them.

    Attributes:
        corners: (T, 3, 3) mm.
        normals: (T, 3) outward.
        face: (T,) number of the face, from 1.
        kinds: Of each face: `plane`, `cylinder`, `other`.
        cylinders: Of each cylinder face: point, axis, radius.
        edges: (E, 3) points on the edges.
    """

    corners: Array
    normals: Array
    face: NDArray[np.int64]
    kinds: dict[int, str]
    cylinders: dict[int, tuple[Array, Array, float]]
    edges: Array

    def draw(self, rng: np.random.Generator, count: int, views: Array,
             faces: tuple[int, ...] | None = None) -> tuple[Array, Array, NDArray[np.int64]]:
        """Points, outward normals and face numbers of points that one of the views (V, 3) sees, even over the area."""
        sides = self.corners[:, 1:] - self.corners[:, :1]
        area = np.linalg.norm(np.cross(sides[:, 0], sides[:, 1]), axis=1)
        seen = (self.normals @ views.T).max(axis=1) > 0.25
        if faces is not None:
            seen &= np.isin(self.face, faces)
        chance = area * seen
        triangle = rng.choice(len(area), count, p=chance / chance.sum())
        a, b = rng.random(count), rng.random(count)
        flip = a + b > 1
        a[flip], b[flip] = 1 - a[flip], 1 - b[flip]
        points = self.corners[triangle, 0] + a[:, None] * sides[triangle, 0] + b[:, None] * sides[triangle, 1]
        normals, face = self.normals[triangle].copy(), self.face[triangle]
        for number, (origin, axis, radius) in self.cylinders.items():
            at = face == number
            offset = points[at] - origin
            height = offset @ axis
            radial = offset - height[:, None] * axis
            radial /= np.linalg.norm(radial, axis=1, keepdims=True)
            side = np.sign((radial * normals[at]).sum(axis=1))[:, None]
            points[at], normals[at] = origin + height[:, None] * axis + radius * radial, side * radial
        return points, normals, face


def read_sampler(path: Path) -> Sampler:
    """Read a STEP file with the kernel alone and triangulate it finely."""
    from OCP.BRep import BRep_Tool
    from OCP.BRepAdaptor import BRepAdaptor_Curve, BRepAdaptor_Surface
    from OCP.BRepMesh import BRepMesh_IncrementalMesh
    from OCP.GeomAbs import GeomAbs_SurfaceType as Kind
    from OCP.STEPControl import STEPControl_Reader
    from OCP.TopAbs import TopAbs_Orientation, TopAbs_ShapeEnum
    from OCP.TopExp import TopExp_Explorer
    from OCP.TopLoc import TopLoc_Location
    from OCP.TopoDS import TopoDS

    reader = STEPControl_Reader()
    reader.ReadFile(str(path))
    reader.TransferRoots()
    shape = reader.OneShape()
    BRepMesh_IncrementalMesh(shape, 0.01, False, 0.15, False)
    corners, faces, kinds, cylinders, edges = [], [], {}, {}, []
    explorer, number = TopExp_Explorer(shape, TopAbs_ShapeEnum.TopAbs_FACE), 0
    while explorer.More():
        number += 1
        face = TopoDS.Face(explorer.Current())
        explorer.Next()
        surface = BRepAdaptor_Surface(face)
        kinds[number] = {Kind.GeomAbs_Plane: "plane", Kind.GeomAbs_Cylinder: "cylinder"}.get(surface.GetType(), "other")
        if kinds[number] == "cylinder":
            position = surface.Cylinder().Position()
            place, axis = position.Location(), position.Direction()
            cylinders[number] = (np.array([place.X(), place.Y(), place.Z()]), np.array([axis.X(), axis.Y(), axis.Z()]),
                                 surface.Cylinder().Radius())
        mesh = BRep_Tool.Triangulation_s(face, TopLoc_Location())
        nodes = np.array([[(p := mesh.Node(i)).X(), p.Y(), p.Z()] for i in range(1, mesh.NbNodes() + 1)])
        triangles = np.array([mesh.Triangle(i).Get() for i in range(1, mesh.NbTriangles() + 1)]) - 1
        if face.Orientation() == TopAbs_Orientation.TopAbs_REVERSED:
            triangles = triangles[:, ::-1]
        corners.append(nodes[triangles])
        faces.append(np.full(len(triangles), number))
    edge_explorer = TopExp_Explorer(shape, TopAbs_ShapeEnum.TopAbs_EDGE)
    while edge_explorer.More():
        edge = TopoDS.Edge(edge_explorer.Current())
        edge_explorer.Next()
        if BRep_Tool.Degenerated_s(edge):
            continue
        curve = BRepAdaptor_Curve(edge)
        for u in np.linspace(curve.FirstParameter(), curve.LastParameter(), 60):
            p = curve.Value(float(u))
            edges.append([p.X(), p.Y(), p.Z()])
    all_corners = np.concatenate(corners)
    cross = np.cross(all_corners[:, 1] - all_corners[:, 0], all_corners[:, 2] - all_corners[:, 0])
    length = np.linalg.norm(cross, axis=1, keepdims=True)
    real = length[:, 0] > 1e-12
    return Sampler(all_corners[real], (cross / np.maximum(length, 1e-12))[real], np.concatenate(faces)[real], kinds,
                   cylinders, np.array(edges))


def simulate(sampler: Sampler, rng: np.random.Generator, count: int, *, outliers: float = 0.3, views: int = 2,
             faces: tuple[int, ...] | None = None, turn_deg: float = 2.5, shift_mm: float = 3.0,
             clutter: bool = False, all_round: bool = False) -> Scene:
    """A scan with fixture, ghosts and clutter and a start that is off.

    Args:
        sampler: Of the blade.
        rng: Source of randomness.
        count: All points.
        outliers: Share of points that don't lie on the blade.
        views: Number of directions from which the scanner looks.
        faces: Only these faces are seen.
        turn_deg: Rotation error of the start about the middle of the blade.
        shift_mm: Translation error of the start.
        clutter: A block of clutter on the blade.
        all_round: The scanner sees the blade from six sides.
    """
    low, high = sampler.corners.min(axis=(0, 1)), sampler.corners.max(axis=(0, 1))
    directions = rng.normal(size=(1, 3)) * [1, 1, 0.4]
    others = [directions * -0.4 + rng.normal(size=3) * [1, 1, 0.5] for _ in range(views - 1)]
    directions = np.vstack([directions, *others])
    directions /= np.linalg.norm(directions, axis=1, keepdims=True)
    if all_round:
        directions = np.vstack([np.eye(3), -np.eye(3)])
    true = int(count * (1.0 - outliers))
    points, normals, face = sampler.draw(rng, true, directions, faces)
    strangers = _strangers(sampler, rng, count - true, directions, points, normals, low, high, clutter)
    used = np.isin(face, [n for n, kind in sampler.kinds.items() if kind != "other"])
    pose = np.eye(4)
    pose[:3, :3] = Rotation.random(random_state=rng).as_matrix()
    pose[:3, 3] = rng.uniform([-200, -200, 300], [200, 200, 700])
    in_measure = points @ pose[:3, :3].T + pose[:3, 3]
    about = in_measure[used].mean(axis=0)
    n = normals[used] @ pose[:3, :3].T
    rows = np.hstack([np.cross(in_measure[used] - about, n), n])
    crb = SIGMA_MM**2 * np.linalg.inv(rows.T @ rows)
    everything = np.vstack([points + rng.normal(0, SIGMA_MM, points.shape), strangers])
    everything = everything[rng.permutation(len(everything))] @ pose[:3, :3].T + pose[:3, 3]
    middle = 0.5 * (low + high)
    axis, way = rng.normal(size=3), rng.normal(size=3)
    turn = Rotation.from_rotvec(np.radians(turn_deg) * axis / np.linalg.norm(axis)).as_matrix()
    off = np.eye(4)
    off[:3, :3] = turn
    off[:3, 3] = middle - turn @ middle + shift_mm * way / np.linalg.norm(way)
    ends = np.array([[middle[0], middle[1], z] for z in (low[2], middle[2], high[2])])
    return Scene(everything, pose, pose @ off, crb, about, ends, true / count)


def _strangers(sampler: Sampler, rng: np.random.Generator, count: int, views: Array, points: Array, normals: Array,
               low: Array, high: Array, clutter: bool) -> Array:
    """Fixture planes and blocks, edge ghosts behind the edges, ghosts off the faces, and stray points."""
    shares = rng.multinomial(count, [0.5, 0.2, 0.1, 0.1, 0.1] if clutter else [0.6, 0.25, 0.1, 0.05, 0.0])
    table, corner = shares[0] // 2, rng.uniform(low - 15, low - 4)
    first = rng.uniform(low - 60, high + 60, (table, 3))
    first[:, 2] = low[2] - rng.uniform(0.5, 12.0)
    wall = shares[0] - table
    second = np.column_stack([np.full(wall, corner[0]), rng.uniform(low[1] - 30, high[1] + 30, wall),
                              rng.uniform(low[2] - 40, low[2] + 60, wall)])
    first += rng.normal(0, SIGMA_MM, first.shape)
    second += rng.normal(0, SIGMA_MM, second.shape)
    edge = sampler.edges[rng.choice(len(sampler.edges), shares[1])]
    behind = -views[rng.integers(len(views), size=len(edge))]
    edge = edge + behind * rng.exponential(0.7, len(edge))[:, None] + rng.normal(0, 0.25, edge.shape)
    at = rng.choice(len(points), shares[2])
    lifted = points[at] - normals[at] * rng.uniform(0.0, 1.5, len(at))[:, None] + rng.normal(0, SIGMA_MM, (len(at), 3))
    stray = rng.uniform(low - 30, high + 30, (shares[3], 3))
    middle = points[rng.choice(len(points))]
    block = middle + rng.uniform(-6, 6, (shares[4], 3))
    return np.vstack([first, second, edge, lifted, stray, block])
