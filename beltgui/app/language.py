"""Language of the screen: Qt's translations for the program's own words, templates for sentences from below."""

from __future__ import annotations

from collections.abc import Mapping
from types import MappingProxyType

from PySide6.QtCore import QCoreApplication, QLibraryInfo, QLocale, QTranslator

from beltgui.app.sentences import Sentences
from beltgui.steps.state import TITLES
from resources import resource_path

ENGLISH, CHINESE = "en", "zh_CN"
LANGUAGES: Mapping[str, str] = MappingProxyType({ENGLISH: "English", CHINESE: "简体中文"})
CONTEXT = "sentence"
# How lists and clauses are joined; of what stands in several, the looser joint comes first.
JOINTS: Mapping[str, Mapping[str, str]] = MappingProxyType({
    CHINESE: {
        " – ": " – ", "; ": "；", ": ": "：", ", then ": "，然后", ", ": "、", " and ": "和", " or ": "或",
        " with ": "，同时", ".": "。", "'": "“”",
    },
})  # fmt: skip
# Steps are called by their titles on the screen.
KEYS: Mapping[str, Mapping[str, str]] = MappingProxyType({"step '": TITLES})


class _Installed:
    """The translators must live as long as they are installed."""

    language = ENGLISH
    translators: tuple[QTranslator, ...] = ()
    sentences: Sentences | None = None


def install(language: str) -> None:
    """Show everything in a language from now on; widgets get Qt's LanguageChange event.

    Args:
        language: A key of `LANGUAGES`.

    Raises:
        ValueError: there is no such language, or its file is missing.
    """
    if language not in LANGUAGES:
        raise ValueError(f"There is no language '{language}'; there are {', '.join(LANGUAGES)}.")
    for translator in _Installed.translators:
        QCoreApplication.removeTranslator(translator)
    _Installed.translators = ()
    _Installed.sentences = None
    _Installed.language = language
    QLocale.setDefault(QLocale(QLocale.Language.C))  # numbers are written the same way everywhere
    if language == ENGLISH:
        return
    own, qt = QTranslator(), QTranslator()
    path = resource_path("translations", f"beltcal_{language}.qm")
    if not own.load(str(path)):
        raise ValueError(f"{path}: the translation cannot be read. Install the program again.")
    folder = QLibraryInfo.path(QLibraryInfo.LibraryPath.TranslationsPath)
    translators = [own]
    if qt.load(f"qtbase_{language}", folder):
        translators.insert(0, qt)  # the last one installed is asked first
    for translator in translators:
        QCoreApplication.installTranslator(translator)
    _Installed.translators = tuple(translators)


def current() -> str:
    """The language that is shown."""
    return _Installed.language


def suggested() -> str:
    """The language of the computer, as far as there is a translation."""
    return CHINESE if QLocale.system().language() == QLocale.Language.Chinese else ENGLISH


def sentence(text: str) -> str:
    """A sentence of the engine in the language of the screen."""
    if _Installed.language == ENGLISH or not text:
        return text
    if _Installed.sentences is None:
        from beltgui.app.sentence_templates import TEMPLATES

        joints = JOINTS.get(_Installed.language)
        _Installed.sentences = Sentences([str(text) for text in TEMPLATES], _translated, joints=joints, keys=KEYS)
    return _Installed.sentences.say(text)


def _translated(template: str) -> str:
    return QCoreApplication.translate(CONTEXT, template)
