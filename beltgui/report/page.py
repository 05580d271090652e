"""A page of sections, tables and pictures as one HTML file that needs no other."""

from __future__ import annotations

import base64
from collections.abc import Iterable, Sequence
from dataclasses import dataclass, field
from html import escape

STYLE = """
:root { --ink: #212529; --soft: #6c757d; --line: #dee2e6; --ok: #146c43; --bad: #b02a37; }
* { box-sizing: border-box; }
body { font: 15px/1.5 system-ui, "DejaVu Sans", sans-serif; color: var(--ink); background: #f4f5f6; margin: 0; }
main { max-width: 1240px; margin: 0 auto; padding: 24px; background: white; }
h1 { margin: 0 0 4px; font-size: 26px; } h2 { margin: 36px 0 8px; font-size: 20px; }
.lead { color: var(--soft); margin: 0 0 16px; }
.verdict { padding: 12px 16px; color: white; border-radius: 4px; font-weight: 600; }
.verdict.ok { background: var(--ok); } .verdict.bad { background: var(--bad); }
.ok { color: var(--ok); font-weight: 600; } .bad { color: var(--bad); font-weight: 600; }
.verdict.ok, .verdict.bad { color: white; }
.wide { overflow-x: auto; }
table { border-collapse: collapse; margin: 12px 0; width: 100%; }
th, td { text-align: left; padding: 5px 10px; border-bottom: 1px solid var(--line); vertical-align: top; }
th { border-bottom: 2px solid var(--ink); font-weight: 600; }
td.vector { white-space: nowrap; }
td.number { text-align: right; font-variant-numeric: tabular-nums; white-space: nowrap; }
figure { margin: 16px 0; } figure img { max-width: 100%; border: 1px solid var(--line); }
figcaption { color: var(--soft); font-size: 14px; }
@media print { body { background: white; } h2 { break-after: avoid; } figure { break-inside: avoid; } }
"""


@dataclass(frozen=True)
class Table:
    """A table; `caption` says the units where the columns do not."""

    columns: Sequence[str]
    rows: Sequence[Sequence[str]]
    caption: str = ""


@dataclass(frozen=True)
class Figure:
    """A picture (PNG) with a caption that says what to see in it."""

    png: bytes
    caption: str


@dataclass(frozen=True)
class Section:
    """A part of the page, usually one step."""

    title: str
    text: str = ""
    accepted: bool | None = None
    reasons: Sequence[str] = ()
    tables: Sequence[Table] = ()
    figures: Sequence[Figure] = ()


@dataclass(frozen=True)
class Page:
    """The whole report."""

    title: str
    lead: str
    accepted: bool
    headline: str
    sections: Sequence[Section] = field(default_factory=tuple)


def render(page: Page) -> str:
    """The page as HTML text."""
    word = "✔ Accepted" if page.accepted else "✖ Rejected"
    kind = "ok" if page.accepted else "bad"
    body = "\n".join(_section(section) for section in page.sections)
    return (
        '<!DOCTYPE html>\n<html lang="en"><head><meta charset="utf-8">'
        '<meta name="viewport" content="width=device-width, initial-scale=1">'
        f"<title>{escape(page.title)}</title><style>{STYLE}</style></head><body><main>\n"
        f'<h1>{escape(page.title)}</h1><p class="lead">{escape(page.lead)}</p>\n'
        f'<div class="verdict {kind}">{word}. {escape(page.headline)}</div>\n{body}\n</main></body></html>\n'
    )


def vector_text(value_mm: Iterable[float]) -> str:
    """A point or a translation with its unit."""
    return "(" + ", ".join(f"{number:.3f}" for number in value_mm) + ") mm"


def _section(section: Section) -> str:
    parts = [f"<section><h2>{escape(section.title)}</h2>"]
    if section.accepted is not None:
        word, kind = ("✔ accepted", "ok") if section.accepted else ("✖ rejected", "bad")
        parts.append(f'<p class="{kind}">{word}</p>')
    parts += [f'<p class="bad">{escape(reason)}</p>' for reason in section.reasons]
    if section.text:
        parts.append(f"<p>{escape(section.text)}</p>")
    parts += [_table(table) for table in section.tables]
    parts += [_figure(figure) for figure in section.figures]
    return "\n".join([*parts, "</section>"])


def _table(table: Table) -> str:
    head = "".join(f"<th>{escape(column)}</th>" for column in table.columns)
    rows = "".join("<tr>" + "".join(_cell(cell) for cell in row) + "</tr>" for row in table.rows)
    caption = f'<p class="lead">{escape(table.caption)}</p>' if table.caption else ""
    return f'<div class="wide"><table><thead><tr>{head}</tr></thead><tbody>{rows}</tbody></table></div>{caption}'


def _cell(text: str) -> str:
    kind = ' class="number"' if _is_number(text) else ""
    if text.startswith("("):
        kind = ' class="vector"'
    if text in ("accepted", "rejected"):
        kind = ' class="ok"' if text == "accepted" else ' class="bad"'
    return f"<td{kind}>{escape(text)}</td>"


def _is_number(text: str) -> bool:
    try:
        float(text)
    except ValueError:
        return False
    return True


def _figure(figure: Figure) -> str:
    data = base64.b64encode(figure.png).decode("ascii")
    caption = escape(figure.caption)
    return (
        f'<figure><img alt="{caption}" src="data:image/png;base64,{data}"><figcaption>{caption}</figcaption></figure>'
    )
