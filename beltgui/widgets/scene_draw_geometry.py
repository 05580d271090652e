"""What the graphics library is given for each item of a scene: points, cells and colours as plain arrays."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from beltgui.viewmodel import scene
from beltgui.viewmodel.scene import Role
from beltgui.widgets.scene_draw_colours import Bytes, colours_of, rgb_of

# An edge sharper than this stays an edge.
CREASE = np.cos(np.deg2rad(35.0))
# Above this, corners are not given normals of their own: the memory would be threefold.
MOST_SMOOTH = 150_000
SHAFT, HEAD_RADIUS, HEAD_LENGTH, SIDES = 0.018, 0.055, 0.2, 10


@dataclass(frozen=True, eq=False)
class Geometry:
    """One drawable thing.

    Attributes:
        points: (N, 3) float32, mm.
        kind: `points`, `lines` or `triangles`.
        cells: Numbers of points, cell after cell.
        offsets: Where each cell begins in `cells`, and the end.
        normals: (N, 3) for smooth shading.
        colour: `#rrggbb` of all of it, unless there are colours of points or cells.
        point_colours: (N, 3).
        cell_colours: (M, 3).
        opacity: 0 to 1.
        size_px: Of points or lines.
        wireframe: Only edges of triangles.
        lit: Shaded by light.
    """

    points: NDArray[np.float32]
    kind: str
    cells: NDArray[np.int64]
    offsets: NDArray[np.int64]
    normals: NDArray[np.float32] | None = None
    colour: str = "#808080"
    point_colours: Bytes | None = None
    cell_colours: Bytes | None = None
    opacity: float = 1.0
    size_px: float = 1.0
    wireframe: bool = False
    lit: bool = False


def geometry_of(item: scene.Item, palette: Mapping[str, str], hover_face: int | None = None) -> Geometry | None:
    """The geometry of an item; None for what is only written (labels) or empty.

    Args:
        item: Of the scene.
        palette: `#rrggbb` of each role.
        hover_face: The face under the pointer, drawn lighter.
    """
    if isinstance(item, scene.Points):
        return _points(item, palette)
    if isinstance(item, scene.Mesh):
        return _mesh(item, palette, hover_face)
    if isinstance(item, scene.Lines):
        return _lines(item, palette)
    if isinstance(item, scene.Arrow):
        return _arrows([(np.asarray(item.start, float), np.asarray(item.vector, float), palette[item.role])])
    if isinstance(item, scene.Frame):
        pose = np.asarray(item.scene_from_frame, dtype=float)
        return _arrows([
            (pose[:3, 3], item.length_mm * pose[:3, axis], palette[role])
            for axis, role in enumerate((Role.X, Role.Y, Role.Z))
        ])
    return None


def _points(item: scene.Points, palette: Mapping[str, str]) -> Geometry | None:
    xyz = np.ascontiguousarray(item.xyz, dtype=np.float32).reshape(-1, 3)
    good = np.isfinite(xyz).all(axis=1)
    values = item.values
    if not good.all():
        xyz, values = xyz[good], None if values is None else np.asarray(values)[good]
    if not len(xyz):
        return None
    coloured = values is not None and item.scale is not None
    return Geometry(
        xyz,
        "points",
        np.arange(len(xyz), dtype=np.int64),
        np.arange(len(xyz) + 1, dtype=np.int64),
        colour=palette[item.role],
        point_colours=colours_of(values, item.scale, palette[Role.MUTED]) if coloured else None,
        size_px=item.size_px,
    )


def _lines(item: scene.Lines, palette: Mapping[str, str]) -> Geometry | None:
    lines = [np.asarray(line, dtype=np.float32).reshape(-1, 3) for line in item.polylines]
    lines = [line[np.isfinite(line).all(axis=1)] for line in lines]
    lines = [line for line in lines if len(line) > 1]
    if not lines:
        return None
    points = np.concatenate(lines)
    offsets = np.concatenate([[0], np.cumsum([len(line) for line in lines])]).astype(np.int64)
    return Geometry(
        points,
        "lines",
        np.arange(len(points), dtype=np.int64),
        offsets,
        colour=palette[item.role],
        size_px=item.width_px,
    )


def _mesh(item: scene.Mesh, palette: Mapping[str, str], hover_face: int | None) -> Geometry | None:
    triangles = np.asarray(item.triangles, dtype=np.int64).reshape(-1, 3)
    if not len(triangles):
        return None
    vertices = np.asarray(item.vertices, dtype=np.float32).reshape(-1, 3)
    coloured = item.values is not None and item.scale is not None
    of_vertices = colours_of(item.values, item.scale, palette[Role.MUTED]) if coloured else None
    of_cells = None
    if item.face_id is not None and (item.chosen_faces or hover_face is not None):
        if of_vertices is None:
            of_cells = np.tile(np.array(rgb_of(palette[item.role]), dtype=np.uint8), (len(triangles), 1))
        else:
            of_cells = of_vertices[triangles].mean(axis=1).round().astype(np.uint8)
        face_id = np.asarray(item.face_id)
        of_cells[np.isin(face_id, item.chosen_faces)] = rgb_of(palette[Role.CHOSEN])
        if hover_face is not None:
            under = face_id == hover_face
            light = np.array(rgb_of(palette[Role.SUGGESTION]))
            of_cells[under] = (0.6 * of_cells[under] + 0.4 * light).astype(np.uint8)
    smooth = not item.wireframe and len(triangles) <= MOST_SMOOTH
    points, normals, cells = vertices, None, triangles
    if smooth:
        points, normals = vertices[triangles].reshape(-1, 3), corner_normals(vertices, triangles)
        cells = np.arange(points.shape[0], dtype=np.int64).reshape(-1, 3)
        if of_vertices is not None:
            of_vertices = of_vertices[triangles].reshape(-1, 3)
    return Geometry(
        np.ascontiguousarray(points),
        "triangles",
        np.ascontiguousarray(cells.ravel()),
        np.arange(0, 3 * len(triangles) + 1, 3, dtype=np.int64),
        normals,
        colour=palette[item.role],
        point_colours=of_vertices if of_cells is None else None,
        cell_colours=of_cells,
        opacity=item.opacity,
        wireframe=item.wireframe,
        lit=not item.wireframe,
    )


def corner_normals(vertices: NDArray[np.float32], triangles: NDArray[np.int64]) -> NDArray[np.float32]:
    """(3 M, 3) unit normals of the triangles' corners: smooth, except across edges sharper than `CREASE`."""
    corners = vertices[triangles].astype(np.float64)
    flat = np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
    summed = np.stack(
        [np.bincount(triangles.ravel(), np.repeat(flat[:, axis], 3), len(vertices)) for axis in range(3)], axis=1
    )
    flat, summed = _unit(flat), _unit(summed)
    smooth = summed[triangles]
    sharp = np.einsum("mkd,md->mk", smooth, flat) < CREASE
    smooth[sharp] = np.broadcast_to(flat[:, None, :], smooth.shape)[sharp]
    return np.ascontiguousarray(smooth.reshape(-1, 3), dtype=np.float32)


