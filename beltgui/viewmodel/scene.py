"""A 3D picture as data: what to draw, in which frame, by role; the screen's theme turns roles into colours."""

from __future__ import annotations

from dataclasses import dataclass
from enum import StrEnum

import numpy as np
from numpy.typing import NDArray

Floats = NDArray[np.float32]
Array = NDArray[np.float64]


class Role(StrEnum):
    """What something is; never a colour. `face 0` to `face 7` tell neighbouring faces apart."""

    BLADE = "blade"
    SCAN = "scan"
    FIT = "fit"
    INLIER = "inlier"
    OUTLIER = "outlier"
    HELD_OUT = "held out"
    EXCLUDED = "excluded"
    ROBOT = "robot"
    WHEEL = "wheel"
    PATH = "path"
    PATH_COMPENSATED = "compensated path"
    SUGGESTION = "suggestion"
    ATTENTION = "attention"
    CHOSEN = "chosen"
    BOX = "box"
    MUTED = "muted"
    X = "x"
    Y = "y"
    Z = "z"
    FACE_0 = "face 0"
    FACE_1 = "face 1"
    FACE_2 = "face 2"
    FACE_3 = "face 3"
    FACE_4 = "face 4"
    FACE_5 = "face 5"
    FACE_6 = "face 6"
    FACE_7 = "face 7"


@dataclass(frozen=True)
class Scale:
    """How values become colours; `diverging` is symmetric about 0.

    Attributes:
        title: Quantity with its unit, e.g. `signed distance, µm`.
        low: Value at the lower end, in that unit.
        high: Value at the upper end.
        kind: `diverging` or `sequential`.
    """

    title: str
    low: float
    high: float
    kind: str = "diverging"


@dataclass(frozen=True, eq=False)
class Points:
    """A cloud, thinned for display.

    Attributes:
        name: Unique in the scene; drawing the same name again replaces it.
        xyz: (N, 3) float32, mm, in the scene's frame.
        role: Its colour, unless there are values.
        values: (N,) coloured by `scale`.
        scale: For the values.
        size_px: Of a point.
        pickable: A click on a point is reported.
    """

    name: str
    xyz: Floats
    role: Role = Role.SCAN
    values: Floats | None = None
    scale: Scale | None = None
    size_px: float = 2.0
    pickable: bool = False


@dataclass(frozen=True, eq=False)
class Mesh:
    """A triangle mesh.

    Attributes:
        name: Unique in the scene.
        vertices: (N, 3) float32, mm.
        triangles: (M, 3) int32.
        role: Its colour, unless there are values.
        opacity: 0 to 1.
        values: (N,) per vertex, coloured by `scale`; NaN is drawn as `muted`.
        scale: For the values.
        face_id: (M,) which CAD face each triangle is of; a click reports the face.
        chosen_faces: Ids that are drawn as `chosen`.
        pickable: A click is reported.
        wireframe: Draw edges only.
    """

    name: str
    vertices: Floats
    triangles: NDArray[np.int32]
    role: Role = Role.BLADE
    opacity: float = 1.0
    values: Floats | None = None
    scale: Scale | None = None
    face_id: NDArray[np.int32] | None = None
    chosen_faces: tuple[int, ...] = ()
    pickable: bool = False
    wireframe: bool = False


@dataclass(frozen=True, eq=False)
class Lines:
    """Polylines: each (n, 3) float32, mm."""

    name: str
    polylines: tuple[Floats, ...]
    role: Role = Role.PATH
    width_px: float = 2.0


@dataclass(frozen=True, eq=False)
class Arrow:
    """An arrow from `start` (3,) along `vector` (3,), mm, with a label at its tip."""

    name: str
    start: Array
    vector: Array
    role: Role
    label: str = ""


@dataclass(frozen=True, eq=False)
class Frame:
    """A coordinate frame: `scene_from_frame` (4, 4); `name` is its label, e.g. `{M}`."""

    name: str
    scene_from_frame: Array
    length_mm: float = 30.0


@dataclass(frozen=True, eq=False)
class Label:
    """Text at a point (3,), mm."""

    name: str
    at: Array
    text: str
    role: Role = Role.MUTED


Item = Points | Mesh | Lines | Arrow | Frame | Label


@dataclass(frozen=True, eq=False)
class Scene:
    """One picture.

    Attributes:
        title: What is seen, one line.
        frame: Letter of the frame that all coordinates are in: `B`, `F`, `M`, `S`, `W`, `H`.
        items: What to draw.
        view: The camera is set anew when this text changes, and otherwise left where the person put it.
        legend: (role, words) of what needs explaining.
        look_from: From where the first picture is taken: a direction (3,) in the scene's frame, from the middle of what
            is seen towards the eye; None is the standard oblique view.
        up: (3,) what is up in that picture; used with `look_from`.
        fit_to: The first picture takes in the items whose names begin with one of these; empty takes in all.
        beside: More pictures, each in a viewport of its own to the right of this one.
    """

    title: str
    frame: str
    items: tuple[Item, ...]
    view: str = ""
    legend: tuple[tuple[Role, str], ...] = ()
    look_from: tuple[float, float, float] | None = None
    up: tuple[float, float, float] = (0.0, 0.0, 1.0)
    fit_to: tuple[str, ...] = ()
    beside: tuple[Scene, ...] = ()
