"""Where a cycle falls below the speed that the program should keep, and why."""

from __future__ import annotations

from trajopt_cli.page.cycles import Shown
from trajopt_cli.page.tables import table
from trajopt_cli.problem.constant_speed import DIP, Dip
from trajopt_cli.table import place
from trajopt_cli.units import MM

MOST = 200
"""Dips in a table; summary.json has all of them."""


def kept_speed(one: Shown) -> str:
    """A table of the dips of one cycle, or that there are none; nothing where no stretch should keep its speed."""
    if not one.stretches:
        return ""
    dips = [dip for stretch in one.stretches for dip in stretch.dips]
    way = sum(stretch.length for stretch in one.stretches) / MM
    said = f"{one.name}: {way:.1f} mm should keep the programmed speed"
    if not dips:
        return f"<p>{said}, and do within {100 * DIP:g} %.</p>"
    caption = f"{said} within {100 * DIP:g} %; where they do not" + (
        f", the {MOST} longest" if len(dips) > MOST else ""
    )
    heads = ("place", "motion", ">at [mm]", ">programmed [mm/s]", ">slowest [mm/s]", ">for [s]", ">over [mm]", "cause")
    worst = sorted(dips, key=lambda dip: -dip.length)[:MOST]
    return table(caption, heads, map(_row, sorted(worst, key=lambda dip: dip.start)))


def _row(dip: Dip) -> tuple[str, ...]:
    return (
        place(dip.source),
        dip.name,
        f"{dip.along / MM:.1f}",
        f"{dip.programmed / MM:.4g}",
        f"{dip.lowest / MM:.4g}",
        f"{dip.duration:.3f}",
        f"{dip.length / MM:.1f}",
        dip.cause,
    )
