"""The 3D view once more in a window of its own, drawn by the graphics card: for a big picture, or a second screen.

The view in the main window is drawn by a process beside it and works everywhere. This window is for a workstation with
a graphics card; it draws within the program and follows the view that it was opened from.
"""

from __future__ import annotations

from typing import TYPE_CHECKING

from PySide6.QtCore import QCoreApplication, QEvent, QSizeF, Qt, Signal
from PySide6.QtGui import QCloseEvent, QKeySequence, QResizeEvent, QShortcut
from PySide6.QtWidgets import QMainWindow, QWidget

from beltgui.app.theme import px, theme
from beltgui.widgets.scene_view_buttons import ViewButtons
from beltgui.widgets.scene_window_gl import Glass, NoOpenGLError, WindowDrawer, loader

if TYPE_CHECKING:
    from beltgui.widgets.scene_view import SceneView

WIDTH_PX, HEIGHT_PX = 1100, 800


class SceneWindow(QMainWindow):
    """Shows what a `SceneView` shows, with cameras of its own; closes for good.

    Turned, moved and zoomed as the view is; F11 takes the whole screen, Esc closes.

    Args:
        view: Followed until the window closes.

    Signals:
        closed: It is gone.
        picture_shown: A new picture is on its way to the screen.
    """

    closed = Signal()
    picture_shown = Signal()

    def __init__(self, view: SceneView) -> None:
        super().__init__()
        self.setObjectName("scene_window")
        self.setAttribute(Qt.WidgetAttribute.WA_DeleteOnClose)
        self._view = view
        self._drawer: WindowDrawer | None = None
        self._why = ""
        self._place = QWidget(self)
        self.setCentralWidget(self._place)
        self.canvas = Glass(self._place)
        self.canvas.setObjectName("scene_window_canvas")
        self.canvas.picture_shown.connect(self.picture_shown)
        self._buttons = ViewButtons("scene_window", self.canvas)
        self._buttons.look_wanted.connect(self.canvas.look)
        for keys, do in (("Esc", self.close), ("F11", self._whole_screen)):
            QShortcut(QKeySequence(keys), self).activated.connect(do)
        self.resize(px(WIDTH_PX), px(HEIGHT_PX))
        self._write()
        view.laid_out.connect(self.follow)
        theme().changed.connect(self._theme_changed)
        loader().loaded.connect(self._begin, Qt.ConnectionType.QueuedConnection)
        loader().failed.connect(self._fail, Qt.ConnectionType.QueuedConnection)
        self.follow()
        loader().begin()

    def follow(self) -> None:
        """Show what the view shows now."""
        panes = self._view.canvas.panes
        self.canvas.set_panes([(pane.scene, pane.extras) for pane in panes])
        for ours, theirs in zip(self.canvas.panes, panes, strict=True):
            ours.pins = theirs.pins
        self.canvas.setAccessibleDescription(" | ".join(pane.scene.title for pane in panes))
        self._write()

    # --- within

    def _begin(self) -> None:
        if self._drawer is not None or self._why:
            return
        try:
            self._drawer = WindowDrawer(self._place)
        except NoOpenGLError:
            self._fail(self.tr("The screen gives it no OpenGL."))
            return
        self._drawer.interactor.lower()
        self._drawer.interactor.show()
        self._lay_out()
        self.canvas.set_drawer(self._drawer)

    def _fail(self, why: str) -> None:
        self._why = why
        self._write()

    def _whole_screen(self) -> None:
        self.setWindowState(self.windowState() ^ Qt.WindowState.WindowFullScreen)

    def _write(self) -> None:
        self.setWindowTitle(self.tr("3D view – beltcal"))
        self.canvas.setAccessibleName(self.tr("3D view in a window of its own"))
        if self._why:
            self.canvas.notice = self.tr("This window cannot be drawn: {reason}").format(reason=self._why)
        elif not self.canvas.panes:
            self.canvas.notice = QCoreApplication.translate("SceneView", "Nothing to show yet.")
        else:
            self.canvas.notice = QCoreApplication.translate("SceneView", "The 3D view is being prepared.")
        self._lay_out()

    def _lay_out(self) -> None:
        self.canvas.setGeometry(self._place.rect())
        if self._drawer is not None:
            self._drawer.interactor.setGeometry(self._place.rect())
        size = self._buttons.sizeHint()
        self._buttons.setGeometry(
            self._place.width() - size.width() - 8, self._place.height() - size.height() - 8,
            size.width(), size.height(),
        )  # fmt: skip
        self.canvas.keep_free = QSizeF(size.width() + 16.0, size.height() + 16.0)
        self.canvas.update()

    def _theme_changed(self) -> None:
        self._lay_out()
        self.canvas.redraw()

    def resizeEvent(self, event: QResizeEvent) -> None:  # noqa: N802  (Qt's name)
        """Picture, glass and buttons keep their places."""
        super().resizeEvent(event)
        self._lay_out()

    def changeEvent(self, event: QEvent) -> None:  # noqa: N802  (Qt's name)
        """Write again in another language."""
        super().changeEvent(event)
        if event.type() == QEvent.Type.LanguageChange:
            self._write()

    def closeEvent(self, event: QCloseEvent) -> None:  # noqa: N802  (Qt's name)
        """Everything that draws goes first: a widget of VTK that is not closed ends the program."""
        self._view.laid_out.disconnect(self.follow)
        theme().changed.disconnect(self._theme_changed)
        loader().loaded.disconnect(self._begin)
        loader().failed.disconnect(self._fail)
        self.canvas.shut_down()
        if self._drawer is not None:
            self._drawer.stop()
        super().closeEvent(event)
        self.closed.emit()
