"""What goes wrong in a cell: it is refused or rejected in words that say what to do; what was taken stays."""

from collections.abc import Callable
from dataclasses import dataclass, replace
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from beltgui.commissioning import Commissioner, Commissioning
from beltgui.jobs import Job
from beltgui.steps.base.room import BaseRoom
from beltgui.steps.error_surface import probing
from beltgui.steps.error_surface import step as error_surface
from beltgui.steps.error_surface.probing import Presenting
from beltgui.steps.fine import step as fine
from beltgui.steps.room import Room
from beltgui.steps.scans import acquire_scans
from beltgui.steps.state import StepEvent, StepState
from beltgui.steps.tool.room import ToolRoom
from core.path import CellFrames
from core.verdict import Code, Verdict
from devices.interfaces import Lost, Mount, Refused, StagePosition, Stale
from tests.beltgui.cell_bench import bench_of, with_stage
from tests.beltgui.live import Live, blade_and_model

GRINDER = "fine"


@pytest.fixture
def live(tmp_path: Path) -> Any:
    with Live.start(tmp_path / "session") as cell:
        yield cell


def kept(live: Live, step: str, kind: str) -> int:
    return len(live.session.samples(step, kind))


def said(verdict: Verdict) -> str:
    return "\n".join(reason.message for reason in verdict.reasons)


def at(number: int, fault: Callable[[], None]) -> Callable[[int], None]:
    """Calls the fault once, before the call of that number."""

    def before(call: int) -> None:
        if call == number:
            fault()

    return before


# ---- one step with a fault in the middle


def acquire(room: Room, live: Live) -> None:
    room.acquire(bench_of(live, ball=with_stage(live)), live.context)


def test_a_ball_that_moved_between_two_scans_rejects_the_base(live: Live) -> None:
    by_mm = 2.0
    live.hook("scanner", "capture", at(7, lambda: live.sim.world.faults.move_ball((0.0, by_mm, 0.0))))
    bench = bench_of(live, ball=with_stage(live))
    BaseRoom().acquire(bench, live.context)
    outcome = BaseRoom().solve(bench, Job())
    assert outcome.verdict.reasons[0].code is Code.HELD_OUT_ERROR
    assert "has moved meanwhile" in outcome.verdict.reasons[0].message
    assert outcome.returned_mm == pytest.approx(by_mm, abs=0.1)
    assert kept(live, "base", "scan") == len(live.sim.plan.base_step)
    assert kept(live, "base", "closing_scan") == 1


@pytest.fixture
def slip(live: Live) -> Callable[..., fine.FineOutcome]:
    """Two scans of the blade; it slips between them."""

    def with_shift(shift_in_work_mm: tuple[float, float, float]) -> fine.FineOutcome:
        live.context.cell.operator.perform(Mount("blade", live.context.serial))
        live.context.move(live.sim.plan.fine_step[0].base_from_flange, "to the blade's scans")
        before = live.sim.truth.measure_from_work
        live.hook("scanner", "capture", at(1, lambda: live.sim.world.faults.slip_blade(shift_in_work_mm, np.zeros(3))))
        samples = fine.acquire(live.context)
        blade, model = blade_and_model()
        return fine.solve(samples, live.stage_fit(), live.base_fit(), model, blade, before, unmoved_since=before)

    return with_shift


def test_a_blade_that_stays_is_accepted(slip: Callable[..., fine.FineOutcome]) -> None:
    outcome = slip((0.0, 0.0, 0.0))
    assert outcome.verdict.reasons == ()
    assert outcome.moved_mm is not None and outcome.moved_mm < 0.02


@pytest.mark.parametrize("shift", [(0.5, 0.0, 0.0), (0.0, 0.1, 0.0), (0.0, 0.0, 0.3)])
def test_a_blade_that_slipped_between_two_scans_is_rejected(
    slip: Callable[..., fine.FineOutcome], shift: tuple[float, float, float]
) -> None:
    """Also along z, where the faces of one scan alone hold the blade, so that the scans agree with each other."""
    outcome = slip(shift)
    assert not outcome.verdict.ok
    assert "fasten it and begin again with the rough step" in said(outcome.verdict)
    assert outcome.moved_mm == pytest.approx(np.linalg.norm(shift), rel=0.25)


@dataclass
class Probed:
    outcome: error_surface.ErrorSurfaceOutcome
    presenting: Presenting


