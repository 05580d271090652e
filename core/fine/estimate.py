"""The last stage: all points in their boxes, nearly efficient weights, pose and covariance."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import NDArray

from core.errors import FitError
from core.fine.boxes import FacePoints, Target, distances, gather
from core.fine.capture import Capture
from core.fine.held_out import held_out_means
from core.fine.moments import Moments, accumulate, normal_equations, solve_moments
from core.fine.noise import WINDOW_SIGMAS, Mixture, fit_mixture
from core.fine.settings import FineSettings
from core.frames import pose_error
from core.progress import Progress, part, silent
from core.verdict import Code

Array = NDArray[np.float64]
Mask = NDArray[np.bool_]

# Below this many points a face borrows the scatter of all faces.
OWN_NOISE_POINTS = 400
_OWN_SHARES_POINTS = 30
# The border of a face is used while at most this share of its points within three sigmas are strangers ...
_CLEAN_RIM_SHARE = 0.03
# ... and its mean agrees with that of the inner part within this many standard errors.
_RIM_AGREES = 4.0
_PASSES_BEFORE_FROZEN = 3
# The noise is estimated anew in these passes and then kept, so that the pose can settle.
_PASSES_WITH_NOISE = 8
_STRANGERS_RULE = 0.6
# Of the points in a seen face's box at least this share lies on it ...
_LEAST_ON = 0.3
# ... and it has at least this share of the usual points per area.
_THIN = 0.03
# Squared Mahalanobis length of a step that no longer matters.
_CONVERGED = 1e-4
# A face is at odds with the others beyond this many standard errors and more than this many sigmas.
_AT_ODDS_ERRORS, _AT_ODDS_SIGMAS = 6.0, 1.5
_AT_ODDS_LEAST_MM = 0.03


@dataclass(frozen=True, eq=False)
class FaceFit:
    """One target in the last stage.

    Attributes:
        target: Surface and trim.
        box: Points in its filter box.
        rim: (n,) True for points in the border zone.
        rim_used: Whether the border has a say; None while undecided.
        mixture: Noise of the inner part.
        rim_mixture: Noise of the border.
        distances_mm: (n,) at the last pass.
        weights: (n,) at the last pass.
        moments: Of all weighted points.
        used: False where the face has no say.
        note: Why not.
    """

    target: Target
    box: FacePoints
    rim: Mask
    rim_used: bool | None
    mixture: Mixture
    rim_mixture: Mixture
    distances_mm: Array
    weights: Array
    moments: Moments | None
    used: bool
    note: str

    @property
    def parts(self) -> list[tuple[Mask, Mixture]]:
        """Points and noise of the zones that have a say."""
        inner = (~self.rim, self.mixture)
        return [inner, (self.rim, self.rim_mixture)] if self.rim_used is not False else [inner]


@dataclass(frozen=True, eq=False)
class Estimate:
    """Pose, covariance and faces of the last stage.

    Attributes:
        measure_from_work: 4x4.
        covariance: (6, 6) of the pose error in M about `centre`.
        information: (6, 6) J^T W J about `centre`.
        centre: (3,) middle of the points in M.
        lever_mm: RMS distance of the points from it.
        faces: One per target.
        sigma_mm: Robust scatter over all faces.
        rms_mm: Weighted RMS distance.
        weight: Sum of the weights.
        passes: Passes over the points of the boxes.
    """

    measure_from_work: Array
    covariance: Array
    information: Array
    centre: Array
    lever_mm: float
    faces: tuple[FaceFit, ...]
    sigma_mm: float
    rms_mm: float
    weight: float
    passes: int

    @property
    def used(self) -> list[FaceFit]:
        """Faces that have a say."""
        return [face for face in self.faces if face.used]


def estimate(targets: Sequence[Target], points: Array, found: Capture, settings: FineSettings, *,
             asked_for: bool, progress: Progress = silent) -> Estimate:
    """Pose from all points.

    Args:
        targets: Chosen faces.
        points: (N, 3) mm in M.
        found: Pose and scatter of the capture.
        settings: See there.
        asked_for: True where the faces were named by the caller: none may be left out then.
        progress: Told of each pass.

    Raises:
        FitError: too few points, or the iteration does not settle.
    """
    sigma = settings.sigma_mm or found.sigma_mm
    progress(0.0, "points of the faces")
    boxes = gather(targets, points, found.measure_from_work, half_thickness_mm=WINDOW_SIGMAS * 1.1 * sigma,
                   margin_mm=settings.edge_margin_mm)
    faces = [_opened(target, box, sigma, settings) for target, box in zip(targets, boxes, strict=True)]
    if not asked_for:
        faces = [_unless_overhung(face, found.overhung) for face in faces]
    _refuse_poor(faces, settings, asked_for)
    result = _converged(faces, found.measure_from_work, sigma, settings, asked_for, part(progress, 0.0, 0.5))
    left = 0.5
    while not asked_for:
        odd = _at_odds(result)
        if odd is None:
            break
        faces = [replace(face, used=False, note=odd[1]) if face is odd[0] else face for face in result.faces]
        _refuse_poor(faces, settings, asked_for)
        told, left = part(progress, 1.0 - left, 1.0 - left / 2.0), left / 2.0
        result = _converged(faces, result.measure_from_work, result.sigma_mm, settings, asked_for, told)
    return result


def _opened(target: Target, box: FacePoints, sigma: float, settings: FineSettings) -> FaceFit:
    """A face before its first pass."""
    count = len(box.index)
    nothing = Mixture(float(count), 0.0, sigma, 1e-3, 1e-3)
    enough = count >= settings.min_points_per_face
    note = "" if enough else f"only {count} points in its box, {settings.min_points_per_face} are needed"
    return FaceFit(target, box, box.depth <= settings.edge_zone_mm, None, nothing, nothing, np.zeros(count),
                   np.zeros(count), None, enough, note)


def _unless_overhung(face: FaceFit, overhung: frozenset[int]) -> FaceFit:
    """The face without a say where the scan goes on beyond all its edges as if they weren't there."""
    if not face.used or not overhung.issuperset(face.target.patch.face_ids):
        return face
    return replace(face, used=False, note="the scanned surface goes on beyond its edge: the fixture, or another part")


