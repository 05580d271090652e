"""The error surface's room: probing that can be gone on with, what spoils it, what is shown, export with proof."""

from collections.abc import Iterator
from dataclasses import dataclass, replace
from pathlib import Path
from types import SimpleNamespace
from typing import Any

import numpy as np
import pytest

from beltgui.jobs import Cancelled, Job
from beltgui.session import Session
from beltgui.steps.blocks import plain
from beltgui.steps.error_surface import export as exporting
from beltgui.steps.error_surface.room import ErrorSurfaceRoom, export
from beltgui.steps.error_surface.series import STEP, current_clamping
from beltgui.steps.error_surface.step import ErrorSurfaceOutcome
from beltgui.steps.room import Bench
from beltgui.steps.views.drawing import count_points
from beltgui.viewmodel.plot import Band, Curve, Map, Marks
from beltgui.viewmodel.scene import Lines, Mesh, Points, Role
from beltgui.viewmodel.step import StepContent, Use
from core.errors import InputError
from core.frames import inverse
from core.verdict import Code, Verdict
from devices.interfaces import Refused, Scan
from tests.beltgui.live import Live, blade_and_model

GRINDER, PERSON = "fine", "A. Probe"
U_COUNT, V_COUNT, CHECKS = 25, 18, 3
ROOM = ErrorSurfaceRoom()


def bench_of(live: Live, session: Session | None = None) -> Bench:
    """Earlier outcomes by the truth; the tool step has read every head at its stop."""
    blade, model = blade_and_model()
    bench = Bench(session or live.session, live.sim.plan, small(blade), model, "2026-01-01")
    wheels, rests = {}, {}
    for name, plan in live.sim.plan.grinders.items():
        wheels[name] = SimpleNamespace(
            base_from_tool=live.sim.truth.base_from_tool(name), radius_mm=plan.head_radius_mm
        )
        rests[name] = tuple(live.sim.cell.grinders[name].read().angle_rad for _ in range(2))
    in_base = live.sim.plan.fine_step[0].base_from_flange @ live.sim.plan.flange_from_work
    nominal = SimpleNamespace(measure_from_work=inverse(live.sim.truth.base_from_measure) @ in_base)
    bench.found.update(
        ball=SimpleNamespace(stage=live.stage_fit()), base=SimpleNamespace(fit=live.base_fit()),
        fine=SimpleNamespace(fit=nominal, face_ids=None), tool=SimpleNamespace(wheels=wheels, rests_rad=rests),
    )  # fmt: skip
    return bench


def small(blade: Any) -> Any:
    return replace(blade, probing=replace(blade.probing, u_count=U_COUNT, v_count=V_COUNT))


def started(folder: Path, **named: Any) -> Live:
    live = Live.start(folder, **named)
    live.context = replace(live.context, blade=small(live.context.blade))
    return live


def kept(live: Live, kind: str) -> list[Any]:
    return live.session.samples(STEP, kind)


def said(verdict: Verdict) -> str:
    return "\n".join(reason.message for reason in verdict.reasons)


def cancelled_at(line: int) -> Job:
    """A job that somebody cancels when a line is probed."""
    job = Job(lambda fraction, text: job.cancel() if text == f"probing line {line} of {V_COUNT}" else None)
    return job


# ---- the whole step once, with real scans


@dataclass
class Done:
    live: Live
    bench: Bench
    outcome: ErrorSurfaceOutcome
    samples: list[Any]


@pytest.fixture(scope="module")
def done(tmp_path_factory: pytest.TempPathFactory) -> Iterator[Done]:
    told: list[Any] = []
    with started(tmp_path_factory.mktemp("whole") / "session") as live:
        bench = bench_of(live)
        ROOM.acquire(bench, replace(live.context, on_sample=told.append))
        outcome = ROOM.solve(bench, Job())
        bench.found[STEP] = outcome
        yield Done(live, bench, outcome, told)


def test_a_good_cell_is_accepted_and_nothing_is_taken_twice(done: Done) -> None:
    outcome = done.outcome
    assert outcome.verdict.reasons == ()
    assert outcome.complete and outcome.apart_mm == 0.0
    assert outcome.held_out.rms_mm < 0.03
    assert outcome.at_end is not None and outcome.at_end.moved_mm is not None and outcome.at_end.moved_mm < 0.15
    assert set(outcome.programs) == {"transverse", "longitudinal"}
    before = len(done.live.session.samples(STEP))
    assert [sample.id for sample in done.samples] == [sample.id for sample in done.live.session.samples(STEP)]
    ROOM.acquire(done.bench, done.live.context)
    assert len(done.live.session.samples(STEP)) == before
    assert len(kept(done.live, "line")) == V_COUNT and len(kept(done.live, "check")) == CHECKS


