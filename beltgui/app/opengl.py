"""Whether the screen can show a window that the graphics card draws."""

from __future__ import annotations

from PySide6.QtCore import QCoreApplication
from PySide6.QtGui import QGuiApplication

# What Qt shows these on has no OpenGL for a widget.
WITHOUT_GL = ("offscreen", "minimal", "minimalegl", "vnc", "linuxfb")


def why_no_window() -> str:
    """Why there can be no 3D view in a window of its own; empty if there can."""
    platform = QGuiApplication.platformName()
    if platform not in WITHOUT_GL:
        return ""
    text = QCoreApplication.translate(
        "SceneWindow", "A window of its own needs OpenGL, which the screen “{platform}” does not offer."
    )
    return text.format(platform=platform)
