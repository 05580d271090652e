import itertools
import re

import numpy as np
import pytest

from core.cad import merge_patches, read_blade_type, read_step
from core.errors import InputError
from core.frames import skew
from resources import blade_type_names, blade_type_path, make_blades, resource_path
from resources.blade_design import DESIGNS

NAMES = ["S1", "S2", "S3", "S4", "S5", "S6", "AIRFOIL", "TE"]
WHEEL_RADIUS_MM = 60.0


@pytest.fixture(scope="module", params=DESIGNS, ids=lambda design: design.name)
def design(request):
    return request.param


@pytest.fixture(scope="module")
def model(design):
    return read_step(resource_path("blades", f"{design.name.lower()}.step"))


def test_the_named_faces_are_what_the_process_expects(model, design):
    assert [model.face(name).name for name in NAMES] == NAMES
    types = {name: model.face(name).type for name in NAMES}
    assert types == {"S1": "cylinder", "S2": "plane", "S3": "plane", "S4": "cylinder", "S5": "plane", "S6": "plane",
                     "AIRFOIL": "bspline", "TE": "bspline"}
    assert sum(face.name is not None for face in model.faces) == len(NAMES)
    tip = design.hub_radius_mm + design.span_mm + design.shroud.thickness_mm
    assert model.face("S4").surface.radius_mm == pytest.approx(tip, abs=1e-9)
    for name in ("S1", "S4"):
        surface = model.face(name).surface
        assert surface.outward == 1 and abs(surface.axis[0]) == pytest.approx(1.0)
        np.testing.assert_allclose(surface.origin[1:], [0.0, -design.hub_radius_mm], atol=1e-9)


def test_all_registration_faces_are_seen_from_one_diagonal(model):
    view = np.array([1.0, 1.0, 0.6]) / np.linalg.norm([1.0, 1.0, 0.6])
    for name in ("S2", "S3", "S4", "S5", "S6"):
        face = model.face(name)
        assert face.surface.normal_at(face.surface.from_surface([0.0], [0.0]))[0] @ view > 0.3


def test_the_faces_with_arcs_have_two_concentric_arcs_and_two_lines(model):
    for name, radii in (("S3", "platform"), ("S5", "shroud")):
        face = model.face(name)
        points = face.surface.from_surface(*np.array(face.trim.exterior.coords).T)
        rho = np.hypot(points[:, 1], points[:, 2] - model.face("S4").surface.origin[2])
        assert len(points) > 10 and np.ptp(rho) > 11.0, radii
        on_arcs = (np.abs(rho - rho.min()) < 1e-6) | (np.abs(rho - rho.max()) < 1e-6)
        assert on_arcs.all()


def test_the_solid_is_valid_and_watertight(model):
    from OCP.BRepCheck import BRepCheck_Analyzer
    from OCP.STEPControl import STEPControl_Reader

    reader = STEPControl_Reader()
    reader.ReadFile(str(model.path))
    reader.TransferRoots()
    assert BRepCheck_Analyzer(reader.OneShape()).IsValid()
    assert model.solid and model.lost_faces == 0
    # The area vectors of a closed surface add up to nothing.
    mesh = model.tessellate(0.05)
    corner = mesh.vertices[mesh.triangles]
    normal = np.cross(corner[:, 1] - corner[:, 0], corner[:, 2] - corner[:, 0]) / 2.0
    assert np.linalg.norm(normal.sum(axis=0)) < 1e-6 * np.linalg.norm(normal, axis=1).sum()


def test_the_blade_has_its_size(model, design):
    length, width, height = np.ptp(model.bounds_mm, axis=0)[[0, 1, 2]]
    assert 70.0 < length < 80.0 and 60.0 < width < 80.0 and 270.0 < height < 310.0
    assert model.bounds_mm[0, 2] == pytest.approx(design.root_outline_mm[-1][1], abs=1e-5)


def test_the_airfoil_is_one_smooth_face_around_the_leading_edge(model, design):
    surface = model.spline_surface("AIRFOIL")
    assert surface.domain == ((0.0, 1.0), (0.0, 1.0))
    assert (surface.degree_u, surface.degree_v) == (3, 3) and surface.weights is None
    for knots in (surface.knots_u, surface.knots_v):
        inner = knots[4:-4]
        assert np.all(np.diff(inner) > 0.0), "single inner knots: second derivatives are continuous"
    (u0, u1), (v0, v1) = surface.face_domain
    assert (u0, u1) == (pytest.approx(0.0), pytest.approx(1.0)) and 0.0 < v0 < 0.01 and 0.99 < v1 < 1.0
    points = surface.point(np.array([0.0, 0.5, 1.0]), 0.5)
    assert points[0, 0] > 15.0 and points[2, 0] > 15.0 and points[1, 0] < -15.0
    # Pressure side first: it looks to -y; v climbs the span.
    assert surface.normal(0.25, 0.5)[1] < -0.7 and surface.normal(0.75, 0.5)[1] > 0.7
    assert surface.point(0.5, 1.0)[2] - surface.point(0.5, 0.0)[2] == pytest.approx(design.span_mm + 2.0)


