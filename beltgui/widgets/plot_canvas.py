"""One plot: series updated in place, zoom kept, a legend beside it and not over it, units as they are."""

from __future__ import annotations

import html
from typing import Any

import numpy as np
import pyqtgraph as pg
from PySide6.QtCore import Qt, Signal
from PySide6.QtGui import QFont, QFontMetrics, QKeyEvent
from PySide6.QtWidgets import QLabel, QVBoxLayout, QWidget

from beltgui.app.language import sentence
from beltgui.app.theme import colour, px, theme
from beltgui.viewmodel.plot import Band, Bars, Curve, Map, Marks, Plot, Series
from beltgui.viewmodel.scene import Role
from beltgui.widgets.plot_items import colour_map, fill_item, kind_of, make_item, sign


class PlotCanvas(QWidget):
    """Shows one `Plot` after another of the same key.

    Signals:
        chosen: Sample id of the mark that was clicked.
    """

    chosen = Signal(int)

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self._plot: Plot | None = None
        self._items: list[Any] = []
        self._kinds: list[str] = []
        self._limits: list[Any] = []
        self._bar: Any = None
        self._chosen: int | None = None
        self.legend = QLabel(self)
        self.legend.setTextFormat(Qt.TextFormat.RichText)
        self.legend.setWordWrap(True)
        self.graph = pg.PlotWidget(self)
        self.graph.setMenuEnabled(False)
        self.graph.hideButtons()
        self.graph.setFocusPolicy(Qt.FocusPolicy.StrongFocus)
        self.graph.setMinimumSize(0, 0)
        self._ring = pg.ScatterPlotItem(pxMode=True, size=18)
        self._ring.setZValue(50)
        self.graph.addItem(self._ring, ignoreBounds=True)
        layout = QVBoxLayout(self)
        layout.setContentsMargins(2, 2, 2, 2)
        layout.setSpacing(0)
        layout.addWidget(self.legend)
        layout.addWidget(self.graph, 1)
        for side in ("left", "bottom"):
            self.graph.getAxis(side).enableAutoSIPrefix(False)
        theme().changed.connect(self.rethemed)
        self._style()

    @property
    def plot(self) -> Plot | None:
        """What is shown."""
        return self._plot

    def show_plot(self, plot: Plot) -> None:
        """Show a plot; a zoom that the person chose stays."""
        self._plot = plot
        kinds = [kind_of(series) for series in plot.series]
        if kinds != self._kinds:
            self._make(plot)
        for item, series in zip(self._items, plot.series, strict=True):
            fill_item(item, series)
        self._draw_limits(plot)
        self._draw_colour_bar(plot)
        self._draw_words(plot)
        self.choose(self._chosen)

    def choose(self, sample_id: int | None) -> None:
        """Ring the marks of a sample; None for none."""
        self._chosen = sample_id
        places: list[tuple[float, float]] = []
        for series in self._plot.series if self._plot is not None and sample_id is not None else ():
            if isinstance(series, Marks) and sample_id in series.sample_ids:
                place = series.sample_ids.index(sample_id)
                x, y = float(series.x[place]), float(series.y[place])
                if np.isfinite([x, y]).all():
                    places.append((x, y))
        self._ring.setData(pos=np.array(places).reshape(-1, 2))

    def whole(self) -> None:
        """Show all of it again."""
        self.graph.enableAutoRange()

    def zoomed(self) -> bool:
        """Whether the person has chosen a part."""
        return not all(self.graph.getViewBox().autoRangeEnabled())

    def rethemed(self) -> None:
        """Draw again in the theme's colours."""
        self._style()
        if self._plot is not None:
            self.show_plot(self._plot)

    def keyPressEvent(self, event: QKeyEvent) -> None:  # noqa: N802
        """Home shows all, plus and minus zoom."""
        steps = {Qt.Key.Key_Plus: 0.8, Qt.Key.Key_Minus: 1.25}
        if event.key() == Qt.Key.Key_Home:
            self.whole()
        elif event.key() in steps:
            factor = steps[Qt.Key(event.key())]
            self.graph.getViewBox().scaleBy((factor, factor))
        else:
            super().keyPressEvent(event)

    def _make(self, plot: Plot) -> None:
        for item in self._items:
            for part in (*getattr(item, "curves", ()), item) if isinstance(item, pg.FillBetweenItem) else (item,):
                self.graph.removeItem(part)
        self._items = [make_item(series) for series in plot.series]
        self._kinds = [kind_of(series) for series in plot.series]
        for item, series in zip(self._items, plot.series, strict=True):
            if isinstance(series, Band):
                for curve in item.curves:
                    self.graph.addItem(curve)
            if isinstance(series, Marks):
                item.sigClicked.connect(self._clicked)
                item.setZValue(20)
            if isinstance(series, Curve):
                item.setZValue(15)
            self.graph.addItem(item)

    def _clicked(self, item: Any, points: Any, event: Any) -> None:
        if len(points) and (sample_id := item.sample_id(points[0].index())) is not None:
            self.chosen.emit(sample_id)

    def _draw_limits(self, plot: Plot) -> None:
        for line in self._limits:
            self.graph.removeItem(line)
        self._limits = []
        for limit in plot.limits:
            pen = pg.mkPen(colour(Role.ATTENTION), width=2, style=Qt.PenStyle.DashLine)
            line = pg.InfiniteLine(
                limit.y, angle=0, pen=pen, label=sentence(limit.name).replace("{", "(").replace("}", ")"),
                labelOpts={"position": 0.98, "color": colour(Role.ATTENTION), "anchors": [(1, 0), (1, 1)]},
            )  # fmt: skip
            line.label.setFont(self._font())
            line.setZValue(30)
            self.graph.addItem(line)
            self._limits.append(line)

    def _draw_colour_bar(self, plot: Plot) -> None:
        scales = [series.scale for series in plot.series if isinstance(series, Map)]
        if self._bar is not None and not scales:
            self.graph.plotItem.layout.removeItem(self._bar)
            self._bar.scene().removeItem(self._bar)
            self._bar = None
        if not scales:
            return
        scale = scales[0]
        if self._bar is None:
            self._bar = pg.ColorBarItem(interactive=False, width=px(12))
            self.graph.plotItem.layout.addItem(self._bar, 2, 5)
            # Otherwise half of the uppermost tick's number is cut off.
            self.graph.plotItem.layout.setContentsMargins(1.0, px(8), 1.0, 1.0)
        self._bar.setLevels(values=(scale.low, scale.high))
        self._bar.setColorMap(colour_map(scale))
        axis = self._bar.axis
        axis.enableAutoSIPrefix(False)
        axis.setPen(colour("line"))
        axis.setTextPen(colour("text"))
        axis.setLabel(html.escape(sentence(scale.title)), color=colour("text"), **{"font-size": f"{px(12)}px"})
        axis.setStyle(tickFont=self._font())
        metrics = QFontMetrics(self._font())
        widest = max(metrics.horizontalAdvance(f"{end:.4g}") for end in (scale.low, scale.high))
        axis.setWidth(widest + metrics.height() + px(14))  # the numbers, and the title beside them

    def _draw_words(self, plot: Plot) -> None:
        style = {"color": colour("text"), "font-size": f"{px(12)}px"}
        self.graph.setLabel("bottom", html.escape(sentence(plot.x_label)), **style)
        labels = [series.labels for series in plot.series if isinstance(series, Bars) and series.labels]
        ticks = None
        if labels:
            first = next(series for series in plot.series if isinstance(series, Bars) and series.labels)
            ticks = [[(float(x), sentence(word)) for x, word in zip(first.x, first.labels, strict=False)]]
        self.graph.getAxis("bottom").setTicks(ticks)
        named = [series for series in plot.series if not isinstance(series, Map) and series.name]
        # Written level: upright, a long label would be cut off in a low plot.
        words = [f"<b>↑ {html.escape(sentence(plot.y_label))}</b>" if plot.y_label else ""]
        words += [_legend(series) for series in named]
        self.legend.setText("&nbsp;&nbsp; ".join(word for word in words if word))
        self.setAccessibleName(sentence(plot.title))

    def _style(self) -> None:
        self.graph.setBackground(colour("panel"))
        for side in ("left", "bottom"):
            axis = self.graph.getAxis(side)
            axis.setPen(colour("line"))
            axis.setTextPen(colour("text"))
            axis.setStyle(tickFont=self._font())
        self.graph.showGrid(x=True, y=True, alpha=0.15)
        self._ring.setPen(pg.mkPen(colour(Role.CHOSEN), width=3))
        self._ring.setBrush(None)
        self._ring.setSize(px(18))

    def _font(self) -> QFont:
        font = QFont(self.font())
        font.setPixelSize(px(12))
        return font


def _legend(series: Series) -> str:
    assert not isinstance(series, Map)
    name = html.escape(sentence(series.name)).replace(" ", "&nbsp;")
    return f'<span style="color:{colour(series.role)}">{sign(series)}</span>&nbsp;{name}'
