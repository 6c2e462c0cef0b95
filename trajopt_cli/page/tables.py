"""Tables and the places of charts, as HTML."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
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
    right = [head.startswith(">") for head in heads]
    made = "".join(f"<tr>{''.join(_cell(value, right[i], html) for i, value in enumerate(row))}</tr>\n" for row in rows)
    name, head = text(caption), "".join(_head(one) for one in heads)
    return (
        f'<div class="scroll" role="region" aria-label="{name}" tabindex="0"><table><caption>{name}</caption>'
        f"<thead><tr>{head}</tr></thead><tbody>\n{made}</tbody></table></div>"
    )


def drawn(table_: TextTable) -> str:
    """The same of a table of text."""
    return table(table_.title, table_.heads, table_.rows)


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


def _head(head: str) -> str:
    right = head.startswith(">")
    return f'<th scope="col"{_class(right)}>{text(head.lstrip(">~"))}</th>'


def _cell(value: str, right: bool, html: bool) -> str:
    shown = value if html else text(value)
    if isinstance(value, Good | Bad):
        shown = f'<span class="{"good" if isinstance(value, Good) else "bad"}">{shown}</span>'
    return f"<td{_class(right)}>{shown}</td>"


def _class(right: bool) -> str:
    return ' class="n"' if right else ""
