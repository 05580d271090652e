"""The 3D view: every kind of item is seen, replaced by name, picked where it is seen; nothing is left behind."""

import gc
import multiprocessing
import os
import threading
import weakref
from collections.abc import Callable, Iterator
from dataclasses import replace
from typing import Any

import numpy as np
import pytest
from PySide6.QtCore import QEvent, QPoint, QPointF, Qt
from PySide6.QtGui import QColor, QImage, QMouseEvent, QWheelEvent
from PySide6.QtWidgets import QApplication, QToolButton
from pytestqt.qtbot import QtBot

from beltgui.app.theme import colour, theme
from beltgui.viewmodel.scene import Arrow, Frame, Item, Label, Lines, Mesh, Points, Role, Scale, Scene
from beltgui.widgets.scene_view import SceneView
from beltgui.widgets.scene_view_overlay import Pin

WAIT_MS = 30_000
WIDTH, HEIGHT = 640, 480
MISSING_COLOUR = 12


@pytest.fixture
def open_view(qtbot: QtBot) -> Iterator[Callable[..., SceneView]]:
    opened: list[SceneView] = []

    def open_one(size: tuple[int, int] = (WIDTH, HEIGHT), **options: Any) -> SceneView:
        view = SceneView(**{"own_process": False, **options})
        opened.append(view)
        view.resize(*size)
        view.show()
        view.prepare()
        return view

    yield open_one
    for view in opened:
        view.shut_down()
        view.close()
        view.deleteLater()
    QApplication.sendPostedEvents(None, QEvent.Type.DeferredDelete)


def shown(qtbot: QtBot, view: SceneView, scene: Scene, second: Scene | None = None) -> np.ndarray:
    """The picture once the scenes are in it."""
    with qtbot.waitSignal(view.picture_shown, timeout=WAIT_MS):
        view.show_scene(scene, second)
    return pixels(view)


def pixels(view: SceneView) -> np.ndarray:
    image = view.screenshot().convertToFormat(QImage.Format.Format_RGB888)
    rows = np.frombuffer(image.constBits(), np.uint8).reshape(image.height(), image.bytesPerLine())
    return rows[:, : 3 * image.width()].reshape(image.height(), image.width(), 3).astype(int)


def share_of(picture: np.ndarray, key: str, within: int = MISSING_COLOUR) -> float:
    """Which part of the picture has a colour of the theme."""
    wanted = QColor(colour(key))
    return float((np.abs(picture - [wanted.red(), wanted.green(), wanted.blue()]).max(axis=2) <= within).mean())


def scene(*items: Item, frame: str = "M", view: str = "top", **more: Any) -> Scene:
    return Scene("A title", frame, items, view, **more)


def plate(name: str = "plate", **more: Any) -> Mesh:
    """Two squares of 40 mm side by side in x, faces 7 and 9, at z = 0."""
    vertices = np.array([[x, y, 0] for x in (-40, 0, 40) for y in (-20, 20)], dtype=np.float32)
    triangles = np.array([[0, 2, 1], [1, 2, 3], [2, 4, 3], [3, 4, 5]], dtype=np.int32)
    return Mesh(name, vertices, triangles, face_id=np.array([7, 7, 9, 9], dtype=np.int32), pickable=True, **more)


def grid(z: float = 0.0, **more: Any) -> Points:
    x, y = np.meshgrid(np.arange(-30.0, 31.0, 10.0), np.arange(-20.0, 21.0, 10.0))
    xyz = np.stack([x.ravel(), y.ravel(), np.full(x.size, z)], axis=1).astype(np.float32)
    return Points("scan", xyz, **{"size_px": 5.0, "pickable": True, **more})


def where(view: SceneView, xyz: Any, number: int = 0) -> QPoint:
    """The pixel of a point, by the camera that the picture was drawn with."""
    rect = view.canvas.rects()[number]
    at, _ = view.canvas.panes[number].camera.project(np.asarray(xyz, dtype=float), rect.width(), rect.height())
    return (QPointF(*at[0]) + rect.topLeft()).toPoint()


