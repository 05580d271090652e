"""Plots: every kind of series, in place, with the person's zoom kept; units as they are; a click chooses the sample."""

from dataclasses import replace

import numpy as np
import pyqtgraph as pg
import pytest
from PySide6.QtCore import QPoint, QPointF, Qt
from pytestqt.qtbot import QtBot

from beltgui.app.theme import Theme, colour, theme
from beltgui.viewmodel.plot import Bars, LimitLine, Map, Marks, Plot
from beltgui.viewmodel.scene import Role, Scale
from beltgui.widgets.plot_canvas import PlotCanvas
from beltgui.widgets.plot_dots import DotsItem
from beltgui.widgets.plot_items import MarksItem
from beltgui.widgets.plots_area import PlotsArea
from tests.beltgui.wizard_canned import plots, rows

PLOTS = plots(rows())


@pytest.fixture
def area(qtbot: QtBot) -> PlotsArea:
    made = PlotsArea()
    qtbot.addWidget(made)
    made.resize(420, 250)
    made.show()
    made.show_plots(PLOTS)
    return made


def colours_of(canvas: PlotCanvas) -> set[str]:
    """Colours in the picture of a plot."""
    image = canvas.graph.grab().toImage()
    return {image.pixelColor(x, y).name() for x in range(0, image.width(), 2) for y in range(0, image.height(), 2)}


def test_every_kind_is_drawn_on_its_tab(area: PlotsArea) -> None:
    assert [area.tabs.tabText(k) for k in range(5)] == ["Residuals", "Section", "Histogram", "Faces", "Map"]
    kinds = {
        "residuals": [MarksItem] * 2,
        "section": [pg.FillBetweenItem, pg.PlotCurveItem, pg.PlotCurveItem],
        "histogram": [pg.BarGraphItem],
        "faces": [pg.BarGraphItem],
        "map": [pg.ImageItem],
    }
    for place, plot in enumerate(PLOTS):
        area.tabs.setCurrentIndex(place)
        canvas = area.canvas(plot.key)
        assert canvas.plot is plot
        assert [type(item) for item in canvas._items] == kinds[plot.key]
        assert not area.grab().isNull()


def test_only_the_plot_that_is_seen_is_drawn(area: PlotsArea) -> None:
    assert area.canvas("residuals").plot is PLOTS[0]
    with pytest.raises(KeyError):
        area.canvas("map")


def test_axis_labels_keep_their_unit_without_prefixes(area: PlotsArea) -> None:
    canvas = area.canvas("residuals")
    assert "↑ residual, µm" in canvas.legend.text()
    canvas.graph.setYRange(0.0, 5.0e6)
    canvas.graph.setXRange(0.0, 5.0e6)
    for side, label in (("left", ""), ("bottom", "sample")):
        axis = canvas.graph.getAxis(side)
        axis.updateAutoSIPrefix()
        assert axis.autoSIPrefixScale == 1.0
        assert axis.label.toPlainText().strip() == label


def test_an_update_uses_the_items_again_and_keeps_the_zoom(area: PlotsArea) -> None:
    canvas = area.canvas("residuals")
    items = list(canvas._items)
    canvas.graph.setXRange(2.0, 4.0, padding=0.0)
    canvas.graph.setYRange(-1.0, 1.0, padding=0.0)
    assert canvas.zoomed()
    area.show_plots(plots(rows(12)))
    assert canvas._items == items
    np.testing.assert_allclose(canvas.graph.viewRange(), [[2.0, 4.0], [-1.0, 1.0]])
    area.whole_button.click()
    assert not canvas.zoomed()


def test_other_series_are_made_anew(area: PlotsArea) -> None:
    area.show_plots((replace(PLOTS[1], key="residuals"), *PLOTS[1:]))
    assert type(area.canvas("residuals")._items[0]) is pg.FillBetweenItem
    shown = area.canvas("residuals").graph.listDataItems()
    assert not any(isinstance(item, pg.ScatterPlotItem) and len(item.points()) for item in shown)


def test_plots_that_go_and_come(area: PlotsArea) -> None:
    area.tabs.setCurrentIndex(1)
    area.show_plots(PLOTS[1:3])
    assert area.tabs.count() == 2
    assert area.tabs.currentIndex() == 0
    area.show_plots(())
    assert area.tabs.count() == 0
    assert area.whole_button.isHidden()
    area.show_plots(PLOTS)
    assert area.canvas("residuals").plot is PLOTS[0]


def test_a_click_on_a_mark_chooses_its_sample_and_a_chosen_sample_is_ringed(qtbot: QtBot, area: PlotsArea) -> None:
    canvas = area.canvas("residuals")
    item = canvas._items[0]
    with qtbot.waitSignal(area.chosen) as chosen:
        item.sigClicked.emit(item, [item.points()[3]], None)
    assert chosen.args == [4]
    area.choose(4)
    ring = canvas._ring.getData()
    np.testing.assert_allclose(np.ravel(ring), [3.0, 71.0])
    area.choose(6)
    assert len(canvas._ring.getData()[0]) == 0
    area.choose(None)
    assert len(canvas._ring.getData()[0]) == 0


