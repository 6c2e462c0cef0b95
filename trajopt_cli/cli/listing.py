"""A program's motions as a table and as records, in the units of RAPID: mm, deg, mm/s."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import asdict
from typing import Any

from rich.table import Table

from trajopt_cli.cli.layout import place, plain_table
from trajopt_cli.rapid.listing import Listing, Row


def listing_record(listing: Listing, warnings: Iterable[str]) -> dict[str, Any]:
    """The listing as plain data; mm, deg, mm/s, quaternions scalar first."""
    return {
        "motions": [asdict(row) | {"source": str(row.source)} for row in listing.rows],
        "line_length_mm": listing.line_length,
        "fly_by_zones": listing.fly_by,
        "warnings": list(warnings),
    }


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
