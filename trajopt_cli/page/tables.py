"""Tables and the places of charts, as HTML."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence
from dataclasses import dataclass

from trajopt_cli.page.encode import text
from trajopt_cli.table import Bad, Good, TextTable


@dataclass(frozen=True)
class Tile:
    """One number of a page's head. kind: "before", "after", "bound" or "" for its colour."""

    name: str
    big: str
    small: str
    kind: str = ""


def head(title: str, about: str, tiles: Iterable[Tile], doubts: Iterable[str] = (), html: bool = False) -> str:
    """Title, a line about it with what was not checked, and the numbers that matter. html: about is HTML."""
    made = "".join(
        f'<div class="tile {one.kind}"><dt>{text(one.name)}</dt><dd class="big">{text(one.big)}</dd>'
        f'<dd class="small">{text(one.small)}</dd></div>'
        for one in tiles
    )
    open_ = "".join(f' · <strong class="bad">{text(one)}</strong>' for one in doubts)
    line = about if html else text(about)
    return f'<h1>{text(title)}</h1><p class="sub">{line}{open_}</p><dl class="tiles">{made}</dl>'


def table(caption: str, heads: Sequence[str], rows: Iterable[Sequence[str]], html: bool = False) -> str:
    """A table that scrolls in a box of its own. heads: as in TextTable. rows: plain text, or HTML where html is
    true."""
    classes = [' class="n"' if head.startswith(">") else "" for head in heads]
    cells = ("".join(_cell(*pair, html) for pair in zip(row, classes, strict=False)) for row in rows)
    made = "".join(f"<tr>{row}</tr>\n" for row in cells)
    pairs = zip(heads, classes, strict=True)
    name, head = text(caption), "".join(f'<th scope="col"{kind}>{text(one.lstrip(">~"))}</th>' for one, kind in pairs)
    return (
        f'<div class="scroll" role="region" aria-label="{name}" tabindex="0"><table><caption>{name}</caption>'
        f"<thead><tr>{head}</tr></thead><tbody>\n{made}</tbody></table></div>"
    )


def drawn(table_: TextTable) -> str:
    """The same of a table of text."""
    return table(table_.title, table_.heads, table_.rows)


def linked(table_: TextTable, first: str) -> str:
    """The same with its first column as HTML. first: of a cell there, with {0} for its text."""
    rows = [(first.format(text(name)), *map(text, rest)) for name, *rest in table_.rows]
    return table(table_.title, table_.heads, rows, html=True)


def numbers(*values: str) -> Iterator[str]:
    """Cells of a table's row that hold figures, given as plain text."""
    return (f'<td class="n">{text(value)}</td>' for value in values)


def chart(name: str, label: str) -> str:
    """Where the chart of this name in data["charts"] is drawn. label: what a screen reader calls it."""
    return f'<figure class="chart" data-chart="{text(name)}" aria-label="{text(label)}"></figure>'


def facts(pairs: Iterable[tuple[str, str]]) -> str:
    """Names and values below each other, plain text."""
    return f'<dl class="facts">{"".join(f"<dt>{text(name)}</dt><dd>{text(value)}</dd>" for name, value in pairs)}</dl>'


def points(lines: Iterable[str]) -> str:
    """A list of plain sentences; nothing for none."""
    made = "".join(f"<li>{text(line)}</li>" for line in lines)
    return f"<ul>{made}</ul>" if made else ""


def _cell(value: str, kind: str, html: bool) -> str:
    shown = value if html else text(value)
    if isinstance(value, Good | Bad):
        shown = f'<span class="{"good" if isinstance(value, Good) else "bad"}">{shown}</span>'
    return f"<td{kind}>{shown}</td>"
