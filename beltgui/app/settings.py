"""What the program remembers of a person's choices between two starts: theme, text size, recent sessions, tour seen."""

from __future__ import annotations

from PySide6.QtCore import QSettings

RECENT_KEPT = 8


def settings() -> QSettings:
    """The user's settings file."""
    return QSettings(QSettings.Format.IniFormat, QSettings.Scope.UserScope, "beltcal", "beltcal")


def text(key: str, default: str = "") -> str:
    """A remembered text."""
    return str(settings().value(key, default))


def keep(key: str, value: str) -> None:
    """Remember a text."""
    settings().setValue(key, value)


def recent_sessions() -> list[str]:
    """Folders of the sessions last opened, the latest first."""
    return [line for line in text("recent").split("\n") if line]


def add_recent(folder: str) -> None:
    """Put a folder in front of the recent ones."""
    rest = [known for known in recent_sessions() if known != folder]
    keep("recent", "\n".join([folder, *rest][:RECENT_KEPT]))
