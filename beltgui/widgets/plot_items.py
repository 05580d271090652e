"""Series of a plot as pyqtgraph items that are made once and then updated in place."""

from __future__ import annotations

from typing import Any

import numpy as np
import pyqtgraph as pg
from PySide6.QtCore import QRectF, Qt
from PySide6.QtGui import QColor

from beltgui.app.theme import colour, px
from beltgui.viewmodel.plot import Band, Bars, Curve, Map, Marks, Series
from beltgui.viewmodel.scene import Role, Scale
from beltgui.widgets.plot_dots import DotsItem
from beltgui.widgets.scene_draw_colours import TABLES

# A role is told by shape too, not by colour alone: (pyqtgraph's symbol, sign in the legend).
SYMBOLS = {
    Role.OUTLIER: ("x", "✕"),
    Role.ATTENTION: ("x", "✕"),
    Role.HELD_OUT: ("d", "◆"),
    Role.EXCLUDED: ("+", "＋"),
    Role.SUGGESTION: ("star", "★"),
    Role.CHOSEN: ("s", "■"),
    Role.FIT: ("s", "■"),
    Role.PATH_COMPENSATED: ("t1", "▲"),
}
USUAL = ("o", "●")
# Above this many marks they are drawn small, above the larger number as dots.
MANY, DOTS = 500, 2000
MARK_PX, SMALL_PX = 9, 4


class MarksItem(pg.ScatterPlotItem):
    """Marks that know their samples; held here and not in each mark, which would be slow."""

    sample_ids: np.ndarray | None = None

    def sample_id(self, place: int) -> int | None:
        """Of the mark at a place; None if marks stand for no samples."""
        return None if self.sample_ids is None else int(self.sample_ids[place])


def sign(series: Series) -> str:
    """How a series looks in one character, for the legend."""
    if isinstance(series, Marks):
        return SYMBOLS.get(series.role, USUAL)[1]
    if isinstance(series, Curve):
        return "┅" if series.dashed else "━"
    return "▆"


def kind_of(series: Series) -> str:
    """Series of the same kind can be shown in the same item."""
    dots = isinstance(series, Marks) and len(series.x) > DOTS
    return "dots" if dots else type(series).__name__


def make_item(series: Series) -> Any:
    """An empty item for such a series."""
    if kind_of(series) == "dots":
        return DotsItem()
    if isinstance(series, Marks):
        return MarksItem(pxMode=True, hoverable=False)
    if isinstance(series, Curve):
        return pg.PlotCurveItem(connect="finite")
    if isinstance(series, Bars):
        return pg.BarGraphItem(x=[0.0], height=[0.0], width=0.8)
    if isinstance(series, Band):
        lower, upper = pg.PlotCurveItem(), pg.PlotCurveItem()
        return pg.FillBetweenItem(lower, upper)
    return pg.ImageItem(axisOrder="row-major")


def fill_item(item: Any, series: Series) -> None:
    """Show a series in the item made for its kind, in the theme's present colours."""
    if isinstance(series, Marks):
        _fill_marks(item, series)
    elif isinstance(series, Curve):
        style = Qt.PenStyle.DashLine if series.dashed else Qt.PenStyle.SolidLine
        item.setData(_floats(series.x), _floats(series.y), pen=pg.mkPen(colour(series.role), width=2, style=style))
    elif isinstance(series, Bars):
        item.setOpts(
            x=_floats(series.x), height=np.nan_to_num(_floats(series.height)), width=series.width * _spacing(series),
            brush=_pale(series.role, 170), pen=pg.mkPen(colour(series.role)),
        )  # fmt: skip
    elif isinstance(series, Band):
        good = np.isfinite(series.low) & np.isfinite(series.high) & np.isfinite(series.x)
        item.curves[0].setData(_floats(series.x)[good], _floats(series.low)[good])
        item.curves[1].setData(_floats(series.x)[good], _floats(series.high)[good])
        item.setBrush(_pale(series.role, 60))
    else:
        _fill_map(item, series)


def _fill_marks(item: Any, series: Marks) -> None:
    x, y = _floats(series.x), _floats(series.y)
    good = np.isfinite(x) & np.isfinite(y)
    if len(series.sample_ids) == len(x):
        item.sample_ids = np.asarray(series.sample_ids, dtype=int)[good]
    else:
        item.sample_ids = None
    if isinstance(item, DotsItem):
        item.show_dots(x[good], y[good], QColor(colour(series.role)))
        return
    many = len(x) > MANY
    symbol = SYMBOLS.get(series.role, USUAL)[0]
    ink = QColor(colour(series.role))
    thin = symbol in ("x", "+")
    pen = pg.mkPen(ink, width=2) if thin and not many else None
    item.setData(x=x[good], y=y[good], symbol=symbol, size=px(SMALL_PX if many else MARK_PX),
                 pen=pen, brush=pg.mkBrush(ink))  # fmt: skip


def _spacing(series: Bars) -> float:
    """Distance between bars, of which `width` is a share; bars with words stand 1 apart."""
    places = np.unique(_floats(series.x))
    return 1.0 if series.labels or len(places) < 2 else float(np.median(np.diff(places)))


def _fill_map(item: Any, series: Map) -> None:
    values = np.asarray(series.values, np.float32)
    item.setImage(values, autoLevels=False, levels=(series.scale.low, series.scale.high))
    item.setColorMap(colour_map(series.scale))
    (left, right), (bottom, top) = series.x_range, series.y_range
    item.setRect(QRectF(left, bottom, right - left, top - bottom))


def colour_map(scale: Scale) -> pg.ColorMap:
    """The same colours as in the 3D picture."""
    table = TABLES[scale.kind]
    return pg.ColorMap(np.linspace(0.0, 1.0, len(table)), table)


def _pale(role: Role, alpha: int) -> QColor:
    ink = QColor(colour(role))
    ink.setAlpha(alpha)
    return ink


def _floats(values: Any) -> np.ndarray:
    return np.asarray(values, float).ravel()
