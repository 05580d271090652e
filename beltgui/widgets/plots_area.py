"""The plots of a step, one tab each; only the one that is seen is drawn."""

from __future__ import annotations

import re

from PySide6.QtCore import QTimer, Signal
from PySide6.QtWidgets import QTabWidget, QToolButton, QVBoxLayout, QWidget

from beltgui.app.language import sentence
from beltgui.viewmodel.plot import Plot
from beltgui.widgets.plot_canvas import PlotCanvas

# A longer title of a tab loses its end.
LONGEST = 16


def short_title(title: str) -> str:
    """A plot's title as its tab has room for: without what is in brackets and without numbers."""
    short = re.sub(r"\s*[(（].*?[)）]|\s*=\s*[-+\d.,]+", "", title).strip()
    return short if len(short) <= LONGEST else short[: LONGEST - 1].rstrip() + "…"


class PlotsArea(QWidget):
    """Tabs of plots; a plot of the same key replaces the one before and keeps its zoom.

    Signals:
        chosen: Sample id of the mark that was clicked.
    """

    chosen = Signal(int)

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.setObjectName("plots")
        self._plots: dict[str, Plot] = {}
        self._pages: dict[str, QWidget] = {}
        self._canvases: dict[str, PlotCanvas] = {}
        self._free: list[PlotCanvas] = []
        self._waiting: set[str] = set()
        self._chosen: int | None = None
        self.tabs = QTabWidget(self)
        self.tabs.setObjectName("plot_tabs")
        self.tabs.setDocumentMode(True)
        self.tabs.setUsesScrollButtons(True)
        self.tabs.currentChanged.connect(self._show_current)
        self.whole_button = QToolButton(self)
        self.whole_button.setObjectName("plot_whole")
        self.whole_button.setProperty("quiet", "true")
        self.whole_button.clicked.connect(self._whole)
        self.tabs.setCornerWidget(self.whole_button)
        # The arrows of a bar that is too narrow are tool buttons too; those of the application are too large for it.
        self.tabs.setStyleSheet("QTabBar QToolButton { padding: 0px; min-height: 0px; }")
        layout = QVBoxLayout(self)
        layout.setContentsMargins(0, 0, 0, 0)
        layout.addWidget(self.tabs)
        QTimer.singleShot(0, self, self._prepare)
        self.retranslate()

    def show_plots(self, plots: tuple[Plot, ...]) -> None:
        """Show these; what is not among them goes."""
        keys = [plot.key for plot in plots]
        if keys != list(self._plots):
            self._arrange(keys)
        self._plots = {plot.key: plot for plot in plots}
        self._waiting = set(keys)
        for place, plot in enumerate(plots):
            title = sentence(plot.title)
            short = short_title(title).replace("&", "&&")
            if self.tabs.tabText(place) != short:
                self.tabs.setTabText(place, short)
            self.tabs.setTabToolTip(place, title)
        self.whole_button.setVisible(bool(plots))
        self._show_current()

    def choose(self, sample_id: int | None) -> None:
        """Ring a sample's marks; None for none."""
        self._chosen = sample_id
        for canvas in self._canvases.values():
            canvas.choose(sample_id)

    def canvas(self, key: str) -> PlotCanvas:
        """The canvas of a plot that has been seen."""
        return self._canvases[key]

    def retranslate(self) -> None:
        """Write again in the present language."""
        self.setAccessibleName(self.tr("Plots"))
        self.tabs.setAccessibleName(self.tr("Plots"))
        self.whole_button.setText("⤢")
        self.whole_button.setToolTip(self.tr("Show the whole plot again (Home). Drag to move, wheel to zoom."))
        self.whole_button.setAccessibleName(self.tr("Show the whole plot"))
        self.show_plots(tuple(self._plots.values()))

    def _arrange(self, keys: list[str]) -> None:
        current = self.tabs.currentWidget()
        shown = next((key for key, page in self._pages.items() if page is current), "")
        self.tabs.blockSignals(True)
        self.tabs.clear()
        for key in [key for key in self._pages if key not in keys]:
            if key in self._canvases:
                self._put_aside(self._canvases.pop(key))
            self._pages.pop(key).deleteLater()
        for key in keys:
            if key not in self._pages:
                page = self._pages[key] = QWidget(self)
                QVBoxLayout(page).setContentsMargins(0, 0, 0, 0)
            self.tabs.addTab(self._pages[key], "")
        if shown in keys:
            self.tabs.setCurrentIndex(keys.index(shown))
        self.tabs.blockSignals(False)

    def _show_current(self) -> None:
        current = self.tabs.currentWidget()
        key = next((key for key, page in self._pages.items() if page is current), "")
        if key not in self._waiting:
            return
        self._waiting.discard(key)
        canvas = self._canvases.get(key)
        if canvas is None:
            canvas = self._canvases[key] = self._take_canvas()
            self._pages[key].layout().addWidget(canvas)
            canvas.show()
        canvas.show_plot(self._plots[key])
        canvas.choose(self._chosen)

    def _prepare(self) -> None:
        """The first canvas is made before it is needed, in a turn of the event loop that does nothing else."""
        if not self._canvases and not self._free:
            self._put_aside(self._make_canvas())

    def _take_canvas(self) -> PlotCanvas:
        """One that is free; making a new one takes the time of a frame or two."""
        if self._free:
            canvas = self._free.pop()
            canvas.whole()
            return canvas
        return self._make_canvas()

    def _make_canvas(self) -> PlotCanvas:
        canvas = PlotCanvas(self)
        canvas.chosen.connect(self.chosen)
        return canvas

    def _put_aside(self, canvas: PlotCanvas) -> None:
        canvas.hide()
        canvas.setParent(self)
        self._free.append(canvas)

    def _whole(self) -> None:
        for key, page in self._pages.items():
            if page is self.tabs.currentWidget() and key in self._canvases:
                self._canvases[key].whole()
