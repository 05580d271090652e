"""What faces hold before anything is scanned, filter boxes as lines, and progress that ends the work."""

from collections.abc import Callable

import numpy as np
import pytest

from core.cad import CadModel, Cylinder, Plane, read_step
from core.errors import InputError
from core.fine import analyse_faces, box_outlines, solve_fine
from core.frames import perturbed, rotate, transform_points
from core.progress import part
from core.rough import find_candidates
from resources import blade_type_path

SPREAD = ["S2", "S3", "S4", "S5", "S6"]


@pytest.fixture(scope="module")
def model() -> CadModel:
    return read_step(blade_type_path("dr95").with_name("dr95.step"))


def moved_off(model: CadModel, names: list[str], motion: np.ndarray, about: np.ndarray) -> float:
    """RMS distance of the faces' own points from the faces after a small motion about a point of W."""
    pose = perturbed(np.eye(4), motion, about)
    squares = []
    for face in model.select(names):
        low_s, low_t, high_s, high_t = face.trim.bounds
        s, t = (grid.ravel() for grid in np.meshgrid(np.linspace(low_s, high_s, 7), np.linspace(low_t, high_t, 7)))
        points = face.surface.from_surface(s, t)
        squares.append(np.mean(face.surface.to_surface(transform_points(pose, points))[2] ** 2))
    return float(np.sqrt(np.mean(squares)))


def test_the_usual_faces_hold_the_blade(model: CadModel) -> None:
    hold = analyse_faces(model, SPREAD)
    assert not hold.free and hold.conditioning.condition < 20.0
    assert analyse_faces(model, SPREAD, max_condition=2.0).free


def test_two_planes_leave_the_shift_along_their_common_line(model: CadModel) -> None:
    hold = analyse_faces(model, ["S2", "S3"])
    assert hold.free and not hold.turns
    at, direction = hold.axis
    planes = [face.surface for face in model.select(["S2", "S3"])]
    common = np.cross(planes[0].normal, planes[1].normal)
    np.testing.assert_allclose(np.abs(direction), np.abs(common / np.linalg.norm(common)), atol=1e-6)
    assert moved_off(model, ["S2", "S3"], np.concatenate([np.zeros(3), direction]), at) < 1e-6


def test_one_cylinder_lets_the_blade_slide_around_its_axis_or_along_it(model: CadModel) -> None:
    hold = analyse_faces(model, ["S1"])
    weakest = hold.conditioning.weakest_direction
    slide = np.concatenate([weakest[:3] / hold.lever_mm, weakest[3:]])
    assert hold.free and not hold.turns and np.linalg.norm(slide[3:]) > 0.9
    assert moved_off(model, ["S1"], slide, hold.centre_mm) < 2e-3  # 1 mm on a radius of 688 mm, to second order


def test_the_axis_of_a_free_turn_is_where_the_turn_leaves_the_face(model: CadModel) -> None:
    hold = analyse_faces(model, ["S2"])
    assert hold.free and hold.turns
    at, direction = hold.axis
    assert moved_off(model, ["S2"], np.concatenate([1e-4 * direction, np.zeros(3)]), at) < 1e-6


@pytest.mark.parametrize(("faces", "sentence"), [([], "empty"), (["AIRFOIL"], "free-form"), (["S9"], "no face")])
def test_faces_that_cannot_be_measured_on_are_refused(model: CadModel, faces: list[str], sentence: str) -> None:
    with pytest.raises(InputError, match=sentence):
        analyse_faces(model, faces)


@pytest.mark.parametrize("name", ["S2", "S4"])
def test_a_filter_box_keeps_its_margin_and_its_thickness(model: CadModel, name: str) -> None:
    face = model.face(name)
    lines = box_outlines(face, half_thickness_mm=0.5, margin_mm=1.0)
    assert isinstance(face.surface, Plane | Cylinder) and len(lines) >= 5
    s, t, d = face.surface.to_surface(np.concatenate(lines))
    np.testing.assert_allclose(np.abs(d), 0.5, atol=1e-9)
    import shapely

    depth = shapely.distance(face.trim.boundary, shapely.points(s, t))
    assert depth.min() > 0.999
    assert np.abs(np.diff(lines[0], axis=0)).max() < 2.5


def test_a_face_without_surface_has_no_box_and_a_narrow_one_none_to_show(model: CadModel) -> None:
    with pytest.raises(InputError, match="no filter box"):
        box_outlines(model.face("AIRFOIL"), half_thickness_mm=0.5, margin_mm=0.3)
    assert box_outlines(model.face("S2"), half_thickness_mm=0.5, margin_mm=500.0) == ()


# ---- progress


class Enough(Exception):  # noqa: N818
    pass


@pytest.fixture(scope="module")
def scan(model: CadModel) -> np.ndarray:
    """Points on the model's triangles, of the whole blade."""
    rng = np.random.default_rng(0)
    mesh = model.tessellate(0.1)
    corners = mesh.vertices[mesh.triangles]
    area = np.linalg.norm(np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0]), axis=1)
    pick = rng.choice(len(corners), 20_000, p=area / area.sum())
    a, b = np.sqrt(rng.random((2, len(pick), 1)))
    a, b = a, b**2
    points = (1 - a) * corners[pick, 0] + a * (1 - b) * corners[pick, 1] + a * b * corners[pick, 2]
    return points + rng.normal(0.0, 0.02, points.shape)


def teller(told: list[float], most: int | None = None) -> Callable[[float, str], None]:
    def tell(fraction: float, text: str) -> None:
        assert text
        told.append(fraction)
        if most is not None and len(told) == most:
            raise Enough

    return tell


def test_registration_tells_its_progress_and_can_be_ended(model: CadModel, scan: np.ndarray) -> None:
    told: list[float] = []
    fit = solve_fine(model, [scan], np.eye(4), progress=teller(told))
    assert told == sorted(told) and told[0] == 0.0 and told[-1] <= 1.0 and len(told) > 12
    assert [len(face.counts) for face in fit.faces if face.used] == [len(fit.bins_mm) - 1] * sum(
        face.used for face in fit.faces
    )
    assert all(sum(face.counts) >= 0.9 * face.points for face in fit.faces)
    with pytest.raises(Enough):
        solve_fine(model, [scan], np.eye(4), progress=teller([], 6))


def test_the_global_search_tells_its_progress_and_can_be_ended(model: CadModel, scan: np.ndarray) -> None:
    turned = rotate(perturbed(np.eye(4), np.array([0.4, 1.0, -0.7, 0.0, 0.0, 0.0]), np.zeros(3)), scan)
    told: list[float] = []
    find_candidates(model, turned, progress=teller(told))
    assert told == sorted(told) and told[0] == 0.0 and told[-1] <= 1.0 and len(told) > 60
    with pytest.raises(Enough):
        find_candidates(model, turned, progress=teller([], 20))


def test_a_part_of_the_work_tells_its_share() -> None:
    told: list[tuple[float, str]] = []
    part(lambda fraction, text: told.append((fraction, text)), 0.2, 0.6)(0.5, "half")
    assert told == [(pytest.approx(0.4), "half")]
