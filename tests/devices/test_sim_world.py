from __future__ import annotations

from collections.abc import Callable

import numpy as np
import pytest

from devices.interfaces import Mount, TouchCone
from devices.sim import SimulatedCell, build_simulated_cell

Build = Callable[..., SimulatedCell]


def a_short_day(seed: int, readings: int = 1) -> list[np.ndarray]:
    simulated = build_simulated_cell(seed=seed, resolution=16)
    cell, pose = simulated.cell, simulated.plan.fine_step[0]
    cell.stage.home()
    cell.operator.perform(Mount("stylus"))
    cell.operator.perform(TouchCone(0, 1))
    touch = cell.robot.read().base_from_flange
    cell.operator.perform(Mount("blade", "A"))
    cell.robot.move_to(pose.base_from_flange)
    cell.stage.move_to(pose.stage)
    for _ in range(readings):
        angle = cell.grinders["fine"].read().angle_rad
    scan = cell.scanner.capture().points_mm
    return [touch, scan, simulated.truth.flange_from_work, np.array([angle])]


def test_the_seed_decides_everything() -> None:
    first, again, other = a_short_day(1), a_short_day(1), a_short_day(2)
    for mine, same, different in zip(first[:3], again[:3], other[:3], strict=True):
        assert np.array_equal(mine, same, equal_nan=True)
        assert not np.array_equal(mine, different, equal_nan=True)


def test_what_one_device_does_does_not_change_what_another_sees() -> None:
    few, many = a_short_day(1), a_short_day(1, readings=25)
    assert np.array_equal(few[1], many[1], equal_nan=True)


def test_every_clamping_has_its_own_error_of_the_right_size() -> None:
    simulated = build_simulated_cell()
    world, clampings = simulated.world, []
    for serial in ("A", "A", "B"):
        simulated.cell.operator.perform(Mount("blade", serial))
        clampings.append(simulated.truth.flange_from_work)
    for clamping in clampings:
        error = np.linalg.inv(world.nominal_flange_from_work) @ clamping
        assert np.linalg.norm(error[:3, 3]) == pytest.approx(1.8)
        assert np.rad2deg(np.arccos((np.trace(error[:3, :3]) - 1.0) / 2.0)) == pytest.approx(1.2)
    assert not np.allclose(clampings[0], clampings[1]) and not np.allclose(clampings[0], clampings[2])
    again = build_simulated_cell()
    again.cell.operator.perform(Mount("blade", "A"))
    assert np.array_equal(again.truth.flange_from_work, clampings[0])


def test_the_nominal_clamping_is_the_blade_types_own() -> None:
    assert build_simulated_cell().world.nominal_flange_from_work[:3, 3] == pytest.approx([0.0, 0.0, 128.0])


def test_the_unknown_places_are_off_by_what_was_asked_for() -> None:
    simulated = build_simulated_cell(seed=11)
    plan, truth = simulated.plan, simulated.truth
    assert np.linalg.norm(truth.base_from_measure[:3, 3] - plan.base_from_measure[:3, 3]) == pytest.approx(6.0)
    assert np.linalg.norm(truth.ball_in_flange_mm - plan.ball.nominal_in_flange_mm) == pytest.approx(2.0)
    assert np.linalg.norm(truth.tip_in_flange_mm - plan.stylus.nominal_tip_in_flange_mm) == pytest.approx(2.0)
    assert np.linalg.norm(truth.cone_in_base_mm - plan.stylus.cone_in_base_mm) == pytest.approx(5.0)
    for name, grinder in plan.grinders.items():
        tool = truth.base_from_tool(name)
        assert np.linalg.norm(tool[:3, 3] - grinder.base_from_tool[:3, 3]) == pytest.approx(3.0)
        point, direction = truth.head_axis(name)
        assert tool[:3, 3] - point == pytest.approx(180.0 * tool[:3, 0], abs=1e-9)
        assert direction == pytest.approx(tool[:3, 2])


def test_a_blade_that_slips_between_two_scans_is_elsewhere_until_it_is_clamped_again(quiet: Build) -> None:
    simulated = quiet()
    simulated.cell.operator.perform(Mount("blade", "A"))
    before = simulated.truth.flange_from_work
    simulated.world.faults.slip_blade([0.0, 0.0, 0.3], [0.0, 0.0, 0.01])
    after = simulated.truth.flange_from_work
    slip = np.linalg.inv(before) @ after
    assert slip[:3, 3] == pytest.approx([0.0, 0.0, 0.3])
    assert slip[1, 0] == pytest.approx(np.sin(0.01))
    simulated.cell.operator.perform(Mount("blade", "A"))
    assert np.array_equal(simulated.world.faults.blade_slip, np.eye(4))


def test_a_knocked_ball_is_seen_elsewhere(quiet: Build) -> None:
    simulated = quiet()
    cell = simulated.cell
    cell.operator.perform(Mount("ball"))
    cell.robot.move_to(simulated.plan.stage_step[0].base_from_flange)
    before = simulated.truth.ball_in_measure_mm
    points_before = cell.scanner.observe()
    simulated.world.faults.move_ball([0.5, 0.0, 0.0])
    assert np.linalg.norm(simulated.truth.ball_in_measure_mm - before) == pytest.approx(0.5)
    points_after = cell.scanner.observe()
    seen = [points[face == -2].mean(axis=0) for points, face in (points_before, points_after)]
    assert 0.3 < np.linalg.norm(seen[1] - seen[0]) < 0.7
