"""How a table looks."""

from __future__ import annotations

from pathlib import PurePath

from rich import box
from rich.table import Table

from trajopt_cli.motion import Source


def plain_table(title: str, *columns: str) -> Table:
    """A plain table; a column whose name begins with '>' is set flush right."""
    table = Table(title=title, title_justify="left", box=box.SIMPLE_HEAD, pad_edge=False)
    for column in columns:
        table.add_column(column.lstrip(">"), justify="right" if column.startswith(">") else "left")
    return table


def place(source: Source | None) -> str:
    """The file's name and the line; the title says where the file is, and a path would fill the terminal."""
    return f"{PurePath(source.file).name}:{source.line}" if source else ""
