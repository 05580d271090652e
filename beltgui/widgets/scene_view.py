"""The 3D view: shows scenes, the planned motion and the robot; reports clicks on points and faces.

The picture is drawn off-screen by a process of its own and painted by Qt, the same on every platform, with or without a
screen: the window's event loop never waits for the graphics, and a fault of a graphics driver does not end the program.
"""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray
from PySide6.QtCore import QElapsedTimer, QEvent, QSize, QSizeF, Signal
from PySide6.QtGui import QCloseEvent, QImage, QResizeEvent
from PySide6.QtWidgets import QVBoxLayout, QWidget

from beltgui.app.opengl import why_no_window
from beltgui.app.theme import theme
from beltgui.viewmodel.scene import Item, Scene
from beltgui.widgets.scene_view_buttons import ViewButtons
from beltgui.widgets.scene_view_canvas import Canvas
from beltgui.widgets.scene_view_link import LocalDrawer, ProcessDrawer
from beltgui.widgets.scene_view_motion import motion_items, motion_scene, robot_items
from beltgui.widgets.scene_view_overlay import Pin
from beltgui.widgets.scene_view_pick import Hit
from beltgui.widgets.scene_window import SceneWindow

Array = NDArray[np.float64]

PICK_MODES = ("none", "point", "face")
# A drawing process that is lost sooner than this after its start is not started again by itself.
LIFE_MS = 10_000
# The robot's live mark moves on the screen when the flange has moved this far (mm, and entries of the rotation).
SEEN_MM, SEEN_TURN = 0.05, 1e-3


