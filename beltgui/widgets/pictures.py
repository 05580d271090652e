"""Instruction pictures and icons: line drawings in the theme's colours, sharp at any size."""

from __future__ import annotations

from functools import cache

from PySide6.QtCore import QByteArray, QRectF, QSize, Qt
from PySide6.QtGui import QIcon, QPainter, QPaintEvent, QPixmap
from PySide6.QtSvg import QSvgRenderer
from PySide6.QtWidgets import QSizePolicy, QWidget

from beltgui.app.theme import colour, px, theme
from resources import resource_path

# The drawings' own colours, each replaced by the theme's.
_INKS = {"#808891": "text", "#2f7fd6": "accent", "#c8ccd0": "line"}


@cache
def _drawing(name: str) -> str:
    file = name.replace(" ", "_") + ".svg"
    return resource_path("pictures", file).read_text(encoding="utf-8")


def drawing(name: str, inks: dict[str, str] | None = None) -> QByteArray:
    """A picture's SVG in the theme's colours.

    Args:
        name: `mount ball`, `mount blade`, `mount stylus`, `mount nothing`, `touch cone`, `touch shaft`, `motion`,
            `step <name>` or `app`.
        inks: Keys of the theme in place of `text`, `accent` and `line`.

    Raises:
        FileNotFoundError: there is no such picture.
    """
    text = _drawing(name)
    for ink, key in _INKS.items():
        text = text.replace(ink, colour((inks or {}).get(key, key)))
    return QByteArray(text.encode())


def icon(name: str, size: int = 48) -> QIcon:
    """A picture as an icon in the theme's colours of this moment."""
    pixmap = QPixmap(size, size)
    pixmap.fill(Qt.GlobalColor.transparent)
    painter = QPainter(pixmap)
    QSvgRenderer(drawing(name)).render(painter)
    painter.end()
    return QIcon(pixmap)


class Picture(QWidget):
    """One picture, as large as the place allows, in its own proportions."""

    def __init__(self, parent: QWidget | None = None, height: int = 120) -> None:
        super().__init__(parent)
        self._name = ""
        self._height = height
        self._renderer = QSvgRenderer(self)
        self.setSizePolicy(QSizePolicy.Policy.Expanding, QSizePolicy.Policy.Fixed)
        theme().changed.connect(self._rethemed)

    @property
    def name(self) -> str:
        """Of the picture that is shown; empty for none."""
        return self._name

    def show_picture(self, name: str) -> None:
        """Show a picture; an empty name shows none."""
        if name == self._name:
            return
        self._name = name
        self._rethemed()

    def sizeHint(self) -> QSize:  # noqa: N802
        """Of the usual height."""
        return QSize(px(self._height) * 3 // 2, px(self._height))

    def paintEvent(self, event: QPaintEvent) -> None:  # noqa: N802
        """Draw it in the middle."""
        if not self._name:
            return
        size = self._renderer.defaultSize().scaled(self.size(), Qt.AspectRatioMode.KeepAspectRatio)
        left, top = (self.width() - size.width()) / 2.0, (self.height() - size.height()) / 2.0
        self._renderer.render(QPainter(self), QRectF(left, top, size.width(), size.height()))

    def _rethemed(self) -> None:
        if self._name:
            self._renderer.load(drawing(self._name))
        self.updateGeometry()
        self.update()
