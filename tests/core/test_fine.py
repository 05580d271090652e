"""The fine step as a whole: truth, scan, pose; and everything that must be refused."""

from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest
from scipy.spatial.transform import Rotation

import resources
from benchmarks.unknown_blade import read_sampler, simulate, write_blade
from core.cad import read_step
from core.errors import FitError, InputError
from core.fine import FineLimits, FineSettings, assign_points, judge_fine, solve_fine
from core.fine.checks import check_start
from core.verdict import Code

BLADES = Path(resources.__file__).parent / "blades"
FACES = ["S2", "S3", "S4", "S5", "S6"]
NEAR = FineSettings(search=False)


@pytest.fixture(scope="module")
def dr95():
    return read_step(BLADES / "dr95.step"), read_sampler(BLADES / "dr95.step")


@pytest.fixture(scope="module")
def scene(dr95):
    return simulate(dr95[1], np.random.default_rng(11), 20_000, views=3)


@pytest.fixture(scope="module")
def fit(dr95, scene):
    return solve_fine(dr95[0], [scene.points], scene.start)


def faces_scene(dr95, names, seed, count=6000, **options):
    """A scan of some faces only, the start nearly right."""
    model, sampler = dr95
    ids = tuple(model.face(name).id for name in names)
    return simulate(sampler, np.random.default_rng(seed), count, faces=ids, all_round=True,
                    **{"turn_deg": 0.05, "shift_mm": 0.1, **options})


def test_pose_within_three_bounds_from_a_start_far_off(fit, scene):
    assert np.all(scene.error_mm(fit.measure_from_work) < 3.0 * scene.bound_mm())
    assert fit.sigma_mm == pytest.approx(0.035, rel=0.05)
    assert np.all(fit.point_sigma_mm < 1.3 * scene.bound_mm())
    assert fit.converged
    assert fit.start_moved_mm > 5.0
    assert judge_fine(fit).ok


@pytest.mark.parametrize("seed", [1])
def test_a_blade_that_is_in_no_project(tmp_path, seed):
    rng = np.random.default_rng(seed)
    write_blade(rng, tmp_path / "blade.step")
    unknown = simulate(read_sampler(tmp_path / "blade.step"), rng, 40_000, clutter=seed % 2 == 1, views=1 + seed % 3)
    found = solve_fine(read_step(tmp_path / "blade.step"), [unknown.points], unknown.start)
    assert np.all(unknown.error_mm(found.measure_from_work) < 3.0 * unknown.bound_mm())


def test_named_faces_in_two_scans(dr95):
    scene = faces_scene(dr95, FACES, 3, 8000, turn_deg=2.5, shift_mm=3.0)
    fit = solve_fine(dr95[0], [scene.points[:3000], scene.points[3000:]], scene.start, face_ids=FACES)
    assert np.all(scene.error_mm(fit.measure_from_work) < 3.0 * scene.bound_mm())
    assert sorted(face.name for face in fit.faces) == FACES
    assert {face.type for face in fit.faces} == {"plane", "cylinder"}
    for face in fit.faces:
        assert face.used
        assert face.points > 300
        assert abs(face.mean_mm) < 5 * 0.035 / np.sqrt(face.points) + 0.003
        assert face.rms_mm == pytest.approx(0.035, rel=0.15)
        assert face.coverage > 0.6


def test_faces_without_points_are_left_out_with_a_note(dr95):
    scene = faces_scene(dr95, FACES, 5)
    fit = solve_fine(dr95[0], [scene.points], scene.start, settings=NEAR)
    used = {face.name for face in fit.faces if face.used}
    assert used == set(FACES)
    assert all(face.note for face in fit.faces if not face.used)


def test_the_same_input_gives_the_same_pose(dr95):
    scene = faces_scene(dr95, FACES, 4)
    one, two = (solve_fine(dr95[0], [scene.points], scene.start, face_ids=FACES, settings=NEAR) for _ in range(2))
    assert np.array_equal(one.measure_from_work, two.measure_from_work)


def test_the_fixture_table_is_not_taken_for_a_face(tmp_path):
    # Few faces are seen, none of them square to z; the table below the blade is, and it is larger than all of them.
    rng = np.random.default_rng(106)
    write_blade(rng, tmp_path / "blade.step")
    sampler, model = read_sampler(tmp_path / "blade.step"), read_step(tmp_path / "blade.step")
    regular = [number for number, kind in sampler.kinds.items() if kind != "other"]
    faces = tuple(int(i) for i in rng.choice(regular, 6, replace=False))
    scene = simulate(sampler, rng, 40_000, faces=faces, views=6)
    fit = solve_fine(model, [scene.points], scene.start)
    assert np.all(scene.error_mm(fit.measure_from_work) < 3.0 * scene.bound_mm())


def test_known_noise_sets_the_covariance(dr95):
    scene = faces_scene(dr95, FACES, 6)
    one, two = (solve_fine(dr95[0], [scene.points], scene.start, face_ids=FACES,
                           settings=FineSettings(sigma_mm=sigma, search=False)) for sigma in (0.035, 0.040))
    ratio = np.sqrt(np.trace(two.covariance.matrix) / np.trace(one.covariance.matrix))
    assert ratio == pytest.approx(0.040 / 0.035, rel=0.06)


