"""The stage model against a simulated stage."""

import numpy as np
import pytest
from scipy.spatial.transform import Rotation

from core.ball import StageLimits, StageObservations, judge_stage, paper_axes, solve_stage
from core.errors import FitError, InputError
from core.frames import transform_points
from core.verdict import Code

R0 = Rotation.from_rotvec([0.3, -0.5, 2.0]).as_matrix()
AXES = np.array([[1.0002, 0.001, -0.002], [0.0, 0.9997, 0.003], [0.0, 0.0, 1.0004]])
ROTARY = np.array([0.02, -0.03, 1.0]) / np.linalg.norm([0.02, -0.03, 1.0])
POINT = np.array([30.0, -250.0, 10.0]) - ROTARY * (ROTARY @ np.array([30.0, -250.0, 10.0]))
BALL = np.array([10.0, 20.0, 230.0])
CROSS = np.array([[0, 0, 0], [60, 0, 0], [-60, 0, 0], [0, 60, 0], [0, -60, 0], [0, 0, 60], [0, 0, -60.0]])


def balls(stage, angle, axes=AXES):
    """Solve BALL = A q + c + Rot(theta) (R0 p - c) for p, one position at a time."""
    seen = []
    for q, theta in zip(stage, angle, strict=True):
        back = Rotation.from_rotvec(-theta * ROTARY).as_matrix()
        seen.append(R0.T @ (POINT + back @ (BALL - axes @ q - POINT)))
    return np.array(seen)


def carried(stage, theta, point):
    return AXES @ stage + POINT + Rotation.from_rotvec(theta * ROTARY).as_matrix() @ (R0 @ point - POINT)


def observe(stage, angle, sigma, rng, *, tell=True, axes=AXES):
    noisy = balls(stage, angle, axes) + rng.normal(0.0, sigma, (len(stage), 3))
    return StageObservations(stage, angle, noisy, np.full(len(stage), sigma) if tell else None)


def mixed(rng, count):
    return rng.uniform(-80.0, 80.0, (count, 3)), rng.uniform(-0.6, 0.6, count)


@pytest.mark.parametrize("count", [6, 9, 20])
def test_all_axes_from_positions_where_everything_moves_at_once(count):
    rng = np.random.default_rng(count)
    stage, angle = mixed(rng, count)
    fit = solve_stage(StageObservations(stage, angle, balls(stage, angle)))
    assert fit.converged
    assert np.abs(fit.measure_from_scanner[:3, :3] - R0).max() < 1e-8
    assert np.abs(fit.axes * fit.scale - AXES).max() < 1e-8
    assert np.abs(fit.rotary_axis.direction - ROTARY).max() < 1e-8
    assert np.abs(fit.rotary_axis.point_mm - POINT).max() < 1e-5
    assert np.abs(fit.ball_in_measure_mm - BALL).max() < 1e-5
    where, theta, point = np.array([10.0, 20.0, 30.0]), 0.2, np.array([5.0, 3.0, 200.0])
    found = transform_points(fit.measure_from_scanner_at(where, theta), point)
    assert np.abs(found - carried(where, theta, point)).max() < 1e-5


def test_noise_gives_errors_that_the_covariance_states():
    """Mean of 25 normalised errors squared, 3 degrees of freedom each: 3 +- 4 * sqrt(6 / 25)."""
    where, theta, point = np.array([40.0, -30.0, 20.0]), 0.3, np.array([5.0, 8.0, 215.0])
    carried_nees, ball_nees, turn_nees = [], [], []
    for seed in range(25):
        rng = np.random.default_rng(seed)
        fit = solve_stage(observe(*mixed(rng, 12), 0.01, rng))
        error = transform_points(fit.measure_from_scanner_at(where, theta), point) - carried(where, theta, point)
        carried_nees.append(error @ np.linalg.solve(fit.point_covariance_at(where, theta, point), error))
        ball_error = fit.ball_in_measure_mm - BALL
        ball_nees.append(ball_error @ np.linalg.solve(fit.ball_covariance_mm2(), ball_error))
        turn = Rotation.from_matrix(fit.measure_from_scanner[:3, :3] @ R0.T).as_rotvec()
        turn_nees.append(turn @ np.linalg.solve(fit.covariance.matrix[:3, :3], turn))
    for nees in (carried_nees, ball_nees, turn_nees):
        assert abs(np.mean(nees) - 3.0) < 4.0 * np.sqrt(6.0 / 25.0)


