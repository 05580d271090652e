"""From the start to a pose from which every point's face is certain: coarse alignment, then boxes that tighten."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import NDArray

from core.cad import CadModel
from core.fine.boxes import Target, distances, gather
from core.fine.coarse import ModelSamples, ThinScan, align, sample_model, support, surface_share, thin_scan
from core.fine.moments import accumulate, solve_moments
from core.fine.noise import shortest_half_sigma
from core.fine.settings import FineSettings
from core.fine.slides import slid_poses
from core.frames import perturbed, transform_points
from core.progress import Progress, part, silent
from core.robust import tukey_weights

Array = NDArray[np.float64]

TESSELLATION_MM = 0.03
NEAR_MM = 2.0
SURFACE_REACH_MM = 6.0
_ENOUGH = 30
_LEAST_STARTS, _MOST_STARTS = 10, 20
# A wide kernel comes from farther off, a narrow one is not drawn to a table some mm beside the faces.
_WIDE_EVERY, _WIDE_KERNEL_MM, _NARROW_KERNEL_MM = 4, 4.0, 1.5
_EXPLORING_POINTS = 800
_LEAST_THIN_POINTS = 20
_SAME_POSE_MM = 0.5
_POLISH_KERNEL_MM = 0.6
_CLEARLY_BETTER = 1.02
_WORTH_A_TRY = 0.8
_MOST_FIXTURE_PLANES = 3
_SHRINK = 0.6
# Boxes stop tightening here; the final stage takes over.
_LAST_HALF_SIGMAS = 8.0
_LEAST_SIGMA_MM = 2e-4


@dataclass(frozen=True, eq=False)
class Capture:
    """A pose near the answer.

    Attributes:
        measure_from_work: 4x4.
        sigma_mm: Scatter of the points about the faces.
        near: Points within 2 mm of the inner parts of the faces.
        on: How many of them lie on the faces.
        near_by_face: (F,) the same per target.
        on_by_face: (F,) the same per target.
        surface_share: Share of the scanned surface within 6 mm of the faces that lies on them.
        overhung: Ids of faces whose surface goes on beyond their edges.
    """

    measure_from_work: Array
    sigma_mm: float
    near: int
    on: int
    near_by_face: NDArray[np.int64]
    on_by_face: NDArray[np.int64]
    surface_share: float = 0.0
    overhung: frozenset[int] = frozenset()

    @property
    def agreeing(self) -> int:
        """Faces on which most of the points beside them lie."""
        return int(np.count_nonzero((self.near_by_face >= _ENOUGH) & (2 * self.on_by_face >= self.near_by_face)))

    @property
    def contradicting(self) -> int:
        """Faces beside which there are points, most of them not on the face."""
        return int(np.count_nonzero((self.near_by_face >= _ENOUGH) & (2 * self.on_by_face < self.near_by_face)))

    @property
    def share(self) -> float:
        """`on / near`; 0 without points."""
        return self.on / self.near if self.near else 0.0


def capture(model: CadModel, targets: Sequence[Target], points: Array, start: Array,
            settings: FineSettings, progress: Progress = silent) -> Capture | None:
    """Best of several starts around the given one; None where no point comes near the model.

    Args:
        model: For the coarse stage, which looks at all faces.
        targets: Chosen faces.
        points: (N, 3) mm in M.
        start: measure_from_work.
        settings: See there.
        progress: Told of the stages.
    """
    ids = {number for target in targets for number in target.patch.face_ids}
    progress(0.0, "triangles of the CAD model")
    mesh = model.tessellate(TESSELLATION_MM)
    progress(0.05, "points of the CAD model")
    samples = sample_model(mesh, ids, settings.seed)
    progress(0.1, "thinning the scan")
    thin = thin_scan(points, samples, start, settings.coarse_points, settings.capture_mm, settings.seed)
    if len(thin.points) < _LEAST_THIN_POINTS:
        return None
    pose = start
    if settings.search:
        pose = _best_coarse(samples, thin, model, start, settings, part(progress, 0.2, 0.75))
        progress(0.75, "looking for the fixture's planes")
        pose = _without_fixture(samples, thin, pose, settings)
        pose = _without_slide(samples, thin, targets, pose, settings, part(progress, 0.78, 0.85))
    rng = np.random.default_rng(settings.seed)
    medium = points
    if len(points) > settings.medium_points:
        medium = points[rng.choice(len(points), settings.medium_points, replace=False)]
    progress(0.85, "tightening the filter boxes")
    tight = tighten(targets, medium, pose, settings)
    if tight is None:
        return None
    pose = tight.measure_from_work
    return replace(tight, surface_share=surface_share(samples, thin, pose, SURFACE_REACH_MM),
                   overhung=support(samples, thin, pose).overhung)


def _best_coarse(samples: ModelSamples, thin: ThinScan, model: CadModel, start: Array,
                 settings: FineSettings, progress: Progress) -> Array:
    """Several starts around the given one until the best pose was reached twice.

    A blade has parallel faces a few mm apart: one start may end with some faces of the scan on the wrong ones.
    """
    rng = np.random.default_rng(settings.seed)
    some = thin.part(rng.permutation(len(thin.points))[:_EXPLORING_POINTS])
    corners = model.bounds_mm[np.array(list(np.ndindex(2, 2, 2))), np.arange(3)]
    best, best_score, reached = start, -1.0, 0
    for attempt in range(_MOST_STARTS):
        progress(attempt / _MOST_STARTS, f"start {attempt + 1} is aligned")
        wide = attempt % _WIDE_EVERY == _WIDE_EVERY - 1
        pose = align(samples, some, _varied(start, model, attempt, rng), settings.capture_mm * (1.0 if wide else 0.5),
                     kernel_mm=_WIDE_KERNEL_MM if wide else _NARROW_KERNEL_MM)
        value = support(samples, thin, pose).score
        apart = np.linalg.norm(transform_points(pose, corners) - transform_points(best, corners), axis=1).max()
        if apart < _SAME_POSE_MM:
            reached += 1
        elif value > best_score:
            reached = 1
        if value > best_score:
            best, best_score = pose, value
        if reached >= 2 and attempt + 1 >= _LEAST_STARTS:
            break
    return align(samples, thin, best, settings.capture_mm, kernel_mm=_POLISH_KERNEL_MM)


def _without_fixture(samples: ModelSamples, thin: ThinScan, pose: Array, settings: FineSettings) -> Array:
    """The pose, or the better one that comes out without the points of planes that can't be faces."""
    best = support(samples, thin, pose)
    for _ in range(_MOST_FIXTURE_PLANES):
        if not best.overhung:
            break
        rest = thin.part(np.flatnonzero(~np.isin(best.face_of_point, list(best.overhung))))
        if len(rest.points) < _LEAST_THIN_POINTS:
            break
        tried = align(samples, rest, pose, settings.capture_mm)
        found = support(samples, thin, tried)
        if found.score <= _CLEARLY_BETTER * best.score:
            break
        pose, best = tried, found
    return pose