def test_everything_comes_out_again_from_the_session(done: Done) -> None:
    with Session.open(done.live.session.folder) as session:
        again = Bench(session, done.bench.plan, done.bench.blade, done.bench.model, done.bench.date, done.bench.found)
        outcome = ROOM.solve(again, Job())
    assert {name: program.text for name, program in outcome.programs.items()} == {
        name: program.text for name, program in done.outcome.programs.items()
    }
    assert plain(ROOM.record(outcome)) == plain(ROOM.record(done.outcome))
    assert "held-out error" in ROOM.headline(outcome)


def test_a_line_left_out_is_predicted_instead_of_fitted(done: Done) -> None:
    line = kept(done.live, "line")[0]
    done.live.session.include(line.id, False, PERSON)
    outcome = ROOM.solve(done.bench, Job())
    content = ROOM.view(done.bench, outcome)
    done.live.session.undo(STEP, PERSON)
    assert outcome.surface.sample_u.size == U_COUNT * (V_COUNT - 1)
    row = next(row for row in content.rows if row.id == line.id)
    assert row.use is Use.EXCLUDED and not row.included and row.can_exclude
    assert content.suggestion is not None and content.suggestion.text.startswith("Delete line 1")
    assert content.suggestion.improves == "Its part of the airfoil is not measured now."
    assert ROOM.solve(done.bench, Job()).surface.sample_u.size == U_COUNT * V_COUNT


def test_too_many_lines_or_a_check_left_out_reject(done: Done) -> None:
    lines, checks = kept(done.live, "line"), kept(done.live, "check")
    for sample in (lines[3], lines[7], checks[1]):
        done.live.session.include(sample.id, False, PERSON)
    outcome = ROOM.solve(done.bench, Job())
    for _ in range(3):
        done.live.session.undo(STEP, PERSON)
    assert "2 of 18 lines are left out" in said(outcome.verdict)
    assert "1 of 3 check lines are left out. A check that fails may not be left out" in said(outcome.verdict)
    assert outcome.programs == {}


def test_errors_belong_to_the_frames_they_were_measured_with(done: Done) -> None:
    """The tool was calibrated again and lies elsewhere: the lines say nothing about that cell."""
    tool = done.bench.found["tool"]
    moved = done.live.sim.truth.base_from_tool(GRINDER).copy()
    moved[:3, 3] += (0.0, 0.2, 0.0)
    done.bench.found["tool"] = SimpleNamespace(
        wheels={**tool.wheels, GRINDER: replace_wheel(tool.wheels[GRINDER], moved)}, rests_rad=tool.rests_rad
    )
    outcome = ROOM.solve(done.bench, Job())
    done.bench.found["tool"] = tool
    assert [reason.code for reason in outcome.verdict.reasons] == [Code.WRONG_MODEL]
    assert "probe the blade again" in said(outcome.verdict)
    assert outcome.apart_mm == pytest.approx(0.2, abs=1e-6)


def replace_wheel(wheel: Any, base_from_tool: np.ndarray) -> Any:
    return SimpleNamespace(base_from_tool=base_from_tool, radius_mm=wheel.radius_mm)


def test_another_grinder_has_lines_of_its_own(done: Done) -> None:
    done.live.session.choose(STEP, "grinder", "rough", PERSON)
    with pytest.raises(InputError, match="No line of the airfoil has been probed on grinder rough"):
        ROOM.solve(done.bench, Job())
    content = ROOM.view(done.bench, None, "No line of the airfoil has been probed on grinder rough.")
    done.live.session.undo(STEP, PERSON)
    assert content.rows == () and content.progress == f"0 of {V_COUNT + CHECKS} lines"
    assert content.reasons[0].message.startswith("No line")
    done.live.session.choose(STEP, "grinder", "seventh", PERSON)
    with pytest.raises(InputError, match=r"no grinder 'seventh'. Choose one of rough, fine"):
        ROOM.solve(done.bench, Job())
    done.live.session.undo(STEP, PERSON)


