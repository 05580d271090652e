"""Finds the template behind an English sentence and says it in another language.

What lies below the screen speaks plain English and knows nothing of languages. Its sentences are written as templates
(f-strings) in the source; `tools/translations.py` collects them, with `{0}`, `{1}` ... for what is filled in. Here a
sentence is taken apart by these templates; what was filled in may be made of templates itself. Of all ways to take it
apart the one counts that leaves the fewest letters of English over.
"""

from __future__ import annotations

import re
from collections import Counter
from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from itertools import islice

from beltgui.app.template import PLACE, Template, words_in

Translate = Callable[[str], str]
SENTENCE_END = re.compile(r"(?<=[.!?]) +")
# `Ball in {F} x`: a label and what it is of.
TAIL = re.compile(r"(.+) ([A-Za-z]'{0,2}|[+-]?[\d.]+)", re.DOTALL)
# `+0.70 rotary tilt`: a number and what it counts.
TERM = re.compile(r"([+-]?[\d.]+) (.+)", re.DOTALL)
BRACKETS = re.compile(r"(.+) \(([^()]+)\)", re.DOTALL)
NAME = re.compile(r"'([^']+)'")
SHUT = re.compile(r"\([^()]*\)|\[[^\[\]]*\]|'[^']*'")
WORD = re.compile(r"[^\s,;:()\[\]\"]+")
QUOTED = re.compile(r"'[^']*'|\"[^\"]*\"")
# Units, codes and names that are the same in every language.
EVERYWHERE = frozenset({"deg", "rad", "nan", "inf", "NaN", "beltcal"})
SHORT_WORDS = frozenset({"an", "as", "at", "by", "do", "in", "is", "it", "no", "of", "on", "or", "to", "up"})
MOST_SENTENCES = 24
MOST_WAYS = 12
# Templates with fewer letters, such as `{0} is {1}.`, count only where all that is filled in is known.
LEAST_WEIGHT = 10
MOST_STEPS = 80
# More than this is no sentence but, say, the report of a crash; it is left as it is.
MOST_LETTERS = 2000
MOST_KEPT = 20_000


@dataclass(frozen=True)
class _Said:
    """A text in the other language, and how many letters of English are left in it."""

    text: str
    left: int


