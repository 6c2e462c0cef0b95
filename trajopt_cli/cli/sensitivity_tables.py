"""The table of a sensitivity, and what stands below it."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence

from trajopt_cli.problem.plan import Target
from trajopt_cli.study.levers import Lever, LeverKind
from trajopt_cli.study.sensitivity import APART, WORTH, Row
from trajopt_cli.table import TextTable, tabulate

_APART = "≠"
_OFF = 2e-3  # share by which the plan solved again may be off before that is told


def levers_table(
    program: str, target: Target, rows: Sequence[Row], cycle: float, everything: bool, search: bool
) -> TextTable:
    """The levers that save something, or all of them. cycle: of the plan [s]."""

    def lever(text: Callable[[Lever], str]) -> Callable[[Row], str]:
        return lambda row: "" if row.lever.kind is LeverKind.PLACE else text(row.lever)

    columns: dict[str, Callable[[Row], str]] = {
        "~lever": lambda row: row.lever.name,
        "step": lambda row: row.lever.step,
        ">now": lever(lambda one: f"{one.now:.4g}"),
        ">then": lever(lambda one: f"{one.then:.4g}"),
        "": lever(lambda one: one.unit),
        ">saves [s]": lambda row: "-" if row.gain is None else f"{row.gain:.4f}",
        ">of the cycle": lambda row: "" if row.gain is None else f"{100 * row.gain / cycle:.2f} %",
        ">first order [s]": lambda row: "-" if row.first_order is None else f"{row.first_order:.4f}",
    }
    if search:
        columns[">planned anew [s]"] = lambda row: "" if row.searched is None else f"{row.searched:.4f}"
    columns[" "] = lambda row: row.why or (_APART if row.apart else "" if row.active else "not limiting")
    shown = [row for row in rows if everything or row.best > WORTH or row.gain is None]
    return tabulate(f"{program}, {target.value}: what one change saves of {cycle:.3f} s", shown, columns)


def rest_lines(rows: Sequence[Row], cycle: float, again: float, everything: bool) -> Iterator[str]:
    """What the table leaves out, and what its marks mean. cycle, again: of the plan, and of it solved again [s]."""
    if abs(again - cycle) > _OFF * cycle:
        yield f"solved again with nothing changed the plan takes {again:.3f} s: savings count from there"
    if any(row.apart for row in rows if everything or row.best > WORTH):
        yield (
            f"{_APART} linear estimate off by more than {100 * APART:g} %: along the step another limit takes "
            "over, the rail moves, or a corner changes its size"
        )
    if everything:
        return
    asleep = [row.lever.name for row in rows if not row.active]
    if asleep:
        yield f"not limiting, raising these saves nothing: {', '.join(asleep)}"
    little = [row.lever.name for row in rows if row.active and row.gain is not None and 0 <= row.best <= WORTH]
    if little:
        yield f"save a millisecond at most: {', '.join(little)}"
    costs = sum(row.gain is not None and row.gain < 0 and row.best <= WORTH for row in rows)
    if costs:
        yield f"{costs} steps cost time (--all lists them)"