# ---- what is shown


@pytest.fixture(scope="module")
def content(done: Done) -> StepContent:
    return ROOM.view(done.bench, done.outcome)


def items(content: StepContent) -> dict[str, Any]:
    assert content.scene is not None
    return {item.name: item for item in content.scene.items}


def test_rows_and_numbers_say_what_was_probed(content: StepContent, done: Done) -> None:
    assert content.complete and not content.provisional and content.ok
    assert content.progress == f"{V_COUNT + CHECKS} of {V_COUNT + CHECKS} lines"
    assert [row.use for row in content.rows] == [Use.FIT] * V_COUNT + [Use.HELD_OUT] * CHECKS
    assert all(len(row.cells) == len(content.columns) for row in content.rows)
    assert sum(row.flag == "worst" for row in content.rows) == 1
    numbers = {number.label: number for number in content.numbers}
    assert numbers["Held-out error, RMS"].value == pytest.approx(done.outcome.held_out.rms_mm)
    assert numbers["Leave-one-out error, RMS"].limit == 0.05
    speeds = [number for label, number in numbers.items() if label.endswith("largest speed of the flange")]
    assert len(speeds) == 2 and all(number.value is not None and number.value <= 250.0 for number in speeds)
    assert all(number.limit == 250.0 and number.unit == "mm/s" for number in speeds)
    read_back = [number for label, number in numbers.items() if "read back" in label]
    assert {number.unit for number in read_back} == {"mm", "deg"}
    assert all(number.value is not None and number.value < 1e-3 for number in read_back)
    assert len(content.checks) == 4 and all(check.ok for check in content.checks)
    rejected = content.extra["tables"][0]
    assert len(rejected["rows"]) == len(done.outcome.surface.rejected)


def test_the_picture_is_coloured_where_the_blade_was_measured(content: StepContent, done: Done) -> None:
    assert content.scene is not None and content.scene.frame == "W" and count_points(content.scene) < 60_000
    airfoil = items(content)["airfoil"]
    assert isinstance(airfoil, Mesh) and airfoil.values is not None and airfoil.scale is not None
    assert "µm" in airfoil.scale.title and airfoil.scale.low == -airfoil.scale.high
    known = np.isfinite(airfoil.values)
    assert 0.7 < known.mean() < 1.0
    assert np.abs(airfoil.values[known]).max() <= airfoil.scale.high
    rejected = items(content).get("rejected")
    count = 0 if rejected is None else len(rejected.xyz)
    assert count == len(done.outcome.surface.rejected)
    assert isinstance(items(content)["probed"], Points)
    assert "wheel" in items(content) and "{H}" in items(content)


def test_the_wheel_touches_the_blade_in_the_picture(content: StepContent, done: Done) -> None:
    """Its axis is a wheel's radius away from the airfoil."""
    wheel, airfoil = items(content)["wheel"], items(content)["airfoil"]
    frame = items(content)["{H}"].scene_from_frame
    along, origin = frame[:3, 2], frame[:3, 3]
    away = airfoil.vertices - origin
    distance = np.linalg.norm(away - np.outer(away @ along, along), axis=1)
    width = done.live.sim.plan.grinders[GRINDER].wheel_width_mm
    near = distance[np.abs(away @ along) < 0.5 * width]
    assert near.min() == pytest.approx(done.live.sim.plan.grinders[GRINDER].wheel_radius_mm, abs=0.6)
    assert wheel.role is Role.WHEEL


def test_settings_of_the_picture_change_nothing_but_the_picture(done: Done) -> None:
    session = done.live.session
    for key, value in (("show_exaggeration", 200.0), ("show_path", "longitudinal"), ("show_section", 0.9)):
        session.choose(STEP, key, value, PERSON)
    outcome = ROOM.solve(done.bench, Job())
    shown = ROOM.view(done.bench, outcome)
    for _ in range(3):
        session.undo(STEP, PERSON)
    assert plain(ROOM.record(outcome)) == plain(ROOM.record(done.outcome))
    found = items(shown)
    nominal, drawn = found["nominal path"], found["compensated path"]
    assert shown.scene is not None and [words for _, words in shown.scene.legend][-1].endswith("x200")
    assert isinstance(drawn, Lines) and len(drawn.polylines) == 9
    stroke = outcome.programs["longitudinal"].plan.strokes[0]
    away = np.linalg.norm(drawn.polylines[0] - nominal.polylines[0], axis=1)
    np.testing.assert_allclose(away, 200.0 * np.abs(stroke.error_mm), atol=1e-3)
    plots = {plot.key: plot for plot in shown.plots}
    assert "v = 0.893" in plots["section"].title and "longitudinal" in plots["error_left"].title


