"""The tables, lines and record of `trajopt compare runs`."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from typing import Any

from rich.table import Table

from trajopt_cli.cli.layout import plain_table
from trajopt_cli.problem.plan import Target
from trajopt_cli.runs.compared import ComparedRuns, MotionRow
from trajopt_cli.runs.inputs_compared import Difference

_LONGEST = 24  # letters of a motion's name: two runs are to fit in 80 columns


def cycles_table(answer: ComparedRuns) -> Table:
    """Cycle time, bound and gap of each run by target, and the difference to the first."""
    table = plain_table("cycle times", "plan", "run", ">cycle [s]", ">bound [s]", ">gap", ">against A [s]")
    for target in Target:
        first = answer.runs[0].plans[target].cycle
        for run in answer.runs:
            plan = run.plans[target]
            bound = "" if plan.bound is None else f"{plan.bound:.3f}"
            gap = "" if plan.gap is None else f"{100 * plan.gap:.1f} %"
            change = "" if run is answer.runs[0] else _change(plan.cycle, first)
            table.add_row(str(target), run.letter, f"{plan.cycle:.3f}", bound, gap, change)
    before = answer.runs[0].written
    for run in answer.runs:
        told = "" if run.written is None else f"{run.written:.3f}"
        counts = run is not answer.runs[0] and run.written is not None and before is not None
        change = _change(run.written or 0.0, before or 0.0) if counts else ""
        table.add_row("as written", run.letter, told or "not driven", "", "", change)
    return table


def runs_line(answer: ComparedRuns) -> str:
    """The cycle times of the plans that are put side by side, in a line."""
    cycles = [(run.letter, run.plans[answer.target].cycle) for run in answer.runs]
    told = (
        f"{letter} {cycle:.3f} s" + (f", {_change(cycle, cycles[0][1])} against A" if letter != "A" else "")
        for letter, cycle in cycles
    )
    return f"{answer.target} plans: {', '.join(told)}"


def inputs_lines(answer: ComparedRuns, diff: bool = False) -> Iterator[str]:
    """What differs in what the runs were made from; diff: with the changed lines of the program."""
    said = False
    for letter, changes in answer.modules.items():
        for one in changes:
            said = True
            yield f"program {one.name}: {letter} has +{one.added} −{one.removed} lines against A"
            if diff:
                yield from (f"    {line}" for line in one.diff)
    for difference in (*answer.limits, *answer.inputs):
        said = True
        yield difference_line(answer, difference)
    if not said:
        yield "the inputs are the same: program, cell file, options and versions"


def difference_line(answer: ComparedRuns, one: Difference) -> str:
    """ "cell rail.stroke: A [-0.2, 2.2], B [-0.2, 1.8]"; runs of the same value together."""
    groups: dict[str | None, str] = {}
    for run, value in zip(answer.runs, one.values, strict=True):
        groups[value] = groups.get(value, "") + run.letter
    told = "; ".join(f"{', '.join(letters)} {'–' if value is None else value}" for value, letters in groups.items())
    kind = "" if one.kind else "limit "
    return f"{kind}{one.what}: {told}"


def motions_table(answer: ComparedRuns, rows: Sequence[MotionRow]) -> Table:
    """Times of motions in each run; a motion that a run does not have, or drops, says so."""
    heads = [f">{run.letter} [s]" for run in answer.runs]
    if len(answer.runs) == 2:
        heads.append(">B − A [s]")
    missing = "not there" if len(answer.runs) == 2 else "–"
    table = plain_table(f"motions of the {answer.target} plans", "place", "motion", *heads)
    for row in rows:
        times = [missing if one is None else "dropped" if one.dropped else f"{one.time_s:.3f}" for one in row.motions]
        if len(answer.runs) == 2:
            times.append(_signed(row.times[1] - row.times[0]))
        table.add_row(row.any.place, shortened(row.any.name), *times)
    return table


def bindings(answer: ComparedRuns) -> Iterator[str]:
    """The motions that different limits hold back, and which."""
    rows = answer.bound_otherwise
    if rows:
        yield ""
        yield f"{len(rows)} motion{'s' if len(rows) > 1 else ''} held back by different limits:"
    for row in rows:
        told = [
            f"{run.letter} {binding}"
            for run, binding in zip(answer.runs, row.bindings, strict=True)
            if binding is not None
        ]
        yield f"{row.any.place} {shortened(row.any.name)}: {'; '.join(told)}"


def runs_record(answer: ComparedRuns) -> dict[str, Any]:
    """The whole comparison as plain data, in SI."""
    return {
        "target": answer.target.value,
        "runs": [
            {
                "run": run.letter,
                "folder": str(run.folder),
                "chosen": run.target.value,
                "as_written_s": run.written,
                "plans": {
                    target.value: {
                        "cycle_time_s": plan.cycle,
                        "lower_bound_s": plan.bound,
                        "gap": plan.gap,
                        "legal": plan.judge.legal,
                        "against_first_s": plan.cycle - answer.runs[0].plans[target].cycle,
                    }
                    for target, plan in run.plans.items()
                },
            }
            for run in answer.runs
        ],
        "program": {
            letter: [
                {"module": one.name, "lines_added": one.added, "lines_removed": one.removed, "diff": list(one.diff)}
                for one in changes
            ]
            for letter, changes in answer.modules.items()
        },
        "limits": [_difference(one) for one in answer.limits],
        "inputs": [_difference(one) for one in answer.inputs],
        "motions": [_motion(row) for row in answer.rows],
        "notes": list(answer.notes),
    }


def _difference(one: Difference) -> dict[str, Any]:
    return {"kind": one.kind or "limit", "name": one.name, "values": list(one.values)}


def _motion(row: MotionRow) -> dict[str, Any]:
    return {
        "instruction": row.any.instruction,
        "target": row.any.target,
        "sources": [None if one is None else one.source for one in row.motions],
        "times_s": [None if one is None else one.time_s for one in row.motions],
        "dropped": [None if one is None else one.dropped for one in row.motions],
        "bindings": [None if one is None else one.binding for one in row.motions],
        "spread_s": row.spread,
    }


def shortened(name: str) -> str:
    """A motion's name; of a long one the beginning and the end."""
    half = _LONGEST // 2
    return name if len(name) <= _LONGEST else f"{name[:half]}…{name[1 - half :]}"


def _change(now: float, before: float) -> str:
    return f"{_signed(now - before)} ({100 * (now / before - 1):+.1f} %)".replace("-", "−") if before > 0 else ""


def _signed(seconds: float) -> str:
    told = f"{seconds:+.3f}".replace("-", "−")
    return "0.000" if told[1:] == "0.000" else told
