"""Runs side by side as tables and as plain data: what `compare runs` prints, its --json and its page say the same."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from functools import partial
from typing import Any

from trajopt_cli.problem.plan import Target
from trajopt_cli.runs.compared import AlignedMotion, ComparedRuns, Difference, OneRun
from trajopt_cli.table import TOLD_GAP, Bad, Good, TextTable, percent, seconds, signed, tabulate


def cycles_table(answer: ComparedRuns) -> TextTable:
    """Cycle time, bound, gap and verdict of each run by target, and the difference to the first."""
    first = answer.runs[0]

    def row(run: OneRun, target: Target) -> tuple[str, ...]:
        plan = run.plans[target]
        against = "" if run is first else difference(plan.cycle_time_s, first.plans[target].cycle_time_s)
        legal = Good("yes") if plan.judge.legal else Bad("no")
        gap = percent(plan.gap if (plan.gap or 0.0) <= TOLD_GAP else None)
        times = seconds(plan.cycle_time_s), seconds(plan.lower_bound_s)
        return str(target), run.letter, *times, gap, against, legal

    def written(run: OneRun) -> tuple[str, ...]:
        counts = run is not first and run.written is not None and first.written is not None
        against = difference(run.written or 0.0, first.written or 0.0) if counts else ""
        return "as written", run.letter, seconds(run.written, "not driven"), "", "", against, ""

    rows = [row(run, target) for target in Target for run in answer.runs] + [written(run) for run in answer.runs]
    heads = ("plan", "run", ">cycle [s]", ">bound [s]", ">gap", ">against A [s]", "legal")
    return TextTable("cycle times", heads, tuple(rows))


def motions_table(answer: ComparedRuns, rows: Sequence[AlignedMotion]) -> TextTable:
    """Times of motions in each run; a motion that a run does not have, or drops, says so."""
    two = len(answer.runs) == 2

    def time(n: int, row: AlignedMotion) -> str:
        motion = row.motions[n]
        if motion is None:
            return "not there" if two else "–"
        return "dropped" if motion.dropped else seconds(motion.time_s)

    columns: dict[str, Callable[[AlignedMotion], str]] = {
        f">{run.letter} [s]": partial(time, n) for n, run in enumerate(answer.runs)
    }
    if two:
        columns[">B − A [s]"] = lambda row: signed(row.times[1] - row.times[0])
    else:
        columns[">spread [s]"] = lambda row: seconds(row.spread)
    return tabulate(f"motions of the {answer.target} plans", rows, _NAMED | columns)


def bindings_table(answer: ComparedRuns) -> TextTable:
    """The motions that different limits hold back, and which."""
    columns = {run.letter: partial(lambda n, row: _known(row.bindings[n]), n) for n, run in enumerate(answer.runs)}
    return tabulate("what limits each", answer.bound_otherwise, _NAMED | columns)


def inputs_table(answer: ComparedRuns) -> TextTable:
    """Limits, keys of the cell file, options and versions that differ."""
    columns: dict[str, Callable[[Difference], str]] = {"what": named}
    columns |= {run.letter: partial(lambda n, row: _known(row.values[n]), n) for n, run in enumerate(answer.runs)}
    return tabulate("cell file, limits in force, options, versions", (*answer.limits, *answer.inputs), columns)


def inputs_lines(answer: ComparedRuns, diff: bool = False) -> Iterator[str]:
    """The same, line by line, behind the program's changes; diff: with the lines that changed."""
    changed = [(letter, one) for letter, changes in answer.modules.items() for one in changes]
    for letter, one in changed:
        yield f"program {one.name}: {letter} has +{one.added} −{one.removed} lines against A"
        yield from (f"    {line}" for line in (one.diff if diff else ()))
    differing = (*answer.limits, *answer.inputs)
    for each in differing:
        groups: dict[str, str] = {}
        for run, value in zip(answer.runs, each.values, strict=True):
            groups[_known(value)] = groups.get(_known(value), "") + run.letter
        told = "; ".join(f"{', '.join(runs)} {value}" for value, runs in groups.items())
        yield f"{named(each)}: {told}"
    if not changed and not differing:
        yield "the inputs are the same: program, cell file, options and versions"


def runs_line(answer: ComparedRuns) -> str:
    """The cycle times of the plans that are put side by side, in a line."""
    first = answer.runs[0].plans[answer.target].cycle_time_s
    told = [f"{run.letter} {run.plans[answer.target].cycle_time_s:.3f} s" for run in answer.runs]
    told[1:] = [
        f"{text}, {difference(run.plans[answer.target].cycle_time_s, first)} against A"
        for text, run in zip(told[1:], answer.runs[1:], strict=True)
    ]
    return f"{answer.target} plans: {', '.join(told)}"


def runs_record(answer: ComparedRuns) -> dict[str, Any]:
    """The whole comparison as plain data, in SI."""

    def differences(found: Sequence[Difference]) -> list[dict[str, Any]]:
        return [{"kind": one.kind or "limit", "name": one.name, "values": list(one.values)} for one in found]

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
                        **plan.model_dump(include={"cycle_time_s", "lower_bound_s", "gap"}),
                        "legal": plan.judge.legal,
                        "against_first_s": plan.cycle_time_s - answer.runs[0].plans[target].cycle_time_s,
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
        "limits": differences(answer.limits),
        "inputs": differences(answer.inputs),
        "motions": [
            {
                "instruction": row.any.instruction,
                "target": row.any.target,
                "sources": [None if one is None else one.source for one in row.motions],
                "times_s": [None if one is None else one.time_s for one in row.motions],
                "dropped": [None if one is None else one.dropped for one in row.motions],
                "bindings": [None if one is None else one.binding for one in row.motions],
                "spread_s": row.spread,
            }
            for row in answer.rows
        ],
        "notes": list(answer.notes),
    }


def difference(now: float, before: float) -> str:
    """Of two times: "−0.105 (−1.9 %)"; nothing where there is no time before."""
    return f"{signed(now - before)} ({signed(100 * (now / before - 1), 1)} %)" if before > 0 else ""


def named(one: Difference) -> str:
    """What differs: "cell rail.stroke", "limit joint_1 speed"."""
    return one.what if one.kind else f"limit {one.what}"


_NAMED: dict[str, Callable[[AlignedMotion], str]] = {
    "place": lambda row: row.any.place,
    "~motion": lambda row: row.any.name,
}


def _known(value: str | None) -> str:
    return "–" if value is None else value
