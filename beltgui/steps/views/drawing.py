"""Pieces of 3D pictures that all rooms draw alike: thinned clouds, balls, wheels, triads, the scanner's volume."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike, NDArray

from beltgui.viewmodel.scene import Arrow, Floats, Frame, Item, Label, Lines, Mesh, Points, Role, Scene
from core.frames import transform_points
from devices.cell_plan import ScannerPlan

Array = NDArray[np.float64]

FLANGE_RADIUS_MM = 31.5
_AXES = (("x", Role.X), ("y", Role.Y), ("z", Role.Z))


def display(points: ArrayLike) -> Floats:
    """Points (N, 3) as a scene holds them: float32."""
    return np.asarray(points, dtype=np.float32).reshape(-1, 3)


def thin_index(count: int, most: int) -> NDArray[np.int64]:
    """At most `most` of `count` indices, spread evenly and the same at every call."""
    if count <= most:
        return np.arange(count, dtype=np.int64)
    # Even strides would follow a scanner's rows and show as stripes.
    return np.sort(np.random.default_rng(0).choice(count, most, replace=False)).astype(np.int64)


def thinned(points: Array, most: int) -> Floats:
    """At most `most` of the points (N, 3), for display only."""
    return display(points[thin_index(len(points), most)])


def count_points(scene: Scene) -> int:
    """Number of points, vertices and line points in a scene."""
    total = 0
    for item in scene.items:
        if isinstance(item, Points):
            total += len(item.xyz)
        elif isinstance(item, Mesh):
            total += len(item.vertices)
        elif isinstance(item, Lines):
            total += sum(len(line) for line in item.polylines)
    return total


# ---- lines


def circle(center: ArrayLike, normal: ArrayLike, radius_mm: float, count: int = 65) -> Floats:
    """A closed polyline around `center` (3,) at right angles to `normal` (3,)."""
    return arc(center, normal, _across(np.asarray(normal, dtype=float)), radius_mm, 0.0, 2.0 * np.pi, count)


def arc(
    center: ArrayLike, normal: ArrayLike, start: ArrayLike, radius_mm: float, low_rad: float, high_rad: float,
    count: int = 65,
) -> Floats:  # fmt: skip
    """A polyline around `center`, from `low_rad` to `high_rad` right-handed about `normal`; 0 is along `start` (3,)."""
    axis = _unit(np.asarray(normal, dtype=float))
    first = np.asarray(start, dtype=float)
    first = _unit(first - axis * (axis @ first))
    angle = np.linspace(low_rad, high_rad, count)[:, None]
    way = np.cos(angle) * first + np.sin(angle) * np.cross(axis, first)
    return display(np.asarray(center, dtype=float) + radius_mm * way)


def segments(name: str, starts: ArrayLike, ends: ArrayLike, role: Role, width_px: float = 2.0) -> Lines:
    """Straight lines from `starts` (N, 3) to `ends` (N, 3)."""
    pairs = zip(display(starts), display(ends), strict=True)
    return Lines(name, tuple(np.stack(pair) for pair in pairs), role, width_px)


def exaggerated(name: str, at: Array, away: Array, times: float, role: Role, width_px: float = 2.0) -> Lines:
    """Residuals as lines from `at` (N, 3) along `away` (N, 3), `times` as long as they are."""
    return segments(name, at, at + times * away, role, width_px)


def exaggeration(away: Array, wanted_mm: float) -> float:
    """A round factor (1, 2, 5, 10, 20 ...) that makes the largest of the vectors (N, 3) about `wanted_mm` long."""
    lengths = np.linalg.norm(away.reshape(-1, 3), axis=1)
    lengths = lengths[np.isfinite(lengths)]
    largest = float(lengths.max()) if len(lengths) else 0.0
    if not largest > 0.0:
        return 1.0
    raw = wanted_mm / largest
    if raw <= 1.0:
        return 1.0
    decade = 10.0 ** np.floor(np.log10(raw))
    return float(decade * max(step for step in (1.0, 2.0, 5.0) if step * decade <= raw * (1.0 + 1e-12)))


def triads(name: str, scene_from_frames: Sequence[Array], length_mm: float, width_px: float = 2.0) -> tuple[Lines, ...]:
    """Many small frames as three items, one for each axis, without labels."""
    if not len(scene_from_frames):
        return ()
    stack = np.asarray(scene_from_frames, dtype=float)
    origins = stack[:, :3, 3]
    return tuple(
        segments(f"{name} {letter}", origins, origins + length_mm * stack[:, :3, index], role, width_px)
        for index, (letter, role) in enumerate(_AXES)
    )


def box(name: str, scene_from_box: Array, low: ArrayLike, high: ArrayLike, role: Role = Role.BOX) -> Lines:
    """The twelve edges of a box between two corners (3,) in its own frame."""
    corners = np.array(np.meshgrid(*np.transpose([low, high]), indexing="ij"), dtype=float).reshape(3, -1).T
    pairs = [(i, j) for i in range(8) for j in range(i + 1, 8) if (i ^ j).bit_count() == 1]
    placed = transform_points(scene_from_box, corners)
    return segments(name, placed[[i for i, _ in pairs]], placed[[j for _, j in pairs]], role, 1.0)


# ---- bodies


@dataclass(frozen=True, eq=False)
class _Net:
    vertices: Floats
    triangles: NDArray[np.int32]


def sphere(
    name: str, center: ArrayLike, radius_mm: float, role: Role = Role.FIT, opacity: float = 0.4, rings: int = 16
) -> Mesh:
    """A ball of `radius_mm` around `center` (3,)."""
    return spheres(name, np.reshape(np.asarray(center, dtype=float), (1, 3)), radius_mm, role, opacity, rings)


def spheres(
    name: str, centers: ArrayLike, radius_mm: float, role: Role = Role.FIT, opacity: float = 0.4, rings: int = 8
) -> Mesh:
    """Several balls as one mesh around `centers` (N, 3)."""
    net = _unit_sphere(rings)
    places = np.asarray(centers, dtype=float).reshape(-1, 3)
    vertices = (places[:, None, :] + radius_mm * net.vertices[None]).reshape(-1, 3)
    offsets = len(net.vertices) * np.arange(len(places), dtype=np.int32)[:, None, None]
    triangles = (net.triangles[None] + offsets).reshape(-1, 3).astype(np.int32)
    return Mesh(name, display(vertices), triangles, role, opacity)


def _unit_sphere(rings: int) -> _Net:
    around = 2 * rings
    polar = np.pi * np.arange(1, rings) / rings
    turn = 2.0 * np.pi * np.arange(around) / around
    body = np.stack([
        np.outer(np.sin(polar), np.cos(turn)), np.outer(np.sin(polar), np.sin(turn)),
        np.repeat(np.cos(polar)[:, None], around, axis=1),
    ], axis=2).reshape(-1, 3)  # fmt: skip
    vertices = np.vstack([[0.0, 0.0, 1.0], body, [0.0, 0.0, -1.0]])
    last = len(vertices) - 1
    triangles = []
    for k in range(around):
        after = (k + 1) % around
        triangles += [(0, 1 + k, 1 + after), (last, last - around + after, last - around + k)]
        for ring in range(rings - 2):
            a, b = 1 + ring * around + k, 1 + ring * around + after
            triangles += [(a, a + around, b), (b, a + around, b + around)]
    return _Net(display(vertices), np.array(triangles, dtype=np.int32))


def disc(
    name: str, center: ArrayLike, normal: ArrayLike, radius_mm: float, role: Role, opacity: float = 0.3, count: int = 48
) -> Mesh:
    """A flat round plate."""
    rim = circle(center, normal, radius_mm, count + 1)[:-1]
    vertices = np.vstack([display(center), rim])
    index = np.arange(count)
    triangles = np.column_stack([np.zeros(count), 1 + index, 1 + (index + 1) % count]).astype(np.int32)
    return Mesh(name, vertices, triangles, role, opacity)


def cylinder(
    name: str, center: ArrayLike, axis: ArrayLike, radius_mm: float, width_mm: float, role: Role, opacity: float = 0.5,
    count: int = 48,
) -> Mesh:  # fmt: skip
    """The shell of a cylinder, `width_mm` long, its middle at `center` (3,)."""
    way = 0.5 * width_mm * _unit(np.asarray(axis, dtype=float))
    middle = np.asarray(center, dtype=float)
    ends = [circle(middle + sign * way, axis, radius_mm, count + 1)[:-1] for sign in (-1.0, 1.0)]
    index = np.arange(count)
    after = (index + 1) % count
    triangles = np.vstack([
        np.column_stack([index, after, count + index]), np.column_stack([after, count + after, count + index])
    ]).astype(np.int32)  # fmt: skip
    return Mesh(name, np.vstack(ends), triangles, role, opacity)


def funnel(
    name: str, tip: ArrayLike, axis: ArrayLike, radius_mm: float, height_mm: float, role: Role, opacity: float = 0.5,
    count: int = 32,
) -> Mesh:  # fmt: skip
    """The shell of a cone with its `tip` (3,), that opens along `axis` (3,)."""
    rim = circle(np.asarray(tip, dtype=float) + height_mm * _unit(np.asarray(axis, dtype=float)), axis, radius_mm,
                 count + 1)[:-1]  # fmt: skip
    index = np.arange(count)
    triangles = np.column_stack([np.zeros(count), 1 + index, 1 + (index + 1) % count]).astype(np.int32)
    return Mesh(name, np.vstack([display(tip), rim]), triangles, role, opacity)


# ---- things of the cell


def frame(letter: str, scene_from_frame: Array, length_mm: float = 40.0) -> Frame:
    """A coordinate frame with its letter in braces."""
    return Frame(f"{{{letter}}}", scene_from_frame, length_mm)


def flange(name: str, scene_from_flange: Array, role: Role = Role.ROBOT, opacity: float = 0.6) -> Mesh:
    """The robot's flange as a plate of its usual size."""
    return disc(name, scene_from_flange[:3, 3], scene_from_flange[:3, 2], FLANGE_RADIUS_MM, role, opacity)