def test_normals_point_out_of_the_airfoil(model):
    surface = model.spline_surface("AIRFOIL")
    u, v = np.linspace(0.02, 0.98, 41)[:, None], np.linspace(0.05, 0.95, 9)
    point, normal = surface.point(u, v), surface.normal(u, v)
    # Against the outline of the section at the same height, by its signed area and turning.
    for k in range(9):
        outline = surface.point(np.linspace(0.0, 1.0, 400), float(v[k]))[:, :2]
        ahead, behind = (point[:, k, :2] + sign * 0.3 * normal[:, k, :2] for sign in (1.0, -1.0))
        assert not _inside(outline, ahead).any() and _inside(outline, behind).all()


def _inside(outline, points):
    import shapely

    return shapely.contains_xy(shapely.Polygon(outline), points[:, 0], points[:, 1])


def test_a_contact_wheel_fits_into_the_concave_side(model):
    surface = model.spline_surface("AIRFOIL")
    u, v = np.meshgrid(np.linspace(0.0, 1.0, 400), np.linspace(0.0, 1.0, 60), indexing="ij")
    _, du, dv = surface.derivatives(u, v)
    normal = surface.normal(u, v)
    duu, duv, dvv = surface.second_derivatives(u, v)
    e, f, g = (np.sum(a * b, axis=-1) for a, b in ((du, du), (du, dv), (dv, dv)))
    ll, mm, nn = (np.sum(a * normal, axis=-1) for a in (duu, duv, dvv))
    mean = (e * nn - 2 * f * mm + g * ll) / (2 * (e * g - f * f))
    gauss = (ll * nn - mm * mm) / (e * g - f * f)
    concave = mean + np.sqrt(np.maximum(mean**2 - gauss, 0.0))
    assert 1.0 / concave.max() > 2 * WHEEL_RADIUS_MM
    convex = -(mean - np.sqrt(np.maximum(mean**2 - gauss, 0.0)))
    edge_radius = 1.0 / convex.max(axis=0)
    assert 1.8 < edge_radius.min() and edge_radius.max() < 4.0
    turn = np.degrees(design_turn(surface))
    assert 20.0 < turn < 32.0


def design_turn(surface):
    """Turn of the chord line from foot to tip in rad."""
    chord = [surface.point(1.0, v) - surface.point(0.48, v) for v in (0.0, 1.0)]
    angle = [np.arctan2(c[1], c[0]) for c in chord]
    return abs(angle[1] - angle[0])


def test_the_registration_faces_determine_all_six_degrees_of_freedom(model):
    rng = np.random.default_rng(5)
    blade = read_blade_type(blade_type_path(model.path.stem))
    points, normals = [], []
    for patch in merge_patches(model.select(blade.registration_faces)):
        s0, t0, s1, t1 = patch.trim.bounds
        p = patch.surface.from_surface(rng.uniform(s0, s1, 400), rng.uniform(t0, t1, 400))
        points.append(p)
        normals.append(patch.surface.normal_at(p))
    p, n = np.vstack(points), np.vstack(normals)
    p -= p.mean(axis=0)
    scale = np.sqrt((p**2).sum(axis=1).mean())
    jacobian = np.hstack([np.einsum("nij,nj->ni", skew(p), n) / scale, n])
    values = np.linalg.svd(jacobian, compute_uv=False)
    assert values[0] / values[-1] < 6.0
    # With a scanner of 0.035 mm these 2000 points carry the middle of the airfoil to some micrometres.
    covariance = 0.035**2 * np.linalg.inv(jacobian.T @ jacobian)
    assert np.sqrt(np.diag(covariance)[3:]).max() < 0.005


def test_the_two_types_can_be_told_apart():
    first, second = (read_step(resource_path("blades", f"{design.name.lower()}.step")) for design in DESIGNS)
    size = np.abs(np.ptp(first.bounds_mm, axis=0) - np.ptp(second.bounds_mm, axis=0))
    assert size.max() > 15.0 and np.sort(size)[1] > 3.0
    for name in ("S2", "S3", "S4", "S5", "S6"):
        shift = first.face(name).surface.to_surface(second.face(name).surface.from_surface(0.0, 0.0))[2]
        assert abs(shift) > 1.0, name


