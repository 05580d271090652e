"""Wheel: truth against estimate, what the angles add, and honest uncertainty."""

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from numpy.typing import NDArray
from scipy.optimize import least_squares
from scipy.spatial.transform import Rotation

from core.tool import WheelLimits, WheelTouches, arc_needed_rad, judge_wheel, solve_wheel
from core.verdict import Code

Array = NDArray[np.float64]

CENTRE = np.array([-800.0, 300.0, 500.0])
FRAME = Rotation.from_euler("ZYX", [30.0, -20.0, 75.0], degrees=True).as_matrix()
RADIUS = 210.0


def touch(degrees: list[float] | Array, frame: Array = FRAME, radius: float = RADIUS) -> tuple[Array, Array]:
    """True angles (N,) in rad and points (N, 3) in B."""
    angles = np.radians(np.asarray(degrees, dtype=float))
    return angles, CENTRE + radius * (np.outer(np.cos(angles), frame[:, 0]) + np.outer(np.sin(angles), frame[:, 1]))


def angle_between(a: Array, b: Array) -> float:
    return float(Rotation.from_matrix(a[:3, :3] @ b[:3, :3].T).magnitude())


@settings(derandomize=True, deadline=None, max_examples=15)
@given(st.integers(0, 10**6), st.floats(25.0, 300.0), st.floats(-40.0, 40.0), st.booleans(), st.integers(3, 6))
def test_exact_touches_give_the_truth(seed: int, arc: float, first: float, known: bool, n: int) -> None:
    frame = Rotation.random(random_state=np.random.default_rng(seed)).as_matrix()
    angles, points = touch(np.linspace(first, first + arc, n), frame)
    fit = solve_wheel(WheelTouches(angles, points), radius_mm=RADIUS if known else None, shaft_offset_mm=-15.0)
    assert angle_between(fit.base_from_tool, frame) < 1e-5
    np.testing.assert_allclose(fit.base_from_tool[:3, 3], CENTRE + frame @ [RADIUS, 0.0, -15.0], atol=1e-3)
    np.testing.assert_allclose(fit.head_axis_direction, frame[:, 2], atol=1e-5)
    assert fit.radius_mm == pytest.approx(RADIUS, abs=1e-3)


def test_axes_of_the_tool_frame() -> None:
    angles, points = touch([0.0, 20.0, 40.0, 60.0])
    fit = solve_wheel(WheelTouches(angles, points), shaft_offset_mm=12.5)
    x, y, z = fit.base_from_tool[:3, :3].T
    np.testing.assert_allclose(z, fit.head_axis_direction, atol=1e-9)
    np.testing.assert_allclose(x, (points[0] - fit.head_axis_point_mm) / RADIUS, atol=1e-6)
    np.testing.assert_allclose(y, np.cross(z, x), atol=1e-9)
    # Right-handed: the second touch is ahead along +y; the origin is the first touch moved along +z.
    assert (points[1] - points[0]) @ y > 0.0
    np.testing.assert_allclose(fit.base_from_tool[:3, 3], points[0] + 12.5 * z, atol=1e-5)


def test_reversed_sensor_turns_the_axis_round_and_is_noticed_against_an_expectation() -> None:
    angles, points = touch([0.0, 20.0, 40.0, 60.0])
    fit = solve_wheel(WheelTouches(-angles, points))
    np.testing.assert_allclose(fit.head_axis_direction, -FRAME[:, 2], atol=1e-6)
    assert judge_wheel(fit).ok
    expected = WheelLimits(expected_axis_in_base=(float(FRAME[0, 2]), float(FRAME[1, 2]), float(FRAME[2, 2])))
    reasons = judge_wheel(fit, expected).reasons
    assert [reason.code for reason in reasons] == [Code.WRONG_MODEL] and "wrong way round" in reasons[0].message
    assert judge_wheel(solve_wheel(WheelTouches(angles, points)), expected).ok


def noisy(
    rng: np.random.Generator, degrees: list[float] | Array, sigma_mm: float = 0.05, sigma_rad: float = 5e-4
) -> WheelTouches:
    angles, points = touch(degrees)
    return WheelTouches(
        angles + rng.normal(0.0, sigma_rad, angles.shape), points + rng.normal(0.0, sigma_mm, points.shape)
    )