def test_linear_axes_alone_and_a_missing_z():
    rng = np.random.default_rng(0)
    full = solve_stage(observe(CROSS, np.zeros(7), 0.005, rng, tell=False))
    assert full.rotary_axis is None and full.assumed == () and full.redundancy == 9
    assert full.sigma_mm == pytest.approx(0.005, rel=0.6)
    unit = AXES / np.linalg.norm(AXES, axis=0)
    truth = [np.arccos(unit[:, i] @ unit[:, j]) - np.pi / 2 for i, j in ((0, 1), (1, 2), (2, 0))]
    assert np.all(np.abs(full.squareness_rad - truth) < 5.0 * full.squareness_sigma_rad)
    expected = np.arccos(R0[:, 2] @ unit)
    assert np.abs(full.scanner_axis_angles_rad - expected).max() < 5e-4
    flat = solve_stage(observe(CROSS[:5], np.zeros(5), 0.005, rng))
    assert flat.assumed == ("z",)
    assert np.abs(flat.axes[:, 2] - [0, 0, 1]).max() < 1e-12 and flat.scale[2] == pytest.approx(1.0)
    with pytest.raises(InputError, match="rotary axis"):
        flat.measure_from_scanner_at([0, 0, 0], 0.3)


def test_paper_axes_is_the_special_case():
    stage = np.array([[0, 0, 0], [50, 0, 0], [0, 50, 0], [0, 0, 50.0]])
    square = np.eye(3)
    seen = balls(stage, np.zeros(4), square)
    fit = solve_stage(StageObservations(stage, np.zeros(4), seen))
    assert fit.redundancy == 0
    assert np.abs(fit.measure_from_scanner[:3, :3] - paper_axes(seen[:3])).max() < 1e-9
    bent = balls(stage, np.zeros(4))
    bent_fit = solve_stage(StageObservations(stage, np.zeros(4), bent))
    assert np.abs(bent_fit.measure_from_scanner[:3, :3] - R0).max() < 1e-9
    assert np.abs(paper_axes(bent[:3]) - R0).max() < 1e-9


def test_leave_one_out_equals_refitting():
    rng = np.random.default_rng(3)
    stage = np.vstack([CROSS, CROSS[:4] + 11.0])
    obs = observe(stage, np.zeros(11), 0.01, rng)
    fit = solve_stage(obs)
    for i in range(11):
        keep = np.arange(11) != i
        others = StageObservations(stage[keep], np.zeros(10), obs.ball_in_scanner_mm[keep], np.full(10, 0.01))
        other = solve_stage(others)
        missed = obs.ball_in_scanner_mm[i] - other.model.predicted(stage[i : i + 1], np.zeros(1))[0]
        assert fit.leave_one_out_mm[i] == pytest.approx(np.linalg.norm(missed), rel=1e-6)


def test_moved_ball_is_noticed():
    rng = np.random.default_rng(4)
    stage, angle = mixed(rng, 12)
    obs = observe(stage, angle, 0.01, rng)
    assert judge_stage(solve_stage(obs)).ok
    obs.ball_in_scanner_mm[5] += [0.0, 1.0, 0.0]
    fit = solve_stage(obs)
    assert int(np.nanargmax(fit.leave_one_out_mm)) == 5
    assert {Code.HIGH_RESIDUAL, Code.HELD_OUT_ERROR} <= {reason.code for reason in judge_stage(fit).reasons}


@pytest.mark.parametrize(
    ("count", "suspects"),
    # With one cross both ends of an axis fit the rest equally badly: rounding decides which one is named.
    [(7, {1, 2}), (14, {2})],
)
def test_a_slip_within_the_limits_is_named(count, suspects):
    rng = np.random.default_rng(6)
    stage = np.vstack([CROSS, CROSS + 9.0])[:count]
    obs = observe(stage, np.zeros(count), 0.003, rng, tell=False)
    assert solve_stage(obs).outlier is None
    obs.ball_in_scanner_mm[2] += [0.0, 0.15, 0.0]
    fit = solve_stage(obs)
    assert fit.outlier in suspects and fit.leave_one_out_mm[2] < StageLimits().max_leave_one_out_mm
    messages = [reason.message for reason in judge_stage(fit).reasons if reason.code is Code.HELD_OUT_ERROR]
    assert len(messages) == 1 and f"observation {fit.outlier}" in messages[0]