def test_making_the_blades_again_gives_the_same_geometry(design, model, tmp_path):
    make_blades.write_step(design, tmp_path / "again.step")
    again = read_step(tmp_path / "again.step")
    assert [face.name for face in again.faces] == [face.name for face in model.faces]
    np.testing.assert_allclose([face.area_mm2 for face in again.faces], [face.area_mm2 for face in model.faces],
                               rtol=1e-6)
    np.testing.assert_allclose(again.spline_surface("AIRFOIL").poles_mm, model.spline_surface("AIRFOIL").poles_mm,
                               atol=1e-6)


def test_the_files_carry_no_clock_and_no_machine(model, tmp_path):
    text = model.path.read_text(encoding="ascii")
    header = text[:text.index("ENDSEC;")]
    assert re.findall(r"\d{4}-\d\d-\d\dT[\d:]*", header) == ["2026-01-01T00:00:00"]
    assert "/" not in header and "\\" not in text


def test_every_type_that_comes_with_the_program_can_be_read():
    assert blade_type_names() == ("DR95", "DR96")
    for name in blade_type_names():
        blade = read_blade_type(blade_type_path(name))
        model = read_step(blade.step_path)
        assert blade.name == name and blade.accepts_serial(f"{name}-0042")
        assert not blade.accepts_serial("DR94-0042") and not blade.accepts_serial(f"{name}-00421")
        assert all(face.usable for face in model.select(blade.registration_faces))
        (u0, u1), (v0, v1) = model.spline_surface(blade.airfoil).face_domain
        u, v = blade.probing.u(), blade.probing.v()
        assert len(u) == 129 and len(v) == 40 and u0 < u[0] and u[-1] < u1 and v0 < v[0] and v[-1] < v1
        # The root's end hangs 60 mm in front of the flange, the span along its z axis.
        end = blade.flange_from_work @ [0.0, 0.0, model.bounds_mm[0, 2], 1.0]
        np.testing.assert_allclose(end[:3], [0.0, 0.0, 60.0], atol=1e-4)


def test_unknown_resources_are_named():
    with pytest.raises(FileNotFoundError, match=r"no blade type 'DR1'.*DR95, DR96"):
        blade_type_path("DR1")
    with pytest.raises(FileNotFoundError, match=r"blades/none\.step"):
        resource_path("blades", "none.step")


GOOD = blade_type_path("DR95").read_text(encoding="utf-8")
BROKEN = [
    ('type = "DR95"', "", r"\[blade\] type is missing"),
    ('type = "DR95"', "type = 95", r"\[blade\] type: expected a text, found 95"),
    ('step = "dr95.step"', 'step = "none.step"', r"\[blade\] step: there is no file 'none.step'"),
    ("DR95-[0-9]{4}", "DR95-[0-9", r"serial_pattern: .* no regular expression"),
    ('["S2", "S3", "S4", "S5", "S6"]', "[]", r"\[faces\] registration: expected a list"),
    ('["S2", "S3", "S4", "S5", "S6"]', "[true]", r"\[faces\] registration: expected a face name"),
    ("rms_mm = 0.08", "rms_mm = -1", r"\[limits\] rms_mm: expected a number of at least"),
    ("rms_mm = 0.08", "rms_mm = nan", r"\[limits\] rms_mm: expected a number of at least"),
    ("rms_mm = 0.08", "rms_mm = 0.08\nrsm = 1", r"\[limits\] rsm: unknown field"),
    ("u_count = 129", "u_count = 3", r"u_count: expected a whole number of at least 4"),
    ("u_count = 129", "u_count = 12.5", r"u_count: expected a whole number"),
    ("v_max = 0.94663445", "v_max = 0.01", r"v_max: must be greater than v_min"),
    ("v_max = 0.94663445", "v_max = 1.5", r"v_max: expected a number in 0 .. 1"),
    ("[0.0, 0.0, 128.0]", "[0.0, 128.0]", r"translation_mm: expected three numbers"),
    ("[rough_start]", "[start]", r"unknown table \[start\]"),
    ("[probing]", "[probing", "not a valid TOML file"),
]


@pytest.mark.parametrize(("old", "new", "message"), BROKEN, ids=[str(i) for i in range(len(BROKEN))])
def test_a_wrong_field_of_a_type_file_is_named(tmp_path, old, new, message):
    assert old in GOOD
    (tmp_path / "dr95.step").write_bytes(b"")
    path = tmp_path / "type.toml"
    path.write_text(GOOD.replace(old, new, 1), encoding="utf-8")
    with pytest.raises(InputError, match=message) as error:
        read_blade_type(path)
    assert "type.toml" in str(error.value)


def test_a_missing_or_binary_type_file_is_refused(tmp_path):
    with pytest.raises(InputError, match="can't be opened"):
        read_blade_type(tmp_path / "none.toml")
    (tmp_path / "binary.toml").write_bytes(bytes(itertools.chain(range(128, 256))))
    with pytest.raises(InputError, match="not a valid TOML file"):
        read_blade_type(tmp_path / "binary.toml")
