"""The golden blade: interpolation, smoothing with bad samples, and where the surface has no answer."""

import json

import numpy as np
import pytest

from core.error_surface import (
    ErrorSurfaceLimits,
    average_surfaces,
    error_surface_from_json_dict,
    fit_error_surface,
    judge_error_surface,
    judge_mismatch,
    surface_mismatch,
)
from core.errors import FitError, InputError
from core.verdict import Code

U = np.linspace(0.02, 0.98, 129)
V = np.linspace(0.02817023, 0.94663445, 40)
GOLDEN_V = (0.02817023, 0.21657314, 0.40497606, 0.59337898, 0.7817819, 0.94663445)


def truth(u, v):
    """Shape error plus 0.5 mm along one axis, seen along a normal that turns around the profile."""
    phi = 0.35 + (2.0 * np.pi - 0.7) * u + 0.4 * v
    normal_y = np.sin(phi) / np.hypot(np.cos(phi), np.sin(phi))
    return 0.5 * np.cos(4.0 * np.pi * v) + 0.5 * normal_y


def grid(lines_u=U, lines_v=V):
    return tuple(axis.ravel() for axis in np.meshgrid(lines_u, lines_v, indexing="ij"))


def between(count=5000, seed=2):
    rng = np.random.default_rng(seed)
    return rng.uniform(U[0], U[-1], count), rng.uniform(V[0], V[-1], count)


def test_golden_grid_is_right_between_its_samples():
    u, v = grid()
    assert np.abs(truth(u, v)).max() <= 1.0
    order = np.random.default_rng(0).permutation(u.size)
    surface = fit_error_surface(u[order], v[order], truth(u, v)[order])
    assert surface.control_points.shape == (129, 40)
    assert surface.degrees == (3, 3)
    at_u, at_v = between()
    assert np.abs(surface.evaluate(at_u, at_v) - truth(at_u, at_v)).max() < 1e-3
    np.testing.assert_allclose(surface.evaluate(u, v), truth(u, v), atol=1e-12)
    for position, line in zip(GOLDEN_V, (0, 8, 16, 24, 32, 39), strict=True):
        assert position == pytest.approx(V[line], abs=1e-8)
        assert np.all(np.isfinite(surface.evaluate(U, position)))
    assert judge_error_surface(surface).ok


def test_uneven_grid():
    lines_u = 0.5 - 0.5 * np.cos(np.pi * np.linspace(0.02, 0.98, 60))
    lines_v = np.linspace(0.0, 1.0, 41) ** 1.3 * 0.9 + 0.03
    u, v = grid(lines_u, lines_v)
    surface = fit_error_surface(u, v, truth(u, v))
    at_u, at_v = np.random.default_rng(1).uniform(0.05, 0.9, (2, 1000))
    assert np.abs(surface.evaluate(at_u, at_v) - truth(at_u, at_v)).max() < 1e-3


def test_derivatives_agree_with_differences():
    u, v = grid()
    surface = fit_error_surface(u, v, truth(u, v))
    at_u, at_v = between(50)
    at_u, at_v = np.clip(at_u, 0.05, 0.95), np.clip(at_v, 0.05, 0.9)
    _, by_u, by_v = surface.derivatives(at_u, at_v)
    h = 1e-6
    np.testing.assert_allclose(
        by_u, (surface.evaluate(at_u + h, at_v) - surface.evaluate(at_u - h, at_v)) / (2 * h), atol=1e-6
    )
    np.testing.assert_allclose(
        by_v, (surface.evaluate(at_u, at_v + h) - surface.evaluate(at_u, at_v - h)) / (2 * h), atol=1e-6
    )


def test_noise_is_estimated_and_the_band_holds_when_interpolating():
    u, v = grid()
    surface = fit_error_surface(u, v, truth(u, v) + np.random.default_rng(3).normal(0.0, 0.01, u.size))
    assert surface.sigma_mm == pytest.approx(0.01, rel=0.08)
    at_u, at_v = between()
    ratio = (surface.evaluate(at_u, at_v) - truth(at_u, at_v)) / surface.sigma_at(at_u, at_v)
    assert np.std(ratio) == pytest.approx(1.0, abs=0.06)