def _refuse_poor(faces: Sequence[FaceFit], settings: FineSettings, asked_for: bool) -> None:
    """Raise where a named face, or all faces together, have too few points."""
    poor = [face for face in faces if not face.used]
    if asked_for and poor:
        names = "; ".join(f"{face.target.patch.label}: {face.note}" for face in poor)
        raise FitError(f"Not enough points on chosen faces ({names}). Scan these faces too, or leave them out of the "
                       "list.", Code.NOT_ENOUGH_POINTS)
    total = sum(len(face.box.index) for face in faces if face.used)
    if total < settings.min_points:
        raise FitError(f"Only {total} scan points lie on the chosen faces, at least {settings.min_points} are needed. "
                       "Scan more of the blade, or check that start and STEP file belong to this scan.",
                       Code.NOT_ENOUGH_POINTS)


def _converged(faces: Sequence[FaceFit], start: Array, sigma: float, settings: FineSettings,
               asked_for: bool, progress: Progress) -> Estimate:
    """Passes until the pose stands still."""
    pose = start
    used_points = np.concatenate([face.box.points for face in faces if face.used])
    centre = used_points.mean(axis=0)
    lever = max(float(np.sqrt(((used_points - centre) ** 2).sum(axis=1).mean())), 1.0)
    current = list(faces)
    for number in range(1, settings.max_passes + 1):
        progress(1.0 - 0.9**number, f"pass {number} over the points of the faces")
        current = _with_distances(current, pose)
        pooled = _pooled(current, sigma, settings)
        current = [_weighted(face, pooled, pose, centre, settings, number) for face in current]
        if not asked_for and number == 1:
            current = _without_stray(current, settings)
        _refuse_poor(current, settings, asked_for)
        moments, scales = _weighing(current)
        new = solve_moments(moments, scales, pose, centre, least_ratio=1e-4, lever_mm=lever)
        matrix, _ = normal_equations(moments, scales, new)
        step = pose_error(new, pose, centre)
        pose, sigma = new, pooled.sigma_mm
        if float(step @ matrix @ step) < _CONVERGED and number > _PASSES_BEFORE_FROZEN:
            return _summed(current, pose, centre, lever, pooled.sigma_mm, number)
    raise FitError(f"The pose has not settled after {settings.max_passes} passes (last step "
                   f"{np.linalg.norm(step[3:]) * 1000.0:.3g} µm, {np.linalg.norm(step[:3]) * 1e6:.3g} µrad). "
                   "The faces seen hold it too loosely or contradict each other; scan more faces.", Code.NOT_CONVERGED)