BOX = Lines("box", (np.array([[-50, -50, 0], [50, -50, 0], [50, 50, 0], [-50, 50, 0]], dtype=np.float32),), Role.BOX)
TILTED = np.array([[0, -1, 0, 5.0], [1, 0, 0, 5], [0, 0, 1, 0], [0, 0, 0, 1]])


@pytest.mark.parametrize(
    ("item", "role"),
    [
        (grid(role=Role.OUTLIER), Role.OUTLIER),
        (plate(role=Role.WHEEL, wireframe=True), Role.WHEEL),
        (Lines("way", (np.array([[0, 0, 0], [30, 30, 0]], np.float32),), Role.PATH_COMPENSATED, 4.0),
         Role.PATH_COMPENSATED),
        (Label("label", np.zeros(3), "尖 a place", Role.SUGGESTION), Role.SUGGESTION),
        (Arrow("arrow", np.zeros(3), np.array([30.0, 0, 0]), Role.HELD_OUT, "normal"), Role.HELD_OUT),
    ],
    ids=["points", "mesh", "lines", "label", "arrow"],
)  # fmt: skip
def test_each_kind_of_item_is_seen_in_its_role_s_colour(
    qtbot: QtBot, open_view: Callable[..., SceneView], item: Item, role: Role
) -> None:
    view = open_view()
    without = share_of(shown(qtbot, view, scene(BOX)), role, within=60)
    assert share_of(shown(qtbot, view, scene(BOX, item)), role, within=60) > without + 1e-4


def test_a_frame_has_three_axes_and_their_names(qtbot: QtBot, open_view: Callable[..., SceneView]) -> None:
    view = open_view()
    without = shown(qtbot, view, scene(BOX, view="oblique"))
    with_frame = shown(qtbot, view, scene(BOX, Frame("{M}", TILTED, 40.0), view="oblique"))
    for role in (Role.X, Role.Y, Role.Z):
        assert share_of(with_frame, role, 60) > share_of(without, role, 60) + 2e-4


def test_the_surface_is_where_the_camera_says(qtbot: QtBot, open_view: Callable[..., SceneView]) -> None:
    """Drawing (by VTK) and projection (by our own formulas) must agree to a pixel, or a click picks beside."""
    view = open_view()
    for direction in ("top", "oblique"):
        picture = shown(qtbot, view, scene(plate(), view=direction))
        for corner in ((-40, -20, 0), (40, -20, 0), (40, 20, 0), (-40, 20, 0)):
            inside, outside = (where(view, np.array(corner) * factor) for factor in (0.975, 1.025))
            assert np.abs(picture[outside.y(), outside.x()] - _rgb("scene")).max() < 4
            assert np.abs(picture[inside.y(), inside.x()] - _rgb("scene")).max() > 20


def _rgb(key: str) -> np.ndarray:
    shade = QColor(colour(key))
    return np.array([shade.red(), shade.green(), shade.blue()])


def test_values_are_coloured_by_the_scale_with_a_bar(qtbot: QtBot, open_view: Callable[..., SceneView]) -> None:
    view = open_view()
    values = np.array([-40, -40, 0, 0, 40, np.nan], dtype=np.float32)
    scale = Scale("signed distance, µm", -40.0, 40.0)
    picture = shown(qtbot, view, scene(plate(values=values, scale=scale)))
    left, right = (where(view, (x, -15, 0)) for x in (-37, 37))
    blue, red = picture[left.y(), left.x()], picture[right.y(), right.x()]
    assert blue[2] > blue[0] + 60 and red[0] > red[2] + 40
    bar = picture[:, -90:]
    assert (bar[..., 2] - bar[..., 0] > 80).sum() > 100 and (bar[..., 0] - bar[..., 2] > 80).sum() > 100


def test_chosen_faces_are_marked(qtbot: QtBot, open_view: Callable[..., SceneView]) -> None:
    view = open_view()
    plain = shown(qtbot, view, scene(plate()))
    marked = shown(qtbot, view, scene(plate(chosen_faces=(9,))))
    at_7, at_9 = where(view, (-20, 0, 0)), where(view, (20, 0, 0))
    assert np.abs(marked[at_7.y(), at_7.x()] - plain[at_7.y(), at_7.x()]).max() < 4
    assert np.abs(marked[at_9.y(), at_9.x()] - plain[at_9.y(), at_9.x()]).max() > 40


