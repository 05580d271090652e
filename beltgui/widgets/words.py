"""The program's own words for what the engine names by key: uses, states, steps."""

from __future__ import annotations

from PySide6.QtCore import QCoreApplication

from beltgui.viewmodel.step import Use


def use_word(use: Use) -> str:
    """What a sample is used for."""
    translate = QCoreApplication.translate
    return {
        Use.FIT: translate("Words", "fit"),
        Use.HELD_OUT: translate("Words", "held out"),
        Use.CHECK: translate("Words", "check"),
        Use.EXCLUDED: translate("Words", "left out"),
    }[use]


def flag_word(flag: str) -> str:
    """Why a sample stands out, with a sign before it; empty for none."""
    translate = QCoreApplication.translate
    words = {
        "worst": translate("Words", "▲ worst"),
        "outlier": translate("Words", "✖ outlier"),
        "refused": translate("Words", "✖ refused"),
        "rejected": translate("Words", "✖ rejected"),
    }
    return words.get(flag, f"▲ {flag}" if flag else "")


def step_word(step: str) -> str:
    """A step's title."""
    translate = QCoreApplication.translate
    return {
        "ball": translate("Words", "Ball"),
        "base": translate("Words", "Base"),
        "rough": translate("Words", "Rough workpiece"),
        "fine": translate("Words", "Fine workpiece"),
        "tool": translate("Words", "Stylus and tool"),
        "error_surface": translate("Words", "Error surface"),
    }[step]