def test_a_mark_of_no_sample_chooses_nothing(qtbot: QtBot, area: PlotsArea) -> None:
    marks = Marks(np.arange(3.0), np.arange(3.0), Role.FIT, "fit")
    area.show_plots((Plot("residuals", "R", "x, mm", "y, mm", (marks,)),))
    item = area.canvas("residuals")._items[0]
    with qtbot.assertNotEmitted(area.chosen):
        item.sigClicked.emit(item, [item.points()[0]], None)


def test_the_legend_has_a_sign_for_each_series(area: PlotsArea) -> None:
    text = area.canvas("residuals").legend.text()
    assert "■" in text
    assert "◆" in text
    assert "held&nbsp;out" in text


def test_limits_follow(area: PlotsArea) -> None:
    canvas = area.canvas("residuals")
    assert [line.value() for line in canvas._limits] == [60.0]
    area.show_plots((replace(PLOTS[0], limits=(LimitLine(10.0, "a {x}"), LimitLine(20.0, "b"))), *PLOTS[1:]))
    assert [line.value() for line in canvas._limits] == [10.0, 20.0]


def test_bars_have_words_for_ticks_and_a_map_has_its_bar(area: PlotsArea) -> None:
    area.tabs.setCurrentIndex(3)
    assert area.canvas("faces").graph.getAxis("bottom")._tickLevels == [
        [(0.0, "pressure"), (1.0, "suction"), (2.0, "root")]
    ]
    area.tabs.setCurrentIndex(4)
    canvas = area.canvas("map")
    assert canvas._bar.levels() == (-40.0, 40.0)
    assert "error, µm" in canvas._bar.axis.label.toPlainText()
    area.show_plots((*PLOTS[:4], replace(PLOTS[0], key="map", title="Map")))
    assert canvas._bar is None


def test_the_bars_of_a_histogram_touch(area: PlotsArea) -> None:
    x = np.arange(5.0) * 20.0
    bars = Bars(x, np.ones(5), Role.INLIER, "points", width=1.0)
    words = Bars(np.array([0.0, 2.0]), np.ones(2), Role.INLIER, "faces", ("a", "c"), 0.25)
    area.show_plots((Plot("residuals", "H", "x, µm", "points", (bars, words)),))
    assert [item.opts["width"] for item in area.canvas("residuals")._items] == [20.0, 0.25]


def test_nothing_known_is_drawn_as_nothing(area: PlotsArea) -> None:
    nan = np.full(3, np.nan)
    empty = Map(np.full((4, 4), np.nan), (0.0, 1.0), (0.0, 1.0), Scale("error, µm", 0.0, 0.0, "sequential"))
    area.show_plots((
        Plot("residuals", "R", "x, mm", "y, mm", (Marks(nan, nan, Role.FIT, "fit", (1, 2, 3)),)),
        Plot("map", "Map", "u", "v", (empty,)),
    ))  # fmt: skip
    area.tabs.setCurrentIndex(1)
    assert not area.grab().isNull()


def test_many_marks_are_drawn_as_dots(area: PlotsArea) -> None:
    x = np.linspace(0.0, 1.0, 20_000)
    for shift in (0.0, 1.0):
        marks = Marks(x, np.sin(9 * x + shift), Role.INLIER, "points")
        area.show_plots((replace(PLOTS[0], series=(marks,)), *PLOTS[1:]))
    (item,) = area.canvas("residuals")._items
    assert isinstance(item, DotsItem)
    assert item.count() == 20_000
    assert item.dataBounds(0) == (0.0, 1.0)
    assert colour(Role.INLIER) in colours_of(area.canvas("residuals"))


def test_a_click_on_a_dot_chooses_its_sample(qtbot: QtBot, area: PlotsArea) -> None:
    x = np.arange(3000.0)
    marks = Marks(x, np.zeros(3000), Role.INLIER, "points", tuple(range(10, 3010)))
    area.show_plots((replace(PLOTS[0], series=(marks,), limits=()), *PLOTS[1:]))
    canvas = area.canvas("residuals")
    canvas.graph.setXRange(100.0, 104.0)
    area.grab()
    at = canvas.graph.mapFromScene(canvas.graph.getViewBox().mapViewToScene(QPointF(102.0, 0.0)))
    with qtbot.waitSignal(area.chosen) as chosen:
        qtbot.mouseClick(canvas.graph.viewport(), Qt.MouseButton.LeftButton, pos=at)
    assert chosen.args == [112]
    with qtbot.assertNotEmitted(area.chosen):
        qtbot.mouseClick(canvas.graph.viewport(), Qt.MouseButton.LeftButton, pos=at - QPoint(0, 40))


def test_another_theme_draws_again(area: PlotsArea, monkeypatch: pytest.MonkeyPatch) -> None:
    canvas = area.canvas("residuals")
    for name in ("dark", "light"):
        monkeypatch.setattr(Theme, "name", property(lambda self, name=name: name))
        theme().changed.emit()
        assert canvas._items[0].opts["brush"].color().name() == colour(Role.FIT)
        assert colour(Role.FIT) in canvas.legend.text()