class SceneView(QWidget):
    """A 3D view; one for each window.

    Left drag turns, right or middle drag (or Shift and left) moves, the wheel zooms, a double click fits; with the
    keyboard F, 1 to 4, the arrows, + and -. A click picks what the mode says. Nothing is drawn before `prepare`;
    what was shown before is drawn then.

    Args:
        parent: Of the widget.
        own_process: Draw in a process of its own; False draws within this one, which is slower for the window and
            quicker to start: for tests.

    Signals:
        picked_point: (name of the item, (3,) mm in that scene's frame, True for the second scene).
        picked_face: (id of the CAD face, True for the second scene).
        picture_shown: A new picture is on the screen.
        laid_out: Other scenes or marks are to be seen.
    """

    picked_point = Signal(str, object, bool)
    picked_face = Signal(int, bool)
    picture_shown = Signal()
    laid_out = Signal()

    def __init__(self, parent: QWidget | None = None, *, own_process: bool = True) -> None:
        super().__init__(parent)
        self._own_process = own_process
        self._drawer: ProcessDrawer | LocalDrawer | None = None
        self._started = QElapsedTimer()
        self._closed = False
        self._scene: Scene | None = None
        self._second: Scene | None = None
        self._path: Array | None = None
        self._robot: Array | None = None
        self._motion_items: tuple[Item, ...] = ()
        self._motion_scene: Scene | None = None
        self._robot_items: tuple[Item, ...] = ()
        self._extras: tuple[Item, ...] = ()
        self._pins: tuple[tuple[Pin, ...], tuple[Pin, ...]] = ((), ())
        self.window_beside: SceneWindow | None = None
        self.setObjectName("scene_view")
        self.canvas = Canvas(self)
        self.canvas.setObjectName("scene_canvas")
        self.canvas.clicked_on.connect(self._clicked)
        self.canvas.picture_shown.connect(self.picture_shown)
        layout = QVBoxLayout(self)
        layout.setContentsMargins(0, 0, 0, 0)
        layout.addWidget(self.canvas)
        self._build_buttons()
        self._write()
        theme().changed.connect(self._theme_changed)

    # --- what it offers

    def prepare(self) -> None:
        """Begin to draw; returns at once, the first picture comes when the graphics are there."""
        if self._drawer is not None or self._closed:
            return
        self._started.start()
        self._drawer = ProcessDrawer() if self._own_process else LocalDrawer()
        self._drawer.lost.connect(self._lost)
        self.destroyed.connect(self._drawer.stop)  # whoever forgets to shut down does not leave a process
        self.canvas.set_drawer(self._drawer)
        self._write()

    def show_scene(self, scene: Scene | None, second: Scene | None = None) -> None:
        """Show a scene with those beside it, or two side by side; None shows nothing."""
        self._scene, self._second = scene, second
        self._lay_out()

    def show_motion(self, path: Array | None) -> None:
        """Show a planned motion, (n, 4, 4) base_from_flange, or take it away.

        It has a viewport of its own beside the first scene; in a scene of the robot's base it is drawn there too.
        """
        self._path = None if path is None else np.asarray(path, dtype=float).reshape(-1, 4, 4)
        self._motion_items = () if self._path is None or not len(self._path) else motion_items(self._path)
        self._motion_scene = None if self._path is None else motion_scene(self._path)
        self._renew_extras()

    def show_robot(self, base_from_flange: Array | None) -> None:
        """Show where the flange is now, (4, 4), wherever a scene of the robot's base is shown; None: not known."""
        if base_from_flange is not None and self._robot is not None:
            change = np.abs(np.asarray(base_from_flange, dtype=float) - self._robot)
            if change[:3, 3].max() < SEEN_MM and change[:3, :3].max() < SEEN_TURN:
                return
        elif base_from_flange is None and self._robot is None:
            return
        self._robot = None if base_from_flange is None else np.array(base_from_flange, dtype=float)
        self._robot_items = () if self._robot is None else robot_items(self._robot)
        self._renew_extras()

    def show_picks(self, first: tuple[Pin, ...] = (), second: tuple[Pin, ...] = ()) -> None:
        """Mark picked places in the first and in the second scene with named rings."""
        self._pins = (first, second)
        self._lay_out_pins()

    def set_pick_mode(self, mode: str) -> None:
        """What a click picks: `none`, `point` or `face`.

        Raises:
            ValueError: there is no such mode.
        """
        if mode not in PICK_MODES:
            raise ValueError(f"pick mode '{mode}': expected one of {', '.join(PICK_MODES)}.")
        self.canvas.pick_mode = mode
        for pane in self.canvas.panes:
            pane.hover_at = pane.hover_face = None
        self.canvas.redraw()

    def look(self, direction: str) -> None:
        """`fit`, `front`, `side`, `top` or `oblique`."""
        self.canvas.look(direction)

    def screenshot(self) -> QImage:
        """What is seen, with all that is written over it."""
        return self.canvas.grab().toImage()

    def open_window(self) -> None:
        """Show the same in a window of its own too, where the screen can; there is one, it comes to the front."""
        if why_no_window() or self._closed:
            return
        if self.window_beside is None:
            self.window_beside = SceneWindow(self)
            self.window_beside.closed.connect(self._window_closed)
        self.window_beside.show()
        self.window_beside.raise_()
        self.window_beside.activateWindow()

    def shut_down(self) -> None:
        """End the drawing; must be called before the widget goes, and may be called twice."""
        if self._closed:
            return
        self._closed = True
        if self.window_beside is not None:
            self.window_beside.close()
        theme().changed.disconnect(self._theme_changed)
        self.canvas.shut_down()
        if self._drawer is not None:
            self._drawer.stop()

    @property
    def drawing_pid(self) -> int | None:
        """Of the drawing process, where there is one."""
        return self._drawer.pid if isinstance(self._drawer, ProcessDrawer) else None

    # --- within

    def _lay_out(self) -> None:
        scenes = [] if self._scene is None else [self._scene, *self._scene.beside]
        if self._motion_scene is not None:
            scenes = [*scenes[:1], self._motion_scene]
        elif self._second is not None:
            scenes.append(self._second)
        wanted: list[tuple[Scene, tuple[Item, ...]]] = []
        for scene in scenes:
            moving = self._extras if scene in (self._scene, self._motion_scene) else self._robot_items
            wanted.append((scene, moving if scene.frame == "B" else ()))
        self.canvas.set_panes(wanted)
        self._lay_out_pins()
        titles = " | ".join(scene.title for scene, _ in wanted)
        self.canvas.setAccessibleDescription(titles)
        self._write()

    def _renew_extras(self) -> None:
        self._extras = (*self._motion_items, *self._robot_items)
        self._lay_out()

    def _lay_out_pins(self) -> None:
        for pane in self.canvas.panes:
            pane.pins = self._pins[0] if pane.scene is self._scene else ()
            if pane.scene is self._second:
                pane.pins = self._pins[1]
        self.canvas.update()
        self.laid_out.emit()

    def _clicked(self, hit: Hit, number: int) -> None:
        shown = self.canvas.panes[number].scene
        if shown is self._motion_scene:
            return
        second = shown is self._second
        if self.canvas.pick_mode == "face" and hit.face_id is not None:
            self.picked_face.emit(hit.face_id, second)
        elif self.canvas.pick_mode == "point":
            self.picked_point.emit(hit.item, hit.xyz, second)

    def _lost(self) -> None:
        """The drawing process has ended by itself: begin again once, then leave it to the person."""
        lived = self._started.elapsed()
        if self._drawer is None or self._closed:
            return
        self._drawer.stop()
        self._drawer = None
        self.canvas.set_drawer(None)
        if lived > LIFE_MS:
            self.prepare()
        self._restart.setVisible(self._drawer is None)
        self._write()

    def _build_buttons(self) -> None:
        self._bar = ViewButtons("scene", self.canvas)
        self._bar.look_wanted.connect(self.look)
        self._own_window = self._bar.add("own_window")
        self._own_window.clicked.connect(self.open_window)
        self._restart = self._bar.add("restart")
        self._restart.clicked.connect(self._start_again)
        self._restart.hide()

    def _window_closed(self) -> None:
        self.window_beside = None

    def _start_again(self) -> None:
        self._restart.hide()
        self.prepare()

    def _write(self) -> None:
        self._own_window.setText(self.tr("Window"))
        self._own_window.setAccessibleName(self.tr("3D view in a window of its own"))
        self._own_window.setEnabled(not why_no_window())
        tip = self.tr("The same in a window of its own, drawn by the graphics card: large, or on another screen (F11)")
        self._own_window.setToolTip(why_no_window() or tip)
        self._restart.setText(self.tr("Start the 3D view again"))
        self._restart.setAccessibleName(self._restart.text())
        self.canvas.setAccessibleName(self.tr("3D view"))
        if self._closed:
            notice = ""
        elif self._drawer is None and self._started.isValid():
            notice = self.tr("The 3D view has stopped. Nothing else is affected.")
        elif self._scene is None and self._motion_scene is None:
            notice = self.tr("Nothing to show yet.")
        else:
            notice = self.tr("The 3D view is being prepared.")
        self.canvas.notice = notice
        self._place_buttons()

    def _place_buttons(self) -> None:
        size: QSize = self._bar.sizeHint()
        self._bar.resize(size)
        self._bar.move(self.width() - size.width() - 8, self.height() - size.height() - 8)
        self.canvas.keep_free = QSizeF(size.width() + 16.0, size.height() + 16.0)
        self.canvas.update()

    def _theme_changed(self) -> None:
        self._place_buttons()
        self.canvas.redraw()

    def resizeEvent(self, event: QResizeEvent) -> None:  # noqa: N802  (Qt's name)
        """Keep the buttons in their corner."""
        super().resizeEvent(event)
        self._place_buttons()

    def closeEvent(self, event: QCloseEvent) -> None:  # noqa: N802  (Qt's name)
        """Closed as a window of its own."""
        self.shut_down()
        super().closeEvent(event)

    def changeEvent(self, event: QEvent) -> None:  # noqa: N802  (Qt's name)
        """Write again in another language."""
        if event.type() == QEvent.Type.LanguageChange:
            self._write()
            self._place_buttons()
        super().changeEvent(event)
