from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace

import numpy as np
import pytest

from devices.interfaces import DeadlineExceeded, Lost, Refused, StagePosition
from devices.sim import SimulatedCell, build_simulated_cell

Build = Callable[..., SimulatedCell]


def test_the_stage_is_homed_first_and_keeps_to_its_limits() -> None:
    stage = build_simulated_cell().cell.stage
    with pytest.raises(Refused, match="Home the stage"):
        stage.move_to(StagePosition(1.0, 0.0, 0.0))
    stage.home()
    stage.move_to(StagePosition(10.0, 0.0, 0.0))
    with pytest.raises(Refused, match=r"stage x cannot go from 10 to 161 mm: the limits are -160 to 160 mm"):
        stage.move_to(StagePosition(161.0, 0.0, 0.0))
    with pytest.raises(Refused, match="rad"):
        stage.move_to(StagePosition(0.0, 0.0, 0.0, 1.0))
    with pytest.raises(Refused, match="stage y"):
        stage.move_to(StagePosition(0.0, float("nan"), 0.0))
    assert stage.position().x_mm == 10.0


def test_a_move_takes_the_slowest_axis_time_and_reads_a_time() -> None:
    simulated = build_simulated_cell()
    stage, clock = simulated.cell.stage, simulated.cell.clock
    stage.home()
    before = clock.now_s()
    position = stage.move_to(StagePosition(40.0, 10.0, 0.0, np.deg2rad(10.0)))
    assert clock.now_s() - before == pytest.approx(40.0 / 20.0 + 0.1, abs=1e-3)
    assert position.time_s == clock.now_s() and not position.moving
    with pytest.raises(DeadlineExceeded):
        stage.move_to(StagePosition(-40.0, 0.0, 0.0), deadline_s=1.0)
    assert -40.0 < stage.position().x_mm < 40.0


def test_a_lost_stage_must_be_homed_again() -> None:
    simulated = build_simulated_cell()
    stage = simulated.cell.stage
    stage.home()
    simulated.world.faults.lose("stage")
    with pytest.raises(Lost):
        stage.position()
    simulated.world.faults.restore("stage")
    assert not stage.homed
    with pytest.raises(Refused, match="Home"):
        stage.move_to(StagePosition(1.0, 0.0, 0.0))


def test_the_stage_stands_where_it_says_within_its_repeatability() -> None:
    simulated = build_simulated_cell(seed=2)
    stage, miss = simulated.cell.stage, []
    stage.home()
    for x in np.linspace(-50.0, 50.0, 100):
        reported = stage.move_to(StagePosition(float(x), 0.0, 0.0))
        miss.append(simulated.world.stage_position.x_mm - reported.x_mm)
    # 100 draws: their spread is known to 7 %
    assert np.std(miss) == pytest.approx(0.003, rel=0.3)


def test_the_measuring_frame_is_tied_to_the_axes(quiet: Build) -> None:
    truth = quiet(seed=3).truth
    zero = StagePosition(0.0, 0.0, 0.0)
    at_zero = truth.measure_from_scanner
    assert np.abs(at_zero[:3, 3]).max() < 1e-12
    for axis, name in enumerate(("x_mm", "y_mm", "z_mm")):
        moved = truth.measure_from_scanner_at(replace(zero, **{name: 100.0}))
        assert moved[:3, 3] == pytest.approx(100.0 * truth.stage_axes[:, axis], abs=1e-9)
        assert np.array_equal(moved[:3, :3], at_zero[:3, :3])
    directions = truth.stage_axes / np.linalg.norm(truth.stage_axes, axis=0)
    assert directions[1:, 0] == pytest.approx([0.0, 0.0], abs=1e-12)
    assert directions[2, 1] == pytest.approx(0.0, abs=1e-12)
    square = np.rad2deg(np.arcsin([directions[:, i] @ directions[:, j] for i, j in ((0, 1), (0, 2), (1, 2))]))
    assert np.all((np.abs(square) > 0.03) & (np.abs(square) < 0.13))
    assert np.abs(np.linalg.norm(truth.stage_axes, axis=0) - 1.0).max() < 1.01e-4


def test_points_on_the_rotary_axis_stay_where_they_are(quiet: Build) -> None:
    truth = quiet(seed=3).truth
    direction, point = truth.rotary_axis
    assert np.linalg.norm(point) > 30.0
    for along in (-50.0, 0.0, 80.0):
        in_measure = point + along * direction
        in_scanner = np.linalg.inv(truth.measure_from_scanner) @ np.append(in_measure, 1.0)
        turned = truth.measure_from_scanner_at(StagePosition(0.0, 0.0, 0.0, 0.5)) @ in_scanner
        assert turned[:3] == pytest.approx(in_measure, abs=1e-9)
