"""Asks for folders without blocking the window."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path

from PySide6.QtCore import Qt
from PySide6.QtWidgets import QFileDialog, QWidget

from beltgui.app import settings


def ask_folder(parent: QWidget, title: str, start: Path, then: Callable[[str], None]) -> QFileDialog:
    """Let the person choose a folder; `then` gets it. Nothing happens if the dialog is closed."""
    dialog = QFileDialog(parent, title, str(start))
    dialog.setObjectName("folder_dialog")
    dialog.setFileMode(QFileDialog.FileMode.Directory)
    dialog.setOption(QFileDialog.Option.ShowDirsOnly)
    dialog.setAttribute(Qt.WidgetAttribute.WA_DeleteOnClose)
    dialog.setModal(False)
    dialog.fileSelected.connect(then)
    dialog.finished.connect(parent.window().activateWindow)
    dialog.show()
    to_front(dialog)
    return dialog


def to_front(window: QWidget) -> None:
    """Above the others and with the keyboard."""
    window.raise_()
    window.activateWindow()


def where_sessions_are() -> Path:
    """The folder above the session opened last, or the person's own."""
    recent = settings.recent_sessions()
    return Path(recent[0]).parent if recent else Path.home()
