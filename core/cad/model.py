"""What a STEP file contains, as plain data: faces with surface, side of the material and trim; mm, frame W."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from pathlib import Path
from typing import TYPE_CHECKING, Any, Literal

import numpy as np
from numpy.typing import NDArray

from core.cad.surfaces import Array, Surface
from core.errors import InputError

if TYPE_CHECKING:
    from shapely import MultiPolygon, Polygon

    from core.cad.spline_surface import SplineSurface

FaceType = Literal["plane", "cylinder", "cone", "sphere", "torus", "bspline", "other"]
Parameter = float | int | str | tuple[float, ...]


@dataclass(frozen=True, eq=False)
class CadFace:
    """One face of the model.

    Attributes:
        id: Place in the file's own order of faces, from 1.
        name: Name of the STEP entity, None where it has none.
        type: Kind of surface; a free-form face that is a plane or cylinder within 0.001 mm counts as one, and
            `parameters["stored_as"]` says how the file has it.
        area_mm2: True area within the trim.
        parameters: Numbers that describe the surface, unit in the key (`radius_mm`, `half_angle_rad`).
        surface: The analytic surface; None for other kinds than plane and cylinder.
        trim: Region of the face in the surface's (s, t) in mm, outer loop and holes; None without surface.
        usable: True where registration can measure on the face.
        why_not: A sentence that says why the face is not usable; None where it is.
    """

    id: int
    name: str | None
    type: FaceType
    area_mm2: float
    parameters: Mapping[str, Parameter]
    surface: Surface | None
    trim: Polygon | MultiPolygon | None
    usable: bool
    why_not: str | None

    @property
    def label(self) -> str:
        """The name where there is one, else `face <id>`; for messages."""
        return self.name or f"face {self.id}"


@dataclass(frozen=True, eq=False)
class Mesh:
    """Triangles of a model.

    Attributes:
        vertices: (V, 3) mm.
        triangles: (T, 3) indices, counter-clockwise seen from outside the material.
        face_ids: (T,) id of the CadFace that each triangle belongs to.
    """

    vertices: Array
    triangles: NDArray[np.int64]
    face_ids: NDArray[np.int64]


@dataclass(frozen=True, eq=False)
class CadModel:
    """A STEP model in mm; picklable (the kernel's own shape is read again from `path` when it is needed).

    Attributes:
        faces: All faces, `faces[i].id == i + 1`.
        path: File that it was read from.
        sha256: Hash of that file.
        bounds_mm: (2, 3) lower and upper corner of the model's box.
        solid: True where all faces bound closed solids, so that "outward" is certain; False for loose surfaces, whose
            outward side is the one that the file says.
        lost_faces: Face entities of the file that the kernel made no face of (degenerate ones); worth a warning.
    """

    faces: tuple[CadFace, ...]
    path: Path
    sha256: str
    bounds_mm: Array
    solid: bool
    lost_faces: int = 0
    _shape: Any = field(default=None, repr=False)

    def face(self, id_or_name: int | str) -> CadFace:
        """The face with this id or name; digits in a string count as an id where no face has that name.

        Raises:
            InputError: there is none, or several carry the name.
        """
        found = [face for face in self.faces if face.name is not None and face.name == id_or_name]
        if not found and str(id_or_name).isdigit():
            found = [face for face in self.faces if face.id == int(id_or_name)]
        if len(found) == 1:
            return found[0]
        if found:
            ids = ", ".join(str(face.id) for face in found)
            raise InputError(f"{self.path.name}: {len(found)} faces are named {id_or_name!r} (ids {ids}). "
                             "Choose one by its id.")
        names = ", ".join(face.name for face in self.faces if face.name) or "none has a name"
        raise InputError(f"{self.path.name}: no face {id_or_name!r}. The model has faces 1 to {len(self.faces)}; "
                         f"names: {names}.")

    def select(self, ids_or_names: Sequence[int | str]) -> tuple[CadFace, ...]:
        """Several faces in the order asked for.

        Raises:
            InputError: one is unknown or asked for twice.
        """
        chosen = tuple(self.face(item) for item in ids_or_names)
        seen: set[int] = set()
        for face in chosen:
            if face.id in seen:
                raise InputError(f"{self.path.name}: {face.label} is named twice in the list of faces.")
            seen.add(face.id)
        return chosen

    def tessellate(self, deflection_mm: float = 0.05, angular_rad: float = 0.2) -> Mesh:
        """Triangles whose distance from the true surface stays below `deflection_mm`.

        Args:
            deflection_mm: Largest distance of a chord from the surface.
            angular_rad: Largest angle between neighbouring normals.

        Raises:
            InputError: a tolerance is not positive, or the file has gone or changed since it was read.
        """
        from core.cad.mesh import tessellate

        return tessellate(self, deflection_mm, angular_rad)

    def spline_surface(self, id_or_name: int | str) -> SplineSurface:
        """The B-spline of a face of type `bspline`, its normal outward.

        Raises:
            InputError: no such face, or it is not a B-spline.
        """
        from core.cad.spline_surface import spline_surface_of

        return spline_surface_of(self, self.face(id_or_name))

    def __getstate__(self) -> dict[str, Any]:
        """Everything but the kernel's shape, which can't be pickled."""
        return {**self.__dict__, "_shape": None}
