"""Which further pose would help the base fit most."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike, NDArray

from core.base.solve import UNKNOWNS, BaseFit
from core.errors import InputError
from core.flange_poses import checked_flange_poses
from core.frames import skew

Array = NDArray[np.float64]


@dataclass(frozen=True)
class PoseGain:
    """What each candidate pose would bring, in the order in which the candidates were given.

    Attributes:
        d_gain: (K,) growth of the log-determinant of the information on all nine unknowns.
        a_gain: (K,) share, 0 to 1, by which the mean variance of a point carried to the base at the lever arm of the
            data would shrink.
        by_d: (K,) candidate indices, best D-gain first.
        by_a: (K,) candidate indices, best A-gain first.
    """

    d_gain: Array
    a_gain: Array
    by_d: NDArray[np.int64]
    by_a: NDArray[np.int64]


def suggest_next_pose(fit: BaseFit, candidate_base_from_flange: ArrayLike) -> PoseGain:
    """Rank reachable poses by how much one more ball seen there would sharpen the fit.

    One observation with Jacobian J and noise S turns the covariance C into `C - C J^T (S + J C J^T)^-1 J C`
    (matrix inversion lemma); D-optimality looks at its determinant, A-optimality at the trace of the pose part
    (Pukelsheim, Optimal Design of Experiments, ch. 6). S is the mean noise of the fit's own observations.

    Args:
        fit: The fit so far.
        candidate_base_from_flange: (K, 4, 4), K >= 1, mm.

    Raises:
        InputError: candidates are not rigid transforms in mm.
    """
    candidates = checked_flange_poses(candidate_base_from_flange)
    if not len(candidates):
        raise InputError("candidate_base_from_flange: give at least one pose.")
    noise = fit.observation_covariance_mm2.mean(axis=0)
    ball = candidates[:, :3, :3] @ fit.ball_in_flange_mm + candidates[:, :3, 3]
    jacobian = np.empty((len(candidates), 3, UNKNOWNS))
    jacobian[:, :, :3] = skew(ball - fit.covariance.about_mm)
    jacobian[:, :, 3:6] = -np.eye(3)
    jacobian[:, :, 6:] = candidates[:, :3, :3]
    known = jacobian @ fit.joint_covariance
    innovation = noise + known @ np.swapaxes(jacobian, 1, 2)
    d_gain = np.linalg.slogdet(innovation)[1] - np.linalg.slogdet(noise)[1]
    less = np.swapaxes(known, 1, 2) @ np.linalg.solve(innovation, known)
    scale = np.array([fit.lever_arm_mm**2] * 3 + [1.0] * 3 + [0.0] * 3)
    shrink = np.einsum("kii,i->k", less, scale) / float(np.diag(fit.joint_covariance) @ scale)
    return PoseGain(np.asarray(d_gain), shrink, np.argsort(-d_gain), np.argsort(-shrink))