def test_plots_have_units_and_lead_back_to_the_lines(content: StepContent, done: Done) -> None:
    plots = {plot.key: plot for plot in content.plots}
    assert list(plots) == ["map", "section", "leave_one_out", "error_left", "head"]
    kinds = {key: {type(series) for series in plot.series} for key, plot in plots.items()}
    assert Map in kinds["map"] and {Band, Curve, Marks} <= kinds["section"] and Curve in kinds["error_left"]
    assert all("µm" in plots[key].y_label for key in ("section", "leave_one_out", "error_left", "head"))
    ids = {row.id for row in content.rows}
    for plot in (plots["section"], plots["leave_one_out"], plots["map"]):
        for series in plot.series:
            if isinstance(series, Marks):
                assert len(series.sample_ids) == len(series.x) == len(series.y) and set(series.sample_ids) <= ids
    predicted = {series.name: series for series in plots["error_left"].series}
    nominal = predicted["nominal path"].y
    assert np.sqrt(np.nanmean(nominal**2)) > 100.0 and np.nanmax(np.abs(predicted["compensated path"].y)) == 0.0


def test_a_missing_scan_at_the_end_is_named(done: Done) -> None:
    closing = kept(done.live, "closing_scan")
    for sample in closing:
        done.live.session.delete(sample.id, PERSON)
    outcome = ROOM.solve(done.bench, Job())
    shown = ROOM.view(done.bench, outcome)
    for _ in closing:
        done.live.session.undo(STEP, PERSON)
    assert "has not been scanned after the last line" in said(outcome.verdict)
    assert shown.provisional and not shown.complete and shown.checks[3].ok is None


# ---- export


