"""Where the 3D view looks from at first, what it takes in, and what it writes at colour bars and headings."""

from collections.abc import Callable, Iterator
from dataclasses import replace
from typing import Any

import numpy as np
import pytest
from PySide6.QtCore import QEvent
from PySide6.QtGui import QFont, QFontMetricsF
from PySide6.QtWidgets import QApplication
from pytestqt.qtbot import QtBot

from beltgui.viewmodel.scene import Arrow, Frame, Item, Mesh, Points, Role, Scene
from beltgui.widgets.scene_view import SceneView
from beltgui.widgets.scene_view_camera import rotation_from
from beltgui.widgets.scene_view_motion import motion_items, motion_scene, robot_items
from beltgui.widgets.scene_view_outline import first_camera, outline_of, wanted_items
from beltgui.widgets.scene_view_overlay import round_ticks, tick_text, wrapped

WAIT_MS = 30_000


@pytest.fixture
def view(qtbot: QtBot) -> Iterator[SceneView]:
    opened = SceneView(own_process=False)
    opened.resize(900, 480)
    opened.show()
    opened.prepare()
    yield opened
    opened.shut_down()
    opened.close()
    opened.deleteLater()
    QApplication.sendPostedEvents(None, QEvent.Type.DeferredDelete)


def cloud(name: str, at: tuple[float, float, float], size_mm: float = 20.0, **more: Any) -> Points:
    corners = np.array([[x, y, z] for x in (-1, 1) for y in (-1, 1) for z in (-1, 1)], dtype=float)
    return Points(name, (np.array(at) + 0.5 * size_mm * corners).astype(np.float32), **{"size_px": 5.0, **more})


NEAR, FAR = cloud("near", (0, 0, 0)), cloud("far", (2000, 0, 0))


def shown(qtbot: QtBot, view: SceneView, change: Callable[[], None]) -> None:
    with qtbot.waitSignal(view.picture_shown, timeout=WAIT_MS):
        change()


def span_px(view: SceneView, points: Points, number: int = 0) -> float:
    """Largest extent of points in a viewport, as a share of its height or width, whichever they fill more."""
    pane, rect = view.canvas.panes[number], view.canvas.rects()[number]
    pixels, depth = pane.camera.project(points.xyz, rect.width(), rect.height())
    assert (depth > 0.0).all()
    return float((np.ptp(pixels, axis=0) / (rect.width(), rect.height())).max())


@pytest.mark.parametrize("look_from", [(1.0, 0.0, 0.0), (0.3, -0.9, 0.4), (-2.0, 5.0, -1.0)])
def test_the_eye_is_where_the_scene_says_and_up_is_up(look_from: tuple[float, float, float]) -> None:
    up = (0.1, 0.2, 1.0)
    camera = first_camera(Scene("A", "M", (NEAR,), "a", look_from=look_from, up=up))
    rotation = camera.rotation
    np.testing.assert_allclose(rotation @ rotation.T, np.eye(3), atol=1e-12)
    assert np.linalg.det(rotation) == pytest.approx(1.0)
    np.testing.assert_allclose(rotation[2], np.array(look_from) / np.linalg.norm(look_from))
    assert rotation[1] @ up > 0.0 and rotation[0] @ up == pytest.approx(0.0, abs=1e-12)


def test_up_along_the_view_is_replaced_and_no_direction_is_refused() -> None:
    rotation = rotation_from((0.0, 0.0, 1.0), (0.0, 0.0, 1.0))
    np.testing.assert_allclose(rotation @ rotation.T, np.eye(3), atol=1e-12)
    with pytest.raises(ValueError, match="no length"):
        rotation_from((0.0, 0.0, 0.0), (0.0, 0.0, 1.0))


def test_the_first_picture_takes_in_what_the_scene_says_and_fit_takes_in_all(qtbot: QtBot, view: SceneView) -> None:
    scene = Scene("A", "M", (NEAR, FAR), "a", look_from=(0.0, -1.0, 0.3), fit_to=("nea",))
    shown(qtbot, view, lambda: view.show_scene(scene))
    assert 0.3 < span_px(view, NEAR) < 1.0
    shown(qtbot, view, lambda: view.look("fit"))
    both = Points("both", np.vstack([NEAR.xyz, FAR.xyz]))
    assert span_px(view, NEAR) < 0.05 and 0.3 < span_px(view, both) < 1.0
    np.testing.assert_allclose(view.canvas.panes[0].camera.rotation, first_camera(scene).rotation)


def test_the_robot_as_it_is_now_never_moves_the_picture() -> None:
    pose = np.eye(4)
    pose[:3, 3] = 3000.0
    scene = Scene("A", "B", (NEAR,), "a")
    assert wanted_items(scene, robot_items(pose)) == (NEAR,)
    assert wanted_items(replace(scene, fit_to=("nothing like it",)), ()) == (NEAR,)


def test_what_is_written_belongs_to_the_picture_that_is_seen(qtbot: QtBot, view: SceneView) -> None:
    """Until the next picture is there, title and names are those of the last one."""
    shown(qtbot, view, lambda: view.show_scene(Scene("First", "M", (NEAR,), "a")))
    before = view.screenshot()
    view.show_scene(Scene("Second", "B", (FAR,), "b"), Scene("Third", "W", (NEAR,), "c"))
    assert view.screenshot() == before
    with qtbot.waitSignal(view.picture_shown, timeout=WAIT_MS):
        pass
    assert view.screenshot() != before


