"""English sentences from below the screen in another language, and nothing left untranslated."""

import importlib.util
from collections.abc import Iterator
from pathlib import Path

import pytest
from PySide6.QtCore import QCoreApplication
from pytestqt.qtbot import QtBot

from beltgui.app import language
from beltgui.app.sentence_templates import TEMPLATES
from beltgui.app.sentences import Sentences
from beltgui.app.template import PLACE

ROOT = Path(__file__).resolve().parents[2]

GERMAN = {
    "The {0} is {1} mm, the limit is {2} mm. {3}": "{0}: {1} mm, erlaubt sind {2} mm. {3}",
    "distance of the {0}": "Abstand: {0}",
    "ball": "Kugel",
    "stage": "Achsen",
    "Fasten it.": "Befestigen.",
    "Scan again.": "Neu scannen.",
    "scan {0} of {1}: {2}": "Scan {0} von {1}: {2}",
    "{0} comes before {1}": "{1} kommt nach {0}",
}


@pytest.fixture
def german() -> Sentences:
    joints = {", ": ", ", " and ": " und "}
    return Sentences(list(GERMAN), lambda text: GERMAN.get(text, text), joints=joints)


@pytest.mark.parametrize(
    ("english", "expected"),
    [
        ("The distance of the ball is 0.3 mm, the limit is 0.1 mm. Fasten it.",
         "Abstand: Kugel: 0.3 mm, erlaubt sind 0.1 mm. Befestigen."),
        ("Fasten it. Scan again.", "Befestigen. Neu scannen."),
        ("The ball is 1 mm, the limit is 2 mm. Fasten it. Scan again.",
         "Kugel: 1 mm, erlaubt sind 2 mm. Befestigen. Neu scannen."),
        ("scan 2 of 7: pose 3", "Scan 2 von 7: pose 3"),
        ("ball, stage and x", "Kugel, Achsen und x"),
        ("one comes before two", "two kommt nach one"),
        ("Nobody wrote this.", "Nobody wrote this."),
        ("Nobody wrote this. Scan again.", "Nobody wrote this. Neu scannen."),
        ("Fasten it.\nScan again.", "Befestigen.\nNeu scannen."),
        ("", ""),
        ("{0} (braces)", "{0} (braces)"),
    ],
)  # fmt: skip
def test_a_sentence_is_taken_apart_by_its_templates(german: Sentences, english: str, expected: str) -> None:
    assert german.say(english) == expected


@pytest.fixture
def chinese(qtbot: QtBot) -> Iterator[None]:
    language.install(language.CHINESE)
    yield
    language.install(language.ENGLISH)


def test_every_text_is_collected_and_translated() -> None:
    spec = importlib.util.spec_from_file_location("translations", ROOT / "tools" / "translations.py")
    assert spec is not None and spec.loader is not None
    tool = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(tool)
    assert tuple(tool.templates()) == TEMPLATES, "run tools/translations.py"
    assert tool.unfinished() == []


def test_the_compiled_file_has_every_sentence_with_its_places(chinese: None) -> None:
    for template in TEMPLATES:
        translated = QCoreApplication.translate(language.CONTEXT, template)
        assert translated.strip(), template
        assert sorted(PLACE.findall(translated)) == sorted(PLACE.findall(template)), template


def test_the_language_is_changed_and_changed_back(chinese: None) -> None:
    english = "The ball may have moved on the flange, or the robot's mastering is off: check both."
    said = language.sentence(english)
    assert language.current() == language.CHINESE and said != english and not any("a" <= c <= "z" for c in said)
    language.install(language.ENGLISH)
    assert language.sentence(english) == english


def test_an_unknown_language_is_refused() -> None:
    with pytest.raises(ValueError, match="There is no language 'xx'; there are en, zh_CN"):
        language.install("xx")
