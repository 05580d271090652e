import pickle

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from core.cad import Cylinder, Plane, read_step
from core.errors import InputError
from core.frames import rigid, rotation_from_rotvec, transform_points
from tests.core import cad_shapes as shapes

PLACE = rigid(rotation_from_rotvec([0.3, -0.5, 0.9]), [40.0, -20.0, 7.0])


def test_a_box_has_six_planes_with_outward_normals(tmp_path):
    model = read_step(shapes.write(shapes.moved(shapes.box(), PLACE), tmp_path / "box.step"))
    centre = transform_points(PLACE, [5.0, 10.0, 15.0])
    assert [face.id for face in model.faces] == [1, 2, 3, 4, 5, 6]
    assert model.solid and model.lost_faces == 0
    assert sorted(round(face.area_mm2, 6) for face in model.faces) == [200, 200, 300, 300, 600, 600]
    for face in model.faces:
        assert face.type == "plane" and face.usable and face.why_not is None
        assert isinstance(face.surface, Plane)
        assert face.trim.area == pytest.approx(face.area_mm2, rel=1e-9)
        np.testing.assert_allclose(np.cross(face.surface.x_axis, face.surface.y_axis), face.surface.normal, atol=1e-12)
        s, t, d = face.surface.to_surface(centre)
        assert d in (pytest.approx(-5), pytest.approx(-10), pytest.approx(-15))
        np.testing.assert_allclose([s, t], 0.0, atol=1e-9)
        np.testing.assert_allclose(face.trim.centroid.coords[0], 0.0, atol=1e-9)
    corners = transform_points(PLACE, np.array(np.meshgrid([0, 10], [0, 20], [0, 30])).reshape(3, -1).T)
    np.testing.assert_allclose(model.bounds_mm, [corners.min(axis=0), corners.max(axis=0)], atol=1e-5)


@pytest.mark.parametrize(("unit", "factor"), [("MM", 1.0), ("INCH", 1.0), ("M", 1.0)])
def test_files_in_other_units_come_out_in_mm(tmp_path, unit, factor):
    path = shapes.write(shapes.cut(shapes.box((60.0, 60.0, 20.0)), shapes.cylinder(12.5, 20.0, at=(30.0, 30.0, 0.0))),
                        tmp_path / "part.step", unit=unit)
    text = path.read_text()
    assert {"MM": ".MILLI.", "INCH": "'INCH'", "M": "SI_UNIT($,.METRE.)"}[unit] in text
    model = read_step(path)
    hole = next(face for face in model.faces if face.type == "cylinder")
    assert hole.surface.radius_mm == pytest.approx(12.5 * factor, rel=1e-9)
    np.testing.assert_allclose(np.ptp(model.bounds_mm, axis=0), [60.0, 60.0, 20.0], atol=1e-5)
    assert hole.area_mm2 == pytest.approx(2 * np.pi * 12.5 * 20.0, rel=1e-6)


def test_a_shaft_and_a_hole_have_opposite_sides(tmp_path):
    shaft = read_step(shapes.write(shapes.moved(shapes.cylinder(8.0, 30.0), PLACE), tmp_path / "shaft.step"))
    side = next(face for face in shaft.faces if face.type == "cylinder")
    outside = transform_points(PLACE, [[9.0, 0.0, 10.0], [0.0, -7.0, 3.0]])
    np.testing.assert_allclose(side.surface.to_surface(outside)[2], [1.0, -1.0], atol=1e-9)
    assert side.surface.outward == 1 and side.parameters["side"] == "convex"

    hole = read_step(shapes.write(shapes.cut(shapes.box((40.0, 40.0, 10.0)),
                                             shapes.cylinder(8.0, 10.0, at=(20.0, 20.0, 0.0))), tmp_path / "h.step"))
    wall = next(face for face in hole.faces if face.type == "cylinder")
    np.testing.assert_allclose(wall.surface.to_surface([[27.0, 20.0, 5.0], [29.0, 20.0, 5.0]])[2], [1.0, -1.0],
                               atol=1e-9)
    np.testing.assert_allclose(wall.surface.normal_at([[27.0, 20.0, 5.0]]), [[-1.0, 0.0, 0.0]], atol=1e-12)
    tops = [face for face in hole.faces if face.type == "plane" and len(face.trim.interiors) == 1]
    assert len(tops) == 2
    for top in tops:
        assert top.trim.area == pytest.approx(1600.0 - np.pi * 64.0, abs=0.002 * 2 * np.pi * 8.0)


