"""Parts that the records of all steps share; this is where rad becomes degrees."""

from __future__ import annotations

import math
from typing import Any

import numpy as np
from numpy.typing import ArrayLike

from core.conditioning import Conditioning
from core.frames import Array, PoseCovariance, euler_zyx_from_rotation
from core.verdict import Verdict


def plain(value: Any) -> Any:
    """Nested lists, dicts, text and finite numbers: what strict JSON can hold. NaN and infinity become None."""
    if isinstance(value, dict):
        return {str(key): plain(item) for key, item in value.items()}
    if isinstance(value, list | tuple):
        return [plain(item) for item in value]
    if isinstance(value, np.ndarray):
        return plain(value.tolist())
    if isinstance(value, np.generic):
        return plain(value.item())
    if isinstance(value, float):
        return value if math.isfinite(value) else None
    if value is None or isinstance(value, bool | int):
        return value
    if isinstance(value, str):
        return str(value)  # a StrEnum becomes ordinary text
    raise TypeError(f"{type(value).__name__} has no place in a record")


def verdict_block(verdict: Verdict) -> dict[str, Any]:
    """`{"ok", "reasons": [{"code", "message"}]}`."""
    reasons = [{"code": str(reason.code), "message": reason.message} for reason in verdict.reasons]
    return {"ok": verdict.ok, "reasons": reasons}


def pose_block(a_from_b: Array, covariance: PoseCovariance | None = None) -> dict[str, Any]:
    """A transform as matrix, translation in mm and Euler angles in degrees, with its covariance where there is one.

    The covariance is 6x6 in the order rx ry rz tx ty tz (rad and mm), for rotations about `covariance_about_mm`, a
    point in the target frame.
    """
    block: dict[str, Any] = {
        "matrix": plain(a_from_b),
        "translation_mm": plain(a_from_b[:3, 3]),
        "euler_zyx_deg": plain(np.degrees(euler_zyx_from_rotation(a_from_b[:3, :3]))),
    }
    if covariance is not None:
        block["covariance"] = plain(covariance.matrix)
        block["covariance_about_mm"] = plain(covariance.about_mm)
    return block


def conditioning_block(conditioning: Conditioning) -> dict[str, Any]:
    """`condition`, and `weakest_direction` in words."""
    return {"condition": plain(conditioning.condition), "weakest_direction": conditioning.description}


def degrees(angle_rad: ArrayLike) -> Any:
    """Angle(s) in rad as plain degrees."""
    return plain(np.degrees(np.asarray(angle_rad, dtype=float)))
