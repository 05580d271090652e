"""Scan to CAD without picks, from any pose: search, compare, accept only what the fine step confirms; mm, rad."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from typing import Generic, Protocol, TypeVar

import numpy as np
from numpy.typing import ArrayLike, NDArray

from core.cad import CadModel
from core.errors import FitError, InputError
from core.frames import Array, inverse, rotvec_from_rotation, transform_points
from core.progress import Progress, part, silent
from core.rough.pair_checks import finite_points
from core.rough.refine import Agreement, agreement, refined, rough_scores
from core.rough.search import TranslationSearch, rotations_from_directions
from core.rough.shape import Shape, flat_directions, mesh_shape, scan_shape
from core.verdict import Code

_SAMPLE_SPACING_MM = 1.0
_SMALL, _LARGE, _COMPARED = 300, 1500, 6000
_KEPT_AFTER_SEARCH, _KEPT_AFTER_SCORE, _KEPT_AFTER_ALIGN = 300, 40, 8
_WIDE_GATES_MM = (8.0, 6.0, 5.0, 4.0, 3.0, 2.0)
# Share of the time, roughly, at which the stages of the search begin.
_SEARCH_BEGINS, _ALIGN_BEGINS, _COMPARE_BEGINS = 0.2, 0.6, 0.85
_NARROW_GATES_MM = (3.0, 2.0, 1.5, 1.0, 0.7, 0.5, 0.4, 0.3, 0.3)


class Confirmed(Protocol):
    """What the fine step's result must offer."""

    @property
    def measure_from_work(self) -> Array:
        """(4, 4)."""


FineT_co = TypeVar("FineT_co", bound=Confirmed, covariant=True)
Confirm = Callable[[CadModel, Sequence[Array], Array], FineT_co]


@dataclass(frozen=True)
class GlobalSettings:
    """What a pose must fulfil to be accepted; shares are of the scan's flat points.

    Attributes:
        surface_mm: On the model means within this along the normal; above the stock that is left to grind, if any.
        min_on_surface: Least share of the scan that lies on the model; the rest is fixture.
        min_of_near: Least share, of the points within 5 mm of the model, that lie on it.
        min_of_parallel: Least share, of those that are also parallel to it, that lie on it.
        least_difference: A second pose is told from the best one if this share of the explained points, and twice as
            many as the other way round, lie on the model in the best pose only.
        same_rad: Poses closer than this and ...
        same_mm: ... than this at the model's corners are one pose.
        max_fine_move_mm: The fine step may move the model's corners this far; more means that it went elsewhere.
        capture_rad: Poses that are as good as each other and closer than this and ...
        capture_mm: ... than this at the model's corners are left to the fine step, whose capture they share.
    """

    surface_mm: float = 0.3
    min_on_surface: float = 0.3
    min_of_near: float = 0.65
    min_of_parallel: float = 0.9
    least_difference: float = 0.015
    same_rad: float = 0.03
    same_mm: float = 3.0
    max_fine_move_mm: float = 7.5
    capture_rad: float = 0.06
    capture_mm: float = 8.0


@dataclass(frozen=True, eq=False)
class Candidate:
    """A pose that was refined and compared.

    Attributes:
        measure_from_work: (4, 4).
        agreement: How it explains the scan.
    """

    measure_from_work: Array
    agreement: Agreement


@dataclass(frozen=True, eq=False)
class GlobalFit(Generic[FineT_co]):
    """The blade found in a scan.

    Attributes:
        measure_from_work: (4, 4), the fine step's.
        score: Share of the scan's flat points that lie on the model.
        candidates: Distinct poses, the accepted one first (as the search left it).
        fine: The fine step's own result, which confirmed the pose.
    """

    measure_from_work: Array
    score: float
    candidates: tuple[Candidate, ...]
    fine: FineT_co


