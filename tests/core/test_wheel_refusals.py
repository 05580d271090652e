"""Wheel: touches that do not determine the axis are refused in words an operator can act on."""

import numpy as np
import pytest
from numpy.typing import NDArray
from scipy.spatial.transform import Rotation

from core.errors import FitError, InputError
from core.tool import WheelTouches, solve_wheel
from core.verdict import Code

Array = NDArray[np.float64]

FRAME = Rotation.from_euler("ZYX", [30.0, -20.0, 75.0], degrees=True).as_matrix()
ORIGIN = np.array([-800.0, 300.0, 500.0])


def touches(degrees: list[float], noise_mm: float = 0.0) -> WheelTouches:
    angles = np.radians(degrees)
    points = 210.0 * np.column_stack([np.cos(angles), np.sin(angles), 0.0 * angles]) @ FRAME.T
    noise = np.random.default_rng(1).normal(0.0, 1.0, points.shape) * noise_mm
    return WheelTouches(angles, points + ORIGIN + noise)


GOOD = touches([0.0, 15.0, 30.0, 45.0])


def refused(data: WheelTouches, match: str, code: Code, **options: float) -> None:
    with pytest.raises(InputError, match=match) as caught:
        solve_wheel(data, **options)  # type: ignore[arg-type]
    assert caught.value.code is code


@pytest.mark.parametrize("n", [0, 1, 2])
def test_too_few_touches(n: int) -> None:
    data = WheelTouches(GOOD.angle_rad[:n], GOOD.point_in_base_mm[:n])
    refused(data, "at least 3", Code.NOT_ENOUGH_POINTS)


def test_repeats_do_not_make_two_touches_three() -> None:
    index = [0, 2, 0, 2]
    data = WheelTouches(GOOD.angle_rad[index], GOOD.point_in_base_mm[index])
    refused(data, "Found 2 touches at different places", Code.NOT_ENOUGH_POINTS)


def test_coincident_touches() -> None:
    points = GOOD.point_in_base_mm[[0] * 4] + np.random.default_rng(0).normal(0.0, 0.05, (4, 3))
    refused(WheelTouches(GOOD.angle_rad, points), "head has not turned", Code.NOT_ENOUGH_VARIATION)


def test_collinear_touches() -> None:
    points = np.outer(np.arange(4.0), [30.0, 10.0, 5.0]) + ORIGIN
    refused(WheelTouches(GOOD.angle_rad, points), "straight line", Code.NOT_ENOUGH_VARIATION)


def test_all_at_one_angle() -> None:
    data = WheelTouches(np.full(4, 0.2), GOOD.point_in_base_mm)
    refused(data, "All head angles are the same", Code.NOT_ENOUGH_VARIATION)


@pytest.mark.parametrize("known", [None, 210.0])
def test_short_arc_says_how_long_it_must_be(known: float | None) -> None:
    data = touches([0.0, 2.0, 4.0], noise_mm=0.05)
    with pytest.raises(
        FitError, match=r"arc of .* deg its direction is known to .*Turn the head over \d+ deg"
    ) as caught:
        solve_wheel(data, radius_mm=known, sigma_mm=0.05)
    assert caught.value.code is Code.NOT_ENOUGH_VARIATION


def test_short_arc_is_refused_even_if_it_fits_by_chance() -> None:
    refused(touches([0.0, 1.0, 2.0]), "do not determine the head's axis", Code.NOT_ENOUGH_VARIATION)


def test_noise_that_no_arc_makes_good() -> None:
    data = touches([0.0, 30.0, 60.0])
    refused(data, "No arc would do", Code.NOT_ENOUGH_VARIATION, sigma_mm=60.0)


def test_degrees_over_a_full_turn() -> None:
    data = WheelTouches(np.degrees(GOOD.angle_rad), GOOD.point_in_base_mm)
    refused(data, "look like degrees", Code.BAD_INPUT)


@pytest.mark.parametrize("radius", [None, 210.0])
def test_few_degrees(radius: float | None) -> None:
    data = touches([0.0, 2.0, 4.0, 6.0], noise_mm=0.01)
    slipped = WheelTouches(np.degrees(data.angle_rad), data.point_in_base_mm)
    with pytest.raises(InputError, match="look like degrees"):
        solve_wheel(slipped, radius_mm=radius)


@pytest.mark.parametrize("radius", [None, 210.0])
def test_degrees_converted_twice(radius: float | None) -> None:
    slipped = WheelTouches(np.radians(GOOD.angle_rad), GOOD.point_in_base_mm)
    with pytest.raises(InputError, match="given as degrees"):
        solve_wheel(slipped, radius_mm=radius)


def test_metres() -> None:
    data = WheelTouches(GOOD.angle_rad, GOOD.point_in_base_mm / 1000.0)
    refused(data, "looks like metres", Code.BAD_INPUT)


def test_numbers_and_shapes() -> None:
    holed = GOOD.point_in_base_mm.copy()
    holed[2, 0] = np.nan
    refused(WheelTouches(GOOD.angle_rad, holed), r"touches\[2\]: NaN", Code.BAD_INPUT)
    angles = GOOD.angle_rad.copy()
    angles[1] = np.inf
    refused(WheelTouches(angles, GOOD.point_in_base_mm), r"touches\[1\]", Code.BAD_INPUT)
    refused(WheelTouches(GOOD.angle_rad[:3], GOOD.point_in_base_mm), "found shapes", Code.BAD_INPUT)
    refused(WheelTouches(GOOD.angle_rad, GOOD.point_in_base_mm[:, :2]), "found shapes", Code.BAD_INPUT)
    refused(WheelTouches(["a"], GOOD.point_in_base_mm), "all numbers", Code.BAD_INPUT)  # type: ignore[arg-type]


@pytest.mark.parametrize("name", ["radius_mm", "sigma_mm", "angle_sigma_rad"])
def test_options_must_be_above_zero(name: str) -> None:
    refused(GOOD, name, Code.BAD_INPUT, **{name: -1.0})
    refused(GOOD, name, Code.BAD_INPUT, **{name: float("nan")})


def test_shaft_offset_must_be_a_number() -> None:
    refused(GOOD, "shaft_offset_mm", Code.BAD_INPUT, shaft_offset_mm=float("nan"))
