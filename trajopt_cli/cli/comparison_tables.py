"""The tables of a comparison."""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from typing import Any

from rich.table import Table

from trajopt_cli.cli.layout import plain_table
from trajopt_cli.cli.remarks import by_name
from trajopt_cli.study.comparison import Step

_SHOWN = 3  # failed checks per row; an illegal plan breaks many at once


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
        *("plan", "target", ">T [s]", ">saving", ">without waits [s]", ">saving", "legal", ">worst of limit"),
        *(">bound [s]", "breaks"),
    )
    for record in records:
        if "why" in record:
            table.add_row(record["name"], record["target"], "-", "", "", "", "-", "", "", "")
            continue
        table.add_row(
            record["name"],
            record["target"],
            f"{record['cycle_time_s']:.3f}",
            _share(record["saving"]),
            f"{record['cycle_time_without_waits_s']:.3f}",
            _share(record["saving_without_waits"]),
            "yes" if record["legal"] else "NO",
            f"{record['worst_ratio']:.3f}",
            "" if record["lower_bound_s"] is None else f"{record['lower_bound_s']:.3f}",
            record["breaks"] or "",
        )
    return table


def row_lines(records: list[dict[str, Any]], files: Iterable[str]) -> Iterator[str]:
    """What the rows are, what they may change, and what is wrong with them; rows that cannot be driven for one and the
    same reason stand together."""
    files = list(files)
    groups: dict[str, list[dict[str, Any]]] = {}
    for record in records:
        groups.setdefault(record.get("why") or record["name"], []).append(record)
    for group in groups.values():
        record = group[0]
        names = ", ".join(one["name"] for one in group)
        if "why" in record:
            yield f"{names}: {by_name(record['why'], files)}"
            continue
        yield f"{names}: {record['title']}; may move: {record['moves']}"
        failed = record["failed"]
        for line in (*record["notes"], *(f"not legal: {one}" for one in failed[:_SHOWN])):
            yield f"    {by_name(line, files)}"
        if len(failed) > _SHOWN:
            yield f"    {len(failed) - _SHOWN} checks more failed; --json lists them"


def comparison_line(records: list[dict[str, Any]]) -> str:
    """The comparison in a line: the fastest legal row against the first one."""
    legal = [record for record in records if record["legal"]]
    if not legal:
        return "no row is legal"
    first, best = legal[0], min(legal, key=lambda record: record["cycle_time_s"])
    return (
        f"{best['name']} {best['cycle_time_s']:.3f} s, {_share(best['saving'])} less than {first['name']} "
        f"{first['cycle_time_s']:.3f} s"
    )


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
