"""Pieces of the fine step against sums and derivatives worked out the slow way."""

import numpy as np
import pytest
import shapely
from hypothesis import given, settings
from hypothesis import strategies as st
from scipy.spatial.transform import Rotation

from core.cad import Cylinder, Patch, Plane
from core.errors import InputError
from core.fine.boxes import distances, gather, make_target
from core.fine.moments import accumulate, solve_moments
from core.fine.noise import fit_mixture, shortest_half_sigma
from core.fine.settings import FineSettings
from core.fine.trim_field import trim_field
from core.frames import perturbed

X, Y, Z = np.eye(3)
PLANE = Plane(np.array([1.0, 2.0, 3.0]), Z, X, Y)
CYLINDER = Cylinder(np.array([5.0, 0.0, 0.0]), np.array([0.0, 0.0, 1.0]), np.array([1.0, 0.0, 0.0]), 12.0, 1)


def random_pose(rng):
    pose = np.eye(4)
    pose[:3, :3] = Rotation.random(random_state=rng).as_matrix()
    pose[:3, 3] = rng.uniform(-300.0, 300.0, 3)
    return pose


def to_measure(pose, points):
    return points @ pose[:3, :3].T + pose[:3, 3]


def test_trim_field_knows_holes_and_the_distance_to_the_edge():
    trim = shapely.box(0, 0, 40, 20).difference(shapely.Point(20, 10).buffer(5))
    field = trim_field(PLANE, trim)
    rng = np.random.default_rng(1)
    s, t = rng.uniform(-5, 45, 3000), rng.uniform(-5, 25, 3000)
    places = shapely.points(s, t)
    truth = shapely.distance(places, trim.boundary)
    inside = shapely.contains(trim, places)
    depth = field.depth_at(s, t)
    clear = truth > 2 * field.cell_mm
    assert np.all(depth[clear & ~inside] < 0.0)
    assert np.abs(depth - truth)[clear & inside].max() < 1.5 * field.cell_mm
    assert field.area_mm2(0.0) == pytest.approx(trim.area, rel=0.01)
    assert field.area_mm2(1.0) == pytest.approx(trim.buffer(-1.0).area, rel=0.01)


def test_a_full_cylinder_has_no_edge_at_its_seam():
    half = np.pi * 12.0
    field = trim_field(CYLINDER, shapely.box(-half, -10, half, 10))
    s = np.array([-half + 0.01, half - 0.01, half + 0.5, 0.0])
    assert np.abs(field.depth_at(s, np.zeros(4)) - 10.0).max() < 2 * field.cell_mm
    assert np.all(field.depth_at(s, np.full(4, 10.5)) < 0.0)


def test_a_point_in_two_boxes_belongs_to_none():
    other = Plane(np.array([1.0, 2.0, 3.0]), Y, Z, X)
    targets = [make_target(Patch(surface, (i,), str(i), shapely.box(-10, -10, 10, 10)))
               for i, surface in enumerate((PLANE, other), start=1)]
    pose = random_pose(np.random.default_rng(2))
    points = np.array([[1.0, 7.0, 3.1], [1.0, 2.1, 8.0], [1.0, 2.05, 3.05], [1.0, 7.0, 8.0]])
    boxes = gather(targets, to_measure(pose, points), pose, half_thickness_mm=0.2, margin_mm=0.5)
    assert [box.index.tolist() for box in boxes] == [[0], [1]]