@pytest.fixture
def probe(live: Live) -> Callable[..., Probed]:
    """The tool step's touches, then the probing with ideal frames; `between` spoils what it likes in between."""

    def with_fault(
        between: Callable[[], None] = lambda: None, while_probing: Callable[[int], None] | None = None
    ) -> Probed:
        blade, model = blade_and_model()
        bench = bench_of(live)
        ToolRoom().acquire(bench, live.context)
        found = ToolRoom().solve(bench, Job())
        assert found.verdict.reasons == ()
        probing.clamp_and_scan(live.context)
        between()
        plan = live.sim.plan.grinders[GRINDER]
        frames = CellFrames(
            live.sim.truth.base_from_tool(GRINDER), live.sim.truth.flange_from_work, plan.wheel_radius_mm,
            plan.contact_side,
        )  # fmt: skip
        presenting = Presenting(model.spline_surface(blade.airfoil), frames, GRINDER)
        if while_probing is not None:
            live.hook_grinder(GRINDER, while_probing)
        grid = replace(blade.probing, u_count=25, v_count=18)
        samples = probing.acquire(live.context, presenting, grid)
        outcome = error_surface.solve(
            samples, plan.head_radius_mm, presenting.normal_in_tool, {}, Verdict(), found.rests_rad[GRINDER]
        )
        return Probed(outcome, presenting)

    return with_fault


def test_a_shifted_sensor_zero_rejects_the_error_surface(live: Live, probe: Callable[..., Probed]) -> None:
    shift_rad = np.radians(0.1)
    outcome = probe(lambda: live.sim.world.faults.shift_angle_zero(GRINDER, shift_rad)).outcome
    assert [reason.code for reason in outcome.verdict.reasons] == [Code.WRONG_MODEL]
    assert "calibrate the tool again" in said(outcome.verdict)
    plan = live.sim.plan.grinders[GRINDER]
    assert outcome.head_rest.moved_mm == pytest.approx(plan.head_radius_mm * shift_rad, abs=0.01)


def test_a_worn_wheel_is_measured_and_compensated(live: Live, probe: Callable[..., Probed]) -> None:
    """Wear is a real error at the contact: the surface shows it, and the path takes it away like all others."""
    worn_mm = 0.4
    probed = probe(lambda: live.sim.world.faults.wear_wheel(GRINDER, worn_mm))
    assert probed.outcome.verdict.reasons == ()
    blade, _ = blade_and_model()
    pattern = replace(error_surface.patterns(blade.probing)["longitudinal"], count=2)
    program = error_surface.write_program(
        "worn", probed.presenting, probed.outcome.surface, pattern, blade_type=blade.name, date="2026-01-01"
    )
    left, before = (
        np.array([
            live.sim.world.true_normal_error(GRINDER, pose)
            for stroke in program.plan.strokes for pose in getattr(stroke, poses)[::12]
        ])
        for poses in ("base_from_flange", "nominal_base_from_flange")
    )  # fmt: skip
    assert np.sqrt(np.mean(left**2)) < 0.03
    assert np.sqrt(np.mean(before**2)) > 0.3


def test_a_blade_that_slips_while_it_is_probed_is_rejected(live: Live, probe: Callable[..., Probed]) -> None:
    fault = at(225, lambda: live.sim.world.faults.slip_blade((0.0, 0.5, 0.0), np.zeros(3)))
    outcome = probe(while_probing=fault).outcome
    assert Code.HELD_OUT_ERROR in {reason.code for reason in outcome.verdict.reasons}


# ---- devices that are lost or refuse


# The stage has reported its place before the fourth scan, so that scan is whole without it.
@pytest.mark.parametrize(("device", "scans"), [("robot", 3), ("scanner", 3), ("stage", 4)])
def test_a_device_lost_midway_ends_the_step_and_keeps_the_scans(live: Live, device: str, scans: int) -> None:
    live.hook("scanner", "capture", at(3, lambda: live.sim.world.faults.lose(device)))
    with pytest.raises(Lost, match=f"{device}: the connection is gone. Check its cable and power"):
        acquire(BaseRoom(), live)
    assert kept(live, "base", "scan") == scans
    assert len(live.session.points(live.session.samples("base", "scan")[-1])) > 1000


def test_a_stalled_robot_is_noticed_before_the_next_scan_is_kept(live: Live) -> None:
    live.hook("scanner", "capture", at(2, lambda: live.sim.world.faults.stall("robot")))
    with pytest.raises(Stale, match="its values stand still"):
        acquire(BaseRoom(), live)
    assert kept(live, "base", "scan") == 2


def test_a_grinder_lost_among_the_touches_keeps_those_before(live: Live) -> None:
    live.hook_grinder("rough", at(7, lambda: live.sim.world.faults.lose("grinder rough")))
    with pytest.raises(Lost, match="grinder rough: the connection is gone"):
        acquire(ToolRoom(), live)
    assert kept(live, "tool", "cone_touch") == len(live.sim.plan.stylus.touches)
    assert kept(live, "tool", "shaft_touch") == 2  # after five readings at the stop


