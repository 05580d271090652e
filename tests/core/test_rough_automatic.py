"""The blade found without picks: from random poses, with clutter, and refused where it is not there or not unique."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path

import numpy as np
import pytest
from scipy.spatial.transform import Rotation

from benchmarks.rough_scans import Blade, Scan, blade, two_area_scan, whole_view_scan
from core.cad import CadModel, read_step
from core.errors import FitError, InputError
from core.rough import Candidate, GlobalSettings, find_candidates, register_globally
from core.rough.automatic import accepted
from core.verdict import Code

BLADES = Path(__file__).parents[2] / "resources" / "blades"


@dataclass(frozen=True)
class Kept:
    """What a fine step that changes nothing returns."""

    measure_from_work: np.ndarray


def keep(model: CadModel, scans: Sequence[np.ndarray], start: np.ndarray) -> Kept:
    assert len(scans) == 1
    return Kept(start)


@pytest.fixture(scope="module")
def model() -> CadModel:
    return read_step(BLADES / "dr95.step")


@pytest.fixture(scope="module")
def body(model: CadModel) -> Blade:
    mesh = model.tessellate(0.03)
    return blade(mesh.vertices, mesh.triangles)


@pytest.fixture(scope="module")
def scan(body: Blade) -> Scan:
    return two_area_scan(body, np.random.default_rng(7), 20_000, 0.3)


@pytest.fixture(scope="module")
def candidates(model: CadModel, scan: Scan) -> tuple[Candidate, ...]:
    return find_candidates(model, scan.points, seed=3)


def off_by(estimate: np.ndarray, scan: Scan, body: Blade) -> float:
    change = estimate - scan.measure_from_work
    return float(np.linalg.norm(body.vertices @ change[:3, :3].T + change[:3, 3], axis=1).max())


@pytest.mark.parametrize(("seed", "clutter", "whole"), [(2, 0.4, False), (3, 0.3, True)])
def test_the_blade_is_found_from_any_pose(model: CadModel, body: Blade, seed: int, clutter: float, whole: bool) -> None:
    make = whole_view_scan if whole else two_area_scan
    scan = make(body, np.random.default_rng(seed), 15_000, clutter)
    fit = register_globally(model, scan.points, confirm=keep, seed=seed)
    assert off_by(fit.measure_from_work, scan, body) < 0.5
    assert fit.score > 0.3
    assert fit.candidates[0].agreement.rms_mm < 0.15
    assert isinstance(fit.fine, Kept)


def test_the_same_seed_gives_the_same_pose(model: CadModel, scan: Scan, candidates: tuple[Candidate, ...]) -> None:
    again = find_candidates(model, scan.points, seed=3)
    assert np.array_equal(again[0].measure_from_work, candidates[0].measure_from_work)


def test_what_the_fine_step_refuses_is_not_accepted(model: CadModel, scan: Scan,
                                                    candidates: tuple[Candidate, ...]) -> None:
    def refuse(model: CadModel, scans: Sequence[np.ndarray], start: np.ndarray) -> Kept:
        raise FitError("face S2 has 3 points.", Code.NOT_ENOUGH_POINTS)

    with pytest.raises(FitError, match=r"fine step refuses it: face S2 has 3 points") as caught:
        accepted(model, scan.points, candidates, refuse, GlobalSettings())
    assert caught.value.code is Code.NOT_ENOUGH_POINTS


def test_a_fine_step_that_wanders_off_is_not_believed(model: CadModel, scan: Scan,
                                                      candidates: tuple[Candidate, ...]) -> None:
    def wander(model: CadModel, scans: Sequence[np.ndarray], start: np.ndarray) -> Kept:
        moved = start.copy()
        moved[:3, 3] += [8.0, 0.0, 0.0]
        return Kept(moved)

    with pytest.raises(FitError, match=r"moved the model by 8\.0 mm"):
        accepted(model, scan.points, candidates, wander, GlobalSettings())


def test_another_blade_type_is_refused(scan: Scan) -> None:
    other = read_step(BLADES / "dr96.step")
    with pytest.raises(FitError, match=r"dr96.*Check the blade type") as caught:
        register_globally(other, scan.points, confirm=keep)
    assert caught.value.code is Code.WRONG_MODEL


def test_a_cube_is_refused(model: CadModel) -> None:
    rng = np.random.default_rng(0)
    points = rng.uniform(-40.0, 40.0, (12_000, 3))
    points[np.arange(12_000), rng.integers(0, 3, 12_000)] = 40.0
    points = Rotation.random(random_state=rng).apply(points + rng.normal(0.0, 0.03, points.shape))
    with pytest.raises(FitError, match="dr95"):
        register_globally(model, points, confirm=keep)


def test_a_block_whose_two_ways_round_look_alike_is_said_to_be_ambiguous(model: CadModel, body: Blade) -> None:
    # Edge plate and shroud look the same after half a turn about z; only the airfoil tells, and it is cut out here.
    scan = two_area_scan(body, np.random.default_rng(4), 30_000, 0.0)
    in_work = (scan.points - scan.measure_from_work[:3, 3]) @ scan.measure_from_work[:3, :3]
    plates = (in_work[:, 2] < 0.3) | (in_work[:, 2] > 211.0)
    with pytest.raises(FitError, match=r"in two ways.*180 degrees") as caught:
        register_globally(model, scan.points[plates], confirm=keep)
    assert caught.value.code is Code.NOT_ENOUGH_VARIATION


def test_unusable_scans_are_refused(model: CadModel, scan: Scan) -> None:
    with pytest.raises(InputError, match="looks like metres"):
        register_globally(model, scan.points * 1e-3, confirm=keep)
    with pytest.raises(InputError, match="Give both in mm"):
        register_globally(model, scan.points * 1e3, confirm=keep)
    with pytest.raises(FitError, match="at least 500"):
        register_globally(model, scan.points[:100], confirm=keep)
    broken = scan.points.copy()
    broken[17] = np.nan
    with pytest.raises(InputError, match=r"points\[17\]"):
        register_globally(model, broken, confirm=keep)


def test_shapes_without_flat_areas_or_surface_are_refused(model: CadModel) -> None:
    rng = np.random.default_rng(1)
    plane = np.column_stack([rng.uniform(-100.0, 100.0, (8000, 2)), rng.normal(0.0, 0.03, 8000)])
    with pytest.raises(FitError, match="fewer than two flat areas"):
        register_globally(model, plane, confirm=keep)
    with pytest.raises(FitError, match="flat enough"):
        register_globally(model, rng.uniform(-100.0, 100.0, (8000, 3)), confirm=keep)