def _without_slide(samples: ModelSamples, thin: ThinScan, targets: Sequence[Target], pose: Array,
                   settings: FineSettings, progress: Progress) -> Array:
    """The pose, or the better one that lies a shift along some faces' normal away."""
    best, best_score = pose, support(samples, thin, pose).score
    slides = slid_poses(targets, thin, pose, settings.capture_mm)
    for number, slid in enumerate(slides):
        progress(number / len(slides), "looking for parallel faces")
        if support(samples, thin, slid).score < _WORTH_A_TRY * best_score:
            continue
        tried = align(samples, thin, slid, settings.capture_mm, kernel_mm=_POLISH_KERNEL_MM)
        value = support(samples, thin, tried).score
        if value > _CLEARLY_BETTER * best_score:
            best, best_score = tried, value
    return best


def _varied(start: Array, model: CadModel, attempt: int, rng: np.random.Generator) -> Array:
    """The start itself, then starts turned by up to 4 degrees and shifted by up to 5 mm about the model's middle."""
    if attempt == 0:
        return start
    middle = transform_points(start, model.bounds_mm.mean(axis=0))
    change = np.concatenate([rng.uniform(-1.0, 1.0, 3) * np.radians(2.5), rng.uniform(-3.0, 3.0, 3)])
    return perturbed(start, change, middle)


def tighten(targets: Sequence[Target], points: Array, start: Array, settings: FineSettings) -> Capture | None:
    """Boxes on the exact surfaces that tighten until they are some sigmas thick; None where they run empty.

    Args:
        targets: Chosen faces.
        points: (n, 3) mm in M, a random part of the scan.
        start: measure_from_work, a few tenths of a mm off.
        settings: See there.
    """
    pose, half, sigma = start, settings.half_thickness_mm, settings.half_thickness_mm
    for _ in range(25):
        boxes = gather(targets, points, pose, half_thickness_mm=half, margin_mm=min(settings.edge_zone_mm, 1.0))
        filled = [(target, box) for target, box in zip(targets, boxes, strict=True) if len(box.index) >= 5]
        if sum(len(box.index) for _, box in filled) < 20:
            return None
        residuals = [distances(target, box.points, pose) for target, box in filled]
        sigma = max(shortest_half_sigma(np.concatenate(residuals))[0], _LEAST_SIGMA_MM)
        centre = np.concatenate([box.points for _, box in filled]).mean(axis=0)
        lever = float(np.sqrt(np.mean([((box.points - centre) ** 2).sum(axis=1).mean() for _, box in filled])))
        moments = [accumulate(target, box.points, tukey_weights(d, half, 1.0), pose, centre)
                   for (target, box), d in zip(filled, residuals, strict=True)]
        new = solve_moments(moments, [1.0] * len(moments), pose, centre, least_ratio=3e-3, lever_mm=max(lever, 1.0))
        corners = np.concatenate([target.box_mm for target in targets])
        moved = float(np.linalg.norm(transform_points(new, corners) - transform_points(pose, corners), axis=1).max())
        pose = new
        tighter = max(_SHRINK * half, _LAST_HALF_SIGMAS * sigma)
        if tighter >= half and moved < 0.5 * sigma:
            break
        half = min(tighter, half)
    return _counted(targets, points, pose, sigma, settings)


def _counted(targets: Sequence[Target], points: Array, pose: Array, sigma: float, settings: FineSettings) -> Capture:
    """How many of the points around the inner parts of the faces lie on them."""
    boxes = gather(targets, points, pose, half_thickness_mm=NEAR_MM, margin_mm=settings.edge_zone_mm)
    near = np.array([len(box.index) for box in boxes])
    on = np.array([np.count_nonzero(np.abs(distances(target, box.points, pose)) < 5.0 * sigma)
                   for target, box in zip(targets, boxes, strict=True)])
    return Capture(pose, sigma, int(near.sum()), int(on.sum()), near, on)
