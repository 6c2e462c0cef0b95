"""The folder of a comparison: its rows as JSON and CSV, its page, and what it was made from."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path
from typing import ClassVar

from trajopt_cli.page.compared import compared_page
from trajopt_cli.page.cycles import Shown
from trajopt_cli.page.optimized import Provenance
from trajopt_cli.pipeline.optimize import held_unasked, inputs_of, made_by
from trajopt_cli.problem.plan import Plan
from trajopt_cli.runs import REPORT
from trajopt_cli.runs.folder import COMPARISON
from trajopt_cli.runs.record import RunRecord, Section, as_json, sha256
from trajopt_cli.study.answers import write_answer
from trajopt_cli.study.comparison import Comparison, Row, Tried
from trajopt_cli.study.comparison_record import comparison_record, rows_csv


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
    notices = (*map(str, job.program.warnings), *answer.notices, *held_unasked(job))
    return compared_page(job.title, job.program, job.plant, record, motions, notices, made)


def _shown(row: Row, bound: float | None) -> Shown | None:
    """A row's motion as a page shows it; None where there is none. bound [s]: as the row's record has it."""
    if not isinstance(row.result, Tried):
        return None
    attempt = row.result.attempt
    plan = attempt.plan or Plan(row.baseline.target, attempt.trajectory, (), None, "")
    plan = replace(plan, trajectory=attempt.trajectory, lower_bound=bound)
    return Shown(row.name, attempt.program, plan, row.result.report)
