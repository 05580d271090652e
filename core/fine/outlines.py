"""Filter boxes as lines, for display; mm, frame W."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from core.cad import CadFace
from core.errors import InputError

Array = NDArray[np.float64]

# Chords of a curved face's outline stay shorter than this.
_LONGEST_MM = 2.0


def box_outlines(face: CadFace, *, half_thickness_mm: float, margin_mm: float) -> tuple[Array, ...]:
    """Edges of a face's filter box: its trim less the margin, on both sides of the surface, and the corners between.

    Args:
        face: A plane or cylinder.
        half_thickness_mm: Largest distance of the box from the surface.
        margin_mm: Distance that the box keeps from the trim's edge.

    Returns:
        Polylines (n, 3) in W; none where the face is narrower than two margins.

    Raises:
        InputError: the face is neither plane nor cylinder.
    """
    if face.surface is None or face.trim is None:
        raise InputError(f"{face.label} has no filter box. {face.why_not or ''}")
    inner = face.trim.buffer(-margin_mm, join_style="mitre")
    lines: list[Array] = []
    for polygon in getattr(inner, "geoms", [inner]):
        for loop in (polygon.exterior, *polygon.interiors):
            corners = np.asarray(loop.coords, dtype=float)
            if not len(corners):
                continue
            s, t = np.asarray(loop.segmentize(_LONGEST_MM).coords, dtype=float).T
            lines += [face.surface.from_surface(s, t, side * half_thickness_mm) for side in (-1.0, 1.0)]
            posts = _corners(corners)
            ends = [face.surface.from_surface(posts[:, 0], posts[:, 1], side * half_thickness_mm)
                    for side in (-1.0, 1.0)]
            lines += [np.stack(pair) for pair in zip(*ends, strict=True)]
    return tuple(lines)


def _corners(loop: Array) -> Array:
    """Points (n, 2) of a closed loop where it turns by more than 20 degrees."""
    points = loop[:-1]
    before, after = points - np.roll(points, 1, axis=0), np.roll(points, -1, axis=0) - points
    cross = before[:, 0] * after[:, 1] - before[:, 1] * after[:, 0]
    turn = np.abs(np.arctan2(cross, np.sum(before * after, axis=1)))
    return np.asarray(points[turn > np.radians(20.0)])
