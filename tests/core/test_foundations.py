"""Conditioning, robust weights and verdicts."""

import numpy as np
import pytest

from core.conditioning import analyse, analyse_pose
from core.robust import huber_weights, mad_sigma, tukey_weights
from core.verdict import Code, Reason, Verdict, above


def test_weakest_direction_is_named() -> None:
    result = analyse(np.diag([100.0, 1.0, 25.0]), [1.0, 1.0, 1.0], ["a", "b", "c"])
    assert result.condition == pytest.approx(10.0)
    np.testing.assert_allclose(np.abs(result.weakest_direction), [0, 1, 0])
    assert result.description == "+1.00 b"


def test_singular_information_has_infinite_condition() -> None:
    assert analyse(np.diag([1.0, 0.0]), [1.0, 1.0], ["a", "b"]).condition == float("inf")


def test_pose_conditioning_does_not_depend_on_the_unit_of_rotation() -> None:
    lever = 50.0
    information = np.diag([lever**2, lever**2, lever**2, 1.0, 1.0, 0.01])
    result = analyse_pose(information, lever)
    assert result.condition == pytest.approx(10.0)
    assert result.description == "translation along (0.00, 0.00, 1.00)"


def test_mad_ignores_a_third_of_outliers() -> None:
    rng = np.random.default_rng(0)
    values = np.concatenate([rng.normal(0, 0.035, 20000), rng.uniform(3, 9, 2000)])
    assert mad_sigma(values) == pytest.approx(0.035, rel=0.2)


def test_weights_are_one_at_zero_and_fall() -> None:
    assert tukey_weights([0.0, 10.0], 1.0).tolist() == [1.0, 0.0]
    np.testing.assert_allclose(huber_weights([0.0, 2.69], 1.0), [1.0, 0.5])


def test_above_rejects_values_over_the_limit_and_what_is_no_number() -> None:
    assert above(Code.HIGH_RESIDUAL, 0.1, 0.2, "The RMS", "Redo.") == []
    assert above(Code.HIGH_RESIDUAL, 0.3, 0.2, "The RMS", "Redo.")[0].message.startswith("The RMS is 0.3 mm")
    assert len(above(Code.HIGH_RESIDUAL, float("nan"), 0.2, "The RMS", "Redo.")) == 1


def test_verdict_is_ok_without_reasons_only() -> None:
    assert Verdict().ok
    assert not Verdict.of([Reason(Code.HIGH_RESIDUAL, "too high")]).ok