def spoiled(seed=5):
    """The golden grid with noise, bounces (single ones and a burst), lost samples and a hole."""
    rng = np.random.default_rng(seed)
    u, v = grid()
    error = truth(u, v) + rng.normal(0.0, 0.01, u.size)
    bad = rng.choice(u.size, 60, replace=False)
    burst = np.flatnonzero((np.abs(u - U[64]) < 1e-9) & (v > 0.5) & (v < 0.62))
    bad = np.union1d(bad, burst)
    error[bad] += rng.uniform(0.3, 3.0, bad.size)
    error[rng.choice(u.size, 100, replace=False)] = np.nan
    hole = (np.abs(u - U[30]) < 7.5 * (U[1] - U[0])) & (np.abs(v - V[20]) < 5.5 * (V[1] - V[0]))
    error[hole] = np.nan
    return u, v, error, bad[np.isfinite(error[bad])]


def test_smoothing_finds_bad_samples_and_bridges_small_gaps_only():
    u, v, error, bad = spoiled()
    surface = fit_error_surface(u, v, error, mode="smooth")
    assert set(bad) <= set(surface.rejected)
    assert len(surface.rejected) <= bad.size + 3
    assert surface.sigma_mm == pytest.approx(0.01, rel=0.06)
    at_u, at_v = between()
    deviation = surface.evaluate(at_u, at_v) - truth(at_u, at_v)
    assert np.sqrt(np.nanmean(deviation**2)) < 0.006
    assert np.nanmax(np.abs(deviation)) < 0.05
    assert np.isnan(surface.evaluate(U[30], V[20]))
    lonely = np.flatnonzero(np.isnan(error) & ((u < 0.15) | (u > 0.4)))
    assert np.all(np.isfinite(surface.evaluate(u[lonely], v[lonely])))
    ratio = deviation / surface.sigma_at(at_u, at_v)
    assert 0.7 < np.sqrt(np.nanmean(ratio**2)) < 1.15
    assert judge_error_surface(surface, ErrorSurfaceLimits(max_rejected_share=0.05)).ok


def test_smoothing_scattered_samples():
    rng = np.random.default_rng(8)
    u, v = rng.uniform(0.05, 0.95, (2, 1500))
    surface = fit_error_surface(u, v, truth(u, v) + rng.normal(0.0, 0.01, u.size), mode="smooth", sigma_mm=0.01)
    at_u, at_v = rng.uniform(0.1, 0.9, (2, 1000))
    deviation = surface.evaluate(at_u, at_v) - truth(at_u, at_v)
    assert np.isnan(deviation).mean() < 0.01
    assert np.sqrt(np.nanmean(deviation**2)) < 0.01


def test_samples_along_scan_lines():
    rng = np.random.default_rng(8)
    v = np.repeat(np.linspace(0.1, 0.9, 12), 150)
    u = rng.uniform(0.05, 0.95, v.size)
    surface = fit_error_surface(u, v, 0.3 * np.sin(3 * u) + 0.2 * v**2 + rng.normal(0.0, 0.01, u.size), mode="smooth")
    at_u, at_v = rng.uniform(0.1, 0.9, (2, 1000))
    deviation = surface.evaluate(at_u, at_v) - (0.3 * np.sin(3 * at_u) + 0.2 * at_v**2)
    assert np.isnan(deviation).mean() < 0.02
    assert np.sqrt(np.nanmean(deviation**2)) < 0.004


def test_nothing_is_said_outside_the_measured_patch():
    u, v = grid()
    surface = fit_error_surface(u, v, truth(u, v))
    outside = surface.evaluate([0.01, 0.99, 0.5, 0.5, np.nan], [0.5, 0.5, 0.02, 0.95, 0.5])
    assert np.all(np.isnan(outside))
    assert np.all(np.isnan(surface.sigma_at([0.01, 0.5], [0.5, 0.95])))
    with pytest.raises(InputError, match="not measured"):
        surface.covariance_at([0.5, 0.99], [0.5, 0.5])


