"""The picture and the hand on it: keeps the cameras, asks for pictures, turns, moves, zooms, picks."""

from __future__ import annotations

from dataclasses import dataclass, field, replace

import numpy as np
from numpy.typing import NDArray
from PySide6.QtCore import QElapsedTimer, QEvent, QPoint, QPointF, QRectF, QSizeF, Qt, QTimer, Signal
from PySide6.QtGui import (
    QColor,
    QFontMetricsF,
    QGuiApplication,
    QImage,
    QKeyEvent,
    QMouseEvent,
    QPainter,
    QPaintEvent,
    QResizeEvent,
    QShowEvent,
    QWheelEvent,
)
from PySide6.QtWidgets import QSizePolicy, QWidget

from beltgui.app.language import sentence
from beltgui.app.theme import colour
from beltgui.viewmodel.scene import Item, Role, Scene
from beltgui.widgets.scene_draw import BACKGROUND, Request, ViewRequest, split
from beltgui.widgets.scene_view_camera import ANGLE_RAD, DIRECTIONS, Camera
from beltgui.widgets.scene_view_link import LocalDrawer, Picture, ProcessDrawer
from beltgui.widgets.scene_view_outline import first_camera, outline_of, wanted_items
from beltgui.widgets.scene_view_overlay import Overlay, Pin, bar_share, paint, top_share
from beltgui.widgets.scene_view_pick import Hit, pick

# Requests are held together for so long, so that several changes at once make one picture.
GATHER_MS = 12
# While the hand turns the scene, and on a large screen while new scenes stream in, a picture that takes longer than
# this is drawn at half the density; at rest it is sharp again.
SLOW_S = 0.05
REST_MS, STREAM_REST_MS = 180, 700
MANY_PIXELS = 2_500_000
HOVER_MS = 40
TURN_RAD_PER_PX = 0.009
KEY_TURN_RAD = np.deg2rad(10.0)
ZOOM_STEP = 1.2
VIEW_KEYS = {
    Qt.Key.Key_F: "fit", Qt.Key.Key_1: "front", Qt.Key.Key_2: "side", Qt.Key.Key_3: "top", Qt.Key.Key_4: "oblique",
}  # fmt: skip
TURN_KEYS = {
    Qt.Key.Key_Left: (-1.0, 0.0), Qt.Key.Key_Right: (1.0, 0.0), Qt.Key.Key_Up: (0.0, -1.0), Qt.Key.Key_Down: (0.0, 1.0),
}  # fmt: skip


@dataclass(eq=False)
class Pane:
    """One viewport: what it shows and how it is looked at."""

    scene: Scene
    extras: tuple[Item, ...] = ()
    camera: Camera = field(default_factory=Camera.looking)
    drawn_with: Camera | None = None
    untouched: bool = True
    whole: bool = False
    margins: tuple[float, float, float] = (0.0, 0.0, 0.0)
    box: NDArray[np.float64] | None = None
    items_sent: bool = False
    extras_sent: bool = False
    hover_face: int | None = None
    hover_at: QPointF | None = None
    pins: tuple[Pin, ...] = ()


@dataclass(frozen=True, eq=False)
class Seen:
    """What a viewport of a picture was drawn from; the pane may be ahead of it."""

    pane: Pane
    scene: Scene
    extras: tuple[Item, ...]
    camera: Camera


