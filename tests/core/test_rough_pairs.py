"""Picked pairs: truth, simulated picks, fit, and every way of picking wrongly."""

from __future__ import annotations

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from scipy.spatial.transform import Rotation

from core.errors import FitError, InputError
from core.rough import PairsLimits, judge_pairs, solve_pairs
from core.verdict import Code

CAD = np.array([[-30.0, -20.0, 5.0], [35.0, -15.0, 0.0], [10.0, 22.0, 12.0], [-20.0, 5.0, 300.0], [25.0, 18.0, 310.0]])
NAMES = ["S2 corner", "S3 corner", "edge plate", "shroud left", "shroud right"]


def truth(seed: int = 0) -> np.ndarray:
    rng = np.random.default_rng(seed)
    pose = np.eye(4)
    pose[:3, :3] = Rotation.random(random_state=rng).as_matrix()
    pose[:3, 3] = rng.uniform(-500.0, 500.0, 3)
    return pose


def picked(pose: np.ndarray, cad: np.ndarray = CAD, noise: float = 0.0, seed: int = 1) -> np.ndarray:
    exact = cad @ pose[:3, :3].T + pose[:3, 3]
    return exact + noise * np.random.default_rng(seed).normal(size=exact.shape)


@settings(derandomize=True, deadline=None, max_examples=30)
@given(st.integers(0, 10_000), st.integers(3, 5))
def test_exact_picks_give_the_exact_pose_from_any_pose(seed: int, count: int) -> None:
    pose = truth(seed)
    fit = solve_pairs(picked(pose, CAD[:count]), CAD[:count])
    assert np.abs(fit.measure_from_work - pose).max() < 1e-9
    assert fit.rms_mm < 1e-9
    assert judge_pairs(fit).ok


def test_noise_is_passed_on_as_the_theory_says() -> None:
    pose, sigma, runs = truth(), 0.5, 200
    shifts = []
    for seed in range(runs):
        fit = solve_pairs(picked(pose, noise=sigma, seed=seed), CAD, sigma_mm=sigma)
        change = fit.measure_from_work - pose
        shifts.append(change[:3, :3] @ CAD.mean(axis=0) + change[:3, 3])
    spread = np.std(shifts, axis=0)
    expected = sigma / np.sqrt(len(CAD))
    assert np.abs(spread - expected).max() < 4.0 * expected / np.sqrt(2 * runs)
    assert np.abs(np.mean(shifts, axis=0)).max() < 4.0 * expected / np.sqrt(runs)
    assert fit.covariance.matrix[3, 3] == pytest.approx(expected**2)


def test_residuals_have_the_sign_scan_minus_cad_and_leave_one_out_is_a_prediction() -> None:
    pose = truth()
    scan = picked(pose, noise=0.3)
    fit = solve_pairs(scan, CAD, names=NAMES)
    carried = CAD @ fit.measure_from_work[:3, :3].T + fit.measure_from_work[:3, 3]
    assert fit.residuals_mm == pytest.approx(scan - carried)
    rest = solve_pairs(scan[1:], CAD[1:])
    predicted = rest.measure_from_work[:3, :3] @ CAD[0] + rest.measure_from_work[:3, 3]
    assert fit.leave_one_out_mm[0] == pytest.approx(np.linalg.norm(scan[0] - predicted))
    assert np.all(fit.leave_one_out_mm > fit.distances_mm)


@pytest.mark.parametrize("bad", range(5))
def test_one_bad_pick_among_five_is_named(bad: int) -> None:
    scan = picked(truth(), noise=0.4, seed=bad)
    scan[bad] += [9.0, -7.0, 8.0]
    fit = solve_pairs(scan, CAD, names=NAMES)
    assert fit.worst == NAMES[bad]
    assert fit.worst_is_clear
    verdict = judge_pairs(fit)
    assert verdict.reasons[0].code is Code.HELD_OUT_ERROR
    assert f"'{NAMES[bad]}'" in verdict.reasons[0].message
    assert "pick it again" in verdict.reasons[0].message


def test_one_bad_pick_among_four_is_named_when_it_is_clear() -> None:
    scan = picked(truth(), CAD[:4], noise=0.1)
    scan[1] += [40.0, 0.0, 0.0]
    fit = solve_pairs(scan, CAD[:4], names=NAMES[:4])
    assert fit.worst == "S3 corner"
    assert fit.worst_is_clear
    assert not judge_pairs(fit).ok


