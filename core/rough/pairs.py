"""Scan to CAD from picked point pairs: rigid Kabsch fit, residuals, and which pick is the bad one; mm and rad."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike
from scipy.stats import f as f_distribution

from core.conditioning import Conditioning, analyse_pose
from core.errors import FitError, InputError
from core.frames import Array, PoseCovariance, nearest_rotation, rigid, skew, transform_points
from core.rough.pair_checks import check_spread, check_units, finite_points, pair_names
from core.verdict import Code

# A proper fit this many times worse than the mirrored one means mirrored picks and not noise.
MIRROR_RATIO = 3.0
# ... unless it is already good in relation to the size of the picked figure.
MIRROR_FLOOR = 0.02
# Probability, corrected for the number of pairs, below which a pick stands out from the others.
CLEAR_PROBABILITY = 0.02
# Rounding floor of a sum of squares, mm^2: exact picks shall not be "bad" in the twelfth decimal.
ROUNDING_MM2 = 1e-12


@dataclass(frozen=True, eq=False)
class PairsFit:
    """Pose of the work in the measurement frame from N picked pairs.

    Attributes:
        measure_from_work: (4, 4).
        covariance: Of the pose error in M about the centroid of the picks.
        names: N names of the pairs.
        residuals_mm: (N, 3) scan pick minus carried CAD pick, dX dY dZ in M.
        distances_mm: (N,) lengths of the residuals.
        rms_mm: Root mean square of the distances.
        sigma_mm: Standard deviation per coordinate of a pick: the given one, else from the residuals (3N - 6 degrees).
        leave_one_out_mm: (N,) distance of each pick from where the other pairs put it; NaN where they don't fix a pose.
        others_rms_mm: (N,) RMS distance that the other pairs keep when this one is left out; NaN as above.
        worst: Name of the pair that disagrees most with the others.
        worst_is_clear: The disagreement is more than chance (F test, corrected for the choice among N).
        redundancy: 3N - 6; with 3 pairs no pick can be checked by the others.
        conditioning: Which movement the picks determine least.
    """

    measure_from_work: Array
    covariance: PoseCovariance
    names: tuple[str, ...]
    residuals_mm: Array
    distances_mm: Array
    rms_mm: float
    sigma_mm: float
    leave_one_out_mm: Array
    others_rms_mm: Array
    worst: str
    worst_is_clear: bool
    redundancy: int
    conditioning: Conditioning

    @property
    def remarks(self) -> tuple[str, ...]:
        """What the numbers can't tell, in sentences for the operator."""
        if len(self.names) == 3:
            return ("3 pairs fix the pose but leave no pair over to check it: a bad pick shows only in the distances "
                    "between the picks. Pick 5 or more pairs.",)
        if not np.all(np.isfinite(self.leave_one_out_mm)):
            alone = [name for name, value in zip(self.names, self.leave_one_out_mm, strict=True) if np.isnan(value)]
            return (f"Without {_quoted(alone)} the other picks lie on a line, so nothing checks it: pick one more pair "
                    "away from that line.",)
        return ()


def solve_pairs(scan_mm: ArrayLike, cad_mm: ArrayLike, *, names: Sequence[str] | None = None,
                sigma_mm: float | None = None) -> PairsFit:
    """Least-squares rigid motion that carries picked CAD points onto the same points picked on the scan.

    Rotation from the singular value decomposition of the cross-covariance (Kabsch 1976; Umeyama 1991 without scale).

    Args:
        scan_mm: (N, 3) picks on the scan, frame M, N >= 3.
        cad_mm: (N, 3) the same picks on the CAD model, frame W.
        names: N names for messages; `pair 1`... if missing.
        sigma_mm: Known standard deviation per coordinate of a pair (scan pick and CAD pick together).

    Raises:
        InputError: wrong shape, NaN, different numbers of picks, a pair entered twice, metres or inches in a set.
        FitError: too few, coincident or collinear picks, or a mirrored set.
    """
    scan, cad = finite_points(scan_mm, "scan_mm"), finite_points(cad_mm, "cad_mm")
    labels = pair_names(names, scan, cad)
    if sigma_mm is not None and not (np.isfinite(sigma_mm) and sigma_mm > 0.0):
        raise InputError(f"sigma_mm: expected a positive number, found {sigma_mm}.")
    check_units(scan, cad)
    check_spread(cad, "on the CAD model", sigma_mm)
    check_spread(scan, "on the scan", sigma_mm)
    pose = kabsch(scan, cad)
    residuals = scan - transform_points(pose, cad)
    squares = float(np.sum(residuals**2))
    left_out, others_squares = _leave_one_out(scan, cad)
    _check_mirrored(scan, cad, squares, others_squares)
    redundancy = 3 * len(scan) - 6
    sigma = float(sigma_mm) if sigma_mm is not None else float(np.sqrt(squares / redundancy))
    information, centre = _information(scan - residuals)
    lever = float(np.sqrt(np.mean(np.sum((scan - residuals - centre) ** 2, axis=1))))
    worst, clear = _worst(np.linalg.norm(residuals, axis=1), squares, others_squares)
    return PairsFit(
        measure_from_work=pose,
        covariance=PoseCovariance(np.asarray(sigma**2 * np.linalg.inv(information)), centre),
        names=labels,
        residuals_mm=residuals,
        distances_mm=np.linalg.norm(residuals, axis=1),
        rms_mm=float(np.sqrt(squares / len(scan))),
        sigma_mm=sigma,
        leave_one_out_mm=left_out,
        others_rms_mm=np.sqrt(others_squares / (len(scan) - 1)),
        worst=labels[worst],
        worst_is_clear=clear,
        redundancy=redundancy,
        conditioning=analyse_pose(information, lever),
    )


