"""The fine step's room: chosen faces, what they leave free, a blade that slipped, and what the screen shows."""

import json
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from beltgui.jobs import Cancelled, Job
from beltgui.steps.fine.faces import chosen_faces
from beltgui.steps.fine.remembered import FILE, home, remember_faces, remembered_faces
from beltgui.steps.views.drawing import count_points
from beltgui.viewmodel.plot import Bars
from beltgui.viewmodel.scene import Arrow, Lines, Mesh, Points, Role
from beltgui.viewmodel.step import Use
from core.errors import FitError, InputError
from core.frames import inverse, pose_error, transform_points
from core.verdict import Code
from devices.interfaces import Mount
from tests.beltgui.blade_bench import PERSON, BladeBench, check_whole
from tests.beltgui.live import blade_and_model

DEFAULT = (21, 22, 29, 30, 33)  # S3, S2, S5, S6, S4
TWO_PLANES = [21, 22]  # nothing holds the shift along z


@pytest.fixture(scope="module")
def scanned(tmp_path_factory: pytest.TempPathFactory) -> Iterator[BladeBench]:
    with BladeBench.start(tmp_path_factory.mktemp("fine") / "session") as cell:
        cell.acquire("rough")
        cell.bench.found["rough"] = cell.solve("rough")
        cell.acquire("fine")
        yield cell


@pytest.fixture
def cell(scanned: BladeBench) -> Iterator[BladeBench]:
    """The scanned blade; a test's edits are undone after it."""
    yield scanned
    scanned.undo_all()


@pytest.fixture(scope="module")
def found(scanned: BladeBench) -> Any:
    return scanned.solve("fine")


@pytest.fixture
def rough_done(tmp_path: Path, scanned: BladeBench) -> Iterator[BladeBench]:
    """A blade scanned by the rough step only; the same seed, so the pose found before is its pose too."""
    with BladeBench.start(tmp_path / "session") as cell:
        cell.acquire("rough")
        cell.bench.found["rough"] = scanned.bench.found["rough"]
        yield cell


