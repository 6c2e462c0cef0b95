"""`trajopt compare`: what the optimum saves, against what, and why; results folders side by side."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Literal

import typer

from trajopt_cli.cli import options as opt
from trajopt_cli.cli.process import reading, wrote
from trajopt_cli.cli.study import Scheduler, tasks_on
from trajopt_cli.errors import InputError

if TYPE_CHECKING:
    from collections.abc import Iterator

    from trajopt_cli.problem.plan import Target
    from trajopt_cli.runs.compared import ComparedRuns
    from trajopt_cli.table import TextTable

MOST = 20  # motions that are listed unless all are asked for
app = typer.Typer(help="Compare plans of one program.", rich_markup_mode=None)


@app.callback()
def _group() -> None:
    """Compare plans of one program."""


@app.command("runs", short_help="Compare results folders: times, motions, limits, inputs.")
def runs(
    results: Annotated[
        list[Path],
        typer.Argument(metavar="RESULTS RESULTS...", help="Two results folders of trajopt optimize or more."),
    ],
    target: Annotated[
        Literal["stream", "rapid"] | None,
        typer.Option(help="Whose motions are put side by side; default: the first run's.", show_default=False),
    ] = None,
    everything: Annotated[bool, typer.Option("--all", help="List every motion, in the program's order.")] = False,
    diff: Annotated[bool, typer.Option("--diff", help="Show the lines of the program that differ, too.")] = False,
    report: Annotated[Path | None, opt.given("--report", "FILE.html", "Write the comparison as a page, too.")] = None,
    as_json: opt.AsJson = False,
    quiet: opt.Quiet = False,
) -> None:
    """Compare runs: cycle times, inputs that differ, motions and the limits that hold them back.

    Differences count against the first folder. Nothing is planned again.

    \b
    Example:
      trajopt optimize programs/hinge_cell.mod --gentle --output results/gentle
      trajopt compare runs results/hinge_cell results/gentle
    """
    from trajopt_cli.cli.console import print_answer
    from trajopt_cli.problem.plan import Target
    from trajopt_cli.runs.compared import compare_runs
    from trajopt_cli.runs.compared_tables import runs_line, runs_record
    from trajopt_cli.runs.files import check_file, write_file

    if report is not None:
        check_file(report, "--report")
    answer = compare_runs(results, Target(target) if target else None)
    print_answer(as_json, quiet, lambda: runs_record(answer), runs_line(answer), _parts(answer, everything, diff))
    if report is not None:
        from trajopt_cli.page.runs import runs_page

        write_file(report, runs_page(answer))
        if not quiet:
            typer.echo(f"written to {report}", err=True)


@app.command("baseline", short_help="Today's practice, textbook methods, both optima, and the saving by cause.")
def baseline(
    program: Annotated[
        list[Path],
        typer.Argument(
            metavar="PROGRAM...|RESULTS",
            help="RAPID module, several, a program list (.pgf), their folder, or a results folder of trajopt optimize.",
        ),
    ],
    cell: opt.CellPath = None,
    entry: opt.Entry = None,
    assume_identity: opt.AssumeIdentity = None,
    loops: opt.LoopsOfProgram = None,
    as_json: opt.AsJson = False,
    quiet: opt.Quiet = False,
    csv: Annotated[Path | None, opt.given("--csv", "FILE.csv", "Write the rows as CSV, too.")] = None,
    plots: Annotated[
        Path | None, opt.given("--plots", "FOLDER", "Draw the rows, the saving by cause and the fastest plan, too.")
    ] = None,
    target: Annotated[
        Literal["stream", "rapid"] | None,
        typer.Option(
            help="Whose plan --plots draws; default: stream, of a results folder its own.", show_default=False
        ),
    ] = None,
    output: Annotated[Path | None, opt.results_at("results/PROGRAM_comparison")] = None,
    phi_min: Annotated[
        float, typer.Option(min=0, max=80, metavar="DEG", help="Row thesis: least angle of joint 3 from stretched.")
    ] = 10.0,
    v_transfer: Annotated[
        float | None, typer.Option(min=1e-3, metavar="M/S", help="Row thesis: rail speed between functional areas.")
    ] = None,
    v_area: Annotated[
        float | None, typer.Option(min=1e-3, metavar="M/S", help="Row thesis: rail speed inside a functional area.")
    ] = None,
    scheduler: Scheduler = None,
    time_limit: opt.TimeLimit = None,
) -> None:
    """Compare the optimum with today's practice and textbook methods, and split its saving by cause.

    Savings count against the first legal row. Exit code 1 when no row is legal.

    \b
    Example:
      trajopt compare baseline programs/hinge_cell.mod --csv rows.csv
    """
    from trajopt_cli.cli.console import print_answer, told
    from trajopt_cli.cli.progress import ProgressView
    from trajopt_cli.job import read_program_or_results
    from trajopt_cli.pipeline.optimize import held_by_default
    from trajopt_cli.problem.editable import Loops
    from trajopt_cli.runs.files import check_file, check_writable, write_file
    from trajopt_cli.runs.folder import check_replaceable
    from trajopt_cli.runs.transaction import write_files
    from trajopt_cli.study import comparison_record as records
    from trajopt_cli.study.case import RailRule
    from trajopt_cli.study.comparison import compare, comparison_pictures
    from trajopt_cli.table import by_name
    from trajopt_cli.units import DEG

    patience = opt.patience_of(time_limit)
    with reading(program):
        wanted = Loops(loops) if loops else None
        job, made_of_loops = read_program_or_results(program, cell, entry, assume_identity or (), wanted)
    if csv is not None:
        check_file(csv, "--csv")
    if plots is not None and plots.exists() and not plots.is_dir():
        raise InputError("is a file; --plots names a folder", file=str(plots))
    if plots is not None:
        check_writable(plots, into=True)
    folder = output or Path("results") / f"{job.program.name}_comparison"
    check_replaceable(folder)
    with ProgressView(patience, quiet) as view, tasks_on(scheduler, patience):
        rule = RailRule(phi_min * DEG, v_transfer, v_area)
        answer = compare(job, view.show, rule, made_of_loops, patience)
    record = records.comparison_record(answer)
    rows = record["rows"]
    if csv is not None:
        write_file(csv, records.rows_csv(rows).encode())
        wrote(csv)
    files = (*job.program.files, str(job.cell_path))
    table = records.rows_table(program[0].name or job.title, answer.waits, rows, answer.settling)
    causes: TextTable | str
    if isinstance(answer.steps, str):
        causes = by_name(f"saving by cause: not available, there is no plan to start from ({answer.steps})", files)
    else:
        causes = records.causes_table(answer.steps)
    notes = [by_name(line, files) for line in (*job.plant.unchecked, *answer.notices, *held_by_default(job))]
    parts = [table, *records.row_lines(rows, files), "", causes, *notes]
    print_answer(as_json, quiet, lambda: record, records.comparison_line(rows), parts)
    if plots is not None:
        pictures = comparison_pictures(answer, _drawn(target, program[0]))
        write_files(plots, pictures)
        if not quiet:
            typer.echo(f"drawn in {plots}: {len(pictures)} files", err=True)
    options = records.ComparisonOptions(
        program=[str(path) for path in job.paths],
        cell=str(job.cell_path),
        entry=job.program.entry,
        assume_identity=list(job.assume_identity),
        loops=made_of_loops.value,
    )
    count = records.write_comparison(folder, answer, options)
    wrote(folder)
    told([f"written to {folder}: report.html (open it in a browser) and {count - 1} files more"], as_json, quiet)
    if not any(row["legal"] for row in rows):
        raise typer.Exit(1)


def _drawn(target: str | None, program: Path) -> Target:
    """Whose plan is drawn: as asked for, else as a results folder was made, else the stream's."""
    from trajopt_cli.job import is_results
    from trajopt_cli.problem.plan import Target
    from trajopt_cli.runs.results import read_results

    if target is None and is_results(program):
        return read_results(program).target
    return Target(target or "stream")


def _parts(answer: ComparedRuns, everything: bool, diff: bool) -> Iterator[TextTable | str]:
    """Runs side by side as they are printed."""
    from trajopt_cli.runs.compared_tables import bindings_table, cycles_table, inputs_lines, motions_table
    from trajopt_cli.table import Verbatim

    for run in answer.runs:
        yield Verbatim(f"{run.letter}: {run.folder} ({', '.join(run.inputs.modules)})")
    yield from (f"note: {note}" for note in answer.notes)
    yield ""
    yield cycles_table(answer)
    yield from map(Verbatim, inputs_lines(answer, diff))
    yield ""
    rows = answer.rows if everything else answer.by_difference[:MOST]
    if rows:
        yield motions_table(answer, rows)
    if not everything and (left := len(answer.by_difference) - len(rows)) > 0:
        yield f"{left} more motions differ; --all lists every one"
    if not everything and (same := len(answer.rows) - len(answer.by_difference)):
        yield f"{same} of {len(answer.rows)} motions take the same time"
    if answer.bound_otherwise:
        yield ""
        yield bindings_table(answer)
