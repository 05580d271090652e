"""Base: the paper's golden numbers, truth against estimate, and the global start."""

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from numpy.typing import NDArray
from scipy.spatial.transform import Rotation

from core.base import BaseLimits, judge_base, solve_base, suggest_next_pose
from core.errors import InputError
from core.verdict import Code

Array = NDArray[np.float64]


def turn(axis: str, degrees: float) -> Array:
    return Rotation.from_euler(axis, degrees, degrees=True).as_matrix()


def pose(rotation: Array, position: Array) -> Array:
    matrix = np.eye(4)
    matrix[:3, :3], matrix[:3, 3] = rotation, position
    return matrix


def golden() -> tuple[Array, Array]:
    """The paper's table: one start, three translations, three tilted poses."""
    first = np.array([-1246.0, -1510.0, 965.0])
    poses = [pose(np.eye(3), first + 150.0 * step) for step in np.vstack([np.zeros(3), np.eye(3)])]
    poses.append(pose(turn("X", 5), np.array([-1116.000, -1527.577, 959.514])))
    poses.append(pose(turn("X", -5), np.array([-1266.000, -1383.678, 930.752])))
    poses.append(pose(turn("Z", -5), np.array([-1251.292, -1523.132, 1095.000])))
    balls = [
        (20.006, 20.000, 19.994),
        (169.960, 22.618, 17.376),
        (17.434, 169.955, 22.611),
        (22.669, 17.428, 169.948),
        (149.954, 2.617, -2.618),
        (-2.572, 149.955, 2.617),
        (2.663, -2.572, 149.954),
    ]
    return np.array(poses), np.array(balls)


def simulate(
    rng: np.random.Generator, n: int, *, tilt_rad: float = 0.4, sigma_mm: float = 0.0
) -> tuple[Array, Array, Array, Array]:
    """Poses, balls in M, true base_from_measure and true ball offset, from the physics alone."""
    truth = pose(Rotation.random(random_state=rng).as_matrix(), rng.uniform(-1500.0, 1500.0, 3))
    ball = rng.uniform(-200.0, 200.0, 3)
    centre = Rotation.random(random_state=rng)
    poses, seen = [], []
    for _ in range(n):
        rotation = (Rotation.from_rotvec(rng.uniform(-tilt_rad, tilt_rad, 3)) * centre).as_matrix()
        in_measure = rng.uniform(-120.0, 120.0, 3)
        in_base = truth[:3, :3] @ in_measure + truth[:3, 3]
        poses.append(pose(rotation, in_base - rotation @ ball))
        seen.append(in_measure + rng.normal(0.0, 1.0, 3) * sigma_mm)
    return np.array(poses), np.array(seen), truth, ball


def angle_between(a: Array, b: Array) -> float:
    return float(Rotation.from_matrix(a[:3, :3] @ b[:3, :3].T).magnitude())


def test_golden_table_of_the_paper() -> None:
    fit = solve_base(*golden())
    measure_from_base = turn("Z", 1) @ turn("Y", 1) @ turn("X", 1)
    assert np.degrees(angle_between(fit.base_from_measure[:3, :3].T, measure_from_base)) < 0.001
    np.testing.assert_allclose(fit.base_from_measure[:3, 3], [-1180.0, -1695.0, 980.0], atol=0.02)
    np.testing.assert_allclose(fit.ball_in_flange_mm, [86.0, -165.0, 35.0], atol=0.02)
    assert fit.rms_mm < 0.0005
    assert judge_base(fit).ok


def test_golden_table_with_its_repeated_first_pose_counts_it_once() -> None:
    poses, balls = golden()
    fit = solve_base(np.insert(poses, 4, poses[0], axis=0), np.insert(balls, 4, balls[0], axis=0))
    assert fit.different_poses == 7
    np.testing.assert_allclose(fit.base_from_measure[:3, 3], [-1180.0, -1695.0, 980.0], atol=0.02)


def test_golden_rotation_about_z_is_the_only_witness_of_the_offset_along_x() -> None:
    fit = solve_base(*golden())
    assert fit.unchecked_directions.tolist() == [0, 0, 0, 0, 0, 0, 1]
    assert "ball offset along flange (0.99" in fit.conditioning.description
    verdict = judge_base(fit, BaseLimits(unchecked_observations=0))
    assert [reason.code for reason in verdict.reasons] == [Code.NO_REDUNDANCY]


@settings(derandomize=True, deadline=None, max_examples=25)
@given(st.integers(0, 10**6), st.integers(4, 9), st.floats(0.1, 2.5))
def test_exact_data_give_the_truth_from_any_rotation(seed: int, n: int, tilt: float) -> None:
    poses, balls, truth, ball = simulate(np.random.default_rng(seed), n, tilt_rad=tilt)
    fit = solve_base(poses, balls)
    assert angle_between(fit.base_from_measure, truth) < 1e-6
    np.testing.assert_allclose(fit.base_from_measure[:3, 3], truth[:3, 3], atol=1e-3)
    np.testing.assert_allclose(fit.ball_in_flange_mm, ball, atol=1e-3)


@pytest.mark.parametrize("n", [4, 5, 8])
def test_noisy_data_stay_within_their_own_covariance(n: int) -> None:
    rng = np.random.default_rng(n)
    worst = 0.0
    for _ in range(30):
        poses, balls, truth, _ball = simulate(rng, n, sigma_mm=0.1)
        fit = solve_base(poses, balls, robot_sigma_mm=0.1)
        error = fit.base_from_measure @ np.linalg.inv(truth)
        about = fit.covariance.about_mm
        xi = np.concatenate(
            [Rotation.from_matrix(error[:3, :3]).as_rotvec(), error[:3, :3] @ about + error[:3, 3] - about]
        )
        worst = max(worst, float(xi @ np.linalg.solve(fit.covariance.matrix, xi)))
    assert worst < 27.9  # chi2 with 6 degrees of freedom, one in 10^4


