import numpy as np
import pytest

from core.cad import read_step
from core.errors import InputError
from core.frames import rigid, rotation_from_rotvec
from resources import resource_path
from tests.core import cad_shapes as shapes

PLACE = rigid(rotation_from_rotvec([0.3, -0.5, 0.9]), [40.0, -20.0, 7.0])


@pytest.fixture(scope="module")
def blade():
    return read_step(resource_path("blades", "dr95.step"))


@pytest.fixture(scope="module")
def airfoil(blade):
    return blade.spline_surface("AIRFOIL")


@pytest.fixture(scope="module")
def ball(tmp_path_factory):
    """A sphere as rational, periodic B-spline: every one of its points, normals and distances is known."""
    from OCP.BRepBuilderAPI import BRepBuilderAPI_NurbsConvert
    from OCP.BRepPrimAPI import BRepPrimAPI_MakeSphere

    solid = BRepBuilderAPI_NurbsConvert(BRepPrimAPI_MakeSphere(10.0).Shape(), True).Shape()
    path = shapes.write(shapes.moved(solid, PLACE), tmp_path_factory.mktemp("ball") / "ball.step")
    model = read_step(path)
    return model.spline_surface(next(face.id for face in model.faces if face.type == "bspline"))


def parameters(surface, count, seed=1):
    (u0, u1), (v0, v1) = surface.domain
    rng = np.random.default_rng(seed)
    return rng.uniform(u0, u1, count), rng.uniform(v0, v1, count)


def kernel_values(blade, u, v):
    """Points and derivatives by the kernel's own evaluator."""
    from OCP.BRep import BRep_Tool
    from OCP.gp import gp_Pnt, gp_Vec
    from OCP.STEPControl import STEPControl_Reader

    reader = STEPControl_Reader()
    reader.ReadFile(str(blade.path))
    reader.TransferRoots()
    surface = BRep_Tool.Surface_s(shapes.faces(reader.OneShape())[blade.face("AIRFOIL").id - 1])
    rows = []
    for a, b in zip(u, v, strict=True):
        point, vectors = gp_Pnt(), [gp_Vec() for _ in range(5)]
        surface.D2(float(a), float(b), point, *vectors)
        rows.append([(item.X(), item.Y(), item.Z()) for item in (point, *vectors)])
    return np.array(rows).swapaxes(0, 1)


def test_values_and_derivatives_agree_with_the_kernel(blade, airfoil):
    u, v = parameters(airfoil, 60)
    u[:4], v[:4] = [0.0, 1.0, 0.0, 1.0], [0.0, 0.0, 1.0, 1.0]
    point, du, dv, duu, dvv, duv = kernel_values(blade, u, v)
    for ours, theirs in zip(airfoil.derivatives(u, v), (point, du, dv), strict=True):
        np.testing.assert_allclose(ours, theirs, atol=1e-9)
    for ours, theirs in zip(airfoil.second_derivatives(u, v), (duu, duv, dvv), strict=True):
        np.testing.assert_allclose(ours, theirs, rtol=1e-9, atol=1e-7)


def test_a_rational_periodic_surface_is_evaluated_exactly(ball):
    u, v = parameters(ball, 500)
    assert ball.weights is not None
    radial = ball.point(u, v) - PLACE[:3, 3]
    np.testing.assert_allclose(np.linalg.norm(radial, axis=1), 10.0, atol=1e-9)
    np.testing.assert_allclose(ball.normal(u, v), radial / 10.0, atol=1e-7)
    step = 1e-6
    inside = (u > 0.01) & (u < ball.domain[0][1] - 0.01)
    u, v = u[inside], np.clip(v[inside], ball.domain[1][0] + 0.01, ball.domain[1][1] - 0.01)
    for order, (a, b) in enumerate([(step, 0.0), (0.0, step)]):
        ahead, behind = ball.derivatives(u + a, v + b), ball.derivatives(u - a, v - b)
        slope = [(x - y) / (2 * step) for x, y in zip(ahead, behind, strict=True)]
        np.testing.assert_allclose(ball.derivatives(u, v)[1 + order], slope[0], atol=1e-5)
        second = ball.second_derivatives(u, v)
        # Knots of multiplicity two carry a jump of the second derivative; a few samples may straddle one.
        wrong = np.abs(second[2 * order] - slope[1 + order]).max(axis=1) > 1e-4
        assert wrong.mean() < 0.01


def test_feet_and_signed_distances_are_found(airfoil):
    u, v = parameters(airfoil, 800, seed=2)
    u, v = 0.01 + 0.98 * u, 0.01 + 0.98 * v
    distance = np.random.default_rng(3).uniform(-0.8, 2.0, u.size)
    points = airfoil.point(u, v) + distance[:, None] * airfoil.normal(u, v)
    for start in (None, np.column_stack([u + 0.004, v - 0.01])):
        feet = airfoil.closest(points, start)
        assert feet.converged.all()
        np.testing.assert_allclose(feet.distance_mm, distance, atol=1e-9)
        np.testing.assert_allclose(np.column_stack([feet.u, feet.v]), np.column_stack([u, v]), atol=1e-8)
        np.testing.assert_allclose(feet.foot_mm, airfoil.point(u, v), atol=1e-7)


def test_far_points_on_a_sphere_find_the_radial_foot(ball):
    rng = np.random.default_rng(4)
    # Both poles, where the parameters degenerate, are left out; the seam is not.
    longitude, latitude = rng.uniform(-np.pi, np.pi, 300), rng.uniform(-1.3, 1.3, 300)
    longitude[:40] = rng.uniform(-0.05, 0.05, 40)
    direction = np.column_stack([np.cos(latitude) * np.cos(longitude), np.cos(latitude) * np.sin(longitude),
                                 np.sin(latitude)]) @ PLACE[:3, :3].T
    radius = rng.uniform(4.0, 30.0, 300)
    feet = ball.closest(PLACE[:3, 3] + radius[:, None] * direction)
    np.testing.assert_allclose(np.linalg.norm(feet.foot_mm - PLACE[:3, 3] - 10.0 * direction, axis=1), 0.0, atol=1e-6)
    assert feet.converged.all()
    np.testing.assert_allclose(feet.distance_mm, radius - 10.0, atol=1e-6)


def test_points_beyond_the_end_stop_at_the_edge_of_the_domain(airfoil):
    beyond = airfoil.point([0.3, 0.7], [1.0, 1.0]) + np.array([0.0, 0.0, 5.0])
    feet = airfoil.closest(beyond)
    np.testing.assert_allclose(feet.v, 1.0)
    assert feet.converged.all()


def test_shapes_of_the_answer_follow_the_parameters(airfoil):
    assert airfoil.point(0.5, 0.5).shape == (3,)
    assert airfoil.normal(np.zeros((4, 1)), np.linspace(0.0, 1.0, 5)).shape == (4, 5, 3)
    assert airfoil.point(np.empty(0), np.empty(0)).shape == (0, 3)


@pytest.mark.parametrize(("u", "v", "name"), [(1.1, 0.5, "u"), (-0.2, 0.5, "u"), (0.5, 1.01, "v"), (np.nan, 0.5, "u")])
def test_parameters_outside_the_domain_are_refused(airfoil, u, v, name):
    with pytest.raises(InputError, match=f"{name} must lie in 0 .. 1"):
        airfoil.point(u, v)


def test_only_a_spline_face_has_a_spline(blade):
    with pytest.raises(InputError, match="S4 is a cylinder, expected a B-spline"):
        blade.spline_surface("S4")
