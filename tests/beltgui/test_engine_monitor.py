"""The monitor: tells what changed and nothing else, never takes part in the work, and does not hide its own faults."""

import threading
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from beltgui.engine import messages as m
from beltgui.engine.guard import MotionGuard
from beltgui.engine.hosts import SimulatedHost
from beltgui.engine.monitor import Monitor
from beltgui.engine.watch import Watch, WatchedGrinder, WatchedScanner
from core.errors import InputError
from devices.interfaces import DeadlineExceeded, Mount, Stale
from resources import blade_type_path, resource_path
from tests.beltgui.engine_fakes import WAIT_S, FakeHost, pose

CELL = resource_path("cells", "simulated.toml")
BLADE = blade_type_path("dr95").with_suffix(".step")


class Screen:
    """Collects what the monitor says."""

    def __init__(self) -> None:
        self.events: list[m.Event] = []
        self.changed = threading.Condition()

    def __call__(self, event: m.Event) -> None:
        with self.changed:
            self.events.append(event)
            self.changed.notify_all()

    def wait_for(self, wanted: Any) -> Any:
        with self.changed:
            assert self.changed.wait_for(lambda: any(wanted(event) for event in self.events), WAIT_S), self.events
            return next(event for event in self.events if wanted(event))

    def strips(self) -> list[dict[str, tuple[str, str]]]:
        with self.changed:
            return [{device.name: (device.state, device.detail) for device in event.devices}
                    for event in self.events if isinstance(event, m.DevicesChanged)]  # fmt: skip


class Lookout:
    """A monitor over fake devices, looked through by hand or running."""

    def __init__(self, host: Any) -> None:
        self.host, self.screen, self.watch = host, Screen(), Watch()
        self.guard = MotionGuard(lambda path, purpose: True)
        self.monitor = Monitor(host, self.watch, self.guard, self.screen)

    def run(self) -> None:
        self.monitor.start()

    def end(self) -> None:
        self.monitor.close()
        self.guard.close()
        assert self.guard.join(WAIT_S)


@pytest.fixture
def lookout(tmp_path: Path) -> Iterator[Lookout]:
    lookout = Lookout(FakeHost(tmp_path, CELL, BLADE, {}))
    yield lookout
    lookout.end()


def is_state(name: str, state: str) -> Any:
    def fits(event: m.Event) -> bool:
        return isinstance(event, m.DevicesChanged) and any((d.name, d.state) == (name, state) for d in event.devices)

    return fits


def test_only_changes_are_told(lookout: Lookout) -> None:
    for _ in range(5):
        lookout.monitor._look()
    assert [type(event) for event in lookout.screen.events] == [m.DevicesChanged, m.CellMoved]
    assert set(lookout.screen.strips()[0]) == {"scanner", "stage", "robot", "grinder rough", "grinder fine"}
    assert {state for state, _ in lookout.screen.strips()[0].values()} == {"simulated"}
    lookout.host.robot.pose = pose(1)
    lookout.monitor._look()
    assert np.array_equal(lookout.screen.events[-1].base_from_flange, pose(1))  # type: ignore[union-attr]


def test_a_scanner_that_keeps_the_work_waiting_is_shown_so(lookout: Lookout) -> None:
    release = threading.Event()
    lookout.host.cell.scanner.capture = lambda **words: release.wait(WAIT_S)
    scanner = WatchedScanner(lookout.host.cell.scanner, lookout.watch)
    work = threading.Thread(target=scanner.capture)
    lookout.run()
    work.start()
    lookout.screen.wait_for(is_state("scanner", "waiting"))
    assert ("waiting", "taking a scan") in [strip["scanner"] for strip in lookout.screen.strips()]
    release.set()
    work.join()
    count = len(lookout.screen.strips())
    with lookout.screen.changed:
        assert lookout.screen.changed.wait_for(lambda: len(lookout.screen.strips()) > count, WAIT_S)
    assert lookout.screen.strips()[-1]["scanner"] == ("simulated", "")
    assert lookout.monitor.join(0.0) is False


def test_late_and_stale_devices_are_told_apart(lookout: Lookout) -> None:
    def late(**words: Any) -> None:
        raise DeadlineExceeded("robot", "no answer within 0.3 s.")

    def stale(**words: Any) -> None:
        raise Stale("stage", "its values stand still.")

    lookout.host.robot.read = late
    lookout.host.stage.position = stale
    lookout.monitor._look()
    strip = lookout.screen.strips()[-1]
    assert strip["robot"] == ("waiting", "no answer within 0.3 s.")
    assert strip["stage"][0] == "stale" and strip["stage"][1].startswith("since ")
    lookout.monitor._look()
    assert len(lookout.screen.strips()) == 1


