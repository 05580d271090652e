from __future__ import annotations

from collections.abc import Callable

import numpy as np
import pytest

from devices.interfaces import DeadlineExceeded, Mount, TouchShaft
from devices.sim import SimulatedCell, build_simulated_cell

Build = Callable[..., SimulatedCell]
GRINDERS = ("rough", "fine")


def rigid(rotation: np.ndarray, translation: np.ndarray) -> np.ndarray:
    matrix = np.eye(4)
    matrix[:3, :3], matrix[:3, 3] = rotation, translation
    return matrix


def presenting(simulated: SimulatedCell, grinder: str, u: float, v: float, lift_mm: float = 0.0) -> np.ndarray:
    """base_from_flange that brings the design point (u, v) to the wheel, by the true frames."""
    design, plan = simulated.world.blade.airfoil.design, simulated.plan.grinders[grinder]
    at = np.array([u]), np.array([v])
    point, normal, along = design.on_grid(*at)[0, 0], design.normals_on_grid(*at)[0, 0], design.on_grid(*at, nv=1)[0, 0]
    y = along - normal * (normal @ along)
    y /= np.linalg.norm(y)
    work_from_contact = rigid(np.column_stack([np.cross(y, normal), y, normal]), point + lift_mm * normal)
    side = plan.contact_side
    axes = np.column_stack([[-side, 0, 0], [0, 0, 1], [0, side, 0]])
    tool_from_contact = rigid(axes, np.array([0.0, -side * plan.wheel_radius_mm, 0.0]))
    flange_from_work = simulated.truth.flange_from_work
    chain = simulated.truth.base_from_tool(grinder) @ tool_from_contact
    return chain @ np.linalg.inv(work_from_contact) @ np.linalg.inv(flange_from_work)


def with_blade(simulated: SimulatedCell) -> SimulatedCell:
    simulated.cell.operator.perform(Mount("blade", "DR95-0001"))
    return simulated


@pytest.fixture
def exact(quiet: Build) -> SimulatedCell:
    """A cell whose robot goes exactly where it says."""
    return with_blade(quiet(truth={"robot.absolute_rms_mm": 1e-9}))


@pytest.mark.parametrize("grinder", GRINDERS)
def test_the_wheel_just_touches_the_airfoil(exact: SimulatedCell, grinder: str) -> None:
    world = exact.world
    for u, v in ((0.1, 0.2), (0.35, 0.5), (0.5, 0.7), (0.7, 0.4), (0.95, 0.9)):
        flange = presenting(exact, grinder, u, v)
        contact = world.contact(grinder, world.true_flange_of(flange))
        assert contact is not None
        fine_u = np.linspace(max(contact.u - 0.02, 0.0), min(contact.u + 0.02, 1.0), 201)
        fine_v = np.linspace(max(contact.v - 0.04, 0.0), min(contact.v + 0.04, 1.0), 81)
        grid_u, grid_v = (axis.ravel() for axis in np.meshgrid(fine_u, fine_v, indexing="ij"))
        points, _, _ = world.blade.airfoil.point_and_tangents(grid_u, grid_v)
        # distance to a torus, written out once more in {B}
        base_from_work = world.true_flange_of(flange) @ exact.truth.flange_from_work
        in_base = points @ base_from_work[:3, :3].T + base_from_work[:3, 3]
        head = world.head(grinder)
        offset = in_base - head.centre_at(contact.angle_rad)
        along = offset @ head.axis
        radial = np.linalg.norm(offset - np.outer(along, head.axis), axis=1)
        gap = np.hypot(radial - 45.0, along) - 15.0
        assert -1e-6 < gap.min() < 2e-3  # the grid of 0.03 mm need not hold the touching point itself
        assert abs(along[np.argmin(gap)]) < 8.0  # on the belt
        whole = world.blade.airfoil.points[::2, ::2].reshape(-1, 3)
        whole = whole @ base_from_work[:3, :3].T + base_from_work[:3, 3]
        assert head.distances(whole, contact.angle_rad).min() > -0.02


@pytest.mark.parametrize("grinder", GRINDERS)
def test_the_normal_error_is_the_airfoils_to_first_order(exact: SimulatedCell, grinder: str) -> None:
    u = np.repeat(np.linspace(0.04, 0.96, 8), 3)
    v = np.tile([0.1, 0.45, 0.85], 8)
    poses = [presenting(exact, grinder, a, b) for a, b in zip(u, v, strict=True)]
    found = [exact.world.true_normal_error(grinder, pose) for pose in poses]
    expected = exact.truth.airfoil_error_mm(u, v)
    assert np.abs(expected).max() > 0.7
    # second order: the slope of the error moves the touching point
    assert np.abs(np.array(found) - expected).max() < 0.02


@pytest.mark.parametrize("grinder", GRINDERS)
def test_a_perfect_airfoil_on_a_perfect_robot_leaves_nothing(quiet: Build, grinder: str) -> None:
    flawless = {"robot.absolute_rms_mm": 1e-9, "blade.shape_error_mm": 0.0, "blade.airfoil_shift_mm": (0.0, 0.0, 0.0)}
    simulated = with_blade(quiet(truth=flawless))
    for u, v in ((0.06, 0.1), (0.3, 0.5), (0.52, 0.3), (0.8, 0.9)):
        assert abs(simulated.world.true_normal_error(grinder, presenting(simulated, grinder, u, v))) < 1e-5
        # lifted off by 0.3 mm the wheel follows by 0.3 mm
        lifted = simulated.world.true_normal_error(grinder, presenting(simulated, grinder, u, v, 0.3))
        assert lifted == pytest.approx(-0.3, abs=2e-3)


