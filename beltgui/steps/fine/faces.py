"""Which faces of the blade are measured on."""

from __future__ import annotations

from beltgui.steps.fine.step import type_faces
from beltgui.steps.room import Bench
from core.errors import InputError

FACES = "faces"


def chosen_faces(bench: Bench) -> tuple[int, ...]:
    """Ids of the faces that a person chose, ascending; the blade type's own as long as nobody did.

    Raises:
        InputError: the choice is empty, or names a face that the model does not have or that cannot be measured on.
    """
    chosen = bench.session.setting("fine", FACES)
    if chosen is None:
        return tuple(sorted(type_faces(bench.model, bench.blade)))
    faces = [bench.model.face(int(number)) for number in chosen]
    if not faces:
        raise InputError("No face is chosen. Click on at least three faces of the CAD model.")
    for face in faces:
        if not face.usable:
            raise InputError(f"{face.label} cannot be chosen. {face.why_not or ''}")
    return tuple(sorted({face.id for face in faces}))
