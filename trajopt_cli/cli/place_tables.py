"""The table of a place, and what stands below it."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterator

from rich.table import Table

from trajopt_cli.cli.layout import plain_table
from trajopt_cli.study.place import Placed, Tried
from trajopt_cli.study.places import Site
from trajopt_cli.units import DEG, MM

_KINDS = 5  # motions that are named with how many places fail at them


def place_table(program: str, answer: Placed) -> Table:
    """The present place, the best one and the others that were planned, the fastest first."""
    site = answer.site
    heads = [f">{one.key} [{'deg' if one.turns else 'mm'}]" for one in site.ranges]
    table = plain_table(
        f"{program}, {answer.target.value}: where {site.in_words} stands",
        "",
        *heads,
        ">cycle [s]",
        ">saves [s]",
        ">of it",
    )
    present, best = answer.present, answer.best
    now = answer.seconds(present)
    others = [one for one in answer.places.values() if one is not present and one is not best]
    ordered = sorted((one for one in others if one.planned is not None), key=lambda one: one.planned or 0.0)
    rows = [("present", present)] + [("best", best)] * (best is not None and best is not present)
    for name, one in [*rows, *(("", one) for one in ordered[:3])]:
        assert one is not None
        cycle = answer.seconds(one)
        figures = [
            f"{value / (DEG if range_.turns else MM):.5g}"
            for range_, value in zip(site.ranges, one.offset, strict=True)
        ]
        saves = None if now is None or cycle is None or one is present else now - cycle
        told = ["", ""] if saves is None or now is None else [f"{saves:.3f}", f"{100 * saves / now:.1f} %"]
        table.add_row(name, *figures, "cannot be done" if cycle is None else f"{cycle:.3f}", *told)
    return table


def impossible_lines(answer: Placed) -> Iterator[str]:
    """How many places cannot be done, at which motions, and why at the nearest one."""
    bad = answer.impossible
    if not bad:
        return
    named = Counter(one.motion or one.why.split(":")[0] for one in bad)
    kinds = ", ".join(f"{name} ({count})" for name, count in named.most_common(_KINDS))
    yield f"{len(bad)} of {len(answer.places)} places cannot be done: {kinds}"
    yield f"{said(answer.site, bad[0])}: {bad[0].why}"


def said(site: Site, one: Tried) -> str:
    """Which place that is."""
    return "the present place" if not any(one.offset) else f"the nearest, {site.shown(one.offset)}"