def test_result_does_not_depend_on_the_order_of_the_observations() -> None:
    poses, balls, _, _ = simulate(np.random.default_rng(5), 8, sigma_mm=0.2)
    order = np.random.default_rng(6).permutation(8)
    one, two = solve_base(poses, balls), solve_base(poses[order], balls[order])
    np.testing.assert_allclose(one.base_from_measure, two.base_from_measure, atol=1e-7)
    np.testing.assert_allclose(one.leave_one_out_mm[order], two.leave_one_out_mm, rtol=1e-6)


def test_scale_of_the_noise_is_estimated_when_not_given() -> None:
    sigmas = []
    for seed in range(40):
        poses, balls, _, _ = simulate(np.random.default_rng(seed), 10, sigma_mm=0.2)
        sigmas.append(solve_base(poses, balls).robot_sigma_mm)
    assert np.mean(sigmas) == pytest.approx(0.2, rel=0.05)


def test_ball_covariances_weigh_and_leave_the_rest_to_the_robot() -> None:
    rng = np.random.default_rng(8)
    weighted, plain, robot = [], [], []
    for _ in range(30):
        poses, balls, truth, _ = simulate(rng, 12)
        spread = np.where(np.arange(12) % 2, 0.01, 1.0)
        noisy = balls + rng.normal(0.0, 1.0, (12, 3)) * spread[:, None] + rng.normal(0.0, 0.05, (12, 3))
        covariance = spread[:, None, None] ** 2 * np.eye(3)
        fit = solve_base(poses, noisy, ball_covariance_mm2=covariance)
        weighted.append(angle_between(fit.base_from_measure, truth))
        plain.append(angle_between(solve_base(poses, noisy).base_from_measure, truth))
        robot.append(fit.robot_sigma_mm)
    assert np.mean(weighted) < 0.4 * np.mean(plain)
    assert 0.03 < np.median(robot) < 0.07


def test_leave_one_out_agrees_with_fitting_without_that_pose() -> None:
    poses, balls, _, _ = simulate(np.random.default_rng(9), 8, sigma_mm=0.2)
    fit = solve_base(poses, balls, robot_sigma_mm=0.2)
    for i in range(8):
        rest = solve_base(np.delete(poses, i, axis=0), np.delete(balls, i, axis=0), robot_sigma_mm=0.2)
        ball = poses[i, :3, :3] @ rest.ball_in_flange_mm + poses[i, :3, 3]
        seen = rest.base_from_measure[:3, :3] @ balls[i] + rest.base_from_measure[:3, 3]
        assert fit.leave_one_out_mm[i] == pytest.approx(np.linalg.norm(ball - seen), rel=0.03)


def test_one_shifted_ball_is_rejected_and_named() -> None:
    poses, balls, _, _ = simulate(np.random.default_rng(10), 10, sigma_mm=0.05)
    balls[3] += [2.5, 0.0, 0.0]
    verdict = judge_base(solve_base(poses, balls))
    assert not verdict.ok
    held_out = [reason for reason in verdict.reasons if reason.code is Code.HELD_OUT_ERROR]
    assert held_out and "observation 3 " in held_out[0].message


def test_good_cell_with_tenths_of_robot_error_is_accepted() -> None:
    poses, balls, _, _ = simulate(np.random.default_rng(11), 10, sigma_mm=0.2)
    assert judge_base(solve_base(poses, balls)).ok


def test_four_poses_are_computed_but_not_accepted() -> None:
    poses, balls, _, _ = simulate(np.random.default_rng(12), 4, sigma_mm=0.01)
    codes = {reason.code for reason in judge_base(solve_base(poses, balls)).reasons}
    assert Code.NO_REDUNDANCY in codes


def test_small_tilts_are_judged_uncertain() -> None:
    poses, balls, _, _ = simulate(np.random.default_rng(13), 8, tilt_rad=0.04, sigma_mm=0.2)
    fit = solve_base(poses, balls)
    codes = {reason.code for reason in judge_base(fit).reasons}
    assert Code.HIGH_UNCERTAINTY in codes
    assert "ball offset" in fit.conditioning.description


def test_suggested_pose_keeps_its_promise() -> None:
    rng = np.random.default_rng(14)
    poses, balls, truth, ball = simulate(rng, 6, sigma_mm=0.1)
    fit = solve_base(poses, balls, robot_sigma_mm=0.1)
    candidates = []
    for degrees in (0.0, 10.0, 40.0):
        rotation = turn("Y", degrees) @ poses[0, :3, :3]
        candidates.append(pose(rotation, poses[0, :3, :3] @ ball + poses[0, :3, 3] - rotation @ ball))
    gain = suggest_next_pose(fit, candidates)
    assert gain.by_d[0] == gain.by_a[0] == 2
    for i, candidate in enumerate(candidates):
        in_base = candidate[:3, :3] @ ball + candidate[:3, 3]
        more = np.vstack([balls, truth[:3, :3].T @ (in_base - truth[:3, 3])])
        after = solve_base(np.append(poses, [candidate], axis=0), more, robot_sigma_mm=0.1)
        shrink = np.linalg.slogdet(fit.joint_covariance)[1] - np.linalg.slogdet(after.joint_covariance)[1]
        assert gain.d_gain[i] == pytest.approx(shrink, rel=0.05)


def test_suggestion_needs_candidates() -> None:
    fit = solve_base(*golden())
    with pytest.raises(InputError, match="at least one pose"):
        suggest_next_pose(fit, np.empty((0, 4, 4)))
