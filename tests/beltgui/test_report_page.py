"""The report's page: one file, everything inside, nothing unescaped."""

from html.parser import HTMLParser

from beltgui.report import Figure, Page, Section, Table, render


class Outline(HTMLParser):
    def __init__(self) -> None:
        super().__init__()
        self.open: list[str] = []
        self.references: list[str] = []

    def handle_starttag(self, tag: str, attrs: list[tuple[str, str | None]]) -> None:
        if tag not in ("meta", "img"):
            self.open.append(tag)
        self.references += [value or "" for key, value in attrs if key in ("src", "href")]

    def handle_endtag(self, tag: str) -> None:
        assert self.open.pop() == tag


def example() -> Page:
    table = Table(["name", "value in mm"], [["<b>", "1.25"], ["verdict", "rejected"]])
    section = Section("1 Ball", "Text & more", False, ["Too few points."], [table], [Figure(b"\x89PNG", "residuals")])
    return Page("Title", "Lead", False, "Because.", [section])


def test_the_page_is_whole_and_needs_no_other_file() -> None:
    outline = Outline()
    outline.feed(render(example()))
    assert outline.open == []
    assert all(reference.startswith("data:image/png;base64,") for reference in outline.references)


def test_text_is_escaped_and_verdicts_are_words() -> None:
    text = render(example())
    assert "&lt;b&gt;" in text
    assert "Text &amp; more" in text
    assert "✖ Rejected" in text
    assert '<td class="number">1.25</td>' in text