def test_the_same_name_replaces_and_a_missing_one_goes(qtbot: QtBot, open_view: Callable[..., SceneView]) -> None:
    view = open_view()
    first = shown(qtbot, view, scene(BOX, grid(role=Role.OUTLIER)))
    other = shown(qtbot, view, scene(BOX, grid(role=Role.HELD_OUT)))
    assert share_of(first, Role.OUTLIER) > 1e-3 > share_of(other, Role.OUTLIER)
    assert share_of(other, Role.HELD_OUT) > 1e-3
    gone = shown(qtbot, view, scene(BOX))
    assert share_of(gone, Role.HELD_OUT) == 0.0
    again = shown(qtbot, view, scene(BOX, replace(grid(role=Role.OUTLIER), xyz=np.zeros((1, 3), np.float32))))
    assert 0.0 < share_of(again, Role.OUTLIER) < 0.2 * share_of(first, Role.OUTLIER)
    shown(qtbot, view, scene(BOX, Points("scan", np.zeros((0, 3), np.float32)), plate("empty", wireframe=True)))


def test_the_camera_stays_until_the_scene_s_view_changes(qtbot: QtBot, open_view: Callable[..., SceneView]) -> None:
    view = open_view()
    shown(qtbot, view, scene(plate()))
    before = view.canvas.panes[0].camera
    with qtbot.waitSignal(view.picture_shown, timeout=WAIT_MS):
        drag(qtbot, view, QPoint(300, 200), QPoint(360, 230))
    turned = view.canvas.panes[0].camera
    assert np.abs(turned.rotation - before.rotation).max() > 0.1
    shown(qtbot, view, scene(plate(), grid(z=30.0)))
    assert view.canvas.panes[0].camera is turned
    shown(qtbot, view, scene(plate(), view="another top"))
    assert np.allclose(view.canvas.panes[0].camera.rotation, before.rotation)


LEFT, RIGHT = Qt.MouseButton.LeftButton, Qt.MouseButton.RightButton


def drag(qtbot: QtBot, view: SceneView, begin: QPoint, end: QPoint, button: Qt.MouseButton = LEFT) -> None:
    qtbot.mousePress(view.canvas, button, pos=begin)
    for share in (0.3, 0.7, 1.0):
        at = QPointF(begin) + share * QPointF(end - begin)
        event = mouse_at(view, at, button)
        QApplication.sendEvent(view.canvas, event)
    qtbot.mouseRelease(view.canvas, button, pos=end)


def mouse_at(view: SceneView, at: QPointF, button: Qt.MouseButton) -> Any:
    return QMouseEvent(
        QEvent.Type.MouseMove, at, view.canvas.mapToGlobal(at), Qt.MouseButton.NoButton, button,
        Qt.KeyboardModifier.NoModifier,
    )  # fmt: skip


def test_moving_zooming_and_the_keyboard(qtbot: QtBot, open_view: Callable[..., SceneView]) -> None:
    view = open_view()
    shown(qtbot, view, scene(plate()))
    before = where(view, (0, 0, 0))
    drag(qtbot, view, QPoint(100, 100), QPoint(140, 80), RIGHT)
    step = where(view, (0, 0, 0)) - before
    assert abs(step.x() - 40) <= 1 and abs(step.y() + 20) <= 1
    fixed = where(view, (20, 10, 0))
    wheel = QWheelEvent(
        QPointF(fixed), view.canvas.mapToGlobal(QPointF(fixed)), QPoint(), QPoint(0, 240), Qt.MouseButton.NoButton,
        Qt.KeyboardModifier.NoModifier, Qt.ScrollPhase.NoScrollPhase, False,
    )  # fmt: skip
    far = view.canvas.panes[0].camera.distance
    QApplication.sendEvent(view.canvas, wheel)
    assert view.canvas.panes[0].camera.distance < 0.75 * far
    assert (where(view, (20, 10, 0)) - fixed).manhattanLength() <= 2
    qtbot.keyClick(view.canvas, Qt.Key.Key_1)
    assert np.allclose(view.canvas.panes[0].camera.rotation, [[1, 0, 0], [0, 0, 1], [0, -1, 0]])
    qtbot.mouseClick(view.findChild(QToolButton, "scene_side"), Qt.MouseButton.LeftButton)
    assert np.allclose(view.canvas.panes[0].camera.rotation[0], [0, 1, 0])
    qtbot.keyClick(view.canvas, Qt.Key.Key_Left)
    assert not np.allclose(view.canvas.panes[0].camera.rotation[0], [0, 1, 0])


