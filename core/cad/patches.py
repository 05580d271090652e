"""Faces that lie on one surface, joined: what registration measures on."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

from core.cad.surfaces import Surface

if TYPE_CHECKING:
    from shapely import MultiPolygon, Polygon


@dataclass(frozen=True, eq=False)
class Patch:
    """One surface with everything of it that the chosen faces cover.

    Attributes:
        surface: Common surface; its (s, t) are those of `trim`.
        face_ids: Faces that were joined, ascending.
        label: Names of the faces for messages, e.g. `S2` or `face 3 + face 7`.
        trim: Union of the faces' regions in (s, t), mm; no edge where two faces only meet.
    """

    surface: Surface
    face_ids: tuple[int, ...]
    label: str
    trim: Polygon | MultiPolygon