def _without_stray(faces: Sequence[FaceFit], settings: FineSettings) -> list[FaceFit]:
    """Leave out faces so thinly covered that ghosts and stray points explain it; the scanner didn't see them."""
    density = {id(face): float(face.weights.sum()) / max(face.target.field.area_mm2(settings.edge_margin_mm), 1.0)
               for face in faces if face.used}
    usual = float(np.median(list(density.values()))) if density else 0.0
    note = "hardly any points; those in its box are as thin as stray points"
    return [replace(face, used=False, note=note) if face.used and density[id(face)] < _THIN * usual else face
            for face in faces]


def _with_distances(faces: Sequence[FaceFit], pose: Array) -> list[FaceFit]:
    return [replace(face, distances_mm=distances(face.target, face.box.points, pose)) if face.used else face
            for face in faces]


def _pooled(faces: Sequence[FaceFit], sigma: float, settings: FineSettings) -> Mixture:
    """Noise of the inner parts of all faces together."""
    inner = [face.distances_mm[~face.rim] for face in faces if face.used]
    together = np.concatenate(inner)
    if len(together) < OWN_NOISE_POINTS:
        together = np.concatenate([face.distances_mm for face in faces if face.used])
    return fit_mixture(together, sigma, sigma_known=settings.sigma_mm)


def _weighted(face: FaceFit, pooled: Mixture, pose: Array, centre: Array, settings: FineSettings,
              number: int) -> FaceFit:
    """Noise, weights and moments of one face at a pose."""
    if not face.used:
        return face
    d = face.distances_mm
    mixture, rim_mixture, rim_used = face.mixture, face.rim_mixture, face.rim_used
    if number <= _PASSES_WITH_NOISE:
        mixture = _noise_of(d[~face.rim], pooled, settings)
        known = settings.sigma_mm or mixture.sigma_mm
        rim_mixture = _noise_of(d[face.rim], replace(pooled, sigma_mm=known), settings, known)
    if number <= _PASSES_BEFORE_FROZEN:
        rim_used = _is_clean(rim_mixture, mixture)
    weights = np.zeros(len(d))
    weights[~face.rim] = mixture.weights(d[~face.rim])
    if rim_used:
        weights[face.rim] = rim_mixture.weights(d[face.rim])
    count = float(weights.sum())
    looked_at = len(d) if rim_used else int(np.count_nonzero(~face.rim))
    strangers = mixture.stranger_share > _STRANGERS_RULE or count < _LEAST_ON * looked_at
    if count < settings.min_points_per_face or strangers:
        note = (f"of {len(d)} points in its box only {count:.0f} lie on it; the others are clutter or ghosts")
        return replace(face, used=False, note=note)
    return replace(face, mixture=mixture, rim_mixture=rim_mixture, rim_used=rim_used, weights=weights,
                   moments=accumulate(face.target, face.box.points, weights, pose, centre))


