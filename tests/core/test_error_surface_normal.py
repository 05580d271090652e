"""Head angle to normal error: the exact circle, the small-angle form and refusals."""

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from core.error_surface import angle_for_error, normal_error
from core.errors import InputError


@settings(derandomize=True, deadline=None, max_examples=40)
@given(st.floats(-0.3, 0.3), st.floats(-0.6, 0.6), st.floats(-0.5, 0.5), st.sampled_from([-1.0, 1.0]))
def test_exact_displacement_along_the_normal(angle, tilt_x, tilt_z, side):
    normal = np.array([tilt_x, side, tilt_z])
    normal /= np.linalg.norm(normal)
    before = np.array([180.0, 0.0, 0.0])
    turned = np.array([[np.cos(angle), -np.sin(angle), 0], [np.sin(angle), np.cos(angle), 0], [0, 0, 1]])
    expected = normal @ (turned @ before - before)
    error = normal_error([angle], normal, 180.0)
    assert error[0] == pytest.approx(expected, abs=1e-10)
    assert error[0] == pytest.approx(180.0 * angle * normal[1], abs=180.0 * angle**2 + 1e-9)
    assert angle_for_error(error, normal, 180.0)[0] == pytest.approx(angle, abs=1e-7)


def test_sign_proud_material_turns_the_head_outwards():
    assert normal_error([0.001], [0.0, 1.0, 0.0], 200.0)[0] == pytest.approx(0.2, rel=1e-6)
    assert normal_error([0.001], [0.0, -1.0, 0.0], 200.0)[0] == pytest.approx(-0.2, rel=1e-6)


@pytest.mark.parametrize(
    ("angle", "normal", "radius", "message"),
    [
        ([5.0], [0, 1, 0], 180.0, "degrees"),
        ([np.nan], [0, 1, 0], 180.0, "sample 1"),
        ([0.01], [1, 0.05, 0], 180.0, "cannot feel"),
        ([0.01], [0, 2, 0], 180.0, "unit vector"),
        ([0.01], [0, 1, 0], 0.18, "radius_mm"),
        ([0.01, 0.02], [[0, 1, 0]] * 3, 180.0, "2 rows"),
    ],
)
def test_refusals(angle, normal, radius, message):
    with pytest.raises(InputError, match=message):
        normal_error(angle, np.array(normal, dtype=float), radius)


def test_unreachable_error():
    with pytest.raises(InputError, match="out of reach"):
        angle_for_error([300.0], [0.0, 1.0, 0.0], 180.0)
