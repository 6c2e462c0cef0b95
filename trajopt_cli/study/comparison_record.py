"""A comparison's rows and saving by cause, as plain data, as CSV, as tables, and as a folder with its page."""

from __future__ import annotations

import csv
import io
import math
from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import replace
from pathlib import Path
from typing import Any, ClassVar

from trajopt_cli.findings import Report, failures
from trajopt_cli.page.compared import compared_page
from trajopt_cli.page.cycles import Shown
from trajopt_cli.page.optimized import Provenance
from trajopt_cli.pipeline.optimize import held_by_default, inputs_of, made_by
from trajopt_cli.problem.plan import Infeasible, NoPlan, Plan
from trajopt_cli.runs import REPORT
from trajopt_cli.runs.folder import COMPARISON
from trajopt_cli.runs.record import RunRecord, Section, as_json, sha256
from trajopt_cli.runs.summary import Settled
from trajopt_cli.runs.uncertainty import within
from trajopt_cli.study.answers import write_answer
from trajopt_cli.study.comparison import Comparison, Row, Step, Tried
from trajopt_cli.table import Bad, Good, TextTable, by_name, percent, seconds, tabulate

Record = Mapping[str, Any]

_COLUMNS = (
    "name", "target", "cycle_time_s", "saving", "cycle_time_without_waits_s", "saving_without_waits", "legal",
    "breaks", "worst_ratio", "lower_bound_s", "moves", "title", "why",
)  # fmt: skip
_RATIOS = frozenset((
    "joint speed", "joint acceleration", "joint jerk", "joint torque", "TCP speed", "TCP acceleration",
    "programmed speed", "programmed reorientation",
))  # fmt: skip
_SHOWN = 3  # failed checks per row; an illegal plan breaks many at once


def worst_ratio(report: Report) -> float:
    """The largest speed, acceleration or torque relative to its limit; above 1 one of them is over."""
    ratios = [one.value / one.limit for one in report.findings if one.check in _RATIOS and one.limit > 0]
    return max(ratios, default=math.nan)


def comparison_record(answer: Comparison) -> dict[str, Any]:
    """The whole comparison as plain data: rows, the saving by cause, and the seconds of programmed waiting."""
    causes: dict[str, Any] = {"why_not": answer.steps}
    if not isinstance(answer.steps, str):
        steps = [(one.name, one.plan.duration, one.saved, one.why_not or None) for one in answer.steps]
        keys = ("name", "cycle_time_s", "saved_s", "why_not")
        causes = {"steps": [dict(zip(keys, one, strict=True)) for one in steps]}
    return {
        "program": str(answer.job.program_path),
        "programmed_waits_s": answer.waits,
        "settling": None if answer.settling is None else answer.settling.model_dump(),
        "rows": row_records(answer),
        "saving_by_cause": causes,
        "guesses": answer.unsure.model_dump()["guesses"],
    }


def row_records(answer: Comparison) -> list[dict[str, Any]]:
    """Rows as plain data; a saving is the share of the first legal row's cycle time, counted for legal rows only."""
    records: list[dict[str, Any]] = []
    reference: float | None = None
    standing = answer.standing
    for row in answer.rows:
        record: dict[str, Any] = {
            "name": row.name,
            "target": row.baseline.target.value,
            "title": row.baseline.title,
            "moves": row.baseline.moves,
        }
        match row.result:
            case Tried(attempt=attempt, report=report):
                time = attempt.trajectory.duration
                if reference is None and report.legal:
                    reference = time
                counted = reference is not None and report.legal
                bound = attempt.plan.lower_bound if attempt.plan is not None and row.baseline.optimum else None
                record |= {
                    "cycle_time_s": time,
                    "cycle_time_range_s": answer.unsure.cycle_time_range_s.get(row.name),
                    "saving_range": answer.unsure.saving_range.get(row.name),
                    "cycle_time_without_waits_s": time - standing,
                    "saving": 1.0 - time / reference if counted and reference else None,
                    "saving_without_waits": (
                        1.0 - (time - standing) / (reference - standing) if counted and reference else None
                    ),
                    "legal": report.legal,
                    "breaks": next((one.check for one in report.findings if not one.passed), None),
                    "failed": failures(report.findings),
                    "worst_ratio": worst_ratio(report),
                    "lower_bound_s": bound,
                    "notes": list(attempt.notes),
                }
            case Infeasible() as no:
                record |= {"legal": False, "why": str(no)}
            case NoPlan(message=message):
                record |= {"legal": False, "why": f"no plan found: {message}"}
            case str(why):
                record |= {"legal": None, "why": why}
        records.append(record)
    return records


def rows_csv(records: list[dict[str, Any]]) -> str:
    """The rows as CSV, a header and a line for each; empty where there is nothing to say."""
    out = io.StringIO()
    writer = csv.DictWriter(out, _COLUMNS, extrasaction="ignore", lineterminator="\n")
    writer.writeheader()
    for record in records:
        writer.writerow({name: "" if record.get(name) is None else record[name] for name in _COLUMNS})
    return out.getvalue()


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


class ComparisonOptions(Section):
    """As the user gave them; loops as in optimize."""

    program: list[str]
    cell: str
    entry: str
    assume_identity: list[str]
    loops: str


class ComparisonRecord(RunRecord[ComparisonOptions]):
    """run.json of trajopt compare baseline."""

    KIND: ClassVar[str] = COMPARISON
    LIBRARIES: ClassVar[tuple[str, ...]] = ("casadi", "numpy", "pin", "ruckig", "scipy", "toppra")


def write_comparison(folder: Path, answer: Comparison, options: ComparisonOptions) -> int:
    """Write comparison.json, comparison.csv, report.html and the inputs; how many files that are. Raises InputError
    where folder may not be replaced."""
    record = comparison_record(answer)
    files = {
        "comparison.json": as_json(record),
        "comparison.csv": rows_csv(record["rows"]).encode(),
        REPORT: comparison_page(answer, options),
    }
    return write_answer(folder, ComparisonRecord, answer.job, files, options, "compare baseline")


def comparison_page(answer: Comparison, options: ComparisonOptions) -> bytes:
    """report.html, which shows all of an answer."""
    job = answer.job
    record = comparison_record(answer)
    motions = [_shown(row, one.get("lower_bound_s")) for row, one in zip(answer.rows, record["rows"], strict=True)]
    hashes = {path: sha256(given.content) for path, given in inputs_of(job).items()}
    made = Provenance(made_by("compare baseline", ComparisonRecord, options), hashes)
    notices = (*map(str, job.program.warnings), *answer.notices, *held_by_default(job))
    return compared_page(job.title, job.program, job.plant, record, motions, notices, made)


def _shown(row: Row, bound: float | None) -> Shown | None:
    """A row's motion as a page shows it; None where there is none. bound [s]: as the row's record has it."""
    if not isinstance(row.result, Tried):
        return None
    attempt = row.result.attempt
    plan = attempt.plan or Plan(row.baseline.target, attempt.trajectory, (), None, "")
    plan = replace(plan, trajectory=attempt.trajectory, lower_bound=bound)
    return Shown(row.name, attempt.program, plan, row.result.report)