def test_a_full_cylinder_is_one_strip_around_the_axis(tmp_path):
    model = read_step(shapes.write(shapes.cylinder(8.0, 30.0), tmp_path / "shaft.step"))
    side = next(face for face in model.faces if face.type == "cylinder")
    np.testing.assert_allclose(side.trim.bounds, [-np.pi * 8.0, -15.0, np.pi * 8.0, 15.0], atol=1e-6)
    assert side.trim.area == pytest.approx(2 * np.pi * 8.0 * 30.0, rel=1e-9)


@pytest.mark.parametrize("turn", np.linspace(0.0, 2 * np.pi, 9))
def test_a_part_of_a_cylinder_never_straddles_the_cut(tmp_path, turn):
    part = shapes.cylinder(50.0, 10.0, x_axis=(np.cos(turn), np.sin(turn), 0.0), angle=1.9)
    model = read_step(shapes.write(part, tmp_path / "part.step"))
    side = next(face for face in model.faces if face.type == "cylinder")
    np.testing.assert_allclose(side.trim.bounds, [-47.5, -5.0, 47.5, 5.0], atol=1e-6)
    middle = np.array([np.cos(turn + 0.95), np.sin(turn + 0.95), 0.1]) * 50.0
    np.testing.assert_allclose(side.surface.to_surface(middle), [0.0, 0.0, 0.0], atol=1e-9)


@pytest.mark.parametrize("direction", [(1.0, 0.0, 0.0), (0.0, 1.0, 0.0), (-1.0, 0.0, 0.0)])
def test_a_bore_across_a_shaft_is_a_hole_in_the_strip_wherever_the_seam_is(tmp_path, direction):
    cross = shapes.cylinder(3.0, 40.0, at=(0.0, 0.0, 15.0), axis=direction)
    model = read_step(shapes.write(shapes.cut(shapes.cylinder(10.0, 30.0), cross), tmp_path / "bored.step"))
    side = next(face for face in model.faces if face.type == "cylinder" and face.surface.radius_mm == 10.0)
    assert side.usable, side.why_not
    phi = np.linspace(-np.arcsin(0.3), np.arcsin(0.3), 20001)
    opening = np.trapezoid(2.0 * np.sqrt(9.0 - (10.0 * np.sin(phi)) ** 2), 10.0 * phi)
    assert side.trim.area == pytest.approx(2 * np.pi * 10.0 * 30.0 - opening, abs=0.05)


def test_other_kinds_are_listed_with_the_reason_why_not(tmp_path):
    from OCP.BRepPrimAPI import BRepPrimAPI_MakeCone, BRepPrimAPI_MakeSphere, BRepPrimAPI_MakeTorus

    parts = shapes.compound(BRepPrimAPI_MakeCone(10.0, 5.0, 10.0).Shape(), BRepPrimAPI_MakeSphere(7.0).Shape(),
                            BRepPrimAPI_MakeTorus(20.0, 4.0).Shape())
    model = read_step(shapes.write(parts, tmp_path / "parts.step"))
    kinds = {face.type: face for face in model.faces}
    assert {"cone", "sphere", "torus"} <= set(kinds)
    assert kinds["cone"].parameters["half_angle_rad"] == pytest.approx(np.arctan(0.5))
    assert kinds["sphere"].parameters["radius_mm"] == pytest.approx(7.0)
    assert kinds["torus"].parameters["major_radius_mm"] == pytest.approx(20.0)
    for kind in ("cone", "sphere", "torus"):
        assert not kinds[kind].usable and kind in kinds[kind].why_not and kinds[kind].surface is None