def test_readings_of_the_work_are_shown_and_none_are_taken_for_it(lookout: Lookout) -> None:
    def never(**words: Any) -> None:
        raise AssertionError("the monitor must not read the heads")

    WatchedGrinder(lookout.host.cell.grinders["fine"], "fine", lookout.watch).read()
    for grinder in lookout.host.cell.grinders.values():
        grinder.read = never
    lookout.monitor._look()
    assert lookout.screen.events[-1].head_deg == {"fine": 0.0}  # type: ignore[union-attr]


def test_a_fault_of_the_monitor_itself_is_told_and_stops_the_cell(lookout: Lookout) -> None:
    def bug(**words: Any) -> None:
        raise RuntimeError("a bug in a driver")

    stopped = threading.Event()
    lookout.guard.attach(lookout.host.robot, lookout.host.stage)
    lookout.host.robot.stop = stopped.set
    lookout.host.robot.read = bug
    lookout.run()
    crash = lookout.screen.wait_for(lambda event: isinstance(event, m.Crashed))
    assert "a bug in a driver" in crash.text
    assert stopped.wait(WAIT_S)
    assert lookout.monitor.join(WAIT_S)


# ---- the simulated cell


def simulated(folder: Path, **info: Any) -> SimulatedHost:
    return SimulatedHost(folder, CELL, BLADE, {"seed": 3, "resolution": "test", "speed": 0.0, **info})


def chance(host: SimulatedHost) -> list[Any]:
    names = ("stage", "robot", "scanner", "operator", "grinder rough", "grinder fine")
    return [host.world.rng(name).bit_generator.state for name in names]


def test_looking_does_not_use_up_the_chance_of_the_simulation(tmp_path: Path) -> None:
    lookout = Lookout(simulated(tmp_path))
    before = chance(lookout.host)
    for _ in range(20):
        lookout.monitor._look()
    lookout.end()
    assert chance(lookout.host) == before


def test_the_simulated_cell_goes_on_where_it_stood(tmp_path: Path) -> None:
    one = simulated(tmp_path)
    one.cell.operator.perform(Mount("ball"))
    one.cell.operator.perform(Mount("blade", "DR95-0001"))
    one.cell.operator.perform(Mount("ball"))
    one.cell.operator.perform(Mount("blade", "DR95-0001"))
    one.cell.robot.move_to(one.plan.fine_step[0].base_from_flange)
    one.simulate("ball moved")
    one.simulate("blade slipped")
    one.remember()
    two = simulated(tmp_path)
    assert two.mounted == Mount("blade", "DR95-0001")
    assert np.array_equal(two.world.true_flange(), one.world.true_flange())
    assert np.allclose(two.world.flange_from_work, one.world.flange_from_work, atol=0.0)
    assert np.array_equal(two.world.ball_in_flange, one.world.ball_in_flange)
    assert chance(two) == chance(one)
    assert np.array_equal(two.cell.scanner.capture().points_mm, one.cell.scanner.capture().points_mm, equal_nan=True)
    assert not np.array_equal(simulated(tmp_path / "new").world.true_flange(), one.world.true_flange())


def test_a_blade_that_is_clamped_already_is_not_clamped_anew(tmp_path: Path) -> None:
    host = simulated(tmp_path)
    host.cell.operator.perform(Mount("blade", "DR95-0001"))
    clamped = host.world.flange_from_work
    host.cell.operator.perform(Mount("blade", "DR95-0001"))
    assert np.array_equal(host.world.flange_from_work, clamped)


@pytest.mark.parametrize("device", ["scanner", "robot", "stage", "grinder fine"])
def test_lost_devices_fault_and_come_back(tmp_path: Path, device: str) -> None:
    lookout = Lookout(simulated(tmp_path))
    lookout.host.simulate(f"{device} lost")
    lookout.monitor._look()
    assert [name for name, (state, _) in lookout.screen.strips()[-1].items() if state == "fault"] == [device]
    lookout.host.simulate("restore all")
    lookout.monitor._look()
    assert {state for state, _ in lookout.screen.strips()[-1].values()} == {"simulated"}
    lookout.end()


def test_faults_of_the_world_can_be_switched_on_and_off(tmp_path: Path) -> None:
    host = simulated(tmp_path)
    faults = host.world.faults
    for fault in ("ball moved", "head zero shifted", "blade slipped", "wheel worn"):
        host.simulate(fault)
    assert np.linalg.norm(faults.ball_moved_mm) == pytest.approx(0.5)
    assert faults.wheel_wear_mm["fine"] > 0 and faults.angle_zero_rad["fine"] > 0
    assert not np.array_equal(faults.blade_slip, np.eye(4))
    host.simulate("restore all")
    assert not faults.ball_moved_mm.any() and not faults.wheel_wear_mm and not faults.angle_zero_rad
    assert np.array_equal(faults.blade_slip, np.eye(4))
    with pytest.raises(InputError, match="no fault 'fire'"):
        host.simulate("fire")


def test_a_damaged_state_of_the_simulated_cell_is_named(tmp_path: Path) -> None:
    (tmp_path / "simulated_cell.json").write_text("{}")
    with pytest.raises(InputError, match="state of the simulated cell"):
        simulated(tmp_path)
