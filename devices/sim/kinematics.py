"""A six-axis arm: forward kinematics (also with wrong geometry, for the true pose) and numeric inverse.

Denavit-Hartenberg in the standard form: T_i = Rot(z, theta) Trans(z, d) Trans(x, a) Rot(x, alpha); the nominal lengths
are those of a UR20, as its maker publishes them.
"""

from __future__ import annotations

from dataclasses import dataclass, replace

import numpy as np
from scipy.spatial.transform import Rotation

from devices.sim.geometry import Array

JOINT_LIMIT_RAD = 2.0 * np.pi
_POSITION_WEIGHT = 1.0 / 500.0  # mm to rad-like numbers, so that both parts of the error weigh alike


@dataclass(frozen=True, eq=False)
class Arm:
    """DH parameters of six joints.

    Attributes:
        d_mm: (6,) offsets along the joint axes.
        a_mm: (6,) link lengths.
        alpha_rad: (6,) twists.
        offset_rad: (6,) joint zero errors, added to the joint angles.
    """

    d_mm: Array
    a_mm: Array
    alpha_rad: Array
    offset_rad: Array

    def frames(self, joints_rad: Array) -> Array:
        """(..., 7, 4, 4): base, then the frame after each joint; the last is base_from_flange."""
        theta = np.asarray(joints_rad, dtype=float) + self.offset_rad
        ct, st = np.cos(theta), np.sin(theta)
        ca, sa = np.cos(self.alpha_rad), np.sin(self.alpha_rad)
        links = np.zeros((*theta.shape, 4, 4))
        links[..., 0, 0], links[..., 0, 1], links[..., 0, 2], links[..., 0, 3] = ct, -st * ca, st * sa, self.a_mm * ct
        links[..., 1, 0], links[..., 1, 1], links[..., 1, 2], links[..., 1, 3] = st, ct * ca, -ct * sa, self.a_mm * st
        links[..., 2, 1], links[..., 2, 2], links[..., 2, 3] = sa, ca, self.d_mm
        links[..., 3, 3] = 1.0
        frames = np.zeros((*theta.shape[:-1], 7, 4, 4))
        frames[..., 0, :, :] = np.eye(4)
        for joint in range(6):
            frames[..., joint + 1, :, :] = frames[..., joint, :, :] @ links[..., joint, :, :]
        return frames

    def forward(self, joints_rad: Array) -> Array:
        """base_from_flange (..., 4, 4) of joint angles (..., 6)."""
        return np.asarray(self.frames(joints_rad)[..., 6, :, :])

    def inverse(self, base_from_flange: Array, seed_rad: Array, iterations: int = 40) -> Array | None:
        """Joint angles (6,) that reach a pose, by damped Newton steps from a seed; None where it does not converge."""
        joints = np.array(seed_rad, dtype=float)
        for _ in range(iterations):
            frames = self.frames(joints)
            tip = frames[6]
            shift = base_from_flange[:3, 3] - tip[:3, 3]
            rotvec = Rotation.from_matrix(base_from_flange[:3, :3] @ tip[:3, :3].T).as_rotvec()
            if np.linalg.norm(shift) < 1e-9 and np.linalg.norm(rotvec) < 1e-12:
                break
            axes, origins = frames[:6, :3, 2], frames[:6, :3, 3]
            jacobian = np.vstack([np.cross(axes, tip[:3, 3] - origins).T * _POSITION_WEIGHT, axes.T])
            error = np.concatenate([shift * _POSITION_WEIGHT, rotvec])
            damping = 1e-3 * min(1.0, float(error @ error))
            step = jacobian.T @ np.linalg.solve(jacobian @ jacobian.T + damping * np.eye(6), error)
            joints = joints + step * min(1.0, 0.6 / max(float(np.abs(step).max()), 1e-300))
        tip = self.forward(joints)
        close = np.linalg.norm(tip[:3, 3] - base_from_flange[:3, 3]) < 1e-6
        return joints if close and np.abs(tip[:3, :3] - base_from_flange[:3, :3]).max() < 1e-8 else None