def test_a_click_picks_the_point_that_is_seen(qtbot: QtBot, open_view: Callable[..., SceneView]) -> None:
    view = open_view()
    behind = replace(grid(z=-10.0), name="behind")
    view.set_pick_mode("point")
    shown(qtbot, view, scene(plate(role=Role.BLADE), grid(z=1.0), behind))
    for wanted in ((20.0, -10.0, 1.0), (-30.0, 20.0, 1.0)):
        with qtbot.waitSignal(view.picked_point, timeout=WAIT_MS) as caught:
            qtbot.mouseClick(view.canvas, LEFT, pos=where(view, wanted) + QPoint(2, -1))
        name, xyz, second = caught.args
        assert (name, second) == ("scan", False)
        assert np.allclose(xyz, wanted)
    pixel = view.canvas.panes[0].camera.mm_per_pixel(HEIGHT)
    with qtbot.waitSignal(view.picked_point, timeout=WAIT_MS) as caught:  # no point near: the surface itself
        qtbot.mouseClick(view.canvas, LEFT, pos=where(view, (15.0, 5.0, 0.0)))
    assert caught.args[0] == "plate"
    assert np.abs(caught.args[1] - [15.0, 5.0, 0.0]).max() < pixel


def test_a_drag_and_a_click_into_the_void_pick_nothing(qtbot: QtBot, open_view: Callable[..., SceneView]) -> None:
    view = open_view()
    shown(qtbot, view, scene(plate(), grid()))
    picked: list[Any] = []
    view.picked_point.connect(lambda *args: picked.append(args))
    view.picked_face.connect(lambda *args: picked.append(args))
    qtbot.mouseClick(view.canvas, LEFT, pos=where(view, (0, 0, 0)))  # the mode is `none`
    for mode in ("point", "face"):
        view.set_pick_mode(mode)
        drag(qtbot, view, where(view, (0, 0, 0)), where(view, (20, 10, 0)))
        view.look("top")
        qtbot.mouseClick(view.canvas, LEFT, pos=QPoint(WIDTH // 2, HEIGHT - 8))
    assert picked == []
    with pytest.raises(ValueError, match="pick mode 'edge': expected one of none, point, face"):
        view.set_pick_mode("edge")


def test_a_click_picks_the_face_and_the_pointer_marks_it(qtbot: QtBot, open_view: Callable[..., SceneView]) -> None:
    view = open_view()
    view.set_pick_mode("face")
    plain = shown(qtbot, view, scene(plate()))
    for x, face in ((-20.0, 7), (20.0, 9)):
        with qtbot.waitSignal(view.picked_face, timeout=WAIT_MS) as caught:
            qtbot.mouseClick(view.canvas, LEFT, pos=where(view, (x, 5, 0)))
        assert caught.args == [face, False]
    at = where(view, (20, 5, 0))
    view.canvas._hovered.invalidate()
    with qtbot.waitSignal(view.picture_shown, timeout=WAIT_MS):
        QApplication.sendEvent(view.canvas, mouse_at(view, QPointF(at), Qt.MouseButton.NoButton))
    assert view.canvas.panes[0].hover_face == 9
    assert np.abs(pixels(view)[at.y(), at.x()] - plain[at.y(), at.x()]).max() > 15


def test_two_scenes_side_by_side(qtbot: QtBot, open_view: Callable[..., SceneView]) -> None:
    view = open_view((900, 480))
    view.set_pick_mode("point")
    picture = shown(qtbot, view, scene(grid(role=Role.OUTLIER)), scene(grid(role=Role.HELD_OUT), frame="W"))
    assert share_of(picture[:, :450], Role.OUTLIER) > 1e-3 and share_of(picture[:, 450:], Role.OUTLIER) == 0.0
    assert share_of(picture[:, 450:], Role.HELD_OUT) > 1e-3 and share_of(picture[:, :450], Role.HELD_OUT) == 0.0
    for number in (0, 1):
        with qtbot.waitSignal(view.picked_point, timeout=WAIT_MS) as caught:
            qtbot.mouseClick(view.canvas, LEFT, pos=where(view, (10, 10, 0), number))
        assert caught.args[2] is bool(number) and np.allclose(caught.args[1], (10, 10, 0))
    view.show_picks((Pin(np.array([10.0, 10, 0]), "1"),), (Pin(np.array([-10.0, 0, 0]), "1"),))
    assert share_of(pixels(view), Role.CHOSEN) > share_of(picture, Role.CHOSEN) + 1e-4
    one = shown(qtbot, view, scene(grid(role=Role.OUTLIER)))
    assert share_of(one, Role.HELD_OUT) == 0.0


def path(count: int = 12) -> np.ndarray:
    poses = np.tile(np.eye(4), (count, 1, 1))
    poses[:, 0, 3] = np.linspace(300.0, 500.0, count)
    poses[:, 2, 3] = 400.0
    return poses


def test_the_planned_motion_and_the_robot(qtbot: QtBot, open_view: Callable[..., SceneView]) -> None:
    view = open_view((900, 480))
    shown(qtbot, view, scene(plate(), frame="W"))
    with qtbot.waitSignal(view.picture_shown, timeout=WAIT_MS):
        view.show_motion(path())
    beside = pixels(view)
    assert [pane.scene.frame for pane in view.canvas.panes] == ["W", "B"]
    assert share_of(beside[60:, 450:], Role.SUGGESTION) > 5e-4
    camera = view.canvas.panes[1].camera
    with qtbot.waitSignal(view.picture_shown, timeout=WAIT_MS):
        view.show_robot(path()[3])
    assert (np.abs(pixels(view)[:, 450:] - beside[:, 450:]).max(axis=2) > MISSING_COLOUR).mean() > 2e-3
    extras = view.canvas.panes[1].extras
    view.show_robot(path()[3] + 1e-6)  # cannot be seen: nothing is drawn
    assert view.canvas.panes[1].extras is extras and view.canvas.panes[1].camera is camera
    with qtbot.waitSignal(view.picture_shown, timeout=WAIT_MS):
        view.show_motion(None)
    assert [pane.scene.frame for pane in view.canvas.panes] == ["W"]
    in_base = shown(qtbot, view, scene(BOX, frame="B"))
    with qtbot.waitSignal(view.picture_shown, timeout=WAIT_MS):
        view.show_motion(path())
    assert [pane.scene.frame for pane in view.canvas.panes] == ["B", "B"]
    assert all("~motion way" in [item.name for item in pane.extras] for pane in view.canvas.panes)
    assert share_of(pixels(view)[60:], Role.SUGGESTION) > share_of(in_base[60:], Role.SUGGESTION) + 2e-3
    with qtbot.waitSignal(view.picture_shown, timeout=WAIT_MS):
        view.show_robot(None)
    assert not any(isinstance(item, Frame) and item.name == "{F}" for item in view.canvas.panes[0].extras)


def test_another_theme_another_size(
    qtbot: QtBot, open_view: Callable[..., SceneView], monkeypatch: pytest.MonkeyPatch
) -> None:
    view = open_view()
    monkeypatch.setattr(theme(), "_choice", "light")
    light = shown(qtbot, view, scene(grid()))
    assert np.abs(light[5, WIDTH // 2] - _rgb("scene")).max() < 4
    monkeypatch.setattr(theme(), "_choice", "dark")
    with qtbot.waitSignal(view.picture_shown, timeout=WAIT_MS):
        theme().changed.emit()
    dark = pixels(view)
    assert np.abs(dark[5, WIDTH // 2] - _rgb("scene")).max() < 4
    assert light.mean() > 180 > 80 > dark.mean()
    with qtbot.waitSignal(view.picture_shown, timeout=WAIT_MS):
        view.resize(800, 300)
    assert pixels(view).shape == (300, 800, 3)
    corner = where(view, (30, 20, 0))
    assert 0 < corner.x() < 800 and 0 < corner.y() < 300  # fitted again


def test_what_was_shown_before_the_graphics_are_there_is_drawn_then(qtbot: QtBot) -> None:
    view = SceneView(own_process=False)
    qtbot.addWidget(view, before_close_func=SceneView.shut_down)
    view.resize(WIDTH, HEIGHT)
    view.show()
    assert view.canvas.notice == "Nothing to show yet."
    view.show_scene(scene(grid(role=Role.OUTLIER)))
    assert view.canvas.notice == "The 3D view is being prepared."
    assert share_of(pixels(view), Role.OUTLIER) == 0.0
    with qtbot.waitSignal(view.picture_shown, timeout=WAIT_MS):
        view.prepare()
    assert share_of(pixels(view), Role.OUTLIER) > 1e-3


def test_a_hidden_view_does_not_draw(qtbot: QtBot, open_view: Callable[..., SceneView]) -> None:
    view = open_view()
    shown(qtbot, view, scene(grid()))
    view.hide()
    with qtbot.assertNotEmitted(view.picture_shown, wait=100):
        view.show_scene(scene(grid(role=Role.OUTLIER)))
    with qtbot.waitSignal(view.picture_shown, timeout=WAIT_MS):
        view.show()
    assert share_of(pixels(view), Role.OUTLIER) > 1e-3


def test_the_drawing_process_is_replaced_when_it_dies_and_gone_in_the_end(
    qtbot: QtBot, open_view: Callable[..., SceneView]
) -> None:
    view = open_view(own_process=True)
    same = shown(qtbot, view, scene(grid(role=Role.OUTLIER)))
    assert share_of(same, Role.OUTLIER) > 1e-3
    first = view.drawing_pid
    assert first is not None and first != os.getpid()
    os.kill(first, 9)
    view.show_scene(scene(grid(role=Role.HELD_OUT)))
    qtbot.waitUntil(lambda: view.drawing_pid is None, timeout=WAIT_MS)
    again = view.findChild(QToolButton, "scene_restart")
    assert again.isVisible() and "has stopped" in view.canvas.notice  # so soon after its start it is left to the person
    with qtbot.waitSignal(view.picture_shown, timeout=WAIT_MS):
        qtbot.mouseClick(again, Qt.MouseButton.LeftButton)
    assert share_of(pixels(view), Role.HELD_OUT) > 1e-3 and not again.isVisible()
    view.shut_down()
    view.shut_down()
    assert multiprocessing.active_children() == []


@pytest.mark.parametrize("own_process", [False, True])
def test_opening_and_closing_leaves_nothing(qtbot: QtBot, own_process: bool) -> None:
    from vtkmodules.vtkRenderingCore import vtkRenderWindow

    gc.collect()
    before = {id(thing) for thing in gc.get_objects() if isinstance(thing, vtkRenderWindow)}
    threads = threading.active_count()
    gone: list[weakref.ref[Any]] = []
    for round_ in range(3 if own_process else 5):
        view = SceneView(own_process=own_process)
        view.resize(300, 200)
        view.show()
        view.prepare()
        if round_ != 1:  # once closed before anything was drawn
            shown(qtbot, view, scene(plate(), grid()))
        view.close()
        gone.extend([weakref.ref(view), weakref.ref(view.canvas)])
        view.deleteLater()
        del view
    QApplication.sendPostedEvents(None, QEvent.Type.DeferredDelete)
    gc.collect()
    assert [ref for ref in gone if ref() is not None] == []
    assert threading.active_count() == threads
    assert multiprocessing.active_children() == []
    assert {id(thing) for thing in gc.get_objects() if isinstance(thing, vtkRenderWindow)} <= before