@pytest.fixture
def own_home(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    monkeypatch.setenv("BELTCAL_HOME", str(tmp_path / "home"))
    return tmp_path / "home"


# ---- scans


def test_the_blade_stays_clamped_between_rough_and_fine(scanned: BladeBench) -> None:
    samples = scanned.live.session.samples("fine", "scan")
    assert [(sample.data["slot"], sample.data["clamping"]) for sample in samples] == [(0, 1), (1, 1)]
    assert scanned.asked.items == ["blade"]


def test_the_blade_is_asked_for_after_the_stylus_was_mounted(rough_done: BladeBench) -> None:
    rough_done.live.context.cell.operator.perform(Mount("stylus"))
    rough_done.live.session.add_sample("tool", "cone_touch", {"slot": 0})
    rough_done.acquire("fine")
    assert rough_done.asked.items == ["blade", "stylus", "blade"]
    assert {sample.data["clamping"] for sample in rough_done.live.session.samples("fine", "scan")} == {2}
    outcome = rough_done.solve("fine")
    assert outcome.verdict.reasons == () and outcome.moved_mm is None
    assert rough_done.error_mm(outcome.fit.measure_from_work) < 0.1
    content = rough_done.fine.view(rough_done.bench, outcome)
    check_whole(content)
    assert "clamped anew" in content.remarks[0] and content.checks[0].ok is None


def test_a_cancelled_round_goes_on_with_the_missing_scan(rough_done: BladeBench) -> None:
    job = Job(lambda fraction, text: job.cancel() if "scan 1 of" in text else None)
    with pytest.raises(Cancelled):
        rough_done.acquire("fine", job)
    assert rough_done.fine.view(rough_done.bench, None).progress == "1 of 2 scans"
    rough_done.acquire("fine")
    assert [sample.data["slot"] for sample in rough_done.live.session.samples("fine", "scan")] == [0, 1]
    assert rough_done.asked.items == ["blade"]


@pytest.mark.parametrize("shift", [(0.3, 0.0, 0.0), (0.0, 0.0, 0.2)])
def test_a_blade_that_slipped_after_the_rough_step_is_rejected(
    rough_done: BladeBench, shift: tuple[float, float, float]
) -> None:
    rough_done.live.sim.world.faults.slip_blade(shift, np.zeros(3))
    rough_done.acquire("fine")
    outcome = rough_done.solve("fine")
    assert [reason.code for reason in outcome.verdict.reasons] == [Code.HELD_OUT_ERROR]
    assert "slipped in its clamp" in outcome.verdict.reasons[0].message
    assert outcome.moved_mm == pytest.approx(np.linalg.norm(shift), rel=0.25)
    content = rough_done.fine.view(rough_done.bench, outcome)
    check_whole(content)
    assert content.ok is False and content.checks[0].ok is False


# ---- result


def test_the_blade_is_found_in_the_flange_with_its_uncertainty(scanned: BladeBench, found: Any) -> None:
    assert found.verdict.reasons == () and found.face_ids == DEFAULT
    assert scanned.error_mm(found.fit.measure_from_work) < 0.1
    assert found.moved_mm < 0.05
    middle = transform_points(found.flange_from_work, scanned.bench.model.bounds_mm.mean(axis=0))
    error = pose_error(found.flange_from_work, scanned.live.sim.truth.flange_from_work, middle)
    sigma = np.sqrt(np.diag(found.flange_covariance.moved_to(middle).matrix))
    assert np.all(np.abs(error) < 5.0 * sigma + np.array([1e-3] * 3 + [0.25] * 3))  # and the robot's own error
    # What the base step leaves open is far more than the scanner's noise.
    assert sigma[3:].min() > np.sqrt(np.diag(found.fit.covariance.matrix))[3:].max()


def test_the_uncertainty_in_the_flange_is_that_of_both_links(scanned: BladeBench, found: Any) -> None:
    """Against both links' errors drawn at random and carried through the chain."""
    rng = np.random.default_rng(3)
    base = scanned.bench.found["base"].fit
    middle = found.flange_covariance.about_mm
    flange_from_base = inverse(found.base_from_flange)
    errors = []
    for _ in range(4000):
        links = []
        for pose, covariance in (
            (base.base_from_measure, base.covariance),
            (found.fit.measure_from_work, found.fit.covariance),
        ):
            small = rng.multivariate_normal(np.zeros(6), covariance.matrix)
            move = np.eye(4)
            move[:3, :3] += np.cross(np.eye(3), -small[:3])
            move[:3, 3] = covariance.about_mm - move[:3, :3] @ covariance.about_mm + small[3:]
            links.append(move @ pose)
        drawn = flange_from_base @ links[0] @ links[1]
        point = transform_points(inverse(found.flange_from_work), middle)
        errors.append(transform_points(drawn, point) - middle)
    spread = np.cov(np.array(errors).T)
    np.testing.assert_allclose(spread, found.flange_covariance.matrix[3:, 3:], atol=0.08 * np.trace(spread))


def test_progress_only_grows_and_the_work_can_be_ended(cell: BladeBench) -> None:
    told: list[float] = []

    def listen(fraction: float, text: str) -> None:
        told.append(fraction)
        if text.startswith("start 5 "):
            job.cancel()

    job = Job(listen)
    with pytest.raises(Cancelled):
        cell.solve("fine", job)
    assert told == sorted(told) and len(told) >= 5


def test_without_a_scan_its_faces_are_missed(cell: BladeBench) -> None:
    second = cell.live.session.samples("fine", "scan")[1]
    cell.live.session.include(second.id, False, PERSON)
    with pytest.raises(FitError) as refusal:
        cell.solve("fine")
    assert "S4" in str(refusal.value) or "S5" in str(refusal.value)
    content = cell.fine.view(cell.bench, None, str(refusal.value))
    check_whole(content)
    assert [row.use for row in content.rows] == [Use.FIT, Use.EXCLUDED]
    assert content.reasons[0].message == str(refusal.value)


# ---- chosen faces


def test_fewer_faces_give_a_result_of_their_own(cell: BladeBench) -> None:
    cell.choose("fine", "faces", [21, 22, 30, 33])
    outcome = cell.solve("fine")
    assert [face.id for face in outcome.fit.faces] == [21, 22, 30, 33]
    content = cell.fine.view(cell.bench, outcome)
    check_whole(content)
    mesh = next(item for item in content.scene.items if isinstance(item, Mesh))
    assert mesh.chosen_faces == (21, 22, 30, 33) and mesh.pickable
    assert set(mesh.chosen_faces) < set(mesh.face_id.tolist())
    rows = content.extra["faces_table"][1]
    assert [row.id for row in rows[:4]] == [21, 22, 30, 33] and all(row.included for row in rows[:4])
    assert not any(row.included for row in rows[4:])


def test_faces_that_leave_a_shift_free_are_named_before_and_after_scanning(cell: BladeBench) -> None:
    cell.choose("fine", "faces", TWO_PLANES)
    with pytest.raises(FitError, match=r"free to move: translation along \(.*1\.00\)") as refusal:
        cell.solve("fine")
    assert refusal.value.code is Code.ILL_CONDITIONED
    for error in ("", str(refusal.value)):
        content = cell.fine.view(cell.bench, None, error)
        check_whole(content)
        assert content.extra["free"] and "shift along (0.00, 0.00, 1.00)" in content.extra["hold"]
        assert content.reasons[0].code == "ILL_CONDITIONED" and content.suggestion is not None
        arrows = [item for item in content.scene.items if isinstance(item, Arrow)]
        assert arrows and all(item.role is Role.ATTENTION for item in arrows)
        way = arrows[0].vector / np.linalg.norm(arrows[0].vector)
        assert abs(way[2]) == pytest.approx(1.0, abs=1e-3)


def test_two_faces_that_hold_badly_and_one_plane_are_told_apart(cell: BladeBench) -> None:
    cell.choose("fine", "faces", [22])
    assert "turn about" in cell.fine.view(cell.bench, None).extra["hold"]
    cell.choose("fine", "faces", list(DEFAULT))
    content = cell.fine.view(cell.bench, None)
    assert content.extra["hold"] == "" and not content.extra["free"]
    assert not any(isinstance(item, Arrow) for item in content.scene.items)


@pytest.mark.parametrize(
    ("faces", "sentence"), [([], "No face is chosen"), ([26], "cannot be chosen"), ([99], "no face")]
)
def test_a_choice_that_cannot_be_used_is_refused_and_shown(cell: BladeBench, faces: list[int], sentence: str) -> None:
    cell.choose("fine", "faces", faces)
    with pytest.raises(InputError, match=sentence):
        cell.solve("fine")
    content = cell.fine.view(cell.bench, None)
    check_whole(content)
    assert sentence in content.reasons[0].message


# ---- remembered for the type


def test_chosen_faces_are_the_default_of_the_next_session(
    cell: BladeBench, own_home: Path, tmp_path: Path
) -> None:
    cell.choose("fine", "faces", [22, 30, 33])
    cell.fine.accepted(cell.bench)
    kept = json.loads((own_home / FILE).read_text(encoding="utf-8"))
    assert kept["DR95"]["faces"] == [22, 30, 33] and home() == own_home
    with BladeBench.start(tmp_path / "next") as after:
        assert chosen_faces(after.bench) == DEFAULT
        after.fine.begin(after.bench, PERSON)
        assert chosen_faces(after.bench) == (22, 30, 33)
        assert after.live.session.setting("fine", "faces") == [22, 30, 33]


@pytest.mark.usefixtures("own_home")
def test_nothing_is_chosen_where_nothing_was_remembered(tmp_path: Path) -> None:
    with BladeBench.start(tmp_path / "next") as cell:
        cell.fine.begin(cell.bench, PERSON)
        assert cell.live.session.setting("fine", "faces") is None


def test_faces_of_another_version_of_the_model_are_not_taken(own_home: Path) -> None:
    blade, model = blade_and_model()
    remember_faces(blade, model, [22, 30, 33])
    assert remembered_faces(blade, model) == (22, 30, 33)
    path = own_home / FILE
    path.write_text(path.read_text(encoding="utf-8").replace(model.sha256, "0" * 64), encoding="utf-8")
    assert remembered_faces(blade, model) is None


@pytest.mark.parametrize("content", ["{", "[]", '{"DR95": 3}', '{"DR95": {"faces": [26], "model_sha256": "HERE"}}'])
def test_a_damaged_file_of_choices_is_refused_or_passed_over(own_home: Path, content: str) -> None:
    blade, model = blade_and_model()
    own_home.mkdir()
    (own_home / FILE).write_text(content.replace("HERE", model.sha256), encoding="utf-8")
    if content in ("{", "[]"):
        with pytest.raises(InputError, match="Remove the file to begin anew"):
            remembered_faces(blade, model)
    else:
        assert remembered_faces(blade, model) is None


# ---- the screen


def test_what_the_screen_shows_of_a_result(scanned: BladeBench, found: Any) -> None:
    content = scanned.fine.view(scanned.bench, found)
    check_whole(content)
    assert content.ok and content.complete and content.reasons == ()
    assert content.headline.startswith("RMS on the faces ")
    by_label = {number.label: number for number in content.numbers}
    flange = [by_label[f"Blade in {{F}} {axis}"] for axis in "xyz"]
    np.testing.assert_allclose([number.value for number in flange], found.flange_from_work[:3, 3])
    assert all(number.unit == "mm" and 0.0 < number.plus_minus < 1.0 for number in flange)
    assert by_label["Blade in {M} Z"].unit == "deg" and by_label["Blade in {M} Z"].plus_minus > 0.0
    ends = [number for number in content.numbers if number.label.startswith("Uncertainty of")]
    np.testing.assert_allclose([number.value for number in ends], 2000.0 * found.fit.point_sigma_mm)
    assert all(number.unit == "µm" and number.limit == 40.0 for number in ends)
    assert [check.ok for check in content.checks] == [True] * len(content.checks)
    assert len(content.checks) == 2 + 4  # the other faces do not hold S4


def test_the_scan_is_coloured_by_face_and_by_distance(scanned: BladeBench, found: Any) -> None:
    content = scanned.fine.view(scanned.bench, found)
    assert content.scene.frame == "W" and count_points(content.scene) <= 60_000
    clouds = {item.name: item for item in content.scene.items if isinstance(item, Points)}
    assert {clouds[f"points of {name}"].role for name in ("S3", "S2", "S5", "S6", "S4")} == {
        Role(f"face {k}") for k in range(5)
    }
    s2 = scanned.bench.model.face("S2").surface
    distance = s2.to_surface(clouds["points of S2"].xyz.astype(float))[2]
    assert np.abs(distance).max() < 13.5 * found.fit.sigma_mm and np.median(np.abs(distance)) < 0.04
    assert any(isinstance(item, Lines) and item.role is Role.BOX for item in content.scene.items)
    coloured = content.extra["scenes"]["signed distance"]
    points = next(item for item in coloured.items if isinstance(item, Points) and item.values is not None)
    assert points.scale.title.endswith("µm") and points.scale.low == -points.scale.high
    scatter = 1.4826 * np.median(np.abs(points.values))
    assert scatter == pytest.approx(1000.0 * found.fit.rms_mm, rel=0.2)
    assert count_points(coloured) <= 60_000


def test_the_plots_show_every_face_in_micrometres(scanned: BladeBench, found: Any) -> None:
    plots = {plot.key: plot for plot in scanned.fine.view(scanned.bench, found).plots}
    assert set(plots) == {"residuals", "faces", "halves"}
    bars = plots["residuals"].series[0]
    assert isinstance(bars, Bars) and bars.width == 1.0
    assert len(plots["residuals"].series) == 1 + len(DEFAULT)
    spread = np.sqrt(np.average(bars.x**2, weights=bars.height))
    assert spread == pytest.approx(1000.0 * found.fit.rms_mm, rel=0.3)
    assert plots["faces"].series[0].labels == ("S3", "S2", "S5", "S6", "S4")
    assert plots["halves"].series[0].height.tolist() == (1000.0 * found.fit.half_split_mm).tolist()


def test_before_the_first_scan_the_faces_are_shown(tmp_path: Path) -> None:
    with BladeBench.start(tmp_path / "session") as cell:
        cell.bench.found.clear()
        content = cell.fine.view(cell.bench, None)
        check_whole(content)
        assert content.progress == "0 of 2 scans" and not content.complete and content.rows == ()
        assert any(isinstance(item, Mesh) and item.pickable for item in content.scene.items)
        assert [row.id for row in content.extra["faces_table"][1][:5]] == list(DEFAULT)
