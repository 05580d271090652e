"""Base: data that do not determine the answer are refused in words an operator can act on."""

import numpy as np
import pytest
from numpy.typing import NDArray
from scipy.spatial.transform import Rotation

from core.base import solve_base
from core.errors import FitError, InputError
from core.verdict import Code

Array = NDArray[np.float64]


def cell(rotations: Array, balls: Array, offset: tuple[float, float, float] = (86.0, -165.0, 35.0)) -> Array:
    """Flange poses that bring a ball at `offset` to `balls` in M, M standing at a fixed place in the base."""
    turn = Rotation.from_euler("ZYX", [20.0, -10.0, 30.0], degrees=True).as_matrix()
    poses = np.tile(np.eye(4), (len(balls), 1, 1))
    for i, (rotation, ball) in enumerate(zip(rotations, balls, strict=True)):
        poses[i, :3, :3] = rotation
        poses[i, :3, 3] = turn @ ball + [-1180.0, -1695.0, 980.0] - rotation @ np.array(offset)
    return poses


def tilts(n: int, size: float, seed: int = 1) -> Array:
    return Rotation.from_rotvec(np.random.default_rng(seed).uniform(-size, size, (n, 3))).as_matrix()


def balls_in_measure(n: int, seed: int = 2) -> Array:
    return np.random.default_rng(seed).uniform(-100.0, 100.0, (n, 3))


def good(n: int = 8) -> tuple[Array, Array]:
    balls = balls_in_measure(n)
    return cell(tilts(n, 0.3), balls), balls


def test_good_data_are_not_refused() -> None:
    poses, balls = good()
    np.testing.assert_allclose(solve_base(poses, balls).ball_in_flange_mm, [86.0, -165.0, 35.0], atol=1e-6)


@pytest.mark.parametrize("n", [0, 1, 3])
def test_fewer_than_four_poses(n: int) -> None:
    poses, balls = good()
    with pytest.raises(FitError, match="at least 4") as caught:
        solve_base(poses[:n].reshape(-1, 4, 4), balls[:n])
    assert caught.value.code is Code.NOT_ENOUGH_POINTS


def test_repeats_do_not_make_three_poses_four() -> None:
    poses, balls = good()
    index = [0, 1, 2, 0, 1, 2]
    with pytest.raises(FitError, match="repeats count once") as caught:
        solve_base(poses[index], balls[index])
    assert caught.value.code is Code.NOT_ENOUGH_POINTS


def test_static_robot() -> None:
    poses, balls = good()
    with pytest.raises(FitError, match="has not moved") as caught:
        solve_base(poses[[0] * 6], balls[[0] * 6] + np.random.default_rng(0).normal(0.0, 0.03, (6, 3)))
    assert caught.value.code is Code.NOT_ENOUGH_VARIATION


def test_translations_only_even_with_noise() -> None:
    balls = balls_in_measure(8)
    poses = cell(tilts(8, 1e-4), balls)
    with pytest.raises(FitError, match=r"flange orientation never changes.*cannot be told apart") as caught:
        solve_base(poses, balls + np.random.default_rng(0).normal(0.0, 0.05, (8, 3)))
    assert caught.value.code is Code.NOT_ENOUGH_VARIATION


def test_rotations_about_one_axis_name_the_axis() -> None:
    balls = balls_in_measure(8)
    rotations = Rotation.from_rotvec(np.outer(np.linspace(-0.5, 0.5, 8), [0.0, 0.0, 1.0])).as_matrix()
    with pytest.raises(FitError, match=r"one axis only, \(-?0.00, -?0.00, -?1.00\) in the flange") as caught:
        solve_base(cell(rotations, balls), balls)
    assert caught.value.code is Code.NOT_ENOUGH_VARIATION


def test_ball_that_stays_in_place() -> None:
    balls = np.tile([10.0, 20.0, 30.0], (8, 1)) + np.random.default_rng(0).normal(0.0, 0.03, (8, 3))
    with pytest.raises(FitError, match="hardly moved"):
        solve_base(cell(tilts(8, 0.3), balls), balls)


def test_balls_on_one_line() -> None:
    balls = np.outer(np.linspace(-100.0, 100.0, 8), [0.6, 0.8, 0.0])
    with pytest.raises(FitError, match=r"on one line, along .*0.60.*rotation about that line is free"):
        solve_base(cell(tilts(8, 0.3), balls), balls)


