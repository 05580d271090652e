"""Triangles of a CAD model, for display and for the simulated scanner."""

from __future__ import annotations

import hashlib
from typing import TYPE_CHECKING, Any

import numpy as np

from core.cad.kernel import faces_of, is_reversed, outward_flip
from core.errors import InputError

if TYPE_CHECKING:
    from core.cad.model import CadModel, Mesh


def kernel_shape(model: CadModel) -> Any:
    """The kernel's shape behind a model; read again where the model came out of a pickle.

    Raises:
        InputError: the file has gone, or is not the one that the model was read from.
    """
    if model._shape is not None:
        return model._shape
    from core.cad.step_file import load_shape

    try:
        content = model.path.read_bytes()
    except OSError as error:
        raise InputError(f"{model.path}: the STEP file can't be opened again ({error.strerror}).") from error
    if hashlib.sha256(content).hexdigest() != model.sha256:
        raise InputError(f"{model.path}: the STEP file was changed after it was read. Read it anew.")
    return load_shape(model.path)[0]


def tessellate(model: CadModel, deflection_mm: float, angular_rad: float) -> Mesh:
    """See `CadModel.tessellate`."""
    from OCP.BRep import BRep_Tool
    from OCP.BRepMesh import BRepMesh_IncrementalMesh
    from OCP.BRepTools import BRepTools
    from OCP.TopLoc import TopLoc_Location

    from core.cad.model import Mesh

    if not (deflection_mm > 0.0 and angular_rad > 0.0):
        raise InputError(f"tessellation of {model.path.name}: deflection ({deflection_mm} mm) and angle "
                         f"({angular_rad} rad) must be greater than zero.")
    shape = kernel_shape(model)
    # Triangles of an earlier call would be kept where they are finer.
    BRepTools.Clean_s(shape)
    BRepMesh_IncrementalMesh(shape, deflection_mm, False, angular_rad, False)
    flip = outward_flip(shape)
    vertices, triangles, ids, count = [], [], [], 0
    for number, face in enumerate(faces_of(shape), start=1):
        location = TopLoc_Location()
        mesh = BRep_Tool.Triangulation_s(face, location)
        if mesh is None:
            continue
        move = location.Transformation()
        nodes = [mesh.Node(i).Transformed(move) for i in range(1, mesh.NbNodes() + 1)]
        corners = np.array([mesh.Triangle(i).Get() for i in range(1, mesh.NbTriangles() + 1)], dtype=np.int64) - 1
        if is_reversed(face) != (flip < 0):
            corners = corners[:, ::-1]
        vertices.append(np.array([(node.X(), node.Y(), node.Z()) for node in nodes]))
        triangles.append(corners + count)
        ids.append(np.full(len(corners), number))
        count += len(nodes)
    return Mesh(np.vstack(vertices), np.vstack(triangles), np.concatenate(ids))