def test_held_out_figures_are_of_the_size_of_the_uncertainty(fit):
    held_out = np.array([face.held_out_mm for face in fit.faces if face.used])
    assert np.nanmax(np.abs(held_out)) < 0.03
    assert np.all(fit.half_split_mm < 8.0 * fit.point_sigma_mm)


def test_points_are_assigned_to_faces(dr95, scene, fit):
    ids = [face.id for face in fit.faces if face.used]
    result = assign_points(dr95[0], scene.points, fit.measure_from_work, ids)
    on = result.face_id > 0
    assert set(np.unique(result.face_id[on])) <= set(ids)
    assert np.abs(result.distance_mm[on]).max() <= 0.2
    assert np.isnan(result.distance_mm[~on]).all()


def test_limits_of_the_blade_type_are_judged(fit):
    verdict = judge_fine(fit, FineLimits(rms_mm=0.01, point_sigma_mm=1e-5, min_faces=99))
    assert {reason.code for reason in verdict.reasons} == {Code.HIGH_RESIDUAL, Code.HIGH_UNCERTAINTY,
                                                           Code.NOT_ENOUGH_VARIATION}
    named = replace(fit, faces_named=True)
    assert [reason.code for reason in judge_fine(named, FineLimits(min_points_per_face=100_000)).reasons] == [
        Code.NOT_ENOUGH_POINTS]


def test_the_wrong_blade_type_is_refused(scene):
    with pytest.raises(FitError, match="blade type") as error:
        solve_fine(read_step(BLADES / "dr96.step"), [scene.points], scene.start)
    assert error.value.code == Code.WRONG_MODEL


def test_a_start_turned_over_never_gives_a_wrong_pose(dr95, scene):
    turn = np.eye(4)
    turn[:3, :3] = Rotation.from_euler("y", 180.0, degrees=True).as_matrix()
    try:
        fit = solve_fine(dr95[0], [scene.points], scene.measure_from_work @ turn)
    except FitError:
        return
    assert np.all(scene.error_mm(fit.measure_from_work) < 3.0 * scene.bound_mm())


@pytest.mark.parametrize(("names", "words"), [
    (["S3", "S5"], "leave the blade free"),
    (["S4"], "leave the blade free"),
    (["S2", "S4"], "translation along"),
])
def test_a_free_direction_is_named(dr95, names, words):
    scene = faces_scene(dr95, names if len(names) > 1 else FACES, 8)
    with pytest.raises(FitError, match=words) as error:
        solve_fine(dr95[0], [scene.points], scene.start, face_ids=names, settings=NEAR)
    assert error.value.code == Code.ILL_CONDITIONED
    assert "Add a" in str(error.value)


def test_a_named_face_without_points_is_named_in_the_refusal(dr95):
    scene = faces_scene(dr95, ["S2", "S3", "S5", "S6"], 9)
    with pytest.raises(FitError, match="S4") as error:
        solve_fine(dr95[0], [scene.points], scene.start, face_ids=FACES, settings=NEAR)
    assert error.value.code == Code.NOT_ENOUGH_POINTS


def test_a_scan_in_metres_is_noticed(dr95, scene):
    with pytest.raises(InputError, match="metres"):
        solve_fine(dr95[0], [scene.points / 1000.0], scene.start)


def test_a_start_in_metres_is_noticed(dr95, scene):
    metres = scene.start.copy()
    metres[:3, 3] = (0.9, -0.4, 0.6)
    with pytest.raises(InputError, match=r"start's translation .* metres"):
        solve_fine(dr95[0], [scene.points + 1500.0], metres)


def test_a_pose_far_from_its_start_is_not_trusted(dr95, scene):
    """What the start brings near may fit another way round too, for instance a symmetric root."""
    model, _ = dr95
    check_start(model, scene.start, scene.measure_from_work, FineSettings())
    turned = scene.measure_from_work.copy()
    turned[:3, :3] = turned[:3, :3] @ np.diag([1.0, -1.0, -1.0])
    with pytest.raises(FitError, match="Redo the rough step") as error:
        check_start(model, turned, scene.measure_from_work, FineSettings())
    assert error.value.code == Code.NOT_CONVERGED


def test_a_start_far_from_everything(dr95, scene):
    away = scene.start.copy()
    away[:3, 3] += 2000.0
    with pytest.raises(FitError, match="mm away"):
        solve_fine(dr95[0], [scene.points], away)


@pytest.mark.parametrize(("points", "words"), [
    (np.zeros((10, 3)), "at least"),
    (np.zeros((100, 2)), "shape"),
    (np.full((100, 3), np.nan), "NaN"),
    (np.zeros((100, 3)), "only 0 mm across"),
])
def test_unusable_scans(dr95, points, words):
    with pytest.raises(InputError, match=words):
        solve_fine(dr95[0], [points], np.eye(4))


@pytest.mark.parametrize(("ids", "words"), [([999], "999"), (["AIRFOIL", "S2"], "AIRFOIL"), (["S2", "S2"], "twice"),
                                            ([], "empty")])
def test_unusable_lists_of_faces(dr95, scene, ids, words):
    with pytest.raises(InputError, match=words):
        solve_fine(dr95[0], [scene.points], scene.start, face_ids=ids)


def test_a_start_that_is_no_pose(dr95, scene):
    with pytest.raises(InputError, match="start"):
        solve_fine(dr95[0], [scene.points], 2.0 * np.eye(4))
