from __future__ import annotations

from collections.abc import Callable

import numpy as np
import pytest

from devices.interfaces import DeadlineExceeded, Mount, Refused, TouchCone, TouchShaft
from devices.sim import SimulatedCell, build_simulated_cell

Build = Callable[..., SimulatedCell]


def tip_in_base(simulated: SimulatedCell) -> np.ndarray:
    return (simulated.world.true_flange() @ np.append(simulated.truth.tip_in_flange_mm, 1.0))[:3]


def test_without_touch_noise_the_true_tip_is_in_the_cone_at_every_touch(quiet: Build) -> None:
    simulated = quiet()
    cell = simulated.cell
    cell.operator.perform(Mount("stylus"))
    count = len(simulated.plan.stylus.touches)
    turns = []
    for index in range(count):
        cell.operator.perform(TouchCone(index, count))
        assert np.abs(tip_in_base(simulated) - simulated.truth.cone_in_base_mm).max() < 1e-5
        reading = cell.robot.read()
        assert not reading.moving
        turns.append(reading.base_from_flange[:3, :3])
        # the report is off by the robot's absolute error: that is what the calibration lives with
        miss = reading.base_from_flange[:3, 3] - simulated.world.true_flange()[:3, 3]
        assert 0.01 < np.linalg.norm(miss) < 1.0
    cosines = (np.einsum("aij,bij->ab", turns, turns) - 1.0) / 2.0
    assert np.rad2deg(np.arccos(np.clip(cosines.min(), -1.0, 1.0))) > 60.0


def test_touch_noise_has_its_size() -> None:
    simulated = build_simulated_cell(seed=6)
    simulated.cell.operator.perform(Mount("stylus"))
    miss = []
    for index in range(60):
        simulated.cell.operator.perform(TouchCone(index, 60))
        miss.append(tip_in_base(simulated) - simulated.truth.cone_in_base_mm)
    # 180 numbers: their spread is known to 5 %
    assert np.std(miss) == pytest.approx(0.02, rel=0.2)


@pytest.mark.parametrize("grinder", ["rough", "fine"])
def test_shaft_touches_lie_on_the_circle_at_the_angle_that_the_sensor_reads(quiet: Build, grinder: str) -> None:
    simulated = quiet()
    cell, plan = simulated.cell, simulated.plan.grinders[grinder]
    cell.operator.perform(Mount("stylus"))
    tool_from_base = np.linalg.inv(simulated.truth.base_from_tool(grinder))
    for angle in plan.touch_angles_rad:
        cell.operator.perform(TouchShaft(grinder, angle))
        read = cell.grinders[grinder].read().angle_rad
        assert read == pytest.approx(angle, abs=np.deg2rad(0.001))
        mark = (tool_from_base @ np.append(tip_in_base(simulated), 1.0))[:3]
        # {H}: head axis at (-Rg, 0), positive angles turn x towards y
        assert mark == pytest.approx([180.0 * np.cos(angle) - 180.0, 180.0 * np.sin(angle), -30.0], abs=1e-4)


def test_the_operator_refuses_what_cannot_be_done() -> None:
    simulated = build_simulated_cell()
    operator = simulated.cell.operator
    operator.perform(Mount("ball"))
    with pytest.raises(Refused, match="stylus to be mounted first"):
        operator.perform(TouchCone(0, 8))
    operator.perform(Mount("stylus"))
    with pytest.raises(Refused, match="rough, fine"):
        operator.perform(TouchShaft("medium", 0.0))
    with pytest.raises(Refused, match=r"-30\.0 to 30\.0 degrees"):
        operator.perform(TouchShaft("rough", 0.6))
    with pytest.raises(DeadlineExceeded, match="nobody confirmed"):
        operator.perform(Mount("nothing"), deadline_s=1.0)
    assert simulated.world.mounted.item == "stylus"
