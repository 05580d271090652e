from __future__ import annotations

import pickle

import numpy as np
import pytest

from devices.clock import InstantClock, RealClock
from devices.interfaces import (
    DeadlineExceeded,
    DeviceError,
    GrinderReading,
    Limit,
    Lost,
    Mount,
    Refused,
    RobotMover,
    StagePosition,
    Stale,
    Stopped,
    TouchCone,
    TouchShaft,
)
from devices.sim import SimulatedCell, build_simulated_cell


@pytest.mark.parametrize("kind", [Lost, Stale, Stopped, DeadlineExceeded, Refused])
def test_errors_cross_a_process_boundary(kind: type[DeviceError]) -> None:
    error = pickle.loads(pickle.dumps(kind("robot", "gone.")))
    assert type(error) is kind
    assert str(error) == "robot: gone."


def test_a_limit_error_states_from_to_limits_and_unit_after_pickling() -> None:
    error = pickle.loads(pickle.dumps(Refused.beyond("stage", Limit("stage x", -10.0, 20.0, "mm"), 1.5, 33.0)))
    for part in ("stage x", "1.5", "33", "-10", "20", "mm"):
        assert part in str(error)
    assert error.limit == Limit("stage x", -10.0, 20.0, "mm")
    assert (error.current, error.target) == (1.5, 33.0)


def test_a_limit_contains_its_ends_and_no_nan() -> None:
    limit = Limit("speed", 0.0, 250.0, "mm/s")
    assert limit.contains(0.0) and limit.contains(250.0)
    assert not limit.contains(250.1) and not limit.contains(float("nan"))


def test_requests_and_readings_are_plain_data_with_an_instruction() -> None:
    requests = [Mount("blade", "DR95-0001"), Mount("nothing"), TouchCone(1, 8), TouchShaft("fine", np.deg2rad(-10.0))]
    sentences = [pickle.loads(pickle.dumps(request)).instruction for request in requests]
    assert "DR95-0001" in sentences[0] and "2 of 8" in sentences[2] and "-10.0 degrees" in sentences[3]
    assert pickle.loads(pickle.dumps(GrinderReading(1.0, 0.1, 2.0))) == GrinderReading(1.0, 0.1, 2.0)
    assert pickle.loads(pickle.dumps(StagePosition(1, 2, 3, 0.1))).z_mm == 3


def test_the_instant_clock_advances_by_what_was_waited_for() -> None:
    clock = InstantClock(5.0)
    clock.wait(2.5)
    clock.wait(0.0)
    assert clock.now_s() == 7.5
    with pytest.raises(ValueError, match="zero or more"):
        clock.wait(-1.0)


def test_the_real_clock_runs_forward_at_its_speed() -> None:
    clock = RealClock(speed=1e4)
    before = clock.now_s()
    clock.wait(1.0)
    assert clock.now_s() - before >= 1.0
    with pytest.raises(ValueError, match="positive"):
        RealClock(0.0)


def test_the_simulated_cell_keeps_the_protocols() -> None:
    simulated: SimulatedCell = build_simulated_cell()
    assert isinstance(simulated.cell.robot, RobotMover)
    for device in (simulated.cell.scanner, simulated.cell.stage, *simulated.cell.grinders.values()):
        assert all(limit.low < limit.high and limit.unit for limit in device.limits)
    assert simulated.cell.robot.limits[1] == Limit("speed", 1.0, 250.0, "mm/s")
