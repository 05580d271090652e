"""The whole demonstration once, on a coarse scanner and grid: every step against the truth, files, session, report."""

import io
import json
import re
import shutil
import sqlite3
from collections.abc import Callable
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from PIL import Image

from beltgui import commissioning
from beltgui.commissioning import Commissioner, Commissioning
from beltgui.demo import DemoResult, run_demo
from beltgui.jobs import Cancelled, Job
from beltgui.replay import replay_session
from beltgui.session import Session
from beltgui.steps.blocks import plain
from beltgui.steps.sources import LiveSource, RecordedSource
from beltgui.steps.state import STEPS, StepEvent, StepState
from core.errors import InputError
from core.path import read_urscript
from devices.interfaces import Mount
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
        ("ball", "scan"): 20, ("base", "scan"): 15, ("rough", "scan"): 2, ("fine", "scan"): 2,
        ("tool", "cone_touch"): 12, ("tool", "shaft_touch"): 12, ("error_surface", "scan"): 2,
        ("error_surface", "line"): GRID[1], ("error_surface", "check"): 3, ("error_surface", "closing_scan"): 2,
    }  # fmt: skip
    assert all(result is not None and result.accepted for result in results.values())
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
    monkeypatch.setattr(commissioning.ball, "solve", lambda *words: done.found.ball)  # shown to repeat above
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
        (lambda folder: change(folder, "DELETE FROM info WHERE key = 'grinder'"), "does not say its grinder"),
        (lambda folder: change(folder, "UPDATE info SET value = '99' WHERE key = 'format'"), "format 99, expected 1"),
        (lambda folder: (folder / "clouds" / "00001_ball.npy").write_bytes(b"x"), "the cloud of sample 1 cannot"),
        (lambda folder: change(folder, "DELETE FROM sample"), "no sample 'scan' of the step 'ball'"),
    ],
)
def test_what_is_no_whole_session_is_refused_in_a_sentence(
    copy: Path, spoil: Callable[[Path], object], sentence: str
) -> None:
    spoil(copy)
    with pytest.raises(InputError, match=sentence):
        replay_session(copy)


@pytest.mark.parametrize(("step", "kind"), [("base", "scan"), ("tool", "shaft_touch"), ("error_surface", "check")])
def test_missing_samples_are_named(copy: Path, step: str, kind: str) -> None:
    change(copy, "DELETE FROM sample WHERE step = ? AND kind = ?", step, kind)
    read: dict[str, Callable[[RecordedSource], object]] = {
        "base": lambda source: source.base(Job()),
        "tool": lambda source: source.tool(Job()),
        "error_surface": lambda source: source.error_surface(Job(), None, None),  # type: ignore[arg-type]
    }
    with Session.open(copy) as session, pytest.raises(InputError, match=f"no sample '{kind}' of the step '{step}'"):
        read[step](RecordedSource(session))


# ---- cancel


@pytest.fixture
def solved(done: DemoResult, monkeypatch: pytest.MonkeyPatch) -> None:
    """Steps find at once what the demonstration found; only the acquisition is real."""
    found = done.found
    for step in ("ball", "base", "rough", "tool"):
        outcome = getattr(found, step)
        monkeypatch.setattr(getattr(commissioning, step), "solve", lambda *words, outcome=outcome: outcome)
    fines = iter((found.fine, found.clamped_again))
    monkeypatch.setattr(commissioning.fine, "solve", lambda *words, **named: next(fines))


class From:
    """A source of recorded samples for the steps before one, and of the live cell's samples from that one on."""

    def __init__(self, recorded: RecordedSource, live: LiveSource, first: str) -> None:
        self._recorded, self._live, self._first = recorded, live, first

    def __getattr__(self, name: str) -> Any:
        step = "error_surface" if name == "clamped_again" else name
        return getattr(self._live if STEPS.index(step) >= STEPS.index(self._first) else self._recorded, name)


@pytest.mark.parametrize(
    ("step", "when", "kind"),
    [
        ("ball", "scan 3 of", "scan"),
        ("base", "scan 3 of", "scan"),
        ("rough", "scan 1 of", "scan"),
        ("fine", "scan 1 of", "scan"),
        ("tool", "cone touch 4 of", "cone_touch"),
        ("error_surface", "probing line 2 of", "line"),
    ],
)
@pytest.mark.usefixtures("solved")
def test_every_step_can_be_cancelled(done: DemoResult, tmp_path: Path, step: str, when: str, kind: str) -> None:
    events: list[StepEvent] = []
    job = Job(lambda fraction, message: job.cancel() if when in message else None)
    blade, model = blade_and_model()
    with Session.open(done.session) as recorded, Live.start(tmp_path / "session") as live:
        context = live.with_job(job)
        if step == "fine":
            context.cell.operator.perform(Mount("blade", context.serial))
        commissioner = Commissioner(
            source=From(RecordedSource(recorded), LiveSource(context), step), plan=context.plan, blade=blade,
            model=model, grinder="fine", date="2026-01-01", job=job, on_step=events.append,
            keep=lambda name, record, ok: live.session.put_result(name, plain(record), accepted=ok),
        )  # fmt: skip
        with pytest.raises(Cancelled):
            commissioner.run(Commissioning())
    assert events[-1] == StepEvent(step, StepState.NOT_STARTED, "cancelled")
    before = list(STEPS[: STEPS.index(step)])
    assert [event.step for event in events if event.state is StepState.ACCEPTED] == before
    with Session.open(tmp_path / "session") as session:
        assert list(session.steps_with_results()) == before
        samples = session.samples(step, kind)
    assert len(samples) == int(re.search(r"\d+", when).group())  # type: ignore[union-attr]
