"""A template of a sentence: literal pieces with numbered places between them."""

from __future__ import annotations

import re
from collections.abc import Iterator

PLACE = re.compile(r"\{(\d+)\}")
_WORD = re.compile(r"\w+")
_SPACE = re.compile(" ")
# So often a piece is looked for again further on; a lone space is only looked for after the end of a sentence.
_MOST_FINDS = 6
_AFTER_SENTENCE = re.compile(r"(?<=[.!?]) ")


class Template:
    """One template.

    Attributes:
        text: As it is in the source, places as `{0}`.
        weight: Number of literal letters.
        words: Words that every text of this template has.
        before: The literal piece before each place.
        sentences: How many it is made of.
    """

    def __init__(self, text: str) -> None:
        self.text = text
        parts = PLACE.split(text)
        self._pieces, self._places = parts[::2], parts[1::2]
        self.weight = sum(len(piece) for piece in self._pieces)
        self.words = _whole_words(self._pieces)
        self.sentences = 1 + sum(len(_AFTER_SENTENCE.findall(piece)) for piece in self._pieces)
        self._speaks = any(mark in piece for piece in self._pieces for mark in ".:;!?")
        self.before = dict(zip(self._places, self._pieces, strict=False))

    def ways(self, text: str) -> Iterator[dict[str, str]]:
        """What may stand in the places; nothing if the text is not of this template.

        A label such as `grinder {0}` is no template of a whole sentence, nor of a label with a label.
        """
        if not self._speaks and text[-1:] in ".!?":
            return
        first, last = self._pieces[0], self._pieces[-1]
        if not last and not text.endswith(" "):
            text = f"{text} " if self._pieces[-2].endswith(" ") and text.endswith(self._pieces[-2].rstrip()) else text
        end = len(text) - len(last)
        if len(first) <= end and text.startswith(first) and text.endswith(last):
            for parts in self._parts(text, len(first), end, 1):
                if self._speaks or not any(": " in part for part in parts):
                    yield dict(zip(self._places, parts, strict=True))

    def _parts(self, text: str, start: int, end: int, number: int) -> Iterator[tuple[str, ...]]:
        """What may stand between the pieces from `number` - 1 on, in text[start:end]."""
        if number == len(self._pieces) - 1:
            yield (text[start:end],)
            return
        piece = self._pieces[number]
        for at in _finds(text, piece, start, end):
            for rest in self._parts(text, at + len(piece), end, number + 1):
                yield (text[start:at], *rest)


def words_in(text: str) -> set[str]:
    """All words of a text."""
    return set(_WORD.findall(text))


def _finds(text: str, piece: str, start: int, end: int) -> Iterator[int]:
    if not piece:  # two places side by side part at a space
        yield from (start, *(match.start() for match in _SPACE.finditer(text, start, end)), end)
        return
    at = text.find(piece, start, end)
    if at < 0:
        return
    yield at
    if piece == " ":
        yield from (match.start() for match in _AFTER_SENTENCE.finditer(text, at + 1, end))
        return
    for _ in range(_MOST_FINDS):
        at = text.find(piece, at + 1, end)
        if at < 0:
            return
        yield at


def _whole_words(pieces: list[str]) -> frozenset[str]:
    """Words that do not touch a place, so that they are words of every text too."""
    found: set[str] = set()
    for number, piece in enumerate(pieces):
        for match in _WORD.finditer(piece):
            open_before = match.start() == 0 and number > 0
            open_after = match.end() == len(piece) and number < len(pieces) - 1
            if not open_before and not open_after:
                found.add(match[0])
    return frozenset(found)
