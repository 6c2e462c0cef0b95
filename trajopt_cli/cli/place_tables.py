"""The table of a place, and what stands below it."""

from __future__ import annotations

from collections import Counter
from collections.abc import Callable, Iterator

from trajopt_cli.study.place import Placed, Tried
from trajopt_cli.study.places import Site
from trajopt_cli.table import TextTable, percent, seconds, tabulate
from trajopt_cli.units import DEG, MM

_KINDS = 5  # motions that are named with how many places fail at them


def place_table(program: str, answer: Placed) -> TextTable:
    """The present place, the best one and the others that were planned, the fastest first."""
    site, present, best = answer.site, answer.present, answer.best
    now = answer.seconds(present)
    others = [
        one for one in answer.places.values() if one is not present and one is not best and one.planned is not None
    ]
    rows = [("present", present)] + ([("best", best)] if best is not None and best is not present else [])
    rows += [("", one) for one in sorted(others, key=lambda one: one.planned or 0.0)[:3]]

    def offset(i: int) -> Callable[[tuple[str, Tried]], str]:
        return lambda row: f"{row[1].offset[i] / (DEG if site.ranges[i].turns else MM):.5g}"

    def saved(one: Tried) -> float | None:
        cycle = answer.seconds(one)
        return None if now is None or cycle is None or one is present else now - cycle

    columns: dict[str, Callable[[tuple[str, Tried]], str]] = {"": lambda row: row[0]}
    columns |= {f">{one.key} [{'deg' if one.turns else 'mm'}]": offset(i) for i, one in enumerate(site.ranges)}
    columns |= {
        ">cycle [s]": lambda row: seconds(answer.seconds(row[1]), "cannot be done"),
        ">saves [s]": lambda row: seconds(saved(row[1])),
        ">of it": lambda row: "" if (gain := saved(row[1])) is None or not now else percent(gain / now),
    }
    return tabulate(f"{program}, {answer.target.value}: where {site.in_words} stands", rows, columns)


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