def test_planes_and_cylinders_stored_as_splines_are_recognised(tmp_path):
    from OCP.BRepBuilderAPI import BRepBuilderAPI_NurbsConvert

    part = shapes.cut(shapes.box((60.0, 60.0, 20.0)), shapes.cylinder(12.5, 20.0, at=(30.0, 30.0, 0.0)))
    exact = read_step(shapes.write(shapes.moved(part, PLACE), tmp_path / "exact.step"))
    splines = BRepBuilderAPI_NurbsConvert(part, True).Shape()
    path = shapes.write(shapes.moved(splines, PLACE), tmp_path / "splines.step")
    assert " CYLINDRICAL_SURFACE(" not in path.read_text() and " PLANE(" not in path.read_text()
    model = read_step(path)
    for face, twin in zip(model.faces, exact.faces, strict=True):
        assert face.parameters["stored_as"] == "bspline" and face.type == twin.type and face.usable, face.why_not
        probe = PLACE[:3, 3] + np.array([[3.0, 4.0, 5.0], [20.0, -7.0, 9.0]])
        np.testing.assert_allclose(face.surface.to_surface(probe)[2], twin.surface.to_surface(probe)[2], atol=1e-6)
        assert face.trim.area == pytest.approx(twin.trim.area, rel=1e-4)
        if face.type == "cylinder":
            assert face.surface.radius_mm == pytest.approx(12.5, abs=1e-7) and face.surface.outward == -1


def test_an_inside_out_solid_still_points_outward(tmp_path):
    model = read_step(shapes.write(shapes.box().Reversed(), tmp_path / "reversed.step"))
    for face in model.faces:
        assert face.surface.to_surface([5.0, 10.0, 15.0])[2] < 0.0
    mesh = model.tessellate(0.1)
    assert _volume(mesh) == pytest.approx(6000.0)


def test_names_and_ids_find_faces(tmp_path):
    path = shapes.write(shapes.box(), tmp_path / "named.step", names={0: "S2", 3: "twice", 4: "twice", 5: "7"})
    model = read_step(path)
    assert model.face("S2").id == 1 and model.face(1).label == "S2" and model.face("2").label == "face 2"
    assert model.face("7").id == 6, "a name wins over an id in digits"
    with pytest.raises(InputError, match=r"no face 'S9'.*1 to 6.*S2"):
        model.face("S9")
    with pytest.raises(InputError, match="2 faces are named 'twice'"):
        model.face("twice")
    with pytest.raises(InputError, match="S2 is named twice"):
        model.select(["S2", 1])


def test_a_name_in_another_character_set_does_not_stop_the_reader(tmp_path):
    path = shapes.write(shapes.box(), tmp_path / "named.step", names={0: "S2"})
    path.write_bytes(path.read_bytes().replace(b"'S2'", b"'Fl\xe4che'"))
    model = read_step(path)
    assert model.faces[0].name.startswith("Fl") and len(model.faces) == 6


def test_placed_copies_in_an_assembly_are_faces_of_their_own(tmp_path):
    single = shapes.box((10.0, 10.0, 10.0))
    far = rigid(np.eye(3), [100.0, 0.0, 0.0])
    model = read_step(shapes.write(shapes.compound(single, shapes.moved(single, far)), tmp_path / "two.step"))
    assert len(model.faces) == 12 and model.lost_faces == 0
    np.testing.assert_allclose(np.ptp(model.bounds_mm, axis=0), [110.0, 10.0, 10.0], atol=1e-5)


