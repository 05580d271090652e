"""Colours: every role and state has one in both themes, texts are readable; the person's choice is kept."""

from collections.abc import Iterator
from pathlib import Path

import pytest
from PySide6.QtCore import QSettings
from PySide6.QtGui import QPalette
from PySide6.QtWidgets import QApplication, QLabel
from pytestqt.qtbot import QtBot

from beltgui.app import settings
from beltgui.app.palette import PALETTES
from beltgui.app.theme import PERCENTS, Theme, contrast
from beltgui.steps.state import StepState
from beltgui.viewmodel.scene import Role

TEXTS = ("text", "muted", "accent", "good", "bad", "warn", *StepState, "connected", "simulated", "waiting", "fault")
FILLED = ("accent", "good", "bad", "warn", "stop")
# Large grey surfaces that recede on purpose; all other roles are marks that must be seen.
SURFACES = {Role.BLADE, *(role for role in Role if role.startswith("face"))}


@pytest.fixture
def theme(qapp: QApplication, tmp_path: Path) -> Iterator[Theme]:
    QSettings.setPath(QSettings.Format.IniFormat, QSettings.Scope.UserScope, str(tmp_path))
    yield Theme()
    qapp.setStyleSheet("")
    qapp.setPalette(QPalette())


def test_contrast_is_that_of_the_standard() -> None:
    assert contrast("#000000", "#ffffff") == pytest.approx(21.0)
    assert contrast("#777777", "#ffffff") == pytest.approx(4.48, abs=0.01)
    assert contrast("#336699", "#336699") == 1.0


@pytest.mark.parametrize("name", PALETTES)
def test_every_role_and_state_has_a_colour(name: str) -> None:
    assert {*Role, *StepState, "background", "panel", "scene"} <= PALETTES[name].keys()
    assert PALETTES[name].keys() == PALETTES["light"].keys()


@pytest.mark.parametrize("name", PALETTES)
def test_texts_are_readable_on_every_ground(name: str) -> None:
    colours = PALETTES[name]
    for text in TEXTS:
        for ground in ("background", "panel"):
            assert contrast(colours[text], colours[ground]) >= 4.5, (text, ground)
    for fill in FILLED:
        assert contrast(colours[f"on {fill}"], colours[fill]) >= 4.5, fill
    for ground in ("good surface", "bad surface", "warn surface", "hover"):
        assert contrast(colours["text"], colours[ground]) >= 4.5, ground


@pytest.mark.parametrize("name", PALETTES)
def test_marks_stand_out_in_the_scene(name: str) -> None:
    colours = PALETTES[name]
    for role in Role:
        least = 1.5 if role in SURFACES else 2.8
        assert contrast(colours[role], colours["scene"]) >= least, role


def test_a_choice_repaints_and_is_remembered(theme: Theme, qtbot: QtBot) -> None:
    label = QLabel("words")
    qtbot.addWidget(label)
    label.show()
    with qtbot.waitSignal(theme.changed):
        theme.choose("dark")
    assert (theme.name, theme.colour("text")) == ("dark", PALETTES["dark"]["text"])
    assert label.palette().color(QPalette.ColorRole.WindowText).name() == PALETTES["dark"]["text"]
    assert (Theme().choice, Theme().name) == ("dark", "dark")
    theme.choose("light")
    assert label.palette().color(QPalette.ColorRole.WindowText).name() == PALETTES["light"]["text"]
    with pytest.raises(ValueError, match="expected one of system, light, dark"):
        theme.choose("pink")


def test_texts_grow_within_bounds_and_stay_that_large(theme: Theme, qapp: QApplication) -> None:
    usual = theme.percent
    theme.resize(+1)
    assert theme.percent > usual and qapp.font().pixelSize() == theme.px(13)
    assert Theme().percent == theme.percent
    for _ in PERCENTS:
        theme.resize(+1)
    assert theme.percent == PERCENTS[-1]
    theme.resize(0)
    assert theme.percent == usual and settings.text("text_percent") == ""
