"""The tables of a comparison."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping, Sequence
from typing import Any

from trajopt_cli.cli.remarks import by_name
from trajopt_cli.runs.summary import Settled
from trajopt_cli.runs.uncertainty import within
from trajopt_cli.study.comparison import Step
from trajopt_cli.table import Bad, Good, TextTable, percent, seconds, tabulate

Record = Mapping[str, Any]
_SHOWN = 3  # failed checks per row; an illegal plan breaks many at once


def rows_table(program: str, waits: float, records: Sequence[Record], settling: Settled | None = None) -> TextTable:
    """The rows for people."""
    against = next((record["name"] for record in records if record["legal"]), None)
    saving = (
        f"savings are relative to {against}, the first legal row"
        if against
        else "no row is legal, so there is no saving to show"
    )
    return tabulate(
        f"{program}: {saving}; T holds {waits:g} s of programmed waits"
        f"{'' if settling is None else f' and {settling.line}'}",
        records,
        {
            "plan": lambda row: row["name"],
            "target": lambda row: row["target"],
            ">T [s]": lambda row: within(seconds(row.get("cycle_time_s"), "-"), row.get("cycle_time_range_s")),
            ">saving": lambda row: within(percent(row.get("saving")), row.get("saving_range"), 100),
            ">without waits [s]": lambda row: seconds(row.get("cycle_time_without_waits_s")),
            ">of it saved": lambda row: percent(row.get("saving_without_waits")),
            "legal": lambda row: "-" if "why" in row else Good("yes") if row["legal"] else Bad("NO"),
            ">worst of limit": lambda row: seconds(row.get("worst_ratio")),
            ">bound [s]": lambda row: seconds(row.get("lower_bound_s")),
            "breaks": lambda row: row.get("breaks") or "",
        },
    )


def row_lines(records: Sequence[Record], files: Iterable[str]) -> Iterator[str]:
    """What the rows are, what they may change, and what is wrong with them; rows that cannot be driven for one and the
    same reason stand together."""
    files = list(files)
    groups: dict[str, list[Record]] = {}
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


def comparison_line(records: Sequence[Record]) -> str:
    """The comparison in a line: the fastest legal row against the first one."""
    legal = [record for record in records if record["legal"]]
    if not legal:
        return "no row is legal"
    first, best = legal[0], min(legal, key=lambda record: record["cycle_time_s"])
    return (
        f"{best['name']} {best['cycle_time_s']:.3f} s, {percent(best['saving'])} less than {first['name']} "
        f"{first['cycle_time_s']:.3f} s"
    )


def causes_table(steps: Sequence[Step]) -> TextTable:
    """Where the seconds went: every step frees one thing more, and the last line is their sum."""
    start, total = steps[0].plan.duration, sum(step.saved for step in steps)
    later = {id(step) for step in steps[1:]}
    return tabulate(
        "saving by cause: each line frees one more thing and is solved and judged again",
        steps,
        {
            "freed": lambda step: step.name,
            ">T [s]": lambda step: seconds(step.plan.duration),
            ">saved [s]": lambda step: seconds(step.saved) if id(step) in later else "",
            ">of T": lambda step: percent(step.saved / start) if id(step) in later else "",
            "": lambda step: step.why_not,
        },
        ("sum", seconds(steps[-1].plan.duration), seconds(total), percent(total / start), ""),
    )
