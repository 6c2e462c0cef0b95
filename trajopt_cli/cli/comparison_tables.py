"""The tables of a comparison."""

from __future__ import annotations

from typing import Any

from rich.table import Table

from trajopt_cli.cli.layout import plain_table
from trajopt_cli.study.comparison import Step


def rows_table(program: str, waits: float, records: list[dict[str, Any]]) -> Table:
    """The rows for people."""
    against = next((record["name"] for record in records if record["legal"]), None)
    saving = (
        f"savings are relative to {against}, the first legal row"
        if against
        else "no row is legal, so there is no saving to show"
    )
    table = plain_table(
        f"{program}: {saving}; T holds {waits:g} s of programmed waits",
        *("plan", "target", ">T [s]", ">saving", ">no waits [s]", ">saving", "legal", ">worst value/limit"),
        ">bound [s]",
    )
    for record in records:
        if "why" in record:
            table.add_row(record["name"], record["target"], "-", "", "", "", "-", "", "")
            continue
        table.add_row(
            record["name"],
            record["target"],
            f"{record['cycle_time_s']:.3f}",
            _share(record["saving"]),
            f"{record['cycle_time_without_waits_s']:.3f}",
            _share(record["saving_without_waits"]),
            "yes" if record["legal"] else f"NO: {record['breaks']}",
            f"{record['worst_ratio']:.3f}",
            "" if record["lower_bound_s"] is None else f"{record['lower_bound_s']:.3f}",
        )
    return table


def _share(value: float | None) -> str:
    return "" if value is None else f"{100 * value:.1f} %"


def causes_table(steps: tuple[Step, ...]) -> Table:
    """Where the seconds went: every step frees one thing more, and the last line is their sum."""
    table = plain_table(
        "saving by cause: each line frees one more thing and is solved and judged anew",
        *("freed", ">T [s]", ">saved [s]", ">of T", ""),
    )
    start = steps[0].plan.duration
    for step in steps:
        first = step is steps[0]
        saved = "" if first else f"{step.saved:.3f}"
        share = "" if first else f"{100 * step.saved / start:.1f} %"
        table.add_row(step.name, f"{step.plan.duration:.3f}", saved, share, step.why_not)
    table.add_section()
    total = sum(step.saved for step in steps)
    table.add_row("sum", f"{steps[-1].plan.duration:.3f}", f"{total:.3f}", f"{100 * total / start:.1f} %", "")
    return table
