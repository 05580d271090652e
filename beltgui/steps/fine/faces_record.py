"""What a STEP file offers for registration, as a record."""

from __future__ import annotations

from typing import Any

from beltgui.steps.blocks import degrees, plain, verdict_block
from core.cad import CadFace, CadModel
from core.verdict import Code, Reason, Verdict


def judge_faces(model: CadModel) -> Verdict:
    """Reject a model on which registration has nothing to measure."""
    if any(face.usable for face in model.faces):
        return Verdict()
    return Verdict((Reason(Code.NOT_ENOUGH_POINTS, f"None of the {len(model.faces)} faces can be used for "
                                                   "registration; each says why. Export the solid with exact faces."),))


def record(model: CadModel, verdict: Verdict) -> dict[str, Any]:
    """All faces in the file's order."""
    return {
        "verdict": verdict_block(verdict),
        "solid": model.solid,
        "bounds_mm": plain(model.bounds_mm),
        "usable_faces": sum(face.usable for face in model.faces),
        "faces": [_face(face) for face in model.faces],
    }


def _face(face: CadFace) -> dict[str, Any]:
    parameters: dict[str, Any] = {}
    for name, value in face.parameters.items():
        if name.endswith("_rad"):
            parameters[name.removesuffix("_rad") + "_deg"] = degrees(value)
        else:
            parameters[name] = plain(value)
    return {"id": face.id, "name": face.name, "type": face.type, "area_mm2": plain(face.area_mm2),
            "usable": face.usable, "why_not": face.why_not, "parameters": parameters}
