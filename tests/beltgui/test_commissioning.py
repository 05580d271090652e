"""The whole demonstration once, on a coarse scanner and grid: every step against the truth, files, session, report."""

import io
import re
from pathlib import Path

import numpy as np
import pytest
from PIL import Image

from beltgui.demo import DemoResult, run_demo
from beltgui.session import Session
from beltgui.steps.state import STEPS, StepEvent, StepState
from core.errors import InputError
from core.path import read_urscript
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
def done(out: Path, events: list[StepEvent]) -> DemoResult:
    return run_demo(out, resolution="test", grid=GRID, on_step=events.append)


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
                ("error_surface", "check"),
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
        ("error_surface", "line"): GRID[1], ("error_surface", "check"): 3,
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