class Sentences:
    """Says sentences in another language.

    Args:
        templates: All of them.
        translate: Gives a template's translation, with the same places; the template itself if there is none.
        joints: What lists and clauses are joined with, and how the other language does it, e.g. `{" and ": " und "}`,
            also its full stop under `.` and its two quotation marks under `'`.
        keys: After words that end a template's piece, such as `step '`, stands a key; by which words it is known.

    Example:
        >>> german = {"The {0} is lost.": "{0} ist verloren.", "robot": "Roboter"}
        >>> Sentences(list(german), lambda text: german.get(text, text)).say("The robot is lost.")
        'Roboter ist verloren.'
    """

    def __init__(
        self,
        templates: Sequence[str],
        translate: Translate,
        *,
        joints: Mapping[str, str] | None = None,
        keys: Mapping[str, Mapping[str, str]] | None = None,
    ) -> None:
        self._plain = {text for text in templates if not PLACE.search(text)}
        self._by_word = _indexed([Template(text) for text in templates if PLACE.search(text)])
        self._translate = translate
        marks = dict(joints or {})
        self._full_stop = marks.pop(".", ".")
        self._quotes = marks.pop("'", "''")
        self._joints = marks
        self._keys = dict(keys or {})
        self._kept: dict[str, _Said] = {}
        self._steps = 0

    def say(self, text: str) -> str:
        """The text in the other language; what no template knows stays as it is."""
        return self._said(text).text

    def knows(self, text: str) -> bool:
        """True if every word of the text comes from a template; numbers, units, codes and names in quotes apart."""
        return self._said(text).left == 0

    def _said(self, text: str) -> _Said:
        self._steps = MOST_STEPS
        self._kept[text] = self._best(text)
        return self._kept[text]

    def _best(self, text: str) -> _Said:
        found = self._kept.get(text)
        if found is not None:
            return found
        self._steps -= 1
        if self._steps < 0:  # an unknown text can be taken apart in thousands of ways, all of no use
            return _Said(text, _letters(text))
        found = self._least(text)
        if self._steps >= 0:
            if len(self._kept) >= MOST_KEPT:
                self._kept.clear()
            self._kept[text] = found
        return found

    def _least(self, text: str) -> _Said:
        """The way that leaves least over; of equal ones the first."""
        stripped = text.strip()
        if not stripped:
            return _Said(text, 0)
        if stripped != text:
            inner = self._best(stripped)
            before, _, after = text.partition(stripped)
            return _Said((before if inner.text[0].isascii() else "") + inner.text + after, inner.left)
        if text in self._plain:
            return _Said(self._translate(text), 0)
        best: _Said | None = None
        for said in self._ways(text):
            if best is None or said.left < best.left:
                best = said
            if best.left == 0:
                return best
        as_it_is = _Said(text, _letters(text))
        return as_it_is if best is None or as_it_is.left < best.left else best

    def _ways(self, text: str) -> Iterator[_Said]:
        """From the likeliest on."""
        templates = self._templates(text)
        if len(text) > MOST_LETTERS:
            yield from self._by_templates(text, [one for one in templates if "\n" in one.text])
            yield from self._by_lines(text)
            return
        ends = self._ends(text)
        label = TAIL.fullmatch(text)
        labelled = label is not None and label[1] in self._plain
        if text[-1] not in ".!?" and not ends and not labelled:
            # `rotation about a with shift along b`: two things, no rotation about something joined
            yield from (said for said in self._by_joints(text, whole=True) if said.left == 0)
        yield from self._by_templates(text, [one for one in templates if one.sentences > 1 or not ends])
        if label is not None and labelled:
            yield _Said(f"{self._translate(label[1])} {label[2]}", 0)
        yield from self._by_speaker(text)
        yield from self._by_lines(text)
        yield from self._by_sentences(text, ends)
        if ends:
            yield from self._by_templates(text, [one for one in templates if one.sentences == 1])
        yield from self._without_end(text)
        yield from self._by_joints(text)
        yield from self._by_marks(text)

    def _ends(self, text: str) -> list[tuple[int, int]]:
        """Gaps between sentences; those in brackets are not counted."""
        shut = [match.span() for match in SHUT.finditer(text)]
        found = (match.span() for match in SENTENCE_END.finditer(text))
        return [(a, b) for a, b in found if not any(start < a < stop for start, stop in shut)][:MOST_SENTENCES]

    def _templates(self, text: str) -> list[Template]:
        """Those that share their rarest word with the text, the longest first."""
        found = {id(one): one for word in words_in(text) | {""} for one in self._by_word.get(word, ())}
        return sorted(found.values(), key=lambda one: -one.weight)

    def _by_templates(self, text: str, templates: Sequence[Template]) -> Iterator[_Said]:
        for template in templates:
            for filled in islice(template.ways(text), MOST_WAYS):
                said = self._filled(template, filled)
                if said.left == 0 or template.weight >= LEAST_WEIGHT:
                    yield said

    def _filled(self, template: Template, filled: Mapping[str, str]) -> _Said:
        said, left = {}, 0
        for place, text in filled.items():
            before = template.before[place]
            names = next((names for end, names in self._keys.items() if before.endswith(end)), {})
            part = self._best(names.get(text, text))
            said[place] = part.text
            left += 0 if before.endswith("'") else part.left
        whole = ""
        for i, piece in enumerate(PLACE.split(self._translate(template.text))):
            whole = _beside(whole, said[piece] if i % 2 else piece)
        return _Said(whole.strip(), left)

    def _by_speaker(self, text: str) -> Iterator[_Said]:
        """What a device says, such as `scanner: no complete scan arrived`."""
        speaker, colon, rest = text.partition(": ")
        if colon and speaker in self._plain:
            said = self._best(rest)
            yield _Said(_chain([self._translate(speaker), said.text], self._joints.get(colon, colon)), said.left)

    def _by_lines(self, text: str) -> Iterator[_Said]:
        if "\n" in text:
            first, rest = text.split("\n", 1)
            said = self._best(first)
            others = self._best(rest) if len(rest) <= MOST_LETTERS else _Said(rest, _letters(rest))
            yield _Said(f"{said.text}\n{others.text}", said.left + others.left)

    def _by_sentences(self, text: str, ends: Sequence[tuple[int, int]]) -> Iterator[_Said]:
        """A text of several sentences, the longest beginning first."""
        for start, stop in reversed(ends):
            first, rest = self._best(text[:start]), self._best(text[stop:])
            between = " " if first.text[-1:].isascii() else ""
            yield _Said(f"{first.text}{between}{rest.text}", first.left + rest.left)

    def _by_joints(self, text: str, *, whole: bool = False) -> Iterator[_Said]:
        """A list, or clauses, with `whole` of parts that are all translated; where a file lies is said as it is."""
        files = "/" in text or "\\" in text
        for joint, other in self._joints.items():
            parts = _split(text, joint) if joint == ": " or not files else [text]
            if len(parts) > 1:
                said = [self._best(part) for part in parts]
                new = [one.text != part for one, part in zip(said, parts, strict=True)]
                if all(new) or (any(new) and not whole):
                    yield _Said(_chain([one.text for one in said], other), sum(one.left for one in said))

    def _without_end(self, text: str) -> Iterator[_Said]:
        """A list or clause with a full stop after it."""
        if text.endswith(".") and not text.endswith(".."):
            inner = self._best(text[:-1])
            if inner.text != text[:-1]:
                yield _Said(inner.text + self._full_stop, inner.left)

    def _by_marks(self, text: str) -> Iterator[_Said]:
        """A name in quotes, a label with what it is of, a number with what it counts, something in brackets."""
        if (term := TERM.fullmatch(text)) is not None:
            rest = self._best(term[2])
            yield _Said(f"{term[1]} {rest.text}", rest.left)
        if (name := NAME.fullmatch(text)) is not None:
            inner = self._best(name[1])
            yield _Said(f"{self._quotes[0]}{inner.text}{self._quotes[1]}", 0)
        if (label := TAIL.fullmatch(text)) is not None:
            head = self._best(label[1])
            yield _Said(f"{head.text} {label[2]}", head.left)
        if (brackets := BRACKETS.fullmatch(text)) is not None:
            head, inner = self._best(brackets[1]), self._best(brackets[2])
            wide = not head.text[-1:].isascii() and not inner.text[-1:].isascii()
            both = f"{head.text}（{inner.text}）" if wide else f"{head.text} ({inner.text})"
            yield _Said(both, head.left + inner.left)


