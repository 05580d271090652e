"""The 3D view: an interactor where the platform has OpenGL, otherwise a picture drawn off-screen."""

from __future__ import annotations

from typing import Any, Protocol

from PySide6.QtCore import Qt
from PySide6.QtGui import QGuiApplication, QImage, QPixmap, QResizeEvent
from PySide6.QtWidgets import QLabel, QSizePolicy, QVBoxLayout, QWidget

# Qt platforms that give a QtInteractor no OpenGL context.
PLATFORMS_WITHOUT_GL = frozenset({"offscreen", "minimal", "vnc", "linuxfb"})
BACKGROUND = "#e9ecef"


class Scene(Protocol):
    """What the application draws on, the same for both kinds of view."""

    @property
    def plotter(self) -> Any:
        """The pyvista plotter; give every actor a `name`, so that drawing again replaces it."""
        ...

    def refresh(self) -> None:
        """Show what has been added to the plotter."""
        ...

    def shut_down(self) -> None:
        """Free the OpenGL objects; must be called before the widget goes."""
        ...


class InteractorView(QWidget):
    """A view that can be turned with the mouse."""

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        from pyvistaqt import QtInteractor

        self.plotter = QtInteractor(self, auto_update=False)
        self.plotter.set_background(BACKGROUND)
        layout = QVBoxLayout(self)
        layout.setContentsMargins(0, 0, 0, 0)
        layout.addWidget(self.plotter)

    def refresh(self) -> None:
        """Render."""
        self.plotter.render()

    def shut_down(self) -> None:
        """Close the interactor."""
        self.plotter.close()


class PictureView(QLabel):
    """A view for platforms without OpenGL: drawn off-screen, shown as a picture."""

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        import pyvista

        from beltgui.report.scenes import prepare_rendering

        prepare_rendering()
        self.plotter = pyvista.Plotter(off_screen=True)
        self.plotter.set_background(BACKGROUND)
        self.setAlignment(Qt.AlignmentFlag.AlignCenter)
        self.setSizePolicy(QSizePolicy.Policy.Ignored, QSizePolicy.Policy.Ignored)
        self._drawn = False

    def refresh(self) -> None:
        """Render and show the picture at the widget's size."""
        self._drawn = True
        self.plotter.window_size = [max(self.width(), 64), max(self.height(), 64)]
        pixels = self.plotter.screenshot(return_img=True)
        height, width, channels = pixels.shape
        image = QImage(pixels.tobytes(), width, height, channels * width, QImage.Format.Format_RGB888)
        self.setPixmap(QPixmap.fromImage(image))

    def resizeEvent(self, event: QResizeEvent) -> None:  # noqa: N802  (Qt's name)
        """Draw again at the new size."""
        super().resizeEvent(event)
        if self._drawn:
            self.refresh()

    def shut_down(self) -> None:
        """Close the plotter."""
        self.plotter.close()


def make_view(parent: QWidget | None = None) -> InteractorView | PictureView:
    """The view that this platform can show."""
    if QGuiApplication.platformName() in PLATFORMS_WITHOUT_GL:
        return PictureView(parent)
    return InteractorView(parent)
