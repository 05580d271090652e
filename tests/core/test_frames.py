"""Frames: conventions that everything else rests on."""

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from core import frames
from core.errors import InputError

angles = st.floats(-3.1, 3.1)
small = st.floats(-0.3, 0.3)
lengths = st.floats(-500.0, 500.0)
triples = st.tuples(lengths, lengths, lengths)
quick = settings(derandomize=True, deadline=None, max_examples=60)


def pose(alpha: float, beta: float, gamma: float, translation: tuple[float, float, float]) -> np.ndarray:
    return frames.rigid(frames.rotation_from_euler_zyx(alpha, beta, gamma), translation)


def test_euler_order_is_rz_ry_rx() -> None:
    a, b, c = 0.3, -0.7, 1.1
    rz = np.array([[np.cos(a), -np.sin(a), 0], [np.sin(a), np.cos(a), 0], [0, 0, 1]])
    ry = np.array([[np.cos(b), 0, np.sin(b)], [0, 1, 0], [-np.sin(b), 0, np.cos(b)]])
    rx = np.array([[1, 0, 0], [0, np.cos(c), -np.sin(c)], [0, np.sin(c), np.cos(c)]])
    np.testing.assert_allclose(frames.rotation_from_euler_zyx(a, b, c), rz @ ry @ rx, atol=1e-15)


@quick
@given(angles, st.floats(-1.5, 1.5), angles)
def test_euler_round_trip(alpha: float, beta: float, gamma: float) -> None:
    back = frames.euler_zyx_from_rotation(frames.rotation_from_euler_zyx(alpha, beta, gamma))
    np.testing.assert_allclose(back, [alpha, beta, gamma], atol=1e-9)


@pytest.mark.parametrize("beta", [np.pi / 2, -np.pi / 2])
def test_euler_in_gimbal_lock_gives_the_same_rotation(beta: float) -> None:
    rotation = frames.rotation_from_euler_zyx(0.4, beta, 0.9)
    back = frames.rotation_from_euler_zyx(*frames.euler_zyx_from_rotation(rotation))
    np.testing.assert_allclose(back, rotation, atol=1e-8)


@quick
@given(angles, small, angles, triples)
def test_inverse_undoes(alpha: float, beta: float, gamma: float, translation: tuple[float, float, float]) -> None:
    a_from_b = pose(alpha, beta, gamma, translation)
    np.testing.assert_allclose(frames.inverse(a_from_b) @ a_from_b, np.eye(4), atol=1e-9)
    stack = np.stack([a_from_b, np.eye(4)])
    np.testing.assert_allclose(frames.inverse(stack)[0], frames.inverse(a_from_b), atol=1e-12)


@quick
@given(angles, small, angles, triples, st.tuples(small, small, small), triples, triples)
def test_pose_error_is_the_inverse_of_perturbed(alpha, beta, gamma, translation, turn, shift, about) -> None:  # type: ignore[no-untyped-def]
    truth = pose(alpha, beta, gamma, translation)
    error = np.concatenate([turn, shift])
    np.testing.assert_allclose(
        frames.pose_error(frames.perturbed(truth, error, about), truth, about), error, atol=1e-7
    )


def test_covariance_moves_like_the_errors_do() -> None:
    rng = np.random.default_rng(3)
    root = rng.normal(size=(6, 6)) * np.array([1e-4] * 3 + [1e-2] * 3)[:, None]
    covariance = frames.PoseCovariance(root @ root.T, np.array([10.0, -20.0, 30.0]))
    point = np.array([100.0, 50.0, -40.0])
    truth = pose(0.2, 0.1, -0.4, (5.0, 6.0, 7.0))
    point_in_b = frames.transform_points(frames.inverse(truth), point)
    errors = (root @ rng.normal(size=(6, 40000))).T
    moved = np.array([
        frames.transform_points(frames.perturbed(truth, error, covariance.about_mm), point_in_b) for error in errors
    ])
    np.testing.assert_allclose(np.cov(moved.T), covariance.of_point(point), rtol=0.06, atol=2e-5)


def test_nearest_rotation_keeps_the_hand() -> None:
    mirrored = np.diag([1.0, 1.0, -1.0])
    assert np.linalg.det(frames.nearest_rotation(mirrored)) == pytest.approx(1.0)


@pytest.mark.parametrize(
    ("matrix", "words"),
    [
        (np.eye(3), "shape"),
        ("text", "4x4"),
        ([[1, 2], [3]], "4x4"),
        (np.diag([1.0, 1.0, -1.0, 1.0]), "left-handed"),
        (np.diag([2.0, 2.0, 2.0, 1.0]), "scaled"),
        (np.diag([1.0, 1.0, 0.0, 1.0]), "left-handed or singular"),
        (np.diag([1.0, 1.0, 1.0, 2.0]), "last row"),
        (np.full((4, 4), np.nan), "NaN"),
        (frames.rigid(np.eye(3), [1, 2, 3]).T, "transposed"),
        (frames.rigid([[1, 0.1, 0], [0, 0.995, 0], [0, 0, 1]], [0, 0, 0]), "right angles|scaled"),
    ],
)
def test_bad_matrices_are_refused_in_words(matrix: object, words: str) -> None:
    with pytest.raises(InputError, match=words):
        frames.checked_rigid(matrix, "start.matrix")


def test_a_matrix_typed_with_four_decimals_is_accepted_and_made_orthonormal() -> None:
    typed = np.round(pose(0.3, 0.2, 0.1, (1.0, 2.0, 3.0)), 4)
    checked = frames.checked_rigid(typed.tolist(), "start.matrix")
    np.testing.assert_allclose(checked[:3, :3].T @ checked[:3, :3], np.eye(3), atol=1e-12)
    np.testing.assert_allclose(checked, typed, atol=2e-4)
