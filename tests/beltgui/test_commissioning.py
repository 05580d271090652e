"""The whole demonstration once, on a coarse scanner and grid: every step against the truth, files, session, report."""

import io
import json
import re
import shutil
import sqlite3
from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from PIL import Image

from beltgui.commissioning import Commissioner
from beltgui.demo import DemoResult, run_demo
from beltgui.jobs import Cancelled, Job
from beltgui.replay import replay_session
from beltgui.session import Session
from beltgui.steps.ball.room import BallRoom
from beltgui.steps.blocks import plain
from beltgui.steps.context import Context
from beltgui.steps.room import Bench, Room
from beltgui.steps.rooms import ROOMS
from beltgui.steps.state import STEPS, StepEvent, StepState
from core.errors import InputError
from core.path import read_urscript
from tests.beltgui.live import Live, blade_and_model
from tests.beltgui.report_reader import Report

GRID = (33, 20)
# Largest true errors. The stage repeats to 3 µm and a ball's centre is good to some 10 µm; what 40 mm of travel leaves
# uncertain of the stage's angles carries over 200 mm to the blade. What passes through the robot's own report carries
# its absolute error of 0.25 mm RMS.
LARGEST_MM = {
    "scanned point in {M}, over all stage positions": 0.06,
    "measure in base, position": 0.6,
    "ball in flange": 0.15,
    "blade in measure, root": 0.1,
    "blade in measure, mid": 0.1,
    "blade in measure, tip": 0.1,
    "blade in flange, root": 0.3,
    "blade in flange, mid": 0.3,
    "blade in flange, tip": 0.3,
    "stylus tip in flange": 0.25,
    "wheel of grinder rough in base, position": 0.6,
    "wheel of grinder fine in base, position": 0.6,
    "blade in flange, clamped again, root": 0.3,
    "blade in flange, clamped again, mid": 0.3,
    "blade in flange, clamped again, tip": 0.3,
}
LARGEST_DEG = {
    "stage squareness xy": 0.04,
    "stage squareness yz": 0.04,
    "stage squareness zx": 0.04,
    "measure in base, orientation": 0.06,
    "wheel of grinder rough in base, orientation": 0.25,
    "wheel of grinder fine in base, orientation": 0.25,
}


@pytest.fixture(scope="module")
def out(tmp_path_factory: pytest.TempPathFactory) -> Path:
    return tmp_path_factory.mktemp("demo")


@pytest.fixture(scope="module")
def events() -> list[StepEvent]:
    return []


@pytest.fixture(scope="module")
def progress() -> list[float]:
    return []


@pytest.fixture(scope="module")
def done(out: Path, events: list[StepEvent], progress: list[float]) -> DemoResult:
    job = Job(lambda fraction, message: progress.append(fraction))
    return run_demo(out, resolution="test", grid=GRID, on_step=events.append, job=job)


@pytest.fixture(scope="module")
def report(done: DemoResult) -> Report:
    return Report(done.report.read_text(encoding="utf-8"))


def in_mm(text: str) -> float:
    value, unit = re.fullmatch(r"([\d.]+) (mm|µm)(?: RMS)?", text).groups()  # type: ignore[union-attr]
    return float(value) * {"mm": 1.0, "µm": 1e-3}[unit]


def test_all_six_steps_are_accepted_in_their_order(done: DemoResult, events: list[StepEvent]) -> None:
    assert done.accepted, done.headline
    assert {name: verdict.reasons for name, verdict in done.found.verdicts.items()} == dict.fromkeys(STEPS, ())
    expected = [(step, state) for step in STEPS for state in (StepState.RUNNING, StepState.ACCEPTED)]
    assert [(event.step, event.state) for event in events] == expected
    assert all(re.search(r"\d (mm|µm)", event.headline) for event in events if event.state is StepState.ACCEPTED)


def test_progress_only_grows(done: DemoResult, progress: list[float]) -> None:
    assert progress == sorted(progress)
    assert progress[0] >= 0.0 and progress[-1] == 1.0


