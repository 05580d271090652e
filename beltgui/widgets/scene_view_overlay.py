"""What is written over the picture: title, legend, colour bar, names, axes, scale.

Painted by Qt, so that every language and every screen density comes out crisp.
"""

from __future__ import annotations

import re
from collections.abc import Callable, Sequence
from dataclasses import dataclass, field
from functools import lru_cache

import numpy as np
from PySide6.QtCore import QPointF, QRectF, QSizeF, Qt
from PySide6.QtGui import QColor, QFont, QFontMetricsF, QImage, QPainter, QPainterPath, QPen

from beltgui.app.theme import colour
from beltgui.viewmodel.scene import Arrow, Frame, Item, Label, Mesh, Points, Role, Scale, Scene
from beltgui.widgets.scene_draw_colours import TABLES
from beltgui.widgets.scene_view_camera import Camera

# An item whose name begins so is drawn but its name is not written.
UNWRITTEN = "~"
MOST_LABELS = 80
MOST_TICKS = 5
MOST_LINES = 3
LEADING = 1.25
# A heading narrower than this share of its viewport leaves room for the scene beside it.
BESIDE = 0.6
WORDS = re.compile(r"[\u2e80-\u9fff\uff00-\uffef]|[^\s\u2e80-\u9fff\uff00-\uffef]+\s*|\s+")
RIM = 3.5
AXES = ((Role.X, "x"), (Role.Y, "y"), (Role.Z, "z"))


@dataclass(frozen=True, eq=False)
class Pin:
    """A picked place, shown as a ring with a name: `at` (3,) mm in the scene's frame."""

    at: np.ndarray
    name: str
    role: Role = Role.CHOSEN


@dataclass(frozen=True, eq=False)
class Overlay:
    """What is to be written over one viewport.

    Attributes:
        scene: What the viewport shows.
        extras: Items beyond the scene's own.
        camera: The one that the picture was drawn with.
        rect: Of the viewport, logical pixels.
        words: A text in the language of the screen.
        pins: Picked places.
        hover: Pixel of what a click would pick; None without.
        keep_free: Size at the lower right that belongs to buttons.
    """

    scene: Scene
    extras: tuple[Item, ...]
    camera: Camera
    rect: QRectF
    words: Callable[[str], str]
    pins: Sequence[Pin] = ()
    hover: QPointF | None = None
    keep_free: QSizeF = field(default_factory=lambda: QSizeF(0.0, 0.0))
    placed: list[QRectF] = field(default_factory=list)


def paint(painter: QPainter, overlay: Overlay) -> None:
    """Write all of it."""
    painter.save()
    painter.setClipRect(overlay.rect)
    painter.translate(overlay.rect.topLeft())
    painter.setRenderHint(QPainter.RenderHint.Antialiasing)
    _title_and_legend(painter, overlay)
    _bars(painter, overlay)
    _axes_and_scale(painter, overlay)
    _names(painter, overlay)
    _pins(painter, overlay)
    if overlay.hover is not None:
        painter.setBrush(Qt.BrushStyle.NoBrush)
        painter.setPen(QPen(QColor(colour(Role.SUGGESTION)), 2.0))
        painter.drawEllipse(overlay.hover, 7.0, 7.0)
    painter.restore()


def written(painter: QPainter, at: QPointF, text: str, shade: str, font: QFont | None = None) -> None:
    """Text with its baseline at a place, with a rim in the background's colour so that it reads on everything."""
    font = font or painter.font()
    ratio = painter.device().devicePixelRatioF()
    image, ascent = _lettering(text, shade, colour("scene"), font.toString(), ratio)
    painter.drawImage(QPointF(round(at.x()) - RIM, round(at.y()) - ascent - RIM), image)


@lru_cache(maxsize=400)
def _lettering(text: str, shade: str, rim: str, font_key: str, ratio: float) -> tuple[QImage, float]:
    """Text as an image, and its ascent; outlines take a tenth of a millisecond each letter, so they are kept."""
    font = QFont()
    font.fromString(font_key)
    metrics = QFontMetricsF(font)
    ascent = float(round(metrics.ascent()))
    wide, high = metrics.horizontalAdvance(text) + 3.0 * RIM, metrics.height() + 2.0 * RIM
    image = QImage(
        max(1, round(wide * ratio)), max(1, round(high * ratio)), QImage.Format.Format_ARGB32_Premultiplied
    )
    image.setDevicePixelRatio(ratio)
    image.fill(Qt.GlobalColor.transparent)
    path = QPainterPath()
    path.addText(QPointF(RIM, RIM + ascent), font, text)
    painter = QPainter(image)
    painter.setRenderHint(QPainter.RenderHint.Antialiasing)
    painter.strokePath(path, QPen(QColor(rim), RIM, j=Qt.PenJoinStyle.RoundJoin))
    painter.fillPath(path, QColor(shade))
    painter.end()
    return image, ascent


