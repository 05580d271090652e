"""Language of the screen: Qt's translations for the program's own words, templates for sentences that come from below."""

from __future__ import annotations


def sentence(text: str) -> str:
    """A sentence of the engine in the language of the screen."""
    return text