def test_scenes_beside_have_viewports_of_their_own(qtbot: QtBot, view: SceneView) -> None:
    beside = tuple(Scene(f"S{place}", "B", (cloud("x", (500.0 * place, 0, 0)),), f"v{place}") for place in (1, 2))
    shown(qtbot, view, lambda: view.show_scene(Scene("S0", "B", (NEAR,), "v0", beside=beside)))
    assert [pane.scene.title for pane in view.canvas.panes] == ["S0", "S1", "S2"]
    for number, scene in enumerate(beside, start=1):
        cube = scene.items[0]
        assert isinstance(cube, Points) and span_px(view, cube, number) > 0.3


def way(count: int = 12) -> np.ndarray:
    poses = np.tile(np.eye(4), (count, 1, 1))
    poses[:, 0, 3] = np.linspace(800.0, 1000.0, count)
    return poses


def test_a_planned_motion_shows_both_ends_and_which_way() -> None:
    items = {item.name: item for item in motion_items(way())}
    heads = [item for name, item in items.items() if "head" in name]
    assert heads and all(isinstance(head, Mesh) for head in heads)
    for head in heads:
        assert isinstance(head, Mesh)
        foot = head.vertices[1:].mean(axis=0)
        along = head.vertices[0] - foot
        assert along[0] == pytest.approx(np.linalg.norm(along)) and 800.0 < foot[0] < 1000.0
    ends = [item for item in items.values() if isinstance(item, Frame)]
    np.testing.assert_allclose(sorted(frame.scene_from_frame[0, 3] for frame in ends), (800.0, 1000.0))


def test_a_planned_motion_fills_its_viewport_and_tells_where_the_base_is() -> None:
    scene, items = motion_scene(way()), motion_items(way())
    outline = outline_of(wanted_items(scene, items))
    assert np.ptp(outline, axis=0).max() < 600.0
    arrow = next(item for item in scene.items if isinstance(item, Arrow))
    assert arrow.vector[0] < 0.0 and arrow.label == "{B} 900 mm"
    other = way()
    other[:, 1, 3] = 50.0
    assert motion_scene(other).view != scene.view and motion_scene(way()).view == scene.view
    near = way()
    near[:, 0, 3] -= 900.0
    assert not any(isinstance(item, Arrow) for item in motion_scene(near).items)


@pytest.mark.parametrize(
    ("value", "unit", "signed", "expected"),
    [
        (1000.0, "µm", True, "+1000 µm"),
        (-1000.0, "µm", True, "−1000 µm"),
        (0.0, "µm", True, "0 µm"),
        (0.001, "mm", False, "0.001 mm"),
        (-0.25, "mm", True, "−0.25 mm"),
        (99999.0, "", False, "99999"),
        (12.5, "", True, "+12.5"),
        (2.0e7, "", False, "2e+07"),
        (2.0e-5, "", False, "2e-05"),
    ],
)
def test_numbers_at_a_colour_bar(value: float, unit: str, signed: bool, expected: str) -> None:
    assert tick_text(value, unit, signed=signed) == expected


@pytest.mark.parametrize(
    ("low", "high"), [(-1000.0, 1000.0), (-50.0, 50.0), (-875.0, 875.0), (0.0, 7.3), (0.002, 0.009)]
)
def test_ticks_are_round_and_within(low: float, high: float) -> None:
    ticks = round_ticks(low, high)
    assert 2 <= len(ticks) <= 5 and min(ticks) >= low - 1e-9 and max(ticks) <= high + 1e-9
    steps = np.diff(ticks)
    assert np.allclose(steps, steps[0])
    lead = float(f"{steps[0]:.6e}".split("e")[0])
    assert any(lead == pytest.approx(wanted) for wanted in (1.0, 2.0, 2.5, 5.0))
    if low < 0.0 < high:
        assert min(abs(tick) for tick in ticks) < 1e-9
    assert round_ticks(5.0, 5.0) == [5.0]


def test_long_words_of_a_legend_take_more_lines(qtbot: QtBot) -> None:
    metrics = QFontMetricsF(QFont())
    english = "residuals drawn 1000 times as long as they are"
    chinese = "残差放大一千倍显示在标准球的位置上"
    for text in (english, chinese):
        lines = wrapped(text, metrics, 0.5 * metrics.horizontalAdvance(text))
        assert 2 <= len(lines) <= 3
        assert "".join(lines).replace(" ", "") == text.replace(" ", "")
    assert wrapped(english, metrics, 1e6) == [english]


def test_points_stand_in_front_of_the_face_they_lie_on(qtbot: QtBot, view: SceneView) -> None:
    """Points a twentieth of a mm behind a face are still seen, those 10 mm behind it are not."""
    square = np.array([[-40, -40], [40, -40], [40, 40], [-40, 40]], np.float32)
    faces = np.vstack([np.column_stack([square, np.full(4, z)]) for z in (0.0, -150.0)]).astype(np.float32)
    triangles = np.array([[0, 1, 2], [0, 2, 3], [4, 5, 6], [4, 6, 7]], np.int32)
    x, y = (axis.ravel() for axis in np.meshgrid(np.linspace(-30, 30, 20), np.linspace(-30, 30, 20)))
    found = []
    for behind in (None, 0.05, 10.0):
        items: tuple[Item, ...] = (Mesh("faces", faces, triangles),)
        if behind is not None:
            xyz = np.stack([x, y, 0.0 * x - behind], axis=1).astype(np.float32)
            items = (*items, Points("points", xyz, Role.OUTLIER, size_px=6.0))
        shown(qtbot, view, lambda items=items: view.show_scene(Scene("A", "W", items, "a top")))
        found.append(view.screenshot())
    assert found[1] != found[0] and found[2] == found[0]
