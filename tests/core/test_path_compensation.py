"""The proof that matters: what the head still feels along the compensated path, between the samples."""

from pathlib import Path

import numpy as np
import pytest

from benchmarks.error_surface_golden import (
    GOLDEN_V,
    EllipseBlade,
    Wheel,
    follow_surface,
    head_error,
)
from core.cad import read_step
from core.error_surface import fit_error_surface, normal_error
from core.path import CellFrames, PatternSettings, plan_path, work_from_contact, write_urscript
from core.path.urscript import verify_program

U = np.linspace(0.02, 0.98, 65)
V = np.linspace(0.02817023, 0.94663445, 40)
RIGID = np.eye(4)


@pytest.fixture(scope="module")
def measured():
    """Errors by way of the head's angle, as the cell measures them, with 2 um of noise."""
    blade, wheel = EllipseBlade(), Wheel()
    u, v = (axis.ravel() for axis in np.meshgrid(U, V, indexing="ij"))
    moved = head_error(blade, wheel, work_from_contact(blade, u, v), u, v)
    moved = moved + np.random.default_rng(0).normal(0, 0.002, u.size)
    angle = np.arcsin(moved / wheel.lever_mm)
    return blade, wheel, fit_error_surface(u, v, normal_error(angle, [0.0, 1.0, 0.0], wheel.lever_mm))


def test_golden_trajectories_are_left_with_micrometres(measured):
    blade, wheel, surface = measured
    pattern = PatternSettings("transverse", (U[0], U[-1]), (V[0], V[-1]), positions=GOLDEN_V, step_mm=3.1)
    plan = plan_path(blade, CellFrames(RIGID, RIGID, 60.0, 1), pattern, error_surface=surface)
    assert len(plan.strokes) == 6
    before, after = [], []
    for stroke in plan.strokes:
        before.append(head_error(blade, wheel, stroke.nominal_work_from_contact, stroke.u, stroke.v))
        after.append(head_error(blade, wheel, stroke.work_from_contact, stroke.u, stroke.v))
    assert np.sqrt(np.mean(np.concatenate(before) ** 2)) > 0.3
    assert np.sqrt(np.mean(np.concatenate(after) ** 2)) < 0.003
    assert np.abs(np.concatenate(after)).max() < 0.01


def test_lines_between_the_samples(measured):
    blade, wheel, surface = measured
    pattern = PatternSettings("longitudinal", (0.1, 0.9), (V[0], V[-1]), positions=(0.1234, 0.5, 0.777), step_mm=4.3)
    plan = plan_path(blade, CellFrames(RIGID, RIGID, 60.0, 1), pattern, error_surface=surface)
    for stroke in plan.strokes:
        left = head_error(blade, wheel, stroke.work_from_contact, stroke.u, stroke.v)
        assert np.sqrt(np.mean(left**2)) < 0.003
        turned = follow_surface(blade, surface, stroke.u[1:-1], stroke.v[1:-1], wheel)
        worse = head_error(blade, wheel, turned, stroke.u[1:-1], stroke.v[1:-1])
        assert np.sqrt(np.mean(worse**2)) > np.sqrt(np.mean(left**2))


def test_real_blade_from_its_step_file():
    path = Path(__file__).parents[2] / "resources" / "blades" / "dr95.step"
    airfoil = read_step(path).spline_surface("AIRFOIL")
    u, v = (axis.ravel() for axis in np.meshgrid(np.linspace(0.02, 0.98, 65), V, indexing="ij"))
    surface = fit_error_surface(u, v, 0.5 * np.cos(4 * np.pi * v) + 0.2 * u)
    pattern = PatternSettings("transverse", (0.02, 0.98), (V[0], V[-1]), positions=GOLDEN_V, step_mm=3.0)
    plan = plan_path(airfoil, CellFrames(RIGID, RIGID, 60.0, -1), pattern, error_surface=surface)
    for stroke in plan.strokes:
        feet = airfoil.closest(stroke.work_from_contact[:, :3, 3], np.column_stack([stroke.u, stroke.v]))
        np.testing.assert_allclose(feet.distance_mm, stroke.error_mm, atol=1e-6)
        assert np.all(stroke.work_from_contact[:, 2, 1] > 0.9)
    assert verify_program(plan, write_urscript(plan, _settings())).max_contact_mm < 1e-3


def _settings():
    from core.path import ProgramSettings

    return ProgramSettings(speed_mm_s=40.0, blade_type="DR95", date="2031-02-03")
