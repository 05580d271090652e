"""Light or dark, and how large: the one place where the screen's colours and sizes come from.

`colour(key)` takes a `Role`, a `StepState`, a device's state, or one of the surfaces and texts named in `palette`.
Whoever draws by hand listens to `theme().changed`; ordinary widgets follow the application's stylesheet.
"""

from __future__ import annotations

from functools import cache

from PySide6.QtCore import QObject, Qt, Signal
from PySide6.QtGui import QColor, QGuiApplication, QPalette
from PySide6.QtWidgets import QApplication

from beltgui.app import settings
from beltgui.app.palette import PALETTES
from beltgui.app.stylesheet import stylesheet

CHOICES = ("system", "light", "dark")
PERCENTS = (85, 100, 115, 130, 150, 175, 200)
BASE_PX = 13


class Theme(QObject):
    """The theme of the application.

    Signals:
        changed: Colours or sizes are other than before.
    """

    changed = Signal()

    def __init__(self) -> None:
        super().__init__()
        chosen = settings.text("theme", "system")
        self._choice = chosen if chosen in CHOICES else "system"
        kept = settings.text("text_percent")
        self._percent = int(kept) if kept.isdigit() and int(kept) in PERCENTS else default_percent()
        hints = QGuiApplication.styleHints()
        hints.colorSchemeChanged.connect(self._system_changed)

    @property
    def choice(self) -> str:
        """`system`, `light` or `dark`, as the person chose."""
        return self._choice

    @property
    def name(self) -> str:
        """`light` or `dark`, as it is shown."""
        if self._choice != "system":
            return self._choice
        dark = QGuiApplication.styleHints().colorScheme() == Qt.ColorScheme.Dark
        return "dark" if dark else "light"

    @property
    def percent(self) -> int:
        """Size of texts and controls against the usual one."""
        return self._percent

    def choose(self, choice: str) -> None:
        """Take `system`, `light` or `dark` and remember it."""
        if choice not in CHOICES:
            raise ValueError(f"theme '{choice}': expected one of {', '.join(CHOICES)}.")
        settings.keep("theme", choice)
        self._choice = choice
        self.apply()

    def resize(self, by: int) -> None:
        """Larger (+1) or smaller (-1) texts; 0 is the usual size again."""
        place = PERCENTS.index(self._percent) + by
        self._percent = PERCENTS[min(max(place, 0), len(PERCENTS) - 1)] if by else default_percent()
        settings.keep("text_percent", str(self._percent) if by else "")
        self.apply()

    def colour(self, key: str) -> str:
        """`#rrggbb` of a role, a state, a surface or a text.

        Raises:
            KeyError: there is no such key.
        """
        return PALETTES[self.name][key]

    def px(self, size: float) -> int:
        """A size in logical pixels that is `size` at the usual text size."""
        return max(1, round(size * self._percent / 100.0))

    def apply(self) -> None:
        """Give the whole application these colours and sizes."""
        application = QApplication.instance()
        if not isinstance(application, QApplication):
            return
        colours = PALETTES[self.name]
        application.setPalette(_qt_palette(colours))
        font = application.font()
        font.setPixelSize(self.px(BASE_PX))
        application.setFont(font)
        application.setStyleSheet(stylesheet(self.name, colours, self.px))
        self.changed.emit()

    def _system_changed(self) -> None:
        if self._choice == "system":
            self.apply()


def default_percent() -> int:
    """The usual size; larger on a screen of many pixels that the desktop does not scale itself."""
    screen = QGuiApplication.primaryScreen()
    if screen is None or screen.devicePixelRatio() > 1.0 or screen.logicalDotsPerInch() > 100.0:
        return 100
    height = screen.size().height()
    return 100 if height < 1300 else 115 if height < 1800 else 150 if height < 2600 else 200


@cache
def theme() -> Theme:
    """The theme; there is one."""
    return Theme()


def colour(key: str) -> str:
    """`#rrggbb` of a role, a state, a surface or a text in the theme that is shown now."""
    return theme().colour(key)


def px(size: float) -> int:
    """A size in logical pixels that is `size` at the usual text size."""
    return theme().px(size)


def contrast(one: str, other: str) -> float:
    """How well two colours are told apart (WCAG 2.2): 1 for the same, 21 for black on white."""
    light, dark = sorted((_luminance(one), _luminance(other)), reverse=True)
    return (light + 0.05) / (dark + 0.05)


def _luminance(text: str) -> float:
    linear = [
        channel / 12.92 if channel <= 0.04045 else ((channel + 0.055) / 1.055) ** 2.4
        for channel in (int(text[place : place + 2], 16) / 255.0 for place in (1, 3, 5))
    ]
    return 0.2126 * linear[0] + 0.7152 * linear[1] + 0.0722 * linear[2]


def _qt_palette(colours: dict[str, str]) -> QPalette:
    of = QPalette.ColorRole
    palette = QPalette()
    for role, key in (
        (of.Window, "background"), (of.WindowText, "text"), (of.Base, "panel"), (of.AlternateBase, "background"),
        (of.Text, "text"), (of.Button, "panel"), (of.ButtonText, "text"), (of.ToolTipBase, "panel"),
        (of.ToolTipText, "text"), (of.PlaceholderText, "muted"), (of.Highlight, "accent"),
        (of.HighlightedText, "on accent"), (of.Link, "accent"), (of.Mid, "line"), (of.Light, "panel"),
        (of.Dark, "line"), (of.BrightText, "on stop"),
    ):  # fmt: skip
        palette.setColor(role, QColor(colours[key]))
    for role in (of.WindowText, of.Text, of.ButtonText):
        palette.setColor(QPalette.ColorGroup.Disabled, role, QColor(colours["muted"]))
    return palette
