"""Stylus: truth against estimate, refusals, bad touches."""

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from numpy.typing import NDArray
from scipy.spatial.transform import Rotation

from core.errors import FitError, InputError
from core.tool import StylusLimits, judge_stylus, solve_stylus
from core.verdict import Code

Array = NDArray[np.float64]

TIP = np.array([12.0, -8.0, 160.0])
PIVOT = np.array([-900.0, 350.0, 410.0])


def touches(turns: Array, noise: Array | float = 0.0) -> Array:
    """Flange poses whose tip rests at PIVOT."""
    poses = np.tile(np.eye(4), (len(turns), 1, 1))
    poses[:, :3, :3] = turns
    poses[:, :3, 3] = PIVOT - turns @ TIP + noise
    return poses


def tilts(n: int, size: float, seed: int = 1) -> Array:
    rng = np.random.default_rng(seed)
    down = Rotation.from_euler("X", 180.0, degrees=True)
    return (Rotation.from_rotvec(rng.uniform(-size, size, (n, 3))) * down).as_matrix()


@settings(derandomize=True, deadline=None, max_examples=25)
@given(st.integers(0, 10**6), st.integers(3, 10), st.floats(0.1, 2.5))
def test_exact_touches_give_the_truth(seed: int, n: int, size: float) -> None:
    fit = solve_stylus(touches(tilts(n, size, seed)))
    np.testing.assert_allclose(fit.tip_in_flange_mm, TIP, atol=1e-7)
    np.testing.assert_allclose(fit.pivot_in_base_mm, PIVOT, atol=1e-7)
    assert fit.rms_mm < 1e-9


def test_noisy_touches_stay_within_their_covariance() -> None:
    rng = np.random.default_rng(3)
    tip, pivot = [], []
    for seed in range(60):
        fit = solve_stylus(touches(tilts(8, 0.4, seed), rng.normal(0.0, 0.05, (8, 3))), sigma_mm=0.05)
        for error, covariance, out in (
            (fit.tip_in_flange_mm - TIP, fit.tip_covariance_mm2, tip),
            (fit.pivot_in_base_mm - PIVOT, fit.pivot_covariance_mm2, pivot),
        ):
            out.append(error @ np.linalg.solve(covariance, error) / 3.0)
    # 180 degrees of freedom: the mean has a standard deviation of 0.105.
    assert np.mean(tip) == pytest.approx(1.0, abs=0.32)
    assert np.mean(pivot) == pytest.approx(1.0, abs=0.32)


def test_noise_is_estimated_when_not_given() -> None:
    rng = np.random.default_rng(4)
    squares = [
        solve_stylus(touches(tilts(10, 0.5, seed), rng.normal(0.0, 0.08, (10, 3)))).sigma_mm ** 2 for seed in range(60)
    ]
    assert np.sqrt(np.mean(squares)) == pytest.approx(0.08, rel=0.08)


def test_held_out_error_is_that_of_a_fit_without_the_touch() -> None:
    poses = touches(tilts(7, 0.4), np.random.default_rng(5).normal(0.0, 0.1, (7, 3)))
    fit = solve_stylus(poses)
    for i in range(7):
        rest = solve_stylus(np.delete(poses, i, axis=0))
        miss = poses[i, :3, :3] @ rest.tip_in_flange_mm + poses[i, :3, 3] - rest.pivot_in_base_mm
        assert fit.leave_one_out_mm[i] == pytest.approx(np.linalg.norm(miss), rel=1e-6)


def test_good_touches_are_accepted_and_the_spread_is_reported() -> None:
    turns = tilts(8, 0.5)
    fit = solve_stylus(touches(turns, np.random.default_rng(6).normal(0.0, 0.05, (8, 3))))
    largest = max(
        Rotation.from_matrix(turns[i] @ turns[j].T).magnitude() for i in range(len(turns)) for j in range(len(turns))
    )
    assert fit.turn_rad == pytest.approx(largest)
    assert 0.05 < fit.weakest_turn_rad < largest
    assert judge_stylus(fit).ok


def test_one_bad_touch_is_named_and_left_out_on_request() -> None:
    noise = np.random.default_rng(7).normal(0.0, 0.05, (10, 3))
    noise[6] += [0.0, 1.5, 0.0]
    poses = touches(tilts(10, 0.5), noise)
    plain = solve_stylus(poses)
    assert plain.worst == 6
    verdict = judge_stylus(plain)
    assert not verdict.ok and any("touch 6 " in reason.message for reason in verdict.reasons)
    robust = solve_stylus(poses, robust=True)
    assert np.flatnonzero(~robust.used).tolist() == [6]
    assert np.linalg.norm(robust.tip_in_flange_mm - TIP) < 0.15 < np.linalg.norm(plain.tip_in_flange_mm - TIP)
    assert robust.leave_one_out_mm[6] == pytest.approx(1.5, abs=0.3)
    assert judge_stylus(robust).ok
    strict = judge_stylus(robust, StylusLimits(rejected=0))
    assert [reason.code for reason in strict.reasons] == [Code.TOO_MANY_OUTLIERS]