def _noise_of(d: Array, pooled: Mixture, settings: FineSettings, known: float | None = None) -> Mixture:
    """Mixture of one zone.

    A small one borrows the scatter of all faces, a tiny one the shares of strangers too; in between its own shares
    count the more the more points it has.
    """
    if len(d) >= OWN_NOISE_POINTS:
        return fit_mixture(d, pooled.sigma_mm, sigma_known=known or settings.sigma_mm)
    total = pooled.count + WINDOW_SIGMAS * pooled.sigma_mm * (pooled.behind + pooled.front)
    part = max(len(d), 1) / total
    usual = Mixture(part * pooled.count, pooled.mean_mm, pooled.sigma_mm, part * pooled.behind, part * pooled.front)
    if len(d) < _OWN_SHARES_POINTS:
        return usual
    own = fit_mixture(d, pooled.sigma_mm, sigma_known=pooled.sigma_mm)
    trust = len(d) / OWN_NOISE_POINTS

    def between(mine: float, others: float) -> float:
        return trust * mine + (1.0 - trust) * others

    return Mixture(between(own.count, usual.count), own.mean_mm, pooled.sigma_mm, between(own.behind, usual.behind),
                   between(own.front, usual.front))


def _is_clean(rim: Mixture, inner: Mixture) -> bool:
    error = inner.sigma_mm * np.sqrt(1.0 / max(rim.count, 1.0) + 1.0 / max(inner.count, 1.0))
    return bool(rim.stranger_share < _CLEAN_RIM_SHARE and abs(rim.mean_mm - inner.mean_mm) < _RIM_AGREES * error)


def _weighing(faces: Sequence[FaceFit]) -> tuple[list[Moments], list[float]]:
    """Moments of the used faces and their 1 / sigma^2."""
    used = [face for face in faces if face.used and face.moments is not None]
    return [face.moments for face in used if face.moments is not None], [face.mixture.sigma_mm**-2 for face in used]


def _summed(faces: Sequence[FaceFit], pose: Array, centre: Array, lever: float, sigma: float,
            passes: int) -> Estimate:
    """Covariance of the M-estimator, A^-1 B A^-1 with the expected slopes and squares of the weight functions.

    Source: Huber & Ronchetti, Robust Statistics (2009), section 6.3.
    """
    slope, square, plain = np.zeros((6, 6)), np.zeros((6, 6)), np.zeros((6, 6))
    total, sum_squares = 0.0, 0.0
    for face in faces:
        if not face.used or face.moments is None:
            continue
        part = face.moments.normal_equations(pose)[0] / face.mixture.sigma_mm**2
        shares = [(float(face.weights[mask].sum()), mixture.efficiency()) for mask, mixture in face.parts
                  if face.weights[mask].any()]
        weight = sum(share for share, _ in shares)
        for share, (mean_weight, mean_slope, mean_square) in shares:
            slope += part * (share / weight * mean_slope / mean_weight)
            square += part * (share / weight * mean_square / mean_weight)
        plain += part
        total += weight
        sum_squares += float(face.weights @ face.distances_mm**2)
    inverse_slope = _inverse(slope, lever)
    return Estimate(pose, inverse_slope @ square @ inverse_slope, plain, centre, lever, tuple(faces), sigma,
                    float(np.sqrt(sum_squares / total)), total, passes)


def _inverse(matrix: Array, lever: float) -> Array:
    """Inverse of a (6, 6) information matrix in scaled unknowns; directions not seen at all get a huge variance."""
    units = np.array([1.0 / lever] * 3 + [1.0] * 3)
    values, vectors = np.linalg.eigh(matrix * np.outer(units, units))
    values = np.maximum(values, 1e-14 * values[-1])
    return np.asarray((units[:, None] * vectors / values) @ (units[:, None] * vectors).T)


def _at_odds(result: Estimate) -> tuple[FaceFit, str] | None:
    """The face that contradicts the others most, with a note; None where none does or few are left."""
    used = result.used
    if len(used) < 4:
        return None
    worst: tuple[float, FaceFit, float] | None = None
    for face, (mean, error) in zip(used, held_out_means(result), strict=True):
        tolerance = max(_AT_ODDS_ERRORS * error, _AT_ODDS_SIGMAS * result.sigma_mm, _AT_ODDS_LEAST_MM)
        if abs(mean) > tolerance and (worst is None or abs(mean) / tolerance > worst[0]):
            worst = (abs(mean) / tolerance, face, mean)
    if worst is None:
        return None
    return worst[1], f"its points lie {worst[2]:+.3f} mm off the surface that the other faces give"