def test_every_estimate_is_near_the_truth(done: DemoResult) -> None:
    checked = set()
    for row in done.rows:
        if row.error.endswith("°"):
            assert float(row.error[:-1]) < LARGEST_DEG[row.quantity], row
        else:
            assert in_mm(row.error) < LARGEST_MM[row.quantity], row
        checked.add(row.quantity)
    assert checked == LARGEST_MM.keys() | LARGEST_DEG.keys()
    assert {row.step for row in done.rows} == set(STEPS)


def test_the_fine_step_knows_how_well_it_did(done: DemoResult) -> None:
    assert done.found.fine is not None
    fit = done.found.fine.fit
    assert fit.point_sigma_mm.max() < 0.02
    assert fit.half_split_mm.max() < 0.02


def test_compensation_takes_the_error_away(done: DemoResult) -> None:
    assert done.proof is not None
    assert 0.3 < done.proof.nominal_rms_mm < 0.8
    assert done.proof.compensated_rms_mm < 0.02
    assert done.proof.compensated_worst_mm < 0.1
    strokes = [stroke for part in done.proof.strokes.values() for stroke in part]
    assert all(np.isfinite(stroke.compensated_mm).all() for stroke in strokes)
    assert sum(len(stroke.u) for stroke in strokes) > 400


def test_program_files_are_read_back(done: DemoResult) -> None:
    assert sorted(path.name for path in done.programs) == ["longitudinal.script", "transverse.script"]
    for path in done.programs:
        plan = done.found.programs[path.stem].plan
        contacts = np.concatenate([stroke.base_from_flange for stroke in plan.strokes])
        poses = read_urscript(path.read_text(encoding="utf-8"))
        assert len(poses) == len(contacts) + 2 * len(plan.strokes)  # towards and away from the wheel at each stroke
        distances = np.linalg.norm(poses[:, None, :3, 3] - contacts[None, ::20, :3, 3], axis=2).min(axis=0)
        assert distances.max() < 1e-5  # mm: nine decimals of a metre


def test_the_session_holds_every_sample_and_result(done: DemoResult) -> None:
    with Session.open(done.session) as session:
        counts = {
            (step, kind): len(session.samples(step, kind))
            for step, kind in (
                ("ball", "scan"), ("base", "scan"), ("rough", "scan"), ("fine", "scan"), ("tool", "cone_touch"),
                ("tool", "shaft_touch"), ("error_surface", "scan"), ("error_surface", "line"),
                ("error_surface", "check"), ("error_surface", "closing_scan"),
            )
        }  # fmt: skip
        assert list(session.steps_with_results()) == list(STEPS)
        results = {step: session.result(step) for step in STEPS}
        scan = session.samples("fine", "scan")[0]
        assert len(session.points(scan)) > 10_000
        info = session.info()
    assert counts == {
        ("ball", "scan"): 19, ("base", "scan"): 14, ("rough", "scan"): 2, ("fine", "scan"): 2,
        ("tool", "cone_touch"): 12, ("tool", "shaft_touch"): 12, ("error_surface", "scan"): 2,
        ("error_surface", "line"): GRID[1], ("error_surface", "check"): 3, ("error_surface", "closing_scan"): 2,
    }  # fmt: skip
    assert all(result is not None and result.ok for result in results.values())
    assert info["simulated"] is True and info["seed"] == 0
    for name in ("blade", "cell"):
        assert (done.session / "inputs" / info[name]).is_file()


def test_the_report_is_whole(report: Report) -> None:
    assert report.open == []
    text = " ".join(report.words)
    assert not re.search(r"\b(nan|inf|none)\b", text, re.IGNORECASE)
    assert "accepted" in text and "✖" not in text
    assert len(report.pictures) >= 9
    for picture in report.pictures:
        with Image.open(io.BytesIO(picture)) as image:
            pixels = np.asarray(image.convert("RGB"))
        assert pixels.std() > 3.0