def test_robust_fit_keeps_good_touches() -> None:
    rng = np.random.default_rng(8)
    rejected = 0
    for seed in range(100):
        poses = touches(tilts(8, 0.4, seed), rng.normal(0.0, 0.05, (8, 3)))
        rejected += int(np.count_nonzero(~solve_stylus(poses, robust=True).used))
    assert rejected <= 2


def test_too_few_touches_and_repeats() -> None:
    poses = touches(tilts(3, 0.4))
    with pytest.raises(FitError, match="at least 3") as caught:
        solve_stylus(poses[:2])
    assert caught.value.code is Code.NOT_ENOUGH_POINTS
    with pytest.raises(FitError, match="Found 2 different"):
        solve_stylus(poses[[0, 1, 0, 1]])
    with pytest.raises(FitError, match="same flange pose"):
        solve_stylus(poses[[0, 0, 0, 0]])
    with pytest.raises(FitError, match="Found 0"):
        solve_stylus(np.empty((0, 4, 4)))


def test_no_change_of_orientation() -> None:
    noise = np.random.default_rng(9).normal(0.0, 5.0, (8, 3))
    with pytest.raises(FitError, match="changes by only") as caught:
        solve_stylus(touches(tilts(8, 1e-3), noise))
    assert caught.value.code is Code.NOT_ENOUGH_VARIATION


def test_rotation_about_one_axis_names_the_free_component() -> None:
    about = np.array([0.0, 0.6, 0.8])
    turns = Rotation.from_rotvec(np.outer(np.linspace(-0.6, 0.6, 8), about)).as_matrix()
    noise = np.random.default_rng(10).normal(0.0, 0.05, (8, 3))
    with pytest.raises(FitError, match=r"one axis only, \(-?0.00, -?0.60, -?0.80\) in the flange.*stay free"):
        solve_stylus(touches(turns, noise))


def test_weak_axis_is_judged_or_refused_by_its_covariance() -> None:
    rng = np.random.default_rng(11)
    vectors = np.column_stack([rng.uniform(-0.03, 0.03, 8), rng.uniform(-0.03, 0.03, 8), rng.uniform(-0.6, 0.6, 8)])
    turns = Rotation.from_rotvec(vectors).as_matrix()
    noise = rng.normal(0.0, 0.05, (8, 3))
    fit = solve_stylus(touches(turns, noise), sigma_mm=0.05)
    assert Code.HIGH_UNCERTAINTY in {reason.code for reason in judge_stylus(fit).reasons}
    assert fit.conditioning.description.startswith("+0.7") and "tip z in flange" in fit.conditioning.description
    with pytest.raises(FitError, match=r"do not determine the tip along \(.*1.00\) in the flange"):
        solve_stylus(touches(turns, noise * 40.0), sigma_mm=2.0)


def test_tip_that_slipped_everywhere_is_rejected() -> None:
    fit = solve_stylus(touches(tilts(8, 0.5), np.random.default_rng(12).normal(0.0, 1.0, (8, 3))))
    codes = {reason.code for reason in judge_stylus(fit).reasons}
    assert {Code.HIGH_RESIDUAL, Code.HELD_OUT_ERROR} <= codes


def test_three_touches_are_computed_but_not_accepted() -> None:
    codes = {reason.code for reason in judge_stylus(solve_stylus(touches(tilts(3, 0.5)))).reasons}
    assert Code.NO_REDUNDANCY in codes


def test_small_tilts_are_not_enough_even_without_noise() -> None:
    codes = {reason.code for reason in judge_stylus(solve_stylus(touches(tilts(8, 0.08)))).reasons}
    assert Code.NOT_ENOUGH_VARIATION in codes


def test_unusable_input() -> None:
    poses = touches(tilts(6, 0.4))
    with pytest.raises(InputError, match="look inverted"):
        solve_stylus(np.linalg.inv(poses))
    metres = poses.copy()
    metres[:, :3, 3] /= 1000.0
    with pytest.raises(InputError, match="metres"):
        solve_stylus(metres)
    holed = poses.copy()
    holed[2, 0, 3] = np.nan
    with pytest.raises(InputError, match=r"observations\[2\].*NaN"):
        solve_stylus(holed)
    mirrored = poses.copy()
    mirrored[3, :3, 1] *= -1.0
    with pytest.raises(InputError, match=r"observations\[3\].*left-handed"):
        solve_stylus(mirrored)
    with pytest.raises(InputError, match="found shape"):
        solve_stylus(poses[0])
    with pytest.raises(InputError, match="4x4 numbers"):
        solve_stylus([["x"]])
    with pytest.raises(InputError, match="sigma_mm"):
        solve_stylus(poses, sigma_mm=0.0)
