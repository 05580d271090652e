"""What the fine step may be told; every default holds for blades of 50 to 500 mm and scanners of 5 to 200 µm noise."""

from __future__ import annotations

from dataclasses import dataclass

from core.errors import InputError


@dataclass(frozen=True)
class FineSettings:
    """Settings of `solve_fine`; lengths in mm.

    Attributes:
        sigma_mm: Known noise of a point along the surface normal; None estimates it from the data.
        edge_margin_mm: Points nearer than this to the edge of a face are never used (burrs, mixed pixels).
        edge_zone_mm: Points nearer than this to the edge form a zone of their own, used only where it is clean.
        half_thickness_mm: Half thickness of the filter boxes when the exact surfaces take over; it shrinks from there.
        capture_mm: How far points may lie from the model at the start; twice a start error of 2.5 degrees on 300 mm.
        max_start_motion_mm: How far the fit may carry a corner of the model from the start; farther away another pose
            may fit the few points that the start brought near, such as a symmetric root the wrong way round.
        min_points_per_face: A face with fewer points in its box is not used (or refused where it was asked for).
        min_points: Fewer points on all faces together are refused.
        max_sigma_mm: A scatter above this is no scanner noise: the model does not fit.
        min_near_share: Least share of the points near the faces that must lie on them.
        max_condition: Largest ratio of best to worst observed direction, with all faces weighing the same.
        max_point_sigma_mm: Largest one-sigma uncertainty that a result may have at an end of the model.
        coarse_points: Points of the thinned scan in the coarse stage.
        medium_points: Points in the stage that tightens the boxes.
        max_passes: Passes over all points before the fit counts as not converged.
        search: False skips the coarse stage, for a start that is known to some tenths of a mm (a blade of the same
        clamp
            scanned again).
        seed: Of the thinning and of the extra starts.
    """

    sigma_mm: float | None = None
    edge_margin_mm: float = 0.3
    edge_zone_mm: float = 1.2
    half_thickness_mm: float = 1.2
    capture_mm: float = 14.0
    max_start_motion_mm: float = 40.0
    min_points_per_face: int = 30
    min_points: int = 100
    max_sigma_mm: float = 0.25
    min_near_share: float = 0.4
    max_condition: float = 100.0
    max_point_sigma_mm: float = 0.2
    coarse_points: int = 4000
    medium_points: int = 60_000
    max_passes: int = 60
    search: bool = True
    seed: int = 0

    def __post_init__(self) -> None:
        """Refuse settings that cannot be meant."""
        for name in ("edge_zone_mm", "half_thickness_mm", "capture_mm", "max_start_motion_mm", "max_sigma_mm",
                     "max_point_sigma_mm"):
            if not getattr(self, name) > 0.0:
                raise InputError(f"{name} must be above 0 mm, found {getattr(self, name)}.")
        if self.sigma_mm is not None and not self.sigma_mm > 0.0:
            raise InputError(f"sigma_mm must be above 0 mm, found {self.sigma_mm}.")
        if not 0.0 <= self.edge_margin_mm <= self.edge_zone_mm:
            raise InputError(f"edge_margin_mm must lie between 0 and edge_zone_mm, found {self.edge_margin_mm}.")