def register_globally(model: CadModel, points: ArrayLike, *, confirm: Confirm[FineT_co], seed: int = 0,
                      settings: GlobalSettings | None = None,
                      progress: Progress = silent) -> GlobalFit[FineT_co]:
    """Find the blade in a scan from any starting pose.

    Rotations lay flat directions of the scan on flat directions of the model; for each rotation all translations are
    tried at once by correlation; the best are aligned point to plane and compared by the share of the scan that they
    explain; the best distinct one must stand out from the second and be confirmed by the fine step.

    Args:
        model: CAD model, frame W.
        points: (N, 3) mm in M, partial views with clutter.
        confirm: The fine step, called as `confirm(model, [points], measure_from_work)`; raises FitError to refuse.
        seed: Of the random thinning.
        settings: What a pose must fulfil.
        progress: Told of the search; confirming tells its own.

    Raises:
        InputError: not numbers, NaN, or a scan in another unit than mm.
        FitError: too few points or flat areas, no pose explains the scan (WRONG_MODEL), several do, or the fine step
            refuses the best one.
    """
    settings = settings or GlobalSettings()
    cloud = finite_points(points, "points")
    candidates = find_candidates(model, cloud, seed=seed, settings=settings, progress=progress)
    return accepted(model, cloud, candidates, confirm, settings)


def accepted(model: CadModel, cloud: Array, candidates: tuple[Candidate, ...], confirm: Confirm[FineT_co],
             settings: GlobalSettings) -> GlobalFit[FineT_co]:
    """The best candidate, if it explains the scan (N, 3), no other does as well, and the fine step confirms it.

    Raises:
        FitError: one of the three is not so.
    """
    best = candidates[0]
    _check_explains(model, best.agreement, settings)
    alike = [best, *_captured_alike(model, candidates, settings)]
    try:
        fine = confirm(model, [cloud], best.measure_from_work)
    except FitError as error:
        raise FitError(f"A pose was found that puts {best.agreement.on_surface:.0%} of the scan on {model.path.stem}, "
                       f"but the fine step refuses it: {error}", error.code) from error
    moved = min(_corner_distance(model, fine.measure_from_work, one.measure_from_work) for one in alike)
    if moved > settings.max_fine_move_mm:
        raise FitError(f"The fine step moved the model by {moved:.1f} mm away from the pose that explains the scan "
                       f"best (at most {settings.max_fine_move_mm:g} mm is expected). Check that the blade type is "
                       f"{model.path.stem} and scan more of edge plate and shroud.", Code.NOT_CONVERGED)
    return GlobalFit(fine.measure_from_work, best.agreement.on_surface, candidates, fine)