def test_lost_half_of_the_blade_is_not_bridged():
    u, v = grid(U[::4], V)
    kept = (v < 0.3) | (v > 0.7)
    surface = fit_error_surface(u[kept], v[kept], truth(u, v)[kept], mode="smooth")
    assert np.all(np.isnan(surface.evaluate(0.5, np.linspace(0.35, 0.65, 9))))
    assert np.isfinite(surface.evaluate(0.5, 0.2)) and np.isfinite(surface.evaluate(0.5, 0.8))


def test_l_shaped_patch_has_a_corner_without_answer():
    u, v = grid(np.linspace(0, 1, 21), np.linspace(0, 1, 21))
    kept = ~((u > 0.5) & (v > 0.5))
    surface = fit_error_surface(u[kept], v[kept], truth(u, v)[kept], mode="smooth")
    assert np.isnan(surface.evaluate(0.7, 0.7))
    assert np.isfinite(surface.evaluate(0.7, 0.3))


def test_json_round_trip():
    u, v, error, _ = spoiled()
    keep = u < 0.3
    for surface in (
        fit_error_surface(*grid(U[:9], V[:8]), truth(*grid(U[:9], V[:8])), info={"blade_type": "DR95"}),
        fit_error_surface(u[keep], v[keep], error[keep], mode="smooth"),
    ):
        text = json.dumps(surface.to_json_dict(), allow_nan=False)
        again = error_surface_from_json_dict(json.loads(text))
        at_u, at_v = between(200)
        np.testing.assert_array_equal(again.evaluate(at_u, at_v), surface.evaluate(at_u, at_v))
        np.testing.assert_allclose(again.sigma_at(at_u, at_v), surface.sigma_at(at_u, at_v))
        assert again.info == surface.info and list(again.rejected) == list(surface.rejected)


def test_damaged_json_is_refused():
    surface = fit_error_surface(*grid(U[:6], V[:6]), truth(*grid(U[:6], V[:6])))
    good = surface.to_json_dict()
    with pytest.raises(InputError, match="knots_u"):
        error_surface_from_json_dict({key: value for key, value in good.items() if key != "knots_u"})
    with pytest.raises(InputError, match="control points"):
        error_surface_from_json_dict({**good, "control_points_mm": good["control_points_mm"][1:]})
    with pytest.raises(InputError, match="degrees"):
        error_surface_from_json_dict({**good, "degrees": [2, 3]})
    with pytest.raises(InputError, match="cannot be read"):
        error_surface_from_json_dict({**good, "knots_v": ["a"]})


def test_average_of_blades_and_its_spread():
    rng = np.random.default_rng(1)
    u, v = grid(U[::4], V)
    surfaces = [
        fit_error_surface(u, v, truth(u, v) + offset + rng.normal(0, 0.003, u.size)) for offset in (-0.1, 0.0, 0.1)
    ]
    average = average_surfaces(surfaces)
    assert average.count == 3
    assert np.abs(average.mean.evaluate(u, v) - truth(u, v)).max() < 0.01
    np.testing.assert_allclose(average.offset_mm, [-0.1, 0.0, 0.1], atol=1e-3)
    assert average.spread_rms_mm == pytest.approx(0.1, rel=0.03)
    with pytest.raises(InputError, match="two"):
        average_surfaces(surfaces[:1])
    kept = ~((u > 0.5) & (v > 0.5))
    partial = fit_error_surface(u[kept], v[kept], truth(u, v)[kept], mode="smooth")
    shared = average_surfaces([surfaces[1], partial]).mean
    assert np.isnan(shared.evaluate(0.8, 0.8)) and abs(shared.evaluate(0.3, 0.3) - truth(0.3, 0.3)) < 0.01


def test_old_surface_that_no_longer_fits_is_noticed():
    u, v = grid(U[::4], V)
    rng = np.random.default_rng(6)
    old = fit_error_surface(u, v, truth(u, v) + rng.normal(0, 0.005, u.size))
    at_u, at_v = between(300)
    fresh = truth(at_u, at_v) + rng.normal(0, 0.005, at_u.size)
    fresh[:5] += 2.0
    same = surface_mismatch(old, at_u, at_v, fresh)
    assert judge_mismatch(same).ok and same.compared == 300
    moved = surface_mismatch(old, at_u, at_v, fresh + 0.1)
    verdict = judge_mismatch(moved)
    assert [reason.code for reason in verdict.reasons] == [Code.WRONG_MODEL]
    assert moved.mean_mm == pytest.approx(0.1, abs=0.05)
    with pytest.raises(InputError, match="still fits"):
        surface_mismatch(old, at_u[:10], at_v[:10], fresh[:10])