@pytest.mark.parametrize("radius", [None, RADIUS])
def test_noisy_touches_stay_within_their_covariance(radius: float | None) -> None:
    rng = np.random.default_rng(1)
    nees = []
    for _ in range(40):
        data = noisy(rng, [-10.0, 5.0, 20.0, 35.0, 50.0])
        fit = solve_wheel(data, radius_mm=radius, shaft_offset_mm=15.0, sigma_mm=0.05, angle_sigma_rad=5e-4)
        turn = Rotation.from_matrix(fit.base_from_tool[:3, :3] @ FRAME.T).as_rotvec()
        # About the estimated origin c: R_error (t - c) + ... with c = estimate leaves R_error-turned difference.
        true_origin = CENTRE + FRAME @ [RADIUS, 0.0, 15.0]
        shift = Rotation.from_rotvec(turn).apply(fit.covariance.about_mm - true_origin)
        error = np.concatenate([turn, shift])
        nees.append(error @ np.linalg.solve(fit.covariance.matrix, error) / 6.0)
    # 240 degrees of freedom: standard deviation of the mean 0.091.
    assert np.mean(nees) == pytest.approx(1.0, abs=0.28)


def test_generous_angles_leave_the_plain_circle_through_the_points() -> None:
    data = noisy(np.random.default_rng(2), [0.0, 25.0, 50.0, 75.0, 100.0, 125.0])
    fit = solve_wheel(data, sigma_mm=0.05, angle_sigma_rad=30.0)

    def geometric(unknowns: Array) -> Array:
        axis = unknowns[3:6] / np.linalg.norm(unknowns[3:6])
        arm = data.point_in_base_mm - unknowns[:3]
        height = arm @ axis
        return np.concatenate([height, np.linalg.norm(arm - np.outer(height, axis), axis=1) - unknowns[6]])

    start = np.concatenate([CENTRE + 1.0, FRAME[:, 2] + 0.01, [RADIUS]])
    plain = least_squares(geometric, start, xtol=1e-12, ftol=1e-12, gtol=1e-12).x
    assert fit.radius_mm == pytest.approx(plain[6], abs=1e-3)
    np.testing.assert_allclose(fit.head_axis_point_mm, plain[:3], atol=2e-3)
    np.testing.assert_allclose(fit.head_axis_direction, plain[3:6] / np.linalg.norm(plain[3:6]), atol=1e-5)


def test_three_points_pass_through_the_plain_circle_exactly() -> None:
    data = noisy(np.random.default_rng(3), [0.0, 60.0, 130.0])
    fit = solve_wheel(data, sigma_mm=0.05, angle_sigma_rad=30.0)
    a, b, c = data.point_in_base_mm
    sides = [np.linalg.norm(b - c), np.linalg.norm(c - a), np.linalg.norm(a - b)]
    circumradius = float(np.prod(sides) / (2.0 * np.linalg.norm(np.cross(b - a, c - a))))
    assert fit.radius_mm == pytest.approx(circumradius, rel=1e-6)
    assert fit.rms_mm < 1e-5


def test_angles_and_known_radius_rescue_a_short_arc() -> None:
    rng = np.random.default_rng(4)
    centre_errors: dict[str, list[float]] = {"points": [], "angles": [], "radius": []}
    for _ in range(25):
        data = noisy(rng, [0.0, 15.0, 30.0], sigma_rad=2e-4)
        for name, radius, trust in (("points", None, 30.0), ("angles", None, 2e-4), ("radius", RADIUS, 2e-4)):
            fit = solve_wheel(data, radius_mm=radius, sigma_mm=0.05, angle_sigma_rad=trust)
            centre_errors[name].append(float((fit.head_axis_point_mm - CENTRE) @ FRAME[:, 0]))
    spread = {name: float(np.std(errors)) for name, errors in centre_errors.items()}
    assert spread["angles"] < 0.3 * spread["points"]
    assert spread["radius"] < 0.5 * spread["angles"]


def test_figure_for_the_axis_and_the_arc_that_would_do() -> None:
    data = noisy(np.random.default_rng(5), [0.0, 8.0, 16.0])
    fit = solve_wheel(data, radius_mm=RADIUS, sigma_mm=0.05, angle_sigma_rad=5e-4)
    wanted = 0.5 * fit.axis_tilt_sigma_rad
    needed = arc_needed_rad(fit, wanted)
    longer = noisy(np.random.default_rng(6), np.degrees(np.linspace(0.0, needed, 3)))
    again = solve_wheel(longer, radius_mm=RADIUS, sigma_mm=0.05, angle_sigma_rad=5e-4)
    assert again.axis_tilt_sigma_rad == pytest.approx(wanted, rel=0.05)
    verdict = judge_wheel(fit)
    assert Code.HIGH_UNCERTAINTY in {reason.code for reason in verdict.reasons}
    assert any("Turn the head farther" in reason.message for reason in verdict.reasons)
    assert np.isinf(arc_needed_rad(fit, 1e-9))