def find_candidates(model: CadModel, points: Array, *, seed: int = 0,
                    settings: GlobalSettings | None = None, progress: Progress = silent) -> tuple[Candidate, ...]:
    """Distinct refined poses, best first, not yet judged; at least one.

    Args:
        model: CAD model, frame W.
        points: (N, 3) mm in M.
        seed: Of the random thinning.
        settings: For what counts as on the surface and as the same pose.
        progress: Told of each stage and each pose tried; what it raises ends the search.

    Raises:
        InputError: a scan in another unit than mm.
        FitError: too few points or too few flat areas.
    """
    settings = settings or GlobalSettings()
    rng = np.random.default_rng(seed)
    _check_size(model, points)
    progress(0.0, "triangles of the CAD model")
    mesh = model.tessellate(0.1)
    progress(0.08, "points of the CAD model")
    model_shape = mesh_shape(mesh.vertices, mesh.triangles, _SAMPLE_SPACING_MM, rng)
    scan = scan_shape(points, rng, part(progress, 0.12, _SEARCH_BEGINS))
    rows = rng.permutation(np.flatnonzero(scan.flat))
    if len(rows) < 100:
        raise FitError(f"Only {len(rows)} places of the scan are flat enough to tell a direction, at least 100 are "
                       "needed. Scan edge plate and shroud with more points.", Code.NOT_ENOUGH_POINTS)
    poses = _searched(scan, rows, model_shape, part(progress, _SEARCH_BEGINS, _ALIGN_BEGINS))
    order = np.argsort(-rough_scores(poses, scan, model_shape, rows[:_SMALL], 4.0))[:_KEPT_AFTER_SCORE]
    told, aligned_poses = part(progress, _ALIGN_BEGINS, _COMPARE_BEGINS), []
    for number, k in enumerate(order):
        told(number / len(order), f"pose {number + 1} of {len(order)} is aligned")
        aligned_poses.append(refined(poses[k], scan, model_shape, rows[:_SMALL], _WIDE_GATES_MM))
    aligned = np.array(aligned_poses)
    order = np.argsort(-rough_scores(aligned, scan, model_shape, rows[:_SMALL], 1.5))
    found: list[Candidate] = []
    told, kept = part(progress, _COMPARE_BEGINS, 1.0), _without_copies(model, aligned[order], settings)
    for number, k in enumerate(kept[:_KEPT_AFTER_ALIGN]):
        told(number / min(len(kept), _KEPT_AFTER_ALIGN), f"pose {number + 1} is compared with the scan")
        pose = refined(aligned[order][k], scan, model_shape, rows[:_LARGE], _NARROW_GATES_MM)
        explained = agreement(pose, scan, model_shape, rows[:_COMPARED], settings.surface_mm)
        found.append(Candidate(inverse(pose), explained))
    found.sort(key=lambda candidate: -candidate.agreement.on_surface)
    distinct = _without_copies(model, inverse(np.array([item.measure_from_work for item in found])), settings)
    return tuple(found[k] for k in distinct)


def _searched(scan: Shape, rows: NDArray[np.int64], model: Shape, progress: Progress) -> Array:
    """(K, 4, 4) work_from_measure, the best of all rotations and translations."""
    scan_directions, _ = flat_directions(scan, most=12, least_share=0.015)
    model_directions, _ = flat_directions(model, most=16, least_share=0.008)
    if len(scan_directions) < 2 or len(model_directions) < 2:
        short = "scan" if len(scan_directions) < 2 else "CAD model"
        raise FitError(f"The {short} has fewer than two flat areas of different direction, which the automatic search "
                       "needs. Scan edge plate and shroud from the side, or pick pairs of points.",
                       Code.NOT_ENOUGH_VARIATION)
    rotations = rotations_from_directions(scan, scan_directions, model, model_directions)
    if not len(rotations):
        raise FitError("No two flat areas of the scan meet at an angle that flat areas of the CAD model have. Check "
                       "the blade type.", Code.WRONG_MODEL)
    search = TranslationSearch(model)
    found = []
    for number, rotation in enumerate(rotations):
        progress(number / len(rotations), f"rotation {number + 1} of {len(rotations)}")
        found.append(search.poses(rotation, scan.points[rows[:_LARGE]]))
    poses = np.concatenate([item[0] for item in found])
    heights = np.concatenate([item[1] for item in found])
    return np.asarray(poses[np.argsort(-heights)[:_KEPT_AFTER_SEARCH]])


def _corners(model: CadModel) -> Array:
    low, high = model.bounds_mm
    return np.array([[x, y, z] for x in (low[0], high[0]) for y in (low[1], high[1]) for z in (low[2], high[2])])


def _corner_distance(model: CadModel, first: Array, second: Array) -> float:
    """Largest distance of the model's corners between two poses measure_from_work."""
    corners = _corners(model)
    return float(np.linalg.norm(transform_points(first, corners) - transform_points(second, corners), axis=1).max())


