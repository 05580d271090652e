"""What the fine step hands over."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from core.conditioning import Conditioning
from core.fine.settings import FineSettings
from core.frames import PoseCovariance

Array = NDArray[np.float64]


@dataclass(frozen=True)
class FaceResult:
    """One face of the model after the fit.

    Attributes:
        id: Of the CadFace.
        name: Name in the STEP file, None where it has none.
        type: `plane` or `cylinder`.
        points: Points used.
        rms_mm: Root mean square of their distances.
        mean_mm: Mean of their distances; positive outside the material.
        sigma_mm: Robust scatter about that mean.
        held_out_mm: Mean distance of the face's points under the pose that the other faces give alone; NaN where they
            don't determine it. Faces that lie on one surface share it.
        coverage: Share of the face's area on which points were found.
        used: False where the face had no say.
        note: Why it was not used, or what is odd about it; empty otherwise.
        counts: How many of all points in the face's box lie between two edges of `FineFit.bins_mm`; empty if not used.
    """

    id: int
    name: str | None
    type: str
    points: int
    rms_mm: float
    mean_mm: float
    sigma_mm: float
    held_out_mm: float
    coverage: float
    used: bool
    note: str
    counts: tuple[int, ...] = ()


@dataclass(frozen=True, eq=False)
class FineFit:
    """Pose of the blade in the measurement frame.

    Attributes:
        measure_from_work: 4x4.
        covariance: Of its error, in M, about the middle of the points.
        faces: All faces asked for (or all that can be used), in the order of their ids.
        faces_named: True where the caller chose the faces, False where all that had points were taken.
        sigma_mm: Robust scatter of a point along the normal, over all faces.
        rms_mm: Root mean square distance of the points used.
        points: Points in the scan.
        points_used: Points that the pose rests on (sum of the weights, rounded).
        near_share: Share of the points within 2 mm of the inner parts of the faces that lie on them.
        iterations: Passes over the points of the boxes.
        converged: True; a fit that doesn't converge raises.
        conditioning: Weakest direction, in W about the middle of the points, all faces weighing the same.
        ends_in_work_mm: (3, 3) the two ends of the model and its middle, along its longest side.
        point_sigma_mm: (3,) one sigma of the position there, root of the trace.
        half_split_mm: (3,) distance there between the poses from two halves of the data (alternating blocks of 5 mm).
        start_moved_mm: Largest motion of the model's corners from the start.
        bins_mm: (k + 1,) edges of the bins of the faces' histograms of distances, symmetric about 0.
        settings: As used.
    """

    measure_from_work: Array
    covariance: PoseCovariance
    faces: tuple[FaceResult, ...]
    faces_named: bool
    sigma_mm: float
    rms_mm: float
    points: int
    points_used: int
    near_share: float
    iterations: int
    converged: bool
    conditioning: Conditioning
    ends_in_work_mm: Array
    point_sigma_mm: Array
    half_split_mm: Array
    start_moved_mm: float
    bins_mm: Array
    settings: FineSettings