@settings(max_examples=15, deadline=None, derandomize=True)
@given(st.integers(0, 10_000))
def test_moments_give_the_sums_over_the_points_and_their_derivative(seed):
    rng = np.random.default_rng(seed)
    pose = random_pose(rng)
    for surface in (PLANE, CYLINDER):
        target = make_target(Patch(surface, (1,), "face", shapely.box(-15, -15, 15, 15)))
        inner = surface.from_surface(rng.uniform(-14, 14, 50), rng.uniform(-14, 14, 50), rng.normal(0, 0.05, 50))
        points, weights = to_measure(pose, inner), rng.random(50)
        centre = points.mean(axis=0)
        moments = accumulate(target, points, weights, pose, centre)
        jacobian = np.empty((50, 6))
        for k in range(6):
            change = np.zeros(6)
            change[k] = 1e-6
            ahead = distances(target, points, perturbed(pose, change, centre))
            jacobian[:, k] = -(ahead - distances(target, points, perturbed(pose, -change, centre))) / 2e-6
        d = distances(target, points, pose)
        matrix, right = moments.normal_equations(pose)
        assert matrix == pytest.approx((jacobian.T * weights) @ jacobian, rel=1e-5, abs=1e-3)
        assert right == pytest.approx(jacobian.T @ (weights * d), rel=1e-5, abs=1e-4)
        row, mean = moments.mean_row(pose)
        assert row == pytest.approx(weights @ jacobian / weights.sum(), rel=1e-5, abs=1e-4)
        assert mean == pytest.approx(weights @ d / weights.sum(), abs=1e-9)


def test_plane_moments_hold_at_a_pose_other_than_that_of_the_pass():
    rng = np.random.default_rng(5)
    pose = random_pose(rng)
    axes = np.eye(3)
    planes = [Plane(rng.uniform(-20, 20, 3), axes[i], axes[(i + 1) % 3], axes[(i + 2) % 3]) for i in range(3)]
    moments, centre = [], pose[:3, 3]
    for plane in planes:
        target = make_target(Patch(plane, (1,), "plane", shapely.box(-15, -15, 15, 15)))
        points = to_measure(pose, plane.from_surface(rng.uniform(-14, 14, 80), rng.uniform(-14, 14, 80)))
        moments.append(accumulate(target, points, np.ones(80), pose, centre))
    start = perturbed(pose, [0.03, -0.02, 0.04, 1.0, -2.0, 0.5], centre)
    solved = solve_moments(moments, [1.0] * 3, start, centre, lever_mm=20.0, rounds=30)
    assert np.abs(solved - pose).max() < 1e-7


def test_one_sided_strangers_do_not_move_the_estimate():
    rng = np.random.default_rng(3)
    sigma, n = 0.035, 40_000
    ghosts = -rng.uniform(0.0, 1.0, n // 4) + rng.normal(0, sigma, n // 4)
    d = np.concatenate([rng.normal(0, sigma, n), ghosts])
    mixture = fit_mixture(d, 0.05)
    assert mixture.sigma_mm == pytest.approx(sigma, rel=0.03)
    shift = 0.0
    for _ in range(20):
        w = mixture.weights(d - shift)
        shift += float(w @ (d - shift) / w.sum())
    assert abs(shift) < 4 * sigma / np.sqrt(n)
    # The symmetric cut at four sigmas is pulled ten times as far.
    cut = np.abs(d) < 4 * sigma
    assert abs(d[cut].mean()) > 4 * abs(shift)
    assert mixture.behind > 20 * mixture.front


def test_without_strangers_hardly_any_efficiency_is_lost():
    mixture = fit_mixture(np.random.default_rng(4).normal(0, 0.02, 20_000), 0.03)
    mean_weight, slope, square = mixture.efficiency()
    assert mean_weight == pytest.approx(1.0, abs=0.01)
    assert slope**2 / square > 0.98


def test_known_scatter_is_kept():
    assert fit_mixture(np.random.default_rng(4).normal(0, 0.02, 500), 0.05, sigma_known=0.021).sigma_mm == 0.021


def test_shortest_half_stands_a_third_of_strangers_on_one_side():
    rng = np.random.default_rng(6)
    d = np.concatenate([rng.normal(0, 0.03, 6000), rng.uniform(0.1, 1.5, 3000)])
    sigma, middle = shortest_half_sigma(d)
    assert 0.03 < sigma < 0.06
    assert abs(middle) < 0.02


@pytest.mark.parametrize("change", [{"sigma_mm": 0.0}, {"capture_mm": -1.0}, {"edge_margin_mm": 3.0},
                                    {"half_thickness_mm": float("nan")}])
def test_settings_that_cannot_be_meant_are_refused(change):
    with pytest.raises(InputError):
        FineSettings(**change)