def wrapped(text: str, metrics: QFontMetricsF, room: float) -> list[str]:
    """A text in lines no wider than `room` pixels, broken at spaces, and anywhere in Chinese; at most `MOST_LINES`."""
    lines = [""]
    for word in WORDS.findall(text):
        if lines[-1] and metrics.horizontalAdvance((lines[-1] + word).rstrip()) > room and len(lines) < MOST_LINES:
            lines.append("")
        lines[-1] += word
    return [metrics.elidedText(line.strip(), Qt.TextElideMode.ElideRight, room) for line in lines]


@dataclass(frozen=True, eq=False)
class _Heading:
    """Title and legend, broken into lines for a viewport; `high` and `wide` with the pad around them, pixels."""

    title: list[str]
    legend: list[tuple[Role, list[str]]]
    pad: float
    side: float
    high: float
    wide: float


def _heading(scene: Scene, words: Callable[[str], str], font: QFont, width: float) -> _Heading:
    bold, small = QFontMetricsF(_bold(font)), QFontMetricsF(font)
    pad, side = 0.6 * bold.height(), 0.7 * small.ascent()
    room = width - 2.0 * pad
    frame = small.horizontalAdvance(_frame_text(scene))
    title = wrapped(words(scene.title), bold, room - frame)
    legend = [(role, wrapped(words(text), small, room - 1.7 * side)) for role, text in scene.legend]
    lines = [line for _, texts in legend for line in texts]
    widest = max([bold.horizontalAdvance(title[-1]) + frame, *(bold.horizontalAdvance(line) for line in title),
                  *(1.7 * side + small.horizontalAdvance(line) for line in lines)])  # fmt: skip
    high = pad + len(title) * bold.height() + LEADING * len(lines) * small.height() + 0.4 * small.height()
    return _Heading(title, legend, pad, side, high, pad + widest)


def _bold(font: QFont) -> QFont:
    font = QFont(font)
    font.setBold(True)
    return font


def _frame_text(scene: Scene) -> str:
    return f"  {{{scene.frame}}}, mm"


def _title_and_legend(painter: QPainter, overlay: Overlay) -> None:
    font = _bold(painter.font())
    bold, small = QFontMetricsF(font), QFontMetricsF(painter.font())
    heading = _heading(overlay.scene, overlay.words, painter.font(), overlay.rect.width())
    pad, side = heading.pad, heading.side
    y = pad + bold.ascent() - bold.height()
    for line in heading.title:
        y += bold.height()
        written(painter, QPointF(pad, y), line, colour("text"), font)
    end = pad + bold.horizontalAdvance(heading.title[-1])
    written(painter, QPointF(end, y), _frame_text(overlay.scene), colour("muted"))
    for role, lines in heading.legend:
        painter.setPen(QPen(QColor(colour("scene")), 1.0))
        painter.setBrush(QColor(colour(role)))
        top = y + LEADING * small.height() - side
        painter.drawRoundedRect(QRectF(pad, top, side, side), 2.0, 2.0)
        for line in lines:
            y += LEADING * small.height()
            written(painter, QPointF(pad + 1.7 * side, y), line, colour("text"))
    overlay.placed.append(QRectF(0.0, 0.0, heading.wide, heading.high))


def scales_of(scene: Scene) -> list[Scale]:
    """The scales that the scene's values are coloured by, each once."""
    found: list[Scale] = []
    for item in scene.items:
        if isinstance(item, Points | Mesh) and item.values is not None and item.scale and item.scale not in found:
            found.append(item.scale)
    return found


def round_ticks(low: float, high: float) -> list[float]:
    """Round numbers within a range, at most `MOST_TICKS`, rising: steps of 1, 2 or 5 times a power of ten."""
    span = high - low
    if not (np.isfinite(span) and span > 0.0):
        return [low]
    decade = 10.0 ** np.floor(np.log10(span / MOST_TICKS))
    for factor in (1.0, 2.0, 2.5, 5.0, 10.0, 20.0):
        step = factor * decade
        first, last = np.ceil(low / step - 1e-9), np.floor(high / step + 1e-9)
        if last - first < MOST_TICKS:
            break
    return [float(step * place) for place in np.arange(first, last + 1.0)]


