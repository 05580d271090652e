"""A planned path as a record."""

from __future__ import annotations

from typing import Any

from beltgui.steps.blocks import degrees, plain, verdict_block
from core.path import PathPlan, ProgramProof, Stroke
from core.verdict import Verdict


def record(plan: PathPlan, program: dict[str, Any] | None) -> dict[str, Any]:
    """Contacts of the design and compensated, flange poses, and the program with its proof.

    Contact frames are 4x4 in the work frame, z outward along the design's normal; flange poses are 4x4 in the base.
    """
    return {
        "verdict": verdict_block(Verdict()),
        "compensated": plan.compensated,
        "points": plan.points,
        "trimmed_points": plan.trimmed_points,
        "program": program,
        "strokes": [_stroke(stroke) for stroke in plan.strokes],
    }


def program_block(path: str, sha256: str, proof: ProgramProof) -> dict[str, Any]:
    """The program file and what came back when it was read again."""
    return {"path": path, "sha256": sha256, "poses": proof.poses, "max_position_mm": plain(proof.max_position_mm),
            "max_rotation_deg": degrees(proof.max_rotation_rad), "max_contact_mm": plain(proof.max_contact_mm)}


def _stroke(stroke: Stroke) -> dict[str, Any]:
    return {
        "points": int(stroke.u.size),
        "u": plain(stroke.u),
        "v": plain(stroke.v),
        "error_mm": plain(stroke.error_mm),
        "nominal_work_from_contact": plain(stroke.nominal_work_from_contact),
        "work_from_contact": plain(stroke.work_from_contact),
        "nominal_base_from_flange": plain(stroke.nominal_base_from_flange),
        "base_from_flange": plain(stroke.base_from_flange),
    }
