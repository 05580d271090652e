from __future__ import annotations

from collections.abc import Callable

import numpy as np
import pytest

from devices.interfaces import DeadlineExceeded, Lost, Mount
from devices.sim import SimulatedCell, build_simulated_cell
from devices.sim.rays import PlaneSurface

Build = Callable[..., SimulatedCell]
BALL, FIXTURE = -2, -3


def at_ball(simulated: SimulatedCell, index: int = 0) -> np.ndarray:
    """Mount the ball, go to a pose of the stage step; the true ball centre in {S}."""
    cell = simulated.cell
    cell.operator.perform(Mount("ball"))
    cell.stage.home()
    pose = simulated.plan.stage_step[index]
    cell.robot.move_to(pose.base_from_flange)
    cell.stage.move_to(pose.stage)
    in_base = simulated.world.true_flange() @ np.append(simulated.truth.ball_in_flange_mm, 1.0)
    return (np.linalg.inv(simulated.world.base_from_scanner()) @ in_base)[:3]


def at_blade(simulated: SimulatedCell, scan: int) -> np.ndarray:
    """Clamp a blade, go to a pose of the fine step; the true work_from_scanner."""
    cell, pose = simulated.cell, simulated.plan.fine_step[scan]
    cell.operator.perform(Mount("blade", "DR95-0001"))
    cell.stage.home()
    cell.robot.move_to(pose.base_from_flange)
    cell.stage.move_to(pose.stage)
    work_from_measure = np.linalg.inv(simulated.truth.measure_from_work)
    return work_from_measure @ simulated.truth.measure_from_scanner_at(pose.stage)


def face_points(simulated: SimulatedCell, work_from_scanner: np.ndarray) -> dict[str, np.ndarray]:
    """Scanned points in {W} by face name."""
    points, face = simulated.cell.scanner.observe()  # type: ignore[attr-defined]
    in_work = points.reshape(-1, 3).astype(float) @ work_from_scanner[:3, :3].T + work_from_scanner[:3, 3]
    names = simulated.world.blade.solid.names
    return {name: in_work[face.ravel() == index] for index, name in enumerate(names) if name}


def test_ball_points_lie_on_the_true_sphere_on_the_side_that_camera_and_projector_see(quiet: Build) -> None:
    simulated = quiet()
    centre = at_ball(simulated)
    points, face = simulated.cell.scanner.observe()
    on_ball = points[face == BALL].astype(float)
    assert len(on_ball) > 1000
    # float32 at 220 mm resolves 1.5e-5 mm
    assert np.abs(np.linalg.norm(on_ball - centre, axis=1) - 19.988 / 2).max() < 5e-5
    normal = (on_ball - centre) / 9.994
    projector = np.array(simulated.plan.scanner.baseline_mm)
    for eye in (np.zeros(3), projector):
        way = eye - on_ball
        assert (np.einsum("ij,ij->i", normal, way / np.linalg.norm(way, axis=1, keepdims=True)) > 0.0).all()
    # the lit share of the disc that the camera sees: the far side from the projector is dark
    assert on_ball[:, 0].max() - centre[0] > 9.0
    assert centre[0] - on_ball[:, 0].min() < 9.0


def test_the_ball_shades_what_is_behind_it(quiet: Build) -> None:
    def fixture_points(baseline_mm: float) -> int:
        simulated = quiet()
        at_ball(simulated, 8)
        plan = simulated.plan.scanner
        object.__setattr__(plan, "baseline_mm", (baseline_mm, 0.0, 0.0))
        return int((simulated.cell.scanner.observe()[1] == FIXTURE).sum())

    assert fixture_points(120.0) < 0.98 * fixture_points(0.0)


def test_every_stage_and_base_pose_shows_the_ball(quiet: Build) -> None:
    simulated = quiet()
    cell = simulated.cell
    at_ball(simulated)
    for pose in (*simulated.plan.stage_step, *simulated.plan.base_step):
        cell.robot.move_to(pose.base_from_flange, speed_mm_s=250.0)
        cell.stage.move_to(pose.stage)
        assert (cell.scanner.observe()[1] == BALL).sum() > 800, pose.name


def test_datum_faces_of_the_scanned_blade_are_exact_and_both_areas_are_seen(quiet: Build) -> None:
    simulated = quiet()
    seen = face_points(simulated, at_blade(simulated, 0))
    assert len(seen["S2"]) > 1500 and len(seen["S3"]) > 800
    assert np.abs(seen["S3"][:, 0] - 37.0).max() < 1e-4
    skewed = np.array([np.sin(np.radians(8.0)), np.cos(np.radians(8.0)), 0.0])
    assert np.ptp(seen["S2"] @ skewed) < 1e-4
    seen = face_points(simulated, at_blade(simulated, 1))
    assert len(seen["S4"]) > 4000 and len(seen["S5"]) > 800 and len(seen["S6"]) > 1500
    assert np.abs(seen["S5"][:, 0] - 31.0).max() < 1e-4
    assert np.abs(np.hypot(seen["S4"][:, 1], seen["S4"][:, 2] + 688.0) - 900.0).max() < 1e-4