def test_every_number_of_the_report_has_its_unit(report: Report) -> None:
    """A column's head gives the unit, or the cell does: lengths and angles never stand alone."""
    lengths = [head for head in report.heads if re.search("RMS|mean|held out", head)]
    assert lengths and all(re.search(r" in (mm|µm|°)$", head) for head in lengths)
    bare = [cell for cell in report.cells if re.fullmatch(r"\(.*\)|[+-]?\d+\.\d+", cell)]
    # Bare decimals stand only under the heads above, five faces with three columns each.
    assert len(bare) <= 15
    vectors = [cell for cell in report.cells if cell.startswith("(")]
    assert len(vectors) > 20
    assert all(re.search(r"\) (mm|°)$", cell) for cell in vectors)


def test_a_second_run_into_the_same_folder_is_refused(done: DemoResult, out: Path) -> None:
    before = {path: path.read_bytes() for path in sorted(out.rglob("*")) if path.is_file()}
    with pytest.raises(InputError, match=r"session already\. Choose another folder"):
        run_demo(out, resolution="test", grid=GRID)
    assert {path: path.read_bytes() for path in sorted(out.rglob("*")) if path.is_file()} == before


# ---- replay


@pytest.fixture
def copy(done: DemoResult, tmp_path: Path) -> Path:
    return Path(shutil.copytree(done.session, tmp_path / "session"))


def change(folder: Path, sql: str, *values: Any) -> None:
    connection = sqlite3.connect(folder / "session.db")
    with connection:
        assert connection.execute(sql, values).rowcount > 0
    connection.close()


def test_a_session_replays_identically(done: DemoResult) -> None:
    before = (done.session / "session.db").read_bytes()
    replay = replay_session(done.session)
    assert [step.step for step in replay.steps] == list(STEPS)
    assert all(step.accepted for step in replay.steps)
    assert {step.step: step.differences for step in replay.steps} == dict.fromkeys(STEPS, ())
    assert replay.same
    for path in done.programs:
        again = read_urscript(replay.found.programs[path.stem].text)
        np.testing.assert_allclose(again, read_urscript(path.read_text(encoding="utf-8")), atol=1e-5)
    assert (done.session / "session.db").read_bytes() == before