def test_what_is_exported_is_read_back(done: Done, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr("beltgui.report.commissioning.commissioning_page", lambda *words, **named: None)
    monkeypatch.setattr("beltgui.report.page.render", lambda page: "<html></html>")
    found = replace(done.bench, found={STEP: done.outcome})
    files = export(found, done.outcome, tmp_path / "out", Job())
    names = ["transverse.script", "longitudinal.script", "error_surface.json", "programs.proof.json", "report.html"]
    assert [path.name for path in files] == names and all(path.is_file() for path in files)
    proof = files[3].read_text()
    assert '"max_contact_mm"' in proof and '"sha256"' in proof
    program = done.outcome.programs["transverse"]
    assert exporting.check_written(files[0], program).max_contact_mm < 1e-3

    text = files[0].read_text()
    moves = [line for line in text.splitlines() if "movel" in line]
    for altered in (
        text.replace(moves[7], moves[7].replace("p[", "p[1")),
        "\n".join(line for line in text.splitlines() if line != moves[7]),
        text.replace("v=0.2", "v=0.9", 1),
    ):
        files[0].write_text(altered)
        with pytest.raises(InputError, match=r"transverse\.script"):
            exporting.check_written(files[0], program)


def test_a_rejected_surface_is_not_exported(done: Done, tmp_path: Path) -> None:
    rejected = replace(done.outcome, verdict=Verdict.of(done_reasons()))
    with pytest.raises(InputError, match="nothing is exported: The wheel is worn"):
        export(done.bench, rejected, tmp_path / "out", Job())
    assert not (tmp_path / "out").exists()


def done_reasons() -> Any:
    return [SimpleNamespace(code=Code.WRONG_MODEL, message="The wheel is worn.")]


# ---- what spoils a real clamping


@pytest.mark.parametrize(("shift", "before_scan"), [((0.5, 0.0, 0.0), 1), ((0.0, 0.0, 0.3), 2)])
def test_a_blade_that_slips_before_probing_is_not_presented(
    tmp_path: Path, shift: tuple[float, float, float], before_scan: int
) -> None:
    with started(tmp_path / "session") as live:

        def spoil(call: int) -> None:
            if call == before_scan:
                live.sim.world.faults.slip_blade(shift, np.zeros(3))

        live.hook("scanner", "capture", spoil)
        asked: list[str] = []
        context = replace(live.context, consent=lambda path, purpose: bool(asked.append(purpose)) or True)
        with pytest.raises(InputError, match=r"clamped for probing is not accepted.*has not presented it to the wheel"):
            ROOM.acquire(bench_of(live), context)
        assert kept(live, "line") == [] and kept(live, "series") == []
        assert not any("probe" in purpose for purpose in asked)


def slip(live: Live, by_mm: float) -> None:
    live.sim.world.faults.slip_blade((by_mm, 0.0, 0.0), np.zeros(3))


# ---- the order of things, with scans that know where the blade is


class KnowingScanner:
    """Scans that hold the blade's pose itself, so that finding it takes no time."""

    def __init__(self, live: Live) -> None:
        self._live = live

    def capture(self) -> Scan:
        pose = self._live.sim.truth.measure_from_work
        return Scan(np.concatenate([pose[:3, :3].T, pose[:3, 3][None]]).astype(np.float32), 0.0)


def register(scans: Any, stage: Any, base: Any, model: Any, blade: Any, start: Any, **named: Any) -> Any:
    """What the fine step would find in such scans."""
    points = scans[-1].points_in_scanner
    pose = np.eye(4)
    pose[:3, :3], pose[:3, 3] = points[:3].T, points[3]
    earlier = named.get("unmoved_since")
    moved = None if earlier is None else float(np.linalg.norm((pose - earlier)[:3, 3]))
    limit = named.get("unmoved_mm", 0.05)
    reasons = [] if moved is None or moved <= limit else done_reasons()
    flange_from_work = inverse(scans[0].base_from_flange) @ base.base_from_measure @ pose
    # Written as float32, a rotation is one but for its last digits.
    left, _, right = np.linalg.svd(flange_from_work[:3, :3])
    flange_from_work[:3, :3] = left @ right
    return FakeFine(SimpleNamespace(measure_from_work=pose), flange_from_work, moved, limit, Verdict.of(reasons))


@dataclass(frozen=True)
class FakeFine:
    fit: Any
    flange_from_work: np.ndarray
    moved_mm: float | None
    moved_limit_mm: float
    verdict: Verdict


@pytest.fixture
def quick(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Iterator[Live]:
    monkeypatch.setattr("beltgui.steps.fine.step.solve", register)
    with started(tmp_path / "session") as live:
        live.context = replace(live.context, cell=replace(live.context.cell, scanner=KnowingScanner(live)))
        yield live


def mounted(live: Live) -> list[Any]:
    """Counts what the operator is asked to do."""
    asked: list[Any] = []
    live.hook("operator", "perform", lambda call: asked.append(call))
    return asked


def test_a_cancelled_probing_is_gone_on_with_after_a_restart(quick: Live) -> None:
    asked = mounted(quick)
    bench = bench_of(quick)
    with pytest.raises(Cancelled):
        ROOM.acquire(bench, replace(quick.context, job=cancelled_at(6)))
    assert len(kept(quick, "line")) == 5
    content = ROOM.view(bench, None)
    assert content.progress == f"5 of {V_COUNT + CHECKS} lines" and content.headline == f"line 5 of {V_COUNT + CHECKS}"
    assert not content.complete and len(content.rows) == 5
    probed = items(content)["probed"]
    assert probed.values is not None and len(probed.values) == len(probed.xyz) and "next line" in items(content)
    assert content.suggestion is not None and content.suggestion.text.startswith("Probe line 6 at v")
    partly = ROOM.solve(bench, Job())
    assert f"5 of {V_COUNT + CHECKS} lines of the airfoil are probed" in said(partly.verdict)
    assert "not been read at its stop after the last line" in said(partly.verdict) and not partly.programs

    folder = quick.session.folder
    quick.session.close()
    reopened = Session.open(folder, write=True)
    quick.context = replace(quick.context, session=reopened)
    fresh = replace(bench, session=reopened, cache={})
    ROOM.acquire(fresh, quick.context)
    assert len(asked) == 1, "the blade was not clamped again"
    assert sorted(sample.data["slot"] for sample in kept(quick, "line")) == list(range(V_COUNT))
    assert len(kept(quick, "return_scan")) == 4 and len(kept(quick, "check")) == CHECKS
    outcome = ROOM.solve(fresh, Job())
    assert outcome.verdict.reasons == () and outcome.complete


def test_lines_of_a_blade_that_moved_in_between_are_void(quick: Live) -> None:
    asked = mounted(quick)
    bench = bench_of(quick)
    with pytest.raises(Cancelled):
        ROOM.acquire(bench, replace(quick.context, job=cancelled_at(6)))
    slip(quick, 0.4)
    ROOM.acquire(bench, quick.context)
    assert len(asked) == 2
    assert len(kept(quick, "line")) == V_COUNT + 5
    clamping = current_clamping(quick.session)
    assert clamping is not None and len(clamping.void) == 5
    assert "The blade is not where it had been clamped" in clamping.why
    outcome = ROOM.solve(bench, Job())
    assert outcome.verdict.reasons == () and outcome.surface.sample_u.size == U_COUNT * V_COUNT
    shown = ROOM.view(bench, None)
    assert sum(row.flag == "refused" and not row.included for row in shown.rows) == 5
    assert any("5 lines of an earlier clamping" in remark for remark in shown.remarks)
    assert any("does not count any more" in remark for remark in shown.remarks)


def test_a_shifted_zero_of_the_head_names_its_grinder(quick: Live) -> None:
    bench = bench_of(quick)
    quick.sim.world.faults.shift_angle_zero(GRINDER, np.radians(0.1))
    ROOM.acquire(bench, quick.context)
    outcome = ROOM.solve(bench, Job())
    assert not outcome.verdict.ok and outcome.programs == {}
    assert "The head of grinder fine reads" in said(outcome.verdict)
    assert "calibrate the tool again" in said(outcome.verdict)


def test_a_blade_that_loosens_while_it_is_probed_names_the_clamp(quick: Live) -> None:
    bench = bench_of(quick)
    total = 5 + V_COUNT * U_COUNT
    quick.hook_grinder(GRINDER, lambda call: slip(quick, 0.4) if call == total - 3 else None)
    ROOM.acquire(bench, quick.context)
    outcome = ROOM.solve(bench, Job())
    assert not outcome.verdict.ok
    assert "It has slipped in its clamp: fasten the clamp and acquire again" in said(outcome.verdict)
    # What was found to be void is clamped and probed anew when somebody asks for it.
    ROOM.acquire(bench, quick.context)
    assert ROOM.solve(bench, Job()).verdict.reasons == ()
    clamping = current_clamping(quick.session)
    assert clamping is not None and clamping.why.startswith("After probing:")


def test_a_deleted_line_alone_is_probed_again(quick: Live) -> None:
    bench = bench_of(quick)
    ROOM.acquire(bench, quick.context)
    line = kept(quick, "line")[4]
    quick.session.delete(line.id, PERSON)
    asked: list[str] = []
    before = len(quick.session.samples(STEP))
    ROOM.acquire(bench, replace(quick.context, consent=lambda path, purpose: bool(asked.append(purpose)) or True))
    assert any(f"to probe {U_COUNT} points of the airfoil on grinder fine" in purpose for purpose in asked)
    # Two scans to see that the blade is there, the head before and after, the line, two closing scans.
    assert len(quick.session.samples(STEP)) == before + 7
    assert ROOM.solve(bench, Job()).verdict.reasons == ()


def test_nobody_who_wants_no_motion_gets_one(quick: Live) -> None:
    paths: list[Any] = []

    def consent(path: Any, purpose: str) -> bool:
        paths.append((path, purpose))
        return "probe" not in purpose

    with pytest.raises(Refused, match="the motion was not wanted: to probe 486 points"):
        ROOM.acquire(bench_of(quick), replace(quick.context, consent=consent))
    path, _ = paths[-1]
    stood = quick.sim.cell.robot.read().base_from_flange
    np.testing.assert_allclose(path.base_from_flange[0], stood, atol=1e-9)
    assert kept(quick, "line") == [] and path.length_mm > 100.0 and path.duration_s > 0.0


def test_before_the_first_line_there_is_nothing_but_the_blade(quick: Live) -> None:
    bench = bench_of(quick)
    with pytest.raises(InputError, match=r"No line of the airfoil has been probed on grinder fine. Probe it first"):
        ROOM.solve(bench, Job())
    content = ROOM.view(bench, None)
    assert content.rows == () and content.plots == () and content.scene is not None and content.checks == ()
    assert not content.complete and content.numbers == ()