def test_rays_on_planes_are_exact_before_they_are_stored_as_float32(quiet: Build) -> None:
    world = quiet().world
    rng = np.random.default_rng(0)
    target = rng.uniform([-30, -20, -60], [30, 20, 210], (4000, 3))
    direction = rng.standard_normal((4000, 3))
    direction /= np.linalg.norm(direction, axis=1, keepdims=True)
    origin = target - 300.0 * direction
    hits = world.blade.scene.cast(origin, direction)
    checked = 0
    for index, surface in enumerate(world.blade.solid.surfaces):
        rows = np.flatnonzero(hits.face == index)
        if isinstance(surface, PlaneSurface) and len(rows):
            points = origin[rows] + hits.distance_mm[rows, None] * direction[rows]
            assert np.abs(points @ surface.normal - surface.offset_mm).max() < 1e-9
            checked += len(rows)
    assert checked > 300


def test_airfoil_points_lie_on_the_true_airfoil(quiet: Build) -> None:
    world = quiet().world
    airfoil = world.blade.airfoil
    rng = np.random.default_rng(1)
    u, v = rng.uniform(0.05, 0.95, 500), rng.uniform(0.1, 0.9, 500)
    goal, du, dv = airfoil.point_and_tangents(u, v)
    normal = airfoil.design.outward * np.cross(du, dv)
    normal /= np.linalg.norm(normal, axis=1, keepdims=True)
    hits = world.blade.scene.cast(goal + 5.0 * normal, -normal)
    on_airfoil = np.array([world.blade.solid.names[face] == "AIRFOIL" for face in hits.face])
    assert on_airfoil.mean() > 0.99
    assert np.abs(hits.distance_mm[on_airfoil] - 5.0).max() < 1e-6


def test_the_airfoil_error_is_the_one_that_was_asked_for(quiet: Build) -> None:
    truth = quiet().truth
    u, v = np.linspace(0.05, 0.95, 40), np.linspace(0.1, 0.9, 40)
    _, normal = quiet().world.blade.airfoil.design.at(u, v)
    expected = 0.5 * np.cos(4.0 * np.pi * v) + 0.5 * normal[:, 1]
    assert np.abs(truth.airfoil_error_mm(u, v) - expected).max() < 1e-4
    flat = quiet(truth={"blade.shape_error_mm": 0.0, "blade.airfoil_shift_mm": (0.0, 0.0, 0.0)}).truth
    assert np.abs(flat.airfoil_error_mm(u, v)).max() < 1e-4


def test_the_noise_lies_along_the_ray_with_the_size_that_was_asked_for(quiet: Build) -> None:
    simulated = quiet(truth={"scanner.noise_mm": 0.035, "scanner.noise_growth": 0.0})
    centre = at_ball(simulated)
    points, face = simulated.cell.scanner.observe()
    noisy = points[face == BALL].astype(float)
    ray = noisy / np.linalg.norm(noisy, axis=1, keepdims=True)
    along = ray @ centre
    true_reach = along - np.sqrt(along**2 - centre @ centre + 9.994**2)
    residual = np.linalg.norm(noisy, axis=1) - true_reach
    assert abs(residual.mean()) < 4.0 * 0.035 / np.sqrt(len(residual))
    assert residual.std() == pytest.approx(0.035, rel=4.0 / np.sqrt(2 * len(residual)))


def test_a_real_scan_has_gaps_ghosts_and_a_time() -> None:
    simulated = build_simulated_cell(seed=3)
    centre = at_ball(simulated)
    before = simulated.cell.clock.now_s()
    scan = simulated.cell.scanner.capture()
    assert scan.time_s == pytest.approx(before + 0.8)
    assert scan.points_mm.dtype == np.float32 and scan.points_mm.ndim == 3
    points = scan.valid_points_mm()
    assert 500 < len(points) < scan.points_mm.size // 3
    gap = np.abs(np.linalg.norm(points - centre, axis=1) - 9.994)
    near = gap < 3.0
    assert 0.005 < (gap[near] > 0.25).mean() < 0.2


def test_nothing_is_seen_outside_the_measuring_distance(quiet: Build) -> None:
    simulated = quiet()
    at_blade(simulated, 0)
    points = simulated.cell.scanner.capture().valid_points_mm()
    near, far = simulated.plan.scanner.near_mm, simulated.plan.scanner.far_mm
    assert points[:, 2].min() > near - 1e-3 and points[:, 2].max() < far + 1e-3


def test_stride_sets_the_resolution(quiet: Build) -> None:
    shapes = {name: quiet(resolution=name).cell.scanner._directions().shape for name in ("full", "demo", "test")}
    assert shapes["full"] == (1419, 2146, 3)
    assert shapes["demo"] == (355, 537, 3)
    assert shapes["test"] == (178, 269, 3)
    with pytest.raises(ValueError, match="stride"):
        quiet(resolution=0)


def test_a_lost_or_slow_scanner_says_so(quiet: Build) -> None:
    simulated = quiet()
    with pytest.raises(DeadlineExceeded, match=r"0\.5 s"):
        simulated.cell.scanner.capture(deadline_s=0.5)
    simulated.world.faults.lose("scanner")
    with pytest.raises(Lost):
        simulated.cell.scanner.capture()