def robot_base(name: str, scene_from_base: Array) -> Mesh:
    """The robot's foot: a short column on its base frame."""
    up = scene_from_base[:3, 2]
    return cylinder(name, scene_from_base[:3, 3] + 60.0 * up, up, 95.0, 120.0, Role.ROBOT, 0.35)


def scanner_volume(name: str, scene_from_scanner: Array, plan: ScannerPlan, role: Role = Role.BOX) -> Lines:
    """The edges of the scanner's measuring volume."""
    width, height = plan.field_mm
    low = (-0.5 * width, -0.5 * height, plan.near_mm)
    return box(name, scene_from_scanner, low, (0.5 * width, 0.5 * height, plan.far_mm), role)


def arrows(
    name: str, start: ArrayLike, directions: Array, length_mm: float, labels: Sequence[str]
) -> tuple[Arrow, ...]:
    """Three labelled arrows in the roles x, y, z; `directions` (3, 3) unit, one in each column."""
    return tuple(
        Arrow(f"{name} {letter}", np.asarray(start, dtype=float), length_mm * directions[:, index], role, labels[index])
        for index, (letter, role) in enumerate(_AXES)
    )


def label(name: str, at: ArrayLike, text: str, role: Role = Role.MUTED) -> Label:
    """Text at a point (3,)."""
    return Label(name, np.asarray(at, dtype=float), text, role)