@pytest.mark.parametrize("seed", range(5))
def test_line_hidden_by_noise(seed: int) -> None:
    balls = np.outer(np.linspace(-100.0, 100.0, 8), [1.0, 0.0, 0.0])
    noise = np.random.default_rng(seed).normal(0.0, 0.3, (8, 3))
    with pytest.raises(FitError) as caught:
        solve_base(cell(tilts(8, 0.05), balls), balls + noise)
    assert caught.value.code is Code.NOT_ENOUGH_VARIATION


def test_tilts_too_small_for_the_noise_name_the_ball_offset() -> None:
    balls = balls_in_measure(8)
    poses = cell(tilts(8, 0.006), balls)
    with pytest.raises(FitError, match="ball offset along flange") as caught:
        solve_base(poses, balls + np.random.default_rng(1).normal(0.0, 0.5, (8, 3)))
    assert caught.value.code is Code.NOT_ENOUGH_VARIATION


def test_mirrored_balls() -> None:
    poses, balls = good()
    with pytest.raises(InputError, match="look mirrored"):
        solve_base(poses, balls * [1.0, -1.0, 1.0])


def test_inverted_poses() -> None:
    poses, balls = good()
    with pytest.raises(InputError, match="look inverted"):
        solve_base(np.linalg.inv(poses), balls)


def test_transposed_rotations() -> None:
    poses, balls = good()
    poses[:, :3, :3] = np.swapaxes(poses[:, :3, :3], 1, 2).copy()
    with pytest.raises(InputError, match="look transposed"):
        solve_base(poses, balls)


def test_flange_in_metres() -> None:
    poses, balls = good()
    poses[:, :3, 3] /= 1000.0
    with pytest.raises(InputError, match=r"base_from_flange.*metres"):
        solve_base(poses, balls)


def test_balls_in_metres() -> None:
    poses, balls = good()
    with pytest.raises(InputError, match=r"ball_in_measure_mm.*metres"):
        solve_base(poses, balls / 1000.0)


def test_observations_in_the_wrong_order() -> None:
    poses, balls = good()
    with pytest.raises(FitError, match="do not belong together") as caught:
        solve_base(poses, balls[::-1])
    assert caught.value.code is Code.WRONG_MODEL


def test_one_gross_error_is_named() -> None:
    poses, balls = good(9)
    balls[4] += [80.0, -60.0, 0.0]
    with pytest.raises(FitError, match="Without observation 4 "):
        solve_base(poses, balls)


def test_left_handed_and_scaled_matrices_name_the_observation() -> None:
    poses, balls = good()
    mirrored, scaled = poses.copy(), poses.copy()
    mirrored[2, :3, 0] *= -1.0
    scaled[5, :3, :3] *= 1.01
    with pytest.raises(InputError, match=r"observations\[2\].*left-handed"):
        solve_base(mirrored, balls)
    with pytest.raises(InputError, match=r"observations\[5\].*scaled"):
        solve_base(scaled, balls)


def test_numbers_and_shapes() -> None:
    poses, balls = good()
    holed = balls.copy()
    holed[6, 1] = np.nan
    with pytest.raises(InputError, match=r"observations\[6\].ball_in_measure_mm: NaN"):
        solve_base(poses, holed)
    with pytest.raises(InputError, match="8 flange poses but 7 ball centres"):
        solve_base(poses, balls[:7])
    with pytest.raises(InputError, match="found shape"):
        solve_base(poses, balls[:, :2])
    with pytest.raises(InputError, match="found shape"):
        solve_base(poses[0], balls)
    with pytest.raises(InputError, match="three numbers"):
        solve_base(poses, [["a", "b", "c"]] * 8)
    with pytest.raises(InputError, match="4x4 numbers"):
        solve_base([["x"]], balls)


def test_noise_figures_are_checked() -> None:
    poses, balls = good()
    with pytest.raises(InputError, match="robot_sigma_mm"):
        solve_base(poses, balls, robot_sigma_mm=-0.1)
    with pytest.raises(InputError, match="one of them must be above zero"):
        solve_base(poses, balls, robot_sigma_mm=0.0)
    with pytest.raises(InputError, match="expected 8 matrices 3x3"):
        solve_base(poses, balls, ball_covariance_mm2=np.eye(3))
    with pytest.raises(InputError, match="positive definite"):
        solve_base(poses, balls, ball_covariance_mm2=np.tile(np.diag([1.0, 1.0, 0.0]), (8, 1, 1)))
    with pytest.raises(InputError, match="NaN"):
        solve_base(poses, balls, ball_covariance_mm2=np.full((8, 3, 3), np.nan))