def _split(text: str, joint: str) -> list[str]:
    """The parts between the joints that stand neither in brackets nor in quotes."""
    shut = [match.span() for match in SHUT.finditer(text)]
    parts, begin, at = [], 0, text.find(joint)
    while at >= 0:
        if not any(start <= at < stop for start, stop in shut):
            parts.append(text[begin:at])
            begin = at + len(joint)
        at = text.find(joint, at + len(joint))
    return [*parts, text[begin:]]


def _chain(parts: Sequence[str], joint: str) -> str:
    whole = parts[0]
    for part in parts[1:]:
        whole = _beside(_beside(whole, joint), part)
    return whole


def _beside(left: str, right: str) -> str:
    """Two texts put together, with a space where letters of two scripts would touch."""
    if not left or not right:
        return left + right
    if right[0] in "（，。；：）":
        return left.rstrip(" ") + right
    one, other = left[-1], right[0]
    apart = (_is_latin(one, ")%'") and _is_han(other)) or (_is_han(one) and _is_latin(other, "(+-./'"))
    return f"{left} {right}" if apart else left + right


def _is_latin(letter: str, marks: str) -> bool:
    return letter in marks or (letter.isascii() and letter.isalnum())


def _is_han(letter: str) -> bool:
    return "\u4e00" <= letter <= "\u9fff"


def _indexed(templates: Sequence[Template]) -> dict[str, list[Template]]:
    """Templates by their rarest word; those without a whole word under the empty one."""
    frequency = Counter(word for template in templates for word in template.words)
    found: dict[str, list[Template]] = {}
    for template in templates:
        rarest = min(template.words, key=lambda word: (frequency[word], word), default="")
        found.setdefault(rarest, []).append(template)
    return found


def _letters(text: str) -> int:
    """Letters in English words; names in quotes, numbers, units, codes and names of files are no English."""
    words = WORD.findall(QUOTED.sub(" ", text))
    return sum(len(word) for word in words if _is_english(word.strip(".'!?")))


def _is_english(word: str) -> bool:
    letters = word.replace("-", "").replace("'", "")
    if not (letters.isascii() and letters.isalpha() and word[1:].islower()):
        return False
    return word.lower() in SHORT_WORDS if len(word) < 3 else word not in EVERYWHERE
