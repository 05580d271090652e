"""Reads a STEP file into a CadModel; everything comes out in mm whatever the file's unit is."""

from __future__ import annotations

import hashlib
import re
from pathlib import Path
from typing import Any

import numpy as np

from core.cad.face_reader import read_face
from core.cad.kernel import bounding_box, faces_of, is_closed_solid, outward_flip, quiet_kernel
from core.cad.model import CadModel
from core.errors import InputError

MAGIC = b"ISO-10303-21"
END_MARK = b"END-ISO-10303-21"
TEXTS = re.compile(rb"'(?:[^']|'')*'|/\*.*?\*/", re.S)
REFERENCES = re.compile(rb"#(\d+)(\s*=)?")
DATA_SECTION = re.compile(rb"DATA\s*(?:\([^;]*\))?\s*;(.*?)ENDSEC\s*;", re.S)
STATEMENT = re.compile(rb"\s*#\d+\s*=\s*(?:[A-Z!][A-Z0-9_]*\s*)?\([-+A-Z0-9_!#$*.,()\"\s]*\)\s*")
CARRIES_SHAPE = re.compile("Representation|Mapped|Transformation")
FACE_ENTITIES = re.compile(rb"=\s*(?:ADVANCED_FACE|FACE_SURFACE)\s*\(")


def read_step(path: str | Path) -> CadModel:
    """Read the faces of a STEP file (AP203, AP214, AP242).

    Args:
        path: The file.

    Returns:
        The model in mm, faces in the order in which the file's shells list them.

    Raises:
        InputError: the file is missing, empty, cut off, no STEP file, unreadable, or holds no face.
    """
    path = Path(path)
    content = _checked_content(path)
    bare = TEXTS.sub(b"", content)
    _check_statements(path, bare)
    _check_references(path, bare)
    shape, names = load_shape(path)
    kernel_faces = faces_of(shape)
    if not kernel_faces:
        raise InputError(f"{path}: the STEP file holds no solid and no face; expected the solid of a blade. "
                         "Export it as a solid body, not as wireframe or an empty assembly.")
    listed = len(FACE_ENTITIES.findall(bare))
    distinct = len({face.TShape() for face in kernel_faces})
    flip = outward_flip(shape)
    faces = tuple(read_face(face, number, name, flip)
                  for number, (face, name) in enumerate(zip(kernel_faces, names, strict=True), start=1))
    return CadModel(faces=faces, path=path, sha256=hashlib.sha256(content).hexdigest(),
                    bounds_mm=np.array(bounding_box(shape)), solid=is_closed_solid(shape),
                    lost_faces=max(0, listed - distinct), _shape=shape)


def _checked_content(path: Path) -> bytes:
    """Bytes of the file, once it is sure that they are a whole STEP file."""
    try:
        content = path.read_bytes()
    except OSError as error:
        raise InputError(f"{path}: the STEP file can't be opened ({error.strerror}).") from error
    if not content.strip():
        raise InputError(f"{path}: the file is empty; expected a STEP file.")
    start = content[:4096].removeprefix(b"\xef\xbb\xbf").lstrip()
    if not start.startswith(MAGIC):
        found = _description(start)
        raise InputError(f"{path}: not a STEP file; it begins with {found}, expected {MAGIC.decode()}.")
    if END_MARK not in content[-4096:]:
        raise InputError(f"{path}: the STEP file is cut off; its end mark {END_MARK.decode()} is missing after "
                         f"{len(content)} bytes. Copy or export it again.")
    return content


def _check_statements(path: Path, bare: bytes) -> None:
    """Refuse a file with a garbled statement and name the first one."""
    for section in DATA_SECTION.findall(bare):
        for statement in section.split(b";")[:-1]:
            if STATEMENT.fullmatch(statement) is None or statement.count(b"(") != statement.count(b")"):
                found = " ".join(statement.decode("ascii", errors="replace").split())[:40]
                raise InputError(f"{path}: the STEP file is damaged at {found!r}; expected `#number = NAME(..)`. "
                                 "Copy or export it again.")


def _check_references(path: Path, bare: bytes) -> None:
    """Refuse a file in which entities are missing: the kernel would leave out faces without a word."""
    defined: set[bytes] = set()
    used: set[bytes] = set()
    for number, definition in REFERENCES.findall(bare):
        (defined if definition else used).add(number)
    if missing := used - defined:
        first = min(missing, key=int).decode()
        raise InputError(f"{path}: the STEP file is damaged; {len(missing)} entities are referred to but missing, the "
                         f"first is #{first}. Copy or export it again.")


def _description(start: bytes) -> str:
    """Beginning of a file in a form that fits into a sentence."""
    head = start[:24].splitlines()[0]
    if head.isascii() and head.decode("ascii").isprintable():
        return repr(head.decode("ascii"))
    return f"the bytes {start[:8].hex(' ')}"


def load_shape(path: Path) -> tuple[Any, tuple[str | None, ...]]:
    """The kernel's shape of a STEP file in mm, and the name of each of its faces.

    Raises:
        InputError: the kernel can't make a shape of it.
    """
    from OCP.IFSelect import IFSelect_ReturnStatus
    from OCP.Standard import Standard_Failure
    from OCP.STEPControl import STEPControl_Reader

    quiet_kernel()
    reader = STEPControl_Reader()
    reader.SetSystemLengthUnit(1.0)
    try:
        status = reader.ReadFile(str(path))
        if status != IFSelect_ReturnStatus.IFSelect_RetDone:
            raise InputError(f"{path}: the STEP file can't be parsed; its text is damaged. Export it again.")
        _check_entities(path, reader.StepModel())
        if reader.TransferRoots() == 0:
            raise InputError(f"{path}: the STEP file holds no shape that can be read; expected the solid of a blade.")
        shape = reader.OneShape()
    except Standard_Failure as error:
        raise InputError(f"{path}: the STEP file can't be read by the CAD kernel ({error}). "
                         "Export it again.") from error
    return shape, tuple(_face_name(reader, face) for face in faces_of(shape))


def _check_entities(path: Path, model: Any) -> None:
    """Refuse geometry whose fields the kernel couldn't read: it would go on with null pointers and crash.

    Damage in annotations, colours and the like is passed over; the kernel skips those.
    """
    for place in range(1, model.NbEntities() + 1):
        if not model.IsErrorEntity(place):
            continue
        kind = type(model.Entity(place))
        room, name = kind.__module__.rpartition(".")[2], kind.__name__.partition("_")[2]
        if room in ("StepGeom", "StepShape") or (room == "StepRepr" and CARRIES_SHAPE.search(name)):
            raise InputError(f"{path}: the STEP file is damaged; a {name} entity has fields of the wrong kind. "
                             "Copy or export it again.")


def _face_name(reader: Any, face: Any) -> str | None:
    """Name of the STEP entity that a kernel face was made from."""
    from OCP.TopLoc import TopLoc_Location

    process = reader.WS().TransferReader()
    # Inside an assembly the entity belongs to the face at its own place.
    entity = process.EntityFromShapeResult(face, 1) or process.EntityFromShapeResult(face.Located(TopLoc_Location()), 1)
    label = entity.Name() if entity is not None and hasattr(entity, "Name") else None
    if label is None:
        return None
    text = "".join(label.Value(i) for i in range(1, label.Length() + 1)).strip()
    return text if text and text.upper() != "NONE" else None