def test_a_loose_face_is_read_but_its_side_is_not_certain(tmp_path):
    model = read_step(shapes.write(shapes.faces(shapes.box())[0], tmp_path / "face.step"))
    assert len(model.faces) == 1 and not model.solid and model.faces[0].usable


def _volume(mesh):
    corner = mesh.vertices[mesh.triangles]
    return np.einsum("ij,ij->", corner[:, 0], np.cross(corner[:, 1], corner[:, 2])) / 6.0


def test_triangles_follow_the_surface_and_face_outward(tmp_path):
    part = shapes.moved(shapes.cut(shapes.box((60.0, 60.0, 20.0)), shapes.cylinder(12.0, 20.0, at=(30.0, 30.0, 0.0))),
                        PLACE)
    model = read_step(shapes.write(part, tmp_path / "part.step"))
    volume = 60.0 * 60.0 * 20.0 - np.pi * 144.0 * 20.0
    coarse, fine = model.tessellate(0.5, 0.5), model.tessellate(0.005, 0.1)
    assert len(coarse.triangles) < len(fine.triangles)
    assert _volume(fine) == pytest.approx(volume, abs=2 * np.pi * 12.0 * 20.0 * 0.005)
    assert set(fine.face_ids) == {face.id for face in model.faces}
    for face in model.faces:
        nodes = fine.vertices[fine.triangles[fine.face_ids == face.id]]
        np.testing.assert_allclose(face.surface.to_surface(nodes.reshape(-1, 3))[2], 0.0, atol=1e-6)
        normal = np.cross(nodes[:, 1] - nodes[:, 0], nodes[:, 2] - nodes[:, 0])
        assert np.all(np.sum(normal * face.surface.normal_at(nodes.mean(axis=1)), axis=1) > 0.0)


def test_a_model_survives_pickling_and_notices_a_changed_file(tmp_path):
    path = shapes.write(shapes.box(), tmp_path / "box.step")
    copy = pickle.loads(pickle.dumps(read_step(path)))
    assert copy.face(3).area_mm2 > 0.0 and len(copy.tessellate(0.1).triangles) == 12
    shapes.write(shapes.box((1.0, 2.0, 3.0)), path)
    with pytest.raises(InputError, match="changed after it was read"):
        copy.tessellate(0.1)
    path.unlink()
    with pytest.raises(InputError, match="can't be opened again"):
        copy.tessellate(0.1)


@pytest.mark.parametrize(("deflection", "angle"), [(0.0, 0.1), (-1.0, 0.1), (0.1, 0.0), (np.nan, 0.1)])
def test_tolerances_of_triangles_must_be_positive(tmp_path, deflection, angle):
    model = read_step(shapes.write(shapes.box(), tmp_path / "box.step"))
    with pytest.raises(InputError, match="greater than zero"):
        model.tessellate(deflection, angle)


@pytest.mark.parametrize(("content", "found"), [
    (b"", "empty"), (b" \n\t", "empty"), (b"x,y,z\n1,2,3\n", "begins with 'x,y,z"),
    (b"\x89PNG\r\n\x1a\n\x00\x00", "begins with the bytes 89 50"), (b"solid blade\nfacet", "not a STEP file"),
    (b"ISO-10303-21;\nHEADER;\n", "cut off"),
    (b"ISO-10303-21;\nHEADER;\nENDSEC;\nDATA;\nENDSEC;\nEND-ISO-10303-21;\n", "no shape|can't be parsed"),
    (b"ISO-10303-21;\n" + b"#1=\x00\xff)))(((" * 50 + b"END-ISO-10303-21;\n", "can't be parsed|no shape"),
])
def test_what_is_no_step_file_is_refused_with_a_sentence(tmp_path, content, found, capfd):
    path = tmp_path / "blade.step"
    path.write_bytes(content)
    with pytest.raises(InputError, match=found) as error:
        read_step(path)
    assert "blade.step" in str(error.value) and "\n" not in str(error.value)
    assert capfd.readouterr().out == ""