def test_ordinary_noise_makes_no_pick_stand_out() -> None:
    clear = sum(solve_pairs(picked(truth(), noise=0.5, seed=seed), CAD).worst_is_clear for seed in range(200))
    assert clear <= 12  # 2 % of 200 are expected


def test_three_pairs_say_that_nothing_checks_them() -> None:
    fit = solve_pairs(picked(truth(), CAD[[0, 1, 3]], noise=0.2), CAD[[0, 1, 3]])
    assert fit.redundancy == 3
    assert np.all(np.isnan(fit.leave_one_out_mm))
    assert "no pair over" in fit.remarks[0]
    assert judge_pairs(fit).ok
    codes = [reason.code for reason in judge_pairs(fit, PairsLimits(min_pairs=4)).reasons]
    assert codes == [Code.NO_REDUNDANCY]


def test_a_pick_that_alone_leaves_a_line_is_marked_as_unchecked() -> None:
    cad = np.array([[0.0, 0.0, 0.0], [0.0, 0.0, 100.0], [0.0, 0.0, 200.0], [40.0, 0.0, 90.0]])
    fit = solve_pairs(picked(truth(), cad, noise=0.1), cad, names=["a", "b", "c", "d"])
    assert np.isnan(fit.leave_one_out_mm[3])
    assert "'d'" in fit.remarks[0]


def test_all_picks_of_another_blade_are_rejected_without_naming_one() -> None:
    rng = np.random.default_rng(5)
    verdict = judge_pairs(solve_pairs(picked(truth()) + rng.normal(0.0, 12.0, CAD.shape), CAD))
    assert Code.HIGH_RESIDUAL in [reason.code for reason in verdict.reasons]


@pytest.mark.parametrize("noise", [0.0, 1e-6, 0.3])
def test_collinear_picks_are_refused_with_and_without_noise(noise: float) -> None:
    cad = np.outer([0.0, 50.0, 120.0, 180.0, 300.0], [0.6, 0.0, 0.8])
    cad += noise * np.random.default_rng(0).normal(size=cad.shape)
    with pytest.raises(FitError, match=r"on a line along .*Pick at least one point well off") as caught:
        solve_pairs(picked(truth(), cad, noise), cad)
    assert caught.value.code is Code.NOT_ENOUGH_VARIATION


def test_coincident_picks_are_refused() -> None:
    cad = np.full((4, 3), 20.0) + 1e-3 * np.random.default_rng(0).normal(size=(4, 3))
    with pytest.raises(FitError, match="within"):
        solve_pairs(picked(truth()), np.vstack([cad, cad[:1]]))


@pytest.mark.parametrize(("scan_scale", "cad_scale", "text"), [
    (1e-3, 1.0, "on the scan look like metres"),
    (1.0, 1e-3, "on the CAD model look like metres"),
    (1e-3, 1e-3, "look like metres"),
    (1.0, 1.0 / 25.4, "on the CAD model look like inches"),
])
def test_wrong_units_are_named(scan_scale: float, cad_scale: float, text: str) -> None:
    with pytest.raises(InputError, match=text):
        solve_pairs(picked(truth(), noise=0.3) * scan_scale, CAD * cad_scale)


def test_mirrored_picks_are_recognised() -> None:
    mirrored = CAD * [1.0, -1.0, 1.0]
    with pytest.raises(FitError, match="mirror image"):
        solve_pairs(picked(truth(), mirrored, noise=0.3), CAD)


def test_unusable_input_is_refused() -> None:
    scan = picked(truth())
    broken = scan.copy()
    broken[2, 1] = np.nan
    with pytest.raises(InputError, match=r"scan_mm\[2\].*NaN"):
        solve_pairs(broken, CAD)
    with pytest.raises(FitError, match="at least 3"):
        solve_pairs(scan[:2], CAD[:2])
    with pytest.raises(InputError, match="5 picks on the scan and 4"):
        solve_pairs(scan, CAD[:4])
    with pytest.raises(InputError, match="2 names for 5"):
        solve_pairs(scan, CAD, names=["a", "b"])
    with pytest.raises(InputError, match="entered twice"):
        solve_pairs(np.vstack([scan, scan[:1]]), np.vstack([CAD, CAD[:1]]))
    with pytest.raises(InputError, match="N x 3"):
        solve_pairs(scan[:, :2], CAD)
    with pytest.raises(InputError, match="sigma_mm"):
        solve_pairs(scan, CAD, sigma_mm=-1.0)
    with pytest.raises(InputError, match="rows of three numbers"):
        solve_pairs([["a", 1, 2]], CAD)
