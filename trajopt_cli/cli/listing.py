"""A program's motions as a table, in the units of RAPID: mm, deg, mm/s."""

from __future__ import annotations

from rich.table import Table

from trajopt_cli.cli.layout import place, plain_table
from trajopt_cli.rapid.listing import Listing, Row


def listing_table(program: str, listing: Listing) -> Table:
    """One line per motion."""
    title = f"{program}: positions in mm, world; joints in deg; external axes as written"
    table = plain_table(
        title,
        "place",
        "instruction",
        "target",
        "to",
        "orientation w x y z",
        "ext. axes",
        "conf",
        "speed",
        "zone",
        "tool",
        "",
    )
    for row in listing.rows:
        tool = " ".join(part for part in (row.tool, row.wobj) if part)
        table.add_row(
            place(row.source),
            row.instruction,
            row.target or "",
            _figures(row.position or row.joints),
            _figures(row.orientation, 5),
            " ".join("-" if value is None else f"{value:g}" for value in row.extax or ()).rstrip(" -"),
            "" if row.conf is None else f"{row.conf.cf1},{row.conf.cf4},{row.conf.cf6},{row.conf.cfx}",
            row.speed or "",
            row.zone or "",
            tool,
            _rest(row),
        )
    return table


def _figures(values: tuple[float, ...] | None, digits: int = 2) -> str:
    # + 0.0 takes the sign off a zero
    return " ".join(f"{round(value, digits) + 0.0:g}" for value in values or ())


def _rest(row: Row) -> str:
    parts = []
    if row.duration is not None:
        parts.append(f"{'at least ' if row.instruction == 'Wait' else ''}{row.duration:g} s")
    if row.value is not None:
        parts.append(f"= {row.value:g}")
    if row.optional:
        parts.append("optional")
    return ", ".join(parts)
