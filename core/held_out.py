"""Errors at observations that the fit has not seen, without fitting again."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray
from scipy.stats import f as fisher

Array = NDArray[np.float64]

# Below this share left over, the others predict that direction of an observation 30 times worse than it is measured:
# it is the only witness there, and its error would be noise blown up.
_SOLE_WITNESS = 1e-3
# Chance per fit that a good observation is called bad.
FALSE_ALARM = 1e-3


def held_out_residuals(
    jacobian: Array, weights: Array, cofactor: Array, residuals: Array, groups: NDArray[np.int64]
) -> tuple[Array, NDArray[np.int64]]:
    """Residuals that a weighted least-squares fit leaves at observations it was not given.

    The identity `e = (I - J C J^T W)^-1 r` for each group left out (Cook & Weisberg, Residuals and Influence in
    Regression, 1982, eq. 2.2.7, in blocks); exact for a linear model, first order for a nonlinear one.

    Args:
        jacobian: (N, k, p) derivative of each residual by the unknowns.
        weights: (N, k, k) inverse covariance of each residual.
        cofactor: (p, p) inverse of the sum of J^T W J.
        residuals: (N, k) residuals of the full fit.
        groups: (N,) equal numbers are left out together (repeats of one pose).

    Returns:
        (N, k) in the unit of the residuals, without the directions that the others cannot predict, NaN if they predict
        none; and (N,) the number of those unpredicted directions in the observation's group.
    """
    k = residuals.shape[1]
    errors = np.full(residuals.shape, np.nan)
    unpredicted = np.zeros(len(residuals), dtype=np.int64)
    for group in np.unique(groups):
        index = np.flatnonzero(groups == group)
        root = np.zeros((len(index) * k, len(index) * k))
        for block, i in enumerate(index):
            part = slice(block * k, (block + 1) * k)
            root[part, part] = np.linalg.cholesky(weights[i]).T
        white = root @ jacobian[index].reshape(len(root), -1)
        left_over, directions = np.linalg.eigh(np.eye(len(root)) - white @ cofactor @ white.T)
        seen = left_over > _SOLE_WITNESS
        unpredicted[index] = np.count_nonzero(~seen)
        if not np.any(seen):
            continue
        along = directions[:, seen]
        whitened = along @ ((along.T @ (root @ residuals[index].ravel())) / left_over[seen])
        errors[index] = np.linalg.solve(root, whitened).reshape(-1, k)
    return errors, unpredicted


def odd_one_out(drops: Array, squares: float, redundancy: int, size: int = 3) -> int | None:
    """The observation that all others contradict, if there is one.

    F test of the deletion (Cook & Weisberg 1982, sec. 2.2.2) against the noise that is left without it, Bonferroni over
    the observations: a slip shows even where it stays within limits wide enough for a
    robot.

    Args:
        drops: (N,) by how much the weighted squares fall when the observation is left out.
        squares: Weighted sum of squares of all.
        redundancy: Number of equations beyond the number of unknowns.
        size: Equations of one observation.

    Returns:
        Its index, or None.
    """
    left = redundancy - size
    worst = int(np.argmax(drops))
    drop = float(drops[worst])
    if left <= 0 or not drop > 0.0:
        return None
    variance = max(squares - drop, 0.0) / left
    odd = drop > size * float(fisher.isf(FALSE_ALARM / len(drops), size, left)) * variance
    return worst if odd else None
