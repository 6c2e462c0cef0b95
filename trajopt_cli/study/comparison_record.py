"""The records behind a comparison's tables and its page: rows, the saving by cause, as plain data and as CSV."""

from __future__ import annotations

import csv
import io
import math
from typing import Any

from trajopt_cli.findings import Report, failures
from trajopt_cli.problem.plan import Infeasible, NoPlan
from trajopt_cli.study.comparison import Comparison, Tried

_COLUMNS = (
    "name", "target", "cycle_time_s", "saving", "cycle_time_without_waits_s", "saving_without_waits", "legal",
    "breaks", "worst_ratio", "lower_bound_s", "moves", "title", "why",
)  # fmt: skip


_RATIOS = frozenset(
    {
        "joint speed",
        "joint acceleration",
        "joint jerk",
        "joint torque",
        "TCP speed",
        "TCP acceleration",
        "programmed speed",
        "programmed reorientation",
    }
)


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