def _without_copies(model: CadModel, work_from_measure: Array, settings: GlobalSettings) -> list[int]:
    """Places of the poses that are no copy of an earlier one."""
    poses = inverse(work_from_measure)
    kept: list[int] = []
    for k, pose in enumerate(poses):
        copies = any(_corner_distance(model, pose, poses[j]) < settings.same_mm
                     and np.linalg.norm(rotvec_from_rotation(pose[:3, :3].T @ poses[j][:3, :3])) < settings.same_rad
                     for j in kept)
        if not copies:
            kept.append(k)
    return kept


def _check_size(model: CadModel, points: Array) -> None:
    """The scan must have the size of a work piece that could be the model, in mm."""
    if len(points) < 500:
        raise FitError(f"The scan has {len(points)} points, at least 500 are needed to find the blade in it.",
                       Code.NOT_ENOUGH_POINTS)
    size = float(np.linalg.norm(np.ptp(model.bounds_mm, axis=0)))
    extent = float(np.linalg.norm(np.diff(np.percentile(points, [2.0, 98.0], axis=0), axis=0)))
    if extent < size / 20.0:
        hint = " It looks like metres." if size / 5000.0 < extent < size / 150.0 else ""
        raise InputError(f"The scan is {extent:.3g} mm across and {model.path.name} {size:.4g} mm.{hint} Give the scan "
                         "in mm, and edge plate and shroud together.")
    if extent > size * 100.0:
        raise InputError(f"The scan is {extent:.4g} mm across and {model.path.name} {size:.4g} mm. Give both in mm.")


def _check_explains(model: CadModel, found: Agreement, settings: GlobalSettings) -> None:
    """Enough of the scan must lie on the model, and what is near it must lie on it."""
    name = model.path.stem
    if found.on_surface < settings.min_on_surface:
        raise FitError(f"{name} was not found in the scan: the best pose puts {found.on_surface:.0%} of it on the "
                       f"model, at least {settings.min_on_surface:.0%} is needed. Check the blade type, and scan edge "
                       "plate and shroud with less of the fixture.", Code.WRONG_MODEL)
    if found.of_near < settings.min_of_near or found.of_parallel < settings.min_of_parallel:
        raise FitError(f"The scan does not fit {name}: in the best pose {found.of_near:.0%} of the points near the "
                       f"model lie on it ({settings.min_of_near:.0%} is needed), and of those parallel to its "
                       f"faces {found.of_parallel:.0%} ({settings.min_of_parallel:.0%} is needed). Check the blade "
                       "type.", Code.WRONG_MODEL)


def _captured_alike(model: CadModel, candidates: Sequence[Candidate], settings: GlobalSettings) -> list[Candidate]:
    """Poses as good as the best one that the fine step reaches from it; any farther one makes the scan ambiguous.

    The points that the best pose explains and another one doesn't must outnumber the reverse.
    """
    best, alike = candidates[0], []
    for other in candidates[1:]:
        for_best = int(np.count_nonzero(best.agreement.on & ~other.agreement.on))
        for_other = int(np.count_nonzero(other.agreement.on & ~best.agreement.on))
        needed = max(2 * for_other, int(settings.least_difference * np.count_nonzero(best.agreement.on)))
        if for_best <= needed:
            turn = other.measure_from_work[:3, :3] @ best.measure_from_work[:3, :3].T
            turn_rad = float(np.linalg.norm(rotvec_from_rotation(turn)))
            shift = _corner_distance(model, best.measure_from_work, other.measure_from_work)
            if turn_rad < settings.capture_rad and shift < settings.capture_mm:
                alike.append(other)
                continue
            shares = f"{best.agreement.on_surface:.0%} and {other.agreement.on_surface:.0%} of it on the model"
            raise FitError(f"The scan fits {model.path.stem} in two ways ({shares}), {np.degrees(turn_rad):.0f} "
                           f"degrees and up to {shift:.0f} mm apart. Scan an area that tells them apart too, such as "
                           "the airfoil next to the edge plate, or pick pairs of points.", Code.NOT_ENOUGH_VARIATION)
    return alike
