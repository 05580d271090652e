"""Leave-one-out errors and covariance against brute force; the banded inverse against the dense one."""

from itertools import pairwise

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from scipy.interpolate import BSpline

from core.error_surface import fit_error_surface
from core.error_surface.banded import BandedFactor


def small(seed, nu=7, nv=6):
    rng = np.random.default_rng(seed)
    lines_u = np.sort(rng.uniform(0.0, 1.0, nu)) + np.linspace(0, 0.6, nu)
    lines_v = np.sort(rng.uniform(0.0, 1.0, nv)) + np.linspace(0, 0.6, nv)
    u, v = (axis.ravel() for axis in np.meshgrid(lines_u, lines_v, indexing="ij"))
    return u, v, np.sin(4.0 * u) * np.cos(2.0 * v) + rng.normal(0, 0.05, u.size)


def integral(first, second):
    """Integral of the product of two sets of piecewise cubics by a fine midpoint rule with Gauss points."""
    nodes, weights = np.polynomial.legendre.leggauss(5)
    breaks = np.unique(np.concatenate([first.t, second.t]))
    total = 0.0
    for low, high in pairwise(breaks):
        x = 0.5 * (low + high) + 0.5 * (high - low) * nodes
        total = total + 0.5 * (high - low) * (first(x).T * weights) @ second(x)
    return total


@pytest.mark.parametrize("seed", [0, 1])
def test_interpolation_against_refits_without_the_sample(seed):
    u, v, error = small(seed)
    surface = fit_error_surface(u, v, error)
    su, sv = (BSpline(knots, np.eye(knots.size - 4), 3) for knots in (surface.knots_u, surface.knots_v))
    hu, hv = (np.mean(np.diff(np.unique(x))) for x in (u, v))
    mu, ku, bu = (integral(su.derivative(k) if k else su, su.derivative(k) if k else su) for k in range(3))
    mv, kv, bv = (integral(sv.derivative(k) if k else sv, sv.derivative(k) if k else sv) for k in range(3))
    energy = (
        np.kron(bu * hu**3, mv / hv) + 2.0 * np.kron(ku * hu, kv * hv) + np.kron(mu / hu, bv * hv**3)
    )
    design = (su(u)[:, :, None] * sv(v)[:, None, :]).reshape(u.size, -1)
    for left_out in range(0, u.size, 5):
        rest = np.delete(np.arange(u.size), left_out)
        n, m = energy.shape[0], rest.size
        # Least bending energy subject to passing through all the other samples.
        system = np.block([[energy, design[rest].T], [design[rest], np.zeros((m, m))]])
        solution = np.linalg.lstsq(system, np.concatenate([np.zeros(n), error[rest]]), rcond=None)[0][:n]
        expected = error[left_out] - design[left_out] @ solution
        assert surface.leave_one_out_mm[left_out] == pytest.approx(expected, abs=1e-6)


@pytest.mark.parametrize("options", [{}, {"intervals": (2, 3)}])
def test_smoothing_against_refits_without_the_sample(options):
    rng = np.random.default_rng(4)
    u, v = rng.uniform(0, 1, (2, 120))
    u[:4], v[:4] = [0, 0, 1, 1], [0, 1, 0, 1]
    error = np.sin(3 * u) * v + rng.normal(0, 0.02, u.size)
    surface = fit_error_surface(u, v, error, mode="smooth", reject=False, **options)
    fixed = {"mode": "smooth", "reject": False, "penalty": surface.penalty, "intervals": options.get("intervals")}
    compared = 0
    for left_out in range(4, u.size, 6):
        rest = np.delete(np.arange(u.size), left_out)
        refit = fit_error_surface(u[rest], v[rest], error[rest], **fixed, reach_steps=np.inf)
        same_knots = refit.knots_u.size == surface.knots_u.size
        predicted = refit.evaluate(u[left_out], v[left_out])
        if same_knots and np.isfinite(predicted):
            compared += 1
            assert surface.leave_one_out_mm[left_out] == pytest.approx(error[left_out] - predicted, abs=2e-6)
    assert compared > 10


def test_regression_covariance_is_the_spread_over_noise():
    rng = np.random.default_rng(9)
    lines = np.linspace(0, 1, 14)
    u, v = (axis.ravel() for axis in np.meshgrid(lines, lines, indexing="ij"))
    at = np.array([0.03, 0.4, 0.77]), np.array([0.5, 0.98, 0.2])
    runs = []
    for _ in range(150):
        surface = fit_error_surface(
            u, v, u**2 * v + rng.normal(0, 0.02, u.size), mode="smooth", intervals=(2, 2), sigma_mm=0.02, reject=False
        )
        runs.append(surface.evaluate(*at) - at[0] ** 2 * at[1])
    nees = np.mean([run @ np.linalg.solve(surface.covariance_at(*at), run) for run in runs]) / 3
    assert nees == pytest.approx(1.0, abs=3.0 * np.sqrt(2.0 / 450))
    np.testing.assert_allclose(np.sqrt(np.diag(surface.covariance_at(*at))), surface.sigma_at(*at), rtol=1e-8)


@settings(derandomize=True, deadline=None, max_examples=20)
@given(st.integers(0, 10**6), st.integers(1, 6), st.integers(7, 20))
def test_inverse_inside_the_band(seed, width, n):
    rng = np.random.default_rng(seed)
    lower = np.tril(np.triu(rng.normal(size=(n, n)), -width)) + 2.0 * np.eye(n)
    dense = lower @ lower.T + 0.1 * np.eye(n)
    band = np.zeros((width + 1, n))
    for offset in range(width + 1):
        band[offset, : n - offset] = np.diagonal(dense, -offset)
    factor = BandedFactor.of(band)
    inverse = np.linalg.inv(dense)
    found = factor.inverse_band()
    for offset in range(width + 1):
        np.testing.assert_allclose(found[offset, : n - offset], np.diagonal(inverse, -offset), rtol=1e-6, atol=1e-9)
    assert factor.log_determinant() == pytest.approx(np.linalg.slogdet(dense)[1], rel=1e-9)