def kabsch(target: Array, source: Array) -> Array:
    """(4, 4) target_from_source of paired points (N, 3), least squares, no scale, no reflection."""
    target_centre, source_centre = target.mean(axis=0), source.mean(axis=0)
    rotation = nearest_rotation((target - target_centre).T @ (source - source_centre))
    return rigid(rotation, target_centre - rotation @ source_centre)


def _information(points: Array) -> tuple[Array, Array]:
    """(6, 6) J^T J about the centroid of carried picks (N, 3), and the centroid; covariance = sigma^2 / (J^T J).

    A pose error moves a pick by `r x (p - c) + t`, so J = [-[p - c]x, I].
    """
    centre = points.mean(axis=0)
    jacobian = np.concatenate([-skew(points - centre), np.broadcast_to(np.eye(3), (len(points), 3, 3))], axis=2)
    return np.asarray(np.einsum("nki,nkj->ij", jacobian, jacobian)), np.asarray(centre)


def _leave_one_out(scan: Array, cad: Array) -> tuple[Array, Array]:
    """Prediction error of each pair by the others, and the others' sum of squares; NaN where they don't fix a pose."""
    errors, squares = np.full(len(scan), np.nan), np.full(len(scan), np.nan)
    if len(scan) == 3:
        return errors, squares
    for i in range(len(scan)):
        others = np.arange(len(scan)) != i
        try:
            check_spread(cad[others], "on the CAD model", None)
            check_spread(scan[others], "on the scan", None)
        except FitError:
            continue
        pose = kabsch(scan[others], cad[others])
        errors[i] = np.linalg.norm(scan[i] - transform_points(pose, cad[i]))
        squares[i] = np.sum((scan[others] - transform_points(pose, cad[others])) ** 2)
    return errors, squares


def _worst(distances: Array, squares: float, others_squares: Array) -> tuple[int, bool]:
    """Index of the pair whose removal helps most, and whether that is more than chance.

    F test of three shift parameters for one pair: ((S - S_i) / 3) / (S_i / (3 (N - 1) - 6)), Bonferroni over N.
    """
    count = len(distances)
    if not np.any(np.isfinite(others_squares)):
        return int(np.argmax(distances)), False
    worst = int(np.nanargmin(others_squares))
    remaining = 3 * (count - 1) - 6
    rest = max(float(others_squares[worst]), ROUNDING_MM2)
    gain = max(squares - rest, 0.0)
    if gain < ROUNDING_MM2:
        return int(np.argmax(distances)), False
    probability = count * float(f_distribution.sf((gain / 3.0) / (rest / remaining), 3, remaining))
    return worst, probability < CLEAR_PROBABILITY


def _check_mirrored(scan: Array, cad: Array, squares: float, others_squares: Array) -> None:
    """A reflection that fits far better than any rotation means that left and right were exchanged."""
    count = len(scan)
    mirrored = cad * np.array([-1.0, 1.0, 1.0])
    reflected_squares = float(np.sum((scan - transform_points(kabsch(scan, mirrored), mirrored)) ** 2))
    size = float(np.sum((cad - cad.mean(axis=0)) ** 2))
    far_better = squares > MIRROR_RATIO**2 * reflected_squares and squares > MIRROR_FLOOR**2 * size
    # From 5 pairs on, one bad pick that explains everything is the simpler story.
    explained = count > 4 and np.nanmin(others_squares, initial=np.inf) < MIRROR_RATIO**2 * reflected_squares
    if far_better and not explained:
        raise FitError(
            f"The picks are a mirror image of each other: {np.sqrt(reflected_squares / count):.2g} mm RMS if one set "
            f"is reflected, {np.sqrt(squares / count):.3g} mm if it is not. Check that left and right (or a sign) "
            "are the same on the scan and on the CAD model, and pick again.", Code.WRONG_MODEL)


def _quoted(names: Sequence[str]) -> str:
    return ", ".join(f"'{name}'" for name in names)
