"""Numbers, checks, suggestion and verdict: a unit beside every number, a dash for the unknown, never colour alone."""

import math

import pytest
from PySide6.QtGui import QGuiApplication
from pytestqt.qtbot import QtBot

from beltgui.app.theme import Theme, theme
from beltgui.viewmodel.step import Check, Number, Suggestion
from beltgui.widgets.banner import Banner, BannerKind
from beltgui.widgets.checks_list import ChecksList
from beltgui.widgets.figures import decimals_for, number, plain_number, with_unit
from beltgui.widgets.numbers_panel import NumbersPanel
from beltgui.widgets.pictures import Picture, drawing, icon
from beltgui.widgets.suggestion_box import SuggestionBox
from tests.beltgui.wizard_canned import CHECKS, NUMBERS


def test_numbers_as_text() -> None:
    assert number(1.23456, 2) == "1.23"
    assert number(-0.0001, 3) == "0.000"
    assert number(-0.5, 1) == "-0.5"
    assert [number(value) for value in (None, math.nan, math.inf)] == ["–"] * 3
    assert with_unit(None, "mm") == "– mm"
    assert with_unit(20.0, "", 0) == "20"
    assert [plain_number(value) for value in (0.02314, None, math.nan)] == ["0.02314", "–", "–"]


@pytest.mark.parametrize(
    ("plus_minus", "decimals"),
    [(0.5, 3), (0.001, 3), (0.0004, 4), (0.00008, 5), (1e-12, 6), (0.0, 3), (None, 3), (float("nan"), 3), (25.0, 3)],
)
def test_an_uncertainty_never_reads_as_zero(plus_minus: float | None, decimals: int) -> None:
    assert decimals_for(plus_minus, 3) == decimals


def test_every_number_has_its_unit_and_the_main_ones_come_first(qtbot: QtBot) -> None:
    panel = NumbersPanel()
    qtbot.addWidget(panel)
    panel.show_numbers(NUMBERS[::-1])
    assert [row.label.text() for row in panel.rows][:2] == ["RMS of the residuals", "Position of the scanner in {M}, x"]
    for row in panel.rows[: len(NUMBERS)]:
        assert row.value.text().endswith((" mm", " deg", " ppm"))
    texts = panel.text()
    assert "123.4567 mm ± 0.0121 mm (k = 2)" in texts
    assert "0.0213 mm limit 0.0500 mm" in texts
    assert "0.0610 mm ▲ limit 0.0500 mm" in texts
    assert "Scale of x – ppm" in texts


def test_the_bar_shows_the_share_of_the_limit(qtbot: QtBot) -> None:
    panel = NumbersPanel()
    qtbot.addWidget(panel)
    panel.show_numbers((Number("RMS", -0.02, "mm", limit=0.05), Number("RMS 2", math.nan, "mm", limit=0.05)))
    assert panel.rows[0].bar.share == pytest.approx(0.4)
    assert panel.rows[1].bar.share is None
    assert panel.rows[1].value.text() == "– mm"


def test_rows_are_used_again(qtbot: QtBot) -> None:
    panel = NumbersPanel()
    qtbot.addWidget(panel)
    panel.show_numbers(NUMBERS)
    before = list(panel.rows)
    panel.show_numbers(NUMBERS[:3])
    assert panel.rows == before
    assert len(panel.text().split("\n")) == 3
    panel.show_numbers(())
    assert panel.isHidden()


def test_many_numbers_are_shown_on_demand(qtbot: QtBot) -> None:
    panel = NumbersPanel()
    qtbot.addWidget(panel)
    panel.show_numbers(tuple(Number(f"value {k}", float(k), "mm", main=k == 29) for k in range(30)))
    assert panel.text().split("\n")[0] == "value 29 29.000 mm"
    assert len(panel.text().split("\n")) == 8
    assert panel.all_button.text() == "All 30 numbers"
    panel.all_button.click()
    assert len(panel.text().split("\n")) == 30
    panel.all_button.click()
    assert len(panel.text().split("\n")) == 8
    panel.show_numbers(NUMBERS)
    assert panel.all_button.isHidden()


def test_checks_have_shape_value_limit_and_count(qtbot: QtBot) -> None:
    checks = ChecksList()
    qtbot.addWidget(checks)
    checks.show_checks(CHECKS)
    assert checks.text().split("\n") == [
        "✔ RMS error of the predicted ball centres: 0.0231 mm, limit 0.05 mm (n = 4)",
        "✖ closing scan: ball has stayed: 0.083 mm, limit 0.06 mm (n = 1)",
        "○ second closing scan: – mm, limit 0.06 mm — not known yet",
    ]
    checks.show_checks((Check("count", 3.0, "", None, 0, True),))
    assert checks.text() == "✔ count: 3"
    assert checks.lines[1].isHidden()


def test_a_suggestion_says_what_it_would_improve(qtbot: QtBot) -> None:
    box = SuggestionBox()
    qtbot.addWidget(box)
    assert box.isHidden()
    box.show_suggestion(Suggestion("One more pose.", "x from 2 to 1 mm"))
    assert "One more pose." in box.text()
    assert "Would improve: x from 2 to 1 mm" in box.text()
    box.show_suggestion(None)
    assert box.isHidden()


@pytest.mark.parametrize("kind", BannerKind)
def test_every_verdict_has_a_shape_and_is_copied_whole(qtbot: QtBot, kind: BannerKind) -> None:
    banner = Banner()
    qtbot.addWidget(banner)
    banner.say(kind, "headline", ("reason one.", "reason two."))
    assert not banner.word.text()[0].isalnum()
    banner.copy_button.click()
    copied = QGuiApplication.clipboard().text()
    assert "headline" in copied
    assert "reason two." in copied
    banner.retranslate()
    assert banner.kind is kind
    banner.say(None)
    assert banner.isHidden()
    assert banner.text() == ""


def test_a_long_verdict_scrolls_instead_of_pushing_the_button_away(qtbot: QtBot) -> None:
    banner = Banner()
    qtbot.addWidget(banner)
    banner.resize(330, 100)
    banner.say(
        BannerKind.REJECTED, "no", tuple(f"Reason {k}: something is wrong, do something about it." for k in range(30))
    )
    assert banner.height() <= theme().px(210)


def test_pictures_are_drawn_in_the_colours_of_the_theme(qtbot: QtBot, monkeypatch: pytest.MonkeyPatch) -> None:
    picture = Picture()
    qtbot.addWidget(picture)
    light = {}
    names = ["mount ball", "mount blade", "mount stylus", "mount nothing", "touch cone", "touch shaft", "motion", "app"]
    names += [f"step {step}" for step in ("ball", "base", "rough", "fine", "tool", "error_surface")]
    monkeypatch.setattr(Theme, "name", property(lambda self: "light"))
    for name in names:
        light[name] = bytes(drawing(name).data())
        picture.show_picture(name)
        assert not picture.grab().isNull()
        assert not icon(name).isNull()
    monkeypatch.setattr(Theme, "name", property(lambda self: "dark"))
    assert all(bytes(drawing(name).data()) != light[name] for name in names)
    with pytest.raises(FileNotFoundError, match="mount_nose"):
        drawing("mount nose")
