"""The folder of a comparison: its rows as JSON and CSV, its page, and what it was made from."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from pathlib import Path
from typing import TYPE_CHECKING, Any, ClassVar

from trajopt_cli.pipeline.optimize import held_unasked, inputs_of, made_by
from trajopt_cli.problem.plan import Plan
from trajopt_cli.runs import REPORT
from trajopt_cli.runs.folder import COMPARISON, write_run
from trajopt_cli.runs.record import Inputs, RunRecord, Section, as_json, sha256
from trajopt_cli.study.comparison import Comparison, Row, Tried
from trajopt_cli.study.comparison_record import comparison_record, rows_csv

if TYPE_CHECKING:
    from trajopt_cli.page.compared import Compared


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
    job, inputs, record = answer.job, inputs_of(answer.job), comparison_record(answer)
    files = {
        "comparison.json": as_json(record),
        "comparison.csv": rows_csv(record["rows"]).encode(),
        REPORT: comparison_page(answer, options),
        **{given.place: given.content for given in inputs.values()},
    }
    first, cell = inputs[next(iter(job.program.files))], inputs[str(job.cell_path)]
    write_run(
        folder,
        ComparisonRecord,
        files,
        "compare baseline",
        options=options,
        inputs=Inputs(program=first.place, cell=cell.place, files=[one.record(rapid=False) for one in inputs.values()]),
    )
    return len(files)


def comparison_page(answer: Comparison, options: ComparisonOptions) -> bytes:
    """report.html, which shows all of an answer."""
    from trajopt_cli.page.compared import Cause, compared_page
    from trajopt_cli.page.optimized import Provenance

    job = answer.job
    records = comparison_record(answer)["rows"]
    rows = [_compared(row, record) for row, record in zip(answer.rows, records, strict=True)]
    causes: Sequence[Cause] | str = (
        answer.steps
        if isinstance(answer.steps, str)
        else [Cause(step.name, step.plan.duration, step.saved, step.why_not) for step in answer.steps]
    )
    hashes = {path: sha256(given.content) for path, given in inputs_of(job).items()}
    made = Provenance(made_by("compare baseline", ComparisonRecord, options), hashes)
    notices = (*map(str, job.program.warnings), *answer.notices, *held_unasked(job))
    return compared_page(job.title, job.program, job.plant, rows, causes, notices, made)


def _compared(row: Row, record: dict[str, Any]) -> Compared:
    from trajopt_cli.page.compared import Compared
    from trajopt_cli.page.cycles import Shown

    one, shown = row.baseline, None
    if isinstance(row.result, Tried):
        attempt = row.result.attempt
        plan = attempt.plan or Plan(one.target, attempt.trajectory, (), None, "")
        plan = replace(plan, trajectory=attempt.trajectory, lower_bound=record["lower_bound_s"])
        shown = Shown(row.name, attempt.program, plan, row.result.report)
    return Compared(
        row.name,
        one.target.value,
        one.title,
        one.moves,
        shown,
        record.get("why", ""),
        record.get("saving"),
        record.get("lower_bound_s"),
        record.get("notes", ()),
    )