def test_covariance_can_be_scaled_by_the_residuals() -> None:
    rng = np.random.default_rng(7)
    squares = [
        solve_wheel(noisy(rng, np.linspace(0.0, 90.0, 8), 0.1, 2e-3), radius_mm=RADIUS).sigma_mm ** 2 for _ in range(30)
    ]
    assert np.sqrt(np.mean(squares)) == pytest.approx(0.1, rel=0.1)


def test_good_touches_are_accepted() -> None:
    data = noisy(np.random.default_rng(8), [-20.0, -5.0, 10.0, 25.0, 40.0])
    fit = solve_wheel(data, radius_mm=RADIUS)
    assert judge_wheel(fit).ok
    assert np.nanmax(fit.leave_one_out_mm) < 0.5
    assert fit.arc_rad == pytest.approx(np.radians(60.0), abs=0.01)


def test_three_touches_have_no_held_out_figure() -> None:
    fit = solve_wheel(noisy(np.random.default_rng(9), [0.0, 30.0, 60.0]), radius_mm=RADIUS)
    assert np.all(np.isnan(fit.leave_one_out_mm))
    assert [reason.code for reason in judge_wheel(fit).reasons] == [Code.NO_REDUNDANCY]
    assert judge_wheel(fit, WheelLimits(different_touches=3)).ok


def test_three_touches_with_a_slip_are_not_accepted() -> None:
    data = noisy(np.random.default_rng(9), [0.0, 30.0, -30.0])
    data.point_in_base_mm[1] += [2.0, 0.0, 0.0]
    assert Code.NO_REDUNDANCY in [reason.code for reason in judge_wheel(solve_wheel(data, radius_mm=RADIUS)).reasons]


def test_wrong_radius_is_noticed() -> None:
    fit = solve_wheel(noisy(np.random.default_rng(10), [-20.0, 0.0, 20.0, 40.0]), radius_mm=RADIUS + 6.0)
    messages = [reason.message for reason in judge_wheel(fit).reasons if reason.code is Code.WRONG_MODEL]
    assert any("The radius given is 216.000 mm" in message for message in messages)
    assert fit.free_radius_mm == pytest.approx(RADIUS, abs=1.0)


def test_scale_of_the_sensor_is_noticed_and_fitted_on_request() -> None:
    data = noisy(np.random.default_rng(11), [-30.0, -10.0, 10.0, 30.0, 50.0], sigma_rad=2e-4)
    stretched = WheelTouches(data.angle_rad / 1.06, data.point_in_base_mm)
    plain = solve_wheel(stretched, radius_mm=RADIUS, angle_sigma_rad=2e-4, sigma_mm=0.05)
    messages = [reason.message for reason in judge_wheel(plain).reasons if reason.code is Code.WRONG_MODEL]
    assert any("The head turns 1.06" in message for message in messages)
    fitted = solve_wheel(stretched, radius_mm=RADIUS, fit_angle_scale=True, angle_sigma_rad=2e-4, sigma_mm=0.05)
    assert abs(fitted.angle_scale - 1.06) < 4.0 * fitted.angle_scale_sigma < 0.01
    assert np.linalg.norm(fitted.head_axis_point_mm - CENTRE) < 0.5


def test_one_bad_angle_and_one_bad_touch_are_named() -> None:
    data = noisy(np.random.default_rng(12), [-30.0, -15.0, 0.0, 15.0, 30.0, 45.0])
    angles, points = data.angle_rad.copy(), data.point_in_base_mm.copy()
    angles[4] += 0.05
    messages = [reason.message for reason in judge_wheel(solve_wheel(WheelTouches(angles, points))).reasons]
    assert any("Look at touch 4 " in message for message in messages)
    points[1] += 2.0 * FRAME[:, 2]
    fit = solve_wheel(WheelTouches(data.angle_rad, points), sigma_mm=0.05, angle_sigma_rad=5e-4)
    messages = [reason.message for reason in judge_wheel(fit).reasons]
    assert any("Look at touch 1 " in message for message in messages)