def scene(
    title: str, letter: str, items: Iterable[Item | None], *, view: str, legend: Sequence[tuple[Role, str]] = (),
    look_from: ArrayLike | None = None, up: ArrayLike = (0.0, 0.0, 1.0), fit_to: Sequence[str] = (),
    beside: Sequence[Scene] = (),
) -> Scene:  # fmt: skip
    """A scene of those items that are there, and a legend of what is drawn.

    Empty clouds and bundles of lines are left out, and of the legend what explains nothing; the rest as in `Scene`.
    """
    kept = tuple(item for item in items if item is not None and not _empty(item))
    drawn = {role for item in kept for role in _roles(item)}
    return Scene(
        title, letter, kept, view, tuple((role, words) for role, words in legend if role in drawn),
        None if look_from is None else _triple(look_from), _triple(up), tuple(fit_to), tuple(beside),
    )  # fmt: skip


def _roles(item: Item) -> tuple[Role, ...]:
    """By which roles an item is coloured."""
    if isinstance(item, Frame):
        return (Role.X, Role.Y, Role.Z)
    if isinstance(item, Mesh) and item.chosen_faces:
        return (item.role, Role.CHOSEN)
    if isinstance(item, Points | Mesh) and item.values is not None:
        return ()
    return (item.role,)


def _triple(vector: ArrayLike) -> tuple[float, float, float]:
    x, y, z = (float(value) for value in np.asarray(vector, dtype=float))
    return x, y, z


def _empty(item: Item) -> bool:
    if isinstance(item, Points):
        return not len(item.xyz)
    if isinstance(item, Mesh):
        return not len(item.triangles)
    return isinstance(item, Lines) and not item.polylines


def _unit(vector: Array) -> Array:
    return vector / np.linalg.norm(vector)


def _across(direction: Array) -> Array:
    return np.cross(direction, np.eye(3)[int(np.argmin(np.abs(direction)))])
