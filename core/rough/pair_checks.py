"""What picked pairs must fulfil before they are fitted; each refusal says what was found and what to do."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
from numpy.typing import ArrayLike

from core.errors import FitError, InputError
from core.frames import Array
from core.verdict import Code

# Second to first singular value of the centred picks: below this they are "on a line" for the noise of hand picks.
COLLINEAR_RATIO = 0.03
# Picks on a work piece spread over more than this; less is one spot picked several times, or metres.
SMALLEST_SPREAD_MM = 1.0
# Known factors between lengths that differ by the unit only, and how far off they may be.
UNIT_FACTORS = ((1000.0, "metres"), (25.4, "inches"), (10.0, "centimetres"))
UNIT_TOLERANCE = 0.15


def finite_points(points: ArrayLike, field: str) -> Array:
    """(N, 3) float array of what a person or a file supplied.

    Raises:
        InputError: not numbers, not (N, 3), or NaN; the row is named.
    """
    try:
        array = np.asarray(points, dtype=float)
    except (TypeError, ValueError) as error:
        raise InputError(f"{field}: expected rows of three numbers in mm.") from error
    if array.ndim != 2 or array.shape[1] != 3:
        raise InputError(f"{field}: expected rows of three numbers in mm (N x 3), found shape {array.shape}.")
    bad = np.flatnonzero(~np.isfinite(array).all(axis=1))
    if len(bad):
        raise InputError(f"{field}[{bad[0]}]: the point contains NaN or infinite numbers. Pick it again.")
    return array


def pair_names(names: Sequence[str] | None, scan: Array, cad: Array) -> tuple[str, ...]:
    """Names of the pairs, after checking that there are enough pairs and none twice.

    Raises:
        InputError: different numbers of scan picks, CAD picks and names, or a pair entered twice.
        FitError: fewer than three pairs.
    """
    if len(scan) != len(cad):
        raise InputError(f"There are {len(scan)} picks on the scan and {len(cad)} on the CAD model; each pair needs "
                         "both.")
    if names is not None and len(names) != len(scan):
        raise InputError(f"There are {len(names)} names for {len(scan)} pairs; each pair needs one.")
    labels = tuple(f"pair {i + 1}" for i in range(len(scan))) if names is None else tuple(str(name) for name in names)
    if len(scan) < 3:
        raise FitError(f"Found {len(scan)} pairs; a pose needs at least 3 that don't lie on a line. Pick 5 or more.",
                       Code.NOT_ENOUGH_POINTS)
    both = np.hstack([scan, cad])
    for i, j in zip(*np.triu_indices(len(both), 1), strict=True):
        if np.array_equal(both[i], both[j]):
            raise InputError(f"Pairs '{labels[i]}' and '{labels[j]}' are the same pick entered twice. Remove one "
                             "of them.")
    return labels


def check_units(scan: Array, cad: Array) -> None:
    """Distances between picks must agree between the two sets; the median over all of them survives a bad pick.

    Raises:
        InputError: one set, or both, is in another unit than mm.
    """
    first, second = np.triu_indices(len(scan), 1)
    scan_lengths = np.linalg.norm(scan[first] - scan[second], axis=1)
    cad_lengths = np.linalg.norm(cad[first] - cad[second], axis=1)
    usable = (scan_lengths > 0.0) & (cad_lengths > 0.0)
    if not np.any(usable):
        return
    ratio = float(np.median(scan_lengths[usable] / cad_lengths[usable]))
    for factor, unit in UNIT_FACTORS:
        for which, value in (("on the CAD model", ratio), ("on the scan", 1.0 / ratio)):
            if abs(value / factor - 1.0) < UNIT_TOLERANCE:
                raise InputError(f"The picks {which} look like {unit}: distances between them are {value:.4g} times "
                                 "smaller there than in the other set. Give both in mm.")
    if max(np.ptp(scan, axis=0).max(), np.ptp(cad, axis=0).max()) < SMALLEST_SPREAD_MM:
        raise InputError(f"All picks lie within {np.ptp(cad, axis=0).max():.3g} mm, on the scan and on the CAD model. "
                         "They look like metres; give both in mm.")


def check_spread(points: Array, where: str, sigma_mm: float | None) -> None:
    """The picks must span a plane.

    Args:
        points: (N, 3) mm.
        where: For the message, e.g. `on the scan`.
        sigma_mm: Known noise of a pick, which a line's thickness must exceed clearly.

    Raises:
        FitError: the picks coincide or lie on a line within what picking can resolve.
    """
    centred = points - points.mean(axis=0)
    _, values, directions = np.linalg.svd(centred, full_matrices=False)
    rms = values / np.sqrt(len(points))
    if rms[0] < 0.5 * SMALLEST_SPREAD_MM:
        raise FitError(f"The picks {where} all lie within {2 * rms[0]:.2g} mm of each other. Pick points that are "
                       "spread over the whole blade.", Code.NOT_ENOUGH_VARIATION)
    if rms[1] < max(COLLINEAR_RATIO * rms[0], 3.0 * (sigma_mm or 0.0)):
        axis = ", ".join(f"{value:.2f}" for value in directions[0] + 0.0)
        raise FitError(f"The picks {where} lie on a line along ({axis}): {rms[1]:.2g} mm RMS off it over a length of "
                       f"{np.ptp(centred @ directions[0]):.3g} mm, so the rotation about that line is not determined. "
                       "Pick at least one point well off the line.", Code.NOT_ENOUGH_VARIATION)
