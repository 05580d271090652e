"""Draws scenes straight into a window, with what the computer has for graphics; the hand's picture lies over it.

This is where pyvistaqt is used, and it is imported only when somebody wants such a window: that takes seconds.
"""

from __future__ import annotations

import importlib
import threading
from dataclasses import replace
from functools import cache
from typing import Any

from PySide6.QtCore import QObject, Qt, Signal
from PySide6.QtGui import QOpenGLContext, QPainter
from PySide6.QtWidgets import QWidget

from beltgui.widgets.scene_draw import Request, Scenery
from beltgui.widgets.scene_view_canvas import Canvas
from beltgui.widgets.scene_view_link import Picture

# pyvistaqt loads the rest of what it needs when the first interactor is made; so it is loaded with it.
PACKAGES = ("pyvista", "pyvista.plotting", "vtkmodules.vtkRenderingOpenGL2", "pyvistaqt")


class Loader(QObject):
    """Imports what a window needs, once, in a thread beside the screen's.

    Signals:
        loaded: Everything is there.
        failed: Something cannot be loaded; the reason.
    """

    loaded = Signal()
    failed = Signal(str)

    def __init__(self) -> None:
        super().__init__()
        self.done = False
        self._thread: threading.Thread | None = None

    def begin(self) -> None:
        """Load, unless that is under way; tells at once if it has been done."""
        if self.done:
            self.loaded.emit()
        elif self._thread is None or not self._thread.is_alive():
            self._thread = threading.Thread(target=self._load, name="imports of the 3D window")
            self._thread.start()

    def _load(self) -> None:
        try:
            for name in PACKAGES:
                importlib.import_module(name)
        except ImportError as error:  # a library of the graphics driver may be missing on this computer
            self.failed.emit(str(error))
            return
        self.done = True
        self.loaded.emit()


@cache
def loader() -> Loader:
    """The loader; there is one."""
    return Loader()


class NoOpenGLError(RuntimeError):
    """The screen's platform should have OpenGL, but gives none."""


class WindowDrawer(QObject):
    """Draws what a `Glass` asks for into a `QtInteractor`, which it makes; the same words as the other drawers.

    Only the glass over it takes mouse and keys, so that the hand does the same in every 3D view.

    Raises:
        NoOpenGLError: there is none.

    Signals:
        drawn: A `Picture` of no pixels: the window has it.
        lost: Never.
    """

    drawn = Signal(object)
    lost = Signal()

    def __init__(self, parent: QWidget) -> None:
        super().__init__(parent)
        if not QOpenGLContext().create():
            raise NoOpenGLError
        from pyvistaqt import QtInteractor

        self.interactor: Any = QtInteractor(parent, auto_update=False)
        self.interactor.setFocusPolicy(Qt.FocusPolicy.NoFocus)
        self.interactor.setAcceptDrops(False)
        self.interactor.renderer.DrawOff()  # pyvista's own, which is empty
        self._scenery = Scenery(self.interactor.render_window, swapped=False)

    def submit(self, request: Request) -> None:
        """Draw this with the next frame, in which the glass draws what is written over it."""
        ratio = self.interactor.devicePixelRatioF()
        self._scenery.show(replace(request, ratio=ratio))
        self.interactor.update()
        self.drawn.emit(Picture(None, 0.0))

    def stop(self) -> None:
        """Free the OpenGL objects."""
        self._scenery.clear()
        self.interactor.close()


class Glass(Canvas):
    """The canvas of a 3D view without a picture of its own: what lies under it is seen through."""

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.setAttribute(Qt.WidgetAttribute.WA_OpaquePaintEvent, False)
        self._drawn = False

    def _keep(self, picture: Picture) -> None:
        self._drawn = True

    def _has_picture(self) -> bool:
        return self._drawn

    def _paint_picture(self, painter: QPainter) -> None:
        """It is there already."""