def tick_text(value: float, unit: str, *, signed: bool) -> str:
    """A number as a person writes it, `+1000 µm`: no exponent from 0.001 to 99999; `signed` writes the plus."""
    size = abs(value)
    if size < 1e-12:
        text = "0"
    elif 0.001 <= size < 99999.5:
        decimals = min(max(2 - int(np.floor(np.log10(size))), 0), 6)
        text = f"{size:.{decimals}f}"
        text = text.rstrip("0").rstrip(".") if "." in text else text
    else:
        text = f"{size:.3g}"
    sign = "" if text == "0" else "\u2212" if value < 0.0 else "+" if signed else ""
    return f"{sign}{text} {unit}".rstrip()


def _quantity(title: str) -> str:
    """`signed distance, µm` without its unit, in any language: the ticks have it."""
    return re.sub(r"\s*[,，、]\s*[^\s,，、]*$", "", title)


def _bars(painter: QPainter, overlay: Overlay) -> None:
    metrics = QFontMetricsF(painter.font())
    line = metrics.height()
    right = overlay.rect.width() - 0.8 * line
    height = min(0.45 * overlay.rect.height(), 16.0 * line)
    lowest = overlay.rect.height() - overlay.keep_free.height() - 1.5 * line
    bottom = min(0.5 * (overlay.rect.height() + height) + line, lowest)
    for scale in scales_of(overlay.scene)[:2]:
        ticks, wide = _ticks_of(scale, metrics)
        bar = QRectF(right - wide - 1.4 * line, bottom - height, 0.9 * line, height)
        table = np.ascontiguousarray(TABLES[scale.kind][::-1])
        image = QImage(table.tobytes(), 1, len(table), 3, QImage.Format.Format_RGB888)
        painter.drawImage(bar, image)
        painter.setBrush(Qt.BrushStyle.NoBrush)
        painter.setPen(QPen(QColor(colour("line")), 1.0))
        painter.drawRect(bar)
        span = max(scale.high - scale.low, 1e-300)
        for value, text in ticks:
            y = bar.bottom() - bar.height() * (value - scale.low) / span
            painter.setPen(QPen(QColor(colour("muted")), 1.0))
            painter.drawLine(QPointF(bar.right(), y), QPointF(bar.right() + 0.25 * line, y))
            written(painter, QPointF(bar.right() + 0.4 * line, y + 0.35 * metrics.ascent()), text, colour("text"))
        words = _quantity(overlay.words(scale.title))
        words = metrics.elidedText(words, Qt.TextElideMode.ElideRight, 0.6 * overlay.rect.width())
        across = metrics.horizontalAdvance(words)
        written(painter, QPointF(right - across, bar.top() - 0.7 * line), words, colour("text"))
        overlay.placed.append(QRectF(bar.left(), bar.top() - 2.0 * line, right - bar.left(), height + 3.0 * line))
        right = min(bar.left(), right - across) - line


def _axes_and_scale(painter: QPainter, overlay: Overlay) -> None:
    """Which way x, y, z point in this picture, and how long some mm are in the plane of the middle."""
    line = QFontMetricsF(painter.font()).height()
    size = 1.7 * line
    crowded = overlay.rect.width() < overlay.keep_free.width() + 15.0 * line
    floor = overlay.rect.height() - 0.8 * line - (overlay.keep_free.height() if crowded else 0.0)
    middle = QPointF(0.8 * line + size, floor - size)
    order = sorted(range(3), key=lambda axis: overlay.camera.rotation[2, axis])
    for axis in order:
        right, up = overlay.camera.rotation[0, axis], overlay.camera.rotation[1, axis]
        role, name = AXES[axis]
        tip = middle + QPointF(size * right, -size * up)
        painter.setPen(QPen(QColor(colour(role)), 2.0))
        painter.drawLine(middle, tip)
        beside = middle + QPointF(1.25 * size * right - 0.2 * line, -1.25 * size * up + 0.25 * line)
        written(painter, beside, name, colour(role))
    mm = overlay.camera.mm_per_pixel(overlay.rect.height()) * 7.0 * line
    step = 10.0 ** np.floor(np.log10(mm))
    length = max(step * factor for factor in (1.0, 2.0, 5.0) if step * factor <= mm)
    pixels = length / overlay.camera.mm_per_pixel(overlay.rect.height())
    left = QPointF(middle.x() + 1.9 * size, floor)
    painter.setPen(QPen(QColor(colour("muted")), 2.0))
    painter.drawLine(left, left + QPointF(pixels, 0.0))
    for end in (left, left + QPointF(pixels, 0.0)):
        painter.drawLine(end, end - QPointF(0.0, 0.3 * line))
    written(painter, left + QPointF(0.0, -0.45 * line), f"{length:g} mm", colour("muted"))