def test_a_grinder_lost_while_probing_keeps_the_lines_before(live: Live, probe: Callable[..., Probed]) -> None:
    fault = at(5 + 25 * 4 + 3, lambda: live.sim.world.faults.lose("grinder fine"))
    with pytest.raises(Lost, match="grinder fine: the connection is gone"):
        probe(while_probing=fault)
    assert kept(live, "error_surface", "line") == 4


def test_a_stage_target_beyond_its_travel_is_refused_with_its_limits(live: Live) -> None:
    first, second = live.sim.plan.fine_step
    limit = live.sim.cell.stage.limits[0]
    beyond = replace(second, stage=StagePosition(limit.high + 5.0, 0.0, 0.0))
    with pytest.raises(Refused, match=r"stage x cannot go from .* the limits are .* mm. Choose a target inside"):
        acquire_scans(live.context, "fine", [first, beyond])
    assert kept(live, "fine", "scan") == 1
    assert live.sim.cell.stage.position().x_mm == first.stage.x_mm


def test_nothing_moves_without_consent(tmp_path: Path) -> None:
    asked: list[str] = []

    def refuse(path: Any, purpose: str) -> bool:
        asked.append(purpose)
        assert len(path.base_from_flange) > 1 and path.length_mm > 0.0
        return False

    with Live.start(tmp_path / "session", consent=refuse) as live:
        before = live.sim.cell.robot.read()
        with pytest.raises(Refused, match=r"the motion was not wanted: to the scanning pose .* Nothing has moved"):
            acquire(BaseRoom(), live)
        after = live.sim.cell.robot.read()
        np.testing.assert_array_equal(before.base_from_flange, after.base_from_flange)
        assert len(asked) == 1 and kept(live, "base", "scan") == 0


def test_probing_is_asked_for_once_and_as_a_whole(live: Live) -> None:
    blade, model = blade_and_model()
    asked: list[str] = []
    probing.clamp_and_scan(live.context)
    before = live.sim.cell.robot.read()

    def refuse(path: Any, purpose: str) -> bool:
        asked.append(purpose)
        return False

    plan = live.sim.plan.grinders[GRINDER]
    frames = CellFrames(plan.base_from_tool, live.sim.plan.flange_from_work, plan.wheel_radius_mm, plan.contact_side)
    presenting = Presenting(model.spline_surface(blade.airfoil), frames, GRINDER)
    with pytest.raises(Refused, match="to probe 5196 points of the airfoil on grinder fine"):
        probing.acquire(replace(live.context, consent=refuse), presenting, blade.probing)
    np.testing.assert_array_equal(before.base_from_flange, live.sim.cell.robot.read().base_from_flange)
    assert len(asked) == 1


# ---- the whole run stops at the step that failed


def commission(live: Live, events: list[StepEvent]) -> Commissioning:
    bench = bench_of(live)

    def keep(step: str, record: Any, headline: str, ok: bool) -> None:
        live.session.put_result(step, record, ok=ok, headline=headline)

    def take(room: Room, job: Job) -> None:
        room.acquire(bench, live.with_job(job))

    return Commissioner(bench, take, live.context.job, keep, events.append).run()


def test_an_operator_who_refuses_ends_the_run_with_his_sentence(live: Live) -> None:
    def decline(call: int) -> None:
        raise Refused("operator", "the ball is not at hand. Fetch it and start again.")

    live.hook("operator", "perform", decline)
    events: list[StepEvent] = []
    with pytest.raises(Refused, match="Fetch it and start again"):
        commission(live, events)
    assert [(event.step, event.state) for event in events] == [
        ("ball", StepState.RUNNING), ("ball", StepState.FAILED)
    ]  # fmt: skip
    assert "Fetch it" in events[-1].headline
    assert list(live.session.steps_with_results()) == []


def test_a_rejected_step_is_kept_and_ends_the_run(live: Live) -> None:
    """The ball is knocked by 1 mm in the middle of the first step."""
    live.hook("scanner", "capture", at(10, lambda: live.sim.world.faults.move_ball((1.0, 0.0, 0.0))))
    events: list[StepEvent] = []
    found = commission(live, events)
    assert list(found.verdicts) == ["ball"] and not found.accepted
    assert events[-1].state is StepState.FAILED
    assert events[-1].headline == found.verdicts["ball"].reasons[0].message
    assert "fasten both, scan again" in said(found.verdicts["ball"])
    result = live.session.result("ball")
    assert result is not None and not result.ok
    assert kept(live, "ball", "scan") == len(live.sim.plan.stage_step) and kept(live, "base", "scan") == 0
