"""English sentences from below the screen in another language, and nothing left untranslated."""

import importlib.util
import re
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
# Sentences of rooms, solvers, verdicts and devices as they came to the screen, one a line.
SEEN = Path(__file__).with_name("sentences_seen.txt")
# Units, abbreviations, names of faces and of fields in files.
NOT_ENGLISH = re.compile(
    r"“[^”]*”|--\w+|[\w.\[\]]*_\w*|\S+\.(step|matrix)|\b(deg|rad|nan|sigma|count|positions|observations)\b|AIRFOIL|RMS|NaN"
)

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


def translated(template: str) -> str:
    return QCoreApplication.translate(language.CONTEXT, template)


def bare(text: str) -> str:
    return re.sub(r"\s", "", text)


def english_words(text: str) -> list[str]:
    return re.findall(r"[A-Za-z][a-z]{2,}", NOT_ENGLISH.sub(" ", text))


def test_every_text_is_collected_and_translated() -> None:
    spec = importlib.util.spec_from_file_location("translations", ROOT / "tools" / "translations.py")
    assert spec is not None and spec.loader is not None
    tool = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(tool)
    assert tuple(tool.templates()) == TEMPLATES, "run tools/translations.py"
    assert tool.unfinished() == []
    assert tool.homeless() == []


def test_the_compiled_file_has_every_sentence_with_its_places(chinese: None) -> None:
    for template in TEMPLATES:
        translated = QCoreApplication.translate(language.CONTEXT, template)
        assert translated.strip(), template
        assert sorted(PLACE.findall(translated)) == sorted(PLACE.findall(template)), template


def test_each_template_is_found_again_behind_what_it_makes(chinese: None) -> None:
    said = Sentences([str(text) for text in TEMPLATES], translated, joints=language.JOINTS[language.CHINESE])
    wrong = []
    for template in map(str, TEMPLATES):
        if re.search(r"\}\{|\}\.\{", template):
            continue  # where one place ends and the next begins is seen from what fills them only
        both = (template, translated(template))
        english, expected = (PLACE.sub(lambda place: f"7.5{place[1]}", text) for text in both)
        if bare(said.say(english)) != bare(expected) or not said.knows(english):
            wrong.append(template)
    assert wrong == []


def test_sentences_that_were_seen_leave_no_english(chinese: None) -> None:
    seen = SEEN.read_text(encoding="utf-8").splitlines()
    said = Sentences(
        [str(text) for text in TEMPLATES], translated, joints=language.JOINTS[language.CHINESE], keys=language.KEYS
    )
    assert len(seen) > 150
    assert [text for text in seen if not said.knows(text)] == []
    assert [text for text in seen if english_words(said.say(text))] == []


@pytest.mark.parametrize(
    ("english", "expected"),
    [
        ("The step 'rough' has no result yet. Solve it first.", "步骤“工件粗定位”还没有结果。请先求解。"),
        ("The cell has no grinder x. Choose one of rough, fine.", "单元中没有 x 砂带磨床。请从粗磨、精磨中选择。"),
        ("grinder rough: the connection is gone. Check its cable and power, then connect it again.",
         "粗磨砂带磨床：连接已断开。请检查其电缆和电源，然后重新连接。"),
        ("Grinder rough: origin of {H} in {B}, z", "粗磨砂带磨床：{H} 的原点在 {B} 中的位置 z"),
        ("Mount the blade DR95-0001 on the flange, then confirm.", "请将叶片 DR95-0001 安装到法兰上，然后确认。"),
        ("To do: Ball (accept), then Rough workpiece (not done yet).",
         "待办：标准球（接受），然后工件粗定位（尚未完成）。"),
        ("The scan is 3 mm across. Wrong 'name' here.", "The scan is 3 mm across. Wrong 'name' here."),
        ("/data/ball and stage/a.stl: there is no such file.", "/data/ball and stage/a.stl：没有这个文件。"),
    ],
)  # fmt: skip
def test_words_are_chosen_by_what_they_belong_to(chinese: None, english: str, expected: str) -> None:
    assert language.sentence(english) == expected


def test_the_report_of_a_crash_is_left_as_it_is(chinese: None) -> None:
    crash = "Traceback (most recent call last):\n" + "  File 'a.py', line 3, in the ball\n" * 200
    first, rest = language.sentence(f"The monitor of the devices has ended.\n{crash}").split("\n", 1)
    assert first == "设备监视已结束。" and rest.count("\n") == crash.count("\n")


def test_the_toolkits_own_buttons_are_translated_too(chinese: None) -> None:
    assert QCoreApplication.translate("QPlatformTheme", "Cancel") == "取消"


def test_the_language_is_changed_and_changed_back(chinese: None) -> None:
    english = "The ball may have moved on the flange, or the robot's mastering is off: check both."
    said = language.sentence(english)
    assert language.current() == language.CHINESE and said != english and not any("a" <= c <= "z" for c in said)
    language.install(language.ENGLISH)
    assert language.sentence(english) == english


def test_an_unknown_language_is_refused() -> None:
    with pytest.raises(ValueError, match="There is no language 'xx'; there are en, zh_CN"):
        language.install("xx")