def test_missing_files_and_folders_are_refused(tmp_path):
    with pytest.raises(InputError, match=r"none\.step: the STEP file can't be opened"):
        read_step(tmp_path / "none.step")
    with pytest.raises(InputError, match="can't be opened"):
        read_step(tmp_path)


def test_a_file_cut_off_anywhere_is_refused(tmp_path):
    whole = shapes.write(shapes.box(), tmp_path / "whole.step").read_bytes()
    path = tmp_path / "part.step"
    for share in (0.2, 0.6, 0.95):
        path.write_bytes(whole[:int(share * len(whole))])
        with pytest.raises(InputError, match="cut off"):
            read_step(path)
    path.write_bytes(whole[:len(whole) // 2] + b"\nENDSEC;\nEND-ISO-10303-21;\n")
    with pytest.raises(InputError, match="entities are referred to but missing"):
        read_step(path)


@pytest.mark.parametrize(("old", "new", "message"), [
    ("= ORIENTED_EDGE(", "= ORIENTXD_EDGE(", "EdgeLoop entity has fields of the wrong kind"),
    ("= LINE(", "=0LINE(", r"damaged at '#\d+ =0LINE"),
    ("= LINE(", "= LI\xffNE(", r"damaged at '#\d+ = LI"),
    ("= DIRECTION(", "=)[ DIRECTION(", r"damaged at '#\d+ =\)\["),
    ("= CARTESIAN_POINT('',(", "= CARTESIAN_POINT('',((", "damaged at"),
    ("= PLANE(", "= SPHERICAL_SURFACE(", "SphericalSurface entity has fields of the wrong kind"),
])
def test_damage_that_would_crash_the_kernel_is_named(tmp_path, old, new, message):
    path = shapes.write(shapes.box(), tmp_path / "box.step")
    text = path.read_text(encoding="latin-1")
    assert old in text
    path.write_text(text.replace(old, new, 1), encoding="latin-1")
    with pytest.raises(InputError, match=message):
        read_step(path)


def test_a_file_of_wires_only_is_refused(tmp_path):
    from OCP.BRepBuilderAPI import BRepBuilderAPI_MakeEdge
    from OCP.gp import gp_Pnt

    edge = BRepBuilderAPI_MakeEdge(gp_Pnt(0.0, 0.0, 0.0), gp_Pnt(10.0, 0.0, 0.0)).Edge()
    with pytest.raises(InputError, match="no solid and no face"):
        read_step(shapes.write(edge, tmp_path / "wire.step"))


def test_reading_prints_nothing(tmp_path, capfd):
    path = shapes.write(shapes.box(), tmp_path / "box.step")
    capfd.readouterr()
    read_step(path)
    captured = capfd.readouterr()
    assert captured.out == "" and captured.err == ""


finite = st.floats(-80.0, 80.0)
vectors = st.tuples(finite, finite, finite).map(np.array)


@settings(derandomize=True, deadline=None, max_examples=60)
@given(rotvec=vectors, origin=vectors, point=vectors, radius=st.floats(0.5, 900.0), side=st.sampled_from([-1, 1]))
def test_surface_coordinates_round_trip_and_the_normal_is_the_gradient(rotvec, origin, point, radius, side):
    x_axis, y_axis, normal = rotation_from_rotvec(rotvec / 30.0).T
    for surface in (Plane(origin, normal, x_axis, y_axis), Cylinder(origin, normal, x_axis, radius, side)):
        s, t, d = surface.to_surface(point)
        np.testing.assert_allclose(surface.from_surface(s, t, d), point, atol=1e-9)
        if isinstance(surface, Cylinder) and radius + side * d < 0.1:
            continue
        step = 1e-5 * surface.normal_at(point)
        ahead, behind = surface.to_surface(point + step)[2], surface.to_surface(point - step)[2]
        assert (ahead - behind) / 2e-5 == pytest.approx(1.0, abs=1e-5)
