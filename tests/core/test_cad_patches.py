import dataclasses

import numpy as np
import pytest
import shapely

from core.cad import merge_patches, read_step
from core.errors import InputError
from core.frames import rigid, rotation_from_rotvec
from tests.core import cad_shapes as shapes

PLACE = rigid(rotation_from_rotvec([0.3, -0.5, 0.9]), [40.0, -20.0, 7.0])


def read(shape, tmp_path):
    return read_step(shapes.write(shapes.moved(shape, PLACE), tmp_path / "part.step"))


def of_type(model, kind):
    return [face for face in model.faces if face.type == kind]


def sectors(starts, angles, radius=20.0, height=10.0):
    """Pieces of one full cylinder next to each other."""
    return [shapes.cylinder(radius, height, x_axis=(np.cos(a), np.sin(a), 0.0), angle=b)
            for a, b in zip(starts, angles, strict=True)]


def barrel(model, radius=20.0):
    return [face for face in of_type(model, "cylinder") if abs(face.surface.radius_mm - radius) < 1e-9]


@pytest.mark.parametrize("start", [0.0, 1.0, np.pi, 5.0])
def test_two_halves_of_a_cylinder_become_one_closed_strip_without_edges(tmp_path, start):
    model = read(shapes.compound(*sectors([start, start + np.pi], [np.pi, np.pi])), tmp_path)
    halves = barrel(model)
    assert len(halves) == 2
    patch, = merge_patches(halves)
    assert patch.face_ids == tuple(sorted(face.id for face in halves))
    assert patch.trim.area == pytest.approx(2 * np.pi * 20.0 * 10.0, rel=1e-6)
    np.testing.assert_allclose(patch.trim.bounds, [-np.pi * 20.0, -5.0, np.pi * 20.0, 5.0], atol=1e-5)
    inner = patch.shrunk(1.0)
    assert inner.area == pytest.approx(2 * np.pi * 20.0 * 8.0, rel=1e-6), "no border is lost at the cut"


def test_pieces_on_both_sides_of_the_cut_join_and_the_cut_moves_into_the_gap(tmp_path):
    # Three pieces fill 0.5 .. 5.5 rad; the gap lies around 6.1 rad.
    model = read(shapes.compound(*sectors([0.5, 2.0, 4.0], [1.5, 2.0, 1.5])), tmp_path)
    faces = barrel(model)
    for order in ([0, 1, 2], [2, 0, 1], [0, 2, 1]):
        patch, = merge_patches([faces[i] for i in order])
        np.testing.assert_allclose(patch.trim.bounds, [-50.0, -5.0, 50.0, 5.0], atol=1e-5)
        assert patch.trim.area == pytest.approx(1000.0, rel=1e-6)
        assert patch.trim.geom_type == "Polygon"
        for face in faces:
            s, t = shapely.get_coordinates(face.trim.representative_point()).T
            inside = patch.surface.to_surface(face.surface.from_surface(s, t))
            assert patch.trim.contains(shapely.Point(inside[0][0], inside[1][0]))
            assert inside[2][0] == pytest.approx(0.0, abs=1e-9)


def test_a_single_full_cylinder_keeps_its_points_at_the_seam(tmp_path):
    patch, = merge_patches(barrel(read(shapes.cylinder(20.0, 10.0), tmp_path)))
    assert patch.shrunk(1.0).area == pytest.approx(2 * np.pi * 20.0 * 8.0, rel=1e-6)
    assert patch.shrunk(6.0).is_empty


def test_an_open_patch_shrinks_on_all_sides(tmp_path):
    patch, = merge_patches(barrel(read(sectors([0.0], [2.0])[0], tmp_path)))
    assert patch.shrunk(1.0).area == pytest.approx(38.0 * 8.0, rel=1e-6)


def test_coplanar_neighbours_join_and_the_line_between_them_goes(tmp_path):
    # Two blocks side by side: their tops stay two faces with a common edge.
    model = read(shapes.fuse(shapes.box((10.0, 20.0, 5.0)), shapes.box((15.0, 20.0, 5.0), (10.0, 0.0, 0.0))), tmp_path)
    tops = [face for face in model.faces if face.surface.normal @ PLACE[:3, 2] > 0.99]
    assert len(tops) == 2
    patch, = merge_patches(tops)
    assert patch.trim.area == pytest.approx(500.0, rel=1e-6)
    assert patch.shrunk(1.0).area == pytest.approx(23.0 * 18.0, rel=1e-5)
    assert patch.label == f"face {tops[0].id} + face {tops[1].id}"
    np.testing.assert_allclose(shapely.centroid(patch.trim).coords[0], 0.0, atol=1e-6)


def test_faces_that_do_not_touch_or_face_the_other_way_stay_apart(tmp_path):
    blocks = shapes.compound(shapes.box((10.0, 10.0, 5.0)), shapes.box((10.0, 10.0, 5.0), (10.5, 0.0, 0.0)),
                             shapes.box((10.0, 10.0, 5.0), (0.0, 0.0, 5.0)))
    model = read(blocks, tmp_path)
    assert len(merge_patches(model.faces)) == len(model.faces) - 4, "only the side walls of the stacked blocks join"


def test_a_step_of_some_hundredths_is_another_surface(tmp_path):
    blocks = shapes.compound(shapes.box((10.0, 10.0, 5.0)), shapes.box((10.0, 10.0, 5.03), (10.0, 0.0, 0.0)))
    model = read(blocks, tmp_path)
    tops = [face for face in model.faces if face.surface.normal @ PLACE[:3, 2] > 0.99]
    assert len(merge_patches(tops)) == 2


def test_a_bridge_between_two_patches_joins_all_three(tmp_path):
    blocks = [shapes.box((10.0, 10.0, 5.0), (x, 0.0, 0.0)) for x in (0.0, 20.0, 10.0)]
    model = read(shapes.compound(*blocks), tmp_path)
    tops = [face for face in model.faces if face.surface.normal @ PLACE[:3, 2] > 0.99]
    patch, = merge_patches(tops)
    assert patch.face_ids == tuple(sorted(face.id for face in tops))
    assert patch.trim.area == pytest.approx(300.0, rel=1e-6)


def test_unusable_and_repeated_faces_are_refused(tmp_path):
    from OCP.BRepPrimAPI import BRepPrimAPI_MakeSphere

    model = read(shapes.compound(shapes.box(), BRepPrimAPI_MakeSphere(3.0).Shape()), tmp_path)
    with pytest.raises(InputError, match=r"can't be used for registration.*sphere"):
        merge_patches(of_type(model, "sphere"))
    with pytest.raises(InputError, match="given twice"):
        merge_patches([model.faces[0], dataclasses.replace(model.faces[0])])