def nominal_arm() -> Arm:
    """A UR20 as its data sheet describes it."""
    return Arm(
        d_mm=np.array([236.3, 0.0, 0.0, 201.0, 159.3, 154.3]),
        a_mm=np.array([0.0, -862.0, -728.7, 0.0, 0.0, 0.0]),
        alpha_rad=np.array([np.pi / 2, 0.0, 0.0, np.pi / 2, -np.pi / 2, 0.0]),
        offset_rad=np.zeros(6),
    )


def working_joints(rng: np.random.Generator, count: int) -> Array:
    """(count, 6) joint angles spread over the space in front of the arm, where work is done."""
    low = np.deg2rad([-180.0, -130.0, 40.0, -90.0, 30.0, -180.0])
    high = np.deg2rad([180.0, -40.0, 130.0, 90.0, 150.0, 180.0])
    return np.asarray(rng.uniform(low, high, size=(count, 6)))


def imperfect_arm(rng: np.random.Generator, absolute_rms_mm: float) -> Arm:
    """The nominal arm with errors in all lengths, twists and joint zeros, scaled to an RMS position error."""
    nominal = nominal_arm()
    lengths, angles = rng.normal(0.0, 0.1, (2, 6)), rng.normal(0.0, 1e-4, (2, 6))
    joints = working_joints(rng, 400)

    def with_scale(scale: float) -> Arm:
        return replace(
            nominal,
            d_mm=nominal.d_mm + scale * lengths[0],
            a_mm=nominal.a_mm + scale * lengths[1],
            alpha_rad=nominal.alpha_rad + scale * angles[0],
            offset_rad=scale * angles[1],
        )

    error = with_scale(1.0).forward(joints)[:, :3, 3] - nominal.forward(joints)[:, :3, 3]
    rms = float(np.sqrt((error**2).sum(axis=1).mean()))
    return with_scale(absolute_rms_mm / rms)


def reach_joints(arm: Arm, base_from_flange: Array, near_rad: Array) -> Array | None:
    """Joint angles for a pose, each within half a turn of `near_rad` where the joint limits allow it.

    Wherever it can, the arm takes the one branch with the shoulder towards the pose, elbow up and wrist not flipped: a
    pose has the same true error then however the arm came there.

    Returns:
        (6,) rad, or None where no branch reaches the pose.
    """
    azimuth = float(np.arctan2(base_from_flange[1, 3], base_from_flange[0, 3]))
    direct = arm.inverse(base_from_flange, near_rad)
    if direct is not None and _usual(direct, azimuth):
        return _near(direct, near_rad)
    others = [] if direct is None else [direct]
    for wrist_2 in (np.pi / 2, -np.pi / 2):
        for wrist_1 in (-0.3, -1.2, 0.6, -2.4):
            for wrist_3 in (0.0, 2.0, -2.0):
                seed = np.array([azimuth + np.pi, -1.4, 1.6, wrist_1, wrist_2, wrist_3])
                found = arm.inverse(base_from_flange, seed)
                if found is not None and _usual(found, azimuth):
                    return _near(found, near_rad)
                if found is not None:
                    others.append(found)
    wrapped = [joints for joints in (_near(other, near_rad) for other in others) if _within_limits(joints)]
    return min(wrapped, key=lambda joints: float(np.abs(joints - near_rad).max())) if wrapped else None


def _usual(joints: Array, azimuth_rad: float) -> bool:
    """Shoulder towards the pose, elbow up, wrist not flipped."""
    return bool(np.cos(joints[0] - azimuth_rad) < 0.0 and np.sin(joints[2]) > 0.0 and np.sin(joints[4]) > 0.0)


def _within_limits(joints: Array) -> bool:
    return bool(np.abs(joints).max() <= JOINT_LIMIT_RAD)


def _near(joints: Array, near: Array) -> Array:
    """The same arm position with each angle within half a turn of `near` where the joint limits allow it."""
    wrapped = near + np.mod(joints - near + np.pi, 2.0 * np.pi) - np.pi
    wrapped = np.where(wrapped > JOINT_LIMIT_RAD, wrapped - 2.0 * np.pi, wrapped)
    return np.where(wrapped < -JOINT_LIMIT_RAD, wrapped + 2.0 * np.pi, wrapped)
