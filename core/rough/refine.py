"""Candidate poses made better and compared: robust point-to-plane alignment on the model's sampled surface; mm, rad."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from core.frames import Array, perturbed, transform_points
from core.robust import tukey_weights
from core.rough.shape import Shape, nearest

# Normals of scan and model that belong together differ by less than about 30 degrees.
NORMAL_AGREEMENT = 0.85
# Farther than this from the nearest sample, a point is past the edge of the face even if it is on its surface.
PAST_EDGE_MM = 1.8
# Near the model but not on it: a wrong model or a wrong pose leaves many such points, a fixture few.
NEAR_MODEL_MM = 5.0


@dataclass(frozen=True)
class Agreement:
    """How well a pose explains a scan.

    Attributes:
        on_surface: Share of the scan's flat points that lie on the model with the right normal.
        of_near: Share of the points within 5 mm of the model that lie on it.
        of_parallel: Share of the points within 5 mm and parallel to the model there that lie on it: a face of another
            blade type is parallel but beside.
        rms_mm: Of the points on the surface.
        on: (n,) which of the compared points lie on the surface.
    """

    on_surface: float
    of_near: float
    of_parallel: float
    rms_mm: float
    on: NDArray[np.bool_]


def refined(work_from_measure: Array, scan: Shape, model: Shape, rows: NDArray[np.int64],
            gates_mm: tuple[float, ...]) -> Array:
    """Point-to-plane ICP with Tukey weights and a gate that narrows from step to step.

    Args:
        work_from_measure: (4, 4) start.
        scan: Points in M.
        model: Points in W.
        rows: Which of the scan's points to use.
        gates_mm: One per iteration: points farther than this from the model don't count.
    """
    pose = work_from_measure
    points, normals = scan.points[rows], scan.normals[rows]
    for gate in gates_mm:
        moved = transform_points(pose, points)
        distance, index = nearest(model.tree, moved, 2.0 * gate)
        reached = np.isfinite(distance)
        moved, index = moved[reached], index[reached]
        normal = model.normals[index]
        offset = np.sum((moved - model.points[index]) * normal, axis=1)
        facing = np.abs(np.sum((normals[reached] @ pose[:3, :3].T) * normal, axis=1)) > NORMAL_AGREEMENT
        weight = np.where(facing, tukey_weights(offset, gate, 1.0), 0.0)
        if np.count_nonzero(weight) < 12:
            return pose
        centre = moved.mean(axis=0)
        jacobian = np.hstack([np.cross(moved - centre, normal), normal])
        weighted = jacobian * weight[:, None]
        information = jacobian.T @ weighted
        # A trace of damping keeps a direction that the points leave free where it is.
        damping = 1e-6 * np.trace(information) * np.eye(6)
        pose = perturbed(pose, -np.linalg.solve(information + damping, weighted.T @ offset), centre)
    return pose


def agreement(work_from_measure: Array, scan: Shape, model: Shape, rows: NDArray[np.int64],
              surface_mm: float) -> Agreement:
    """Compare the scan's points `rows` (flat ones) with the model at a pose; on it means within `surface_mm`."""
    moved = transform_points(work_from_measure, scan.points[rows])
    distance, index = nearest(model.tree, moved, NEAR_MODEL_MM)
    near = np.isfinite(distance)
    offset, parallel = np.full(len(rows), np.inf), np.zeros(len(rows), dtype=bool)
    normal = model.normals[index[near]]
    offset[near] = np.sum((moved[near] - model.points[index[near]]) * normal, axis=1)
    cosine = np.sum((scan.normals[rows][near] @ work_from_measure[:3, :3].T) * normal, axis=1)
    parallel[near] = np.abs(cosine) > NORMAL_AGREEMENT
    on = (np.abs(offset) < surface_mm) & (distance < PAST_EDGE_MM) & parallel
    count = int(np.count_nonzero(on))
    return Agreement(
        on_surface=count / len(rows),
        of_near=count / max(int(np.count_nonzero(near)), 1),
        of_parallel=count / max(int(np.count_nonzero(parallel)), 1),
        rms_mm=float(np.sqrt(np.mean(offset[on] ** 2))) if count else np.inf,
        on=on,
    )


def rough_scores(poses: Array, scan: Shape, model: Shape, rows: NDArray[np.int64], reach_mm: float) -> Array:
    """(K,) mean over the scan's points `rows` of a score that falls from 1 on the model to 0 at `reach_mm`."""
    scores = np.zeros(len(poses))
    for k, pose in enumerate(poses):
        distance, index = nearest(model.tree, transform_points(pose, scan.points[rows]), reach_mm)
        reached = np.isfinite(distance)
        normal = model.normals[index[reached]]
        facing = np.abs(np.sum((scan.normals[rows][reached] @ pose[:3, :3].T) * normal, axis=1)) > NORMAL_AGREEMENT
        scores[k] = float(np.sum((1.0 - (distance[reached] / reach_mm) ** 2)[facing])) / len(rows)
    return scores