def _unit(vectors: NDArray[np.float64]) -> NDArray[np.float64]:
    length = np.linalg.norm(vectors, axis=-1, keepdims=True)
    return vectors / np.where(length > 0.0, length, 1.0)


def _arrows(arrows: list[tuple[NDArray[np.float64], NDArray[np.float64], str]]) -> Geometry | None:
    points, cells, colours = [], [], []
    count = 0
    for start, vector, colour in arrows:
        length = float(np.linalg.norm(vector))
        if not length > 0.0:
            continue
        vertices, triangles = _arrow(start, vector / length, length)
        points.append(vertices)
        cells.append(triangles + count)
        colours.append(np.tile(np.array(rgb_of(colour), dtype=np.uint8), (len(triangles), 1)))
        count += len(vertices)
    if not points:
        return None
    triangles = np.concatenate(cells)
    return Geometry(
        np.concatenate(points).astype(np.float32),
        "triangles",
        triangles.ravel(),
        np.arange(0, 3 * len(triangles) + 1, 3, dtype=np.int64),
        cell_colours=np.concatenate(colours),
        lit=True,
    )


def _arrow(
    start: NDArray[np.float64], along: NDArray[np.float64], length: float
) -> tuple[NDArray[np.float64], NDArray[np.int64]]:
    """A shaft and a head as rings of points, joined by triangles."""
    aside = np.cross(along, np.eye(3)[np.argmin(np.abs(along))])
    aside /= np.linalg.norm(aside)
    angle = np.linspace(0.0, 2.0 * np.pi, SIDES, endpoint=False)[:, None]
    ring = np.cos(angle) * aside + np.sin(angle) * np.cross(along, aside)
    neck = 1.0 - HEAD_LENGTH
    profile = ((0.0, 0.0), (0.0, SHAFT), (neck, SHAFT), (neck, HEAD_RADIUS), (1.0, 0.0))
    points = np.concatenate([start + length * (at * along + radius * ring) for at, radius in profile])
    here = np.arange(SIDES)
    there = (here + 1) % SIDES
    triangles = [
        np.concatenate([np.stack([a + here, a + there, b + there], 1), np.stack([a + here, b + there, b + here], 1)])
        for a, b in ((k * SIDES, (k + 1) * SIDES) for k in range(len(profile) - 1))
    ]
    return points, np.concatenate(triangles).astype(np.int64)