@pytest.mark.parametrize("grinder", GRINDERS)
def test_moving_the_contact_outward_by_the_error_brings_the_wheel_back(quiet: Build, grinder: str) -> None:
    simulated = with_blade(quiet(seed=3))
    left = []
    for u, v in ((0.06, 0.1), (0.3, 0.25), (0.52, 0.6), (0.8, 0.9)):
        error = simulated.world.true_normal_error(grinder, presenting(simulated, grinder, u, v))
        left.append(simulated.world.true_normal_error(grinder, presenting(simulated, grinder, u, v, error)))
        assert abs(error) > 0.1
    assert np.abs(left).max() < 1e-3


@pytest.mark.parametrize("grinder", GRINDERS)
def test_the_whole_profile_can_be_presented(quiet: Build, grinder: str) -> None:
    simulated = with_blade(quiet(seed=2))
    robot = simulated.cell.robot
    for v in (0.03, 0.94):
        for u in np.linspace(0.02, 0.98, 9):
            robot.move_to(presenting(simulated, grinder, float(u), v), speed_mm_s=250.0)
            assert abs(simulated.cell.grinders[grinder].read().angle_rad) < np.deg2rad(1.0)


def test_the_sensor_reads_the_contact_in_its_own_steps(exact: SimulatedCell) -> None:
    cell, world = exact.cell, exact.world
    for grinder, side in (("rough", 1), ("fine", -1)):
        assert cell.grinders[grinder].read().angle_rad == pytest.approx(-side * np.deg2rad(30.0), abs=1e-5)
        assert cell.grinders[grinder].read().force_N == 0.0
        flange = presenting(exact, grinder, 0.3, 0.25)
        cell.robot.move_to(flange)
        reading = cell.grinders[grinder].read()
        step = 2.0 * np.pi / 2**19
        assert reading.angle_rad / step == pytest.approx(round(reading.angle_rad / step), abs=1e-6)
        error = world.true_normal_error(grinder, flange)
        # exact: n . (Rot - I)(K0 - O) = side Rg sin(angle)
        assert side * 180.0 * np.sin(reading.angle_rad) == pytest.approx(error, abs=180.0 * step)
        assert reading.force_N > 20.0


def test_a_worn_wheel_and_a_shifted_zero_show(exact: SimulatedCell) -> None:
    cell, world = exact.cell, exact.world
    flange = presenting(exact, "fine", 0.3, 0.25)
    cell.robot.move_to(flange)
    before, read_before = world.true_normal_error("fine", flange), cell.grinders["fine"].read().angle_rad
    world.faults.shift_angle_zero("fine", 0.002)
    assert cell.grinders["fine"].read().angle_rad - read_before == pytest.approx(0.002, abs=1.3e-5)
    world.faults.wear_wheel("fine", 0.4)
    assert world.true_normal_error("fine", flange) - before == pytest.approx(-0.4, abs=5e-3)


def test_bounced_and_lost_samples_come_at_their_rates(quiet: Build) -> None:
    simulated = with_blade(quiet(truth={"grinder.bounce_share": 0.1, "grinder.lost_share": 0.05}))
    simulated.cell.robot.move_to(presenting(simulated, "rough", 0.3, 0.25))
    angles, lost = [], 0
    for _ in range(600):
        try:
            angles.append(simulated.cell.grinders["rough"].read().angle_rad)
        except DeadlineExceeded:
            lost += 1
    off_mm = np.abs(np.array(angles) - np.median(angles)) * 180.0
    assert lost / 600 == pytest.approx(0.05, abs=4.0 * np.sqrt(0.05 * 0.95 / 600))
    assert (off_mm > 0.1).mean() == pytest.approx(0.1, abs=4.0 * np.sqrt(0.1 * 0.9 / 600))
    assert 0.19 < off_mm[off_mm > 0.1].min() and off_mm.max() < 1.01


def test_out_of_reach_there_is_no_contact(exact: SimulatedCell) -> None:
    away = presenting(exact, "rough", 0.3, 0.25, 150.0)
    assert np.isnan(exact.world.true_normal_error("rough", away))
    with pytest.raises(KeyError, match="rough, fine"):
        exact.world.true_normal_error("medium", away)


def test_held_heads_are_let_go_when_the_robot_moves() -> None:
    simulated = build_simulated_cell()
    cell = simulated.cell
    cell.operator.perform(Mount("stylus"))
    cell.operator.perform(TouchShaft("rough", np.deg2rad(10.0)))
    assert cell.grinders["rough"].read().angle_rad == pytest.approx(np.deg2rad(10.0), abs=np.deg2rad(1.0))
    cell.robot.move_to(simulated.plan.base_step[0].base_from_flange)
    assert cell.grinders["rough"].read().angle_rad == pytest.approx(np.deg2rad(-30.0), abs=1e-3)