@pytest.mark.parametrize("spoil", [np.diag([1.0, -1.0, 1.0]), np.eye(3)[[1, 0, 2]]])
def test_a_left_handed_set_of_axes_is_rejected(spoil):
    """One sign or the order of two columns is wrong everywhere: the residuals cannot show it."""
    stage = np.vstack([CROSS, CROSS + 5.0])
    seen = balls(stage, np.zeros(14))
    fit = solve_stage(StageObservations(stage @ spoil, np.zeros(14), seen))
    assert fit.rms_mm < 1e-9
    assert [reason.code for reason in judge_stage(fit).reasons] == [Code.WRONG_MODEL]
    assert judge_stage(fit, StageLimits(require_right_handed=False)).ok


def test_no_redundancy_is_a_reason_unless_waived():
    stage = np.array([[0, 0, 0], [50, 0, 0], [0, 50, 0], [0, 0, 50.0]])
    fit = solve_stage(StageObservations(stage, np.zeros(4), balls(stage, np.zeros(4))))
    assert fit.model_covariance is None and np.isnan(fit.leave_one_out_mm).all()
    assert [reason.code for reason in judge_stage(fit).reasons] == [Code.NO_REDUNDANCY]
    assert judge_stage(fit, StageLimits(require_redundancy=False)).ok
    with pytest.raises(InputError, match="covariance"):
        fit.point_covariance_at([0, 0, 0], 0.0, [0, 0, 0])


def test_swapped_scale_is_judged():
    stage = np.vstack([CROSS, CROSS + 5.0])
    fit = solve_stage(observe(stage, np.zeros(14), 0.01, np.random.default_rng(0), axes=AXES @ np.diag([1, 1.02, 1])))
    assert Code.OUTSIDE_LIMITS in {reason.code for reason in judge_stage(fit).reasons}


def test_still_rotary_away_from_zero_keeps_its_angle():
    fit = solve_stage(StageObservations(CROSS, np.full(7, 0.3), balls(CROSS, np.full(7, 0.3))))
    assert fit.rotary_axis is None and fit.rotary_reference_rad == pytest.approx(0.3)
    turned = fit.measure_from_scanner_at([1, 2, 3], 0.3)
    assert np.isfinite(turned).all()
    with pytest.raises(InputError, match="rotary axis"):
        fit.measure_from_scanner_at([1, 2, 3], 0.0)


ZERO = np.zeros(7)
LINE = np.outer(np.arange(7.0), [10.0, 10.0, 0.0])


@pytest.mark.parametrize(
    ("stage", "angle", "text"),
    [
        (CROSS[:3], ZERO[:3], "axis y was not moved"),
        (CROSS[[0, 3, 4]], ZERO[:3], "axis x was not moved"),
        (np.zeros((7, 3)), ZERO, "stood still"),
        (np.array([[0, 0, 0], [60, 0, 9], [0, 60, 3]]), ZERO[:3], "at least"),
        (LINE, ZERO, "together"),
        (CROSS, np.array([0, 0, 0, 0, 0, 0, 0.3]), "determine"),
        (CROSS, np.degrees(np.linspace(-0.5, 0.5, 7)), "degrees"),
        (np.where(np.arange(7)[:, None] == 2, np.nan, CROSS), ZERO, "observation 2"),
    ],
)
def test_bad_positions_are_named(stage, angle, text):
    seen = balls(np.nan_to_num(stage), angle)
    with pytest.raises(InputError, match=text):
        solve_stage(StageObservations(np.asarray(stage, dtype=float), np.asarray(angle, dtype=float), seen))


def test_metres_shapes_and_sigma_are_named():
    seen = balls(CROSS, ZERO)
    with pytest.raises(InputError, match="ball centres look like metres"):
        solve_stage(StageObservations(CROSS, ZERO, seen * 1e-3))
    angle = np.linspace(-0.5, 0.5, 7)
    with pytest.raises(InputError, match="ball centres look like metres"):
        solve_stage(StageObservations(CROSS, angle, balls(CROSS, angle) * 1e-3))
    with pytest.raises(InputError, match="stage positions look like metres"):
        solve_stage(StageObservations(CROSS * 1e-3 * 2.0, ZERO, seen))
    with pytest.raises(InputError, match="expected positions"):
        solve_stage(StageObservations(CROSS, ZERO[:5], seen))
    with pytest.raises(InputError, match="sigma"):
        solve_stage(StageObservations(CROSS, ZERO, seen, -np.ones(7)))
    with pytest.raises(FitError):
        solve_stage(StageObservations(CROSS[:1], ZERO[:1], seen[:1]))
    with pytest.raises(InputError, match="none"):
        solve_stage(StageObservations(np.zeros((0, 3)), np.zeros(0), np.zeros((0, 3))))
