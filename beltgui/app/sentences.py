"""Finds the template behind an English sentence and says it in another language.

What lies below the screen speaks plain English and knows nothing of languages. Its sentences are written as templates
(f-strings) in the source; `tools/translations.py` collects them, with `{0}`, `{1}` ... for what is filled in. Here a
sentence is taken apart by these templates; what was filled in may be made of templates itself.
"""

from __future__ import annotations

import re
from collections.abc import Callable, Sequence
from functools import lru_cache

Translate = Callable[[str], str]
PLACE = re.compile(r"\{(\d+)\}")
SENTENCE_END = re.compile(r"(?<=[.:;!?]) +")
MOST_SENTENCES = 24
# Deeper nesting than this is not written anywhere.
DEPTH = 6
# Lists are joined with these; each part is a text of its own.
JOINTS = (", ", "; ", " and ", " or ")


class _Template:
    """One template as a pattern."""

    def __init__(self, text: str) -> None:
        self.text = text
        pieces = PLACE.split(text)
        self.literal = max(pieces[::2], key=len)
        self.weight = sum(len(piece) for piece in pieces[::2])
        self._order = [int(number) for number in pieces[1::2]]
        pattern = "".join(re.escape(piece) if i % 2 == 0 else "(.+?)" for i, piece in enumerate(pieces))
        self._pattern = re.compile(pattern, re.DOTALL)

    def filled(self, text: str) -> dict[int, str] | None:
        """What stands in the places if the text is of this template."""
        if self.literal not in text:
            return None
        found = self._pattern.fullmatch(text)
        return None if found is None else dict(zip(self._order, found.groups(), strict=True))


class Sentences:
    """Says sentences in another language.

    Args:
        templates: All of them.
        translate: Gives a template's translation, with the same places; the template itself if there is none.

    Example:
        >>> german = {"The {0} is lost.": "{0} ist verloren.", "robot": "Roboter"}
        >>> Sentences(list(german), lambda text: german.get(text, text)).say("The robot is lost.")
        'Roboter ist verloren.'
    """

    def __init__(self, templates: Sequence[str], translate: Translate) -> None:
        self._plain = {text for text in templates if not PLACE.search(text)}
        with_places = [_Template(text) for text in templates if PLACE.search(text)]
        self._templates = sorted(with_places, key=lambda template: -template.weight)
        self._translate = translate
        self.say = lru_cache(maxsize=4096)(self._say)

    def knows(self, text: str) -> bool:
        """True if every word of the text comes from a template, numbers and names in quotes apart."""
        return self._found(text, 0) is not None

    def _say(self, text: str) -> str:
        found = self._found(text, 0)
        if found is None:
            found = self._one_by_one(text)
        return found

    def _one_by_one(self, text: str) -> str:
        """What is known of a text of several lines or sentences; the rest as it is."""
        lines = text.split("\n")
        if len(lines) > 1:
            return "\n".join(self._say(line) for line in lines)
        parts = SENTENCE_END.split(text)
        return " ".join(self._filling(part, 0) for part in parts)

    def _found(self, text: str, depth: int) -> str | None:
        if text in self._plain:
            return self._translate(text)
        if depth > DEPTH:
            return None
        stripped = text.strip()
        if stripped != text and stripped:
            inner = self._found(stripped, depth)
            return None if inner is None else text.replace(stripped, inner)
        for template in self._templates:
            filled = template.filled(text)
            if filled is not None:
                parts = {str(place): self._filling(part, depth + 1) for place, part in filled.items()}
                pieces = PLACE.split(self._translate(template.text))
                return "".join(parts[piece] if i % 2 else piece for i, piece in enumerate(pieces))
        return self._joined(text, depth)

    def _filling(self, text: str, depth: int) -> str:
        found = self._found(text, depth)
        if found is not None:
            return found
        for joint in JOINTS:
            parts = text.split(joint)
            if len(parts) > 1:
                return joint.join(self._filling(part, depth + 1) for part in parts)
        return text

    def _joined(self, text: str, depth: int) -> str | None:
        """A text of several sentences, the longest known beginning first."""
        ends = [match.span() for match in SENTENCE_END.finditer(text)][:MOST_SENTENCES]
        for start, stop in reversed(ends):
            first = self._found(text[:start], depth + 1)
            if first is not None:
                rest = self._found(text[stop:], depth + 1)
                if rest is not None:
                    return f"{first} {rest}"
        return None