def test_a_changed_sample_shows_in_its_step_and_not_before(
    done: DemoResult, copy: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(BallRoom, "solve", lambda *words: done.found.ball)  # shown to repeat above
    with Session.open(copy) as session:
        sample = session.samples("base", "scan")[4]
    data = sample.data | {"stage_mm": [sample.data["stage_mm"][0] + 0.2, *sample.data["stage_mm"][1:]]}
    change(copy, "UPDATE sample SET data = ? WHERE id = ?", json.dumps(data), sample.id)
    change(copy, "DELETE FROM result WHERE step NOT IN ('ball', 'base')")  # the rest would only take time
    replay = replay_session(copy)
    assert [(step.step, step.same) for step in replay.steps] == [("ball", True), ("base", False)]
    differences = replay.steps[1].differences
    assert any(difference.field.startswith("base_from_measure") for difference in differences)
    assert all(difference.recorded != difference.now for difference in differences)


@pytest.mark.parametrize(
    ("spoil", "sentence"),
    [
        (lambda folder: (folder / "session.db").unlink(), r"no session here, session\.db is missing. Give the folder"),
        (lambda folder: (folder / "session.db").write_bytes(b"no database" * 100), "this is not a session's database"),
        (lambda folder: change(folder, "DELETE FROM result"), "no finished step, there is nothing to compare"),
        (lambda folder: (folder / "inputs" / "dr95.toml").unlink(), r"dr95\.toml"),
        (lambda folder: (folder / "inputs" / "dr95.step").unlink(), r"dr95\.step"),
        (lambda folder: (folder / "inputs" / "simulated.toml").unlink(), r"simulated\.toml"),
        (lambda folder: change(folder, "DELETE FROM info WHERE key = 'date'"), "does not say its date"),
        (lambda folder: change(folder, "UPDATE info SET value = '99' WHERE key = 'format'"), "format 99, expected 2"),
        (lambda folder: (folder / "clouds" / "00001_ball.npy").write_bytes(b"x"), "the cloud of sample 1 cannot"),
        (lambda folder: change(folder, "DELETE FROM sample"), "No scan shows the ball yet. Take the scans"),
    ],
)
def test_what_is_no_whole_session_is_refused_in_a_sentence(
    copy: Path, spoil: Callable[[Path], object], sentence: str
) -> None:
    spoil(copy)
    with pytest.raises(InputError, match=sentence):
        replay_session(copy)


@pytest.mark.parametrize(
    ("step", "kind", "said"),
    [
        ("base", "scan", "No scan shows the ball yet. Take the scans."),
        ("tool", "shaft_touch", "12 of 26 planned touches and readings are missing. Take the missing ones."),
        ("error_surface", "line", "No line of the airfoil has been probed on grinder fine. Probe it first."),
        ("error_surface", "check", "20 of 23 lines of the airfoil are probed."),
    ],
)
def test_missing_samples_are_named(done: DemoResult, copy: Path, step: str, kind: str, said: str) -> None:
    change(copy, "DELETE FROM sample WHERE step = ? AND kind = ?", step, kind)
    bench = done.found.bench
    with Session.open(copy) as session:
        there = Bench(session, bench.plan, bench.blade, bench.model, bench.date, dict(bench.found))
        try:
            messages = [reason.message for reason in ROOMS[step].solve(there, Job()).verdict.reasons]
        except InputError as error:
            messages = [str(error)]
    assert any(said in message for message in messages), messages


# ---- cancel


@dataclass(frozen=True)
class AlreadyFound:
    """A room whose step was done before: only what comes after it is real."""

    room: Room
    outcome: Any

    @property
    def step(self) -> str:
        return self.room.step

    def __getattr__(self, name: str) -> Any:
        return getattr(self.room, name)

    def acquire(self, bench: Bench, context: Context) -> None:
        pass

    def solve(self, bench: Bench, job: Job) -> Any:
        return self.outcome


@pytest.mark.parametrize(
    ("step", "when", "kind", "kept"),
    [
        ("ball", "scan 3 of", "scan", 3),
        ("base", "scan 3 of", "scan", 3),
        ("rough", "scan 1 of", "scan", 1),
        ("fine", "scan 1 of", "scan", 1),
        ("tool", "cone touch 4 of", "cone_touch", 4),
        ("error_surface", "probing line 2 of", "line", 1),
    ],
)
def test_every_step_can_be_cancelled(
    done: DemoResult, tmp_path: Path, step: str, when: str, kind: str, kept: int
) -> None:
    events: list[StepEvent] = []
    job = Job(lambda fraction, message: job.cancel() if when in message else None)
    blade, model = blade_and_model()
    before = list(STEPS[: STEPS.index(step)])
    rooms = {
        name: AlreadyFound(room, done.found.bench.found[name]) if name in before else room
        for name, room in ROOMS.items()
    }
    with Live.start(tmp_path / "session") as live:
        bench = Bench(live.session, live.context.plan, blade, model, "2026-01-01")

        def keep(name: str, record: Any, headline: str, ok: bool) -> None:
            live.session.put_result(name, plain(record), ok=ok, headline=headline)

        def acquire(room: Room, part: Job) -> None:
            room.acquire(bench, live.with_job(part))

        with pytest.raises(Cancelled):
            Commissioner(bench, acquire, job, keep, events.append, rooms).run()
    assert events[-1] == StepEvent(step, StepState.NOT_STARTED, "cancelled")
    assert [event.step for event in events if event.state is StepState.ACCEPTED] == before
    with Session.open(tmp_path / "session") as session:
        assert list(session.steps_with_results()) == before
        samples = session.samples(step, kind)
    assert len(samples) == kept
