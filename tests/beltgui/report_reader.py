"""Reads a report the way a browser does."""

import base64
from html.parser import HTMLParser


class Report(HTMLParser):
    """What a reader of the report sees: words outside of tags, table heads and cells, pictures."""

    def __init__(self, text: str) -> None:
        super().__init__()
        self.open: list[str] = []
        self.heads: list[str] = []
        self.cells: list[str] = []
        self.words: list[str] = []
        self.pictures: list[bytes] = []
        self.feed(text)

    def handle_starttag(self, tag: str, attrs: list[tuple[str, str | None]]) -> None:
        if tag == "img":
            source = dict(attrs)["src"] or ""
            assert source.startswith("data:image/png;base64,")
            self.pictures.append(base64.b64decode(source.split(",", 1)[1], validate=True))
        elif tag != "meta":
            self.open.append(tag)

    def handle_endtag(self, tag: str) -> None:
        assert self.open.pop() == tag

    def handle_data(self, data: str) -> None:
        if self.open and self.open[-1] == "style":
            return
        self.words.append(data)
        if self.open and self.open[-1] == "th":
            self.heads.append(data)
        if self.open and self.open[-1] == "td":
            self.cells.append(data)