class Canvas(QWidget):
    """Paints what a drawer draws; see `SceneView` for what it offers.

    Signals:
        clicked_on: (`Hit`, number of the viewport).
        picture_shown: A new picture is on the screen.
    """

    clicked_on = Signal(object, int)
    picture_shown = Signal()

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.panes: list[Pane] = []
        self.pick_mode = "none"
        self.keep_free = QSizeF(0.0, 0.0)
        self.notice = ""
        self.seconds = 0.0
        self._sharp_seconds = 0.0
        self._drawer: ProcessDrawer | LocalDrawer | None = None
        self._picture = QImage()
        self._pixels: NDArray[np.uint8] | None = None
        self._asked: list[Seen] = []
        self._seen: list[Seen] = []
        self._in_flight = False
        self._dirty = False
        self._interacting = False
        self._sharp = True
        self._words: dict[str, str] = {}
        self._pressed: QPointF | None = None
        self._last = QPointF()
        self._dragging = False
        self._held: Pane | None = None
        self._hovered = QElapsedTimer()
        self._gather = QTimer(self, singleShot=True, interval=GATHER_MS)
        self._gather.timeout.connect(self._ask)
        self._rest = QTimer(self, singleShot=True)
        self._rest.timeout.connect(self._at_rest)
        self.setMouseTracking(True)
        self.setFocusPolicy(Qt.FocusPolicy.StrongFocus)
        self.setSizePolicy(QSizePolicy.Policy.Expanding, QSizePolicy.Policy.Expanding)
        self.setMinimumSize(160, 120)
        self.setAttribute(Qt.WidgetAttribute.WA_OpaquePaintEvent)

    # --- what is shown

    def set_drawer(self, drawer: ProcessDrawer | LocalDrawer | None) -> None:
        """Draw with this one from now on; everything is sent to it anew."""
        self._drawer = drawer
        self._in_flight = False
        self._picture = QImage()
        self._seen = []
        for pane in self.panes:
            pane.items_sent = pane.extras_sent = False
        if drawer is not None:
            drawer.drawn.connect(self._take)
            self.redraw()

    def set_panes(self, wanted: list[tuple[Scene, tuple[Item, ...]]]) -> None:
        """Show these scenes, each with its layer of extras, side by side."""
        kept = self.panes if len(wanted) == len(self.panes) else self.panes[: len(wanted)]
        if len(wanted) != len(self.panes):
            for pane in kept:
                pane.box = None  # the viewport has another shape now
        panes = []
        for number, (scene, extras) in enumerate(wanted):
            pane = kept[number] if number < len(kept) else Pane(scene, camera=first_camera(scene))
            if pane.scene is not scene:
                anew = pane.scene.view != scene.view or pane.scene.frame != scene.frame
                pane.scene, pane.items_sent, pane.hover_face, pane.hover_at = scene, False, None, None
                if anew:
                    pane.untouched, pane.whole, pane.box, pane.camera = True, False, None, first_camera(scene)
            if pane.extras is not extras:
                pane.extras, pane.extras_sent = extras, False
            panes.append(pane)
        self.panes = panes
        for pane in panes:
            self._fit_if_untouched(pane)
        if self.width() * self.height() * self.devicePixelRatioF() ** 2 > MANY_PIXELS:
            self._busy(STREAM_REST_MS)
        self.redraw()

    def look(self, direction: str) -> None:
        """Look at everything: `fit` keeps the direction, the others are those of the camera."""
        for pane in self.panes:
            if direction != "fit":
                pane.camera = Camera(pane.camera.target, pane.camera.distance, DIRECTIONS[direction])
            pane.untouched, pane.whole, pane.box = True, True, None
            self._fit_if_untouched(pane)
        self.redraw()

    def forget_words(self) -> None:
        """The language has changed."""
        self._words.clear()
        self.update()

    def redraw(self) -> None:
        """Ask for a new picture soon."""
        self._dirty = True
        if not self._in_flight and not self._gather.isActive():
            self._gather.start()
        if self._picture.isNull():
            self.update()  # the notice

    def shut_down(self) -> None:
        """No more pictures."""
        self._gather.stop()
        self._rest.stop()
        self._drawer = None

    def rects(self) -> list[QRectF]:
        """Of the viewports, logical pixels."""
        return self._rects(len(self.panes))

    def _rects(self, count: int) -> list[QRectF]:
        edges = split(self.width(), max(count, 1))
        return [QRectF(begin, 0.0, end - begin, self.height()) for begin, end in edges]

    def _fit_if_untouched(self, pane: Pane) -> None:
        """Fit at the first sight, and when the scene has outgrown the picture that the person has not changed."""
        if not pane.untouched:
            return
        every = (*pane.scene.items, *pane.extras)
        outline = outline_of(every if pane.whole else wanted_items(pane.scene, pane.extras))
        if not len(outline):
            return
        rect = self.rects()[self.panes.index(pane)]
        box = np.stack([outline.min(axis=0), outline.max(axis=0)])
        right = bar_share(pane.scene, QFontMetricsF(self.font()), rect.width())
        top = top_share(pane.scene, self._word, self.font(), rect)
        bottom = min(self.keep_free.height() / max(rect.height(), 1.0), 0.2)
        same = pane.margins == (right, top, bottom)
        if pane.box is not None and same:
            size = float(np.linalg.norm(pane.box[1] - pane.box[0])) or 1.0
            pixels, depth = pane.camera.project(outline, rect.width(), rect.height())
            inside = (pixels >= 0.0).all() and (pixels <= (rect.width(), rect.height())).all() and (depth > 0.0).all()
            if inside and float(np.linalg.norm(box[1] - box[0])) > 0.5 * size:
                return
        pane.box = box
        pane.margins = (right, top, bottom)
        # The camera's picture fills the viewport; what is left of it for the scene is narrower and lower.
        free = 1.0 - top - bottom
        fitted = pane.camera.fitted(outline, rect.width() * (1.0 - right) / max(rect.height() * free, 1.0))
        fitted = replace(fitted, distance=fitted.distance / free)
        pane.camera = fitted.moved(-0.5 * right * rect.width(), 0.5 * (top - bottom) * rect.height(), rect.height())

    # --- pictures

    def _ask(self) -> None:
        if self._drawer is None or self._in_flight or not self.panes or not self.isVisible():
            return
        ratio = self.devicePixelRatioF()
        self._sharp = not (self._interacting and self._sharp_seconds > SLOW_S)
        if not self._sharp:
            ratio *= 0.5
        width, height = max(round(self.width() * ratio), 16), max(round(self.height() * ratio), 16)
        views = []
        for pane in self.panes:
            views.append(
                ViewRequest(
                    pane.camera.position,
                    pane.camera.target,
                    pane.camera.rotation[1],
                    float(np.rad2deg(ANGLE_RAD)),
                    None if pane.items_sent else pane.scene.items,
                    None if pane.extras_sent else pane.extras,
                    pane.hover_face,
                )
            )
            pane.items_sent = pane.extras_sent = True
        self._asked = [Seen(pane, pane.scene, pane.extras, pane.camera) for pane in self.panes]
        self._dirty, self._in_flight = False, True
        palette = {str(role): colour(role) for role in Role} | {BACKGROUND: colour(BACKGROUND)}
        self._drawer.submit(Request(width, height, ratio, tuple(views), palette))

    def _take(self, picture: Picture) -> None:
        self._in_flight = False
        self._keep(picture)
        self.seconds = picture.seconds
        if self._sharp:
            self._sharp_seconds = picture.seconds
        self._seen = self._asked
        for seen in self._seen:
            seen.pane.drawn_with = seen.camera
        self.update()
        if self._dirty:
            self._gather.start()
        self.picture_shown.emit()

    def _keep(self, picture: Picture) -> None:
        height, width, _ = picture.pixels.shape
        self._pixels = picture.pixels  # the image reads from it
        self._picture = QImage(picture.pixels.data, width, height, 4 * width, QImage.Format.Format_RGB32)

    def _at_rest(self) -> None:
        self._interacting = False
        if not self._sharp:
            self.redraw()

    def paintEvent(self, event: QPaintEvent) -> None:  # noqa: N802  (Qt's name)
        """The picture, and what is written over it."""
        painter = QPainter(self)
        if not self._has_picture() or not self.panes:
            painter.fillRect(self.rect(), QColor(colour(BACKGROUND)))
            painter.setPen(QColor(colour("muted")))
            painter.drawText(self.rect(), Qt.AlignmentFlag.AlignCenter | Qt.TextFlag.TextWordWrap, self.notice)
            return
        self._paint_picture(painter)
        rects = self._rects(len(self._seen))
        for seen, rect in zip(self._seen, rects, strict=True):
            taken = rect.right() - (self.width() - self.keep_free.width())
            free = QSizeF(taken, self.keep_free.height()) if taken > 0.0 else QSizeF(0.0, 0.0)
            now = seen.pane.scene is seen.scene
            pins, hover = (seen.pane.pins, seen.pane.hover_at) if now else ((), None)
            paint(painter, Overlay(seen.scene, seen.extras, seen.camera, rect, self._word, pins, hover, free))
        painter.setPen(QColor(colour("line")))
        for rect in rects[1:]:
            painter.drawLine(rect.topLeft(), rect.bottomLeft())
        if self.hasFocus():
            painter.setPen(QColor(colour("accent")))
            painter.drawRect(self.rect().adjusted(0, 0, -1, -1))

    def _has_picture(self) -> bool:
        return not self._picture.isNull()

    def _paint_picture(self, painter: QPainter) -> None:
        if self._picture.size() == self.size() * self.devicePixelRatioF():
            self._picture.setDevicePixelRatio(self.devicePixelRatioF())
            painter.drawImage(QPoint(0, 0), self._picture)
        else:
            self._picture.setDevicePixelRatio(1.0)
            painter.drawImage(QRectF(self.rect()), self._picture)

    def _word(self, text: str) -> str:
        if text not in self._words:
            if len(self._words) > 500:
                self._words.clear()
            self._words[text] = sentence(text)
        return self._words[text]

    def resizeEvent(self, event: QResizeEvent) -> None:  # noqa: N802  (Qt's name)
        """A picture of the new size."""
        super().resizeEvent(event)
        for pane in self.panes:
            if pane.untouched:
                pane.box = None
                self._fit_if_untouched(pane)
        self.redraw()

    def showEvent(self, event: QShowEvent) -> None:  # noqa: N802  (Qt's name)
        """What was held back while nobody looked is drawn now."""
        super().showEvent(event)
        self.redraw()

    # --- the hand

    def hit(self, at: QPointF) -> tuple[Hit | None, int]:
        """What a click at a place of this widget picks, and in which viewport."""
        number = self._number_at(at)
        pane, rect = self.panes[number], self.rects()[number]
        camera = pane.drawn_with or pane.camera
        local = at - rect.topLeft()
        found = pick(pane.scene, camera, local.x(), local.y(), rect.width(), rect.height(), self.pick_mode)
        return found, number

    def _number_at(self, at: QPointF) -> int:
        return next((number for number, rect in enumerate(self.rects()) if at.x() < rect.right()), len(self.panes) - 1)

    def mousePressEvent(self, event: QMouseEvent) -> None:  # noqa: N802  (Qt's name)
        """A click or a drag begins."""
        if self.panes:
            self._pressed = self._last = event.position()
            self._dragging = False
            self._held = self.panes[self._number_at(event.position())]
            self._hover(None)

    def mouseMoveEvent(self, event: QMouseEvent) -> None:  # noqa: N802  (Qt's name)
        """Turn (left), move (right, middle, or left with Shift); without a button show what a click would pick."""
        here = event.position()
        if self._pressed is None or self._held not in self.panes:
            self._hover(here)
            return
        if not self._dragging:
            far = (here - self._pressed).manhattanLength() >= QGuiApplication.styleHints().startDragDistance()
            if not far:
                return
            self._dragging = True
        step = here - self._last
        self._last = here
        pane = self._held
        shift = bool(event.modifiers() & Qt.KeyboardModifier.ShiftModifier)
        if event.buttons() & Qt.MouseButton.LeftButton and not shift:
            pane.camera = pane.camera.turned(step.x() * TURN_RAD_PER_PX, step.y() * TURN_RAD_PER_PX)
        else:
            pane.camera = pane.camera.moved(step.x(), step.y(), self.height())
        self._touched(pane)

    def mouseReleaseEvent(self, event: QMouseEvent) -> None:  # noqa: N802  (Qt's name)
        """The end of a drag, or a click that picks."""
        clicked = self._pressed is not None and not self._dragging and event.button() == Qt.MouseButton.LeftButton
        self._pressed, self._held = None, None
        if clicked and self.pick_mode != "none" and self.panes:
            found, number = self.hit(event.position())
            if found is not None:
                self.clicked_on.emit(found, number)

    def mouseDoubleClickEvent(self, event: QMouseEvent) -> None:  # noqa: N802  (Qt's name)
        """Everything into the picture again, where clicks mean nothing else."""
        if self.pick_mode == "none":
            self.look("fit")

    def wheelEvent(self, event: QWheelEvent) -> None:  # noqa: N802  (Qt's name)
        """Nearer or farther, about what is under the pointer."""
        turns = event.angleDelta().y() / 120.0
        if not self.panes or not turns:
            return
        number = self._number_at(event.position())
        pane, rect = self.panes[number], self.rects()[number]
        local = event.position() - rect.topLeft()
        pane.camera = pane.camera.zoomed(ZOOM_STEP**turns, local.x(), local.y(), rect.width(), rect.height())
        self._touched(pane)
        event.accept()

    def keyPressEvent(self, event: QKeyEvent) -> None:  # noqa: N802  (Qt's name)
        """F fits, 1 to 4 are the views, the arrows turn, + and - zoom."""
        key = event.key()
        allowed = Qt.KeyboardModifier.KeypadModifier | Qt.KeyboardModifier.ShiftModifier
        if not self.panes or event.modifiers() & ~allowed:
            super().keyPressEvent(event)
        elif key in VIEW_KEYS:
            self.look(VIEW_KEYS[key])
        elif key in TURN_KEYS:
            right, up = TURN_KEYS[key]
            for pane in self.panes:
                pane.camera = pane.camera.turned(right * KEY_TURN_RAD, up * KEY_TURN_RAD)
                self._touched(pane)
        elif key in (Qt.Key.Key_Plus, Qt.Key.Key_Equal, Qt.Key.Key_Minus):
            factor = 1.0 / ZOOM_STEP if key == Qt.Key.Key_Minus else ZOOM_STEP
            for pane in self.panes:
                pane.camera = pane.camera.zoomed(factor, 0.0, 0.0, 0.0, 0.0)
                self._touched(pane)
        else:
            super().keyPressEvent(event)

    def leaveEvent(self, event: QEvent) -> None:  # noqa: N802  (Qt's name)
        """Nothing is under the pointer any more."""
        super().leaveEvent(event)
        self._hover(None)

    def _touched(self, pane: Pane) -> None:
        pane.untouched = False
        self._busy(REST_MS)
        self.redraw()

    def _busy(self, rest_ms: int) -> None:
        self._interacting = True
        self._rest.start(rest_ms)

    def _hover(self, at: QPointF | None) -> None:
        if self.pick_mode == "none" or not self.panes:
            return
        if at is not None and self._hovered.isValid() and self._hovered.elapsed() < HOVER_MS:
            return
        self._hovered.start()
        found, number = (None, -1) if at is None else self.hit(at)
        for place, pane in enumerate(self.panes):
            hit = found if place == number else None
            face = hit.face_id if hit is not None and self.pick_mode == "face" else None
            pane.hover_at = None
            if hit is not None and self.pick_mode == "point":
                rect = self.rects()[place]
                camera = pane.drawn_with or pane.camera
                pixel, _ = camera.project(hit.xyz, rect.width(), rect.height())
                pane.hover_at = QPointF(*pixel[0])
            if face != pane.hover_face:
                pane.hover_face = face
                self.redraw()
        self.setCursor(Qt.CursorShape.CrossCursor if found is not None else Qt.CursorShape.ArrowCursor)
        self.update()

    def changeEvent(self, event: QEvent) -> None:  # noqa: N802  (Qt's name)
        """Texts of another language."""
        if event.type() == QEvent.Type.LanguageChange:
            self.forget_words()
        super().changeEvent(event)
