"""How answers look: tables that fit the terminal, lines that hang below their beginning, places without folders."""

from __future__ import annotations

import os
from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from itertools import zip_longest
from textwrap import wrap

from rich.console import Console, ConsoleOptions, RenderResult
from rich.segment import Segment
from rich.style import Style

from trajopt_cli.cli.listing import shortened
from trajopt_cli.table import TextTable

_GAPS = (3, 2, 1)  # characters between columns, the widest that fits
_INDENT = "    "  # of what does not fit and stands below
_LEAST = 12  # characters that a name keeps when it is cut in the middle


@dataclass(frozen=True)
class Fitted:
    """A table that is never wider than the terminal and loses no figure there: columns move together, heads take
    several lines, names are cut in the middle, and at last the columns on the right stand below each row."""

    table: TextTable

    def __rich_console__(self, console: Console, options: ConsoleOptions) -> RenderResult:
        """The lines, none with spaces at its end; heads in bold on a terminal, unless NO_COLOR is set."""
        heads, rows = self.table.heads, self.table.rows
        columns = [
            Column(head.lstrip(">~"), [row[i] for row in rows], head.startswith(">"), _LEAST * head.startswith("~"))
            for i, head in enumerate(heads)
        ]
        bold = None if os.environ.get("NO_COLOR") else Style(bold=True)
        sections = [self.table.total and i == len(rows) - 2 for i in range(len(rows))]
        for line, head in table_lines(self.table.title, columns, sections, options.max_width):
            yield Segment(line, bold if head else None)
            yield Segment.line()


@dataclass(frozen=True)
class Column:
    """A column of text. right: set flush right. least: to how many characters its cells may be cut, 0 for not."""

    head: str
    cells: Sequence[str]
    right: bool = False
    least: int = 0

    def width(self, split: bool) -> int:
        """What the column needs; of a split head the longest word counts."""
        parts = self.head.split() if split else [self.head]
        return max(map(len, (*parts, *self.cells)), default=0)

    def set(self, text: str, width: int) -> str:
        """A text in the column."""
        return text.rjust(width) if self.right else text.ljust(width)


def table_lines(
    title: str, columns: Sequence[Column], sections: Sequence[bool], width: int
) -> Iterator[tuple[str, bool]]:
    """A table's lines, none wider than width unless one cell is, and of each whether it belongs to the heads.

    sections: of each row whether a section ends with it.
    """
    for text in wrapped(title, width):
        yield text, False
    yield "", False
    columns = [one for one in columns if one.width(split=False)]
    widths, gap = _fitted(columns, width)
    beside, below = columns[: len(widths)], columns[len(widths) :]

    def line(texts: Sequence[str]) -> str:
        parts = (one.set(text, w) for one, text, w in zip(beside, texts, widths, strict=True))
        return (" " * gap).join(parts).rstrip()

    heads = [wrap(one.head, w, break_long_words=False)[::-1] for one, w in zip(beside, widths, strict=True)]
    for texts in [*zip_longest(*heads, fillvalue="")][::-1]:
        yield line(texts), True
    yield "─" * (sum(widths) + gap * (len(widths) - 1)), False
    for i, end in enumerate(sections):
        cells = zip(beside, widths, strict=True)
        yield line([shortened(one.cells[i], w) if one.least else one.cells[i] for one, w in cells]), False
        rest = [f"{one.head}: {one.cells[i]}" if one.head else one.cells[i] for one in below if one.cells[i]]
        for text in wrapped(", ".join(rest), width, _INDENT) if rest else ():
            yield text, False
        if end and i < len(sections) - 1:
            yield "", False
    yield "", False


def _fitted(columns: Sequence[Column], width: int) -> tuple[list[int], int]:
    """The widths of the columns that stand beside each other, and the gap between them."""

    def left(widths: Sequence[int], gap: int) -> int:
        return width - sum(widths) - gap * (len(widths) - 1)

    for split in (False, True):
        widths = [one.width(split) for one in columns]
        for gap in _GAPS:
            if left(widths, gap) >= 0:
                return widths, gap
    whole = list(widths)
    while left(widths, _GAPS[-1]) < 0:
        room = [i for i, one in enumerate(columns[: len(widths)]) if one.least and widths[i] > one.least]
        if room:
            widths[max(room, key=lambda i: widths[i])] -= 1
        elif len(widths) > 1:
            widths = whole[: len(widths) - 1]
        else:
            break
    return widths, next((gap for gap in _GAPS if left(widths, gap) >= 0), 1)


def wrapped(text: str, width: int, indent: str = "", deeper: str = "") -> list[str]:
    """A text as lines of at most width, the first indented, all others deeper. No word is broken: a path stays one."""
    return wrap(
        text,
        width,
        initial_indent=indent,
        subsequent_indent=indent + deeper,
        break_long_words=False,
        break_on_hyphens=False,
    )