def test_interpolation_refuses_incomplete_grids_and_outliers():
    u, v = grid(U[::8], V[::2])
    error = truth(u, v)
    with pytest.raises(InputError, match=r"2 of \d+ grid nodes have no sample.*--smooth"):
        fit_error_surface(u[2:], v[2:], error[2:])
    lost = error.copy()
    lost[40] = np.nan
    with pytest.raises(InputError, match=r"1 of .*--smooth"):
        fit_error_surface(u, v, lost)
    dense_u, dense_v = grid()
    bounced = truth(dense_u, dense_v)
    bounced[2000] += 0.8
    with pytest.raises(InputError, match=r"u .* v .*off its neighbours.*--smooth") as caught:
        fit_error_surface(dense_u, dense_v, bounced)
    assert f"{dense_u[2000]:.5g}" in str(caught.value)
    with pytest.raises(InputError, match="given 2 times"):
        fit_error_surface(np.append(u, u[0]), np.append(v, v[0]), np.append(error, 0.3))
    rng = np.random.default_rng(0)
    with pytest.raises(InputError, match="not on a grid"):
        fit_error_surface(*rng.uniform(0, 1, (2, 50)), np.zeros(50))


def test_unusable_samples():
    u, v = grid(U[::8], V[::2])
    error = truth(u, v)
    broken = u.copy()
    broken[3] = np.nan
    with pytest.raises(InputError, match="Sample 4"):
        fit_error_surface(broken, v, error)
    with pytest.raises(InputError, match="at least 16"):
        fit_error_surface(u[:15], v[:15], error[:15])
    with pytest.raises(InputError, match="micrometres"):
        fit_error_surface(u, v, error * 1e3)
    with pytest.raises(FitError, match="one line"):
        fit_error_surface(np.full(40, 0.5), np.linspace(0, 1, 40), np.zeros(40), mode="smooth")
    wobble = 0.5 + 1e-7 * np.random.default_rng(0).normal(size=40)
    with pytest.raises(FitError, match="one line"):
        fit_error_surface(wobble, np.linspace(0, 1, 40), np.zeros(40), mode="smooth")
    with pytest.raises(InputError, match="swapped"):
        fit_error_surface(u, v * 3.0, error, domain=(0.0, 1.0, 0.0, 1.0))
    with pytest.raises(InputError, match="equal length"):
        fit_error_surface(u, v[1:], error)
    with pytest.raises(InputError, match="mode"):
        fit_error_surface(u, v, error, mode="magic")
    with pytest.raises(InputError, match="sigma_mm"):
        fit_error_surface(u, v, error, sigma_mm=-1.0)
    three = grid(U[::8], V[:3])
    with pytest.raises(InputError, match="at least 4"):
        fit_error_surface(*three, np.zeros(three[0].size))


def test_constant_and_large_errors():
    u, v = grid(U[::8], V[::2])
    for mode in ("interpolate", "smooth"):
        flat = fit_error_surface(u, v, np.full(u.size, 0.2), mode=mode)
        assert flat.evaluate(0.5, 0.5) == pytest.approx(0.2, abs=1e-9)
        assert judge_error_surface(flat).ok
    far = fit_error_surface(u, v, np.full(u.size, 8.0))
    assert [reason.code for reason in judge_error_surface(far).reasons] == [Code.OUTSIDE_LIMITS]


def test_noisy_surface_is_rejected_by_its_verdict():
    u, v = grid(U[::4], V)
    noisy = truth(u, v) + np.random.default_rng(0).normal(0, 0.2, u.size)
    codes = {reason.code for reason in judge_error_surface(fit_error_surface(u, v, noisy, mode="smooth")).reasons}
    assert codes == {Code.HELD_OUT_ERROR, Code.HIGH_RESIDUAL}