def labels_of(items: Sequence[Item]) -> list[tuple[np.ndarray, str, Role, bool]]:
    """Place (3,), text, role, and whether the text is a sentence to translate, of all that is written in the scene."""
    found: list[tuple[np.ndarray, str, Role, bool]] = []
    for item in items:
        if isinstance(item, Label):
            found.append((np.asarray(item.at, dtype=float), item.text, item.role, True))
        elif isinstance(item, Arrow) and item.label:
            found.append((np.asarray(item.start, float) + np.asarray(item.vector, float), item.label, item.role, True))
        elif isinstance(item, Frame) and not item.name.startswith(UNWRITTEN):
            pose = np.asarray(item.scene_from_frame, dtype=float)
            found.append((pose[:3, 3], item.name, Role.MUTED, False))
            for axis, (role, name) in enumerate(AXES):
                found.append((pose[:3, 3] + 1.08 * item.length_mm * pose[:3, axis], name, role, False))
    return found


def _names(painter: QPainter, overlay: Overlay) -> None:
    labels = labels_of((*overlay.scene.items, *overlay.extras))[:MOST_LABELS]
    if not labels:
        return
    metrics = QFontMetricsF(painter.font())
    places = np.stack([at for at, *_ in labels])
    pixels, depth = overlay.camera.project(places, overlay.rect.width(), overlay.rect.height())
    for (x, y), away, (_, text, role, translate) in zip(pixels, depth, labels, strict=True):
        if away <= 0.0 or not (0.0 <= x <= overlay.rect.width() and 0.0 <= y <= overlay.rect.height()):
            continue
        text = overlay.words(text) if translate else text
        shade = colour("text") if role is Role.MUTED else colour(role)
        box = _free_place(overlay, x, y, metrics.horizontalAdvance(text), metrics.height())
        overlay.placed.append(box)
        written(painter, QPointF(box.left(), box.top() + metrics.ascent()), text, shade)


def _free_place(overlay: Overlay, x: float, y: float, wide: float, high: float) -> QRectF:
    """Beside a pixel, within the viewport, on nothing that is written already if there is such a place."""
    first = None
    left_of = -4.0 - wide
    for left, top in ((4.0, -0.8), (left_of, -0.8), (4.0, 0.2), (left_of, 0.2), (4.0, -1.8), (4.0, 1.2), (4.0, 2.2)):
        box = QRectF(x + left, y + top * high, wide, high)
        box.moveLeft(min(max(box.left(), 2.0), max(overlay.rect.width() - wide - 2.0, 2.0)))
        first = first or box
        if not any(box.intersects(other) for other in overlay.placed):
            return box
    return first


def bar_share(scene: Scene, metrics: QFontMetricsF, width: float) -> float:
    """Which part of a viewport's width the colour bars need."""
    needed = sum(_ticks_of(scale, metrics)[1] + 3.6 * metrics.height() for scale in scales_of(scene)[:2])
    return min(needed / max(width, 1.0), 0.4)


def top_share(scene: Scene, words: Callable[[str], str], font: QFont, rect: QRectF) -> float:
    """Which part of a viewport's height title and legend need; where it is wide, the scene has room beside them."""
    heading = _heading(scene, words, font, rect.width())
    high = 1.8 * QFontMetricsF(font).height() if heading.wide < BESIDE * rect.width() else heading.high
    return min(high / max(rect.height(), 1.0), 0.4)


def _ticks_of(scale: Scale, metrics: QFontMetricsF) -> tuple[list[tuple[float, str]], float]:
    """Values and texts of a bar, and the width of the widest text."""
    unit = scale.title.rpartition(", ")[2]
    values = round_ticks(scale.low, scale.high)
    ticks = [(value, tick_text(value, unit, signed=scale.kind == "diverging")) for value in values]
    return ticks, max(metrics.horizontalAdvance(text) for _, text in ticks)


def _pins(painter: QPainter, overlay: Overlay) -> None:
    if not overlay.pins:
        return
    places = np.stack([np.asarray(pin.at, dtype=float) for pin in overlay.pins])
    pixels, depth = overlay.camera.project(places, overlay.rect.width(), overlay.rect.height())
    for (x, y), away, pin in zip(pixels, depth, overlay.pins, strict=True):
        if away <= 0.0:
            continue
        painter.setBrush(Qt.BrushStyle.NoBrush)
        for shade, wide in ((colour("scene"), 5.0), (colour(pin.role), 2.5)):
            painter.setPen(QPen(QColor(shade), wide))
            painter.drawEllipse(QPointF(x, y), 7.0, 7.0)
        written(painter, QPointF(x + 11.0, y - 6.0), pin.name, colour(pin.role))
